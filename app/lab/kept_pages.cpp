// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/kept_pages.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <vector>

#include "assessment/metrics/invariance.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

using nlohmann::json;
using Cells = std::vector<std::string>;

/// The rows below the heading whose first cells are these, as a Markdown table has them.
std::vector<Cells> table_of(const std::string& text, const Cells& first_cells, const std::string& path) {
    std::vector<Cells> rows;
    bool inside = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] != '|') {
            if (inside) break;
            continue;
        }
        Cells cells;
        std::istringstream row(line.substr(1));
        for (std::string cell; std::getline(row, cell, '|');) {
            const std::size_t begin = cell.find_first_not_of(' '), end = cell.find_last_not_of(' ');
            cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
        }
        if (!inside) {
            inside = cells.size() >= first_cells.size() &&
                     std::equal(first_cells.begin(), first_cells.end(), cells.begin());
        } else if (line.find("---") == std::string::npos ||
                   line.find_first_not_of("|- ") != std::string::npos) {
            rows.push_back(std::move(cells));
        }
    }
    if (rows.empty())
        throw InputError(path, "", "no table of " + first_cells.back() + " by " + first_cells.front(),
                         "make the page again with fulcrum-lab");
    return rows;
}

json number_or_null(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return end == text.c_str() ? json() : json(value);
}

/// "60, 58, 43"; null where the page has no such column.
json counts_or_null(const std::string& text) {
    json counts = json::array();
    std::istringstream cells(text);
    for (std::string cell; std::getline(cells, cell, ',');) {
        const json count = number_or_null(cell);
        if (!count.is_null()) counts.push_back(static_cast<int>(count.get<double>()));
    }
    return counts.empty() ? json() : counts;
}

json version_or_null(const std::string& text) {
    const json number = number_or_null(text);
    return number.is_null() ? json() : json(static_cast<int>(number.get<double>()));
}

json text_or_null(const std::string& text) {
    return text.empty() ? json() : json(text);
}

/// The whole numbers that follow `mark`, separated by commas.
std::vector<int> counts_after(const std::string& text, const std::string& mark, const std::string& path) {
    std::vector<int> counts;
    const std::size_t found = text.find(mark);
    if (found != std::string::npos) {
        std::istringstream rest(text.substr(found + mark.size(), 60));
        char comma = ',';
        for (int count = 0; comma == ',' && rest >> count;) {
            counts.push_back(count);
            if (!(rest >> comma)) break;
        }
    }
    if (counts.empty())
        throw InputError(path, "", "no numbers after '" + mark + "'", "make the page again with fulcrum-lab");
    return counts;
}

void require_cells(const Cells& row, std::size_t count, const std::string& path) {
    if (row.size() != count)
        throw InputError(path, "",
                         "a row has " + std::to_string(row.size()) + " cells, not " + std::to_string(count),
                         "make the page again with fulcrum-lab");
}

}  // namespace

json read_operators_page(const std::string& text, const std::string& path) {
    json metrics = json::array(), gates = json::array();
    constexpr std::size_t before_versions = 10, cells = 12;
    for (const Cells& row : table_of(text, {"metric", "hand", "better", "AUC"}, path)) {
        const bool old = row.size() == before_versions;
        require_cells(row, old ? before_versions : cells, path);
        metrics.push_back({{"metric", row[0]},
                           {"hand", text_or_null(row[1])},
                           {"auc", number_or_null(row[3])},
                           {"retest", number_or_null(row[6])},
                           {"separates", row[5] == cell_context ? json() : json(row[5] == cell_yes)},
                           {"values", old ? json() : counts_or_null(row[10])},
                           {"version", old ? json() : version_or_null(row[11])}});
    }
    for (const Cells& row : table_of(text, {"gate", "hand", "experts failed"}, path)) {
        require_cells(row, 6, path);
        const bool reason = row[5] != cell_yes && row[5] != cell_no_reason;
        const json failed = {number_or_null(row[2]), number_or_null(row[3]), number_or_null(row[4])};
        gates.push_back({{"metric", row[0]},
                         {"hand", text_or_null(row[1])},
                         {"failed", failed},
                         {"safety", reason ? row[5] : ""}});
    }
    return {{"metrics", metrics},
            {"gates", gates},
            {"seeds", counts_after(text, "\nOf ", path).front()},
            {"passed", counts_after(text, "; passed: ", path)}};
}

json read_invariance_page(const std::string& text, const std::string& path) {
    json metrics = json::object();
    for (const Cells& row : table_of(text, {"metric", trace_changes[0].title}, path)) {
        constexpr std::size_t before_versions = 1 + std::size(trace_changes);
        const bool old = row.size() == before_versions;
        require_cells(row, old ? before_versions : before_versions + 1, path);
        metrics[row[0]]["version"] = old ? json() : version_or_null(row.back());
        for (std::size_t k = 0; k < std::size(trace_changes); ++k) {
            const std::string& cell = row[k + 1];
            const json percent = number_or_null(cell);
            metrics[row[0]][trace_changes[k].name] = cell == "–"         ? json(0.0)
                                                     : percent.is_null() ? json()
                                                                         : json(0.01 * percent.get<double>());
        }
    }
    return {{"metrics", metrics}};
}

}  // namespace fulcrum::app
