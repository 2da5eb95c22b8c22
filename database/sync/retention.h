// SPDX-License-Identifier: GPL-3.0-or-later
// How long a programme keeps the data of trainees: so many months after the last practice or sign-in. Who is
// due is listed; a director erases them after looking at the list, never the program by itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/store/store.h"
#include "database/sync/programme_server.h"

namespace fulcrum::database {

inline constexpr int longest_retention = 600;  ///< months

/// Empty: no end is set.
std::optional<int> retention_months(const Store& store);
/// 1 to longest_retention; empty: nobody becomes due. Audited. Operation::erase_person.
void set_retention_months(const Store& store, const Session& director, const std::optional<int>& months);

struct DuePerson {
    std::string id, login, display_name;
    UtcMilliseconds last = 0;  ///< the newest of attempt, sign-in and the making of the account
    std::int64_t attempts = 0;
};
/// Trainees with no other role whose last practice is longer ago than the programme keeps data, the longest
/// ago first; with what was merged into them. Empty where no end is set. Operation::erase_person.
std::vector<DuePerson> people_due(const Store& store, const Session& director);

/// Erases these people, each as erase_person() does, with the reason that their time is over; only those who
/// are still due. Cut off, those who are left are due as before. Returns whom it erased. Throws StoreError
/// conflict where one of them is not due any more, before anybody is erased; as erase_person().
std::vector<std::string> erase_due(const Store& store, const Session& director,
                                   const std::vector<std::string>& person_ids,
                                   const StoreProgress& progress = {});

}  // namespace fulcrum::database
