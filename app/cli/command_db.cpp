// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum db: creates and checks the store, shows its audit log, brings scores up to date.
#include <QDate>
#include <QDateTime>
#include <iostream>

#include "app/cli/commands.h"
#include "app/cli/simulation_options.h"
#include "app/live/interrupted.h"
#include "assessment/metrics/statement_words.h"
#include "database/records/people.h"
#include "database/scoring/rescoring.h"
#include "database/store/audit.h"
#include "database/store/quick_check.h"
#include "database/store/signing_keys.h"

namespace fulcrum::app {
namespace {

int create(const Arguments& arguments) {
    const std::string path = store_path(arguments);
    const database::Store store = database::Store::create(path);
    if (arguments.has("--json")) {
        print_json({{"created", path}, {"schema", database::Store::schema_version()}});
    } else {
        std::cout << "created " << path << " (schema " << database::Store::schema_version() << ")\n";
    }
    return 0;
}

/// What --against names; empty without it.
std::string known_head(const Arguments& arguments) {
    const std::string head = arguments.value_or("--against", "");
    constexpr std::size_t least = 16, most = 64;
    if (arguments.has("--against") && (head.size() < least || head.size() > most ||
                                       head.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos))
        throw UsageError(
            "--against", {QT_TRANSLATE_NOOP("errors", "'%1' is not the head of an audit log"), head},
            QT_TRANSLATE_NOOP(
                "errors",
                "give its first 16 to 64 hexadecimal digits, as reports and `db audit` print them"));
    return head;
}

void add_head(const database::Store& store, const std::string& head, database::CheckReport& report) {
    database::CheckItem item(database::CheckId::known_head);
    item.count = 1;
    if (!database::Audit(store).has_head(head))
        item.problems.push_back(
            {QT_TRANSLATE_NOOP(
                 "errors",
                 "no audit row has the head %1: the store was rewritten, or an older copy is in its place"),
             head});
    item.ok = item.problems.empty();
    report.ok = report.ok && item.ok;
    report.items.push_back(std::move(item));
}

/// What --key names; empty without it.
std::string known_key(const Arguments& arguments) {
    const std::string key = arguments.value_or("--key", "");
    constexpr std::size_t least = 16, most = 32;
    if (arguments.has("--key") && (key.size() < least || key.size() > most ||
                                   key.find_first_not_of("0123456789abcdef") != std::string::npos))
        throw UsageError(
            "--key", {QT_TRANSLATE_NOOP("errors", "'%1' is not the fingerprint of a station's key"), key},
            QT_TRANSLATE_NOOP(
                "errors",
                "give its first 16 to 32 hexadecimal digits, as reports and `db audit` print them"));
    return key;
}

void add_key(const database::Store& store, const std::string& key, database::CheckReport& report) {
    database::CheckItem item(database::CheckId::known_key);
    item.count = 1;
    const std::string found = database::Audit(store).signing_key();
    // Keys that this one announced are as good: the item `signatures` has looked at who signed what.
    if (!database::leads_to_newest(database::signing_keys(store.connection(), store.station_id()), key))
        item.problems.push_back(
            found.empty()
                ? Sentence(QT_TRANSLATE_NOOP(
                               "errors",
                               "the newest audit row is not signed (it should be, by %1): the log was "
                               "written by somebody else, or the station has a new key"),
                           key)
                : Sentence(
                      QT_TRANSLATE_NOOP("errors",
                                        "the newest audit row is signed by the key %1, to which no announced "
                                        "keys lead from %2: the log was written by somebody else, or the key "
                                        "was lost"),
                      found, key));
    item.ok = item.problems.empty();
    report.ok = report.ok && item.ok;
    report.items.push_back(std::move(item));
}

/// The look that the window takes when it starts.
int quick_check(const Arguments& arguments) {
    database::StoreOptions options;
    options.read_only = options.older_schema = true;
    const database::Store store = database::Store::open(store_path(arguments), options);
    store.require(store.station_session(), database::Operation::check_store);
    const database::QuickCheck found = database::quick_check(store);
    if (arguments.has("--json")) {
        print_json({{"ok", found.problems.empty()},
                    {"store", store_path(arguments)},
                    {"tables", found.tables},
                    {"tables_seen", found.tables_seen},
                    {"problems", english_of(found.problems)}});
    } else {
        std::cout << "quick check: " << (found.problems.empty() ? "ok" : "BROKEN") << " ("
                  << found.tables_seen << " of " << found.tables << " tables read)\n";
        for (const Sentence& problem : found.problems) std::cout << "  " << line_of(problem) << '\n';
    }
    return found.problems.empty() ? 0 : 1;
}

int check(const Arguments& arguments) {
    // The quick look answers none of these questions, so it must not say "ok" to them.
    for (const char* other :
         {"--against", "--key", "--simulate", "--seed", "--as", "--role", "--password-file"})
        arguments.exclude("--quick", other);
    if (arguments.has("--quick")) return quick_check(arguments);
    const SimulationSample sample = simulation_sample(arguments);
    database::StoreOptions options;
    options.read_only = !arguments.has("--as");  // a sign-in is recorded, so the store must be writable
    options.older_schema = options.read_only;
    const std::string head = known_head(arguments), key = known_key(arguments);
    const database::Store store = database::Store::open(store_path(arguments), options);
    const database::Session session = session_of(arguments, store);
    database::CheckReport report = check_store_and_sample(store, session, sample);
    if (!head.empty()) add_head(store, head, report);
    if (!key.empty()) add_key(store, key, report);
    nlohmann::json items = nlohmann::json::array();
    for (const database::CheckItem& item : report.items) {
        items.push_back({{"name", item.name},
                         {"ok", item.ok},
                         {"count", item.count},
                         {"problems", english_of(item.problems)},
                         {"notes", english_of(item.notes)}});
        if (!arguments.has("--json")) {
            std::cout << item.name << ": " << (item.ok ? "ok" : "BROKEN") << " (" << item.count << ")\n";
            for (const Sentence& problem : item.problems) std::cout << "  " << line_of(problem) << '\n';
            for (const Sentence& note : item.notes) std::cout << "  note: " << line_of(note) << '\n';
        }
    }
    const int schema = store.found_schema(), current = database::Store::schema_version();
    if (arguments.has("--json")) {
        print_json({{"ok", report.ok},
                    {"store", store_path(arguments)},
                    {"schema", schema},
                    {"program_schema", current},
                    {"items", items}});
    } else if (schema < current) {
        std::cout << "schema " << schema << " of " << current
                  << ": what later schemas add was not checked; `fulcrum db migrate` brings it up to date\n";
    }
    return report.ok ? 0 : 1;
}

/// A day ("2026-11-21") or a time ("2026-11-21T04:07:37Z"), UTC. A day means its beginning, with `end` its
/// end.
database::UtcMilliseconds moment_of(const Arguments& arguments, const std::string& option, bool end) {
    const auto given = arguments.value(option);
    if (!given) return 0;
    const QString words = QString::fromStdString(*given);
    const QDate day = QDate::fromString(words, QStringLiteral("yyyy-MM-dd"));
    if (day.isValid()) return QDateTime(end ? day.addDays(1) : day, QTime(0, 0), Qt::UTC).toMSecsSinceEpoch();
    const QDateTime moment = QDateTime::fromString(words, QStringLiteral("yyyy-MM-dd'T'HH:mm:ss'Z'"));
    if (!moment.isValid())
        throw UsageError(
            option, {QT_TRANSLATE_NOOP("errors", "'%1' is not a time"), *given},
            QT_TRANSLATE_NOOP("errors", "give a day (2026-11-21) or a time (2026-11-21T04:07:37Z), UTC"));
    return QDateTime(moment.date(), moment.time(), Qt::UTC).toMSecsSinceEpoch();
}

/// Throws unless `kind` is an operation in the log, or the part of one before its dot.
void require_kind(const std::string& kind, const std::vector<std::string>& kinds) {
    std::string list;
    for (const std::string& known : kinds) {
        if (kind == known || known.rfind(kind + ".", 0) == 0) return;
        list += (list.empty() ? "" : ", ") + known;
    }
    throw UsageError("--kind", {QT_TRANSLATE_NOOP("errors", "no entry of kind '%1'"), kind},
                     {QT_TRANSLATE_NOOP("errors", "name one of %1, or the part before a dot"), list});
}

const char* verdict(const std::optional<bool>& passed) {
    return !passed ? "not scored" : *passed ? "passed" : "failed";
}

nlohmann::json json_of(const database::AuditEntry& entry) {
    return {{"sequence", entry.sequence},
            {"time", database::iso_utc(entry.time)},
            {"station", entry.station_id},
            {"actor", entry.actor_id},
            {"actor_name", entry.actor_name},
            {"role", or_null(entry.role)},
            {"operation", entry.operation},
            {"object", entry.object_id},
            {"person", or_null(entry.person_id)},
            {"person_name", or_null(entry.person_name)},
            {"payload", entry.payload},
            {"digest", entry.digest},
            {"previous_hash", entry.previous_hash},
            {"hash", entry.hash}};
}

int audit(const Arguments& arguments) {
    database::AuditFilter filter;
    filter.from = moment_of(arguments, "--from", false);
    filter.until = moment_of(arguments, "--until", true);
    filter.limit = static_cast<int>(arguments.integer("--limit", 500, 1, 1000000));
    if (filter.until > 0 && filter.until <= filter.from)
        throw UsageError("--until", QT_TRANSLATE_NOOP("errors", "is not after --from"),
                         QT_TRANSLATE_NOOP("errors", "give a later time"));
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const database::Audit log(store);
    store.require(session, database::Operation::view_audit);
    filter.person_id = person_named(arguments, store, session);
    filter.kind = arguments.value_or("--kind", "");
    if (!filter.kind.empty()) require_kind(filter.kind, log.kinds(session));
    const std::vector<database::AuditEntry> entries = log.entries(session, filter);
    const std::vector<Sentence> problems = log.verify();
    if (arguments.has("--json")) {
        nlohmann::json rows = nlohmann::json::array();
        for (const database::AuditEntry& entry : entries) rows.push_back(json_of(entry));
        print_json({{"store", store_path(arguments)},
                    {"chain",
                     {{"ok", problems.empty()},
                      {"rows", log.count()},
                      {"head", log.head()},
                      {"key", log.signing_key()},
                      {"problems", english_of(problems)}}},
                    {"entries", rows}});
    } else {
        for (const database::AuditEntry& entry : entries) {
            std::cout << entry.sequence << "  " << database::iso_utc(entry.time) << "  " << entry.actor_name
                      << (entry.role.empty() ? "" : " (" + entry.role + ")") << "  " << entry.operation
                      << "  " << (entry.person_name.empty() ? entry.object_id : entry.person_name) << "  "
                      << entry.payload << '\n';
        }
        std::cout << "chain: " << (problems.empty() ? "intact" : "BROKEN") << ", " << log.count()
                  << " rows, head " << log.head()
                  << (log.signing_key().empty() ? "" : ", signed by key " + log.signing_key()) << '\n';
        for (const Sentence& problem : problems) std::cout << "  " << line_of(problem) << '\n';
    }
    return problems.empty() ? 0 : 1;
}

nlohmann::json json_of(const RecomputedScore& one) {
    return {{"attempt", one.attempt_id},
            {"task", one.task_id},
            {"because", one.why},
            {"passed_in_force", or_null(one.passed_in_force)},
            {"passed", or_null(one.passed)},
            {"not_scored_because", or_null(words_of(one.not_scored_because))},
            {"problem", or_null(one.problem.words())}};
}

int recompute(const Arguments& arguments) {
    const std::string path = store_path(arguments);
    std::string person;
    std::optional<database::Session> session;
    {
        const database::Store store = open_store(arguments, false);
        session = session_of(arguments, store);
        store.require(*session, database::Operation::recompute_score);
        person = person_named(arguments, store, *session);
    }
    const std::vector<RecomputedScore> scores = recompute_scores(path, *session, person);
    bool all = true;
    nlohmann::json rows = nlohmann::json::array();
    for (const RecomputedScore& one : scores) {
        all = all && one.problem.empty();
        rows.push_back(json_of(one));
        if (arguments.has("--json")) continue;
        std::cout << one.attempt_id << ' ' << one.task_id << ": "
                  << (one.problem.empty() ? verdict(one.passed) : one.problem.words()) << " (" << one.why
                  << ")\n";
    }
    if (arguments.has("--json")) {
        print_json({{"store", path}, {"recomputed", rows}});
    } else if (scores.empty()) {
        std::cout << "all scores that you may recompute are up to date\n";
    }
    return all ? 0 : 1;
}

int score(const Arguments& arguments) {
    std::optional<database::Session> session;
    {
        const database::Store store = open_store(arguments, false);
        session = session_of(arguments, store);
        store.require(*session, database::Operation::score_interrupted);
    }
    bool all = true;
    nlohmann::json rows = nlohmann::json::array();
    for (const ui::InterruptedScore& one : score_interrupted(store_path(arguments), *session)) {
        all = all && one.problem.empty();
        rows.push_back({{"attempt", one.attempt_id},
                        {"task", one.task_id},
                        {"duration_s", one.duration_s},
                        {"passed", or_null(one.passed)},
                        {"because", or_null(one.problem.empty() ? words_of(one.why) : one.problem.words())}});
        if (!arguments.has("--json"))
            std::cout << one.attempt_id << ' ' << one.task_id << ": " << verdict(one.passed) << " ("
                      << (one.problem.empty() ? words_of(one.why) : one.problem.words()) << ")\n";
    }
    if (arguments.has("--json")) {
        print_json({{"store", store_path(arguments)}, {"scored", rows}});
    } else if (rows.empty()) {
        std::cout << "all interrupted attempts that you may score have a score\n";
    }
    return all ? 0 : 1;
}

}  // namespace

std::vector<Command> store_commands() {
    const Option person{"--person", "LOGIN",
                        QT_TRANSLATE_NOOP("commands", "Only entries about this person.")};
    return {
        {"db create",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP("commands", "Creates an empty store."),
         {store_option(), json_option()},
         create},
        {"db check", "", 0, 0,
         QT_TRANSLATE_NOOP("commands", "Checks that the store is complete and unchanged."),
         joined(
             {{"--against", "HEAD",
               QT_TRANSLATE_NOOP("commands",
                                 "Also check that the audit log contains this head, which a report or `db "
                                 "audit` printed earlier: 16 to 64 hexadecimal digits.")},
              {"--key", "FINGERPRINT",
               QT_TRANSLATE_NOOP(
                   "commands",
                   "Also check that the newest audit row is signed by this key, or by one to which announced "
                   "keys lead from it: 16 to 32 hexadecimal digits, as reports and `db audit` print them.")},
              {"--quick", "",
               QT_TRANSLATE_NOOP("commands",
                                 "Only what the window looks at when it starts, within a second.")}},
             joined(simulation_options(), session_options())),
         check},
        {"db audit", "", 0, 0, QT_TRANSLATE_NOOP("commands", "Lists the audit log and checks its chain."),
         joined({person,
                 {"--kind", "KIND",
                  QT_TRANSLATE_NOOP("commands",
                                    "Only entries of this operation, or of the group before its dot.")},
                 {"--from", "TIME",
                  QT_TRANSLATE_NOOP("commands",
                                    "From this day (2026-11-21) or time (2026-11-21T04:07:37Z), UTC.")},
                 {"--until", "TIME", QT_TRANSLATE_NOOP("commands", "Up to this day or time, UTC.")},
                 {"--limit", "N",
                  QT_TRANSLATE_NOOP("commands", "Show at most this many of the newest entries."), "500"}},
                session_options()),
         audit},
        {"db score", "", 0, 0,
         QT_TRANSLATE_NOOP("commands", "Scores interrupted attempts that have no score yet."),
         session_options(), score},
        {"db recompute", "", 0, 0,
         QT_TRANSLATE_NOOP("commands", "Recomputes outdated scores; the scores in force stay unchanged."),
         joined({person}, session_options()), recompute}};
}

}  // namespace fulcrum::app
