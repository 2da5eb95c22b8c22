// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/exchange.h"

#include <algorithm>
#include <cmath>

#include "database/records/rating_seen.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/schema/server_version.h"
#include "database/store/audit.h"
#include "database/store/store_state.h"
#include "database/sync/erasure.h"
#include "database/sync/server_link.h"
#include "database/sync/server_schema.h"
#include "database/sync/station_erasure.h"

namespace fulcrum::database {
namespace {

std::string one_text(Connection& connection, const char* sql) {
    Query row(connection, sql);
    return row.next() && !row.is_null(0) ? row.text(0) : std::string();
}

/// Batches of at most `size`.
template <typename Act>
void in_batches(const std::vector<std::string>& keys, int size, Act&& act) {
    for (std::size_t first = 0; first < keys.size(); first += static_cast<std::size_t>(size)) {
        const std::size_t end = std::min(keys.size(), first + static_cast<std::size_t>(size));
        act(std::vector<std::string>(keys.begin() + static_cast<std::ptrdiff_t>(first),
                                     keys.begin() + static_cast<std::ptrdiff_t>(end)),
            end);
    }
}

}  // namespace

Exchange::Exchange(const Store& store, Connection& server, const SyncOptions& options)
    : store_(store), station_(store.connection()), server_(server), options_(options) {}

SyncCount& Exchange::count(const Units& units) {
    for (SyncCount& one : result.counts)
        if (one.title == units.table().title) return one;
    result.counts.push_back({units.table().title});
    return result.counts.back();
}

void Exchange::progress(const std::string& title, Way way, std::size_t done, std::size_t all) {
    if (!options_.progress) return;
    const double share = all == 0 ? 1 : static_cast<double>(done) / static_cast<double>(all);
    options_.progress((static_cast<double>(step_) + share) / static_cast<double>(steps_),
                      (way == Way::up ? "sent " : "received ") + title + ": " + std::to_string(done) +
                          " of " + std::to_string(all));
}

void Exchange::require_one_programme() {
    const char* const sql = "SELECT id FROM programme";
    const std::string here = one_text(station_, sql), there = one_text(server_, sql);
    if (here.empty() && there.empty())
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "neither this store nor the server has a programme"),
                         QT_TRANSLATE_NOOP("errors",
                                           "make the programme at one station (start `fulcrum`, Create "
                                           "programme) and sync that one first"));
    if (!here.empty() && !there.empty() && here != there)
        throw StoreError(
            StoreErrorKind::conflict,
            QT_TRANSLATE_NOOP("errors", "this store belongs to another programme than the server"),
            QT_TRANSLATE_NOOP(
                "errors",
                "name the right server; a further station begins with an empty store (`fulcrum db create`) "
                "and gets its people by sync"));
}

void Exchange::require_known_log() {
    Query newest(
        server_,
        "SELECT sequence, hash FROM audit_entry WHERE station_id = ? ORDER BY sequence DESC LIMIT 1");
    newest.bind(store_.station_id());
    if (!newest.next()) return;
    Query own(station_, "SELECT hash FROM audit_entry WHERE station_id = ? AND sequence = ?");
    own.bind(store_.station_id()).bind(newest.integer(0));
    if (!own.next() || own.bytes(0) != newest.bytes(1))
        throw StoreError(
            StoreErrorKind::conflict,
            {QT_TRANSLATE_NOOP("errors",
                               "the audit log of this store is not the one that the server knows (row %1): "
                               "an older copy is in its place, or it was rewritten"),
             newest.text(0)},
            QT_TRANSLATE_NOOP("errors",
                              "restore the newest backup; if this is the newest, keep this file and begin "
                              "with an empty store (`fulcrum db create`), which joins as a further station "
                              "and gets people and attempts by sync; nothing was transferred"));
}

void Exchange::look_at_clock() {
    Query row(server_, "SELECT (extract(epoch FROM clock_timestamp()) * 1000)::bigint");
    if (row.next()) result.clock_ahead_s = static_cast<double>(store_.now() - row.integer(0)) * 1e-3;
}

