// SPDX-License-Identifier: GPL-3.0-or-later
// `db check`: every page, reference, chain row, chunk and score read once; and the closing of attempts that
// lost their program.
#include <sqlite3.h>
#include <sys/stat.h>

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/schema/migration.h"
#include "database/store/audit.h"
#include "database/store/override_rows.h"
#include "database/store/recording_lock.h"
#include "database/store/score_rows.h"
#include "database/store/signing_keys.h"
#include "database/store/store_check.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

constexpr std::size_t most_problems = 20;

/// Where SQLite says no more than that the file is damaged: which tables cannot be read.
void name_damaged_tables(Connection& connection, CheckItem& item) {
    std::vector<std::string> tables;
    try {
        Query names(connection, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
        while (names.next()) tables.push_back(names.text(0));
    } catch (const StoreError&) {
        item.problems.push_back(
            {QT_TRANSLATE_NOOP("errors", "table %1: it or an index of it is damaged"), "sqlite_schema"});
        return;
    }
    for (const std::string& table : tables) {
        bool sound = true;
        try {
            Query rows(connection,
                       QString("PRAGMA integrity_check('%1')").arg(QString::fromStdString(table)));
            while (rows.next()) sound = sound && rows.text(0) == "ok";
        } catch (const StoreError&) {
            sound = false;
        }
        if (!sound)
            item.problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "table %1: it or an index of it is damaged"), table});
    }
}

/// Tables, indexes and triggers, and the statements that made them.
std::map<std::string, std::string> definitions(Connection& connection) {
    std::map<std::string, std::string> all;
    // Statistics of the query planner are made where SQLite likes to.
    Query rows(connection,
               "SELECT type || ' ' || name, quote(type) || quote(name) || quote(tbl_name) || quote(sql) FROM "
               "sqlite_master WHERE name NOT LIKE 'sqlite@_stat%' ESCAPE '@'");
    while (rows.next()) all[rows.text(0)] = rows.text(1);
    return all;
}

void check_integrity(const Store& store, CheckItem& item, const CheckWatch& watch) {
    const auto name_tables = [&] {
        const std::size_t before = item.problems.size();
        if (!watch.stopped()) name_damaged_tables(store.connection(), item);
        return item.problems.size() > before;
    };
    bool named = true;
    try {
        Query rows(store.connection(), "PRAGMA integrity_check(100)");
        while (rows.next()) {
            if (rows.text(0) == "ok") continue;
            item.problems.push_back(rows.text(0));
            named = named && rows.text(0) != sqlite3_errstr(SQLITE_CORRUPT);
        }
    } catch (const StoreError&) {
        if (!name_tables()) throw;
    }
    if (!named) name_tables();
    if (item.problems.empty()) check_definitions(store, item.problems);
    Query pages(store.connection(), "PRAGMA page_count");
    if (pages.next()) item.count = pages.integer(0);
}

void check_foreign_keys(const Store& store, CheckItem& item) {
    Query rows(store.connection(), "PRAGMA foreign_key_check");
    while (rows.next())
        item.problems.push_back({QT_TRANSLATE_NOOP("errors", "table %1: a row points to nothing in %2"),
                                 rows.text(0), rows.text(2)});
    Query tables(store.connection(), "SELECT COUNT(*) FROM sqlite_master WHERE type = 'table'");
    if (tables.next()) item.count = tables.integer(0);
}

/// Records that the programme server sent: where they were made is in the audit log of another station, and
/// check_records() compares them with their digests here.
std::set<std::string> received_records(Connection& connection) {
    std::set<std::string> names;
    Query rows(connection,
               "SELECT p.payload FROM audit_entry e JOIN audit_payload p ON p.station_id = e.station_id AND "
               "p.sequence = e.sequence WHERE e.operation = 'sync.receive'");
    while (rows.next()) {
        const QJsonObject said = QJsonDocument::fromJson(QByteArray::fromStdString(rows.text(0))).object();
        for (const QString& name : said.value(QLatin1String(records_key)).toObject().keys())
            names.insert(name.toStdString());
    }
    return names;
}

void check_scores(const Store& store, CheckItem& item) {
    const std::set<std::string> received = received_records(store.connection());
    Query rows(
        store.connection(),
        "SELECT s.id, s.attempt_id, (SELECT e.sequence FROM audit_entry e WHERE e.object_id = s.id AND "
        "e.operation = 'score.add'), (SELECT p.payload FROM audit_entry e JOIN audit_payload p ON "
        "p.station_id = e.station_id "
        "AND p.sequence = e.sequence WHERE e.object_id = s.id AND e.operation = 'score.add') FROM score s");
    while (rows.next()) {
        ++item.count;
        const Sentence place(QT_TRANSLATE_NOOP("errors", "score of attempt %1"), rows.text(1));
        if (rows.is_null(2)) {
            if (received.count(RecordName{RecordKind::score, rows.text(0)}.text()) != 0) continue;
            item.problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: not in the audit chain"), place});
        } else if (!rows.is_null(3)) {
            const std::string digest =
                score_digest(rows.text(1), read_score(store.connection(), rows.text(0)));
            if (rows.text(3).find(digest) == std::string::npos)
                item.problems.push_back(
                    {QT_TRANSLATE_NOOP("errors", "%1: changed after it was written"), place});
        }
    }
}

