// SPDX-License-Identifier: Apache-2.0
// Devices of Force Dimension through their real entry: fulcrum-hapticd loads a fake libdrd
// (tests/fakes/libdrd.cpp).
#include "sim_core/hapticd/force_dimension_device.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <cmath>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/numerics/input_error.h"
#include "tests/fakes/fake_force_dimension.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/allocation_count.h"
#include "tests/support/built.h"
#include "tests/support/process_rights.h"

namespace fulcrum {
namespace {

using test::says;
using test::until;

constexpr std::int64_t limit = 50'000'000;  // ns
constexpr int force_status = 5, error_status = 9, force_off_cause = 14;

class ForceDimensionThroughTheDaemon : public ::testing::Test {
  protected:
    static std::string fake(const char* name) { return test::fake_library(name); }
    static DevicePose pose(const DaemonClient& client, int hand) {
        DevicePose newest;
        client.state().pose[hand].read(newest);
        return newest;
    }
    static bool is_present(const DaemonClient& client, int hand) { return pose(client, hand).present == 1; }
    double force(int number) const {
        double most = 0;
        for (const auto& f : page->device[number].force) most = std::max(most, std::abs(f.load()));
        return most;
    }
    /// Sends these forces to the two hands every half millisecond until the condition holds, at most 8 s.
    template <typename Condition>
    bool push_each_until(DaemonClient& client, const Vector3& left, const Vector3& right, Condition&& holds) {
        return until([&] {
            ++command.sequence;
            command.time = monotonic_ns();
            for (int h = 0; h < 2; ++h) {
                for (int axis = 0; axis < 3; ++axis) command.force[axis] = (h == 0 ? left : right)[axis];
                client.command().command[h].write(command);
            }
            return holds();
        });
    }
    /// The same force for both.
    template <typename Condition>
    bool push_until(DaemonClient& client, const Vector3& wanted, Condition&& holds) {
        return push_each_until(client, wanted, wanted, holds);
    }
    static std::string error_of(const std::string& specification) {
        try {
            DaemonClient client(test::hapticd_program(), specification);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }
    test::FakePage<test::FakeForceDimensionPage> page{"FAKE_FORCE_DIMENSION_PAGE"};
    test::Variable library{"FULCRUM_LIBDRD", fake("libdrd.so")};
    ForceCommand command;
};

TEST_F(ForceDimensionThroughTheDaemon, PosesAreTurnedIntoTheDeviceFrame) {
    DaemonClient client(test::hapticd_program(), "force-dimension");
    EXPECT_EQ(client.facts().title, "omega.7");
    EXPECT_EQ(client.facts().kind, "force-dimension");
    for (int n = 0; n < 2; ++n) {
        page->device[n].position[1] = 0.02 + n;  // to the right
        page->device[n].position[2] = -0.03;
        page->device[n].turn = 0.4;
        page->device[n].tilt = 0.6;
        page->device[n].gripper = 0.1;
        page->device[n].buttons = 1;
        page->device[n].position[0] = 0.01;  // towards the person
    }
    ASSERT_TRUE(until([&] {
        return pose(client, 0).position[2] != 0 && pose(client, 1).position[2] != 0 &&
               pose(client, 1).buttons != 0;
    }));
    for (int h = 0; h < 2; ++h) {
        const DevicePose now = pose(client, h);
        EXPECT_EQ(now.present, 1U);
        EXPECT_DOUBLE_EQ(now.position[0], 0.02 + h);
        EXPECT_DOUBLE_EQ(now.position[1], -0.03);
        EXPECT_DOUBLE_EQ(now.position[2], 0.01);
        EXPECT_NEAR(now.roll, -0.4, 1e-12) << "whatever the tilt";
        EXPECT_DOUBLE_EQ(now.jaw, 0.2);
        EXPECT_EQ(now.buttons, std::uint32_t{button_energy});
    }
    EXPECT_TRUE(test::is_filtered(client.device_process())) << "the thread that reads it as well";
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(ForceDimensionThroughTheDaemon, ADeviceWithoutAGripperClosesJawsWithItsFirstButton) {
    page->count = 1;
    page->device[0].has_gripper = 0;
    DaemonClient client(test::hapticd_program(), "force-dimension");
    EXPECT_FALSE(client.facts().slot[0]) << "one device moves the right hand";
    page->device[0].buttons = 7;
    EXPECT_TRUE(until([&] {
        const DevicePose now = pose(client, 1);
        return now.jaw == 0 && now.buttons == (button_energy | button_exchange);
    }));
    page->device[0].buttons = 0;
    EXPECT_TRUE(until([&] { return pose(client, 1).jaw == 1; }));
}

TEST_F(ForceDimensionThroughTheDaemon, ForceSentIsForceAskedInTheLibrarysFrame) {
    DaemonClient client(test::hapticd_program(), "force-dimension:1,0");
    ASSERT_TRUE(client.facts().force[0] && client.facts().force[1]);
    EXPECT_EQ(page->device[0].max_force, client.facts().force[1]->peak);
    page->device[0].saturated = 1;  // not a fault
    // A force of its own for each hand: device 1 is the left one.
    const Vector3 left(0.4, -1.2, 1.9), right(-0.3, 0.8, 0.5);
    EXPECT_TRUE(push_each_until(client, left, right,
                                [&] {
                                    const auto& of_left = page->device[1].force;
                                    const auto& of_right = page->device[0].force;
                                    return of_left[0] == 1.9 && of_left[1] == 0.4 && of_left[2] == -1.2 &&
                                           of_right[0] == 0.5 && of_right[1] == -0.3 && of_right[2] == 0.8;
                                }))
        << "device 0 has " << force(0) << " N along one axis, device 1 " << force(1);
    EXPECT_TRUE(is_present(client, 0) && is_present(client, 1));
    page->device[0].position[0] = 0.05;
    EXPECT_TRUE(until([&] { return pose(client, 1).position[2] == 0.05; }))
        << "device 0 moves the right hand";
    EXPECT_TRUE(push_until(client, 5 * left, [&] { return force(0) == 0 && force(1) == 0; }))
        << "above the peak";
}

TEST_F(ForceDimensionThroughTheDaemon, AFaultStopsForceAndHandAndSaysWhatToDo) {
    DaemonClient client(test::hapticd_program(), "force-dimension:,0");
    test::FakeForceDimensionDevice& device = page->device[0];
    const Vector3 gentle(0, 0.5, 0);
    const auto force_comes = [&] {
        return push_until(client, gentle, [&] { return force(0) == 0.5 && is_present(client, 1); });
    };
    const auto stops_with = [&](DeviceFault fault, const std::function<void()>& make) {
        ASSERT_TRUE(force_comes());
        const std::int64_t begin = monotonic_ns();
        make();
        ASSERT_TRUE(push_until(client, gentle, [&] { return !is_present(client, 1); }));
        EXPECT_LE(monotonic_ns() - begin, limit);
        ASSERT_TRUE(push_until(client, gentle, [&] { return force(0) == 0; }));
        EXPECT_LE(monotonic_ns() - begin, limit);
        EXPECT_TRUE(says(client, words_of(fault))) << client.message().words();
    };
    stops_with(DeviceFault::switched_off, [&] {
        device.status[force_off_cause] = 1;
        device.status[force_status] = 0;
    });
    const std::uint32_t enabled = device.enabled;
    std::uint64_t begin = device.ticks;
    EXPECT_TRUE(until([&] { return device.ticks > begin + 1500; }));
    EXPECT_EQ(device.enabled, enabled) << "what a person switched off stays off";
    device.status[force_status] = 1;
    stops_with(DeviceFault::too_fast, [&] {
        device.status[force_off_cause] = 2;
        device.status[force_status] = 0;
    });
    EXPECT_TRUE(force_comes()) << "after a second it is switched on again";
    stops_with(DeviceFault::needs_calibration, [&] { device.status[3] = 1; });
    device.status[3] = 0;
    EXPECT_TRUE(force_comes());
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(ForceDimensionThroughTheDaemon, ADeviceThatDoesNotAnswerIsOpenedAgain) {
    DaemonClient client(test::hapticd_program(), "force-dimension:,0");
    test::FakeForceDimensionDevice& device = page->device[0];
    const auto lost_and_back = [&](DeviceFault fault, const std::function<void(int)>& set) {
        const std::uint32_t closed = device.closed;
        ASSERT_TRUE(until([&] { return is_present(client, 1); }));
        const std::int64_t begin = monotonic_ns();
        set(1);
        ASSERT_TRUE(until([&] { return !is_present(client, 1); }));
        EXPECT_LE(monotonic_ns() - begin, limit);
        EXPECT_TRUE(says(client, words_of(fault))) << client.message().words();
        ASSERT_TRUE(until([&] { return client.poll() == DaemonClient::Health::restarting; }));
        set(0);
        device.open = 0;  // the system closes what a process that was killed had open
        EXPECT_TRUE(until([&] {
            return client.poll() == DaemonClient::Health::good && is_present(client, 1);
        })) << client.message().words();
        if (fault == DeviceFault::no_answer) {
            EXPECT_EQ(device.closed, closed + 1);
        }
    };
    lost_and_back(DeviceFault::no_answer, [&](int on) { device.pose_fails = static_cast<unsigned>(on); });
    lost_and_back(DeviceFault::no_answer, [&](int on) { device.force_fails = static_cast<unsigned>(on); });
    lost_and_back(DeviceFault::no_answer, [&](int on) { device.status[1] = 1 - on; });
    lost_and_back(DeviceFault::servo_stopped, [&](int on) { page->hang = static_cast<unsigned>(on); });
}

TEST_F(ForceDimensionThroughTheDaemon, AFirmwareThatTheLibraryNamesIsTheReasonAndSaysWhatToUpdate) {
    page->old_firmware = 1;
    page->device[0].opens = 0;
    const std::string refusal = error_of("force-dimension:,0");
    EXPECT_NE(
        refusal.find("device 0: the device does not open: the maker's driver reports 'firmware version is "
                     "not supported'; update the firmware of the device"),
        std::string::npos)
        << refusal;
    page->device[0].opens = 1;
    DaemonClient client(test::hapticd_program(), "force-dimension:,0");
    ASSERT_TRUE(until([&] { return is_present(client, 1); }));
    const std::int64_t begin = monotonic_ns();
    page->device[0].status[error_status] = 1;
    ASSERT_TRUE(until([&] { return !is_present(client, 1); }));
    EXPECT_LE(monotonic_ns() - begin, limit);
    EXPECT_TRUE(says(client, words_of(DeviceFault::firmware))) << client.message().words();
    page->device[0].status[error_status] = 0;
    page->old_firmware = 0;
    EXPECT_TRUE(until([&] { return client.poll() == DaemonClient::Health::good && is_present(client, 1); }))
        << client.message().words();
}

TEST_F(ForceDimensionThroughTheDaemon, WhatKeepsItFromOpeningIsNamedWithWhatToDo) {
    const auto refused = [](const std::string& named, const char* what) {
        const std::string error = error_of(named);
        EXPECT_NE(error.find(what), std::string::npos) << error;
    };
    for (const auto& [name, what] :
         {std::pair("none.so", "is not installed"), std::pair("libdrd_old.so", "(dhdErrorGetLastStr)")}) {
        test::Variable other("FULCRUM_LIBDRD", fake(name));
        refused("force-dimension", what);
    }
    setenv("FULCRUM_LIBDRD", fake("libdrd.so").c_str(), 1);
    page->count = 0;
    refused("force-dimension", "no device was found; connect it");
    page->count = 2;
    page->device[1].opens = 0;
    refused("force-dimension",
            "device 1: the device does not open: the maker's driver reports 'no device found'");
    EXPECT_EQ(page->device[0].open, 0U) << "the other one is closed again";
    for (const char* const wrong : {"force-dimension:", "force-dimension:1", "force-dimension:1,1",
                                    "force-dimension:a,1", "force-dimension:1,22"})
        refused(wrong, "write force-dimension:LEFT,RIGHT");
    EXPECT_EQ(look_at_library(test::hapticd_program(), "force-dimension").state, LibraryState::ready);
}

TEST_F(ForceDimensionThroughTheDaemon, ForceIsZeroAndDevicesAreClosedAfterTheProgramDies) {
    for (const int number : {SIGKILL, SIGSTOP}) {
        const std::uint32_t closed = page->device[0].closed;
        const pid_t child = fork();
        if (child == 0) {
            DaemonClient client(test::hapticd_program(), "force-dimension");
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
        EXPECT_TRUE(until([&] { return page->device[0].closed == closed + 1; }));
        EXPECT_TRUE(until([&] { return page->device[1].open == 0; }));
    }
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(ForceDimensionThroughTheDaemon, AfterAnOverseerThatWasStoppedTheDeviceCanBeOpenedAtOnce) {
    for (int i = 0; i < 2; ++i) {
        DaemonClient client(test::hapticd_program(), "force-dimension");
        EXPECT_TRUE(client.wait_for_sign());
        ASSERT_EQ(kill(client.overseer(), SIGSTOP), 0);
        EXPECT_EQ(page->device[1].open, 1U);
        if (i == 1) {
            EXPECT_TRUE(until([&] { return !client.wait_for_sign(); }));
        }
    }
    EXPECT_EQ(page->device[0].open, 0U);
    EXPECT_EQ(page->device[0].closed, 2U);
    EXPECT_EQ(page->misuse, 0U);
}

TEST_F(ForceDimensionThroughTheDaemon, TheServoThreadAllocatesNothing) {
    hapticd::ForceDimensionDevice device(hapticd::force_dimension_numbers("force-dimension"));
    device.open();
    DevicePose poses[device_slots];
    const auto run = [&](std::uint64_t ticks) {
        const std::uint64_t begin = page->device[1].ticks;
        return until([&] {
            device.read(monotonic_ns(), poses);
            for (int h = 0; h < 2; ++h) device.render(h, Vector3(0, 0.2, 0), 0);
            return page->device[1].ticks > begin + ticks;
        });
    };
    EXPECT_TRUE(run(50));
    EXPECT_EQ(test::allocations_in([&] { EXPECT_TRUE(run(300)); }), 0U);
    EXPECT_EQ(poses[0].present, 1U);
    device.close();
    EXPECT_EQ(page->misuse, 0U);
}

}  // namespace
}  // namespace fulcrum
