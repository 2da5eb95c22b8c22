// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/curricula.h"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "database/records/attempt_query.h"
#include "database/records/standings.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/rows/same_person.h"
#include "database/store/accepted_assets.h"
#include "database/store/audit.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::database {
namespace {

// Copies of an older program have no row of their own that says so.
#define FULCRUM_NO_COPY(attempt)                                                       \
    "NOT EXISTS (SELECT 1 FROM attempt_reassignment r WHERE r.to_id = " attempt        \
    ".id) AND NOT EXISTS (SELECT 1 FROM attempt_asset c WHERE c.attempt_id = " attempt \
    ".id AND c.file = " FULCRUM_COPIED_FROM ") "
// What was recorded elsewhere belongs to no curriculum (external_task_prefix).
#define FULCRUM_OWN_TASK "a.task_id NOT LIKE 'external-%' "
// A copy that came back to its person: that person has an original of the same performance. The copies in
// between may be of people whom this store does not have.
#define FULCRUM_CAME_BACK                                                                        \
    "EXISTS (SELECT 1 FROM attempt b WHERE b.person_id = a.person_id AND b.started = a.started " \
    "AND b.seed = a.seed AND b.task_id = a.task_id AND b.id <> a.id AND " FULCRUM_NO_COPY("b") ") "
// Its version is the one that the person follows: not of a voided one, which is as if it had never been, nor
// of the copy of a reassigned one, which names what the other person followed.
#define FULCRUM_DECIDES                                                                               \
    FULCRUM_OWN_TASK                                                                                  \
    "AND NOT EXISTS (SELECT 1 FROM attempt_void v WHERE v.attempt_id = a.id) AND ((" FULCRUM_NO_COPY( \
        "a") ") OR " FULCRUM_CAME_BACK ") "

/// The version of attempts from before they named one.
std::string first_version(const Curriculum& newest) {
    return newest.id + "@1";
}

/// A move of one of a person's accounts.
struct Move {
    std::string account;
    bool kept = false;  ///< written by a decision (keep_version), made by nobody on purpose
    FollowedCurriculum to;
};
/// By person, oldest first.
using Moves = std::map<std::string, std::vector<Move>>;

/// The first attempt that decides.
struct FirstAttempt {
    std::string curriculum;
    std::int64_t time = 0;  ///< UTC ms
};

// It has the id of its decision, so that every station knows it as one.
#define FULCRUM_KEPT "EXISTS (SELECT 1 FROM standing_override o WHERE o.id = m.id) "

/// The version that a person follows from the beginning.
FollowedCurriculum followed_first(const std::optional<FirstAttempt>& begun, const Curriculum& newest) {
    FollowedCurriculum first;
    first.name = newest.name();
    if (!begun) return first;
    first.name = begun->curriculum.empty() ? first_version(newest) : begun->curriculum;
    // Before attempts named it there was one version, of whichever curriculum is installed.
    if (begun->curriculum.empty() && newest.version_named(first.name) == nullptr) first.name = newest.name();
    return first;
}

/// The moves of the people (table `p`) for whom `whose` holds with this value. Not those that another account
/// of the same person made before a merge.
Moves read_moves(Connection& connection, const QString& whose, const std::string& value) {
    Query rows(
        connection,
        "SELECT p.id, m.person_id, m.curriculum, m.time, w.display_name, m.reason, CASE WHEN " FULCRUM_KEPT
        "THEN 1 ELSE 0 END FROM curriculum_move m " +
            join_owner("m.person_id", "p") + "JOIN person w ON w.id = m.author_id WHERE " + whose + " AND " +
            owner_of("m.author_id") + " <> p.id ORDER BY m.time, m.id");
    rows.bind(value);
    Moves moves;
    while (rows.next())
        moves[rows.text(0)].push_back(
            {rows.text(1), rows.flag(6), {rows.text(2), rows.integer(3), rows.text(4), rows.text(5)}});
    return moves;
}

/// Of `account` out of its person's, or of all of them where it is empty.
std::optional<FirstAttempt> read_first(Connection& connection, const std::string& person_id,
                                       const std::string& account) {
    Query first(connection, "SELECT a.curriculum, a.started FROM attempt a WHERE " +
                                belongs_to("a.person_id") +
                                (account.empty() ? QString() : QString(" AND a.person_id = ?")) +
                                " AND " FULCRUM_DECIDES " ORDER BY a.started, a.id LIMIT 1");
    first.bind(person_id);
    if (!account.empty()) first.bind(account);
    if (!first.next()) return std::nullopt;
    return FirstAttempt{first.text(0), first.integer(1)};
}

/// Whether others were merged into this account.
bool is_merge_target(Connection& connection, const std::string& person_id) {
    Query merged(connection,
                 "SELECT 1 FROM person d JOIN person t ON t.id = d.merged_into AND t.merged_into = '' WHERE "
                 "d.merged_into = ? LIMIT 1");
    merged.bind(person_id);
    return merged.next();
}

/// The versions that a person follows one after the other. `first`: of all accounts; `own`: of `account`, the
/// one that stays, where others were merged into it. By what was recorded, not by what a station knew when it
/// wrote a row: so stations that have exchanged agree, in whichever order the rows arrived.
std::vector<FollowedCurriculum> versions_of(const std::string& account,
                                            const std::optional<FirstAttempt>& first,
                                            const std::optional<FirstAttempt>& own,
                                            const std::vector<Move>& moves, const Curriculum& newest) {
    std::vector<FollowedCurriculum> followed = {followed_first(first, newest)};
    std::int64_t own_since = own ? own->time : std::numeric_limits<std::int64_t>::max();
    for (const Move& move : moves) {
        // A decision keeps the version of somebody who has begun nothing, and moves nobody who has.
        if (move.kept && (followed.size() > 1 || (first && first->time < move.to.since))) continue;
        // A merged account moves nobody who has begun under the one that stays.
        if (move.account == account)
            own_since = std::min(own_since, move.to.since);
        else if (own_since <= move.to.since)
            continue;
        followed.push_back(move.to);
    }
    // Whoever was moved before any attempt decided began with that version: nothing was done under another.
    if (followed.size() > 1 && (!first || followed[1].since <= first->time))
        followed.front().name = followed[1].name;
    // From the attempt on with which the account that stays began itself, it follows the version that this
    // attempt names. A merge puts nobody on the version of the doubled account.
    if (own && own->time == own_since) {
        FollowedCurriculum begun = followed_first(own, newest);
        begun.since = own->time;
        const auto later =
            std::find_if(followed.begin() + 1, followed.end(),
                         [&](const FollowedCurriculum& one) { return one.since >= begun.since; });
        if ((later - 1)->name != begun.name) followed.insert(later, std::move(begun));
    }
    return followed;
}

/// As followed(), not checked.
std::vector<FollowedCurriculum> history(Connection& connection, const std::string& person_id,
                                        const Curriculum& newest) {
    const std::optional<FirstAttempt> first = read_first(connection, person_id, {});
    std::optional<FirstAttempt> own;
    if (first && is_merge_target(connection, person_id)) own = read_first(connection, person_id, person_id);
    return versions_of(person_id, first, own, read_moves(connection, "p.id = ?", person_id)[person_id],
                       newest);
}

/// Into which others were merged.
std::set<std::string> merge_targets(Connection& connection) {
    Query rows(connection,
               "SELECT DISTINCT t.id FROM person d JOIN person t ON t.id = d.merged_into AND t.merged_into = "
               "'' WHERE d.merged_into <> ''");
    std::set<std::string> targets;
    while (rows.next()) targets.insert(rows.text(0));
    return targets;
}

/// Of a person's accounts.
struct Begun {
    std::optional<FirstAttempt> first, own;  ///< of all; of the one that the others were merged into
    std::string first_id;
};

/// By person; those without an attempt that decides are left out.
std::map<std::string, Begun> begun_by_everybody(Connection& connection) {
    Query rows(connection, "SELECT " + owner_of("p.person_id") +
                               ", p.person_id, a.started, a.id, a.curriculum FROM (SELECT DISTINCT "
                               "a.person_id FROM attempt a WHERE " FULCRUM_OWN_TASK
                               ") p JOIN attempt a ON a.id = (SELECT a.id FROM attempt a WHERE a.person_id "
                               "= p.person_id AND " FULCRUM_DECIDES " ORDER BY a.started, a.id LIMIT 1)");
    std::map<std::string, Begun> everybody;
    while (rows.next()) {
        Begun& person = everybody[rows.text(0)];
        const FirstAttempt attempt{rows.text(4), rows.integer(2)};
        const std::string id = rows.text(3);
        if (rows.text(0) == rows.text(1)) person.own = attempt;
        if (person.first && std::tie(person.first->time, person.first_id) <= std::tie(attempt.time, id))
            continue;
        person.first = attempt;
        person.first_id = id;
    }
    return everybody;
}

void write_move(const Store& store, const Session& educator, const std::string& id, const std::string& person,
                const std::string& from, const std::string& to, const std::string& reason,
                std::int64_t time) {
    Query(store.connection(),
          "INSERT INTO curriculum_move (id, person_id, curriculum, author_id, time, reason) VALUES "
          "(?, ?, ?, ?, ?, ?)")
        .bind(id)
        .bind(person)
        .bind(to)
        .bind(educator.person_id())
        .bind(time)
        .bind(reason)
        .run();
    Audit(store).append(educator, id, "curriculum.move",
                        json_object({{"from", from}, {"person", person}, {"reason", reason}, {"to", to}}),
                        {{RecordKind::curriculum_move, id}});
}

std::vector<CurriculumAssignment> assignments_of(const std::vector<FollowedCurriculum>& followed,
                                                 const Curriculum& newest) {
    std::vector<CurriculumAssignment> result;
    for (const FollowedCurriculum& one : followed) {
        const Curriculum* version = newest.version_named(one.name);
        if (version == nullptr)
            result.push_back({one.since, &newest, one.name});
        else
            result.push_back({one.since, version});
    }
    return result;
}

const Curriculum& require_version(const Curriculum& newest, const std::string& name) {
    const Curriculum* found = newest.version_named(name);
    if (found != nullptr) return *found;
    std::string known = newest.name();
    for (const Curriculum& one : newest.older) known += ", " + one.name();
    throw StoreError(StoreErrorKind::bad_value,
                     {QT_TRANSLATE_NOOP("errors", "no curriculum %1 is installed"), name},
                     {QT_TRANSLATE_NOOP("errors", "name one of these: %1"), known});
}

/// Whether people can stay on this text of a version: it is that of the first attempt with the version.
/// Stations that are apart may publish one version with different contents, and each keeps its own: so it may
/// also be a text that the programme accepts, unless this station's attempts began with another one.
bool is_text_of(const Store& store, const std::string& name, const Curriculum& version) {
    const std::string digest = sha256_hex(version.text);
    const QString begun =
        "SELECT x.digest FROM attempt a JOIN attempt_asset x ON x.attempt_id = a.id AND x.file LIKE "
        "'curricula/%' WHERE a.curriculum = ? ";
    const QString first = "ORDER BY a.started, a.id LIMIT 1";
    Query of_all(store.connection(), begun + first);
    of_all.bind(name);
    if (!of_all.next() || of_all.text(0) == digest) return true;
    // A copy that was made here of another station's attempt has that station's text.
    Query own(store.connection(), begun + "AND a.station_id = ? AND " FULCRUM_NO_COPY("a") + first);
    own.bind(name).bind(store.station_id());
    if (own.next() && own.text(0) != digest) return false;
    return AcceptedAssets(store).unknown({{"curricula/" + version.file, digest}}).empty();
}

}  // namespace

