// SPDX-License-Identifier: Apache-2.0
// Statements: stored as ids with parameters, shown in words, every one of them marked for translation.
#include "assessment/metrics/statement.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "assessment/metrics/registry.h"
#include "assessment/metrics/statement_words.h"
#include "sim_core/telemetry/event_types.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

/// One of every id, with the parameters that the program gives it.
std::vector<Statement> samples() {
    using Id = StatementId;
    const std::string hand = "left", metric = "f_max", tissue = "bowel", phase = "Run the bowel";
    const Statement because = Id::nothing_cut;
    const std::vector<Statement> with_parameters = {
        {Id::specimen_undivided, {{"percent", 94.0}, {"least", 95.0}}},
        {Id::few_way_points, {{"least", 3.0}}},
        {Id::few_target_movements, {{"least", 2.0}}},
        {Id::few_movements, {{"count", 4.0}, {"least", 5.0}}},
        {Id::few_loaded_movements, {{"count", 4.0}, {"least", 5.0}}},
        {Id::device_noise, {{"noise_um", 7.0}, {"limit_um", 5.0}}},
        {Id::short_inside, {{"least_s", 4.0}}},
        {Id::short_force, {{"least_s", 1.0}}},
        {Id::no_force_on, {{"tissue", tissue}}},
        {Id::no_force_limit_for, {{"tissue", tissue}}},
        {Id::low_rate, {{"rate_hz", 9.96}, {"least_hz", 20.0}}},
        {Id::samples_lost, {{"count", 150.0}}},
        {Id::not_recorded, {{"channels", std::string("left.px, left.py")}}},
        {Id::cutting_differs, {{"difference", std::string("areolar: penetrate_n 0.11, there 0.04")}}},
        {Id::device_class_differs, {{"device", std::string("mouse-keyboard")}}},
        {Id::fidelity_differs, {{"limits", std::string("standard")}, {"used", std::string("fast")}}},
        {Id::variant_differs, {{"limits", std::string("standard")}, {"used", std::string("narrow")}}},
        {Id::limits_outdated, {{"metric", metric}}},
        {Id::gate_not_judged, {{"metric", metric}, {"hand", hand}, {"because", because}}},
        {Id::critical_error,
         {{"event", std::string("perforation")},
          {"hand", hand},
          {"tissue", tissue},
          {"phase", phase},
          {"time_s", 43.2}}},
        {Id::gate_missed,
         {{"metric", metric},
          {"hand", hand},
          {"tissue", tissue},
          {"phase", phase},
          {"value", 6.0},
          {"limit", 4.0}}},
        {Id::gates_met_narrowly, {{"metric", metric}, {"hand", hand}, {"value", 3.9}, {"limit", 4.0}}},
        {Id::time_ran_out, {{"metric", std::string("time")}}},
        {Id::gate_without_value, {{"metric", metric}, {"hand", hand}, {"because", because}}},
        {Id::not_scored, {{"because", because}}},
        {Id::practice_stood_still, {{"seconds", 1.5}}},
        Statement::plain("The force rose to 6.0 N."),
    };
    std::vector<Statement> all;
    for (const StatementRow& row : statements) {
        Statement sample(row.kind);
        for (const Statement& one : with_parameters)
            if (one.id() == row.kind) sample = one;
        all.push_back(sample);
    }
    return all;
}

TEST(Statements, HaveWordsForEveryId) {
    std::set<std::string> names, words;
    for (const Statement& sample : samples()) {
        const StatementRow& row = row_of(statements, sample.id());
        EXPECT_TRUE(names.insert(row.name).second) << row.name << " names two statements";
        const std::string text = words_of(sample);
        EXPECT_EQ(text.empty(), sample.id() == StatementId::none) << row.name;
        EXPECT_TRUE(words.insert(text).second) << text << ": two statements read the same";
        EXPECT_EQ(text.find_first_of("{}"), std::string::npos) << row.name << ": " << text;
    }
}

TEST(Statements, ComeBackFromTheStoreAsTheyWere) {
    for (const Statement& sample : samples()) {
        const std::string stored = stored_text(sample);
        EXPECT_EQ(statement_of(stored), sample) << stored;
        EXPECT_EQ(stored_text(statement_of(stored)), stored);
        EXPECT_EQ(words_of(statement_of(stored)), words_of(sample));
        if (sample.id() > StatementId::plain) {
            EXPECT_EQ(stored.find("{\"id\":\""), 0U) << stored;
        }
    }
}

