// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/reports_large_page.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim_core/lab/result_page.h"

namespace fulcrum::app::program_test {
namespace {

constexpr const char* reports_variable = "FULCRUM_REPORTS_PAGE";
constexpr const char* reports_page_id = "reports_large";

std::optional<double> reports_seconds_in(const nlohmann::json& row, const char* name) {
    const auto found = row.find(name);
    if (found == row.end() || !found->is_number()) return std::nullopt;
    return found->get<double>();
}

/// What was entered before at this commit; a file that cannot be read has nothing.
std::vector<ReportsRow> reports_rows_in(const std::string& folder, const std::string& commit) {
    std::ifstream file(std::filesystem::path(folder) / (std::string(reports_page_id) + ".json"));
    const nlohmann::json document = nlohmann::json::parse(file, nullptr, false);
    std::vector<ReportsRow> rows;
    if (!document.is_object() || !document.contains("rows") || !document["rows"].is_array()) return rows;
    for (const nlohmann::json& one : document["rows"]) {
        if (!one.is_object() || one.value("commit", std::string()) != commit) continue;
        ReportsRow row;
        row.what = one.value("what", std::string());
        row.trainees = one.value("trainees", 0);
        row.attempts = one.value("attempts", 0);
        row.metrics = one.value("metrics", 0);
        row.station_s = reports_seconds_in(one, "station_s");
        row.server_s = reports_seconds_in(one, "server_s");
        row.limit_s = reports_seconds_in(one, "limit_s");
        rows.push_back(std::move(row));
    }
    return rows;
}

/// In the order in which they were measured first, those with few metrics first.
void put_reports_row(std::vector<ReportsRow>& rows, const ReportsRow& row) {
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const ReportsRow& one) {
        return one.what == row.what && one.metrics == row.metrics;
    });
    if (same != rows.end())
        *same = row;
    else
        rows.push_back(row);
    std::stable_sort(rows.begin(), rows.end(),
                     [](const ReportsRow& a, const ReportsRow& b) { return a.metrics < b.metrics; });
}

nlohmann::json reports_document(const std::vector<ReportsRow>& rows, const std::string& commit) {
    const auto number = [](const std::optional<double>& seconds) {
        return seconds ? nlohmann::json(*seconds) : nlohmann::json();
    };
    nlohmann::json list = nlohmann::json::array();
    for (const ReportsRow& row : rows)
        list.push_back({{"what", row.what},
                        {"trainees", row.trainees},
                        {"attempts", row.attempts},
                        {"metrics", row.metrics},
                        {"station_s", number(row.station_s)},
                        {"server_s", number(row.server_s)},
                        {"limit_s", number(row.limit_s)},
                        {"commit", commit}});
    nlohmann::json document;
    document["rows"] = std::move(list);
    return document;
}

std::string reports_time(const std::optional<double>& seconds) {
    if (!seconds) return "–";
    char text[32];
    std::snprintf(text, sizeof text, "%.2f s", *seconds);
    return text;
}

/// "5 s", and of a smaller programme "0.45 s".
std::string reports_limit(const std::optional<double>& seconds) {
    if (!seconds) return "–";
    char text[32];
    std::snprintf(text, sizeof text, "%.3g s", *seconds);
    return text;
}

lab::ResultTable reports_table(const std::vector<ReportsRow>& rows) {
    lab::ResultTable table;
    table.name = reports_page_id;
    table.columns = {"what", "station", "server", "limit", "trainees", "attempts each", "metrics an attempt"};
    for (const ReportsRow& row : rows)
        table.rows.push_back({row.what, reports_time(row.station_s), reports_time(row.server_s),
                              reports_limit(row.limit_s), std::to_string(row.trainees),
                              std::to_string(row.attempts), std::to_string(row.metrics)});
    return table;
}

/// Empty where no row has a limit.
std::string reports_verdict(const std::vector<ReportsRow>& rows) {
    std::string over;
    bool limited = false;
    for (const ReportsRow& row : rows) {
        if (!row.limit_s) continue;
        limited = true;
        const double longest = std::max(row.station_s.value_or(0), row.server_s.value_or(0));
        if (longest > *row.limit_s) over += (over.empty() ? "" : "; ") + row.what;
    }
    if (!limited) return {};
    return over.empty() ? "Every time that has a limit is within it." : "Over the limit: " + over + ".";
}

}  // namespace

void enter_reports(const std::vector<ReportsRow>& measured) {
    const char* const folder = std::getenv(reports_variable);
    if (folder == nullptr || measured.empty()) return;
    const lab::Machine machine = lab::this_machine(lab::build_info());
    std::vector<ReportsRow> rows = reports_rows_in(folder, machine.build.commit);
    for (const ReportsRow& row : measured) put_reports_row(rows, row);
    lab::ResultPage page(reports_page_id, "Reports of a large programme",
                         "FULCRUM_REPORT_TRAINEES=200 FULCRUM_REPORT_ATTEMPTS=300 " +
                             std::string(reports_variable) +
                             "=docs/results xvfb-run -a -s '-screen 0 1280x800x24' test_app "
                             "--gtest_filter=ServerReportsLarge*");
    page.paragraph(
        "One cohort in a station's store and, after an exchange, at a programme server (PostgreSQL) on the "
        "same machine. Its trainees have assessed attempts of all tasks, each with nine gates, the metrics "
        "of its row and the digests of three files. Each time is by the clock. *Grid and dashboard* is the "
        "query behind both, and what the dashboard makes of it; an educator's account has it from the "
        "server alone, whose row policies look at each row. *Grid in the window* is from a director's "
        "click on *Cohorts* in the program's window until the grid with everyone's row is painted; the "
        "dashboard, where a director begins, was shown before. The reports are those of the whole cohort, "
        "written to a file; the PDF has pages for everyone. Statements for a record store have every "
        "metric of an attempt: the row with most metrics has as many as an attempt of the delivered "
        "demonstration on average, without a limit. –: not measured, or no limit.");
    page.table(reports_table(rows));
    const std::string verdict = reports_verdict(rows);
    if (!verdict.empty()) page.paragraph(verdict);
    page.document(reports_document(rows, machine.build.commit));
    page.write(folder, machine);
}

}  // namespace fulcrum::app::program_test
