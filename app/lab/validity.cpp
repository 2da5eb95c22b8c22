// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/validity.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "app/lab/kept_pages.h"
#include "assessment/assets/assets.h"
#include "assessment/metrics/registry.h"
#include "assessment/operators/cheats.h"
#include "sim_core/lab/chart.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

using lab::short_number;
using nlohmann::json;

/// A result as JSON, or from the page that is kept of it.
json read_result(const std::string& folder, const std::string& name, const std::string& command,
                 json (*read_page)(const std::string&, const std::string&)) {
    const auto content = [&](const char* ending) {
        const std::string path = (std::filesystem::path(folder) / (name + ending)).string();
        std::ifstream file(path);
        std::stringstream text;
        if (file) text << file.rdbuf();
        return std::pair(path, text.str());
    };
    const auto [path, text] = content(".json");
    if (text.empty()) {
        const auto [page_path, page] = content(".md");
        if (!page.empty()) return read_page(page, page_path);
    }
    const json document = json::parse(text, nullptr, false);
    if (!document.is_object())
        throw InputError(path, "", text.empty() ? "no such file, and no page of it" : "not a JSON object",
                         "make it with fulcrum-lab " + command + " --output " + folder);
    return document;
}

/// Tasks in the order of their ids that have a page of operators.
std::vector<std::string> tasks_in(const std::string& folder) {
    std::set<std::string> tasks;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            const std::string stem = entry.path().stem().string(), begin = "operators_";
            const std::string ending = entry.path().extension().string();
            if ((ending == ".json" || ending == ".md") && stem.compare(0, begin.size(), begin) == 0)
                tasks.insert(stem.substr(begin.size()));
        }
    if (tasks.empty())
        throw InputError(folder, "", "holds no operators_TASK.json or .md",
                         "make them with fulcrum-lab operators TASK --output " + folder);
    return {tasks.begin(), tasks.end()};
}

/// " [1 and 60 values]" where fewer experts or novices than attempts have one.
std::string few_values(const json& row, int seeds) {
    const json values = row.value("values", json());
    if (!values.is_array() || values.size() != 3) return "";
    const int experts = values[0].get<int>(), novices = values[2].get<int>();
    if (experts >= seeds && novices >= seeds) return "";
    return " [" + std::to_string(experts) + " and " + std::to_string(novices) + " values]";
}

/// "left 0.99, right 1" of the rows of a metric; `key` auc or retest.
std::string by_hand(const json& document, const std::string& metric, const char* key) {
    const json& rows = document.at("metrics");
    const int seeds = document.at("seeds").get<int>();
    std::string text;
    for (const json& row : rows) {
        if (row.at("metric") != metric || row.at(key).is_null()) continue;
        const std::string hand = row.at("hand").is_null() ? "" : row.at("hand").get<std::string>() + " ";
        const bool context = row.at("separates").is_null();
        const std::string value = short_number(row.at(key).get<double>(), 2) +
                                  (std::string(key) == "auc" ? few_values(row, seeds) : "");
        text += (text.empty() ? "" : ", ") + hand + (context ? "(" + value + ")" : value);
    }
    return text;
}

/// What is known of the version that a value was measured with; empty: the registry's.
std::string version_mark(const json& version, int now) {
    if (version.is_null()) return "version not recorded";
    return version == now ? "" : "measured with v" + std::to_string(version.get<int>());
}

/// The version that a page has of a metric; null where it has none, nothing where it has no such metric.
std::optional<json> version_in(const json& document, const std::string& metric) {
    for (const json& row : document.at("metrics"))
        if (row.at("metric") == metric) return row.value("version", json());
    return std::nullopt;
}

/// "v2", or where values are of another version "v2; A1, B1: measured with v1; noise: version not recorded".
std::string version_words(const std::string& metric, int now, const std::map<std::string, json>& operators,
                          const json& changes) {
    std::map<std::string, std::string> marked;  // what is marked so
    const auto mark = [&](const json& version, const std::string& what) {
        const std::string words = version_mark(version, now);
        if (words.empty()) return;
        std::string& all = marked[words];
        all += (all.empty() ? "" : ", ") + what;
    };
    for (const auto& [task, document] : operators)
        if (const std::optional<json> version = version_in(document, metric)) mark(*version, task);
    if (const auto found = changes.find(metric); found != changes.end())
        mark(found->value("version", json()), "500 Hz and noise");
    std::string text = "v" + std::to_string(now);
    for (const auto& [words, what] : marked) text += "; " + what + ": " + words;
    return text;
}

std::string change_words(const json& changes, const std::string& metric, const char* change) {
    const auto found = changes.find(metric);
    if (found == changes.end() || !found->contains(change)) return "";
    const json& value = found->at(change);
    if (value.is_null()) return "absent";
    return value.get<double>() <= 1e-9 ? "–" : short_number(100 * value.get<double>(), 2) + " %";
}

const char* grade_words(EvidenceGrade grade) {
    switch (grade) {
        case EvidenceGrade::strong:
            return "strong";
        case EvidenceGrade::moderate:
            return "moderate";
        case EvidenceGrade::expert:
            return "reasoned";
    }
    return "";
}

