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
