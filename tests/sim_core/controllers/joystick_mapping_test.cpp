// SPDX-License-Identifier: Apache-2.0
// The calibration of a joystick as an instrument, and the file that keeps it.
#include "sim_core/controllers/joystick_mapping.h"

#include <gtest/gtest.h>

#include <fstream>

#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

/// A person at a joystick with eight axes, of which the seventh trembles.
struct Person {
    JoystickCalibration calibration;
    JoystickReading reading;
    double now = 0;
    void look() {
        now += 0.02;
        reading.axis[6] = 0.01 * ((static_cast<int>(now * 50)) % 2);
        calibration.see(reading, 8, now);
    }
    void hold_still() {
        for (int i = 0; i < 30; ++i) look();
    }
    void move(int axis, double from, double to) {
        for (int i = 0; i <= 20; ++i) {
            reading.axis[axis] = from + (to - from) * i / 20;
            look();
        }
    }
    /// All the steps: pitch on 3 (down is up), yaw on 0, insertion on 5, roll left out, jaws on 2.
    JoystickPart work() {
        reading.axis[3] = 0.1;
        hold_still();
        EXPECT_TRUE(calibration.next());
        move(3, 0.8, -0.9);
        EXPECT_TRUE(calibration.next());
        reading.axis[3] = 0.1;
        move(0, -1, 1);
        EXPECT_TRUE(calibration.next());
        reading.axis[0] = 0;
        move(5, -0.5, 0.7);
        EXPECT_TRUE(calibration.next());
        EXPECT_TRUE(calibration.can_skip());
        calibration.skip();
        move(2, -1, 1);
        EXPECT_TRUE(calibration.next());
        EXPECT_TRUE(calibration.done());
        return calibration.part();
    }
};

double value(const JoystickPart& part, JoystickMotion motion, double reading) {
    JoystickReading now;
    for (double& axis : now.axis) axis = reading;
    return part.motion[static_cast<int>(motion)].value(now);
}

TEST(JoystickCalibration, FindsTheAxisItsEndsAndItsDirectionOfEachMotion) {
    Person person;
    const JoystickPart part = person.work();
    ASSERT_TRUE(part.used());
    const int axes[] = {3, 0, 5, -1, 2};
    for (int m = 0; m < joystick_motions; ++m) EXPECT_EQ(part.motion[m].axis, axes[m]) << m;
    constexpr double eighth = 0.7853981633974483;
    EXPECT_NEAR(value(part, JoystickMotion::pitch, 0.1), 0, 1e-12) << "where it was held straight";
    EXPECT_NEAR(value(part, JoystickMotion::pitch, -0.9), eighth, 1e-12) << "the tip up, where it stopped";
    EXPECT_NEAR(value(part, JoystickMotion::pitch, 0.8), -eighth, 1e-12);
    EXPECT_NEAR(value(part, JoystickMotion::pitch, 1), -eighth, 1e-12) << "beyond its end it stays there";
    EXPECT_NEAR(value(part, JoystickMotion::yaw, -0.5), -0.5 * eighth, 1e-12);
    EXPECT_NEAR(value(part, JoystickMotion::insertion, -0.5), 0, 1e-12);
    EXPECT_NEAR(value(part, JoystickMotion::insertion, 0.1), 0.1, 1e-9) << "half way of 0.2 m";
    EXPECT_NEAR(value(part, JoystickMotion::insertion, 0.7), 0.2, 1e-12);
    EXPECT_EQ(value(part, JoystickMotion::roll, 0.4), 0) << "left out";
    EXPECT_NEAR(value(part, JoystickMotion::jaw, 0), 0.5, 1e-9);
    EXPECT_EQ(part.jaws, -1) << "an axis does it";
    EXPECT_EQ(part.energy, 0);
    EXPECT_EQ(part.clutch, 2);
}

