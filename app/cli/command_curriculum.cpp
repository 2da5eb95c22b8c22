// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum curriculum rule, fit, agreement and fulcrum benchmark statistics: the statistics of the platform on
// values from elsewhere (docs/FORMATS.md, Statistics).
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>

#include "app/cli/commands.h"
#include "app/cli/statistics_json.h"
#include "assessment/learning/learning_curve.h"
#include "assessment/learning/pass_rule.h"
#include "assessment/learning/statistics.h"
#include "assessment/trace/csv_reader.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t most_rows = 100000;

double number_of(std::string_view text, bool& ok) {
    const std::string word(text);
    char* rest = nullptr;
    const double value = std::strtod(word.c_str(), &rest);
    ok = !word.empty() && *rest == '\0' && std::isfinite(value);
    return value;
}

/// The named columns of a CSV file with a header row, as text.
struct Columns {
    std::vector<std::vector<std::string>> rows;

    Columns(const std::string& path, const std::vector<std::string>& names) {
        std::ifstream file(path);
        if (!file)
            throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "cannot be read"),
                             QT_TRANSLATE_NOOP("errors", "give a CSV file with a header row"));
        CsvReader reader(file, path);
        std::vector<std::size_t> at(names.size());
        if (!reader.next())
            reader.fail_at(1, names[0], QT_TRANSLATE_NOOP("errors", "the file is empty"),
                           QT_TRANSLATE_NOOP("errors", "begin with a row of names"));
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto& cells = reader.cells();
            const auto found = std::find(cells.begin(), cells.end(), names[i]);
            if (found == cells.end())
                reader.fail(names[i], QT_TRANSLATE_NOOP("errors", "the column is missing"),
                            QT_TRANSLATE_NOOP("errors", "add it to the first row"));
            at[i] = static_cast<std::size_t>(found - cells.begin());
        }
        const std::size_t width = reader.cells().size();
        while (reader.next()) {
            if (reader.cells().size() != width)
                reader.fail("(row)", {QT_TRANSLATE_NOOP("errors", "%1 cells"), reader.cells().size()},
                            {QT_TRANSLATE_NOOP("errors", "write %1 cells, as in the first row"), width});
            if (rows.size() == most_rows)
                reader.fail("(row)", QT_TRANSLATE_NOOP("errors", "too many rows"),
                            QT_TRANSLATE_NOOP("errors", "give at most 100,000"));
            std::vector<std::string> row;
            for (const std::size_t column : at) row.emplace_back(reader.cells()[column]);
            rows.push_back(std::move(row));
        }
    }
    double number(const std::string& path, std::size_t row, std::size_t column, const char* name) const {
        bool ok = false;
        const double value = number_of(rows[row][column], ok);
        if (!ok)
            throw InputError(
                path, std::to_string(row + 2) + ": " + name,
                {QT_TRANSLATE_NOOP("errors", "%1 is not a number"), CsvReader::quoted(rows[row][column])},
                QT_TRANSLATE_NOOP("errors", "write a finite number"));
        return value;
    }
};

double chance_of(const std::string& text) {
    bool ok = false;
    const double q = number_of(text, ok);
    if (!ok || q < 0 || q > 1)
        throw UsageError("--q", {QT_TRANSLATE_NOOP("errors", "'%1' is not a probability"), text},
                         QT_TRANSLATE_NOOP("errors", "give a number from 0 to 1"));
    return q;
}

int run_rule(const Arguments& arguments) {
    for (const char* needed : {"--rule", "--q"})
        if (!arguments.has(needed))
            throw UsageError(needed, QT_TRANSLATE_NOOP("errors", "is missing"),
                             QT_TRANSLATE_NOOP("errors", "see fulcrum curriculum rule --help"));
    const PassRule rule = parse_pass_rule(*arguments.value("--rule"));
    if (const auto never = why_never_met(rule, 1)) throw UsageError("--rule", never->problem, never->hint);
    const double q = chance_of(*arguments.value("--q"));
    const auto attempts = static_cast<int>(arguments.integer("--attempts", 30, 1, 1000));
    const OperatingPoint point = operating_point(rule, q, attempts);
    if (arguments.has("--json")) {
        print_json({{"declared", point.declared},
                    {"mean_attempts_if_declared", or_null(point.mean_attempts_if_declared)},
                    {"median_attempts", or_null(point.median_attempts)}});
        return 0;
    }
    std::cout << "proficient within " << attempts << " attempts: " << 100 * point.declared
              << " % of trainees\n";
    if (point.mean_attempts_if_declared)
        std::cout << "these need " << *point.mean_attempts_if_declared << " attempts on average\n";
    std::cout << "half of all trainees within: "
              << (point.median_attempts ? std::to_string(*point.median_attempts) + " attempts" : "never")
              << '\n';
    return 0;
}

