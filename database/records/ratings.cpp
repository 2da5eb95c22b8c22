// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/ratings.h"

#include <algorithm>
#include <map>
#include <set>

#include "database/records/attempt_query.h"
#include "database/records/curricula.h"
#include "database/records/people_rows.h"
#include "database/records/rating_seen.h"
#include "database/records/standings.h"
#include "database/rows/crypto.h"
#include "database/rows/enum_column.h"
#include "database/rows/json.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

constexpr std::size_t longest_remark = 4000;

const char* const rating_columns =
    "SELECT r.id, r.attempt_id, r.rater_id, p.display_name, r.form_digest, r.blinding, r.begun, r.handed_in, "
    "r.remark, COALESCE(l.time, 0) FROM rating r JOIN person p ON p.id = r.rater_id JOIN attempt a ON a.id = "
    "r.attempt_id LEFT JOIN rating_release l ON l.rating_id = r.id ";

/// Reads forms once each.
class Forms {
  public:
    explicit Forms(Connection& connection) : connection_(connection) {}
    const ObserverForm& of(const std::string& digest) {
        const auto known = forms_.find(digest);
        if (known != forms_.end()) return known->second;
        Query row(connection_, "SELECT text FROM form_text WHERE digest = ?");
        row.bind(digest);
        if (!row.next())
            throw StoreError(StoreErrorKind::corrupt,
                             {QT_TRANSLATE_NOOP("errors", "the form %1 of a rating is missing"), digest},
                             QT_TRANSLATE_NOOP("errors", "restore the newest backup"));
        return forms_.emplace(digest, parse_form(row.text(0), "form " + digest)).first->second;
    }

  private:
    Connection& connection_;
    std::map<std::string, ObserverForm> forms_;
};

void read_answers(Connection& connection, RatingRow& row) {
    row.answers.assign(row.form.items.size(), std::nullopt);
    row.answered.assign(row.form.items.size(), false);
    Query items(connection, "SELECT number, value FROM rating_item WHERE rating_id = ? ORDER BY number");
    items.bind(row.id);
    while (items.next()) {
        const auto number = static_cast<std::size_t>(items.integer(0));
        if (number >= row.answers.size())
            throw StoreError(
                StoreErrorKind::corrupt,
                {QT_TRANSLATE_NOOP("errors", "rating %1 has more answers than its form"), row.id},
                QT_TRANSLATE_NOOP("errors", "restore the newest backup"));
        row.answered[number] = true;
        if (!items.is_null(1)) row.answers[number] = static_cast<int>(items.integer(1));
    }
}

std::vector<RatingRow> read_ratings(Connection& connection, Query& rows) {
    std::vector<RatingRow> ratings;
    Forms forms(connection);
    while (rows.next()) {
        RatingRow row;
        row.id = rows.text(0);
        row.attempt_id = rows.text(1);
        row.rater_id = rows.text(2);
        row.rater_name = rows.text(3);
        row.form = forms.of(rows.text(4));
        row.blinding = enum_of(rows.text(5), blindings, "blinding of rating " + row.id);
        row.begun = rows.integer(6);
        row.handed_in = rows.integer(7);
        row.remark = rows.text(8);
        row.released = rows.integer(9);
        ratings.push_back(std::move(row));
    }
    for (RatingRow& row : ratings) read_answers(connection, row);
    return ratings;
}

/// What the session may see of all forms of one attempt.
AttemptRatings shown_to(const Session& session, std::vector<RatingRow> all) {
    const auto own = [&](const RatingRow& row) { return row.rater_id == session.person_id(); };
    const bool rating_alone = std::any_of(all.begin(), all.end(), [&](const RatingRow& row) {
        return own(row) && row.handed_in == 0 && row.form.blind;
    });
    const bool has_rated = std::any_of(all.begin(), all.end(),
                                       [&](const RatingRow& row) { return own(row) && row.handed_in > 0; });
    AttemptRatings shown;
    for (RatingRow& row : all) {
        if (row.handed_in == 0 && !own(row)) continue;
        bool visible = own(row);
        if (session.role() == Role::trainee) {
            visible = row.released > 0;
        } else if (!visible && !rating_alone) {
            visible = has_rated || row.released > 0 || !row.form.blind;
        }
        if (visible)
            shown.rows.push_back(std::move(row));
        else
            ++shown.hidden;
    }
    std::stable_sort(shown.rows.begin(), shown.rows.end(), [](const RatingRow& a, const RatingRow& b) {
        return (a.handed_in == 0) > (b.handed_in == 0);
    });
    return shown;
}

