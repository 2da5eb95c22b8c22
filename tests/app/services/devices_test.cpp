// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices.h"

#include <gtest/gtest.h>

#include <QSettings>

namespace fulcrum::app::program_test {
namespace {

TEST(ForceScale, IsKeptForEachKindOfDeviceAndNeverOutOfRange) {
    QSettings().clear();
    EXPECT_EQ(Devices::force_scale("virtual"), 1);
    Devices::set_force_scale("virtual", 0.3);
    EXPECT_EQ(Devices::force_scale("virtual"), 0.3);
    EXPECT_EQ(Devices::force_scale("touch"), 1);
    for (const auto& [set, kept] :
         {std::pair{-1.0, ui::least_force_scale}, {0.0, ui::least_force_scale}, {7.0, 1.0}}) {
        Devices::set_force_scale("virtual", set);
        EXPECT_EQ(Devices::force_scale("virtual"), kept) << set;
    }
    // Values that nobody chose on the page: the force of the model.
    for (const char* damaged : {"strong", "nan", "inf", "-0.5", "0", "40", ""}) {
        QSettings().setValue("force_scale/virtual", QString::fromLatin1(damaged));
        EXPECT_EQ(Devices::force_scale("virtual"), 1) << damaged;
    }
    QSettings().clear();
}

TEST(ForceScale, OfTheMovementAndAssignmentsAreKeptAndNeverOutOfRange) {
    QSettings().clear();
    EXPECT_EQ(Devices::motion_scale("touch"), 1);
    Devices::set_motion_scale("touch", 1.5);
    Devices::set_motion_scale("", 40);
    EXPECT_EQ(Devices::motion_scale("touch"), 1.5);
    EXPECT_EQ(Devices::motion_scale(""), ui::largest_motion_scale);
    for (const char* damaged : {"fast", "nan", "0", "-1", "1e9"}) {
        QSettings().setValue("motion_scale/touch", QString::fromLatin1(damaged));
        EXPECT_EQ(Devices::motion_scale("touch"), 1) << damaged;
    }
    const ui::SlotChoice usual;
    EXPECT_EQ(Devices::slot_choice("touch"), usual);
    Devices::set_slot_choice("touch", {1, 0, -1});
    EXPECT_EQ(Devices::slot_choice("touch"), (ui::SlotChoice{1, 0, -1}));
    Devices::set_slot_choice("touch", {1, 0, -1, 2});
    EXPECT_EQ(Devices::slot_choice("touch"), (ui::SlotChoice{1, 0, -1, 2}));
    Devices::set_slot_choice("touch", {-1, -1, -1});
    EXPECT_EQ(Devices::slot_choice("touch"), (ui::SlotChoice{-1, -1, -1}));
    for (const char* damaged : {"1 1 2", "0 1", "0 1 3", "a b c", "-2 0 1", "0 1 2 3"}) {
        QSettings().setValue("hands/touch", QString::fromLatin1(damaged));
        EXPECT_EQ(Devices::slot_choice("touch"), usual) << damaged;
    }
    QSettings().clear();
}

TEST(ForceScale, TheDeviceThatWasChosenIsKeptWhereItIsKnown) {
    QSettings().clear();
    Devices devices("");
    EXPECT_EQ(Devices::chosen(), "");
    devices.choose("controller");
    EXPECT_EQ(Devices::chosen(), "controller");
    EXPECT_EQ(devices.in_use().kind, "controller");
    EXPECT_EQ(devices.in_use().device_class, DeviceClass::controller);
    EXPECT_FALSE(devices.readings().has_value());
    EXPECT_FALSE(devices.start_force_test());
    devices.choose("mouse-keyboard");
    EXPECT_EQ(Devices::chosen(), "");
    EXPECT_EQ(devices.in_use().kind, "");
    QSettings().setValue("device", "virtual:/tmp/x");
    EXPECT_EQ(Devices::chosen(), "");
    QSettings().clear();
}

TEST(ForceScale, DeviceThatIsNotOpenHasNoReadings) {
    Devices none("");
    EXPECT_FALSE(none.readings().has_value());
    Devices named("virtual:/none/script.json");
    EXPECT_FALSE(named.readings().has_value());
    EXPECT_EQ(named.in_use().kind, "virtual");
    EXPECT_EQ(none.in_use().kind, "");
}

}  // namespace
}  // namespace fulcrum::app::program_test
