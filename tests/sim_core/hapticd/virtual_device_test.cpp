// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/virtual_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"

namespace fulcrum::hapticd {
namespace {

constexpr std::int64_t ms = 1'000'000;

class VirtualDeviceTest : public ::testing::Test {
  protected:
    VirtualDevice device(const std::string& text) {
        std::ofstream(script) << text;
        return VirtualDevice(read_device_script(script));
    }
    test::OwnFolder folder;
    std::string script = (folder / "script.json").string();
};

TEST_F(VirtualDeviceTest, FollowsThePathInStraightLines) {
    auto made = device(R"({"format": "fulcrum-device-script", "repeat": true, "right": {"path": [
        {"t": 0, "position": [0, 0, 0], "jaw": 1}, {"t": 1, "position": [0.1, 0, 0], "jaw": 0, "buttons": 4},
        {"t": 2, "position": [0, 0, 0]}]}})");
    DevicePose poses[device_slots];
    made.read(1000 * ms, poses);
    EXPECT_EQ(poses[1].position[0], 0);
    EXPECT_EQ(poses[0].present, 0U);
    EXPECT_EQ(poses[1].present, 1U);
    made.read(1500 * ms, poses);
    EXPECT_NEAR(poses[1].position[0], 0.05, 1e-12);
    EXPECT_NEAR(poses[1].jaw, 0.5, 1e-12);
    EXPECT_EQ(poses[1].sequence, 2U);
    made.read(2250 * ms, poses);
    EXPECT_EQ(poses[1].buttons, 4U);
    made.read(3250 * ms, poses);  // again
    EXPECT_NEAR(poses[1].position[0], 0.025, 1e-12);
}

TEST_F(VirtualDeviceTest, ASimulatedHandYieldsToTheForceAndComesBack) {
    auto made = device(R"({"format": "fulcrum-device-script", "force": {"peak": 3.3},
        "left": {"path": [{"t": 0}], "hand": {"mass": 0.2, "arm_stiffness": 300, "arm_damping": 10}}})");
    ASSERT_TRUE(made.facts().force[0].has_value());
    EXPECT_FALSE(made.facts().force[1].has_value());
    DevicePose poses[device_slots];
    std::int64_t now = 1000 * ms;
    const auto run = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) made.read(now += ms, poses);
    };
    made.render(0, Vector3(0, 0, 1.5), 0);
    run(2000);
    EXPECT_NEAR(poses[0].position[2], 1.5 / 300, 1e-5);
    made.render(0, Vector3::Zero(), 0);
    run(2000);
    EXPECT_NEAR(poses[0].position[2], 0, 1e-5);
}

TEST_F(VirtualDeviceTest, FaultsBeginAndEndWhenTheScriptSaysSo) {
    auto made = device(R"({"format": "fulcrum-device-script", "left": {"path": [{"t": 0}]}, "faults": [
        {"t": 1, "for": 0.5, "kind": "silence"}, {"t": 2, "for": 0.5, "kind": "not_a_number"},
        {"t": 3, "for": 0.5, "kind": "jump"}]})");
    DevicePose poses[device_slots];
    made.read(10'000 * ms, poses);
    EXPECT_EQ(poses[0].present, 1U);
    made.read(11'100 * ms, poses);
    EXPECT_EQ(poses[0].present, 0U);
    made.read(12'100 * ms, poses);
    EXPECT_TRUE(std::isnan(poses[0].position[0]));
    made.read(13'100 * ms, poses);
    EXPECT_EQ(poses[0].position[0], 1);
    made.read(14'000 * ms, poses);
    EXPECT_EQ(poses[0].position[0], 0);
    EXPECT_EQ(poses[0].present, 1U);
}

TEST_F(VirtualDeviceTest, AFaultCanWaitForTheFirstForce) {
    auto made = device(R"({"format": "fulcrum-device-script", "force": {}, "left": {"path": [{"t": 0}]},
        "faults": [{"t": 1, "for": 0.5, "kind": "silence", "after_force": true}]})");
    DevicePose poses[device_slots];
    const auto present_at = [&](int milliseconds) {
        made.read(milliseconds * ms, poses);
        return poses[0].present == 1;
    };
    EXPECT_TRUE(present_at(10'000));
    EXPECT_TRUE(present_at(11'200)) << "whatever the time";
    made.render(0, Vector3(0, 0.1, 0), 0);
    EXPECT_TRUE(present_at(20'000));
    made.render(0, Vector3::Zero(), 0);
    EXPECT_FALSE(present_at(21'200)) << "a second after the first force";
    EXPECT_TRUE(present_at(21'600));
    EXPECT_THROW(device(R"({"format": "fulcrum-device-script", "left": {"path": [{"t": 0}]},
        "faults": [{"kind": "silence", "after_force": 1}]})"),
                 InputError);
}

TEST_F(VirtualDeviceTest, ReplaysARecording) {
    std::ofstream((folder / "hands.csv").string()) << "t,slot,x,y,z,roll,jaw,buttons\n0,left,0,0,0,0,1,0\n"
                                                      "0,scope,0,0,0,0,1,0\n1,left,0.01,0,-0.02,0.5,0,1\n";
    auto made = device(R"({"format": "fulcrum-device-script", "recording": "hands.csv"})");
    EXPECT_TRUE(made.facts().slot[0]);
    EXPECT_FALSE(made.facts().slot[1]);
    EXPECT_TRUE(made.facts().slot[scope_slot]);
    DevicePose poses[device_slots];
    made.read(1000 * ms, poses);
    made.read(1500 * ms, poses);
    EXPECT_NEAR(poses[0].position[0], 0.005, 1e-12);
    EXPECT_NEAR(poses[0].position[2], -0.01, 1e-12);
    EXPECT_NEAR(poses[0].roll, 0.25, 1e-12);
}

TEST_F(VirtualDeviceTest, ARecordingWithAWrongRowIsRefusedWithItsRow) {
    for (const char* const row : {"1,left,0,0", "x,left,0,0,0,0,1,0", "1,middle,0,0,0,0,1,0",
                                  "0,left,0,0,0,0,1,0", "1,left,nan,0,0,0,1,0", "1,left,5,0,0,0,1,0"}) {
        std::ofstream((folder / "hands.csv").string())
            << "t,slot,x,y,z,roll,jaw,buttons\n0,left,0,0,0,0,1,0\n"
            << row << '\n';
        try {
            device(R"({"format": "fulcrum-device-script", "recording": "hands.csv"})");
            ADD_FAILURE() << row;
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), "3") << error.what();
        }
    }
}

}  // namespace
}  // namespace fulcrum::hapticd
