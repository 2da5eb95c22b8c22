// SPDX-License-Identifier: GPL-3.0-or-later
// Erasing a person: name, login, verifier, roles, memberships, attempts with all that belongs to them,
// comments about and by them, and what audit rows say of them. The rows of the audit log stay, and a row
// "Erased person" stays where others' records name the person (who voided an attempt, who rated it).
#pragma once

#include <set>
#include <string>
#include <vector>

#include "database/rows/connection.h"
#include "database/store/store.h"
#include "database/sync/programme_server.h"

namespace fulcrum::database {

/// Rows about people: each ? of `where` is the person.
struct RowsAbout {
    const char* table;
    const char* where;
};
/// In the order in which an erasure deletes them; an export of a person's data reads the same.
const std::vector<RowsAbout>& rows_about_people();
/// A statement with the person in place of each ?.
Query about_person(Connection& connection, const std::string& sql, const std::string& person_id);
/// Ids of what audit rows are about when they are about this person.
std::set<std::string> audit_objects_of(Connection& connection, const std::string& person_id);

/// What an erasure would delete on this side, by table, without the empty ones. Throws
/// StoreError not_found.
std::vector<ErasedRows> rows_to_erase(Connection& connection, const std::string& person_id);
/// At the server: enters the person into the list of erasures and deletes.
void erase_on_server(Connection& server, const std::string& person_id, std::int64_t time);
/// At a station, audited: this person alone, as the server's list names each. False if there is nothing to
/// erase. Throws StoreError locked while the person performs.
bool erase_at_station(const Store& store, const std::string& person_id, const Session& actor,
                      const std::string& reason);
/// The person, and those that were merged into it: one person's data under several ids.
std::vector<std::string> with_merged(Connection& connection, const std::string& person_id);
/// Who was merged into a person at a station while the server, which did not know of it, erased that person:
/// their data is there until the owner of the server erases them too. Only the server's list deletes, so that
/// no merge at a station, right or wrong, ends in a deletion.
std::vector<Sentence> merged_into_erased(Connection& connection);

}  // namespace fulcrum::database
