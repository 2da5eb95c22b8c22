// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of statement follows the project's xAPI profile, and one that was changed does not.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "assessment/assets/assets.h"
#include "database/records/ratings.h"
#include "sim_core/scene/json_document.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/support.h"
#include "tests/support/xapi_profile.h"
#include "ui/reports/report_xapi.h"

namespace fulcrum::ui {
namespace {

class XapiProfile : public ::testing::Test {
  protected:
    /// A passed, a failed, a completed and an ended attempt without a verdict, a rating, and what was voided.
    static nlohmann::json statements() {
        database::test::Programme programme;
        const std::string rated = programme.record("ann");
        const database::Ratings ratings(*programme.store);
        const auto rate = [&](const std::string& attempt) {
            const std::string rating = ratings.begin(programme.session("educator"), attempt,
                                                     load_form(asset_path("forms/goals.json")));
            ratings.answer(programme.session("educator"), rating, {5, 4, 3, 2, 1}, std::vector<bool>(5, true),
                           "");
            ratings.hand_in(programme.session("educator"), rating);
            ratings.release(programme.session("educator"), attempt);
        };
        rate(rated);
        programme.clock.pass_s(60);
        const std::string out = programme.record("ann");
        rate(out);
        programme.attempts().void_attempt(programme.session("educator"), out, "wrong person");
        PersonReport report = gather_person(*programme.store, programme.session("director"),
                                            programme.id("ann"), {load_task(task_file("A2"))}, "0.1.0");
        EXPECT_EQ(report.progress.size(), 1U);
        std::vector<database::ProgressPoint>& points = report.progress[0].series[0].points;
        EXPECT_FALSE(points.empty());
        const database::ProgressPoint like = points[0];
        const auto add = [&](std::optional<bool> passed, AttemptState state) {
            database::ProgressPoint point = like;
            point.attempt_id.back() = static_cast<char>('0' + points.size());
            point.passed = passed;
            point.state = state;
            if (!passed) {
                point.points.reset();
                point.not_scored_because = StatementId::never_inside;
            }
            point.ratings.clear();
            points.push_back(point);
        };
        add(true, AttemptState::completed);
        add(false, AttemptState::timed_out);
        add(std::nullopt, AttemptState::completed);
        add(std::nullopt, AttemptState::interrupted);
        return nlohmann::json::parse(xapi_statements({report}, "https://training.example"));
    }
    static const nlohmann::json& profile() {
        static const nlohmann::json read = nlohmann::json::parse(xapi_profile_text);
        return read;
    }
    static std::string all(const std::vector<std::string>& problems) {
        std::string text;
        for (const std::string& one : problems) text += one + "; ";
        return text;
    }
};

TEST_F(XapiProfile, EachStatementFollowsOneTemplateAndEachTemplateHasOne) {
    std::set<std::string> verbs;
    for (const nlohmann::json& one : statements()) {
        EXPECT_EQ(all(test::profile_problems(profile(), one)), "") << one.dump(1);
        verbs.insert(one["verb"]["id"].get<std::string>());
    }
    for (const nlohmann::json& one : profile()["templates"])
        EXPECT_EQ(verbs.count(one["verb"].get<std::string>()), 1U) << one["id"];
}

TEST_F(XapiProfile, AChangedStatementDoesNot) {
    struct Change {
        const char* name;
        std::function<void(nlohmann::json&)> apply;
    };
    const Change changes[] = {
        {"another profile",
         [](nlohmann::json& s) { s["context"]["contextActivities"]["category"][0]["id"] = "urn:x"; }},
        {"no profile", [](nlohmann::json& s) { s["context"].erase("contextActivities"); }},
        {"a name", [](nlohmann::json& s) { s["actor"]["name"] = "Ann"; }},
        {"a mail address", [](nlohmann::json& s) { s["actor"]["mbox"] = "mailto:ann@example.org"; }},
        {"no account", [](nlohmann::json& s) { s["actor"].erase("account"); }},
        {"another verb",
         [](nlohmann::json& s) { s["verb"]["id"] = "http://adlnet.gov/expapi/verbs/launched"; }},
        {"a term that is not in it",
         [](nlohmann::json& s) { s["context"]["extensions"]["urn:fulcrum:xapi:mood"] = "good"; }},
        {"no time", [](nlohmann::json& s) { s.erase("timestamp"); }},
    };
    for (const nlohmann::json& one : statements())
        for (const Change& change : changes) {
            nlohmann::json changed = one;
            change.apply(changed);
            EXPECT_NE(all(test::profile_problems(profile(), changed)), "")
                << change.name << " " << one["verb"];
        }
    for (const nlohmann::json& one : statements()) {
        if (one["verb"]["id"] != "http://adlnet.gov/expapi/verbs/passed") continue;
        nlohmann::json changed = one;
        changed["result"]["success"] = false;
        EXPECT_NE(all(test::profile_problems(profile(), changed)), "");
        changed = one;
        changed["context"]["extensions"]["urn:fulcrum:xapi:device-class"] = "spoon";
        EXPECT_NE(all(test::profile_problems(profile(), changed)), "");
        changed = one;
        changed["result"]["extensions"]["urn:fulcrum:xapi:metrics"] = {{{"id", "time"}}};
        EXPECT_NE(all(test::profile_problems(profile(), changed)), "") << "a value without its unit";
    }
}

/// As the product's reader of files written by hand judges a text.
bool fits_for_the_reader(const std::string& text, const std::string& schema) {
    try {
        JsonDocument::parse(text, "value").check_schema(schema.c_str());
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

/// Values of all kinds: those of the statements, and their lists with one member of the first row changed.
std::set<std::string> values_of_all_kinds(const nlohmann::json& statements) {
    std::set<std::string> texts{"null", "true", "7", "-1.5", "\"\"", "\"practice\"", "[]", "{}", "[7]"},
        lists;
    for (const nlohmann::json& one : statements)
        for (const char* part : {"result", "context"}) {
            if (!one.contains(part) || !one.at(part).contains("extensions")) continue;
            for (const auto& [id, value] : one.at(part).at("extensions").items()) {
                texts.insert(value.dump());
                if (!value.is_array() || value.empty() || !lists.insert(id).second) continue;
                std::vector<std::string> keys;
                for (const auto& [key, was] : value.at(0).items()) keys.push_back(key);
                for (const std::string& key : keys) {
                    nlohmann::json changed = value;
                    changed[0].erase(key);
                    texts.insert(changed.dump());
                    for (const char* other : {"null", "\"x\"", "7", "1.5", "[[1]]", "[[1, 2], [1, \"x\"]]"}) {
                        changed[0][key] = nlohmann::json::parse(other);
                        texts.insert(changed.dump());
                    }
                }
            }
        }
    EXPECT_EQ(lists.size(), 2U) << "metrics and rating items";
    return texts;
}

TEST_F(XapiProfile, ValuesAreJudgedAsByTheReaderOfFilesWrittenByHand) {
    int good = 0, bad = 0;
    const std::set<std::string> texts = values_of_all_kinds(statements());
    for (const nlohmann::json& one : profile()["concepts"]) {
        if (!one.contains("inlineSchema")) continue;
        const std::string schema = one["inlineSchema"];
        for (const std::string& text : texts) {
            const std::string wrong =
                test::schema_problem(nlohmann::json::parse(schema), nlohmann::json::parse(text));
            EXPECT_EQ(wrong.empty(), fits_for_the_reader(text, schema)) << one["id"] << ", " << text;
            ++(wrong.empty() ? good : bad);
        }
    }
    EXPECT_GT(good, 50);
    EXPECT_GT(bad, 500);
}

TEST_F(XapiProfile, IsAProfileByItsSpecification) {
    const nlohmann::json& read = profile();
    EXPECT_EQ(read["@context"], "https://w3id.org/xapi/profiles/context");
    EXPECT_EQ(read["type"], "Profile");
    EXPECT_EQ(read["conformsTo"], "https://w3id.org/xapi/profiles#1.0");
    ASSERT_EQ(read["versions"].size(), 1U);
    EXPECT_EQ(read["versions"][0]["id"], xapi_profile_version);
    std::set<std::string> ids;
    for (const char* part : {"concepts", "templates"})
        for (const nlohmann::json& one : read[part]) {
            EXPECT_TRUE(ids.insert(one["id"].get<std::string>()).second) << one["id"];
            EXPECT_EQ(one["inScheme"], xapi_profile_version) << one["id"];
            for (const char* words : {"prefLabel", "definition"})
                EXPECT_FALSE(one[words]["en"].get<std::string>().empty()) << one["id"];
        }
    for (const nlohmann::json& one : read["templates"])
        for (const nlohmann::json& rule : one["rules"]) {
            EXPECT_EQ(rule["location"].get<std::string>().rfind("$.", 0), 0U);
            EXPECT_TRUE(rule.contains("presence") || rule.contains("any") || rule.contains("none"));
        }
    EXPECT_EQ(read, nlohmann::json::parse(
                        read_text_file(test::source_path("assets/schemas/xapi_profile.jsonld"), 1U << 20U)));
}

}  // namespace
}  // namespace fulcrum::ui
