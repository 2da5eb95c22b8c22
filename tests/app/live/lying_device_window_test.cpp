// SPDX-License-Identifier: GPL-3.0-or-later
// The window with a device whose readings are false while it presses on a sphere: not a number, a jump of a
// metre, silence; by the virtual device through fulcrum-hapticd. The force is 0 within 50 ms of the first
// false reading, the attempt pauses and says what to do, and nothing is lost.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "app/live/device_rig.h"
#include "database/scoring/loaded_task.h"
#include "sim_core/instrument/mouse_mapping.h"
#include "sim_core/rigid/targets.h"
#include "tests/app/daemon_processes.h"
#include "tests/app/program_path.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

using ui::AttemptPhase;
using ui::window_test::find;
using ui::window_test::keep_picture;
using ui::window_test::wait_for;

constexpr std::uint64_t lying_seed = 7;  // places the spheres
constexpr double rest_s = 2.5;           // the attempt begins while the hand rests

/// Before the services are made: rests, then presses on the left hand's first sphere.
struct LyingDevice {
    LyingDevice() {
        const Scene scene = load_task_and_scene("A2").scene;
        const InstrumentSpec& spec = *scene.instrument(Hand::left);
        const Trocar trocar = make_trocar(spec.trocar);
        const Vector3 start = start_reading(spec.trocar.shaft_length, spec.start_insertion, 0).handle;
        const TargetSphere sphere = place_targets(*scene.targets, lying_seed).front();
        EXPECT_EQ(sphere.hand, Hand::left);
        const Vector3 out = (trocar.position - sphere.centre).normalized();
        const double touching = sphere.radius + spec.tip_radius;
        nlohmann::json path = nlohmann::json::array();
        for (const double t : {0.0, rest_s}) path.push_back(nlohmann::json::object({{"t", t}}));
        const auto come = [&](double t, double from_centre) {
            const Vector3 handle = handle_for_tip(trocar, sphere.centre + from_centre * out);
            const Vector3 place = DeviceRig::turned(handle - start);
            path.push_back({{"t", t}, {"position", {place.x(), place.y(), place.z()}}});
        };
        come(rest_s + 0.5, touching + 0.01);
        come(rest_s + 0.7, touching - 0.0015);
        nlohmann::json faults = nlohmann::json::array();
        double at = 0.7;
        for (const char* const kind : {"not_a_number", "jump", "silence"}) {
            faults.push_back({{"t", at}, {"for", 0.5}, {"kind", kind}, {"after_force", true}});
            at += 1.9;
        }
        std::ofstream(script) << nlohmann::json{{"format", "fulcrum-device-script"},
                                                {"title", "a hand that lies"},
                                                {"force", {{"damping", 0.5}, {"peak", 3.3}}},
                                                {"left", {{"path", path}}},
                                                {"faults", faults}};
    }
    static std::string daemon() {
        const std::string program = program_path();
        return program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd";
    }
    fulcrum::test::OwnFolder own;
    std::string script = (own / "hand.json").string();
    fulcrum::test::Variable device{"FULCRUM_DEVICE", "virtual:" + script};
    fulcrum::test::Variable program{"FULCRUM_HAPTICD", daemon()};
};

/// Looks at the daemon's page ten thousand times a second.
class ForceWatch {
  public:
    struct Lie {
        double force = 0;              ///< N, before it
        std::int64_t until_zero = -1;  ///< ns, from its first reading to the first report of no force
    };
    explicit ForceWatch(const StatePage& page) : page_(page), thread_([this] { watch(); }) {}
    ~ForceWatch() {
        stop_ = true;
        thread_.join();
    }
    ForceWatch(const ForceWatch&) = delete;
    ForceWatch& operator=(const ForceWatch&) = delete;
    std::vector<Lie> lies() const {
        const std::lock_guard<std::mutex> lock(mutex_);
        return lies_;
    }

  private:
    void watch() {
        DevicePose pose;
        ForceReport report;
        double x = 0, before = 0;
        std::int64_t began = 0;  // ns, the lie that is under way
        for (; !stop_; usleep(100)) {
            if (!page_.pose[0].read(pose) || !page_.report[0].read(report)) continue;
            const double force = std::hypot(std::hypot(report.force[0], report.force[1]), report.force[2]);
            const bool is_false =
                pose.present == 0 || !std::isfinite(pose.position[0]) || std::abs(pose.position[0] - x) > 0.5;
            if (!is_false) {
                x = pose.position[0];
                before = force;
                began = 0;
                continue;
            }
            const std::lock_guard<std::mutex> lock(mutex_);
            if (began == 0) lies_.push_back({before, -1});
            if (began == 0) began = pose.time;
            if (lies_.back().until_zero < 0 && force == 0) lies_.back().until_zero = report.time - began;
        }
    }
    const StatePage& page_;
    mutable std::mutex mutex_;
    std::vector<Lie> lies_;
    std::atomic<bool> stop_{false};
    std::thread thread_;  // begins last
};

class LyingDeviceWindow : public LyingDevice, public Window {
  protected:
    AttemptPhase phase() { return theatre().session()->phase(); }
    QString panel() { return find<QLabel>(window, "panel_text")->text(); }
};

TEST_F(LyingDeviceWindow, EachLiePausesTheAttemptWithForceZeroWithin50MillisecondsAndLosesNothing) {
    services.seed = lying_seed;
    create_programme_and_trainee();
    start("A2", false);
    const SharedPage<StatePage> page = state_page_of(daemon_child_of(getpid()));
    ASSERT_TRUE(page);
    DevicePose pose;
    ASSERT_TRUE(page->pose[0].read(pose));
    ASSERT_EQ(pose.position[2], 0) << "the attempt begins while the hand rests";
    const ForceWatch watch(*page.get());
    for (const char* const what : {"impossible reading", "impossible reading", "does not answer"}) {
        ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::device_lost; }, 20000));
        ASSERT_TRUE(wait_for([&] { return ui::window_test::sees(window, "theatre_panel"); }, 5000));
        const QString said = panel();
        EXPECT_TRUE(said.contains(QStringLiteral("The left hand's device"))) << said.toStdString();
        EXPECT_TRUE(said.contains(QLatin1String(what))) << said.toStdString();
        EXPECT_TRUE(said.contains("Reconnect the device")) << said.toStdString();
        ASSERT_TRUE(wait_for([&] { return aligned().in_place; }, 20000)) << aligned().hand[0].distance;
        QTest::keyClick(theatre().view(), Qt::Key_Return);
        ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::running; }, 10000));
    }
    keep_picture(window, "37-after-three-lies");
    const std::vector<ForceWatch::Lie> lies = watch.lies();
    ASSERT_EQ(lies.size(), 3U);
    for (const ForceWatch::Lie& lie : lies) {
        EXPECT_GT(lie.force, 0.05) << "N, it was pressing";
        EXPECT_GE(lie.until_zero, 0) << "the force became 0";
        EXPECT_LE(lie.until_zero, 50'000'000) << "ns";
    }
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.device, "a hand that lies");
    expect_replays(attempt.meta.id);
}

}  // namespace
}  // namespace fulcrum::app::program_test
