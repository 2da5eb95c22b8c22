// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum people erase: a person of a programme without a server is erased at its station.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "database/sync/station_erasure.h"

namespace fulcrum::app {
namespace {

int erase(const Arguments& arguments) {
    const bool dry = arguments.has("--dry-run");
    const auto reason = arguments.value("--reason");
    if (!reason && !dry)
        throw UsageError("--reason", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "say why: it is stored in the audit log"));
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const std::string& named = arguments.words()[0];
    const auto person = database::People(store).find_login(session, named);
    const std::string id = person ? person->id : named;
    const std::vector<database::ErasedRows> rows =
        database::erase_person(store, session, id, reason.value_or(""), dry);
    if (arguments.has("--json")) {
        nlohmann::json tables = nlohmann::json::object();
        for (const database::ErasedRows& one : rows) tables[one.table] = one.rows;
        print_json({{"store", store_path(arguments)}, {"person", id}, {"dry_run", dry}, {"rows", tables}});
        return 0;
    }
    for (const database::ErasedRows& one : rows) std::cout << one.table << ": " << one.rows << " rows\n";
    if (dry)
        std::cout << "would be erased; nothing was changed\n";
    else
        std::cout
            << "erased; " << database::erasure_list_path(store.station_id())
            << " names the id, so that a restored backup erases the person again: keep a copy of it with "
               "the backups\n";
    return 0;
}

}  // namespace

Command erase_command() {
    Command erasing{"people erase",
                    "LOGIN",
                    1,
                    1,
                    "Erases a person of a programme without a server; needs --as, a director.",
                    joined({{"--dry-run", "", "Only show what would be erased."},
                            {"--reason", "TEXT", "Why; stored in the audit log."}},
                           session_options()),
                    erase};
    erasing.details =
        "LOGIN is a login or an id. Name, login, password, cohorts, attempts with traces and scores, "
        "comments "
        "by and about the person and what the audit log says of them are deleted; accounts that were merged "
        "into the person too. The rows of the audit log stay, and a row \"Erased person\" where others' "
        "records "
        "name the person. This cannot be undone. A programme with a server erases there (`server erase`).";
    return erasing;
}

}  // namespace fulcrum::app
