// SPDX-License-Identifier: Apache-2.0
// Tracked instruments through their real entry: fulcrum-hapticd connects to a server in the test.
#include "sim_core/hapticd/igtl_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/numerics/input_error.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/allocation_count.h"
#include "tests/support/built.h"
#include "tests/support/fake_tracker.h"
#include "tests/support/openigtlink_peer.h"
#include "tests/support/process_rights.h"

namespace fulcrum {
namespace {

using hapticd::handle_of;
using hapticd::igtl_specification;
using test::FakeTracker;
using test::until;
using Mode = FakeTracker::Mode;

const std::vector<std::string> two_tools = {"LeftTipToPatient", "RightTipToPatient"};

DevicePose tracked_pose(const DaemonClient& client, int slot) {
    DevicePose newest;
    client.state().pose[slot].read(newest);
    return newest;
}
bool tracked_present(const DaemonClient& client, int slot) {
    return tracked_pose(client, slot).present == 1;
}
std::string opening_error(const std::string& specification) {
    try {
        DaemonClient client(test::hapticd_program(), specification);
    } catch (const InputError& error) {
        return error.what();
    }
    return "opened";
}

TEST(IgtlSpecification, NamesLengthsAndAxesAreRead) {
    const auto plain = igtl_specification("openigtlink");
    EXPECT_EQ(plain.address.text(), "127.0.0.1:18944");
    EXPECT_EQ(plain.tool[1], "RightTipToPatient");
    EXPECT_FALSE(plain.named[1]);
    const auto full =
        igtl_specification("openigtlink:tracker.local:1234,right=Probe,length=0,shaft=-z,axes=+y+z+x");
    EXPECT_EQ(full.address.text(), "tracker.local:1234");
    EXPECT_EQ(full.tool[0], "") << "not looked for where others are named";
    EXPECT_EQ(full.tool[1], "Probe");
    EXPECT_EQ(full.length, 0);
    EXPECT_EQ(full.shaft, -Vector3::UnitZ());
    EXPECT_EQ(full.axes * Vector3(1, 2, 3), Vector3(2, 3, 1));
    EXPECT_EQ(igtl_specification("openigtlink:left=A").address.text(), "127.0.0.1:18944");
    EXPECT_EQ(igtl_specification("openigtlink:[::1]:99").address.text(), "[::1]:99");
    for (const char* wrong :
         {"openigtlink:a:0", "openigtlink:a:70000", "openigtlink:a:x",
          "openigtlink:a,left=", "openigtlink:a,middle=B", "openigtlink:a,length=-3",
          "openigtlink:a,length=1e3", "openigtlink:a,shaft=z", "openigtlink:a,axes=+x+y-z",
          "openigtlink:a,axes=+x+x+z", "openigtlink:a b", "openigtlink:a,left=ANameOfMoreThanTwentyBytes",
          "openigtlink:a,", "openigtlink:a,,left=B"}) {
        if (std::string(wrong) == "openigtlink:a,") {
            EXPECT_NO_THROW(igtl_specification(wrong));
            continue;
        }
        EXPECT_THROW(igtl_specification(wrong), InputError) << wrong;
    }
}

TEST(IgtlSpecification, TheHandleIsALengthBackAlongTheShaftAndTurnsWithTheRoll) {
    auto wanted = igtl_specification("openigtlink:a,length=300");
    igtl::Pose pose;
    pose.place = Vector3(0.1, 0.2, 0.3);
    const Vector3 axis = Vector3(0.2, -0.5, -0.8).normalized();
    const Quaternion lean = Quaternion::FromTwoVectors(Vector3::UnitZ(), axis);
    double before = 0;
    for (const double turn : {0.0, 0.4, -1.1}) {
        pose.rotation = (lean * Quaternion(Eigen::AngleAxisd(turn, Vector3::UnitZ()))).toRotationMatrix();
        const auto handle = handle_of(pose, wanted);
        EXPECT_LT((handle.position - (pose.place - 0.3 * axis)).norm(), 1e-12);
        if (turn == 0.0) before = handle.roll;
        EXPECT_NEAR(handle.roll - before, turn, 1e-9) << "positive about the direction to the tip";
    }
    // Another axis of the tracker points up: the same movement, seen in the device's frame.
    wanted = igtl_specification("openigtlink:a,length=0,axes=-x+z+y");
    EXPECT_EQ(handle_of(pose, wanted).position, Vector3(-0.1, 0.3, 0.2));
    // A tool whose -x points to the tip.
    wanted = igtl_specification("openigtlink:a,length=300,shaft=-x");
    pose.rotation = Matrix3::Identity();
    EXPECT_LT((handle_of(pose, wanted).position - Vector3(0.4, 0.2, 0.3)).norm(), 1e-12);
}

TEST(IgtlTracker, PosesJawsAndButtonsArriveFromEachKindOfMessage) {
    FakeTracker tracker(two_tools);
    igtl::Bytes image_and_jaw;
    const double jaw[] = {0.25, 4};
    igtl::append_sensor(image_and_jaw, "RightJaw", 0, jaw, 2, 0);
    tracker.also_send(image_and_jaw);
    DaemonClient client(test::hapticd_program(), "openigtlink:" + tracker.address() + ",left=" +
                                                     two_tools[0] + ",right=" + two_tools[1] + ",length=0");
    EXPECT_EQ(client.facts().kind, "openigtlink");
    EXPECT_TRUE(client.facts().slot[0] && client.facts().slot[1]);
    EXPECT_FALSE(client.facts().slot[scope_slot]);
    EXPECT_FALSE(client.facts().force[0] || client.facts().force[1]);
    double x = 0.01;
    for (const Mode mode : {Mode::good, Mode::tdata, Mode::position, Mode::image}) {
        tracker.mode = mode;
        igtl::Pose pose;
        pose.place = Vector3(x += 0.01, -0.02, 0.03);
        tracker.move(1, pose);
        EXPECT_TRUE(until([&] {
            const DevicePose now = tracked_pose(client, 1);
            return now.present == 1 && std::abs(now.position[0] - x) < 1e-7;
        })) << static_cast<int>(mode);
        EXPECT_NEAR(tracked_pose(client, 1).position[2], 0.03, 1e-6);
        EXPECT_TRUE(until([&] { return tracked_present(client, 0); }));
    }
    EXPECT_EQ(tracked_pose(client, 1).jaw, 0.25);
    EXPECT_EQ(tracked_pose(client, 1).buttons, std::uint32_t{button_energy});
    EXPECT_EQ(tracked_pose(client, 0).jaw, 1);
    EXPECT_TRUE(until([&] {
        client.poll();
        return client.message().empty();
    }));
}

/// Adds the words with which the peer sends a tool at this pose.
void add_tool(std::vector<std::string>& words, const std::string& name, const igtl::Pose& pose) {
    const Quaternion q(pose.rotation);
    words.insert(words.end(), {"tool", name});
    for (const double value :
         {1e3 * pose.place.x(), 1e3 * pose.place.y(), 1e3 * pose.place.z(), q.x(), q.y(), q.z(), q.w()}) {
        std::ostringstream text;
        text.precision(12);
        text << value;
        words.push_back(text.str());
    }
}
/// The next line of this type that the peer prints; null after 8 s without one.
nlohmann::json printed_by(test::OpenIgtlinkPeer& peer, const std::string& type) {
    nlohmann::json found;
    until([&] {
        for (const std::string& line : peer.lines(50)) {
            const nlohmann::json fields = nlohmann::json::parse(line, nullptr, false);
            EXPECT_NE(fields.value("type", ""), "error") << line;
            if (found.is_null() && fields.value("type", "") == type) found = fields;
        }
        return !found.is_null();
    });
    return found;
}

TEST(IgtlTracker, WhatTheProtocolsOwnLibrarySendsMovesTheHandsAsItWasSent) {
    if (!test::OpenIgtlinkPeer::built()) GTEST_SKIP() << test::OpenIgtlinkPeer::not_built;
    constexpr double whole_turn = 2 * 3.14159265358979323846;
    // Lean and turn of each are such that rows and columns, or the order of a quaternion, cannot be mistaken.
    igtl::Pose poses[2];
    for (int slot = 0; slot < 2; ++slot) {
        const Vector3 axis = Vector3(0.2 - 0.5 * slot, -0.5, -0.8).normalized();
        const Quaternion lean = Quaternion::FromTwoVectors(Vector3::UnitZ(), axis);
        const Quaternion turn(Eigen::AngleAxisd(0.7 - 1.5 * slot, Vector3::UnitZ()));
        poses[slot].rotation = (lean * turn).toRotationMatrix();
        poses[slot].place = Vector3(0.0125, -0.034 - 0.01 * slot, 0.0615);
    }
    const auto wanted = igtl_specification("openigtlink:a,length=300");
    for (const char* const version : {"1", "2"})
        for (const char* const kind : {"transform", "position", "tdata", "asked"}) {
            SCOPED_TRACE(std::string(kind) + ", header version " + version);
            std::vector<std::string> words = {"serve", kind, version, "30"};
            for (std::size_t slot = 0; slot < 2; ++slot) add_tool(words, two_tools[slot], poses[slot]);
            words.insert(words.end(), {"sensor", "RightJaw", "0.25", "4"});
            test::OpenIgtlinkPeer peer(words);
            const nlohmann::json listening = printed_by(peer, "port");
            ASSERT_FALSE(listening.is_null());
            const DaemonClient client(
                test::hapticd_program(),
                "openigtlink:127.0.0.1:" + std::to_string(listening["port"].get<int>()) +
                    ",left=" + two_tools[0] + ",right=" + two_tools[1] + ",length=300");
            for (int slot = 0; slot < 2; ++slot) {
                const hapticd::TrackedHandle handle = handle_of(poses[slot], wanted);
                EXPECT_TRUE(until([&] { return tracked_present(client, slot); })) << slot;
                const DevicePose now = tracked_pose(client, slot);
                for (int axis = 0; axis < 3; ++axis)
                    EXPECT_NEAR(now.position[axis], handle.position[axis], 1e-6) << slot << ' ' << axis;
                EXPECT_NEAR(std::remainder(now.roll - handle.roll, whole_turn), 0, 1e-5) << slot;
            }
            EXPECT_TRUE(until([&] { return tracked_pose(client, 1).jaw == 0.25; }));
            EXPECT_EQ(tracked_pose(client, 1).buttons, std::uint32_t{button_energy});
            EXPECT_EQ(tracked_pose(client, 0).jaw, 1);
            if (std::string(kind) != "asked") continue;
            const nlohmann::json request = printed_by(peer, "STT_TDATA");
            ASSERT_FALSE(request.is_null()) << "the library read what the device process asks";
            EXPECT_EQ(request["resolution"], 10);
        }
}

TEST(IgtlTracker, AFaultThatPassesMakesTheHandAbsentAndSaysWhatToDo) {
    FakeTracker tracker(two_tools);
    DaemonClient client(test::hapticd_program(), "openigtlink:" + tracker.address());
    struct Case {
        Mode mode;
        DeviceFault fault;
    };
    for (const Case& one :
         {Case{Mode::silent, DeviceFault::no_poses}, Case{Mode::not_a_number, DeviceFault::not_a_pose},
          Case{Mode::not_a_rotation, DeviceFault::not_a_pose},
          Case{Mode::wrong_checksum, DeviceFault::wrong_checksum}}) {
        ASSERT_TRUE(until([&] { return tracked_present(client, 0) && tracked_present(client, 1); }));
        const Vector3 before(tracked_pose(client, 0).position[0], tracked_pose(client, 0).position[1],
                             tracked_pose(client, 0).position[2]);
        tracker.mode = one.mode;
        EXPECT_TRUE(until([&] {
            client.poll();
            return !tracked_present(client, 0) && !tracked_present(client, 1) &&
                   client.message().words() == words_of(one.fault);
        })) << words_of(one.fault)
            << client.message().words();
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(tracked_pose(client, 0).position[axis], before[axis], 1e-9) << "no jump";
        tracker.mode = Mode::good;
        EXPECT_TRUE(until([&] {
            client.poll();
            return tracked_present(client, 0) && client.message().empty();
        }));
    }
    // One tool out of view: its hand alone.
    tracker.hidden = 1;
    EXPECT_TRUE(until([&] {
        FaultReport report;
        return client.state().fault.read(report) && report.hands == 2U && !tracked_present(client, 1) &&
               tracked_present(client, 0);
    }));
}

TEST(IgtlTracker, AServerThatGreetsWithAStatusOfVersion2IsUnderstood) {
    igtl::Bytes greeting;
    igtl::append_status(greeting, "Slicer", 0, {1, 0, "", "ready"}, 2);
    igtl::append_status(greeting, "Tracker", 0, {13, 7, "NotReady", "the camera is warming up"}, 2);
    FakeTracker tracker(two_tools, 0, 100, greeting);
    DaemonClient client(test::hapticd_program(), "openigtlink:" + tracker.address() + ",length=0");
    igtl::Pose pose;
    pose.place = Vector3(0.01, 0.02, 0.03);
    tracker.move(0, pose);
    EXPECT_TRUE(until([&] {
        const DevicePose now = tracked_pose(client, 0);
        return now.present == 1 && std::abs(now.position[0] - 0.01) < 1e-7 && tracked_present(client, 1);
    }));
    client.poll();
    EXPECT_TRUE(client.message().empty()) << client.message().words();
    EXPECT_TRUE(test::is_filtered(client.device_process())) << "while its connection is open";
}

TEST(IgtlTracker, AConnectionThatEndsIsOpenedAgain) {
    auto tracker = std::make_unique<FakeTracker>(two_tools);
    const int port = tracker->port();
    DaemonClient client(test::hapticd_program(), "openigtlink:" + tracker->address());
    ASSERT_TRUE(until([&] { return tracked_present(client, 1); }));
    tracker.reset();
    EXPECT_TRUE(until([&] { return !tracked_present(client, 0) && !tracked_present(client, 1); }));
    EXPECT_TRUE(until([&] {
        client.poll();
        return client.message().words().find("no OpenIGTLink server answers") != std::string::npos;
    })) << client.message().words();
    EXPECT_NE(client.message().words().find("start the server"), std::string::npos);
    EXPECT_NE(client.message().words().find("tried again"), std::string::npos);
    tracker = std::make_unique<FakeTracker>(two_tools, port);
    EXPECT_TRUE(until([&] {
        client.poll();
        return tracked_present(client, 0) && tracked_present(client, 1) && client.message().empty();
    }));
    // What is no OpenIGTLink: the connection is given up, and opened again.
    const auto process = client.device_process();
    tracker->mode = Mode::garbage;
    EXPECT_TRUE(until([&] { return !tracked_present(client, 0); }));
    tracker->mode = Mode::good;
    EXPECT_TRUE(until([&] {
        client.poll();
        return client.device_process() != process && tracked_present(client, 0);
    }));
}

TEST(IgtlTracker, WhatDoesNotOpenSaysWhy) {
    std::string closed;
    {
        FakeTracker gone(two_tools);
        closed = gone.address();
    }
    const std::string refused = opening_error("openigtlink:" + closed);
    EXPECT_NE(refused.find(closed + ": no OpenIGTLink server answers: Connection refused; start the server"),
              std::string::npos)
        << refused;
    FakeTracker others({"Probe", "Stylus"});
    const std::string other = opening_error("openigtlink:" + others.address());
    EXPECT_NE(other.find("sent no pose of LeftTipToPatient, RightTipToPatient, ScopeTipToPatient, only of "
                         "Probe, Stylus; name its tools: openigtlink:" +
                         others.address() + ",left=NAME"),
              std::string::npos)
        << other;
    EXPECT_EQ(opening_error("openigtlink:" + others.address() + ",left=Probe,right=Stylus"), "opened");
    others.mode = Mode::garbage;
    const std::string garbage = opening_error("openigtlink:" + others.address() + ",left=Probe");
    EXPECT_NE(garbage.find("what it sends is not OpenIGTLink; check that this is the port"),
              std::string::npos)
        << garbage;
}

TEST(IgtlDevice, TheLoopAllocatesNothingAndASlowTrackerMovesWithoutSteps) {
    FakeTracker tracker(two_tools, 0, 50);
    hapticd::IgtlDevice device(
        igtl_specification("openigtlink:" + tracker.address() + ",left=" + two_tools[0] + ",length=0"));
    device.open();
    DevicePose poses[device_slots];
    // 1 mm with each frame of the tracker, on a clock of the test: 20 ms between two frames.
    double largest = 0, before = 0;
    std::int64_t now = monotonic_ns();
    std::uint64_t made = 0, moved = 0;
    for (int frame = 0; frame < 8; ++frame) {
        igtl::Pose pose;
        pose.place.x() = 1e-3 * frame;
        tracker.move(0, pose);
        const std::uint64_t sent = tracker.frames;
        ASSERT_TRUE(until([&] { return tracker.frames >= sent + 2; }));
        made += test::allocations_in([&] {
            for (int tick = 0; tick < 20; ++tick) {
                now += 1'000'000;
                device.read(now, poses);
                const double step = std::abs(poses[0].position[0] - before);
                before = poses[0].position[0];
                if (frame > 2) largest = std::max(largest, step);
                if (frame > 2 && step > 0) ++moved;
            }
        });
    }
    EXPECT_EQ(made, 0U);
    EXPECT_GT(moved, 40U);
    EXPECT_LT(largest, 0.3e-3) << "steps of 1 mm are spread over the time between frames";
}

}  // namespace
}  // namespace fulcrum