Sentence MissingCurriculum::words() const {
    return {QT_TRANSLATE_NOOP("errors",
                              "the curriculum %2 is not installed, but people follow it (how many: %1)"),
            people, name};
}

Sentence not_here_words(const std::string& name) {
    return {QT_TRANSLATE_NOOP("errors",
                              "nothing can be said of a standing: the person follows the curriculum %1, "
                              "which is not at this station"),
            name};
}

Sentence not_here_hint() {
    return QT_TRANSLATE_NOOP("errors",
                             "exchange with the programme server, or install it (a newer version of the "
                             "program, or the file that was published at another station)");
}

std::string missing_in(const std::vector<CurriculumAssignment>& assignments, std::int64_t at) {
    std::string name;
    std::int64_t since = std::numeric_limits<std::int64_t>::min();
    for (const CurriculumAssignment& one : assignments) {
        if (one.missing.empty() || one.time > at || one.time < since) continue;
        name = one.missing;
        since = one.time;
    }
    return name;
}

bool decides_curriculum(const AttemptSummary& attempt) {
    return !is_external_task(attempt.meta.task_id) && attempt.voided_at == 0;
}

std::vector<FollowedCurriculum> Curricula::followed(const Session& session, const std::string& person_id,
                                                    const Curriculum& newest) const {
    store_.require(session, Operation::read_progress, Subject::person(person_id));
    return history(store_.connection(), person_id, newest);
}

