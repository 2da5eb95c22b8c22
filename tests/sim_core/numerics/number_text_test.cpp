// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/number_text.h"

#include <gtest/gtest.h>

#include "tests/support/german_locale.h"

namespace fulcrum {
namespace {

TEST(NumberText, ReadsOnlyWholeFiniteDecimals) {
    EXPECT_EQ(parse_decimal("0.12"), 0.12);
    EXPECT_EQ(parse_decimal("-3e-5"), -3e-5);
    for (const char* text : {"", " 1", "1 ", "0,12", "nan", "inf", "1e999", "0x10", "1.2.3", "+1"})
        EXPECT_FALSE(parse_decimal(text).has_value()) << text;
}

TEST(NumberText, WritesFixedDigits) {
    EXPECT_EQ(decimal_text(37.5, 1), "37.5");
    EXPECT_EQ(decimal_text(-0.0, 2), "0.00");
    EXPECT_EQ(decimal_text(2.5, 0), "2");
    EXPECT_EQ(decimal_text(1e308, 0).size(), 309U);
}

TEST(NumberText, IsTheSameInALocaleWithADecimalComma) {
    const test::GermanLocale german;
    ASSERT_TRUE(german.in_force()) << "localedef cannot make de_DE: install the package locales";
    EXPECT_EQ(parse_decimal("0.12"), 0.12);
    EXPECT_EQ(decimal_text(37.5, 1), "37.5");
}

}  // namespace
}  // namespace fulcrum
