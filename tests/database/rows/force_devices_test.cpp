// SPDX-License-Identifier: GPL-3.0-or-later
// Devices with force as a text of the store.
#include "database/rows/force_devices.h"

#include <gtest/gtest.h>

#include <limits>

#include "database/rows/errors.h"

namespace fulcrum::database {
namespace {

TEST(ForceDevices, AreReadBackAsTheyWereWritten) {
    ForceDevices devices;
    EXPECT_EQ(force_devices_text(devices), "");
    ForceOutput output;
    output.damping = 1.0 / 3;
    output.peak = 3.3;
    output.continuous = 0.88;
    output.stiffness = 1260;
    output.torque = 0.029;
    output.scale = 0.4;
    devices[1] = output;
    const std::string text = force_devices_text(devices);
    const ForceDevices again = force_devices_of(text, "here");
    EXPECT_FALSE(again[0].has_value());
    ASSERT_TRUE(again[1].has_value());
    EXPECT_EQ(again[1]->damping, output.damping) << "to the last bit: a replay sends the same forces";
    EXPECT_EQ(again[1]->peak, output.peak);
    EXPECT_EQ(again[1]->continuous, output.continuous);
    EXPECT_EQ(again[1]->stiffness, output.stiffness);
    EXPECT_EQ(again[1]->torque, output.torque);
    EXPECT_EQ(again[1]->scale, output.scale);
    EXPECT_EQ(again[1]->slew, std::numeric_limits<double>::infinity()) << "that of the scene";
    EXPECT_EQ(text.find("slew"), std::string::npos) << "as older attempts have it";
    EXPECT_EQ(force_devices_text(again), text);
}

TEST(ForceDevices, ASlewLimitOfTheDeviceIsReadBackAndChecked) {
    ForceDevices devices;
    devices[0].emplace();
    devices[0]->slew = 1000.0 / 7;
    const std::string text = force_devices_text(devices);
    const ForceDevices again = force_devices_of(text, "here");
    ASSERT_TRUE(again[0].has_value());
    EXPECT_EQ(again[0]->slew, devices[0]->slew);
    EXPECT_EQ(force_devices_text(again), text);
    const std::string name = "\"slew_n_s\":";
    const std::size_t value = text.find(name) + name.size();
    const std::size_t size = text.find_first_of(",}", value) - value;
    for (const char* wrong : {"0", "-1", "null", "\"150\""})
        EXPECT_THROW(force_devices_of(std::string(text).replace(value, size, wrong), "here"), StoreError)
            << wrong;
}

TEST(ForceDevices, UseAndRateAreInTheSameTextAndMayBeAbsent) {
    EXPECT_FALSE(rig_use_of("", "here").has_value());
    const std::string older = R"({"left":{"continuous_n":1,"damping_n_s_m":1,"peak_n":3,"scale":1,)"
                              R"("stiffness_n_m":1000,"torque_n_m":0}})";
    EXPECT_FALSE(rig_use_of(older, "here").has_value()) << "a store from before has no use";
    RigUse use;
    use.stated = 1000;
    use.measured = 2998.0 / 3;
    use.motion = 0.75;
    use.part = {-1, 1, 2};
    use.pedal = 1;
    const std::string text = force_devices_text(force_devices_of(older, "here"), use);
    EXPECT_TRUE(force_devices_of(text, "here")[0].has_value());
    const std::optional<RigUse> again = rig_use_of(text, "here");
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->measured, use.measured);
    EXPECT_EQ(again->motion, 0.75);
    EXPECT_EQ(again->part, use.part);
    EXPECT_EQ(again->pedal, 1);
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"motion\":0.75", "\"motion\":0"},
                                   {"\"pedal\":1", "\"pedal\":3"},
                                   {"\"scope\":2", "\"scope\":1e300"},
                                   {"\"stated_hz\":1000", "\"stated_hz\":-1"},
                                   {"\"stated_hz\":1000", "\"stated_hz\":null"}}) {
        std::string damaged = text;
        ASSERT_NE(damaged.find(from), std::string::npos) << from;
        EXPECT_THROW(rig_use_of(damaged.replace(damaged.find(from), from.size(), to), "here"), StoreError)
            << damaged;
    }
}

TEST(ForceDevices, RefuseATextThatIsDamaged) {
    const std::string whole = R"({"left":{"continuous_n":1,"damping_n_s_m":1,"peak_n":3,"scale":1,)"
                              R"("stiffness_n_m":1000,"torque_n_m":0}})";
    EXPECT_TRUE(force_devices_of(whole, "here")[0].has_value());
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = whole;
        return text.replace(text.find(from), from.size(), to);
    };
    for (const std::string& text :
         {std::string("[]"), std::string("{"), changed("left", "foot"),
          changed("\"scale\":1", "\"scale\":\"1\""), changed("\"scale\":1", "\"scale\":0"),
          changed("\"peak_n\":3", "\"peak_n\":0.5"), changed("\"damping_n_s_m\":1", "\"damping_n_s_m\":-1")})
        EXPECT_THROW(force_devices_of(text, "here"), StoreError) << text;
}

}  // namespace
}  // namespace fulcrum::database
