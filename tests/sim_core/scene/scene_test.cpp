// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim_core/scene/json_document.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

std::string scene_text(const std::string& name) {
    return read_text_file(test::source_path("assets/scenes/" + name), 1U << 20U);
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << "the asset no longer holds " << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

int line_of(const std::string& text, const std::string& what) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return 1 +
           static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

TEST(Scene, TargetsSceneListsNoSoftTissue) {
    const Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    EXPECT_EQ(scene.id, "a2_targets");
    ASSERT_TRUE(scene.targets.has_value());
    EXPECT_FALSE(scene.bowel.has_value());
    EXPECT_FALSE(scene.cavity.has_value());
    EXPECT_FALSE(scene.tethers.has_value());
    EXPECT_EQ(scene.targets->per_hand, 10);
    ASSERT_NE(scene.instrument(Hand::left), nullptr);
    ASSERT_NE(scene.instrument(Hand::right), nullptr);
    EXPECT_NEAR(scene.instrument(Hand::left)->trocar.direction.norm(), 1.0, 1e-12);
    ASSERT_TRUE(scene.camera.has_value());
    EXPECT_NEAR(scene.camera->angle, 0.5235987755982988, 1e-12);
    EXPECT_NEAR(scene.step_period(), 0.005, 1e-15);
}

TEST(Scene, BowelSceneListsBowelCavityAndTethers) {
    const Scene scene = load_scene(test::source_path("assets/scenes/b1_bowel.json"));
    ASSERT_TRUE(scene.bowel.has_value());
    ASSERT_TRUE(scene.cavity.has_value());
    ASSERT_TRUE(scene.tethers.has_value());
    EXPECT_FALSE(scene.targets.has_value());
    ASSERT_EQ(scene.tissue_index("bowel"), 0);
    EXPECT_EQ(scene.tissue_index("liver"), -1);
    EXPECT_NEAR(scene.tissues[0].perforation_force, 10.3, 1e-12);
    EXPECT_NEAR(scene.tissues[0].jaw_force_time_limit, 300, 1e-12);
}

TEST(Scene, SelectsTheLawAndTheLayersOfTheWall) {
    std::string text =
        replaced(scene_text("b1_bowel.json"), "\"material\": \"linear\"", "\"material\": \"EXP2\"");
    text = replaced(text, "\"wall_thickness\": 0.003,",
                    "\"layers\": [{\"name\": \"mucosa\", \"thickness\": 0.001, \"young_modulus\": 8000}, "
                    "{\"thickness\": 0.0005, \"young_modulus\": 80000, \"exponent\": 4}],");
    const Scene scene = parse_scene(text, "b1.json");
    EXPECT_EQ(scene.fidelity.material, MaterialLaw::exp2);
    ASSERT_EQ(scene.bowel->layers.size(), 2U);
    EXPECT_EQ(scene.bowel->layers[1].exponent, 4);
    EXPECT_NEAR(scene.bowel->wall_thickness, 0.0015, 1e-15);
    // The modulus of the whole wall is the area-weighted mean of the layers.
    EXPECT_GT(scene.bowel->young_modulus, 8000 + 72000 / 3.0);
    EXPECT_LT(scene.bowel->young_modulus, 8000 + 72000 / 2.8);
    EXPECT_THROW(parse_scene(replaced(text, "\"thickness\": 0.001,", "\"thickness\": 0.0199,"), "b1.json"),
                 InputError);
}

struct BrokenScene {
    const char* name;
    const char* what;   // replaced in the asset ...
    const char* with;   // ... by this
    const char* wrong;  // must be part of the problem text
    const char* hint;   // must be part of the hint
    const char* at;     // text whose line must be reported; null: the line of `with`
};

class BrokenSceneFile : public testing::TestWithParam<BrokenScene> {};

TEST_P(BrokenSceneFile, ReportsFilePlaceAndHint) {
    const BrokenScene& broken = GetParam();
    const std::string text = replaced(scene_text("b1_bowel.json"), broken.what, broken.with);
    try {
        parse_scene(text, "broken.json");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.file(), "broken.json");
        const int line = line_of(text, broken.at != nullptr ? broken.at : broken.with);
        EXPECT_EQ(std::atoi(error.place().c_str()), line) << error.what();
        EXPECT_NE(error.problem().find(broken.wrong), std::string::npos) << error.what();
        EXPECT_NE(error.hint().find(broken.hint), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line, please";
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, BrokenSceneFile,
    testing::Values(BrokenScene{"comma", "\"length\": 0.9,", "\"length\": 0.9", "not valid JSON",
                                "correct the text", "\"outer_radius\""},
                    BrokenScene{"typo", "\"wall_thickness\"", "\"wall_thicknes\"",
                                "unknown key \"wall_thicknes\"", "did you mean \"wall_thickness\"?", nullptr},
                    BrokenScene{"text_for_number", "\"length\": 0.9", "\"length\": \"0.9 m\"", "type",
                                "a number from 0.1 to 2", nullptr},
                    BrokenScene{"out_of_range", "\"poisson_ratio\": 0.35", "\"poisson_ratio\": 0.5",
                                "the number is too large", "0.49", nullptr},
                    BrokenScene{"missing_key", "\"label\": \"bowel\",", "", "the key \"label\" is missing",
                                "add it", "{\n      \"$comment\": \"Perforation"},
                    BrokenScene{"unknown_tissue", "\"tissue\": \"bowel\"", "\"tissue\": \"colon\"",
                                "\"colon\" is not in the list", "use one of: bowel, wall", nullptr},
                    BrokenScene{"two_left_hands", "\"hand\": \"right\"", "\"hand\":  \"left\"",
                                "holds two instruments", "give each hand one instrument", nullptr},
                    BrokenScene{"short_vector", "\"gravity\": [0, 0, -9.81]", "\"gravity\": [0, -9.81]",
                                "the list is too short", "a list of 3", nullptr},
                    BrokenScene{"level_unknown", "\"skinning\": \"local\"", "\"skinning\": \"regional\"",
                                "not one of those allowed", "one of: local, local2, global", nullptr},
                    BrokenScene{"thick_wall", "\"wall_thickness\": 0.003", "\"wall_thickness\": 0.0199",
                                "thicker than the bowel", "thinner", nullptr},
                    BrokenScene{"up_along_shaft", "\"up\": [0, 0, 1]", "\"up\": [-0.11, -0.05, -0.117]",
                                "parallel", "3 degrees", nullptr},
                    BrokenScene{"twice", "\"segments\": 64,", "\"segments\": 64, \"segments\": 32,",
                                "given twice", "remove one", nullptr}),
    [](const testing::TestParamInfo<BrokenScene>& broken) { return std::string(broken.param.name); });

TEST(SceneText, HostileTextIsRefused) {
    EXPECT_THROW(parse_scene(std::string(100000, '['), "deep.json"), InputError);
    EXPECT_THROW(parse_scene(std::string(std::size_t{2} << 20U, ' '), "large.json"), InputError);
    EXPECT_THROW(parse_scene("", "empty.json"), InputError);
    EXPECT_THROW(parse_scene("[1, 2", "open.json"), InputError);
    EXPECT_THROW(parse_scene("{\"id\": \"\xff\xfe\"}", "bytes.json"), InputError);
    EXPECT_THROW(parse_scene("{\"gravity\": [1e999, 0, 0]}", "huge.json"), InputError);
    EXPECT_THROW(load_scene(test::source_path("assets/scenes/no_such_scene.json")), InputError);
    EXPECT_THROW(load_scene(test::source_path("assets/scenes")), InputError);
}

TEST(SceneText, LinesOfEveryValueAreKnown) {
    const JsonDocument document =
        JsonDocument::parse("{\n \"a\": [1,\n  {\"b/c\": 2}],\n \"d\": \"x\"\n}\n", "lines.json");
    EXPECT_EQ(document.line(""), 1);
    EXPECT_EQ(document.line("/a/0"), 2);
    EXPECT_EQ(document.line("/a/1/b~1c"), 3);
    EXPECT_EQ(document.line("/d"), 4);
    EXPECT_EQ(document.line("/a/1/missing"), 3) << "the nearest ancestor's line is used";
}

}  // namespace
}  // namespace fulcrum