RatingRow require_own_draft(const Store& store, const Session& rater, const std::string& rating_id) {
    Query rows(store.connection(), QString(rating_columns) + "WHERE r.id = ?");
    rows.bind(rating_id);
    std::vector<RatingRow> found = read_ratings(store.connection(), rows);
    if (found.empty())
        throw StoreError(StoreErrorKind::not_found, {QT_TRANSLATE_NOOP("errors", "no rating %1"), rating_id},
                         QT_TRANSLATE_NOOP("errors", "open the attempt again"));
    require_attempt(store, rater, Operation::rate, found[0].attempt_id);
    if (found[0].rater_id != rater.person_id())
        throw AccessDenied("rate", role_name(rater.role()), DenialReason::other_form);
    if (found[0].handed_in > 0)
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the form was handed in already"),
                         QT_TRANSLATE_NOOP("errors", "what was handed in is never changed"));
    return std::move(found[0]);
}

void require_ratable(const Store& store, const std::string& attempt_id) {
    const AttemptSummary attempt = query_attempt(store, attempt_id);
    if (attempt.state == AttemptState::voided || attempt.state == AttemptState::running)
        throw StoreError(StoreErrorKind::conflict,
                         attempt.state == AttemptState::voided
                             ? Sentence(QT_TRANSLATE_NOOP("errors", "the attempt is voided"))
                             : Sentence(QT_TRANSLATE_NOOP("errors", "the attempt has not ended")),
                         QT_TRANSLATE_NOOP("errors", "rate an attempt that has ended and counts"));
}

std::string store_form(Connection& connection, const ObserverForm& form) {
    const std::string digest = text_digest(form.text);
    Query known(connection, "SELECT 1 FROM form_text WHERE digest = ?");
    known.bind(digest);
    if (!known.next())
        Query(connection, "INSERT INTO form_text (digest, text) VALUES (?, ?)")
            .bind(digest)
            .bind(form.text)
            .run();
    return digest;
}

void check_answers(const ObserverForm& form, const FormAnswers& answers, const std::vector<bool>& answered,
                   const std::string& remark) {
    if (answers.size() != form.items.size() || answered.size() != form.items.size())
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "the form %1 has another number of items"), form.name()},
            QT_TRANSLATE_NOOP("errors", "give one answer per item"));
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const FormItem& item = form.items[i];
        if (answers[i] && (*answers[i] < item.lowest || *answers[i] > item.highest))
            throw StoreError(
                StoreErrorKind::bad_value,
                {QT_TRANSLATE_NOOP("errors", "%1: %2 is outside the scale"), item.title, *answers[i]},
                {QT_TRANSLATE_NOOP("errors", "rate from %1 to %2"), item.lowest, item.highest});
        if (answered[i] && !answers[i] && !item.optional)
            throw StoreError(StoreErrorKind::bad_value,
                             {QT_TRANSLATE_NOOP("errors", "%1 must be rated"), item.title},
                             QT_TRANSLATE_NOOP("errors", "only optional items can be left as not seen"));
    }
    if (remark.size() > longest_remark)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a remark has at most 4,000 characters"),
                         QT_TRANSLATE_NOOP("errors", "shorten it"));
}

}  // namespace

static_assert(trace_not_kept == -1);  // as the statement says: there is nothing to watch