void add_metrics(lab::ResultPage& page, const std::map<std::string, json>& operators, const json& changes) {
    page.heading("Metrics");
    page.paragraph(
        "AUC: chance that a random synthetic expert is better than a random synthetic novice; 0.5 is chance. "
        "In "
        "brackets: the metric describes and does not rate in that task. Retest: intraclass correlation of "
        "two attempts "
        "of the same individual. The last two columns: largest change where the same attempt is recorded "
        "with 500 "
        "samples a second, or with 2 um of noise in the tip. After the version of a metric: which values "
        "were "
        "measured with another one, or by a page that does not record it. In square brackets: how many "
        "experts "
        "and novices have a value, where not all have.");
    lab::ResultTable table;
    table.columns = {"metric", "what it is", "source, evidence"};
    for (const auto& [task, document] : operators) table.columns.push_back("AUC " + task);
    table.columns.insert(table.columns.end(), {"retest", "500 Hz", "noise"});
    for (const Metric& metric : metric_registry()) {
        const MetricDescriptor& d = metric.descriptor;
        std::vector<std::string> row = {
            "`" + d.id + "` (" + version_words(d.id, d.version, operators, changes) + ")", d.explanation,
            d.source + "; " + grade_words(d.grade)};
        std::string retest;
        bool shown = false;
        for (const auto& [task, document] : operators) {
            row.push_back(by_hand(document, d.id, "auc"));
            shown = shown || !row.back().empty();
            const std::string again = by_hand(document, d.id, "retest");
            if (!again.empty()) retest += (retest.empty() ? "" : "; ") + task + " " + again;
        }
        if (!shown) continue;
        row.push_back(retest);
        row.push_back(change_words(changes, d.id, "half_rate"));
        row.push_back(change_words(changes, d.id, "noise"));
        table.rows.push_back(std::move(row));
    }
    page.table(table);
}

/// Whether a gate's counts are of the metric as it is now; empty: they are.
std::string gate_version(const json& document, const std::string& metric) {
    const MetricDescriptor* now = find_metric(metric);
    const std::optional<json> version = version_in(document, metric);
    return now == nullptr || !version ? "" : version_mark(*version, now->version);
}

void add_gates(lab::ResultPage& page, const std::map<std::string, json>& operators) {
    page.heading("Gates");
    lab::ResultTable table;
    table.columns = {"task",           "gate", "hand",     "experts failed", "intermediates failed",
                     "novices failed", "of",   "kept for", "version"};
    for (const auto& [task, document] : operators)
        for (const json& gate : document.at("gates")) {
            const json& failed = gate.at("failed");
            table.rows.push_back(
                {task, gate.at("metric"), gate.at("hand").is_null() ? "" : gate.at("hand"),
                 std::to_string(failed.at(0).get<int>()), std::to_string(failed.at(1).get<int>()),
                 std::to_string(failed.at(2).get<int>()), std::to_string(document.at("seeds").get<int>()),
                 gate.at("safety").get<std::string>(), gate_version(document, gate.at("metric"))});
        }
    page.table(table);
    page.paragraph(
        "A gate that fails fewer than one novice in ten says what it is kept for: harm that must stop an "
        "attempt even if the synthetic novices seldom do it. Version: where the counts are not of the gate's "
        "metric as it is now.");
    page.heading("Passed");
    lab::ResultTable passed;
    passed.columns = {"task", "attempts of each group", "experts", "intermediates", "novices"};
    for (const auto& [task, document] : operators) {
        const int seeds = document.at("seeds").get<int>();
        std::vector<std::string> row = {task, std::to_string(seeds)};
        for (const json& count : document.at("passed"))
            row.push_back(short_number(100.0 * count.get<int>() / seeds, 3) + " %");
        passed.rows.push_back(std::move(row));
    }
    page.table(passed);
}

void add_cheats(lab::ResultPage& page) {
    page.heading("Known ways to game the scores");
    page.paragraph(
        "An expert who does one of these instead of the work passes no task where it changes something "
        "(tests/assessment/operators/cheats_test.cpp performs each).");
    lab::ResultTable table;
    table.columns = {"name", "what it does"};
    for (const Cheat& cheat : cheats()) table.rows.push_back({cheat.name, cheat.what});
    page.table(table);
}

}  // namespace

Measured validity_page(const std::string& folder) {
    std::map<std::string, json> operators;
    for (const std::string& task : tasks_in(folder))
        operators[task] = read_result(folder, "operators_" + task, "operators " + task, read_operators_page);
    const json invariance = read_result(folder, "lab_invariance", "invariance", read_invariance_page);
    Measured measured{lab::ResultPage("VALIDITY", "What each metric and gate is worth",
                                      "fulcrum lab validity FOLDER --output docs"),
                      {}};
    measured.page.paragraph(
        "All of this is measured on synthetic operators, whose presets are made so that experts are "
        "steadier, faster and "
        "gentler. It shows that tasks and metrics tell the presets apart, not yet that they tell people "
        "apart.");
    try {
        add_metrics(measured.page, operators, invariance.at("metrics"));
        add_gates(measured.page, operators);
    } catch (const json::exception& wrong) {
        throw InputError(folder, "", std::string("results of another version: ") + wrong.what(),
                         "make them again with fulcrum lab operators and fulcrum lab invariance");
    }
    add_cheats(measured.page);
    measured.document = {{"tasks", operators.size()}};
    return measured;
}

}  // namespace fulcrum::app