std::vector<CurriculumAssignment> Curricula::assignments(const Session& session, const std::string& person_id,
                                                         const Curriculum& newest) const {
    return assignments_of(followed(session, person_id, newest), newest);
}

std::map<std::string, std::vector<CurriculumAssignment>> Curricula::assignments_in(
    const Session& session, const std::string& cohort_id, const Curriculum& newest,
    const std::map<std::string, BegunWith>& begun_with) const {
    store_.require(session, Operation::read_cohort_table, Subject::cohort(cohort_id));
    Connection& connection = store_.connection();
    const Moves moves = read_moves(
        connection, "p.id IN (SELECT person_id FROM cohort_member WHERE cohort_id = ?)", cohort_id);
    const std::set<std::string> merged = merge_targets(connection);
    std::set<std::string> everybody;
    for (const auto& [person, begun] : begun_with) everybody.insert(person);
    for (const auto& [person, of_person] : moves) everybody.insert(person);
    std::map<std::string, std::vector<CurriculumAssignment>> result;
    for (const std::string& person : everybody) {
        const auto begun = begun_with.find(person);
        const auto moved = moves.find(person);
        std::vector<FollowedCurriculum> followed;
        if (begun == begun_with.end() || begun->second.has_copies || merged.count(person) != 0) {
            followed = history(connection, person, newest);
        } else {
            std::optional<FirstAttempt> first;
            if (begun->second.curriculum)
                first = FirstAttempt{*begun->second.curriculum, begun->second.since};
            followed = versions_of(person, first, std::nullopt,
                                   moved == moves.end() ? std::vector<Move>() : moved->second, newest);
        }
        result[person] = assignments_of(followed, newest);
    }
    return result;
}