namespace {

/// Those who may rate may see what there is to rate, also where the store takes no ratings.
void require_rater(const Store& store, const Session& rater) {
    const bool closed = store.is_demo() && read_setting(store.connection(), "demo_sealed") == "1" &&
                        scope_of(rater.role(), Operation::rate) != Scope::none;
    store.require(rater, closed ? Operation::read_ratings : Operation::rate);
}

/// The attempts whose ratings a curriculum waits for, of the people whom the rater may rate, and whether only
/// blind ones count.
std::map<std::string, bool> awaited_attempts(const Store& store, const Session& rater,
                                             const Curriculum& curriculum) {
    std::map<std::string, bool> awaited;
    std::vector<std::string> people;
    if (!asks_for_ratings(curriculum)) return awaited;
    {
        Query rows(store.connection(), "SELECT DISTINCT p.id FROM attempt a " +
                                           join_owner("a.person_id", "p") + "WHERE a.mode = 'assessed' AND " +
                                           visible_people(rater, Operation::rate, "p.id"));
        bind_visible_people(rows, rater, Operation::rate);
        while (rows.next()) people.push_back(rows.text(0));
    }
    for (const std::string& person : people) {
        if (person == rater.person_id()) continue;
        const std::int64_t now = store.now();
        const PersonRecord record = Standings(store).record(rater, person, curriculum, false);
        // What another version would wait for is not said.
        if (!missing_in(record.assignments, now).empty()) continue;
        for (const TaskStanding& one : standing_of(record, now)) {
            if (one.standing != Standing::awaiting_rating || one.rated_attempt.empty()) continue;
            const CurriculumTask* task = curriculum_at(record.assignments, now)->find(one.task);
            awaited[one.rated_attempt] = task->ratings && task->ratings->blind;
        }
    }
    return awaited;
}

}  // namespace

std::vector<RatableAttempt> Ratings::to_rate(const Session& rater, const Curriculum* curriculum,
                                             int limit) const {
    require_rater(store_, rater);
    const std::map<std::string, bool> awaited =
        curriculum != nullptr ? awaited_attempts(store_, rater, *curriculum) : std::map<std::string, bool>();
    // Bound one by one: there are at most as many as people and rated tasks.
    QString first = "0";
    if (!awaited.empty())
        first =
            "CASE WHEN a.id IN (?" + QString(", ?").repeated(int(awaited.size()) - 1) + ") THEN 1 ELSE 0 END";
    Query rows(
        store_.connection(),
        "SELECT a.id, a.task_id, a.variant, a.started, a.duration_s, (SELECT COUNT(*) FROM rating r WHERE "
        "r.attempt_id = a.id AND r.handed_in > 0), (SELECT COUNT(*) FROM rating r WHERE r.attempt_id = a.id "
        "AND r.handed_in > 0 AND r.rater_id = ?), EXISTS (SELECT 1 FROM rating r WHERE r.attempt_id = a.id "
        "AND r.handed_in = 0 AND r.rater_id = ?), a.id IN (" +
            seen_attempts() + "), " + first + " AS awaited FROM attempt a " + join_owner("a.person_id", "p") +
            "WHERE a.state <> 'running' AND a.events <> -1 AND p.id <> ? AND NOT EXISTS (SELECT 1 FROM "
            "attempt_void v WHERE v.attempt_id = a.id) AND " +
            QString(store_.is_demo() ? "1 = 1" : "p.kind = 'real'") + " AND " +
            visible_people(rater, Operation::rate, "p.id") +
            " ORDER BY awaited DESC, a.started DESC, a.id LIMIT ?");
    for (int i = 0; i < 3; ++i) rows.bind(rater.person_id());
    for (const auto& one : awaited) rows.bind(one.first);
    rows.bind(rater.person_id());
    bind_visible_people(rows, rater, Operation::rate);
    rows.bind(limit);
    std::vector<RatableAttempt> attempts;
    while (rows.next()) {
        const auto asked = awaited.find(rows.text(0));
        attempts.push_back({rows.text(0), rows.text(1), rows.text(2), rows.integer(3), rows.real(4),
                            static_cast<int>(rows.integer(5)), static_cast<int>(rows.integer(6)),
                            rows.flag(7), !rows.flag(8), rows.flag(9),
                            asked != awaited.end() && asked->second});
    }
    return attempts;
}

AttemptRatings Ratings::of_attempt(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_ratings, attempt_id);
    Query rows(store_.connection(),
               QString(rating_columns) + "WHERE r.attempt_id = ? ORDER BY r.handed_in, r.id");
    rows.bind(attempt_id);
    return shown_to(session, read_ratings(store_.connection(), rows));
}

