// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/xapi/xapi_outbox.h"

#include <algorithm>

#include "database/rows/connection.h"
#include "database/rows/enum_column.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

constexpr std::size_t longest_problem = 500;

OutboxStatement read_statement(const Query& row) {
    OutboxStatement one;
    one.id = row.text(0);
    one.person_id = row.text(1);
    one.text = row.text(2);
    one.state = enum_of(row.text(3), outbox_states, "state of statement " + one.id);
    one.tries = static_cast<int>(row.integer(4));
    one.next_try = row.integer(5);
    one.changed = row.integer(6);
    one.problem = row.text(7);
    return one;
}
constexpr const char* outbox_columns =
    "SELECT id, person_id, statement, state, tries, next_try, changed, problem FROM xapi_outbox ";

}  // namespace

std::int64_t outbox_wait_ms(int tries) {
    constexpr std::int64_t minute = 60000, longest = 12 * 60 * minute;
    std::int64_t wait = minute;
    for (int i = 1; i < tries && wait < longest; ++i) wait *= 2;
    return std::min(wait, longest);
}

XapiOutbox::XapiOutbox(const Store& store, const Session& session, std::string endpoint)
    : store_(store), endpoint_(std::move(endpoint)) {
    require_at_station(store_, session, Operation::export_cohort);
}

int XapiOutbox::add(const std::vector<OutboxStatement>& statements) const {
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    std::int64_t number = 0;
    {
        Query last(connection, "SELECT COALESCE(MAX(number), 0) FROM xapi_outbox WHERE endpoint = ?");
        last.bind(endpoint_);
        if (last.next()) number = last.integer(0);
    }
    int added = 0;
    for (const OutboxStatement& one : statements) {
        std::string person = one.person_id;
        if (!one.attempt_id.empty()) {
            Query attempt(connection, "SELECT person_id FROM attempt WHERE id = ?");
            attempt.bind(one.attempt_id);
            if (!attempt.next()) continue;
            person = attempt.text(0);
            // Queued by an older program, for the account that the attempt's was merged into then.
            Query(connection,
                  "UPDATE xapi_outbox SET person_id = ? WHERE endpoint = ? AND id = ? AND person_id <> ?")
                .bind(person)
                .bind(endpoint_)
                .bind(one.id)
                .bind(person)
                .run();
        }
        // Erased since the statement was made: what an erasure has deleted does not come back.
        Query known(connection,
                    "SELECT 1 FROM xapi_outbox WHERE endpoint = ? AND id = ? UNION ALL SELECT 1 FROM person "
                    "WHERE id = ? AND login = 'erased-' || id");
        known.bind(endpoint_).bind(one.id).bind(person);
        if (known.next()) continue;
        Query(
            connection,
            "INSERT INTO xapi_outbox (endpoint, id, person_id, number, statement, changed) VALUES (?, ?, ?, "
            "?, ?, ?)")
            .bind(endpoint_)
            .bind(one.id)
            .bind(person)
            .bind(++number)
            .bind(one.text)
            .bind(store_.now())
            .run();
        ++added;
    }
    transaction.commit();
    return added;
}

std::optional<OutboxStatement> XapiOutbox::next() const {
    Query row(store_.connection(), QString(outbox_columns) +
                                       "WHERE endpoint = ? AND state = 'waiting' AND (next_try <= ? OR "
                                       "changed > ?) ORDER BY number LIMIT 1");
    const UtcMilliseconds now = store_.now();
    row.bind(endpoint_).bind(now).bind(now);
    if (!row.next()) return std::nullopt;
    return read_statement(row);
}

void XapiOutbox::set_state(const std::string& id, OutboxState state, const std::string& problem) const {
    Query(
        store_.connection(),
        "UPDATE xapi_outbox SET state = ?, problem = ?, next_try = 0, changed = ? WHERE endpoint = ? AND id "
        "= ? AND state = 'waiting'")
        .bind(row_of(outbox_states, state).name)
        .bind(problem.substr(0, longest_problem))
        .bind(store_.now())
        .bind(endpoint_)
        .bind(id)
        .run();
}

void XapiOutbox::finish(const std::string& id) const {
    set_state(id, OutboxState::done, {});
}

void XapiOutbox::quarantine(const std::string& id, const std::string& problem) const {
    set_state(id, OutboxState::quarantined, problem);
}

void XapiOutbox::postpone(const std::string& id, const std::string& problem, std::int64_t wait_ms) const {
    Transaction transaction(store_.connection());
    int tries = 0;
    {
        Query row(store_.connection(), "SELECT tries FROM xapi_outbox WHERE endpoint = ? AND id = ?");
        row.bind(endpoint_).bind(id);
        if (row.next()) tries = static_cast<int>(row.integer(0));
    }
    ++tries;
    Query(
        store_.connection(),
        "UPDATE xapi_outbox SET tries = ?, next_try = ?, problem = ?, changed = ? WHERE endpoint = ? AND id "
        "= ? AND state = 'waiting'")
        .bind(tries)
        .bind(store_.now() + std::max(wait_ms, outbox_wait_ms(tries)))
        .bind(problem.substr(0, longest_problem))
        .bind(store_.now())
        .bind(endpoint_)
        .bind(id)
        .run();
    transaction.commit();
}

int XapiOutbox::release() const {
    Query update(
        store_.connection(),
        "UPDATE xapi_outbox SET state = 'waiting', tries = 0, next_try = 0, problem = '', changed = ? "
        "WHERE endpoint = ? AND state = 'quarantined'");
    update.bind(store_.now()).bind(endpoint_).run();
    return update.rows_changed();
}

namespace {

std::vector<OutboxCounts> read_counts(const Store& store, const std::string& endpoint) {
    Query rows(store.connection(),
               "SELECT endpoint, state, COUNT(*), MIN(CASE WHEN changed > ? THEN 0 ELSE next_try END) FROM "
               "xapi_outbox WHERE ? IN ('', endpoint) GROUP BY endpoint, state ORDER BY endpoint");
    rows.bind(store.now()).bind(endpoint);
    std::vector<OutboxCounts> all;
    while (rows.next()) {
        if (all.empty() || all.back().endpoint != rows.text(0)) {
            all.emplace_back();
            all.back().endpoint = rows.text(0);
        }
        const int count = static_cast<int>(rows.integer(2));
        switch (enum_of(rows.text(1), outbox_states, "state of a statement")) {
            case OutboxState::waiting:
                all.back().waiting = count;
                all.back().next_try = rows.integer(3);
                break;
            case OutboxState::done:
                all.back().done = count;
                break;
            case OutboxState::quarantined:
                all.back().quarantined = count;
                break;
        }
    }
    return all;
}

}  // namespace

OutboxCounts XapiOutbox::counts() const {
    const std::vector<OutboxCounts> found = read_counts(store_, endpoint_);
    if (!found.empty()) return found.front();
    OutboxCounts none;
    none.endpoint = endpoint_;
    return none;
}

std::vector<OutboxStatement> XapiOutbox::quarantined() const {
    Query rows(store_.connection(),
               QString(outbox_columns) + "WHERE endpoint = ? AND state = 'quarantined' ORDER BY number");
    rows.bind(endpoint_);
    std::vector<OutboxStatement> found;
    while (rows.next()) found.push_back(read_statement(rows));
    return found;
}

std::vector<OutboxCounts> outbox_counts(const Store& store, const Session& session) {
    require_at_station(store, session, Operation::export_cohort);
    return read_counts(store, {});
}

}  // namespace fulcrum::database