const Curriculum& Curricula::in_force(const Session& session, const std::string& person_id,
                                      const Curriculum& newest) const {
    return *curriculum_at(assignments(session, person_id, newest), store_.now());
}

std::string Curricula::missing(const Session& session, const std::string& person_id,
                               const Curriculum& newest) const {
    return missing_in(assignments(session, person_id, newest), store_.now());
}

void Curricula::require_here(const Session& session, const std::string& person_id,
                             const Curriculum& newest) const {
    const std::string name = missing(session, person_id, newest);
    if (!name.empty()) throw StoreError(StoreErrorKind::bad_value, not_here_words(name), not_here_hint());
}

std::vector<CurriculumChange> Curricula::preview(const Session& session, const std::string& person_id,
                                                 const Curriculum& newest, const std::string& to) const {
    require_here(session, person_id, newest);
    const std::int64_t now = store_.now();
    PersonRecord record = Standings(store_).record(session, person_id, newest);
    const std::vector<TaskStanding> before = standing_of(record, now);
    record.assignments.push_back({now, &require_version(newest, to)});
    const std::vector<TaskStanding> after = standing_of(record, now);
    const auto find = [](const std::vector<TaskStanding>& standings, const std::string& task) {
        return std::find_if(standings.begin(), standings.end(),
                            [&](const TaskStanding& one) { return one.task == task; });
    };
    std::vector<CurriculumChange> changes;
    for (const TaskStanding& one : before) {
        const auto other = find(after, one.task);
        if (other == after.end()) {
            changes.push_back({one.task, one, {}, true, false});
        } else if (other->standing != one.standing || other->waits_for != one.waits_for) {
            changes.push_back({one.task, one, *other, false, false});
        }
    }
    for (const TaskStanding& one : after)
        if (find(before, one.task) == before.end()) changes.push_back({one.task, {}, one, false, true});
    return changes;
}