std::map<std::string, AttemptRatings> Ratings::of_person(const Session& session, const std::string& person_id,
                                                         const std::string& task_id) const {
    store_.require(session, Operation::read_ratings, Subject::person(person_id));
    Query rows(store_.connection(), QString(rating_columns) + "WHERE " + belongs_to("a.person_id") +
                                        " AND (? = '' OR a.task_id = ?) ORDER BY "
                                        "r.handed_in, r.id");
    rows.bind(person_id).bind(task_id).bind(task_id);
    std::map<std::string, std::vector<RatingRow>> by_attempt;
    for (RatingRow& row : read_ratings(store_.connection(), rows)) {
        std::vector<RatingRow>& list = by_attempt[row.attempt_id];
        list.push_back(std::move(row));
    }
    std::map<std::string, AttemptRatings> shown;
    for (auto& [attempt, list] : by_attempt) {
        AttemptRatings one = shown_to(session, std::move(list));
        if (!one.rows.empty() || one.hidden > 0) shown.emplace(attempt, std::move(one));
    }
    return shown;
}

std::string Ratings::begin(const Session& rater, const std::string& attempt_id,
                           const ObserverForm& form) const {
    require_attempt(store_, rater, Operation::rate, attempt_id);
    require_ratable(store_, attempt_id);
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    {
        Query own(connection, "SELECT form, handed_in FROM rating WHERE attempt_id = ? AND rater_id = ?");
        own.bind(attempt_id).bind(rater.person_id());
        while (own.next()) {
            const bool same = own.text(0).substr(0, own.text(0).find('@')) == form.id;
            if (same || own.integer(1) == 0)
                throw StoreError(
                    StoreErrorKind::conflict,
                    own.integer(1) == 0
                        ? Sentence(QT_TRANSLATE_NOOP(
                              "errors", "you have a form for this attempt that is not handed in yet"))
                        : Sentence(QT_TRANSLATE_NOOP("errors",
                                                     "you handed in this form for this attempt already")),
                    QT_TRANSLATE_NOOP("errors", "complete that one, or choose another form"));
        }
    }
    const Blinding blinding = !form.blind                               ? Blinding::not_asked
                              : has_seen(connection, rater, attempt_id) ? Blinding::lifted
                                                                        : Blinding::kept;
    const std::string digest = store_form(connection, form);
    std::string id = random_uuid();
    Query(connection,
          "INSERT INTO rating (id, attempt_id, rater_id, form, form_digest, blinding, begun) VALUES (?, ?, "
          "?, ?, "
          "?, ?, ?)")
        .bind(id)
        .bind(attempt_id)
        .bind(rater.person_id())
        .bind(form.name())
        .bind(digest)
        .bind(row_of(blindings, blinding).name)
        .bind(store_.now())
        .run();
    transaction.commit();
    return id;
}

void Ratings::answer(const Session& rater, const std::string& rating_id, const FormAnswers& answers,
                     const std::vector<bool>& answered, const std::string& remark) const {
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    const RatingRow draft = require_own_draft(store_, rater, rating_id);
    check_answers(draft.form, answers, answered, remark);
    Query(connection, "DELETE FROM rating_item WHERE rating_id = ?").bind(rating_id).run();
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (!answered[i]) continue;
        Query row(connection, "INSERT INTO rating_item (rating_id, number, item, value) VALUES (?, ?, ?, ?)");
        row.bind(rating_id).bind(static_cast<std::int64_t>(i)).bind(draft.form.items[i].id);
        if (answers[i])
            row.bind(*answers[i]);
        else
            row.bind_null();
        row.run();
    }
    Query(connection, "UPDATE rating SET remark = ? WHERE id = ?").bind(remark).bind(rating_id).run();
    transaction.commit();
}

void Ratings::discard(const Session& rater, const std::string& rating_id) const {
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    require_own_draft(store_, rater, rating_id);
    Query(connection, "DELETE FROM rating_item WHERE rating_id = ?").bind(rating_id).run();
    Query(connection, "DELETE FROM rating WHERE id = ?").bind(rating_id).run();
    transaction.commit();
}