TEST(JoystickCalibration, AStepEndsOnlyWhereWhatItAsksForWasSeen) {
    Person person;
    EXPECT_FALSE(person.calibration.next()) << "nothing was read";
    person.look();
    EXPECT_FALSE(person.calibration.next()) << "half a second of stillness";
    person.move(1, 0, 1);
    person.look();
    EXPECT_FALSE(person.calibration.next()) << "it moved";
    person.hold_still();
    EXPECT_TRUE(person.calibration.next());
    person.move(3, 0, 0.3);
    EXPECT_FALSE(person.calibration.next()) << "too little";
    person.move(3, -0.8, 0.9);
    person.move(3, 0.9, 0);
    EXPECT_FALSE(person.calibration.next()) << "it is not at an end";
    person.move(3, 0, 0.9);
    EXPECT_TRUE(person.calibration.next());
    EXPECT_FALSE(person.calibration.can_skip()) << "without yaw it is not an instrument";
    person.calibration.skip();
    EXPECT_EQ(person.calibration.step(), 2);
    person.move(3, 0.9, -0.9);
    EXPECT_FALSE(person.calibration.next()) << "that axis is the pitch already";
}

class JoystickFile : public ::testing::Test {
  protected:
    std::string refusal(const std::string& text) {
        std::ofstream(path) << text;
        try {
            read_joystick_mapping(path);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }
    test::OwnFolder folder;
    const std::string path = (folder.path() / "joystick.json").string();
};

TEST_F(JoystickFile, IsReadBackAsItWasWritten) {
    Person person;
    JoystickMapping mapping;
    mapping.name = "Odd \"Stick\"";
    mapping.part[1] = person.work();
    EXPECT_EQ(refusal(joystick_mapping_text(mapping)), "");
    const JoystickMapping again = read_joystick_mapping(path);
    EXPECT_EQ(again.name, mapping.name);
    EXPECT_FALSE(again.part[0].used());
    for (const double reading : {-1.0, -0.3, 0.0, 0.77})
        for (int m = 0; m < joystick_motions; ++m)
            EXPECT_EQ(value(again.part[1], static_cast<JoystickMotion>(m), reading),
                      m == 3 ? 0 : value(mapping.part[1], static_cast<JoystickMotion>(m), reading));
    EXPECT_EQ(again.part[1].clutch, 2);
}

TEST_F(JoystickFile, WithoutAnAxisForJawsTheyAreOpen) {
    Person person;
    JoystickMapping mapping;
    mapping.name = "stick";
    mapping.part[0] = person.work();
    mapping.part[0].motion[static_cast<int>(JoystickMotion::jaw)] = {};
    mapping.part[0].jaws = 2;
    EXPECT_EQ(refusal(joystick_mapping_text(mapping)), "");
    const JoystickMapping read = read_joystick_mapping(path);
    EXPECT_EQ(value(read.part[0], JoystickMotion::jaw, 0), 1)
        << "of their opening, until the button closes them";
    EXPECT_EQ(read.part[0].jaws, 2);
}

TEST_F(JoystickFile, ADamagedOneIsRefusedWithPlaceAndWhatToDo) {
    Person person;
    JoystickMapping mapping;
    mapping.name = "stick";
    mapping.part[0] = person.work();
    const std::string whole = joystick_mapping_text(mapping);
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = whole;
        EXPECT_NE(text.find(from), std::string::npos) << from;
        return refusal(text.replace(text.find(from), from.size(), to));
    };
    EXPECT_EQ(refusal(whole), "");
    EXPECT_NE(refusal("").find("fulcrum-joystick"), std::string::npos);
    EXPECT_NE(refusal(std::string(70000, ' ')).find("larger than 64 KiB"), std::string::npos);
    EXPECT_NE(refusal("[1]").find("calibrate the joystick again"), std::string::npos);
    EXPECT_NE(changed("\"axis\": 5", "\"axis\": 99").find("/left/insertion/axis"), std::string::npos);
    EXPECT_NE(changed("\"axis\": 5", "\"axis\": null").find("/left/insertion/axis"), std::string::npos);
    EXPECT_NE(changed("\"at_high\": 0.2", "\"at_high\": 5").find("not possible"), std::string::npos);
    EXPECT_NE(changed("\"high\": 0.7", "\"high\": -0.5").find("two ends"), std::string::npos);
    EXPECT_NE(changed("\"yaw\"", "\"waw\"").find("no hand"), std::string::npos);
    EXPECT_NE(changed("\"energy\": 0", "\"energy\": 64").find("/left/energy"), std::string::npos);
    std::remove(path.c_str());
    EXPECT_THROW(read_joystick_mapping(path), InputError);
}

}  // namespace
}  // namespace fulcrum
