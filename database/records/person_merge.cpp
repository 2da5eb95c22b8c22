// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/person_merge.h"

#include <algorithm>

#include "database/records/people_rows.h"
#include "database/rows/json.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"
#include "database/store/recording_lock.h"

namespace fulcrum::database {
namespace {

/// A merge counts more than the renamings that another station may have done in the meantime.
constexpr std::int64_t version_of_merge = 1000;

struct Following {
    const char* what;
    const char* sql;  ///< with one ?: the doubled person
};

constexpr Following following[] = {
    {QT_TRANSLATE_NOOP("errors", "attempts"), "SELECT COUNT(*) FROM attempt WHERE person_id = ?"},
    {QT_TRANSLATE_NOOP("errors", "forms of raters about them"),
     "SELECT COUNT(*) FROM rating r JOIN attempt a ON a.id = r.attempt_id WHERE r.handed_in > 0 AND "
     "a.person_id = ?"},
    {QT_TRANSLATE_NOOP("errors", "comments on them"),
     "SELECT COUNT(*) FROM comment c JOIN attempt a ON a.id = c.attempt_id WHERE c.sent > 0 AND a.person_id "
     "= ?"},
    {QT_TRANSLATE_NOOP("errors", "errors of theirs that were confirmed or struck"),
     "SELECT COUNT(*) FROM error_review e JOIN attempt a ON a.id = e.attempt_id WHERE a.person_id = ?"},
    {QT_TRANSLATE_NOOP("errors", "personal goals"), "SELECT COUNT(*) FROM personal_goal WHERE person_id = ?"},
    {QT_TRANSLATE_NOOP("errors", "decisions on standings"),
     "SELECT COUNT(*) FROM standing_override WHERE person_id = ?"},
    {QT_TRANSLATE_NOOP("errors", "moves of curriculum"),
     "SELECT COUNT(*) FROM curriculum_move WHERE person_id = ?"},
    {QT_TRANSLATE_NOOP("errors", "comments written, drafts included"),
     "SELECT COUNT(*) FROM comment WHERE author_id = ?"},
    {QT_TRANSLATE_NOOP("errors", "errors that they confirmed or struck"),
     "SELECT COUNT(*) FROM error_review WHERE author_id = ?"},
    {QT_TRANSLATE_NOOP("errors", "forms filled in, drafts included"),
     "SELECT COUNT(*) FROM rating WHERE rater_id = ?"},
    {QT_TRANSLATE_NOOP("errors", "people merged earlier"),
     "SELECT COUNT(*) FROM person WHERE merged_into = ?"},
};

std::vector<std::string> texts(Connection& connection, const QString& sql, const std::string& value) {
    Query rows(connection, sql);
    for (int mark = 0; mark < sql.count('?'); ++mark) rows.bind(value);
    std::vector<std::string> found;
    while (rows.next()) found.push_back(rows.text(0));
    return found;
}

std::vector<std::string> cohorts_of(Connection& connection, const std::string& column,
                                    const std::string& person) {
    return texts(
        connection,
        "SELECT " + QString::fromStdString(column) +
            " FROM cohort WHERE id IN (SELECT m.cohort_id FROM cohort_member m WHERE m.person_id = ? UNION "
            "SELECT e.cohort_id FROM cohort_educator e WHERE e.person_id = ?) ORDER BY name",
        person);
}

/// What one of the two accounts decided about the other, or about those merged into it. Nobody decides on
/// the own standing: once they are one person, it does not count.
std::int64_t own_after(Connection& connection, const std::string& from, const std::string& into) {
    const auto of_both = [](const char* column) -> QString {
        return QString(column) + " IN (SELECT person_id FROM " + person_owners +
               " same WHERE same.owner_id IN (?, ?))";
    };
    const QString sql = "SELECT (SELECT COUNT(*) FROM standing_override o WHERE " + of_both("o.person_id") +
                        " AND " + of_both("o.author_id") +
                        ") + (SELECT COUNT(*) FROM curriculum_move m WHERE " + of_both("m.person_id") +
                        " AND " + of_both("m.author_id") +
                        ") + (SELECT COUNT(*) FROM rating r JOIN attempt a ON a.id = r.attempt_id WHERE "
                        "r.handed_in > 0 AND " +
                        of_both("a.person_id") + " AND " + of_both("r.rater_id") + ")";
    Query row(connection, sql);
    for (int both = 0; both < 6; ++both) row.bind(from).bind(into);
    return row.next() ? row.integer(0) : 0;
}

std::string in_one_line(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string in_one_line(const std::vector<Role>& roles) {
    std::vector<std::string> words;
    for (const Role role : roles) words.push_back(role_name(role));
    return in_one_line(words);
}

void require_mergeable(const Session& administrator, const Person& from, const Person& into) {
    const auto conflict = [](const Sentence& problem, const Sentence& hint) {
        throw StoreError(StoreErrorKind::conflict, problem, hint);
    };
    if (from.id == into.id)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "this is one account, not two"),
                         QT_TRANSLATE_NOOP("errors", "name the doubled account, then the one that stays"));
    if (from.kind != PersonKind::real || into.kind != PersonKind::real)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "only real people are merged"),
                         QT_TRANSLATE_NOOP("errors", "simulated people are never part of the results"));
    if (administrator.person_id() == from.id || administrator.person_id() == into.id)
        throw AccessDenied("merge_people", role_name(administrator.role()), DenialReason::own_account);
    // Repeated, it moves what a station has brought since.
    if (!from.merged_into.empty() && from.merged_into != into.id)
        conflict({QT_TRANSLATE_NOOP("errors", "%1 is merged into another account already"), from.login},
                 QT_TRANSLATE_NOOP("errors", "undo that merge first (`fulcrum people unmerge`)"));
    if (!into.merged_into.empty())
        conflict({QT_TRANSLATE_NOOP("errors", "%1 is merged into another account already"), into.login},
                 QT_TRANSLATE_NOOP("errors", "name the account that stays"));
    if (!into.active)
        conflict(
            {QT_TRANSLATE_NOOP("errors", "%1 is deactivated"), into.login},
            QT_TRANSLATE_NOOP("errors", "activate the account that stays, or merge the other way round"));
    for (const Role role : from.roles)
        if (std::find(into.roles.begin(), into.roles.end(), role) == into.roles.end())
            conflict({QT_TRANSLATE_NOOP("errors", "%1 holds a role that %2 does not: %3"), from.login,
                      into.login, Sentence(role_name(role))},
                     QT_TRANSLATE_NOOP(
                         "errors",
                         "a merge grants nothing: give that role to the account that stays, or take it "
                         "from the other one, first"));
}

