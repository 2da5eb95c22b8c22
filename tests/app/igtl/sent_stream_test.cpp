// SPDX-License-Identifier: GPL-3.0-or-later
// What another program gets of a running attempt: tips, shafts, camera and forces in one stream, at the rate
// that docs/DEVICES.md states.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/igtl/wire_frame.h"
#include "app/services/application.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/igtl/content.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

/// From the axes of 3D Slicer (right, anterior, superior) to the patient frame (left, cranial, anterior).
Vector3 from_ras(double right, double anterior, double superior) {
    return {-right, superior, anterior};
}

struct SentFrame {
    std::set<std::string> devices;
    bool forces = false;  ///< one is not 0
};

/// Everything that came, by its time.
class SentStream {
  public:
    explicit SentStream(const Scene& scene) : scene_(scene) {}
    void take(const igtl::Message& message) {
        const std::string device(message.device);
        if (message.type != "TRANSFORM" && message.type != "SENSOR") return;
        SentFrame& frame = frames_[message.time];
        frame.devices.insert(device);
        igtl::Sensor sensor;
        if (message.type == "SENSOR" && device.find("Force") != std::string::npos &&
            igtl::read_sensor(message.content, sensor)) {
            EXPECT_EQ(sensor.count, 3) << device;
            EXPECT_EQ(sensor.unit, igtl::unit_newton) << device;
            for (int axis = 0; axis < 3; ++axis)
                frame.forces = frame.forces || sensor.values[static_cast<std::size_t>(axis)] != 0;
        }
        igtl::Transform transform;
        if (message.type == "TRANSFORM" && igtl::read_transform(message.content, transform))
            look_at(device, transform);
    }
    /// The shaft is z of the tool and goes through its trocar.
    void look_at(const std::string& device, const igtl::Transform& transform) {
        const auto& v = transform.values;
        for (const Hand hand : {Hand::left, Hand::right}) {
            const InstrumentSpec* const spec = scene_.instrument(hand);
            if (spec == nullptr || device != tool_names[static_cast<int>(hand)]) continue;
            const Vector3 axis = from_ras(v[6], v[7], v[8]), tip = 1e-3 * from_ras(v[9], v[10], v[11]);
            EXPECT_NEAR(axis.norm(), 1, 1e-5);
            const Vector3 along = (tip - spec->trocar.position).normalized();
            EXPECT_GT(axis.dot(along), 1 - 1e-5) << device << ": " << axis.transpose();
            ++shafts_;
        }
        if (device == tool_names[hand_count]) ++cameras_;
    }
    /// Frames that have all of these.
    std::vector<double> times_with(const std::set<std::string>& wanted) const {
        std::vector<double> times;  // s
        for (const auto& [time, frame] : frames_)
            if (std::includes(frame.devices.begin(), frame.devices.end(), wanted.begin(), wanted.end()))
                times.push_back(1e-9 * static_cast<double>(igtl::ns_of(time)));
        return times;
    }
    bool felt() const {
        return std::any_of(frames_.begin(), frames_.end(), [](const auto& one) { return one.second.forces; });
    }
    std::size_t frames() const { return frames_.size(); }
    std::size_t shafts() const { return shafts_; }
    std::size_t cameras() const { return cameras_; }

  private:
    const Scene& scene_;
    std::map<std::uint64_t, SentFrame> frames_;
    std::size_t shafts_ = 0, cameras_ = 0;
};

TEST(SentStream, HasTipsShaftsCameraAndForcesInEachFrameAtTheRateOfTheDisplay) {
    const fulcrum::test::OwnFolder folder;
    const fulcrum::test::Variable address("FULCRUM_OPENIGTLINK", "127.0.0.1:0");
    const auto services = make_services(folder.path().string());
    services->open_store(false);
    const ui::SendingState state = services->sending();
    ASSERT_TRUE(state.trouble.empty()) << state.trouble.words();
    igtl::Connection connection(igtl::parse_address(state.address, "test"), 2000);
    auto attempt = services->start_demonstration(services->store()->station_session(), "A2");
    const auto until = [&](const std::function<bool()>& holds) {
        const std::int64_t last = monotonic_ns() + 20'000'000'000;
        while (!holds() && monotonic_ns() < last) {
            attempt->update();
            usleep(2000);
        }
        return holds();
    };
    ASSERT_TRUE(until([&] { return attempt->phase() == ui::AttemptPhase::ready; }));
    attempt->start();
    SentStream sent(attempt->scene());
    igtl::Decoder decoder;
    constexpr std::size_t enough = 150;  // two and a half seconds
    const bool came = until([&] {
        connection.read_into(decoder);
        igtl::Message message;
        for (auto found = decoder.next(message); found != igtl::Decoder::Found::nothing;
             found = decoder.next(message)) {
            EXPECT_EQ(found, igtl::Decoder::Found::message);
            if (found == igtl::Decoder::Found::broken) return true;
            sent.take(message);
        }
        return sent.frames() >= enough && sent.felt();
    });
    EXPECT_TRUE(came) << sent.frames() << " frames, a force was sent: " << sent.felt();
    const std::vector<double> times =
        sent.times_with({"LeftTipToPatient", "RightTipToPatient", "CameraToPatient", "LeftForce",
                         "RightForce", "LeftState", "RightState"});
    // The newest may be cut off.
    EXPECT_GE(times.size() + 1, sent.frames()) << "each has all of them";
    EXPECT_GE(sent.shafts() + 2, 2 * times.size());
    EXPECT_GE(sent.cameras() + 1, times.size());
    // A machine that has much else to do leaves gaps; half of the time there is none.
    ASSERT_GT(times.size(), enough / 2);
    std::vector<double> gaps;
    for (std::size_t i = 1; i < times.size(); ++i) gaps.push_back(times[i] - times[i - 1]);
    std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
    const double usual = 1 / gaps[gaps.size() / 2],
                 mean = static_cast<double>(times.size() - 1) / (times.back() - times.front());
    std::cout << "frames a second: usually " << usual << ", on average " << mean << "\n";
    EXPECT_GT(usual, 55) << "60 by docs/DEVICES.md";
    EXPECT_LT(usual, 65);
    EXPECT_LT(mean, 62);
    EXPECT_GT(mean, 25);
}

}  // namespace
}  // namespace fulcrum::app
