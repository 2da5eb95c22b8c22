// SPDX-License-Identifier: GPL-3.0-or-later
// The page reports_large: how long the reports of a large programme take from a station's store and from the
// programme server. Rows are entered in the folder that FULCRUM_REPORTS_PAGE names, and the page is written
// from all rows that are there and of the same commit: it can be made in parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fulcrum::app::program_test {

struct ReportsRow {
    std::string what;  ///< with the number of metrics the key: measured again, a row is replaced
    int trainees = 0;
    int attempts = 0;                           ///< of each trainee
    int metrics = 0;                            ///< of each attempt
    std::optional<double> station_s, server_s;  ///< by the clock; none: not measured
    std::optional<double> limit_s;              ///< of each of the two; none: no limit
};

/// Enters nothing unless a folder is named.
void enter_reports(const std::vector<ReportsRow>& rows);

}  // namespace fulcrum::app::program_test
