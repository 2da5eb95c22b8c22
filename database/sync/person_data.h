// SPDX-License-Identifier: GPL-3.0-or-later
// All that this store holds about one person, as a folder for that person: index.html says what is there in
// words, tables/*.csv has every row of every table that an erasure of the person would touch, traces/*.csv.gz
// the recordings. The password is not in it, nor what is stored about others.
#pragma once

#include <string>
#include <vector>

#include "database/store/store.h"
#include "database/sync/programme_server.h"

namespace fulcrum::database {

/// What a table's rows are, for a reader: "scores", "comments by and about the person".
Sentence title_of_table(const std::string& table);

struct PersonDataExport {
    std::vector<ErasedRows> rows;  ///< by table, without the empty ones
    int traces = 0;
    bool stopped = false;  ///< nothing was written or counted then
};

/// `folder`: a new name in a folder that exists; it has that name only when it is complete. Empty: a dry run,
/// which counts. `words`: of the index. With the person go the accounts that were merged into them. Audited,
/// with the folder's name. Operation::export_all. Throws StoreError exists, read_only, disk_full; locked
/// where another export writes to that name.
PersonDataExport export_person_data(const Store& store, const Session& director, const std::string& person_id,
                                    const std::string& folder, const StoreProgress& progress = {},
                                    Translate words = in_english);

}  // namespace fulcrum::database