int run_fit(const Arguments& arguments) {
    const std::string path = arguments.words()[0];
    const Columns columns(path, {"x", "y"});
    std::vector<double> values;
    for (std::size_t i = 0; i < columns.rows.size(); ++i) {
        if (columns.number(path, i, 0, "x") != static_cast<double>(i + 1))
            throw InputError(path, std::to_string(i + 2) + ": x",
                             {QT_TRANSLATE_NOOP("errors", "is not %1"), i + 1},
                             QT_TRANSLATE_NOOP("errors", "number the attempts 1, 2, 3, ... in order"));
        values.push_back(columns.number(path, i, 1, "y"));
    }
    const std::vector<CurveFit> fits = fit_curves(values);
    if (fits.empty())
        throw InputError(path, "",
                         {QT_TRANSLATE_NOOP("errors", "%1 attempts are too few for a curve"), values.size()},
                         {QT_TRANSLATE_NOOP("errors", "give at least %1"), fewest_attempts_of_a_curve});
    const CurveFit& best = best_curve(fits);
    if (arguments.has("--json")) {
        print_json(curves_json(fits));
        return 0;
    }
    const auto end = [](const std::optional<double>& value) {
        return value ? nlohmann::json(*value).dump() : std::string("open");
    };
    for (const CurveFit& fit : fits)
        std::cout << curve_model_name(fit.model) << ": levels off at " << fit.plateau << " ("
                  << end(fit.plateau_low) << " to " << end(fit.plateau_high) << "), AICc " << fit.aicc
                  << (&fit == &best ? ", best\n" : "\n");
    return 0;
}

/// `ratings[target][rater]`, in the order of first mention.
std::vector<std::vector<double>> table_of(const std::string& path) {
    const Columns columns(path, {"target", "rater", "score"});
    std::vector<std::string> targets, raters;
    const auto index = [](std::vector<std::string>& names, const std::string& name) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
        names.push_back(name);
        return names.size() - 1;
    };
    std::map<std::pair<std::size_t, std::size_t>, double> cells;
    for (std::size_t i = 0; i < columns.rows.size(); ++i) {
        const auto cell =
            std::make_pair(index(targets, columns.rows[i][0]), index(raters, columns.rows[i][1]));
        if (!cells.emplace(cell, columns.number(path, i, 2, "score")).second)
            throw InputError(path, std::to_string(i + 2) + ": rater",
                             {QT_TRANSLATE_NOOP("errors", "%1 has rated %2 twice"), columns.rows[i][1],
                              columns.rows[i][0]},
                             QT_TRANSLATE_NOOP("errors", "give one score for each target and rater"));
    }
    std::vector<std::vector<double>> table(targets.size(), std::vector<double>(raters.size()));
    for (std::size_t t = 0; t < targets.size(); ++t) {
        for (std::size_t r = 0; r < raters.size(); ++r) {
            const auto found = cells.find({t, r});
            if (found == cells.end())
                throw InputError(
                    path, "",
                    {QT_TRANSLATE_NOOP("errors", "there is no score of %1 by %2"), targets[t], raters[r]},
                    QT_TRANSLATE_NOOP("errors", "every rater must have rated every target"));
            table[t][r] = found->second;
        }
    }
    return table;
}

int run_agreement(const Arguments& arguments) {
    const std::string path = arguments.words()[0];
    const std::vector<std::vector<double>> table = table_of(path);
    nlohmann::json agreement;
    try {
        agreement = agreement_json(table);
    } catch (const std::invalid_argument& error) {
        throw InputError(
            path, "", error.what(),
            QT_TRANSLATE_NOOP("errors", "give scores of two or more raters on two or more targets"));
    }
    if (arguments.has("--json")) {
        print_json(agreement);
        return 0;
    }
    for (const auto& [name, one] : agreement["icc"].items())
        std::cout << "ICC(" << name << ") " << one["value"] << " (" << one["low"] << " to " << one["high"]
                  << ")\n";
    std::cout << "Cronbach alpha " << agreement["cronbach_alpha"] << '\n';
    return 0;
}

