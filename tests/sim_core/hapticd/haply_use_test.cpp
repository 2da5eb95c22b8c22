// SPDX-License-Identifier: Apache-2.0
// An Inverse3 that another program uses is not moved by two programs at once.
#include <gtest/gtest.h>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/built.h"
#include "tests/support/fake_haply.h"

namespace fulcrum {
namespace {

using test::FakeHaply;

/// What opening says; empty where the device opens.
std::string haply_refusal(const std::string& specification) {
    try {
        const DaemonClient client(test::hapticd_program(), specification);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(HaplyInUse, AnInverse3OfAnotherProgramIsNamedAndGetsNoCommand) {
    FakeHaply haply({{"0A11", "right"}, {"0B22", "left"}});
    haply.inventories_in_use = 1000;
    const std::string refusal = haply_refusal(haply.specification());
    EXPECT_NE(refusal.find("the Inverse3 0A11 is in use by another program; end the other program that uses "
                           "it; where there is none, restart the Inverse service"),
              std::string::npos)
        << refusal;
    EXPECT_EQ(haply.commands, 0U) << "nothing acts on it";
    EXPECT_GT(haply.inventories, 2) << "asked again";
    EXPECT_EQ(haply_refusal(haply.specification() + ",left=0B22"), "") << "the other one is free";
    EXPECT_GT(haply.commands, 0U);
}

// A program that has just ended, or this one's device process before it was started again.
TEST(HaplyInUse, OneThatIsReleasedWithinASecondIsOpened) {
    FakeHaply haply({{"0A11", "right"}, {"0B22", "left"}});
    haply.inventories_in_use = 3;
    EXPECT_EQ(haply_refusal(haply.specification()), "");
    EXPECT_GE(haply.inventories, 4);
    // What its answers say of its own use is not taken for another's.
    EXPECT_GT(haply.commands, 0U);
    EXPECT_EQ(haply.early(), 0);
}

}  // namespace
}  // namespace fulcrum