int Curricula::move(const Session& educator, const std::vector<std::string>& people, const Curriculum& newest,
                    const std::string& to, const std::string& reason) const {
    for (const std::string& person : people) {
        store_.require(educator, Operation::decide_standing, Subject::person(person));
        require_here(educator, person, newest);
    }
    require_version(newest, to);
    if (reason.find_first_not_of(" \t\r\n") == std::string::npos || reason.size() > 4000)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a reason is missing or too long"),
                         QT_TRANSLATE_NOOP("errors", "give a reason of 1 to 4,000 characters"));
    Connection& connection = store_.connection();
    const std::int64_t now = store_.now();
    int moved = 0;
    Transaction transaction(connection);
    for (const std::string& person : people) {
        const FollowedCurriculum last = history(connection, person, newest).back();
        const std::string& from = last.name;
        if (from == to) continue;
        // After one that was made at a station whose clock is ahead, which it would not replace else.
        write_move(store_, educator, random_uuid(), person, from, to, reason, std::max(now, last.since + 1));
        ++moved;
    }
    transaction.commit();
    return moved;
}

void Curricula::keep_version(const Session& educator, const std::string& person_id, const Curriculum& newest,
                             const std::string& decision, const std::string& reason) const {
    store_.require(educator, Operation::decide_standing, Subject::person(person_id));
    Connection& connection = store_.connection();
    if (!read_moves(connection, "p.id = ?", person_id).empty()) return;
    const std::string name = history(connection, person_id, newest).back().name;
    write_move(store_, educator, decision, person_id, name, name, reason, store_.now());
}

std::vector<CurriculumAssignment> Curricula::of_account(const Session& session, const std::string& person_id,
                                                        const std::string& account_id,
                                                        const Curriculum& newest) const {
    store_.require(session, Operation::read_progress, Subject::person(person_id));
    Connection& connection = store_.connection();
    return assignments_of(
        versions_of(account_id, read_first(connection, person_id, account_id), std::nullopt,
                    read_moves(connection, "m.person_id = ?", account_id)[person_id], newest),
        newest);
}

std::map<std::string, int> Curricula::people(const Curriculum& newest) const {
    Connection& connection = store_.connection();
    std::map<std::string, Begun> begun = begun_by_everybody(connection);
    Moves moves = read_moves(connection, "m.curriculum <> ?", {});  // all
    for (const auto& [person, of_person] : moves) begun.try_emplace(person);
    std::map<std::string, int> result;
    for (const auto& [person, of_person] : begun)
        ++result[versions_of(person, of_person.first, of_person.own, moves[person], newest).back().name];
    return result;
}

std::vector<MissingCurriculum> Curricula::check(const Curriculum& newest) const {
    std::vector<MissingCurriculum> not_here;
    for (const auto& [name, count] : people(newest)) {
        const Curriculum* version = newest.version_named(name);
        if (version == nullptr) {
            not_here.push_back({name, count});
            continue;
        }
        if (!version->text.empty() && !is_text_of(store_, name, *version))
            throw InputError(
                "curricula/" + version->file, "/version",
                {QT_TRANSLATE_NOOP("errors",
                                   "this file says it is %1, but the %1 that people follow (how many: %2) "
                                   "has different content"),
                 name, count},
                QT_TRANSLATE_NOOP(
                    "errors",
                    "a version in use is never edited: restore this file, write the change to a new file "
                    "with /version raised, and move people with fulcrum curriculum move"));
    }
    return not_here;
}

}  // namespace fulcrum::database