void require_not_performing(const Store& store, const std::string& person) {
    for (const std::string& attempt : texts(
             store.connection(), "SELECT id FROM attempt WHERE person_id = ? AND state = 'running'", person))
        if (RecordingLock::is_held(store, attempt))
            throw StoreError(StoreErrorKind::locked,
                             QT_TRANSLATE_NOOP("errors", "the doubled account performs an attempt now"),
                             QT_TRANSLATE_NOOP("errors", "wait until it has ended"));
}

void run(Connection& connection, const char* sql, const std::vector<std::string>& values) {
    Query query(connection, sql);
    for (const std::string& value : values) query.bind(value);
    query.run();
}

/// Cohorts, drafts, and what was seen before rating: rows that are changed as people change.
void move_rows(Connection& connection, const std::string& from, const std::string& into) {
    run(connection,
        "INSERT INTO cohort_member (cohort_id, person_id) SELECT cohort_id, ? FROM cohort_member WHERE "
        "person_id = ? "
        "ON CONFLICT DO NOTHING",
        {into, from});
    run(connection,
        "INSERT INTO cohort_educator (cohort_id, person_id) SELECT cohort_id, ? FROM cohort_educator WHERE "
        "person_id "
        "= ? ON CONFLICT DO NOTHING",
        {into, from});
    run(connection, "DELETE FROM cohort_member WHERE person_id = ?", {from});
    run(connection, "DELETE FROM cohort_educator WHERE person_id = ?", {from});
    run(connection, "UPDATE comment SET author_id = ? WHERE author_id = ? AND sent = 0", {into, from});
    run(connection,
        "UPDATE rating SET rater_id = ? WHERE rater_id = ? AND handed_in = 0 AND NOT EXISTS (SELECT 1 FROM "
        "rating o "
        "WHERE o.attempt_id = rating.attempt_id AND o.form = rating.form AND o.rater_id = ?)",
        {into, from, into});
    run(connection,
        "INSERT INTO rating_seen (attempt_id, person_id, time) SELECT attempt_id, ?, time FROM rating_seen "
        "WHERE "
        "person_id = ? ON CONFLICT DO NOTHING",
        {into, from});
    for (const char* sql :
         {"DELETE FROM credential WHERE person_id = ?", "DELETE FROM person_role WHERE person_id = ?",
          "DELETE FROM sign_in WHERE person_id = ?"})
        run(connection, sql, {from});
}