void Exchange::use_enrolment() {
    Query enrolment(server_, "SELECT station_id, limited FROM own_enrolment()");
    if (!enrolment.next()) return;
    if (enrolment.text(0) != store_.station_id())
        throw StoreError(
            StoreErrorKind::conflict,
            {QT_TRANSLATE_NOOP("errors", "this account of the server is that of another station (%1)"),
             enrolment.text(0)},
            QT_TRANSLATE_NOOP("errors",
                              "enrol this station with a token of its own (`fulcrum server enrol`, then "
                              "`fulcrum sync --enrol TOKEN`)"));
    is_limited_ = enrolment.flag(1);
    if (!is_limited_) return;
    const auto list = [&](const char* sql) {
        Query rows(station_, sql);
        std::string ids;
        while (rows.next()) ids += (ids.empty() ? "" : ",") + rows.text(0);
        return "{" + ids + "}";
    };
    const std::string held = list("SELECT id FROM person WHERE kind = 'real' UNION SELECT id FROM cohort");
    note_given(
        held,
        list("SELECT p.id FROM person p WHERE p.kind = 'real' AND (EXISTS (SELECT 1 FROM attempt a WHERE "
             "a.person_id = p.id) OR EXISTS (SELECT 1 FROM standing_override d WHERE d.person_id = "
             "p.id) OR EXISTS (SELECT 1 FROM curriculum_move m WHERE m.person_id = p.id) OR EXISTS "
             "(SELECT 1 FROM personal_goal g WHERE g.person_id = p.id))"));
    Query refused(server_, "SELECT r FROM refused_claims(?::text[]) r");
    refused.bind(held);
    while (refused.next()) refused_.insert(refused.text(0));
}

void Exchange::note_given(const std::string& held, const std::string& held_whole) {
    Query(server_, "SELECT station_holds(?::text[], ?::text[])").bind(held).bind(held_whole).run();
}

void Exchange::begin() {
    if (has_begun_exchange(store_)) return;
    Audit(store_).append(store_.station_session(), store_.station_id(), "sync.begin",
                         json_object({{"server", server_id_}}));
}

void Exchange::apply_erasures() {
    std::vector<std::string> people;
    Query rows(server_, "SELECT person_id FROM erasure ORDER BY person_id");
    while (rows.next()) people.push_back(rows.text(0));
    if (people.empty()) return;
    // A backup from before brings them back, to a station whose log may be refused from then on.
    add_to_erasure_list(store_, people);
    for (const std::string& id : people)
        if (erase_at_station(store_, id, store_.station_session(), "erased on the programme server"))
            ++result.erased;
}

const std::set<std::string>& Exchange::known(const std::string& table, Way way) {
    auto& known = known_[way == Way::up ? 0 : 1];
    const auto found = known.find(table);
    if (found != known.end()) return found->second;
    for (const SyncTable& one : sync_tables())
        if (table == one.table)
            return known[table] = Units(one, station_).keys(way == Way::up ? server_ : station_, false);
    throw std::logic_error("no unit " + table);
}

std::vector<Unit> Exchange::transferable(const Units& units, std::vector<Unit> read, Way way) {
    const auto waits = [&](const Unit& unit) {
        for (const Reference& reference : units.table().references) {
            const std::set<std::string>& there = known(reference.target, way);
            for (const std::string& value : units.values(unit, reference))
                if (there.count(value) == 0) return true;
        }
        return false;
    };
    const auto rest =
        std::stable_partition(read.begin(), read.end(), [&](const Unit& unit) { return !waits(unit); });
    if (rest != read.end())
        waiting_[{units.table().title, way}] += static_cast<std::int64_t>(read.end() - rest);
    read.erase(rest, read.end());
    auto& keys = known_[way == Way::up ? 0 : 1];
    const auto own = keys.find(units.table().table);
    if (own != keys.end())
        for (const Unit& unit : read) own->second.insert(unit.key);
    return read;
}