void Ratings::hand_in(const Session& rater, const std::string& rating_id) const {
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    const RatingRow draft = require_own_draft(store_, rater, rating_id);
    require_ratable(store_, draft.attempt_id);
    if (const auto left = first_unanswered(draft.form, draft.answers, draft.answered))
        throw StoreError(StoreErrorKind::bad_value,
                         {QT_TRANSLATE_NOOP("errors", "%1 is not rated yet"), draft.form.items[*left].title},
                         QT_TRANSLATE_NOOP("errors", "rate every item of the form"));
    // The attempt may have been opened at another station or at the server, or under an account that was
    // merged into this one, since the form was begun.
    const bool lifted = draft.blinding == Blinding::kept && has_seen(connection, rater, draft.attempt_id);
    const std::string blinding = row_of(blindings, lifted ? Blinding::lifted : draft.blinding).name;
    Query(connection, "UPDATE rating SET handed_in = ?, blinding = ? WHERE id = ?")
        .bind(store_.now())
        .bind(blinding)
        .bind(rating_id)
        .run();
    // The answers stay out of the chain's payload: the administrator reads the chain, not the ratings.
    Audit(store_).append(
        rater, rating_id, "rating.hand_in",
        json_object({{"attempt", draft.attempt_id}, {"blinding", blinding}, {"form", draft.form.name()}}),
        {{RecordKind::rating, rating_id}, {RecordKind::form, text_digest(draft.form.text)}});
    transaction.commit();
}

int Ratings::release(const Session& educator, const std::string& attempt_id) const {
    require_attempt(store_, educator, Operation::release_ratings, attempt_id);
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    std::vector<std::string> ids;
    {
        Query rows(
            connection,
            "SELECT r.id FROM rating r WHERE r.attempt_id = ? AND r.handed_in > 0 AND NOT EXISTS (SELECT 1 "
            "FROM rating_release l WHERE l.rating_id = r.id) ORDER BY r.handed_in, r.id");
        rows.bind(attempt_id);
        while (rows.next()) ids.push_back(rows.text(0));
    }
    // One moment for all: a curriculum judges forms that are released together as one.
    const std::int64_t now = store_.now();
    for (const std::string& id : ids) {
        Query(connection, "INSERT INTO rating_release (rating_id, person_id, time) VALUES (?, ?, ?)")
            .bind(id)
            .bind(educator.person_id())
            .bind(now)
            .run();
        Audit(store_).append(educator, id, "rating.release", json_object({{"attempt", attempt_id}}),
                             {{RecordKind::rating_release, id}});
    }
    transaction.commit();
    return static_cast<int>(ids.size());
}

std::vector<FormAgreement> Ratings::agreement(const Session& rater) const {
    require_rater(store_, rater);
    Query rows(store_.connection(), QString(rating_columns) + join_owner("a.person_id", "w") +
                                        "WHERE r.handed_in > 0 AND NOT EXISTS (SELECT 1 FROM "
                                        "attempt_void v WHERE v.attempt_id = a.id) AND " +
                                        (store_.is_demo() ? "1 = 1" : "w.kind = 'real'") + " AND " +
                                        visible_people(rater, Operation::rate, "w.id") +
                                        " ORDER BY r.form, r.handed_in, r.id");
    bind_visible_people(rows, rater, Operation::rate);
    std::map<std::string, std::vector<RaterScore>> scores;
    std::map<std::string, FormAgreement> forms;
    // Two accounts of one rater agree with nobody: of two forms on one attempt the newest is taken, as in
    // rules.
    const std::map<std::string, std::string> merged = merged_people(store_.connection());
    for (const RatingRow& row : read_ratings(store_.connection(), rows)) {
        FormAgreement& form = forms[row.form.name()];
        form.form = row.form.name();
        form.title = row.form.title;
        ++form.forms;
        if (const std::optional<double> share = form_share(row.form, row.answers))
            scores[form.form].push_back(
                {row.attempt_id, merged.count(row.rater_id) != 0 ? merged.at(row.rater_id) : row.rater_id,
                 *share});
    }
    std::vector<FormAgreement> result;
    for (auto& [name, form] : forms) {
        const RatingTable table = largest_complete_table(scores[name]);
        form.attempts = static_cast<int>(table.targets.size());
        form.raters = static_cast<int>(table.raters.size());
        form.icc = agreement_of(table);
        result.push_back(std::move(form));
    }
    return result;
}

}  // namespace fulcrum::database