void check_signatures(const Store& store, CheckItem& item) {
    SignatureCheck check = verify_audit_signatures(store.connection(), store.station_id());
    item.count = check.count;
    item.problems = std::move(check.problems);
    item.notes = std::move(check.notes);
}

void check_scenes(const Store& store, CheckItem& item) {
    Query rows(store.connection(), "SELECT digest, text FROM scene_text");
    while (rows.next()) {
        ++item.count;
        if (text_digest(rows.text(1)) != rows.text(0))
            item.problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "scene %1: changed after it was written"), rows.text(0)});
    }
    Query lost(store.connection(),
               "SELECT id FROM attempt WHERE scene_digest <> '' AND scene_digest NOT IN (SELECT digest FROM "
               "scene_text)");
    while (lost.next())
        item.problems.push_back(
            {QT_TRANSLATE_NOOP("errors", "attempt %1: its scene is missing"), lost.text(0)});
}

void check_overrides(const Store& store, CheckItem& item) {
    const std::set<std::string> received = received_records(store.connection());
    for (const OverrideRow& row : read_raw_overrides(store.connection())) {
        ++item.count;
        if (received.count(RecordName{RecordKind::decision, row.decision.id}.text()) != 0) continue;
        Query deed(store.connection(),
                   "SELECT p.payload FROM audit_entry e JOIN audit_payload p ON p.station_id = e.station_id "
                   "AND p.sequence = e.sequence WHERE e.object_id = ? AND e.operation = 'standing.decide' "
                   "AND e.actor_id = ?");
        deed.bind(row.decision.id).bind(row.author_id);
        if (!deed.next() || !is_payload_of(deed.text(0), row))
            item.problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "decision %1 on %2: not as the audit log has it"),
                 row.decision.id, row.decision.task});
    }
}

void check_permissions(const Store& store, CheckItem& item) {
    struct stat status {};
    item.count = 1;
    if (::stat(store.path().c_str(), &status) == 0 && (status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
        item.problems.push_back(
            {QT_TRANSLATE_NOOP("errors",
                               "%1: other users of this machine may open it (run `chmod 600` on it)"),
             store.path()});
    }
}

}  // namespace

OneView::OneView(Connection& connection) : connection_(connection), own_(!connection.in_transaction()) {
    // Not a Transaction: that one waits for whoever writes, and keeps them waiting.
    if (own_) connection_.execute("BEGIN");
}

OneView::~OneView() {
    // Where SQLite has ended it after a failed read, there is none.
    if (own_) sqlite3_exec(connection_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void check_definitions(const Store& store, std::vector<Sentence>& problems) {
    constexpr int patience_ms = 100;
    Connection empty(":memory:", false, true, patience_ms);
    migrate(empty, store.found_schema());
    const auto wanted = definitions(empty), found = definitions(store.connection());
    for (const auto& [name, sql] : wanted) {
        const auto here = found.find(name);
        if (here == found.end())
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: it is missing"), name});
        else if (here->second != sql)
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: its definition was changed"), name});
    }
    for (const auto& [name, sql] : found)
        if (wanted.count(name) == 0)
            problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "%1: this is not a part of a Fulcrum store"), name});
}

CheckWatch::CheckWatch(Connection& connection, const StoreProgress& progress)
    : connection_(connection), progress_(progress) {
    constexpr int instructions = 1000000;  // of SQLite's machine: some tens of milliseconds
    if (progress_) sqlite3_progress_handler(connection_.handle(), instructions, &CheckWatch::ask, this);
}

CheckWatch::~CheckWatch() {
    if (progress_) sqlite3_progress_handler(connection_.handle(), 0, nullptr, nullptr);
}

void CheckWatch::begin(double from, double to, const char* what) {
    from_ = from;
    to_ = to;
    what_ = what;
    at(0);
}

bool CheckWatch::at(double share) {
    done_ = from_ + share * (to_ - from_);
    return report();
}

int CheckWatch::ask(void* watch) {
    return static_cast<CheckWatch*>(watch)->report() ? 0 : 1;
}

bool CheckWatch::report() {
    if (progress_ && !stopped_) stopped_ = !progress_(done_, what_);
    return !stopped_;
}

