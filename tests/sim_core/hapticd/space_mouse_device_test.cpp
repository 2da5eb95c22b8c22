// SPDX-License-Identifier: Apache-2.0
// A SpaceMouse through its real entry: fulcrum-hapticd connects to the socket of a spacenavd in the test.
#include "sim_core/hapticd/space_mouse_device.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/devices/spacenavd_socket.h"
#include "sim_core/numerics/input_error.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/allocation_count.h"
#include "tests/support/built.h"
#include "tests/support/fake_spacenavd.h"
#include "tests/support/own_folder.h"
#include "tests/support/process_rights.h"

namespace fulcrum {
namespace {

using hapticd::SpaceMouseDevice;
using test::FakeSpacenavd;
using test::until;
constexpr std::int32_t far_away = 350;

class SpaceMouseOfSpacenavd : public ::testing::Test {
  protected:
    DevicePose pose(const DaemonClient& client, int slot) const {
        DevicePose newest;
        client.state().pose[slot].read(newest);
        return newest;
    }
    test::OwnFolder folder;
    const std::string path = (folder.path() / "spnav.sock").string();
    test::Variable socket_variable{"SPNAV_SOCKET", path};
};

TEST_F(SpaceMouseOfSpacenavd, TheCapMovesTheHandleAndTurnsTheRollInBothProtocols) {
    for (const int protocol : {1, 0}) {
        FakeSpacenavd daemon(path, protocol);
        DaemonClient client(test::hapticd_program(), "space-mouse");
        EXPECT_EQ(client.facts().kind, "space-mouse");
        EXPECT_TRUE(client.facts().slot[scope_slot]);
        EXPECT_FALSE(client.facts().slot[0]);
        ASSERT_TRUE(until([&] { return daemon.connected() && pose(client, scope_slot).present == 1; }));
        EXPECT_TRUE(test::is_filtered(client.device_process())) << "while its connection is open";
        EXPECT_EQ(daemon.sensitivity, protocol == 0 ? 1.0F : 0.0F);
        daemon.send_event(3, {1, 2, 3, 4, 5, 6, 7});  // another device was connected: of no concern
        // To the right, down and away from the person; the cap turned clockwise.
        ASSERT_TRUE(until([&] {
            daemon.send_event(0, {far_away, -far_away, far_away, 0, -far_away, 0, 16});
            return pose(client, scope_slot).position[0] > 2e-3;
        }));
        const DevicePose now = pose(client, scope_slot);
        EXPECT_LT(now.position[1], -1e-3);
        EXPECT_LT(now.position[2], -1e-3) << "+z of the device frame is towards the person";
        EXPECT_GT(now.roll, 0.01);
        daemon.send_event(0, {0, 0, 0, 0, 0, 0, 16});
        daemon.send_event(1, {0, 1, 0, 0, 0, 0, 0});
        EXPECT_TRUE(until([&] { return pose(client, scope_slot).buttons == button_primary; }));
        daemon.send_event(2, {0, 0, 0, 0, 0, 0, 0});
        EXPECT_TRUE(until([&] { return pose(client, scope_slot).buttons == 0; }));
        client.poll();
        EXPECT_TRUE(client.message().empty());
    }
}

TEST_F(SpaceMouseOfSpacenavd, AfterAHangUpOrRubbishTheHandIsAbsentUntilItIsOpenedAgain) {
    FakeSpacenavd daemon(path, 1);
    DaemonClient client(test::hapticd_program(), "space-mouse:right");
    ASSERT_TRUE(until([&] { return daemon.connected() && pose(client, 1).present == 1; }));
    for (const bool rubbish : {false, true}) {
        const auto process = client.device_process();
        if (rubbish)
            daemon.send_event(99, {});
        else
            daemon.hang_up();
        EXPECT_TRUE(until([&] { return pose(client, 1).present == 0; }));
        EXPECT_TRUE(until([&] {
            client.poll();
            return client.message().words().find("lost the device") != std::string::npos ||
                   client.device_process() != process;
        }));
        if (rubbish) daemon.hang_up();
        EXPECT_TRUE(until([&] {
            client.poll();
            return client.device_process() != process && pose(client, 1).present == 1;
        })) << rubbish;
    }
}

TEST_F(SpaceMouseOfSpacenavd, WithoutSpacenavdItSaysWhatToDo) {
    try {
        DaemonClient client(test::hapticd_program(), "space-mouse");
        FAIL();
    } catch (const InputError& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.find(path + ": spacenavd, which reads the SpaceMouse, does not answer: No such file"),
                  0U)
            << what;
        EXPECT_NE(what.find("systemctl restart spacenavd"), std::string::npos);
    }
    EXPECT_THROW(hapticd::space_mouse_slot("space-mouse:middle"), InputError);
}

TEST_F(SpaceMouseOfSpacenavd, ASocketThatThisAccountMayNotUseIsNamedWithWhatToDo) {
    FakeSpacenavd daemon(path, 1);
    ASSERT_EQ(chmod(path.c_str(), 0), 0);
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {  // root may use any socket
        if (getuid() == 0 && setuid(65534) != 0) _exit(1);
        std::string what = "opened";
        try {
            SpaceMouseDevice device(hapticd::space_mouse_slot("space-mouse"));
            device.open();
        } catch (const InputError& error) {
            what = error.what();
        }
        _exit(write(ends[1], what.data(), what.size()) == static_cast<ssize_t>(what.size()) ? 0 : 1);
    }
    close(ends[1]);
    std::string what(2000, '\0');
    const ssize_t size = read(ends[0], what.data(), what.size());
    close(ends[0]);
    waitpid(child, nullptr, 0);
    ASSERT_GT(size, 0);
    what.resize(static_cast<std::size_t>(size));
    EXPECT_EQ(what.find(path + ": you have no permission to use the socket of spacenavd"), 0U) << what;
    EXPECT_NE(what.find("sudo chmod a+rw " + path), std::string::npos) << what;
}

TEST(SpaceMouseDevice, ACapThatWasHeldStopsWhenNothingMoreComesAndTheLoopAllocatesNothing) {
    const test::OwnFolder folder;
    const std::string path = (folder.path() / "s").string();
    const test::Variable variable("SPNAV_SOCKET", path);
    FakeSpacenavd daemon(path, 1);
    SpaceMouseDevice device(hapticd::space_mouse_slot("space-mouse:left"));
    device.open();
    EXPECT_EQ(device.protocol(), 1);
    ASSERT_TRUE(until([&] { return daemon.connected(); }));
    DevicePose poses[device_slots];
    std::int64_t now = 1'000'000'000;
    const auto run = [&](int ticks) {
        return test::allocations_in([&] {
            for (int i = 0; i < ticks; ++i) device.read(now += 1'000'000, poses);
        });
    };
    std::int32_t event[8] = {0, far_away, 0, 0, 0, 0, 0, 16};
    daemon.send_bytes(event, 11);  // in two parts
    usleep(2000);
    EXPECT_EQ(run(1), 0U);
    EXPECT_EQ(poses[0].position[0], 0);
    daemon.send_bytes(reinterpret_cast<const char*>(event) + 11, sizeof event - 11);
    usleep(2000);
    EXPECT_EQ(run(2000), 0U);
    // 0.3 s at full speed, although nothing said that the cap was let go.
    EXPECT_NEAR(poses[0].position[0], 0.3 * hapticd::space_mouse_speed, 2e-4);
    EXPECT_EQ(poses[0].present, 1U);
    event[1] = 1 << 20;  // no deflection
    daemon.send_bytes(event, sizeof event);
    usleep(2000);
    run(1);
    EXPECT_TRUE(device.lost());
    EXPECT_EQ(device.fault().fault, static_cast<std::uint64_t>(DeviceFault::spacenavd));
    EXPECT_EQ(device.fault().hands, 1U);
}

TEST(SpaceMouseDevice, ResponseIsStillInTheMiddleAndRisesToTheFullDeflection) {
    using hapticd::space_mouse_response;
    EXPECT_EQ(space_mouse_response(0), 0);
    EXPECT_EQ(space_mouse_response(10), 0);
    EXPECT_EQ(space_mouse_response(-350), -1);
    EXPECT_EQ(space_mouse_response(4000), 1);
    double before = 0;
    for (int counts = 14; counts <= 350; ++counts) {
        EXPECT_GE(space_mouse_response(counts), before);
        EXPECT_EQ(space_mouse_response(-counts), -space_mouse_response(counts));
        before = space_mouse_response(counts);
    }
}

TEST(SpacenavdSocket, IsNamedByTheConfiguration) {
    const test::OwnFolder folder;
    const std::string file = (folder.path() / "spnavrc").string();
    unsetenv("SPNAV_SOCKET");
    EXPECT_EQ(spacenavd_socket(file), "/var/run/spnav.sock");
    std::ofstream(file) << "# socket = /no\nsensitivity = 1\n  socket =  /tmp/other.sock \n";
    EXPECT_EQ(spacenavd_socket(file), "/tmp/other.sock");
    const test::Variable variable("SPNAV_SOCKET", "/mine");
    EXPECT_EQ(spacenavd_socket(file), "/mine");
}

}  // namespace
}  // namespace fulcrum
