// SPDX-License-Identifier: GPL-3.0-or-later
// The window with each device of the daemon and every fault that it can have: a fault pauses the attempt with
// force 0 and says what to do; when it has passed the attempt resumes, and nothing is lost. The first steps
// are those of the device.
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "tests/app/daemon_processes.h"
#include "tests/app/held_devices.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/posed_hand.h"
#include "tests/app/window_fixture.h"
#include "tests/support/fake_trainer.h"
#include "tests/support/process_rights.h"

namespace fulcrum::app::program_test {
namespace {

using ui::window_test::find;
using ui::window_test::wait_for;

// A fault that is added to the table has to be made by one of them.
TEST(DeviceFaultKinds, EachIsMadeByADeviceOfTheWindowsTests) {
    for (const FaultRow& row : device_faults) {
        if (row.kind == DeviceFault::none) continue;
        const bool made = std::any_of(held_kinds().begin(), held_kinds().end(), [&](const HeldKind& kind) {
            return std::find(kind.faults.begin(), kind.faults.end(), row.kind) != kind.faults.end();
        });
        EXPECT_TRUE(made) << static_cast<int>(row.kind) << ": " << row.words;
    }
}

/// Before the services are made.
struct WithHeldDevice : ::testing::WithParamInterface<std::string> {
    std::unique_ptr<HeldDevice> device = make_held(GetParam());
};

class FaultWindow : public WithHeldDevice, public Window {
  protected:
    QString panel() { return find<QLabel>(window, "panel_text")->text(); }
    ui::AttemptPhase phase() { return theatre().session()->phase(); }
    double elapsed() { return theatre().session()->display().elapsed_s; }
    /// The left hand presses on the first sphere; one that is pushed moves to the side, from where go_back()
    /// brings it back.
    bool works(int milliseconds) {
        const auto mind = make_pointing_mind(theatre().session()->scene(), 1e-3);
        PosedHand hand(
            theatre(), *mind,
            [this](int h, const Vector3& position) {
                device->put(h, device->is_pushed ? Vector3(Vector3::UnitX()) : position);
            },
            device->begin());
        return hand.work_until(
            [&] {
                const TaskDisplay& display = theatre().session()->display();
                const bool presses = device->feels() ? device->force() > 0.05 : display.moving_seen;
                return display.moving_seen && display.elapsed_s > 0.05 && presses;
            },
            milliseconds);
    }
    void expect_first_steps() {
        ASSERT_TRUE(wait_for([&] { return ui::window_test::sees(window, "theatre_keys"); }));
        const QString strip =
            find<QFrame>(window, "theatre_keys")->findChild<QLabel*>()->text().replace("&nbsp;", " ");
        EXPECT_TRUE(strip.contains(device->strip)) << strip.toStdString();
    }
    /// Its maker's library is in the device process and never in the program.
    void expect_library_elsewhere() {
        if (*device->library == '\0') return;
        const pid_t process = daemon_child_of(daemon_child_of(getpid()));
        ASSERT_GT(process, 0);
        EXPECT_TRUE(fulcrum::test::has_mapped(process, device->library));
        EXPECT_FALSE(fulcrum::test::has_mapped(getpid(), device->library));
    }
    /// What is wrong and what to do; or that it was opened again in vain, why, and what to do.
    bool says(DeviceFault fault) {
        const char* const refusal = device->refusal(fault);
        return panel().contains(QString::fromUtf8(words_of(fault))) ||
               (*refusal != '\0' && panel().contains(QLatin1String(refusal)));
    }
    void break_and_pause(DeviceFault fault) {
        // The hand has come to rest, also on a machine that is busy: it is lost where it is put again.
        const std::uint32_t at_rest = theatre().session()->health().ticks + 400;
        ASSERT_TRUE(wait_for([&] { return theatre().session()->health().ticks >= at_rest; }));
        const std::int64_t broken = monotonic_ns();
        device->break_it(fault);
        while (device->force() != 0 && monotonic_ns() - broken < 1'000'000'000) usleep(200);
        EXPECT_LE(monotonic_ns() - broken, 50'000'000) << "until the force is 0";
        ASSERT_TRUE(wait_for([&] { return phase() == ui::AttemptPhase::device_lost; }));
        ASSERT_TRUE(wait_for([&] { return says(fault); }, 10000)) << panel().toStdString();
        EXPECT_TRUE(panel().contains("The force is 0 and the timer is stopped")) << panel().toStdString();
        EXPECT_EQ(device->force(), 0);
    }
    void repair_and_resume() {
        // The display of a late step can come after the panel.
        const std::uint32_t lost_at = theatre().session()->health().ticks;
        ASSERT_TRUE(wait_for([&] { return theatre().session()->snapshot().tick >= lost_at; }));
        const double stopped = elapsed();
        EXPECT_GT(stopped, 0);
        device->repair();
        ASSERT_TRUE(wait_for([&] { return aligned().back; }, 20000)) << panel().toStdString();
        ASSERT_TRUE(wait_for(
            [&] {
                device->go_back(aligned().hand[0].distance);
                return aligned().in_place;
            },
            20000))
            << aligned().hand[0].distance;
        EXPECT_EQ(device->force(), 0) << "until the person resumes";
        EXPECT_EQ(elapsed(), stopped);
        QTest::keyClick(theatre().view(), Qt::Key_Return);
        ASSERT_TRUE(wait_for([&] { return phase() == ui::AttemptPhase::running; }, 10000));
        ASSERT_TRUE(wait_for([&] { return elapsed() > stopped; }, 10000));
        ASSERT_TRUE(!device->feels() || wait_for([&] { return device->force() > 0.05; }, 10000))
            << "the force comes back";
    }
    void expect_stored(std::size_t losses) {
        const database::AttemptSummary attempt = newest_attempt();
        EXPECT_NE(attempt.meta.device.find(device->model), std::string::npos) << attempt.meta.device;
        EXPECT_EQ(attempt.meta.device_class, device->device_class);
        const database::Trace trace =
            database::Attempts(*services.store()).read_trace(window.context().session(), attempt.meta.id);
        EXPECT_EQ(static_cast<std::size_t>(
                      std::count_if(trace.events.begin(), trace.events.end(),
                                    [](const Event& event) { return event.kind == EventKind::device_lost; })),
                  losses)
            << "one loss for each fault";
        expect_replays(attempt.meta.id);
    }
};

TEST_P(FaultWindow, EachFaultPausesTheAttemptWithForceZeroSaysWhatToDoAndLosesNothing) {
    if (GetParam() == "Trainer" && !fulcrum::test::FakeTrainer::is_possible())
        GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    create_programme_and_trainee();
    start("A2", false);
    expect_first_steps();
    expect_library_elsewhere();
    EXPECT_EQ(theatre().session()->health().force_felt[0], device->feels());
    ASSERT_TRUE(works(20000)) << "force at the device: " << device->force();
    const std::vector<DeviceFault>& faults = held_kind(GetParam()).faults;
    for (const DeviceFault fault : faults) {
        SCOPED_TRACE(words_of(fault));
        ASSERT_NO_FATAL_FAILURE(break_and_pause(fault));
        ASSERT_NO_FATAL_FAILURE(repair_and_resume());
    }
    abandon();
    expect_stored(faults.size());
}

std::vector<std::string> kind_names() {
    std::vector<std::string> names;
    for (const HeldKind& kind : held_kinds()) names.emplace_back(kind.name);
    return names;
}
INSTANTIATE_TEST_SUITE_P(Devices, FaultWindow, ::testing::ValuesIn(kind_names()),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace fulcrum::app::program_test
