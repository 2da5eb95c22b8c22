// SPDX-License-Identifier: GPL-3.0-or-later
// What a programme gives to research: attempts of real people under ids drawn for this export, with days
// counted from each person's first attempt; no name, login, date, text, station, seed or device. Always the
// whole programme: two exports of overlapping cohorts could be subtracted.
#pragma once

#include <string>
#include <vector>

#include "database/store/store.h"

namespace fulcrum::database {

struct ResearchColumn {
    std::string name, unit, meaning;
};

struct ResearchTable {
    std::string name;  ///< of its file, without ending
    std::vector<ResearchColumn> columns;
    std::vector<std::vector<std::string>> rows;  ///< as they stand in a CSV file
};

struct ResearchExport {
    int people = 0, attempts = 0;  ///< exported
    int left_out = 0;              ///< attempts of tasks that fewer than least_people people performed
    std::vector<ResearchTable> tables;
    std::string csv(const ResearchTable& table) const;
    std::string dictionary() const;
};

/// The two tables of counts, taken alone, give no count below least_people; attempts and metrics are rows of
/// single people, from which smaller ones follow. Operation::export_cohort of the whole programme; audited
/// where the store is written. Throws AccessDenied, StoreError conflict with fewer than least_people people,
/// and at a station of some cohorts.
ResearchExport research_export(const Store& store, const Session& director);

/// A file for each table, and the dictionary, in a folder that exists; an export that is there is replaced
/// when all files of the new one are written. Returns their paths. Throws std::system_error.
std::vector<std::string> write_research_files(const ResearchExport& research, const std::string& folder);

}  // namespace fulcrum::database
