// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum db: the store's own care.
#include <QDate>
#include <QDateTime>
#include <iostream>
#include <map>

#include "app/cli/commands.h"
#include "app/live/interrupted.h"
#include "app/rescoring.h"
#include "database/records/people.h"
#include "database/store/audit.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

constexpr const char* store_and_session =
    " [--db FILE] [--as LOGIN [--role ROLE] --password-file FILE] [--json]";

OptionSpec spec_of(const std::string& usage, std::set<std::string> options, std::size_t words) {
    OptionSpec spec;
    spec.usage = "usage: fulcrum db " + usage;
    spec.with_value = std::move(options);
    spec.flags = {"--json"};
    spec.minimum_words = spec.maximum_words = words;
    return spec;
}

OptionSpec spec_with_session(const std::string& usage, std::size_t words,
                             const std::set<std::string>& more = {}) {
    std::set<std::string> options = session_options();
    options.insert(more.begin(), more.end());
    return spec_of(usage + store_and_session, std::move(options), words);
}

std::string store_path(const Arguments& arguments) {
    return arguments.value_or("--db", database::Store::default_path());
}

int create(const std::vector<std::string>& words) {
    const Arguments arguments(words, spec_of("create [--db FILE] [--json]", {"--db"}, 0));
    const std::string path = store_path(arguments);
    const database::Store store = database::Store::create(path);
    if (arguments.has("--json")) {
        print_json({{"created", path}, {"schema", database::Store::schema_version()}});
    } else {
        std::cout << "created " << path << " (schema " << database::Store::schema_version() << ")\n";
    }
    return 0;
}

int check(const std::vector<std::string>& words) {
    const Arguments arguments(words, spec_with_session("check", 0));
    const bool signs_in = arguments.has("--as");  // which the store keeps, so it must be writable
    const database::Store store = open_store(arguments, false, !signs_in);
    const database::CheckReport report = store.check(session_of(arguments, store));
    nlohmann::json items = nlohmann::json::array();
    for (const database::CheckItem& item : report.items) {
        items.push_back(
            {{"name", item.name}, {"ok", item.ok}, {"count", item.count}, {"problems", item.problems}});
        if (!arguments.has("--json")) {
            std::cout << item.name << ": " << (item.ok ? "ok" : "BROKEN") << " (" << item.count << ")\n";
            for (const std::string& problem : item.problems) std::cout << "  " << problem << '\n';
        }
    }
    if (arguments.has("--json"))
        print_json({{"ok", report.ok}, {"store", store_path(arguments)}, {"items", items}});
    return report.ok ? 0 : 1;
}

int backup(const std::vector<std::string>& words) {
    const Arguments arguments(words, spec_with_session("backup TO", 1));
    const database::Store store = open_store(arguments, false);
    const std::string& to = arguments.words()[0];
    store.backup(person_session(arguments, store), to);
    if (arguments.has("--json")) {
        print_json({{"store", store_path(arguments)}, {"backup", to}});
    } else {
        std::cout << "backed up " << store_path(arguments) << " to " << to << '\n';
    }
    return 0;
}

/// A day ("2026-11-21", from its first moment UTC) or a moment ("2026-11-21T04:07:37Z"). `end`: a day ends
/// with its last moment.
database::UtcMilliseconds moment_of(const Arguments& arguments, const std::string& option, bool end) {
    const auto given = arguments.value(option);
    if (!given) return 0;
    const QString words = QString::fromStdString(*given);
    const QDate day = QDate::fromString(words, QStringLiteral("yyyy-MM-dd"));
    if (day.isValid()) return QDateTime(end ? day.addDays(1) : day, QTime(0, 0), Qt::UTC).toMSecsSinceEpoch();
    const QDateTime moment = QDateTime::fromString(words, QStringLiteral("yyyy-MM-dd'T'HH:mm:ss'Z'"));
    if (!moment.isValid())
        throw UsageError("command line: " + option + ": '" + *given +
                         "' is no time; give a day (2026-11-21) or a moment (2026-11-21T04:07:37Z), UTC");
    return QDateTime(moment.date(), moment.time(), Qt::UTC).toMSecsSinceEpoch();
}

std::string person_named(const Arguments& arguments, const database::Store& store,
                         const database::Session& session) {
    const auto login = arguments.value("--person");
    if (!login) return {};
    const auto person = database::People(store).find_login(session, *login);
    if (!person)
        throw InputError("command line", "--person", "no person '" + *login + "' that you may read",
                         "name a login of this store");
    return person->id;
}

/// One of the chain's operations, or what stands before the dot of some.
void require_kind(const std::string& kind, const std::vector<std::string>& kinds) {
    std::string list;
    for (const std::string& known : kinds) {
        if (kind == known || known.rfind(kind + ".", 0) == 0) return;
        list += (list.empty() ? "" : ", ") + known;
    }
    throw InputError("command line", "--kind", "no entry of kind '" + kind + "'",
                     "name one of " + list + ", or what stands before a dot");
}

nlohmann::json or_null(const std::string& text) {
    return text.empty() ? nlohmann::json() : nlohmann::json(text);
}

