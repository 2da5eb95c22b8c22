// SPDX-License-Identifier: Apache-2.0
// Haply Inverse3 and VerseGrip through their real entry: fulcrum-hapticd connects to a service in the test.
#include "sim_core/hapticd/haply_device.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/numerics/input_error.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/built.h"
#include "tests/support/fake_haply.h"

namespace fulcrum {
namespace {

using hapticd::haply_specification;
using test::FakeHaply;
using test::until;
using Mode = FakeHaply::Mode;
using Form = FakeHaply::Form;

const std::vector<FakeHaply::Device> one_device = {{"049D", "right"}};
const std::vector<FakeHaply::Device> two_devices = {{"0A11", "right"}, {"0B22", "left"}};

DevicePose haply_pose(const DaemonClient& client, int hand) {
    DevicePose newest;
    client.state().pose[hand].read(newest);
    return newest;
}
bool haply_present(const DaemonClient& client, int hand) {
    return haply_pose(client, hand).present == 1;
}

/// Sends a force to both hands as an attempt does, until the condition holds.
class HaplyPush {
  public:
    template <typename Condition>
    bool until_holds(DaemonClient& client, const Vector3& wanted, Condition&& holds) {
        return until([&] {
            ++command_.sequence;
            command_.time = monotonic_ns();
            for (int axis = 0; axis < 3; ++axis) command_.force[axis] = wanted[axis];
            for (auto& hand : client.command().command) hand.write(command_);
            return holds();
        });
    }

