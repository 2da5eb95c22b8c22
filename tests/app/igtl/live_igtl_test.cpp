// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt of the window, in real time, that another program listens to; and instruments that another
// program tracks, in an attempt of the window.
#include <gtest/gtest.h>

#include <QSettings>

#include "app/igtl/wire_frame.h"
#include "app/services/application.h"
#include "sim_core/devices/device_page.h"
#include "tests/app/program_path.h"
#include "tests/support/fake_tracker.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

struct SetVariable {
    SetVariable(const char* name_in, const std::string& value) : name(name_in) {
        setenv(name, value.c_str(), 1);
    }
    ~SetVariable() { unsetenv(name); }
    const char* name;
};

/// Waits at most 10 s, as the window does.
template <typename Holds>
bool attempt_until(ui::AttemptSession& attempt, Holds&& holds) {
    const std::int64_t last = monotonic_ns() + 10'000'000'000;
    while (!holds()) {
        if (monotonic_ns() > last) return false;
        attempt.update();
        usleep(2000);
    }
    return true;
}

TEST(LiveIgtl, AnAttemptIsSentWhileItRunsAndTheWindowShowsTheReceivers) {
    const test::OwnFolder folder;
    const SetVariable address("FULCRUM_OPENIGTLINK", "127.0.0.1:0");
    const auto services = make_services(folder.path().string());
    services->open_store(false);
    const ui::SendingState state = services->sending();
    ASSERT_TRUE(state.trouble.empty()) << state.trouble.words();
    EXPECT_TRUE(state.fixed);
    services->choose_sending(false);  // the variable decides
    EXPECT_TRUE(services->sending().wanted);
    igtl::Connection connection(igtl::parse_address(state.address, "test"), 2000);
    auto attempt = services->start_demonstration(services->store()->station_session(), "A2");
    ASSERT_TRUE(attempt_until(*attempt, [&] { return attempt->phase() == ui::AttemptPhase::ready; }));
    attempt->start();
    igtl::Decoder decoder;
    TraceRecording recording;
    bool ended = false;
    const auto listen = [&] {
        connection.read_into(decoder);
        igtl::Message message;
        while (decoder.next(message) == igtl::Decoder::Found::message)
            ended = recording.take(message) == TraceRecording::Took::end || ended;
    };
    EXPECT_TRUE(attempt_until(*attempt, [&] {
        listen();
        return recording.rows() >= 40;
    }));
    EXPECT_EQ(services->sending().clients, 1U);
    attempt.reset();
    const std::int64_t last = monotonic_ns() + 5'000'000'000;
    while (!ended && monotonic_ns() < last) {
        connection.wait(10);
        listen();
    }
    EXPECT_TRUE(ended);
    const Trace trace = recording.finish();
    EXPECT_EQ(recording.left_out(), 0U);
    const double rate = static_cast<double>(trace.t.size() - 1) / (trace.t.back() - trace.t.front());
    EXPECT_GT(rate, 10) << "60 where the machine has time";
    EXPECT_LT(rate, 70);
    EXPECT_TRUE(trace.hand[0].has(Channel::force));
    EXPECT_TRUE(trace.camera.recorded());
}

TEST(LiveIgtl, APortInUseIsReportedAndAttemptsContinueWithoutSending) {
    const test::OwnFolder folder;
    const igtl::Server other({"127.0.0.1", 0});
    const SetVariable address("FULCRUM_OPENIGTLINK", "127.0.0.1:" + std::to_string(other.port()));
    const auto services = make_services(folder.path().string());
    EXPECT_NE(services->sending().trouble.words().find("cannot be served"), std::string::npos);
    EXPECT_TRUE(services->sending().address.empty());
    services->open_store(false);
    const auto attempt = services->start_demonstration(services->store()->station_session(), "A2");
    EXPECT_TRUE(attempt_until(*attempt, [&] { return attempt->phase() == ui::AttemptPhase::ready; }));
}

TEST(LiveIgtl, TrackedInstrumentsMoveAnAttemptWhichPausesWhereTheTrackerStops) {
    const test::OwnFolder folder;
    test::FakeTracker tracker({"LeftTipToPatient", "RightTipToPatient"});
    const std::string program = program_path();
    const SetVariable daemon("FULCRUM_HAPTICD",
                             program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd");
    const SetVariable device("FULCRUM_DEVICE", "openigtlink:" + tracker.address());
    const auto services = make_services(folder.path().string());
    services->open_store(false);
    EXPECT_EQ(services->device_in_use().device_class, DeviceClass::tracked);
    const auto session = services->store()->station_session();
    const TaskDefinition& a2 = *std::find_if(services->tasks().begin(), services->tasks().end(),
                                             [](const TaskDefinition& task) { return task.id == "A2"; });
    struct Still : Rig {
        void read(std::uint32_t, RigSample&) override {}
        void write_force(Hand, const Vector3&) override {}
        bool has_force(Hand) const override { return false; }
        double damping(Hand) const override { return -1; }
    };
    const auto rig = services->hands(services->scene_for(a2), std::make_shared<Still>());
    EXPECT_EQ(services->device_in_use().title, "OpenIGTLink " + tracker.address());
    const auto left = [&] {
        RigSample sample;
        rig->read(1, sample);
        return sample.hand[0];
    };
    const std::int64_t limit = monotonic_ns() + 8'000'000'000;
    const DeviceSample before = left();
    igtl::Pose pose;
    pose.place = Vector3(0.01, 0.005, 0);
    tracker.move(0, pose);
    while (left().handle[1] - before.handle[1] < 49'990 && monotonic_ns() < limit) usleep(1000);
    const DeviceSample moved = left();
    EXPECT_NEAR(moved.handle[0] - before.handle[0], -100'000, 300)
        << "to the right is -x of the trocar's frame";
    EXPECT_NEAR(moved.handle[1] - before.handle[1], 50'000, 300);
    EXPECT_EQ(moved.present, 1);
    tracker.mode = test::FakeTracker::Mode::silent;
    while (left().present == 1 && monotonic_ns() < limit) usleep(1000);
    EXPECT_EQ(left().present, 0);
    EXPECT_NEAR(left().handle[1], moved.handle[1], 300) << "it stays where it was";
    while (services->device_trouble().empty() && monotonic_ns() < limit) usleep(1000);
    EXPECT_NE(services->device_trouble().words().find("sends no pose"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app
