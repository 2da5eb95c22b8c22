// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum import: a trace that was recorded elsewhere becomes an external attempt of a person.
#include <QDateTime>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "database/scoring/external_import.h"
#include "database/store/audit.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

using database::ExternalAttempt;

/// Local time "2026-11-20 14:05", or with an offset "2026-11-20T14:05+01:00"; without the option now.
QDateTime performed_at(const Arguments& arguments, const database::Store& store) {
    const auto given = arguments.value("--performed");
    if (!given) return QDateTime::fromMSecsSinceEpoch(store.now());
    QString text = QString::fromStdString(*given).trimmed();
    QDateTime time = QDateTime::fromString(text.replace(QLatin1Char(' '), QLatin1Char('T')), Qt::ISODate);
    if (!time.isValid())
        throw UsageError("--performed",
                         {QT_TRANSLATE_NOOP("errors", "\"%1\" is not a date and time"), *given},
                         QT_TRANSLATE_NOOP("errors", "give it as 2026-11-20T14:05"));
    return time;
}

/// Its person: an external one of the station, or somebody of the cohorts of the educator who signed in.
/// Empty in a dry run where the station would make the person.
std::string person_of_import(const Arguments& arguments, const database::Store& store,
                             const database::Session& session) {
    const database::People people(store);
    if (!session.is_station()) return person_named(arguments, store, session);
    const std::string login = *arguments.value("--person");
    if (!arguments.has("--dry-run"))
        return people.ensure_synthetic(session, login, login, database::PersonKind::external).id;
    const auto known = people.find_login(session, login);
    return known ? known->id : std::string();
}

void print_import(const nlohmann::json& document) {
    std::size_t measured = 0;
    for (const auto& row : document["metrics"]) measured += row["value"].is_null() ? 0 : 1;
    std::cout << document["task"].get<std::string>() << " by " << document["person"].get<std::string>()
              << ", " << document["source"].get<std::string>() << ": " << document["samples"].dump()
              << " samples, " << document["duration_s"].dump() << " s, " << measured << " metric values\n";
    for (const auto& column : document["ignored_columns"])
        print_note({QT_TRANSLATE_NOOP("commands", "note: the column %1 is not mapped and was not read"),
                    column.get<std::string>()});
    for (const auto& gap : document["gaps"]) print_gap(gap[0].dump(), gap[1].dump());
    if (document["dry_run"] == true)
        std::cout << "dry run, nothing was stored\n";
    else
        std::cout << "external attempt " << document["attempt"].get<std::string>()
                  << ": measured, judged by no limits, counts towards no standing\n";
}

int run_import(const Arguments& arguments) {
    for (const char* option : {"--exercise", "--person"})
        if (!arguments.has(option))
            throw UsageError(
                option, QT_TRANSLATE_NOOP("errors", "is missing"),
                QT_TRANSLATE_NOOP("errors", "name the exercise and the person who performed it"));
    const ExternalTrace read = read_external_trace(
        arguments.words()[0], arguments.value_or("--mapping", ""));  // errors before a store is opened
    const database::Store store =
        open_store(arguments, !arguments.has("--as") && !arguments.has("--dry-run"));
    const database::Session session = session_of(arguments, store);
    const QDateTime performed = performed_at(arguments, store);
    ExternalAttempt attempt = external_attempt(read);
    attempt.exercise = *arguments.value("--exercise");
    attempt.source = arguments.value_or("--source", attempt.source);
    attempt.performed = performed.toMSecsSinceEpoch();
    attempt.utc_offset_min = performed.offsetFromUtc() / 60;
    const database::ExternalAttempts imports(store);
    imports.check_values(attempt);  // before a person is made for it
    attempt.person_id = person_of_import(arguments, store, session);
    nlohmann::json document = read.document;
    document["attempt"] = nullptr;
    if (arguments.has("--dry-run")) {
        if (!attempt.person_id.empty()) imports.check(session, attempt);
    } else {
        document["attempt"] = imports.add(session, attempt);
    }
    document.update({{"dry_run", arguments.has("--dry-run")},
                     {"person", *arguments.value("--person")},
                     {"task", database::external_task_prefix + attempt.exercise},
                     {"device_class", row_of(device_classes, DeviceClass::external).name},
                     {"source", attempt.source},
                     {"performed", database::iso_utc(attempt.performed)}});
    if (arguments.has("--json")) {
        print_json(document);
    } else {
        print_import(document);
    }
    return 0;
}

}  // namespace

Command import_command() {
    return {
        "import",
        "TRACE.csv",
        1,
        1,
        QT_TRANSLATE_NOOP(
            "commands",
            "Stores a trace that was recorded elsewhere (box trainer, robot, another simulator) as an "
            "external attempt of a person: measured, judged by no limits, never part of a standing."),
        joined(
            {{"--mapping", "MAPPING.json",
              QT_TRANSLATE_NOOP("commands",
                                "Which column of the trace is which, and in which unit; without it the trace "
                                "is in the format of docs/FORMATS.md. Examples are in assets/mappings.")},
             {"--exercise", "NAME",
              QT_TRANSLATE_NOOP("commands",
                                "What was performed: letters, digits, dots, hyphens, underscores.")},
             {"--person", "LOGIN",
              QT_TRANSLATE_NOOP("commands",
                                "Who performed it: with --as a person of a cohort of that educator, else an "
                                "external person of this station, created if missing (external-NAME).")},
             {"--performed", "TIME", QT_TRANSLATE_NOOP("commands", "When, in local time: 2026-11-20T14:05."),
              QT_TRANSLATE_NOOP("commands", "now")},
             {"--source", "TEXT", QT_TRANSLATE_NOOP("commands", "What recorded it."),
              QT_TRANSLATE_NOOP("commands", "the title of the mapping")},
             {"--dry-run", "", QT_TRANSLATE_NOOP("commands", "Read, measure and check, but store nothing.")}},
            session_options()),
        run_import};
}

}  // namespace fulcrum::app
