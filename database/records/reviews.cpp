// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/reviews.h"

#include <cmath>

#include "database/records/attempt_query.h"
#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"

namespace fulcrum::database {
namespace {

const char* const columns =
    "SELECT c.id, c.attempt_id, c.author_id, p.display_name, c.time_s, c.text, c.created, c.sent, c.read "
    "FROM comment c JOIN person p ON p.id = c.author_id JOIN attempt a ON a.id = c.attempt_id ";

std::vector<Comment> read_rows(Query& rows) {
    std::vector<Comment> comments;
    while (rows.next()) {
        comments.push_back({rows.text(0), rows.text(1), rows.text(2), rows.text(3), rows.real(4),
                            rows.text(5), rows.integer(6), rows.integer(7), rows.integer(8)});
    }
    return comments;
}

struct Place {
    std::string attempt_id, author_id, person_id;
    bool sent = false, read = false;
};

Place place_of(const Store& store, const std::string& comment_id) {
    Query row(store.connection(),
              "SELECT c.attempt_id, c.author_id, " + owner_of("a.person_id") +
                  ", c.sent, c.read FROM comment c JOIN attempt a ON a.id = c.attempt_id WHERE c.id = ?");
    row.bind(comment_id);
    if (!row.next())
        throw StoreError(StoreErrorKind::not_found,
                         {QT_TRANSLATE_NOOP("errors", "no comment %1"), comment_id},
                         QT_TRANSLATE_NOOP("errors", "open the attempt again"));
    return {row.text(0), row.text(1), row.text(2), row.flag(3), row.flag(4)};
}

void require_text(double time_s, const std::string& text) {
    if (text.find_first_not_of(" \t\n") == std::string::npos || text.size() > 4000) {
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a comment has 1 to 4,000 characters"),
                         QT_TRANSLATE_NOOP("errors", "write or shorten it"));
    }
    if (!std::isfinite(time_s) || time_s < 0) {
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a comment's time is not within the attempt"),
                         QT_TRANSLATE_NOOP("errors", "choose a time from 0 s on"));
    }
}

/// Drafts are their author's alone.
Place require_own_draft(const Store& store, const Session& educator, const std::string& comment_id) {
    Place place = place_of(store, comment_id);
    store.require(educator, Operation::comment, Subject::person(place.person_id));
    if (place.author_id != educator.person_id())
        throw AccessDenied("comment", role_name(educator.role()), DenialReason::other_comment);
    if (place.sent)
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the comment was sent already"),
                         QT_TRANSLATE_NOOP("errors", "write another comment"));
    return place;
}

}  // namespace

std::vector<Comment> Reviews::comments(const Session& session, const std::string& attempt_id) const {
    store_.require(session, Operation::read_comment, Subject::person(person_of(store_, attempt_id)));
    Query rows(store_.connection(), QString(columns) +
                                        "WHERE c.attempt_id = ? AND (c.sent > 0 OR c.author_id = ?) "
                                        "ORDER BY c.time_s, c.created, c.id");
    rows.bind(attempt_id).bind(session.person_id());
    return read_rows(rows);
}

std::string Reviews::write(const Session& educator, const std::string& attempt_id, double time_s,
                           const std::string& text, bool send) const {
    store_.require(educator, Operation::comment, Subject::person(person_of(store_, attempt_id)));
    require_text(time_s, text);
    Transaction transaction(store_.connection());
    std::string id = random_uuid();
    Query(store_.connection(),
          "INSERT INTO comment (id, attempt_id, author_id, time_s, text, created) VALUES (?, ?, ?, ?, ?, ?)")
        .bind(id)
        .bind(attempt_id)
        .bind(educator.person_id())
        .bind(time_s)
        .bind(text)
        .bind(store_.now())
        .run();
    if (send) this->send(educator, id);
    transaction.commit();
    return id;
}

void Reviews::edit_draft(const Session& educator, const std::string& comment_id, double time_s,
                         const std::string& text) const {
    Transaction transaction(store_.connection());
    require_own_draft(store_, educator, comment_id);
    require_text(time_s, text);
    Query(store_.connection(), "UPDATE comment SET time_s = ?, text = ? WHERE id = ?")
        .bind(time_s)
        .bind(text)
        .bind(comment_id)
        .run();
    transaction.commit();
}

void Reviews::send(const Session& educator, const std::string& comment_id) const {
    Transaction transaction(store_.connection());
    const Place place = require_own_draft(store_, educator, comment_id);
    Query(store_.connection(), "UPDATE comment SET sent = ? WHERE id = ?")
        .bind(store_.now())
        .bind(comment_id)
        .run();
    // What was said stays out of the chain's payload: the administrator reads the chain, not the reviews.
    Audit(store_).append(educator, comment_id, "comment.send", json_object({{"attempt", place.attempt_id}}),
                         {{RecordKind::comment, comment_id}});
    transaction.commit();
}

void Reviews::delete_draft(const Session& educator, const std::string& comment_id) const {
    Transaction transaction(store_.connection());
    require_own_draft(store_, educator, comment_id);
    Query(store_.connection(), "DELETE FROM comment WHERE id = ?").bind(comment_id).run();
    transaction.commit();
}

std::vector<Comment> Reviews::drafts(const Session& educator) const {
    store_.require(educator, Operation::comment);
    Query rows(store_.connection(),
               QString(columns) + "WHERE c.sent = 0 AND c.author_id = ? ORDER BY c.created DESC, c.id");
    rows.bind(educator.person_id());
    return read_rows(rows);
}

std::vector<Comment> Reviews::unread(const Session& trainee) const {
    store_.require(trainee, Operation::read_comment, Subject::person(trainee.person_id()));
    Query rows(store_.connection(), QString(columns) + "WHERE " + belongs_to("a.person_id") +
                                        " AND c.sent > 0 AND c.read = 0 ORDER BY c.sent DESC, c.id");
    rows.bind(trainee.person_id());
    return read_rows(rows);
}

void Reviews::mark_read(const Session& trainee, const std::string& comment_id) const {
    Transaction transaction(store_.connection());
    const Place place = place_of(store_, comment_id);
    store_.require(trainee, Operation::mark_comment_read, Subject::person(place.person_id));
    if (!place.sent)
        throw StoreError(StoreErrorKind::not_found,
                         {QT_TRANSLATE_NOOP("errors", "no comment %1"), comment_id},
                         QT_TRANSLATE_NOOP("errors", "open the attempt again"));
    if (!place.read) {
        Query(store_.connection(), "UPDATE comment SET read = ? WHERE id = ?")
            .bind(store_.now())
            .bind(comment_id)
            .run();
    }
    transaction.commit();
}

}  // namespace fulcrum::database