TEST(Statements, ReadWell) {
    const std::string metric = "f_max", hand = "left";
    EXPECT_EQ(words_of({StatementId::low_rate, {{"rate_hz", 9.96}, {"least_hz", 20.0}}}),
              "the mean rate of 10 Hz is below 20 Hz");
    EXPECT_EQ(
        words_of({StatementId::gate_not_judged,
                  {{"metric", metric}, {"hand", hand}, {"because", Statement(StatementId::no_benchmark)}}}),
        find_metric(metric)->name + ", left hand: there is no benchmark for this task and device class");
    // A metric that this program no longer has is named by its id.
    EXPECT_EQ(
        words_of({StatementId::gate_missed,
                  {{"metric", std::string("retired")}, {"hand", hand}, {"value", 3.5}, {"limit", 3.0}}}),
        "Left hand: retired is 3.5, the limit is 3 (17 % over); replay that moment and plan it differently.");
    EXPECT_EQ(
        words_of({StatementId::gate_missed,
                  {{"metric", std::string("retired")}, {"hand", hand}, {"value", 3.01}, {"limit", 3.0}}}),
        "Left hand: retired is 3, the limit is 3 (less than 1 % over); replay that moment and plan it "
        "differently.");
}

TEST(Statements, OfAnotherProgramAndOldSentencesAreShownAsTheyAre) {
    for (const char* text : {"Left hand: the force rose to 6.0 N; approach slowly.", "{braces} in a sentence",
                             "{\"id\":\"advice.of_tomorrow\",\"limit\":4.0}", "{\"id\":7}", "[1]", "{}",
                             "{\"id\":\"advice.not_scored\",\"because\":{\"id\":\"tomorrow\"}}"}) {
        const Statement statement = statement_of(text);
        EXPECT_EQ(statement.id(), StatementId::plain) << text;
        EXPECT_EQ(words_of(statement), text);
        EXPECT_EQ(stored_text(statement), text);
        EXPECT_TRUE(statement_json(statement).is_null());
    }
    // An old reason inside a new statement.
    const Statement mixed(StatementId::not_scored, {{"because", Statement::plain("a channel is missing")}});
    EXPECT_EQ(words_of(statement_of(stored_text(mixed))), "Not scored: a channel is missing.");
    EXPECT_TRUE(statement_of("").empty());
}

TEST(Statements, AreTranslatedPartByPart) {
    const Translate shout = [](const char* context, const char* source) {
        return std::string(context) == "fulcrum::metrics" ? std::string("METRIC") : std::string(source);
    };
    EXPECT_EQ(words_of({StatementId::gates_met_narrowly,
                        {{"metric", std::string("f_max")}, {"value", 3.9}, {"limit", 4.0}}},
                       shout),
              "All gates are met. Closest to its limit: METRIC (3.9 N, limit 4.0 N). To improve: METRIC.");
}

/// All texts that sources below `folder` mark for a context; adjacent literals joined, as lupdate joins them.
std::set<std::string> marked_texts(const std::string& folder, const std::string& context) {
    const std::string literal = R"("(?:[^"\\]|\\.)*")";
    const std::regex mark("QT_TRANSLATE_NOOP\\(\\s*\"" + context + "\",\\s*(" + literal + "(?:\\s*" +
                          literal + ")*)\\s*\\)");
    const std::regex one(R"re("((?:[^"\\]|\\.)*)")re");
    std::set<std::string> texts;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source_path(folder))) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".cpp" && extension != ".h") continue;
        std::ifstream file(entry.path());
        std::stringstream content;
        content << file.rdbuf();
        const std::string source = content.str();
        for (std::sregex_iterator it(source.begin(), source.end(), mark), end; it != end; ++it) {
            const std::string literals = (*it)[1];
            std::string text;
            for (std::sregex_iterator part(literals.begin(), literals.end(), one); part != end; ++part)
                text += (*part)[1];
            texts.insert(std::regex_replace(text, std::regex(R"re(\\")re"), "\""));
        }
    }
    return texts;
}

TEST(Statements, AreMarkedForTranslationWithTheTextsOfMetricsAndEvents) {
    const auto statement_texts = marked_texts("assessment/metrics", "fulcrum::statements");
    for (const StatementRow& row : statements) {
        if (row.kind <= StatementId::none) continue;
        EXPECT_EQ(statement_texts.count(row.words), 1U) << row.words;
    }
    const auto metric_texts = marked_texts("assessment/metrics", "fulcrum::metrics");
    for (const Metric& metric : metric_registry())
        for (const std::string& text : {metric.descriptor.name, metric.descriptor.explanation,
                                        metric.descriptor.advice_fault, metric.descriptor.advice_remedy})
            EXPECT_EQ(metric_texts.count(text), 1U) << metric.descriptor.id << ": " << text;
    const auto event_texts = marked_texts("sim_core/telemetry", "fulcrum::events");
    for (const auto& row : event_kinds) EXPECT_EQ(event_texts.count(row.title), 1U) << row.title;
}

}  // namespace
}  // namespace fulcrum