nlohmann::json or_null(const std::optional<bool>& passed) {
    return passed ? nlohmann::json(*passed) : nlohmann::json();
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

int audit(const std::vector<std::string>& words) {
    const Arguments arguments(
        words,
        spec_with_session("audit [--person LOGIN] [--kind KIND] [--from TIME] [--until TIME] [--limit N]", 0,
                          {"--person", "--kind", "--from", "--until", "--limit"}));
    database::AuditFilter filter;
    filter.from = moment_of(arguments, "--from", false);
    filter.until = moment_of(arguments, "--until", true);
    filter.limit = static_cast<int>(arguments.integer("--limit", 500, 1, 1000000));
    if (filter.until > 0 && filter.until <= filter.from)
        throw UsageError("command line: --until: lies before --from; give a later time");
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const database::Audit log(store);
    store.require(session, database::Operation::view_audit);
    filter.person_id = person_named(arguments, store, session);
    filter.kind = arguments.value_or("--kind", "");
    if (!filter.kind.empty()) require_kind(filter.kind, log.kinds(session));
    const std::vector<database::AuditEntry> entries = log.entries(session, filter);
    const std::vector<std::string> problems = log.verify();
    if (arguments.has("--json")) {
        nlohmann::json rows = nlohmann::json::array();
        for (const database::AuditEntry& entry : entries) rows.push_back(json_of(entry));
        print_json({{"store", store_path(arguments)},
                    {"chain",
                     {{"ok", problems.empty()},
                      {"rows", log.count()},
                      {"head", log.head()},
                      {"problems", problems}}},
                    {"entries", rows}});
    } else {
        for (const database::AuditEntry& entry : entries) {
            std::cout << entry.sequence << "  " << database::iso_utc(entry.time) << "  " << entry.actor_name
                      << (entry.role.empty() ? "" : " (" + entry.role + ")") << "  " << entry.operation
                      << "  " << (entry.person_name.empty() ? entry.object_id : entry.person_name) << "  "
                      << entry.payload << '\n';
        }
        std::cout << "chain: " << (problems.empty() ? "holds" : "BROKEN") << ", " << log.count()
                  << " rows, head " << log.head() << '\n';
        for (const std::string& problem : problems) std::cout << "  " << problem << '\n';
    }
    return problems.empty() ? 0 : 1;
}

nlohmann::json json_of(const ui::RecomputedScore& one) {
    return {{"attempt", one.attempt_id},
            {"task", one.task_id},
            {"because", one.why},
            {"passed_in_force", or_null(one.passed_in_force)},
            {"passed", or_null(one.passed)},
            {"not_scored_because", or_null(one.not_scored_because)},
            {"problem", or_null(one.problem)}};
}

int recompute(const std::vector<std::string>& words) {
    const Arguments arguments(words, spec_with_session("recompute [--person LOGIN]", 0, {"--person"}));
    const std::string path = store_path(arguments);
    std::string person;
    std::optional<database::Session> session;
    {
        const database::Store store = open_store(arguments, false);
        session = session_of(arguments, store);
        store.require(*session, database::Operation::recompute_score);
        person = person_named(arguments, store, *session);
    }
    const std::vector<ui::RecomputedScore> scores = recompute_scores(path, *session, person);
    bool all = true;
    nlohmann::json rows = nlohmann::json::array();
    for (const ui::RecomputedScore& one : scores) {
        all = all && one.problem.empty();
        rows.push_back(json_of(one));
        if (arguments.has("--json")) continue;
        std::cout << one.attempt_id << ' ' << one.task_id << ": "
                  << (one.problem.empty() ? verdict(one.passed) : one.problem) << " (" << one.why << ")\n";
    }
    if (arguments.has("--json")) {
        print_json({{"store", path}, {"recomputed", rows}});
    } else if (scores.empty()) {
        std::cout << "every score that you may recompute rests on what is in force\n";
    }
    return all ? 0 : 1;
}

int score(const std::vector<std::string>& words) {
    const Arguments arguments(words, spec_with_session("score", 0));
    std::optional<database::Session> session;
    {
        const database::Store store = open_store(arguments, false);
        session = session_of(arguments, store);
        store.require(*session, database::Operation::score_interrupted);
    }
    nlohmann::json rows = nlohmann::json::array();
    for (const ui::InterruptedScore& one : score_interrupted(store_path(arguments), *session)) {
        rows.push_back({{"attempt", one.attempt_id},
                        {"task", one.task_id},
                        {"duration_s", one.duration_s},
                        {"passed", or_null(one.passed)},
                        {"because", or_null(one.why)}});
        if (!arguments.has("--json"))
            std::cout << one.attempt_id << ' ' << one.task_id << ": " << verdict(one.passed) << " ("
                      << one.why << ")\n";
    }
    if (arguments.has("--json")) {
        print_json({{"store", store_path(arguments)}, {"scored", rows}});
    } else if (rows.empty()) {
        std::cout << "nothing that you may score was interrupted and has no score\n";
    }
    return 0;
}

}  // namespace

int command_db(const std::vector<std::string>& words) {
    using Action = int (*)(const std::vector<std::string>&);
    static const std::map<std::string, Action> actions = {{"create", create}, {"check", check},
                                                          {"backup", backup}, {"audit", audit},
                                                          {"score", score},   {"recompute", recompute}};
    std::string list;
    for (const auto& [name, action] : actions) list += (list.empty() ? "" : "|") + name;
    const std::string usage = "usage: fulcrum db " + list + " ...";
    // The action is the first word that is neither an option nor its value.
    std::size_t at = 0;
    while (at < words.size() && words[at].rfind("--", 0) == 0) at += words[at] == "--json" ? 1 : 2;
    if (at >= words.size()) throw UsageError("command line: a word is missing; " + usage);
    const auto found = actions.find(words[at]);
    if (found == actions.end())
        throw UsageError("command line: db " + words[at] + ": no such action; " + usage);
    std::vector<std::string> rest = words;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(at));
    return found->second(rest);
}

}  // namespace fulcrum::app
