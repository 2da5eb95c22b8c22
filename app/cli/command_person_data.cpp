// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum people export: a copy of all that is stored about a person. fulcrum people retention: how long data
// are kept, and who is due to be erased.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "database/sync/person_data.h"
#include "database/sync/retention.h"

namespace fulcrum::app {
namespace {

int export_person(const Arguments& arguments) {
    const bool dry = arguments.has("--dry-run");
    const std::string folder = arguments.value_or("--output", "");
    if (folder.empty() && !dry)
        throw UsageError("--output", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "name a new folder for the files"));
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const std::string& named = arguments.words()[0];
    const auto person = database::People(store).find_login(session, named);
    const std::string id = person ? person->id : named;
    const database::PersonDataExport done =
        database::export_person_data(store, session, id, dry ? std::string() : folder);
    if (arguments.has("--json")) {
        nlohmann::json tables = nlohmann::json::object();
        for (const database::ErasedRows& one : done.rows) tables[one.table] = one.rows;
        print_json({{"store", store_path(arguments)},
                    {"person", id},
                    {"dry_run", dry},
                    {"folder", dry ? nlohmann::json() : nlohmann::json(folder)},
                    {"recordings", done.traces},
                    {"rows", tables}});
        return 0;
    }
    for (const database::ErasedRows& one : done.rows)
        std::cout << one.table << ": " << one.rows << " rows (" << database::title_of_table(one.table).words()
                  << ")\n";
    std::cout << "recordings: " << done.traces << '\n';
    if (dry)
        std::cout << "would be written; nothing was\n";
    else
        std::cout << "wrote " << folder << "; it is confidential: give it to the person, and delete it\n";
    return 0;
}

nlohmann::json json_of(const database::DuePerson& one) {
    return {{"id", one.id},
            {"login", one.login},
            {"name", one.display_name},
            {"last", database::iso_utc(one.last)},
            {"attempts", one.attempts}};
}

/// Who is due must be who was looked at: their number is said again.
int erase_people_due(const Arguments& arguments, const database::Store& store,
                     const database::Session& session) {
    const std::vector<database::DuePerson> due = database::people_due(store, session);
    const std::int64_t expected = arguments.integer("--erase", 1, 1, 1000000);
    if (static_cast<std::int64_t>(due.size()) != expected)
        throw UsageError(
            "--erase", {QT_TRANSLATE_NOOP("errors", "%1 people are due, not %2"), due.size(), expected},
            QT_TRANSLATE_NOOP("errors", "look at the list again (without --erase), then give its number"));
    std::vector<std::string> ids;
    for (const database::DuePerson& one : due) ids.push_back(one.id);
    const std::vector<std::string> erased = database::erase_due(store, session, ids);
    if (arguments.has("--json"))
        print_json({{"store", store_path(arguments)}, {"erased", erased}});
    else
        std::cout << "erased " << erased.size() << " people; the audit log has each\n";
    return 0;
}

int retention(const Arguments& arguments) {
    int asked = 0;
    for (const char* option : {"--months", "--off", "--erase"}) asked += arguments.has(option) ? 1 : 0;
    if (asked > 1)
        throw UsageError("--erase", QT_TRANSLATE_NOOP("errors", "cannot be used with --months and --off"),
                         QT_TRANSLATE_NOOP("errors", "set the time first, then look at the list"));
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    if (arguments.has("--erase")) return erase_people_due(arguments, store, session);
    if (arguments.has("--off")) database::set_retention_months(store, session, std::nullopt);
    if (arguments.has("--months"))
        database::set_retention_months(
            store, session,
            static_cast<int>(arguments.integer("--months", 1, 1, database::longest_retention)));
    const std::optional<int> months = database::retention_months(store);
    const std::vector<database::DuePerson> due = database::people_due(store, session);
    if (arguments.has("--json")) {
        nlohmann::json list = nlohmann::json::array();
        for (const database::DuePerson& one : due) list.push_back(json_of(one));
        print_json({{"store", store_path(arguments)}, {"months", or_null(months)}, {"due", list}});
        return 0;
    }
    if (!months) {
        std::cout << "data are kept without an end\n";
        return 0;
    }
    std::cout << "data are kept for " << *months
              << " months after the last practice; due to be erased: " << due.size() << '\n';
    for (const database::DuePerson& one : due)
        std::cout << one.login << "  " << one.display_name << "  last " << database::iso_utc(one.last) << "  "
                  << one.attempts << " attempts\n";
    if (!due.empty()) std::cout << "`people retention --erase " << due.size() << "` erases them for good\n";
    return 0;
}

}  // namespace

std::vector<Command> person_data_commands() {
    Command exporting{
        "people export",
        "LOGIN",
        1,
        1,
        QT_TRANSLATE_NOOP("commands",
                          "Writes all that is stored about a person to a folder; needs --as, a director."),
        joined({{"--output",
                 "FOLDER",
                 QT_TRANSLATE_NOOP("commands", "A new folder; index.html says what is in it."),
                 "",
                 {},
                 "-o"},
                {"--dry-run", "", QT_TRANSLATE_NOOP("commands", "Only count what would be written.")}},
               session_options()),
        export_person};
    exporting.details = QT_TRANSLATE_NOOP(
        "commands",
        "LOGIN is a login or an id. Attempts with scores and recordings, comments, observer forms, "
        "decisions, "
        "goals and what the audit log has of the person are written as tables (CSV) and recordings (CSV, "
        "gzip), "
        "with those of accounts that were merged into the person. The audit log says that it was done.");
    Command keeping{
        "people retention",
        "",
        0,
        0,
        QT_TRANSLATE_NOOP("commands",
                          "Shows or sets how long data of trainees are kept, and who is due to be erased."),
        joined({{"--months", "N",
                 QT_TRANSLATE_NOOP("commands",
                                   "Keep data for so many months after the last practice or sign-in.")},
                {"--off", "", QT_TRANSLATE_NOOP("commands", "Set no end.")},
                {"--erase", "N",
                 QT_TRANSLATE_NOOP("commands", "Erase the N people who are due; N as the list has it.")}},
               session_options()),
        retention};
    keeping.details = QT_TRANSLATE_NOOP(
        "commands",
        "Needs --as, a director. Trainees with no other role are due, nobody else. Nobody is erased without "
        "--erase; it does what `people erase` does. A programme with a server erases there (`server "
        "erase`).");
    return {exporting, keeping};
}

}  // namespace fulcrum::app