void Exchange::push(const Units& units, const Keys& keys) {
    const bool versioned = units.table().rule == SyncRule::versioned;
    in_batches(keys, units.table().batch, [&](const Keys& batch, std::size_t done) {
        const std::vector<Unit> read = transferable(units, units.read(station_, batch, true), Way::up);
        if (!read.empty()) {
            Transaction transaction(server_);
            server_.execute("SET CONSTRAINTS ALL DEFERRED");
            int written = static_cast<int>(read.size());
            if (versioned) {
                written = units.replace(server_, read, true);
            } else {
                units.add(server_, read);
            }
            transaction.commit();
            count(units).pushed += written;
        }
        progress(units.table().title, Way::up, done, keys.size());
    });
}

void Exchange::pull(const Units& units, const Keys& keys) {
    in_batches(keys, units.table().batch, [&](const Keys& batch, std::size_t done) {
        const std::vector<Unit> read = transferable(units, units.read(server_, batch, false), Way::down);
        if (!read.empty()) {
            Transaction transaction(station_);
            station_.execute("PRAGMA defer_foreign_keys = ON");
            std::vector<RecordName> records;
            if (units.table().rule == SyncRule::versioned) {
                units.replace(station_, read, false);
            } else {
                units.add(station_, read);
                note_copies_seen(units, read);
            }
            for (const Unit& unit : read) {
                if (units.table().record) records.push_back({*units.table().record, unit.key});
                for (const Reference& reference : units.table().references)
                    if (std::string(reference.target) == "form_text")
                        records.push_back({RecordKind::form, *units.values(unit, reference).begin()});
            }
            Audit(store_).append(store_.station_session(), store_.station_id(), "sync.receive",
                                 json_object({{"server", server_id_},
                                              {"what", units.table().title},
                                              {"count", std::to_string(read.size())}}),
                                 records);
            transaction.commit();
            count(units).pulled += static_cast<std::int64_t>(read.size());
        }
        progress(units.table().title, Way::down, done, keys.size());
    });
}

void Exchange::note_copies_seen(const Units& units, const std::vector<Unit>& read) {
    const std::string table = units.table().table;
    if (table != "attempt_reassignment" && table != "rating_seen") return;
    // The first that each of these names: the original.
    for (const Unit& unit : read)
        for (const std::string& original : units.values(unit, units.table().references.front()))
            note_copies(station_, "s.attempt_id = ?", original);
}

void Exchange::add_missing(const Units& units, Way way) {
    Connection& from = way == Way::up ? station_ : server_;
    Connection& to = way == Way::up ? server_ : station_;
    const Keys keys = units.missing(from, to);
    if (way == Way::up && is_limited_ && units.table().only_from_whole) {
        if (!keys.empty())
            result.conflicts.push_back(
                {QT_TRANSLATE_NOOP("errors",
                                   "%1: %2 of this station are not sent, because it has some cohorts only: "
                                   "publish them at a station that has the whole programme"),
                 units.table().title, static_cast<std::int64_t>(keys.size())});
    } else if (way == Way::up) {
        push(units, keys);
    } else {
        pull(units, keys);
    }
}

void Exchange::push_audit() {
    Query known(server_, "SELECT COALESCE(MAX(sequence), 0) FROM audit_entry WHERE station_id = ?");
    known.bind(store_.station_id());
    std::int64_t done = known.next() ? known.integer(0) : 0;
    const std::int64_t first = done;
    Query own(station_, "SELECT COALESCE(MAX(sequence), 0) FROM audit_entry WHERE station_id = ?");
    own.bind(store_.station_id());
    const std::int64_t last = own.next() ? own.integer(0) : 0;
    constexpr std::int64_t batch = 500;
    const QVariant station = QString::fromStdString(store_.station_id());
    while (done < last) {
        const std::int64_t end = std::min(last, done + batch);
        Transaction transaction(server_);
        copy_rows(station_, server_, "station_key", "station_id = ?", {station});
        // In the order in which they refer to each other.
        for (const char* table : {"audit_entry", "audit_payload", "audit_signature"})
            copy_rows(station_, server_, table, "station_id = ? AND sequence > ? AND sequence <= ?",
                      {station, static_cast<qlonglong>(done), static_cast<qlonglong>(end)});
        transaction.commit();
        result.audit_rows += end - done;
        done = end;
        progress("audit rows", Way::up, static_cast<std::size_t>(done - first),
                 static_cast<std::size_t>(last - first));
    }
}

