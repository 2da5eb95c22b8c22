// SPDX-License-Identifier: Apache-2.0
// The name that a wrong one was probably meant to be.
#include "sim_core/numerics/nearest_name.h"

#include <gtest/gtest.h>

namespace fulcrum {
namespace {

TEST(NearestName, IsTheOneWithTheFewestOtherLettersAndNoneThatIsFar) {
    const std::vector<std::string> known = {"path_len", "plane_dev", "time", "A2", "A3"};
    EXPECT_EQ(nearest_name("path_length", known), "path_len");
    EXPECT_EQ(nearest_name("plane_dve", known), "plane_dev");
    EXPECT_EQ(nearest_name("Time", known), "time");
    EXPECT_EQ(nearest_name("A4", known), "A2") << "the first of equals";
    EXPECT_EQ(nearest_name("blood", known), "");
    EXPECT_EQ(nearest_name("xy", known), "") << "no letter is the same";
    EXPECT_EQ(nearest_name("", known), "");
    EXPECT_EQ(nearest_name(std::string(100'000, 'a'), known), "");
    EXPECT_EQ(nearest_name("time", {}), "");
}

}  // namespace
}  // namespace fulcrum
