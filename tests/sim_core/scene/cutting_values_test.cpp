// SPDX-License-Identifier: Apache-2.0
// Cutting values of a site: read, inserted into the scene, refused with tissue, key and hint.
#include "sim_core/scene/cutting_values.h"

#include <gtest/gtest.h>

#include <limits>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

std::string sheet_text() {
    return read_text_file(test::source_path("assets/scenes/b2_areolar.json"), JsonLimits().bytes);
}

std::string refusal(const CuttingValues& values) {
    try {
        with_cutting_values(sheet_text(), "site values of B2", values);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(CuttingValues, EveryKeyOfTheSceneIsReadAndHasARange) {
    const CuttingValues values = cutting_values(parse_scene(sheet_text(), "b2"));
    ASSERT_EQ(values.size(), 1U);
    ASSERT_EQ(values.count("areolar"), 1U);
    EXPECT_EQ(values.at("areolar").size(), std::size(cutting_keys));
    EXPECT_EQ(values.at("areolar").at("penetrate_n"), 0.08);
    for (const CuttingKey& key : cutting_keys) {
        const CuttingRange range = cutting_range(key.key);
        EXPECT_LT(range.minimum, range.maximum) << key.key;
        EXPECT_FALSE(range.words.empty());
    }
    EXPECT_TRUE(cutting_values(load_scene(test::source_path("assets/scenes/a2_targets.json"))).empty());
}

TEST(CuttingValues, SiteValuesReplaceOnlyTheirKeys) {
    EXPECT_EQ(with_cutting_values(sheet_text(), "b2", {}), sheet_text());
    const Scene before = parse_scene(sheet_text(), "b2");
    const Scene after = parse_scene(
        with_cutting_values(sheet_text(), "b2", {{"areolar", {{"penetrate_n", 0.1234567890123}}}}), "b2");
    EXPECT_EQ(after.tissues[0].cutting->penetrate, 0.1234567890123);
    EXPECT_EQ(after.tissues[0].cutting->static_friction, before.tissues[0].cutting->static_friction);
    EXPECT_EQ(after.tissues[0].stiffness, before.tissues[0].stiffness);
    EXPECT_EQ(after.sheet->line_length, before.sheet->line_length);
    EXPECT_EQ(after.instruments[0].trocar.position, before.instruments[0].trocar.position);
    EXPECT_EQ(after.camera->angle, before.camera->angle);
}

TEST(CuttingValues, InvalidValuesReportFileTissueKeyAndHint) {
    for (const double value : {0.0, -1.0, 21.0, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()}) {
        const std::string words = refusal({{"areolar", {{"penetrate_n", value}}}});
        EXPECT_NE(words.find("site values of B2:/tissues/areolar/cutting/penetrate_n"), std::string::npos)
            << words;
        EXPECT_NE(words.find("give a number above 0, at most 20"), std::string::npos) << words;
    }
    EXPECT_NE(refusal({{"bone", {{"penetrate_n", 1.0}}}}).find("use one of areolar"), std::string::npos);
    EXPECT_NE(refusal({{"areolar", {{"hardness", 1.0}}}}).find("use one of penetrate_n"), std::string::npos);
    const std::string together = refusal({{"areolar", {{"dynamic_friction_n", 5.0}}}});
    EXPECT_NE(together.find("dynamic_friction_n"), std::string::npos) << together;
    EXPECT_NE(together.find("give at most the value of static_friction_n"), std::string::npos) << together;
}

TEST(CuttingValues, DifferencesAreDescribedInWords) {
    const CuttingValues soft{{"areolar", {{"penetrate_n", 0.08}}}},
        tough{{"areolar", {{"penetrate_n", 0.12}}}};
    EXPECT_EQ(cutting_difference(soft, soft), "");
    EXPECT_EQ(cutting_difference(tough, soft), "areolar: penetrate_n 0.12, there 0.08");
    EXPECT_EQ(cutting_difference({}, soft), "areolar: cutting values in the second scene only");
    EXPECT_EQ(cutting_difference(soft, {}), "areolar: cutting values in the first scene only");
}

}  // namespace
}  // namespace fulcrum