int run_statistics(const Arguments& arguments) {
    const std::string path = arguments.words()[0];
    const bool logarithm = arguments.value_or("--scale", "raw") == "ln";
    const Columns columns(path, {"expert", "value"});
    std::vector<ExpertValues> experts;
    for (std::size_t i = 0; i < columns.rows.size(); ++i) {
        double value = columns.number(path, i, 1, "value");
        if (logarithm && value <= 0)
            throw InputError(path, std::to_string(i + 2) + ": value",
                             QT_TRANSLATE_NOOP("errors", "has no logarithm"),
                             QT_TRANSLATE_NOOP("errors", "give values above 0, or --scale raw"));
        value = logarithm ? std::log(value) : value;
        const std::string& name = columns.rows[i][0];
        const auto found = std::find_if(experts.begin(), experts.end(),
                                        [&](const ExpertValues& one) { return one.expert == name; });
        if (found == experts.end()) {
            experts.push_back({name, {value}});
        } else {
            found->values.push_back(value);
        }
    }
    const std::optional<ExpertBenchmark> benchmark = expert_benchmark(experts, 2);
    if (!benchmark)
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "fewer than 2 experts are left"),
                         QT_TRANSLATE_NOOP("errors", "give the values of more experts"));
    nlohmann::json dropped = nlohmann::json::array();
    std::set<std::string> left_out;
    for (const LeftOutExpert& one : benchmark->left_out) {
        dropped.push_back(one.expert);
        left_out.insert(one.expert);
    }
    std::size_t attempts = 0;
    for (const ExpertValues& one : experts)
        attempts += left_out.count(one.expert) > 0 ? 0 : one.values.size();
    if (arguments.has("--json")) {
        print_json({{"mean", benchmark->mean},
                    {"sd", benchmark->deviation},
                    {"dropped", dropped},
                    {"experts", benchmark->experts},
                    {"attempts", attempts}});
        return 0;
    }
    std::cout << "mean " << benchmark->mean << ", standard deviation of an attempt " << benchmark->deviation
              << ", " << benchmark->experts << " experts, " << attempts << " attempts\n";
    for (const LeftOutExpert& one : benchmark->left_out)
        std::cout << "left out: " << one.expert << ", mean " << one.mean << '\n';
    return 0;
}

}  // namespace

std::vector<Command> statistics_commands() {
    return {
        {"curriculum rule",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP("commands",
                           "Prints how likely a rule declares a trainee proficient who passes each attempt "
                           "with the same chance. Learning and the condition of two days are left out."),
         {{"--rule", "RULE", QT_TRANSLATE_NOOP("commands", "row:K, of:K,N or lc-cusum:P0,P1,H.")},
          {"--q", "Q", QT_TRANSLATE_NOOP("commands", "The chance of a pass, from 0 to 1.")},
          {"--attempts", "N", QT_TRANSLATE_NOOP("commands", "The number of attempts, from 1 to 1000."), "30"},
          json_option()},
         run_rule},
        {"curriculum fit",
         "VALUES.csv",
         1,
         1,
         QT_TRANSLATE_NOOP("commands",
                           "Fits learning curves to the values of attempts 1, 2, 3, ...: columns x and y."),
         {json_option()},
         run_fit},
        {"curriculum agreement",
         "RATINGS.csv",
         1,
         1,
         QT_TRANSLATE_NOOP("commands", "Prints how far raters agree: columns target, rater and score."),
         {json_option()},
         run_agreement},
        {"benchmark statistics",
         "VALUES.csv",
         1,
         1,
         QT_TRANSLATE_NOOP("commands",
                           "Prints mean and standard deviation of experts as a benchmark set uses them: "
                           "columns expert and value."),
         {{"--scale",
           "SCALE",
           QT_TRANSLATE_NOOP("commands", "The scale of the values."),
           "raw",
           {"raw", "ln"}},
          json_option()},
         run_statistics}};
}

}  // namespace fulcrum::app