CheckReport check_store(const Store& store, const StoreProgress& progress) {
    CheckReport report;
    const OneView view(store.connection());
    CheckWatch watch(store.connection(), progress);
    const auto look = [&](double from, double to, CheckId id,
                          const std::function<void(CheckItem&)>& checker) {
        if (!report.complete) return;
        CheckItem item(id);
        watch.begin(from, to, item.name.c_str());
        try {
            if (!watch.stopped()) checker(item);
        } catch (const StoreError& error) {
            // A damaged page stops one check, not the others.
            if (!watch.stopped()) item.problems.push_back(error.problem_sentence());
        }
        report.complete = !watch.stopped();
        if (!report.complete) return;
        if (item.problems.size() > most_problems) {
            const std::size_t more = item.problems.size() - most_problems;
            item.problems.resize(most_problems);
            item.problems.push_back({QT_TRANSLATE_NOOP("errors", "and %1 more"), more});
        }
        item.ok = item.problems.empty();
        report.ok = report.ok && item.ok;
        report.items.push_back(std::move(item));
    };
    look(0, 0.25, CheckId::integrity, [&](CheckItem& item) { check_integrity(store, item, watch); });
    look(0.25, 0.3, CheckId::foreign_keys, [&](CheckItem& item) { check_foreign_keys(store, item); });
    look(0.3, 0.4, CheckId::audit_chain, [&](CheckItem& item) {
        const Audit audit(store);
        item.count = audit.count();
        item.problems = audit.verify();
    });
    // An older store has not got all of it; opening it for writing brings it up to date.
    constexpr int with_attempts = 2, with_pathology = 5, with_scenes = 6, with_decisions = 7;
    const int schema = store.found_schema();
    if (schema >= schema_with_signatures)
        look(0.4, 0.4, CheckId::signatures, [&](CheckItem& item) { check_signatures(store, item); });
    if (schema >= with_attempts)
        look(0.4, 0.8, CheckId::trace_checksums, [&](CheckItem& item) { check_traces(store, item, watch); });
    // The digests are over columns up to the newest schema; after a migration they are compared as well.
    if (schema == Store::schema_version())
        look(0.8, 0.9, CheckId::records, [&](CheckItem& item) { check_records(store, item, watch); });
    if (schema >= with_pathology)
        look(0.9, 1, CheckId::score_digests, [&](CheckItem& item) { check_scores(store, item); });
    if (schema >= with_scenes)
        look(1, 1, CheckId::scenes, [&](CheckItem& item) { check_scenes(store, item); });
    if (schema >= with_decisions)
        look(1, 1, CheckId::decisions, [&](CheckItem& item) { check_overrides(store, item); });
    look(1, 1, CheckId::permissions, [&](CheckItem& item) { check_permissions(store, item); });
    return report;
}

std::vector<InterruptedAttempt> close_interrupted_attempts(const Store& store) {
    Connection& connection = store.connection();
    {
        // Most starts find none: no write, no waiting for a recorder that writes.
        Query any(connection, "SELECT 1 FROM attempt WHERE state = 'running' LIMIT 1");
        if (!any.next()) return {};
    }
    Transaction transaction(connection);
    std::vector<InterruptedAttempt> found;
    {
        Query rows(
            connection,
            "SELECT a.id, a.person_id, a.task_id, a.started, COALESCE((SELECT MAX(last_tick) + 1 FROM "
            "trace_chunk c WHERE "
            "c.attempt_id = a.id AND c.stream = 0), 0), COALESCE((SELECT o.tick + 1 FROM attempt_origin o "
            "WHERE o.attempt_id = a.id), 0) FROM attempt a WHERE a.state = 'running' AND "
            "a.station_id = ?");
        rows.bind(store.station_id());
        while (rows.next()) {
            if (RecordingLock::is_held(store, rows.text(0))) continue;
            InterruptedAttempt attempt;
            attempt.attempt_id = rows.text(0);
            attempt.person_id = rows.text(1);
            attempt.task_id = rows.text(2);
            attempt.started = rows.integer(3);
            // Ticks of practice from a moment continue those of the attempt that it began with.
            attempt.recorded_s =
                static_cast<double>(std::max<std::int64_t>(rows.integer(4) - rows.integer(5), 0)) * 1e-3;
            found.push_back(std::move(attempt));
        }
    }
    for (const InterruptedAttempt& attempt : found) {
        Query(connection,
              "UPDATE attempt SET state = 'interrupted', duration_s = ?, events = COALESCE((SELECT "
              "SUM(records) FROM trace_chunk c "
              "WHERE c.attempt_id = attempt.id AND c.stream = 3), 0) WHERE id = ?")
            .bind(attempt.recorded_s)
            .bind(attempt.attempt_id)
            .run();
        Audit(store).append(
            store.station_session(), attempt.attempt_id, "attempt.interrupted",
            json_object({{"task", attempt.task_id}, {"cause", "the program ended while it ran"}}),
            {{RecordKind::attempt, attempt.attempt_id}, {RecordKind::trace, attempt.attempt_id}});
        RecordingLock::clean(store, attempt.attempt_id);
        RecordingLock::leave(store, attempt.attempt_id);
    }
    transaction.commit();
    return found;
}

}  // namespace fulcrum::database
