// SPDX-License-Identifier: Apache-2.0
// Words of scene files that stand for values of an enum.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim_core/scene/fidelity.h"
#include "sim_core/scene/json_names.h"
#include "sim_core/scene/scene_schema.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

using nlohmann::json;

template <typename Row, std::size_t n>
std::vector<std::string> names(const Row (&rows)[n]) {
    std::vector<std::string> list;
    for (const Row& row : rows) list.push_back(row.name);
    return list;
}

std::vector<std::string> sorted(std::vector<std::string> list) {
    std::sort(list.begin(), list.end());
    return list;
}

TEST(Names, TheSchemaAllowsExactlyWhatTheTablesHold) {
    const json schema = json::parse(scene_schema());
    const json& instrument = schema.at("definitions").at("instrument").at("properties");
    EXPECT_EQ(sorted(instrument.at("kind").at("enum").get<std::vector<std::string>>()),
              sorted(names(instrument_types)));
    const json& fidelity = schema.at("properties").at("fidelity").at("properties");
    const auto allowed = [&](const char* key) {
        return fidelity.at(key).at("enum").get<std::vector<std::string>>();
    };
    EXPECT_EQ(allowed("rod"), names(rod_levels));
    EXPECT_EQ(allowed("material"), names(material_laws));
    EXPECT_EQ(allowed("skinning"), names(skin_scopes));
    EXPECT_EQ(allowed("collision"), names(collision_searches));
    EXPECT_EQ(allowed("tool_contact"), names(tool_contact_levels));
    EXPECT_EQ(allowed("membrane"), names(membrane_integrators));
    EXPECT_EQ(allowed("filter"), names(filter_levels));
}

TEST(SceneSchema, IsTheOneOfTheFile) {
    json used = json::parse(scene_schema());
    json file = json::parse(read_text_file(test::source_path("assets/schemas/scene.schema.json"), 1U << 20U));
    for (json* schema : {&used, &file}) schema->erase("$comment");
    EXPECT_EQ(used, file) << "write it again: FULCRUM_WRITE_REFERENCES=1 test_structure";
    EXPECT_GT(used.at("properties").at("objects").at("properties").size(), 10U);
}

// Past the schema no word becomes something else either.
TEST(Names, AnUnknownWordIsRefusedWithItsPlaceAndTheKnownOnes) {
    const JsonDocument document = JsonDocument::parse("{\n\"kind\": \"drill\"\n}", "scene.json");
    try {
        named(document, document.root().at("kind"), "/kind", instrument_types);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "2 (/kind)");
        EXPECT_NE(error.problem().find("\"drill\""), std::string::npos) << error.what();
        EXPECT_NE(error.hint().find("grasper, probe, harmonic"), std::string::npos) << error.what();
    }
    EXPECT_THROW(named(document, json(3), "/kind", rod_levels), InputError);
    EXPECT_THROW(named_fidelity("finest"), InputError);
}

TEST(Names, EachFidelityIsReadBackByItsName) {
    for (const auto& level : fidelity_levels) EXPECT_EQ(named_fidelity(level.name).id, level.name);
    EXPECT_EQ(named_fidelity("fast").rod, RodLevel::linearised);
    EXPECT_EQ(named_fidelity("fine").material, MaterialLaw::exp2);
}

}  // namespace
}  // namespace fulcrum