void require_merge_reason(const std::string& reason) {
    if (reason.find_first_not_of(" \t\r\n") == std::string::npos || reason.size() > 4000)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a reason is missing or too long"),
                         QT_TRANSLATE_NOOP("errors", "give a reason of 1 to 4,000 characters"));
}

void set_merged_into(Connection& connection, const std::string& person, const std::string& into) {
    Query(connection, "UPDATE person SET merged_into = ?, active = 0, version = version + ? WHERE id = ?")
        .bind(into)
        .bind(version_of_merge)
        .bind(person)
        .run();
}

}  // namespace

MergePlan PersonMerge::plan(const Session& administrator, const std::string& from,
                            const std::string& into) const {
    store_.require(administrator, Operation::manage_people);
    store_.require(administrator, Operation::manage_roles);
    MergePlan plan{read_person(store_, from), read_person(store_, into), {}, {}};
    require_mergeable(administrator, plan.from, plan.into);
    require_not_performing(store_, from);
    for (const Following& one : following) {
        Query row(store_.connection(), one.sql);
        row.bind(from);
        if (row.next() && row.integer(0) > 0) plan.counts.push_back({one.what, row.integer(0)});
    }
    if (const std::int64_t own = own_after(store_.connection(), from, into); own > 0)
        plan.counts.push_back(
            {QT_TRANSLATE_NOOP("errors",
                               "decisions and forms of one account about the other, which then do "
                               "not count"),
             own});
    plan.cohorts = cohorts_of(store_.connection(), "name", from);
    return plan;
}

MergePlan PersonMerge::merge(const Session& administrator, const std::string& from, const std::string& into,
                             const std::string& reason) const {
    require_merge_reason(reason);
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    const MergePlan done = plan(administrator, from, into);
    std::vector<RecordName> records = {{RecordKind::person, from}};
    for (const std::string& cohort : cohorts_of(connection, "id", from)) {
        records.push_back({RecordKind::cohort, cohort});
        run(connection, "UPDATE cohort SET version = version + 1 WHERE id = ?", {cohort});
    }
    move_rows(connection, from, into);
    // Those who were merged into this one: a merge is one step, so that readers ask once.
    for (const std::string& earlier :
         texts(connection, "SELECT id FROM person WHERE merged_into = ?", from)) {
        set_merged_into(connection, earlier, into);
        records.push_back({RecordKind::person, earlier});
    }
    set_merged_into(connection, from, into);
    Audit(store_).append(administrator, from, "person.merge",
                         json_object({{"into", into},
                                      {"login", done.from.login},
                                      {"roles", in_one_line(done.from.roles)},
                                      {"cohorts", in_one_line(done.cohorts)},
                                      {"reason", reason}}),
                         records);
    transaction.commit();
    return done;
}

void PersonMerge::undo(const Session& administrator, const std::string& from,
                       const std::string& reason) const {
    store_.require(administrator, Operation::manage_people);
    store_.require(administrator, Operation::manage_roles);
    require_merge_reason(reason);
    Transaction transaction(store_.connection());
    const Person person = read_person(store_, from);
    if (person.merged_into.empty())
        throw StoreError(StoreErrorKind::conflict,
                         {QT_TRANSLATE_NOOP("errors", "%1 is not merged into another account"), person.login},
                         QT_TRANSLATE_NOOP("errors", "name an account that was merged"));
    if (administrator.person_id() == person.merged_into)
        throw AccessDenied("merge_people", role_name(administrator.role()), DenialReason::own_account);
    set_merged_into(store_.connection(), from, {});
    Audit(store_).append(administrator, from, "person.unmerge",
                         json_object({{"from", person.merged_into}, {"reason", reason}}),
                         {{RecordKind::person, from}});
    transaction.commit();
}

}  // namespace fulcrum::database
