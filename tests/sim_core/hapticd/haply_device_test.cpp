// SPDX-License-Identifier: Apache-2.0
// Haply Inverse3 and VerseGrip through their real entry: fulcrum-hapticd connects to a service in the test.
#include "sim_core/hapticd/haply_device.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/numerics/input_error.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/built.h"
#include "tests/support/fake_haply.h"
#include "tests/support/process_rights.h"

namespace fulcrum {
namespace {

using hapticd::haply_specification;
using test::FakeHaply;
using test::says;
using test::until;
using Mode = FakeHaply::Mode;
using Form = FakeHaply::Form;

const std::vector<FakeHaply::Device> one_device = {{"049D", "right"}};
const std::vector<FakeHaply::Device> two_devices = {{"0A11", "right"}, {"0B22", "left"}};

constexpr std::int64_t haply_limit = 50'000'000;  // ns

/// Looks every half millisecond, for so long.
template <typename Condition>
bool until_ms(int milliseconds, Condition&& holds) {
    const std::int64_t last = monotonic_ns() + milliseconds * 1'000'000LL;
    while (monotonic_ns() < last) {
        if (holds()) return true;
        usleep(500);
    }
    return false;
}

DevicePose haply_pose(const DaemonClient& client, int hand) {
    DevicePose newest;
    client.state().pose[hand].read(newest);
    return newest;
}
bool haply_present(const DaemonClient& client, int hand) {
    return haply_pose(client, hand).present == 1;
}

/// Sends forces to the hands as an attempt does, until the condition holds.
class HaplyPush {
  public:
    /// Each hand has a force of its own.
    template <typename Condition>
    bool until_each_holds(DaemonClient& client, const Vector3& left, const Vector3& right,
                          Condition&& holds) {
        return until([&] {
            ++command_.sequence;
            command_.time = monotonic_ns();
            for (int h = 0; h < 2; ++h) {
                for (int axis = 0; axis < 3; ++axis) command_.force[axis] = (h == 0 ? left : right)[axis];
                client.command().command[h].write(command_);
            }
            return holds();
        });
    }
    template <typename Condition>
    bool until_holds(DaemonClient& client, const Vector3& wanted, Condition&& holds) {
        return until_each_holds(client, wanted, wanted, holds);
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
    // Device frame. A force of its own for each hand: the first device is the right one.
    const Vector3 of_left(0.3, 0.5, -0.7), of_right(-0.2, 0.1, 0.6);
    EXPECT_TRUE(push.until_each_holds(client, of_left, of_right,
                                      [&] {
                                          return (haply.force(1) - Vector3(0.3, 0.7, 0.5)).norm() < 1e-9 &&
                                                 (haply.force(0) - Vector3(-0.2, -0.6, 0.1)).norm() < 1e-9;
                                      }))
        << "right device " << haply.force(0).transpose() << ", left device " << haply.force(1).transpose();
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

TEST(HaplyThroughTheDaemon, AFaultThatPassesStopsForceAndHandAndSaysWhatToDo) {
    FakeHaply haply(one_device);
    DaemonClient client(test::hapticd_program(), haply.specification());
    HaplyPush push;
    const Vector3 wanted(0, 0.5, 0);
    const auto works = [&] {
        client.poll();
        return haply_present(client, 1) && haply.force(0).z() == 0.5 && client.message().empty();
    };
    const auto expect_fault = [&](DeviceFault fault, const char* what, std::int64_t begin) {
        EXPECT_TRUE(push.until_holds(client, wanted, [&] {
            return haply.force(0) == Vector3::Zero() && !haply_present(client, 1);
        })) << what;
        EXPECT_LE(monotonic_ns() - begin, haply_limit) << what;
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
        const std::int64_t begin = monotonic_ns();
        haply.mode = one.mode;
        expect_fault(one.fault, std::to_string(static_cast<int>(one.mode)).c_str(), begin);
        haply.mode = Mode::good;
        EXPECT_TRUE(push.until_holds(client, wanted, works)) << client.message().words();
    }
    EXPECT_TRUE(test::is_filtered(client.device_process())) << "while both connections are open";
    haply.event("device-battery-low", "049D");
    haply.event("device-safety-triggered", "0000");
    EXPECT_FALSE(until_ms(100, [&] { return !haply_present(client, 1); })) << "another device";
    ASSERT_TRUE(push.until_holds(client, wanted, works));
    const std::int64_t begin = monotonic_ns();
    haply.event("device-safety-triggered", "049D", "ebrake_triggered");
    expect_fault(DeviceFault::safety_brake, "brake", begin);
    EXPECT_EQ(client.device_process(), process) << "none of these opens it again";
    EXPECT_EQ(haply.early(), 0) << "never two commands without an answer";
}

TEST(HaplyThroughTheDaemon, EachReasonOfASafetyEventAndADisconnectionStopForceAndHand) {
    FakeHaply haply(one_device);
    for (const char* const reason : {"stall_detected", "stability_ceiling", ""}) {
        DaemonClient client(test::hapticd_program(), haply.specification());
        HaplyPush push;
        const Vector3 wanted(0, 0.5, 0);
        ASSERT_TRUE(push.until_holds(client, wanted, [&] {
            return haply_present(client, 1) && haply.force(0).z() == 0.5;
        })) << reason;
        const bool gone = *reason == '\0';
        const std::int64_t begin = monotonic_ns();
        haply.event(gone ? "device-disconnected" : "device-safety-triggered", "049D", reason);
        ASSERT_TRUE(push.until_holds(client, wanted, [&] {
            return haply.force(0) == Vector3::Zero() && !haply_present(client, 1);
        })) << reason;
        EXPECT_LE(monotonic_ns() - begin, haply_limit) << reason;
        EXPECT_TRUE(says(client, words_of(gone ? DeviceFault::no_answer : DeviceFault::safety_brake)))
            << client.message().words();
        if (!gone) continue;
        const auto process = client.device_process();
        EXPECT_TRUE(push.until_holds(client, wanted, [&] {
            client.poll();
            return client.device_process() != process && haply_present(client, 1) &&
                   haply.force(0).z() == 0.5;
        })) << "connected again";
    }
    EXPECT_EQ(haply.early(), 0);
}

TEST(HaplyThroughTheDaemon, ASlowServiceIsUsedAndNeverGetsTwoCommands) {
    FakeHaply haply(one_device);
    DaemonClient client(test::hapticd_program(), haply.specification());
    HaplyPush push;
    const Vector3 wanted(0, 0.5, 0);
    haply.mode = Mode::slow;
    ASSERT_TRUE(push.until_holds(client, wanted, [&] { return haply.force(0).z() == 0.5; }));
    const std::uint64_t before = haply.commands;
    const auto process = client.device_process();
    // Seen while commands come: a test that is kept waiting sends none, and the force ends.
    ASSERT_TRUE(push.until_holds(client, wanted, [&] {
        return haply.commands > before + 20 && haply_present(client, 1) && haply.force(0).z() == 0.5;
    }));
    client.poll();
    EXPECT_EQ(client.device_process(), process);
    EXPECT_EQ(haply.early(), 0);
    // A service that falls further and further behind is not: the hand stays absent, so an attempt pauses.
    haply.mode = Mode::falling_behind;
    EXPECT_TRUE(push.until_holds(client, wanted, [&] {
        client.poll();
        return !haply_present(client, 1) && haply.force(0) == Vector3::Zero() &&
               client.message().words() == words_of(DeviceFault::haply_silent);
    })) << client.message().words();
    // From the second silence on, although every answer comes after all.
    const std::uint64_t answers = haply.commands;
    ASSERT_TRUE(push.until_holds(client, wanted, [&] { return haply.commands > answers + 1; }));
    const std::uint64_t counted = haply.commands;
    bool came = false, pushed = false;
    push.until_holds(client, wanted, [&] {
        came = came || haply_present(client, 1);
        pushed = pushed || haply.force(0) != Vector3::Zero();
        return haply.commands > counted + 4;
    });
    EXPECT_FALSE(came || pushed);
    EXPECT_EQ(haply.early(), 0);
    haply.mode = Mode::good;
    EXPECT_TRUE(push.until_holds(client, wanted, [&] {
        client.poll();
        return haply_present(client, 1) && haply.force(0).z() == 0.5;
    })) << client.message().words();
}

TEST(HaplyOfService, TheFakeSeesASecondCommandThatDoesNotWait) {
    FakeHaply haply(one_device);
    haply.mode = Mode::slow;
    haply::WebSocket hasty(haply.port());
    ASSERT_TRUE(until([&] {
        hasty.serve(1'000'000);
        return hasty.state() == haply::WebSocket::State::open;
    }));
    const std::string command = haply::force_command({{"049D", Vector3(0, 0, 0)}}, haply::ForceForm::vector);
    EXPECT_TRUE(until([&] {
        hasty.send(command);
        hasty.serve(1'000'000);
        return haply.early() > 0;
    }));
}

TEST(HaplyThroughTheDaemon, ForceIsZeroAfterTheProgramOrTheDeviceProcessDies) {
    FakeHaply haply(one_device);
    const auto push_for_ever = [&](int control) {
        DaemonClient client(test::hapticd_program(), haply.specification());
        const pid_t device = client.device_process();
        if (write(control, &device, sizeof device) != sizeof device) _exit(1);
        HaplyPush push;
        push.until_holds(client, Vector3(0, 0.5, 0), [] { return false; });
        _exit(0);
    };
    for (const bool of_device : {false, true}) {
        for (const int number : {SIGKILL, SIGSTOP}) {
            int ends[2];
            ASSERT_EQ(pipe(ends), 0);
            const pid_t child = fork();
            if (child == 0) push_for_ever(ends[1]);
            pid_t device = 0;
            ASSERT_EQ(read(ends[0], &device, sizeof device), static_cast<ssize_t>(sizeof device));
            close(ends[0]);
            close(ends[1]);
            ASSERT_TRUE(until([&] { return haply.force(0).z() == 0.5; })) << of_device << number;
            const std::int64_t begin = monotonic_ns();
            kill(of_device ? device : child, number);
            // Without its client the service's motors stop; with it, a command says so.
            ASSERT_TRUE(
                until([&] { return (of_device ? haply.rendered(0) : haply.force(0)) == Vector3::Zero(); }));
            EXPECT_LE(monotonic_ns() - begin, haply_limit) << of_device << strsignal(number);
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
            EXPECT_TRUE(until([&] { return haply.clients() == 0; })) << "nothing is left";
        }
    }
}

TEST(HaplyDevice, ThePortAfterTheFirstIsUsedWhereNobodyOrAnotherProgramAnswersThere) {
    FakeHaply haply(one_device);
    FakeHaply other(std::vector<FakeHaply::Device>{{"0C33", "right"}});
    int closed = 0;
    {
        const FakeHaply ended(one_device);
        closed = ended.port();
    }
    const auto place = [](const std::vector<int>& ports) {
        hapticd::HaplySpecification wanted = haply_specification("haply:events=0");
        wanted.ports = ports;
        hapticd::HaplyDevice device(wanted);
        device.open();
        DevicePose poses[device_slots];
        EXPECT_TRUE(until([&] {
            device.read(monotonic_ns(), poses);
            return poses[1].present == 1;
        }));
        device.close();
        return poses[1].position[0];
    };
    haply.move(0, Vector3(0.02, 0, 0.1));
    other.move(0, Vector3(0.05, 0, 0.1));
    EXPECT_EQ(place({haply.port(), other.port()}), 0.02) << "the first one where both answer";
    EXPECT_EQ(place({closed, other.port()}), 0.05);
    // Something that takes the connection and speaks another protocol.
    const int listening = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ASSERT_EQ(listen(listening, 4), 0);
    getsockname(listening, reinterpret_cast<sockaddr*>(&address), &size);
    std::atomic<bool> stop{false};
    std::thread closes([&] {
        while (!stop) {
            pollfd one{listening, POLLIN, 0};
            if (poll(&one, 1, 10) > 0) close(accept(listening, nullptr, nullptr));
        }
    });
    EXPECT_EQ(place({ntohs(address.sin_port), haply.port()}), 0.02);
    stop = true;
    closes.join();
    close(listening);
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