  private:
    ForceCommand command_;
};

std::string haply_error(const std::string& specification) {
    try {
        DaemonClient client(test::hapticd_program(), specification);
    } catch (const InputError& error) {
        return error.what();
    }
    return "opened";
}

TEST(HaplySpecification, PortsDevicesAndAxesAreRead) {
    const auto plain = haply_specification("haply");
    EXPECT_EQ(plain.ports, (std::vector<int>{10001, 10000}));
    EXPECT_EQ(plain.events_port, 10020);
    EXPECT_FALSE(plain.hand[0] || plain.hand[1]);
    // To the right, away from the person and up in the service's frame.
    EXPECT_EQ(plain.axes * Vector3(1, 2, 3), Vector3(1, 3, -2));
    const auto full = haply_specification("haply:123,left=A,right=B,events=0,grip=-y,axes=+x+y+z");
    EXPECT_EQ(full.ports, std::vector<int>{123});
    EXPECT_EQ(full.hand[0], "A");
    EXPECT_EQ(full.hand[1], "B");
    EXPECT_EQ(full.events_port, 0);
    EXPECT_EQ(full.grip, -Vector3::UnitY());
    EXPECT_EQ(haply_specification("haply:left=A").ports.size(), 2U);
    for (const char* wrong : {"haply:0", "haply:70000", "haply:tracker.local", "haply:192.168.1.1:10001",
                              "haply:1,left=", "haply:1,left=A,right=A", "haply:1,axes=+x+y-z",
                              "haply:1,grip=z", "haply:1,2", "haply:", "haply:1,", "haply:1,events=-1"})
        EXPECT_THROW(haply_specification(wrong), InputError) << wrong;
}

TEST(HaplyOfService, PositionsRollButtonsAndForceGoTheRightWayRound) {
    FakeHaply haply(two_devices, 2);
    haply.move(0, Vector3(0.01, 0.02, 0.03));
    haply.move(1, Vector3(-0.04, -0.05, 0.06));
    DaemonClient client(test::hapticd_program(), haply.specification());
    EXPECT_EQ(client.facts().title, "Haply Inverse3 with VerseGrip");
    EXPECT_TRUE(client.facts().slot[0] && client.facts().slot[1]) << "by their handedness";
    ASSERT_TRUE(client.facts().force[0] && client.facts().force[1]);
    EXPECT_EQ(client.facts().force[0]->torque, 0);
    ASSERT_TRUE(until([&] { return haply_present(client, 0) && haply_present(client, 1); }));
    const DevicePose right = haply_pose(client, 1), left = haply_pose(client, 0);
    EXPECT_EQ(Vector3(right.position[0], right.position[1], right.position[2]), Vector3(0.01, 0.03, -0.02));
    EXPECT_EQ(Vector3(left.position[0], left.position[1], left.position[2]), Vector3(-0.04, 0.06, 0.05));
    EXPECT_EQ(right.jaw, 1);
    // The grips: the first is the left hand's. The tip points along the grip's z, away from the person.
    const Quaternion away = Quaternion::FromTwoVectors(Vector3::UnitZ(), Vector3::UnitY());
    haply.turn(0, away * Quaternion(Eigen::AngleAxisd(0.4, Vector3::UnitZ())), false, true, true);
    haply.turn(1, Quaternion::Identity(), true);
    ASSERT_TRUE(until([&] { return haply_pose(client, 1).jaw == 0 && haply_pose(client, 0).buttons != 0; }));
    EXPECT_EQ(left.roll, 0);
    EXPECT_NEAR(haply_pose(client, 0).roll, 0.4, 1e-6);
    EXPECT_EQ(haply_pose(client, 0).buttons, std::uint32_t{button_energy | button_exchange});
    EXPECT_EQ(haply_pose(client, 0).jaw, 1);
    HaplyPush push;
    const Vector3 wanted(0.3, 0.5, -0.7);  // device frame
    EXPECT_TRUE(push.until_holds(client, wanted, [&] {
        return (haply.force(0) - Vector3(0.3, 0.7, 0.5)).norm() < 1e-9 && haply.force(1) == haply.force(0);
    }));
    EXPECT_TRUE(push.until_holds(client, Vector3(0, 9, 0), [&] {
        return haply.force(0) == Vector3::Zero() && haply.force(1) == Vector3::Zero();
    })) << "a force above the peak of the device is none";
}

TEST(HaplyOfService, ForceIsRenderedInTheFormThatEachVersionTakes) {
    for (const Form form : {Form::values, Form::refuses_vector}) {
        FakeHaply haply(one_device);
        haply.form = form;
        DaemonClient client(test::hapticd_program(), haply.specification());
        HaplyPush push;
        EXPECT_TRUE(push.until_holds(client, Vector3(0.5, 0, 0), [&] { return haply.force(0).x() == 0.5; }))
            << static_cast<int>(form);
    }
}

TEST(HaplyOfService, AFaultThatPassesStopsForceAndHandAndSaysWhatToDo) {
    FakeHaply haply(one_device);
    DaemonClient client(test::hapticd_program(), haply.specification());
    HaplyPush push;
    const Vector3 wanted(0, 0.5, 0);
    const auto works = [&] {
        client.poll();
        return haply_present(client, 1) && haply.force(0).z() == 0.5 && client.message().empty();
    };
    const auto expect_fault = [&](DeviceFault fault, const char* what) {
        EXPECT_TRUE(push.until_holds(client, wanted,
                                     [&] {
                                         client.poll();
                                         return haply.force(0) == Vector3::Zero() &&
                                                !haply_present(client, 1) &&
                                                client.message().words() == words_of(fault);
                                     }))
            << what << ": " << client.message().words();
    };
    ASSERT_TRUE(push.until_holds(client, wanted, works));
    const auto process = client.device_process();
    struct Case {
        Mode mode;
        DeviceFault fault;
    };
    for (const Case& one : {Case{Mode::garbage, DeviceFault::haply_message},
                            {Mode::cut, DeviceFault::haply_message},
                            {Mode::nan, DeviceFault::haply_message},
                            {Mode::null, DeviceFault::haply_message},
                            {Mode::far_away, DeviceFault::haply_message},
                            {Mode::other_service, DeviceFault::haply_message},
                            {Mode::not_calibrated, DeviceFault::needs_calibration},
                            {Mode::no_power, DeviceFault::no_power}}) {
        haply.mode = one.mode;
        expect_fault(one.fault, std::to_string(static_cast<int>(one.mode)).c_str());
        haply.mode = Mode::good;
        EXPECT_TRUE(push.until_holds(client, wanted, works)) << client.message().words();
    }
    haply.event("device-battery-low", "049D");
    haply.event("device-safety-triggered", "0000");
    haply.event("device-safety-triggered", "049D");
    expect_fault(DeviceFault::safety_brake, "brake");
    EXPECT_EQ(client.device_process(), process) << "none of these opens it again";
}

TEST(HaplyOfService, AServiceThatStallsEndsOrLosesTheDeviceIsOpenedAgain) {
    auto haply = std::make_unique<FakeHaply>(one_device);
    const int port = haply->port();
    DaemonClient client(test::hapticd_program(), "haply:" + std::to_string(port) + ",events=0");
    HaplyPush push;
    const Vector3 wanted(0, 0.5, 0);
    const auto works = [&] {
        client.poll();
        return haply_present(client, 1) && haply->force(0).z() == 0.5;
    };
    const auto expect_opened_again = [&](DeviceFault fault) {
        const auto process = client.device_process();
        EXPECT_TRUE(push.until_holds(client, wanted, [&] {
            client.poll();
            return !haply_present(client, 1) && client.message().words() == words_of(fault);
        })) << client.message().words();
        haply->mode = Mode::good;
        EXPECT_TRUE(push.until_holds(client, wanted, [&] {
            return works() && client.device_process() != process;
        })) << client.message().words();
    };
    ASSERT_TRUE(push.until_holds(client, wanted, works));
    haply->mode = Mode::silent;
    expect_opened_again(DeviceFault::haply_silent);
    haply->mode = Mode::no_device;
    expect_opened_again(DeviceFault::no_answer);
    haply->hang_up();
    EXPECT_TRUE(push.until_holds(client, wanted, [&] {
        client.poll();
        return client.message().words() == words_of(DeviceFault::haply_ended);
    })) << client.message().words();
    haply.reset();
    EXPECT_TRUE(push.until_holds(client, wanted, [&] {
        client.poll();
        return client.message().words().find("does not answer: Connection refused") != std::string::npos;
    })) << client.message().words();
    EXPECT_FALSE(haply_present(client, 1));
    haply = std::make_unique<FakeHaply>(one_device, 0, port);
    EXPECT_TRUE(push.until_holds(client, wanted, works)) << client.message().words();
}

TEST(HaplyOfService, WhatDoesNotOpenSaysWhyAndWhatToDo) {
    int closed = 0;
    {
        FakeHaply gone(one_device);
        closed = gone.port();
    }
    EXPECT_NE(haply_error("haply:" + std::to_string(closed))
                  .find("the Inverse service of Haply does not answer: Connection refused; install the "
                        "service from Haply and start it"),
              std::string::npos);
    FakeHaply none({});
    EXPECT_NE(haply_error(none.specification()).find("reports no Inverse3; connect the device"),
              std::string::npos);
    FakeHaply two(two_devices);
    EXPECT_NE(haply_error(two.specification() + ",left=049D")
                  .find("no Inverse3 with the identity 049D is connected, only 0A11, 0B22; connect it"),
              std::string::npos);
    two.mode = Mode::other_service;
    EXPECT_NE(haply_error(two.specification())
                  .find("is not what the Inverse service of Haply sends from version 3.1 on; install the "
                        "newest version"),
              std::string::npos);
    FakeHaply mute(one_device);
    mute.mode = Mode::silent;
    EXPECT_NE(haply_error(mute.specification()).find("sends no position that can be used; restart"),
              std::string::npos);
    // Something that listens there and speaks another protocol.
    const int listening = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ASSERT_EQ(listen(listening, 4), 0);
    getsockname(listening, reinterpret_cast<sockaddr*>(&address), &size);
    std::atomic<bool> stop{false};
    std::thread other([&] {
        while (!stop) {
            pollfd one{listening, POLLIN, 0};
            if (poll(&one, 1, 10) <= 0) continue;
            const int client = accept(listening, nullptr, nullptr);
            const std::string words = "220 mail.example.org\r\n\r\n";
            send(client, words.data(), words.size(), MSG_NOSIGNAL);
            poll(nullptr, 0, 50);
            close(client);
        }
    });
    EXPECT_NE(haply_error("haply:" + std::to_string(ntohs(address.sin_port)))
                  .find("what answers there is not the Inverse service of Haply; end the program"),
              std::string::npos);
    stop = true;
    other.join();
    close(listening);
}

TEST(HaplyOfService, OneOfTwoCanBeNamedAndBothOfOneSideAreSharedOut) {
    FakeHaply haply({{"A", "right"}, {"B", "right"}});
    const auto hands = [&](const std::string& more) {
        DaemonClient client(test::hapticd_program(), haply.specification() + more);
        return std::pair(client.facts().slot[0], client.facts().slot[1]);
    };
    EXPECT_EQ(hands(""), std::pair(true, true));
    EXPECT_EQ(hands(",left=B"), std::pair(true, false));
    haply.move(1, Vector3(0.09, 0, 0));
    DaemonClient client(test::hapticd_program(), haply.specification() + ",left=B");
    EXPECT_TRUE(until([&] { return haply_pose(client, 0).position[0] == 0.09; }));
}

}  // namespace
}  // namespace fulcrum