void Exchange::finish() {
    for (Sentence& one : merged_into_erased(station_)) result.conflicts.push_back(std::move(one));
    for (const auto& [what, number] : waiting_)
        result.conflicts.push_back(
            {what.second == Way::up
                 ? QT_TRANSLATE_NOOP("errors",
                                     "%1 of this station that wait until what they belong to can be "
                                     "transferred: %2")
                 : QT_TRANSLATE_NOOP("errors",
                                     "%1 of the server that wait until what they belong to can be "
                                     "transferred: %2"),
             what.first.c_str(), number});
    if (result.transferred() == 0 && result.erased == 0) return;
    std::int64_t pushed = 0, pulled = 0;
    for (const SyncCount& one : result.counts) {
        pushed += one.pushed;
        pulled += one.pulled;
    }
    std::string conflicts;
    for (const std::string& one : english_of(result.conflicts))
        conflicts += (conflicts.empty() ? "" : "; ") + one;
    Audit(store_).append(store_.station_session(), store_.station_id(), "sync.finish",
                         json_object({{"server", server_id_},
                                      {"sent", std::to_string(pushed)},
                                      {"received", std::to_string(pulled)},
                                      {"erased", std::to_string(result.erased)},
                                      {"clock_ahead_s", std::to_string(std::llround(result.clock_ahead_s))},
                                      {"conflicts", conflicts}}));
}

void Exchange::run() {
    server_id_ = require_server(server_);
    require_one_programme();
    apply_erasures();  // it writes here only, so an older copy of the store is no reason to leave it out
    require_known_log();
    look_at_clock();
    use_enrolment();
    begin();
    std::vector<Units> all;
    for (const SyncTable& table : sync_tables()) all.emplace_back(table, station_);
    steps_ = 2 * all.size() + 2;
    for (const Units& units : all) {
        if (units.table().rule == SyncRule::versioned) {
            exchange_until_settled(units);
        } else {
            add_missing(units, Way::up);
        }
        ++step_;
    }
    push_audit();
    ++step_;
    for (const Units& units : all) {
        if (units.table().rule == SyncRule::added) add_missing(units, Way::down);
        ++step_;
    }
    if (is_limited_) note_given("{}", "{}");
    finish();
    push_audit();
}

std::int64_t SyncResult::transferred() const {
    std::int64_t sum = 0;
    for (const SyncCount& one : counts) sum += one.pushed + one.pulled;
    return sum;
}

std::unique_ptr<Connection> connection_to(const Store& store, const ServerAddress& address) {
    const std::optional<ServerLink> link = ServerLink::of(store.station_id());
    const bool is_ours = link && link->is_for(address);
    return std::make_unique<Connection>(is_ours ? link->address : address, false,
                                        is_ours ? link->password : std::string());
}

ServerAddress server_of(const Store& store) {
    if (const std::optional<ServerLink> link = ServerLink::of(store.station_id())) return link->address;
    throw StoreError(
        StoreErrorKind::missing,
        QT_TRANSLATE_NOOP("errors", "this station was not enrolled at a programme server"),
        QT_TRANSLATE_NOOP("errors",
                          "ask the server's owner for a token (`fulcrum server enrol`) and give it "
                          "with `fulcrum sync --to ADDRESS --enrol TOKEN`"));
}

SyncResult sync_with_server(const Store& store, const Session& session, const ServerAddress& address,
                            const SyncOptions& options) {
    if (store.is_demo())
        throw StoreError(StoreErrorKind::sealed_demo,
                         QT_TRANSLATE_NOOP("errors", "the demonstration is never synchronised"),
                         QT_TRANSLATE_NOOP("errors", "name the store of the programme with --db"));
    // A store without people has nobody who could sign in: its first sync brings them.
    if (!session.is_station() || store.has_administrator()) store.require(session, Operation::backup);
    const std::unique_ptr<Connection> connection = connection_to(store, address);
    Connection& server = *connection;
    server.watch([&] {
        if (options.stop && options.stop()) throw SyncStopped();
    });
    Exchange exchange(store, server, options);
    try {
        exchange.run();
    } catch (const SyncStopped&) {
        exchange.result.complete = false;
    }
    return exchange.result;
}

}  // namespace fulcrum::database
