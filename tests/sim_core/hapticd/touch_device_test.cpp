// SPDX-License-Identifier: Apache-2.0
// The 3D Systems Touch through its real entry: fulcrum-hapticd loads a fake libHD (tests/fakes/libhd.cpp).
#include "sim_core/hapticd/touch_device.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <cmath>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/numerics/input_error.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_touch.h"
#include "tests/support/allocation_count.h"
#include "tests/support/built.h"
#include "tests/support/german_locale.h"
#include "tests/support/process_rights.h"

namespace fulcrum {
namespace {

using test::says;
using test::until;

constexpr std::int64_t limit = 50'000'000;  // ns
constexpr const char* both = "touch:Left Device,Right Device";

std::string fake(const char* name) {
    return test::fake_library(name);
}

class TouchThroughTheDaemon : public ::testing::Test {
  protected:
    DevicePose pose(const DaemonClient& client, int hand) const {
        DevicePose newest;
        client.state().pose[hand].read(newest);
        return newest;
    }
    bool is_present(const DaemonClient& client, int hand) const { return pose(client, hand).present == 1; }
    double force(int hand) const {
        double most = 0;
        for (const auto& f : page->device[hand].force) most = std::max(most, std::abs(f.load()));
        return most;
    }
    /// Sends this force to both hands every half millisecond until the condition holds, at most 8 s.
    template <typename Condition>
    bool push_until(DaemonClient& client, const Vector3& wanted, Condition&& holds) {
        return until([&] {
            ++command.sequence;
            command.time = monotonic_ns();
            for (int axis = 0; axis < 3; ++axis) command.force[axis] = wanted[axis];
            for (auto& hand : client.command().command) hand.write(command);
            return holds();
        });
    }
    std::string error_of(const std::string& specification) const {
        try {
            DaemonClient client(test::hapticd_program(), specification);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }
    test::FakePage<test::FakeTouchPage> page{"FAKE_TOUCH_PAGE"};
    test::Variable library{"FULCRUM_LIBHD", fake("libHD.so")};
    ForceCommand command;
};

TEST_F(TouchThroughTheDaemon, PosesOfTwoDevicesComeInMetresWithRollJawAndButtons) {
    DaemonClient client(test::hapticd_program(), both);
    EXPECT_EQ(client.facts().title, "3D Systems Touch");
    EXPECT_EQ(client.facts().kind, "touch");
    EXPECT_FALSE(client.facts().slot[scope_slot]);
    for (int h = 0; h < 2; ++h) {
        test::FakeTouchDevice& device = page->device[h];
        device.position[0] = 10 + h;
        device.position[1] = -20;
        device.position[2] = 30;
        device.gimbal[2] = 0.5 - h;
    }
    page->device[1].buttons = 3;
    ASSERT_TRUE(until([&] { return pose(client, 0).position[2] != 0 && pose(client, 1).jaw == 0; }));
    for (int h = 0; h < 2; ++h) {
        const DevicePose now = pose(client, h);
        EXPECT_EQ(now.present, 1U);
        EXPECT_DOUBLE_EQ(now.position[0], 1e-3 * (10 + h));
        EXPECT_DOUBLE_EQ(now.position[1], -0.02);
        EXPECT_DOUBLE_EQ(now.position[2], 0.03);
        EXPECT_DOUBLE_EQ(now.roll, 0.5 - h);
    }
    EXPECT_EQ(pose(client, 0).jaw, 1);
    EXPECT_EQ(pose(client, 0).buttons, 0U);
    EXPECT_EQ(pose(client, 1).buttons, std::uint32_t{button_energy});
    page->device[1].buttons = 0;
    EXPECT_TRUE(until([&] { return pose(client, 1).jaw == 1 && pose(client, 1).buttons == 0; }));
    EXPECT_EQ(page->rate, 1000U);
    EXPECT_TRUE(test::is_filtered(client.device_process())) << "the thread of its library as well";
    EXPECT_TRUE(test::has_mapped(client.device_process(), "libHD.so"));
    EXPECT_EQ(page->misuse, 0U);
    EXPECT_TRUE(client.message().empty());
}

TEST_F(TouchThroughTheDaemon, WorkspaceAndVersionsAreThoseThatTheLibraryStates) {
    const double mm[] = {-210, -110, -85, 205, 130, 100};
    for (int i = 0; i < 6; ++i) page->device[0].workspace[i] = mm[i];
    page->device[1].workspace[0] = 1;  // not possible: what the maker publishes
    page->device[0].firmware = page->device[1].firmware = 192;
    const DaemonClient client(test::hapticd_program(), both);
    ASSERT_TRUE(client.facts().workspace[0] && client.facts().workspace[1]);
    EXPECT_TRUE(client.facts().workspace[0]->least.isApprox(Vector3(-0.21, -0.11, -0.085)));
    EXPECT_TRUE(client.facts().workspace[0]->most.isApprox(Vector3(0.205, 0.13, 0.1)));
    EXPECT_TRUE(client.facts().workspace[1]->size().isApprox(Vector3(0.16, 0.12, 0.07)));
    EXPECT_FALSE(client.facts().workspace[scope_slot].has_value());
    EXPECT_EQ(client.facts().firmware, "driver 2023.11.15, firmware 192");
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(TouchThroughTheDaemon, AFirmwareThatTheLibraryNamesIsTheReasonAndSaysWhatToUpdate) {
    page->old_firmware = 1;
    page->init_error = 0x0302;
    page->init_errors = 3;  // one opening tries three names
    const std::string refusal = error_of("touch");
    EXPECT_NE(refusal.find("0x0302 Firmware version is not supported; update the firmware"),
              std::string::npos)
        << refusal;
    DaemonClient client(test::hapticd_program(), both);
    ASSERT_TRUE(until([&] { return is_present(client, 0); }));
    page->device[0].tick_error = 0x0300;
    ASSERT_TRUE(until([&] {
        client.poll();
        return client.message().words().find("firmware of the device does not suit it") != std::string::npos;
    })) << client.message().words();
    EXPECT_FALSE(is_present(client, 0));
    page->device[0].tick_error = 0;
    page->old_firmware = 0;
}

TEST_F(TouchThroughTheDaemon, ForceSentIsForceAskedWithinTheDevicesLimits) {
    page->device[0].max_force = 2.5;
    page->device[0].continuous_force = 0.7;
    page->device[0].max_stiffness = 0.6;
    page->device[1].max_force = 0;  // not possible: the limits of the smallest device
    DaemonClient client(test::hapticd_program(), both);
    ASSERT_TRUE(client.facts().force[0] && client.facts().force[1]);
    EXPECT_EQ(client.facts().force[0]->peak, 2.5);
    EXPECT_EQ(client.facts().force[0]->continuous, 0.7);
    EXPECT_DOUBLE_EQ(client.facts().force[0]->stiffness, 600);
    EXPECT_DOUBLE_EQ(client.facts().force[0]->damping, 0.3);
    EXPECT_EQ(client.facts().force[1]->peak, 3.3);
    page->device[1].max_force = 3.3;
    const Vector3 wanted(0.4, -1.2, 1.9);
    const auto is_sent = [&](int hand) {
        for (int axis = 0; axis < 3; ++axis)
            if (page->device[hand].force[axis] != wanted[axis]) return false;
        return true;
    };
    EXPECT_TRUE(push_until(client, wanted, [&] { return is_sent(0) && is_sent(1); }));
    // Above the peak of one device: that one gets none, the other what was asked.
    EXPECT_TRUE(push_until(client, 1.2 * wanted, [&] {
        return force(0) == 0 && std::abs(page->device[1].force[2] - 1.2 * wanted[2]) < 1e-12;
    }));
    ForceReport report;
    ASSERT_TRUE(client.state().report[0].read(report));
    EXPECT_EQ(report.off, static_cast<std::uint64_t>(ForceOff::too_large));
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(TouchThroughTheDaemon, AFaultThatPassesStopsForceAndHandAndSaysWhatToDo) {
    struct Case {
        std::uint32_t code;
        DeviceFault fault;
    };
    DaemonClient client(test::hapticd_program(), both);
    for (const Case& one : {Case{0x0200, DeviceFault::warm_motors}, Case{0x0201, DeviceFault::too_much_force},
                            Case{0x0202, DeviceFault::too_much_force}, Case{0x0203, DeviceFault::too_fast},
                            Case{0x0204, DeviceFault::too_much_force}}) {
        const Vector3 gentle(0, 0.5, 0);
        ASSERT_TRUE(push_until(client, gentle, [&] { return force(0) == 0.5 && force(1) == 0.5; }));
        const std::int64_t begin = monotonic_ns();
        page->device[1].tick_error = one.code;
        ASSERT_TRUE(push_until(client, gentle, [&] { return force(0) == 0 && force(1) == 0; }));
        EXPECT_LE(monotonic_ns() - begin, limit) << one.code;
        ASSERT_TRUE(push_until(client, gentle, [&] { return !is_present(client, 1); }));
        EXPECT_TRUE(is_present(client, 0)) << "the other device has no fault";
        EXPECT_TRUE(says(client, words_of(one.fault))) << client.message().words();
        page->device[1].tick_error = 0;
        EXPECT_TRUE(push_until(client, gentle, [&] { return is_present(client, 1); }));
        EXPECT_TRUE(says(client, "")) << client.message().words();
    }
    EXPECT_EQ(page->inits, 2U) << "opened once each";
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(TouchThroughTheDaemon, ADeviceThatDoesNotAnswerIsOpenedAgain) {
    DaemonClient client(test::hapticd_program(), "touch");
    for (const std::uint32_t code : {0x0300U, 0x0302U, 0x0304U, 0x0103U}) {
        const std::uint32_t inits = page->inits;
        const Vector3 gentle(0, 0.5, 0);
        ASSERT_TRUE(push_until(client, gentle, [&] { return force(1) == 0.5; }));
        const std::int64_t begin = monotonic_ns();
        page->device[1].tick_error = code;
        ASSERT_TRUE(push_until(client, gentle, [&] { return force(1) == 0; }));
        EXPECT_LE(monotonic_ns() - begin, limit);
        ASSERT_TRUE(push_until(client, gentle, [&] { return !is_present(client, 1); }));
        EXPECT_TRUE(says(client, words_of(code == 0x0103U ? DeviceFault::driver : DeviceFault::no_answer)))
            << client.message().words();
        ASSERT_TRUE(until([&] { return client.poll() == DaemonClient::Health::restarting; }));
        EXPECT_NE(client.message().words().find("lost the device"), std::string::npos)
            << client.message().words();
        page->device[1].tick_error = 0;
        EXPECT_TRUE(until([&] {
            return client.poll() == DaemonClient::Health::good && is_present(client, 1) &&
                   client.message().empty();
        })) << client.message().words();
        EXPECT_GT(page->inits, inits);
    }
    EXPECT_EQ(page->misuse, 0U) << "closed before it was opened again";
}

TEST_F(TouchThroughTheDaemon, AnUnpluggedDeviceIsTriedAgainUntilItIsBack) {
    DaemonClient client(test::hapticd_program(), "touch");
    page->init_error = 0x0302;
    page->init_errors = 3;  // one opening tries three names
    page->device[1].tick_error = 0x0302;
    EXPECT_TRUE(until([&] {
        return client.poll() == DaemonClient::Health::restarting &&
               client.message().words().find("0x0302 Communication error; check its cable") !=
                   std::string::npos;
    })) << client.message().words();
    page->device[1].tick_error = 0;
    EXPECT_TRUE(until([&] { return client.poll() == DaemonClient::Health::good && is_present(client, 1); }))
        << client.message().words();
}

TEST_F(TouchThroughTheDaemon, AServoLoopThatStopsIsNoticed) {
    DaemonClient client(test::hapticd_program(), "touch");
    ASSERT_TRUE(until([&] { return is_present(client, 1); }));
    page->hang = 1;
    const std::int64_t begin = monotonic_ns();
    ASSERT_TRUE(until([&] { return !is_present(client, 1); }));
    EXPECT_LE(monotonic_ns() - begin, limit);
    EXPECT_TRUE(says(client, words_of(DeviceFault::servo_stopped))) << client.message().words();
    EXPECT_TRUE(until([&] { return client.poll() == DaemonClient::Health::restarting; }));
    page->hang = 0;
    EXPECT_TRUE(until([&] { return client.poll() == DaemonClient::Health::good && is_present(client, 1); }));
}

TEST_F(TouchThroughTheDaemon, NoForceBeforeTheDeviceIsCalibrated) {
    page->device[1].calibration = 0x5002;  // needs a hand
    DaemonClient client(test::hapticd_program(), "touch");
    const Vector3 gentle(0, 0.5, 0);
    std::uint64_t begin = page->device[1].frames;
    EXPECT_TRUE(push_until(client, gentle, [&] { return page->device[1].frames > begin + 800; }));
    EXPECT_EQ(force(1), 0);
    EXPECT_FALSE(is_present(client, 1));
    EXPECT_TRUE(says(client, words_of(DeviceFault::needs_calibration))) << client.message().words();
    page->device[1].calibration = 0x5001;  // the stylus is in the inkwell
    EXPECT_TRUE(push_until(client, gentle, [&] { return force(1) == 0.5; }));
    EXPECT_TRUE(is_present(client, 1));
    EXPECT_EQ(page->device[1].updates, 1U);
}

TEST_F(TouchThroughTheDaemon, WhatKeepsItFromOpeningIsNamedWithWhatToDo) {
    {
        test::Variable none("FULCRUM_LIBHD", "/none/libHD.so");
        EXPECT_EQ(
            error_of("touch").rfind("3D Systems Touch: the maker's library is not installed (/none/libHD", 0),
            0U)
            << error_of("touch");
    }
    {
        test::Variable old("FULCRUM_LIBHD", fake("libHD_old.so"));
        EXPECT_NE(error_of("touch").find("lacks a function that Fulcrum needs (hdUnschedule); install"),
                  std::string::npos)
            << error_of("touch");
    }
    {
        test::Variable part("FULCRUM_LIBHD", fake("libHD_part.so"));
        EXPECT_NE(error_of("touch").find("needs another one that is missing (libPhantomIOLib42.so"),
                  std::string::npos)
            << error_of("touch");
    }
    setenv("FULCRUM_LIBHD", fake("libHD.so").c_str(), 1);
    const auto refused = [&](std::uint32_t code, const char* what) {
        page->init_error = code;
        page->init_errors = 1000;
        const std::string error = error_of(both);
        EXPECT_NE(error.find(what), std::string::npos) << error;
        EXPECT_NE(error.find("Left Device"), std::string::npos) << error;
    };
    refused(0x0302,
            "does not answer: the maker's driver reports 0x0302 Communication error; check its cable");
    refused(0x0600, "install the licence");
    refused(0x0301, "end the other program");
    refused(0x0100, "check the device's name");
    page->init_error = 0x0301;  // a device that an earlier program left open
    page->init_errors = 9;
    EXPECT_EQ(error_of("touch"), "");
    for (const char* const wrong : {"touch:", "touch:a", "touch:,", "touch:a,a", "touch:a,b,c"})
        EXPECT_NE(error_of(wrong).find("device"), std::string::npos) << wrong;
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(TouchThroughTheDaemon, ForceIsZeroAndDevicesAreClosedInOrderAfterTheProgramDies) {
    for (const int number : {SIGKILL, SIGSTOP}) {
        const std::uint32_t closed = page->closed_in_order;
        const pid_t child = fork();
        if (child == 0) {
            DaemonClient client(test::hapticd_program(), both);
            push_until(client, Vector3(0, 0.5, 0), [] { return false; });
            _exit(0);
        }
        ASSERT_TRUE(until([&] { return force(0) == 0.5 && force(1) == 0.5; }));
        const std::int64_t begin = monotonic_ns();
        kill(child, number);
        ASSERT_TRUE(until([&] { return force(0) == 0 && force(1) == 0; }));
        EXPECT_LE(monotonic_ns() - begin, limit) << strsignal(number);
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        EXPECT_TRUE(until([&] { return page->closed_in_order == closed + 2; })) << strsignal(number);
    }
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(TouchThroughTheDaemon, WhatTheLibraryPrintsDisturbsNothingAndItsNumbersHavePoints) {
    const test::GermanLocale german;
    ASSERT_TRUE(german.in_force()) << "localedef cannot make de_DE: install the package locales";
    const test::Variable language("LC_ALL", "de_DE.UTF-8");
    page->of_desktop = 1;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const std::string error = error_of("touch");
    const std::string out = testing::internal::GetCapturedStdout(),
                      err = testing::internal::GetCapturedStderr();
    EXPECT_EQ(error, "");
    EXPECT_EQ(out, "");
    EXPECT_NE(err.find("DEVELOPER EDITION"), std::string::npos);
    EXPECT_EQ(page->inits, 1U);
    EXPECT_EQ(page->comma, 0U) << "the device process has no language";
    // In a program that has one, the same library writes a comma: the test above can fail.
    hapticd::TouchDevice device(hapticd::touch_names("touch"));
    device.open();
    device.close();
    EXPECT_EQ(page->comma, 1U);
}

TEST_F(TouchThroughTheDaemon, TheLookAtTheLibraryLoadsItInAnotherProcess) {
    EXPECT_EQ(look_at_library(test::hapticd_program(), "touch").state, LibraryState::ready);
    for (const auto& [name, state] : {std::pair("libHD_old.so", LibraryState::outdated),
                                      std::pair("libHD_part.so", LibraryState::incomplete),
                                      std::pair("none.so", LibraryState::missing)}) {
        setenv("FULCRUM_LIBHD", fake(name).c_str(), 1);
        const LibraryLook look = look_at_library(test::hapticd_program(), "touch");
        EXPECT_EQ(look.state, state) << name << look.detail;
        EXPECT_NE(look.detail, "");
    }
    EXPECT_EQ(look_at_library("/none/fulcrum-hapticd", "touch").state, LibraryState::unusable);
    EXPECT_EQ(look_at_library("/bin/true", "touch").state, LibraryState::unusable);
    EXPECT_EQ(page->inits, 0U) << "no device is opened";
}

TEST_F(TouchThroughTheDaemon, TheServoLoopAllocatesNothing) {
    hapticd::TouchDevice device(hapticd::touch_names(both));
    device.open();
    DevicePose poses[device_slots];
    const auto run = [&](std::uint64_t ticks) {
        const std::uint64_t begin = page->device[1].frames;
        return until([&] {
            device.read(monotonic_ns(), poses);
            for (int h = 0; h < 2; ++h) device.render(h, Vector3(0, 0.2, 0), 0);
            return page->device[1].frames > begin + ticks;
        });
    };
    EXPECT_TRUE(run(50));
    EXPECT_EQ(test::allocations_in([&] { EXPECT_TRUE(run(300)); }), 0U);
    EXPECT_EQ(poses[0].present, 1U);
    EXPECT_EQ(force(0), 0.2);
    // The process of the device does not run: no force is left from its last tick.
    const std::uint64_t last = page->device[1].frames;
    EXPECT_TRUE(until([&] { return page->device[1].frames > last + 30; }));
    EXPECT_EQ(force(0), 0);
    device.close();
    EXPECT_EQ(page->closed_in_order, 2U);
    EXPECT_EQ(page->misuse, 0U);
}

}  // namespace
}  // namespace fulcrum
