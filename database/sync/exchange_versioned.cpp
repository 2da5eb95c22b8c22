// SPDX-License-Identifier: GPL-3.0-or-later
// Units with a version, of which both sides may have changed the same one: people, cohorts and the programme.
#include "database/records/people_rows.h"
#include "database/store/audit.h"
#include "database/sync/exchange.h"

namespace fulcrum::database {
namespace {

Sentence name_is_taken(const SyncTable& table, const std::string& name) {
    if (std::string(table.table) == "person")
        return {QT_TRANSLATE_NOOP("errors",
                                  "%1: \"%2\" is the login of one at this station and of another one on the "
                                  "server; neither is transferred until one of them gets another login "
                                  "(page People, or `fulcrum people login`)"),
                table.title, name};
    return {QT_TRANSLATE_NOOP("errors",
                              "%1: \"%2\" is the name of one at this station and of another one on the "
                              "server; neither is transferred until one of them is renamed"),
            table.title, name};
}

}  // namespace

void Exchange::add_conflict(Sentence one) {
    if (conflicts_said_.insert(one.words()).second) result.conflicts.push_back(std::move(one));
}

bool Exchange::is_changed_here(const std::string& key) {
    Query row(
        station_,
        "SELECT 1 FROM audit_entry WHERE station_id = ? AND object_id = ? AND (operation LIKE 'person.%' OR "
        "operation LIKE 'password.%' OR operation LIKE 'cohort.%') AND sequence > COALESCE((SELECT "
        "MAX(sequence) FROM audit_entry WHERE station_id = ? AND operation = ?), 0)");
    row.bind(store_.station_id()).bind(key).bind(store_.station_id()).bind("sync.finish");
    return row.next();
}

std::set<std::string> Exchange::names_of_hidden(const Units& units,
                                                const std::map<std::string, UnitState>& here,
                                                const std::map<std::string, UnitState>& there) {
    std::set<std::string> taken;
    if (!is_limited_ || units.table().unique == nullptr) return taken;
    std::string names;
    for (const auto& [key, state] : here) {
        if (there.count(key) != 0) continue;
        // As an element of an array: in quotes, with those within it escaped.
        names += names.empty() ? "\"" : ",\"";
        for (const char c : state.unique) names += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
        names += '"';
    }
    if (names.empty()) return taken;
    const bool is_person = std::string(units.table().table) == "person";
    Query rows(server_, "SELECT t FROM names_taken(?::text[], ?::text[]) t");
    rows.bind(is_person ? "{" + names + "}" : "{}").bind(is_person ? "{}" : "{" + names + "}");
    while (rows.next()) taken.insert(rows.text(0));
    return taken;
}

std::size_t Exchange::exchange_versioned(const Units& units, bool last) {
    const std::map<std::string, UnitState> here = units.states(station_), there = units.states(server_);
    const auto owners = [](const std::map<std::string, UnitState>& states) {
        std::map<std::string, std::string> owner;
        for (const auto& [key, state] : states) owner[state.unique] = key;
        return owner;
    };
    const auto owners_here = owners(here);
    auto owners_there = owners(there);
    for (const std::string& name : names_of_hidden(units, here, there)) owners_there.emplace(name, "");
    Keys up, down;
    std::size_t left = 0;
    const auto goes = [&](const std::string& key, Way way) {
        const auto at_station = here.find(key), at_server = there.find(key);
        if (at_station == here.end() || at_server == there.end() || refused_.count(key) != 0) return false;
        return (at_station->second.version > at_server->second.version) == (way == Way::up);
    };
    // Another unit of the receiving side has this login or name already.
    const auto taken = [&](const std::string& key, const UnitState& state, Way way) {
        if (units.table().unique == nullptr) return false;
        const auto& owner = way == Way::up ? owners_there : owners_here;
        const auto found = owner.find(state.unique);
        if (found == owner.end() || found->second == key) return false;
        // The sending side gave the owner another one, which goes the same way and makes this one free.
        if (!last && goes(found->second, way))
            ++left;
        else
            add_conflict(name_is_taken(units.table(), state.unique));
        return true;
    };
    for (const auto& [key, state] : here) {
        const auto other = there.find(key);
        if (other != there.end() && other->second.content == state.content) continue;
        if (refused_.count(key) != 0) {
            add_conflict(
                {QT_TRANSLATE_NOOP(
                     "errors",
                     "%1: \"%2\" is on the server, but the server never gave it to this station: it is not "
                     "transferred, and the server's log has this; have the person added to a cohort "
                     "of this station, or ask the server's owner for another token"),
                 units.table().title, state.unique.empty() ? key : state.unique});
            continue;
        }
        if (other == there.end() || state.version > other->second.version) {
            if (!taken(key, state, Way::up)) up.push_back(key);
            continue;
        }
        if (taken(key, other->second, Way::down)) continue;
        down.push_back(key);
        if (is_changed_here(key))
            add_conflict(
                {QT_TRANSLATE_NOOP("errors",
                                   "%1: \"%2\" was changed here and on the server; the server's is kept, and "
                                   "the audit log has both"),
                 units.table().title, state.unique.empty() ? key : state.unique});
    }
    for (const auto& [key, state] : there)
        if (here.count(key) == 0 && !taken(key, state, Way::down)) down.push_back(key);
    if (std::string(units.table().table) == "person" && !down.empty()) {
        Transaction transaction(station_);
        for (const std::string& key : down)
            make_room_for(store_, store_.station_session(), there.at(key).unique);
        transaction.commit();
    }
    push(units, up);
    pull(units, down);
    return left;
}

void Exchange::exchange_until_settled(const Units& units) {
    // Rows are written one by one, and at no time may two have one login: a login that passed from one
    // person to another one is free once the first has been transferred.
    bool last = false;
    std::size_t before = 0;
    while (true) {
        for (const Way way : {Way::up, Way::down}) waiting_.erase({units.table().title, way});
        const std::size_t left = exchange_versioned(units, last);
        if (left == 0) return;
        last = before > 0 && left >= before;
        before = left;
    }
}

}  // namespace fulcrum::database
