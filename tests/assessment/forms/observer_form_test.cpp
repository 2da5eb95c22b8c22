// SPDX-License-Identifier: Apache-2.0
// The delivered observer forms are valid and have the items of their sources; wrong ones are refused with the
// place and what to do.
#include "assessment/forms/observer_form.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

nlohmann::json goals_file() {
    return nlohmann::json::parse(read_text_file(asset_path("forms/goals.json"), 1U << 20U));
}

/// The refusal of a form; empty where it is accepted.
std::string form_refusal(const nlohmann::json& document) {
    try {
        parse_form(document.dump(1), "test.json");
        return {};
    } catch (const InputError& error) {
        EXPECT_FALSE(error.hint().empty());
        return error.place() + ": " + error.problem();
    }
}

TEST(ObserverForms, DeliveredOnesHaveTheItemsAndScalesOfTheirSources) {
    const std::vector<ObserverForm> forms = load_forms(asset_path("forms"));
    ASSERT_EQ(forms.size(), 3U);
    const std::vector<std::tuple<std::string, std::size_t, int, int>> expected = {
        {"gas@1", 8, 1, 6}, {"goals@1", 5, 1, 5}, {"osats@1", 7, 1, 5}};
    for (std::size_t i = 0; i < forms.size(); ++i) {
        const auto& [name, items, lowest, highest] = expected[i];
        EXPECT_EQ(forms[i].name(), name);
        EXPECT_EQ(forms[i].items.size(), items) << name;
        EXPECT_TRUE(forms[i].blind) << name;
        EXPECT_NE(forms[i].source.find(" and others "), std::string::npos) << name;
        for (const FormItem& item : forms[i].items) {
            EXPECT_EQ(item.lowest, lowest) << name << item.id;
            EXPECT_EQ(item.highest, highest) << name << item.id;
            EXPECT_EQ(item.anchors.size(), name == "gas@1" ? 6U : 3U) << name << item.id;
        }
    }
    EXPECT_EQ(forms[1].find("tissue_handling")->title, "Tissue handling");
    EXPECT_EQ(forms[1].find("patience"), nullptr);
}

TEST(ObserverForms, WrongOnesAreRefusedWithPlaceAndHint) {
    const auto refused = [](const char* pointer, const nlohmann::json& value, const std::string& says) {
        nlohmann::json document = goals_file();
        document[nlohmann::json::json_pointer(pointer)] = value;
        const std::string found = form_refusal(document);
        EXPECT_NE(found.find(says), std::string::npos) << pointer << " gives: " << found;
    };
    EXPECT_EQ(form_refusal(goals_file()), "");
    refused("/items/1/id", "depth_perception", "/items/1/id): depth_perception is listed twice");
    refused("/items/0/highest", 1, "/items/0/highest): must be above /lowest (is 1)");
    refused("/items/0/anchors/2/rating", 6,
            "/items/0/anchors/2/rating): is outside the scale of the item (is 6)");
    refused("/items/0/anchors/1/rating", 1, "/items/0/anchors/1/rating): does not follow");
    refused("/items/0/anchors/2/rating", 4, "/items/0/anchors): leaves an end of the scale without words");
    refused("/items/0/anchors/0/text", "", "/items/0/anchors/0/text");
    refused("/items", nlohmann::json::array(), "/items");
    refused("/blind", "yes", "/blind");
    refused("/id", "Go als", "/id");
    refused("/colour", "red", "colour");
    refused("/version", 0, "/version");
    nlohmann::json without = goals_file();
    without.erase("source");
    EXPECT_NE(form_refusal(without).find("source"), std::string::npos);
    EXPECT_THROW(parse_form("{", "test.json"), InputError);
    EXPECT_THROW(parse_form("", "test.json"), InputError);
    EXPECT_THROW(load_form(asset_path("forms/none.json")), InputError);
}

TEST(ObserverForms, OfSeveralVersionsTheNewestIsOfferedAndNoneIsThereTwice) {
    const test::OwnFolder folder;
    nlohmann::json document = goals_file();
    const auto write = [&](const char* name) { std::ofstream(folder / name) << document.dump(); };
    write("a.json");
    document["version"] = 12;
    write("b.json");
    document["version"] = 3;
    write("c.json");
    const std::vector<ObserverForm> forms = load_forms(folder.path().string());
    ASSERT_EQ(forms.size(), 3U);
    const std::vector<ObserverForm> newest = newest_forms(forms);
    ASSERT_EQ(newest.size(), 1U);
    EXPECT_EQ(newest[0].name(), "goals@12");
    write("d.json");
    EXPECT_THROW(load_forms(folder.path().string()), InputError);
    EXPECT_TRUE(load_forms((folder / "none").string()).empty());
}

TEST(ObserverForms, AFormIsCompleteWhenEveryItemIsAnsweredAndOnlyOptionalOnesWereNotSeen) {
    const ObserverForm form = load_form(asset_path("forms/osats.json"));
    FormAnswers answers(7, 3);
    std::vector<bool> answered(7, true);
    EXPECT_EQ(first_unanswered(form, answers, answered), std::nullopt);
    answers[4] = std::nullopt;  // use of assistants
    EXPECT_EQ(first_unanswered(form, answers, answered), std::nullopt);
    answered[4] = false;
    EXPECT_EQ(first_unanswered(form, answers, answered), 4U);
    answers[0] = std::nullopt;
    EXPECT_EQ(first_unanswered(form, answers, answered), 0U) << "never left out";
}

TEST(ObserverForms, SumsAndSharesAreOfTheAnsweredItems) {
    const ObserverForm form = load_form(asset_path("forms/osats.json"));
    FormAnswers answers(7, 5);
    EXPECT_DOUBLE_EQ(*form_share(form, answers), 1.0);
    EXPECT_EQ(form_sum(form, answers).sum, 35);
    answers = FormAnswers(7, 1);
    EXPECT_DOUBLE_EQ(*form_share(form, answers), 0.0);
    answers[3] = std::nullopt;
    answers[0] = 4;
    EXPECT_DOUBLE_EQ(*form_share(form, answers), 0.75 / 6);
    const FormSum sum = form_sum(form, answers);
    EXPECT_EQ(sum.sum, 9);
    EXPECT_EQ(sum.lowest, 6);
    EXPECT_EQ(sum.highest, 30);
    EXPECT_EQ(sum.answered, 6);
    EXPECT_EQ(form_share(form, FormAnswers(7)), std::nullopt);
}

}  // namespace
}  // namespace fulcrum
