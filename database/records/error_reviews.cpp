// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/error_reviews.h"

#include <algorithm>

#include "database/records/attempt_query.h"
#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "database/rows/enum_column.h"
#include "database/rows/json.h"
#include "database/store/audit.h"
#include "sim_core/telemetry/event_types.h"

namespace fulcrum::database {
namespace {

constexpr std::int64_t longest_reason = 1000;

/// Characters, not bytes.
std::int64_t length_of(const std::string& text) {
    return std::count_if(text.begin(), text.end(),
                         [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; });
}

void require_reason_of_review(const std::string& reason) {
    if (reason.find_first_not_of(" \t\r\n") != std::string::npos && length_of(reason) <= longest_reason)
        return;
    throw StoreError(
        StoreErrorKind::bad_value,
        QT_TRANSLATE_NOOP("errors",
                          "the reason for confirming or striking an error has 1 to 1,000 characters"),
        QT_TRANSLATE_NOOP("errors", "write or shorten it"));
}

/// Against the record: whatever a caller names, only an error that was recorded is reviewed.
void require_recorded_error(const Store& store, const Session& educator, const std::string& attempt_id,
                            const Event& event) {
    if (!is_error(event.kind))
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "'%1' is no error that the program records of whoever performs"),
             std::string(event_name(event.kind))},
            QT_TRANSLATE_NOOP("errors", "choose an error in the list of events"));
    Query row(store.connection(), "SELECT 1 FROM attempt WHERE id = ? AND state = 'running'");
    row.bind(attempt_id);
    if (row.next())
        throw StoreError(StoreErrorKind::conflict,
                         {QT_TRANSLATE_NOOP("errors", "attempt %1 is still being recorded"), attempt_id},
                         QT_TRANSLATE_NOOP("errors", "wait until it has ended"));
    const std::vector<Event> recorded = Attempts(store).read_events(educator, attempt_id);
    const bool found = std::any_of(recorded.begin(), recorded.end(), [&](const Event& one) {
        return one.tick == event.tick && one.kind == event.kind && one.hand == event.hand &&
               one.tissue == event.tissue && one.detail == event.detail;
    });
    if (!found)
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors",
                               "the record of attempt %1 has no '%2' at tick %3 with this hand, "
                               "tissue and detail"),
             attempt_id, std::string(event_name(event.kind)), event.tick},
            QT_TRANSLATE_NOOP("errors", "open the attempt again and choose an error in the list of events"));
}

/// Later than every other one of this error, also where two are made within a millisecond or the clock was
/// set back: the newest counts.
std::int64_t time_after_others(const Store& store, const std::string& attempt_id, const Event& event) {
    Query row(
        store.connection(),
        "SELECT COALESCE(MAX(time), 0) FROM error_review WHERE attempt_id = ? AND tick = ? AND kind = ? "
        "AND hand = ? AND tissue = ? AND detail = ?");
    row.bind(attempt_id)
        .bind(static_cast<std::int64_t>(event.tick))
        .bind(std::string(event_name(event.kind)))
        .bind(static_cast<std::int64_t>(event.hand))
        .bind(static_cast<std::int64_t>(event.tissue))
        .bind(static_cast<std::int64_t>(event.detail));
    const std::int64_t newest = row.next() ? row.integer(0) : 0;
    return std::max(store.now(), newest + 1);
}

Event event_of(const ErrorReview& review) {
    Event event;
    event.tick = review.tick;
    event.kind = review.kind;
    event.hand = review.hand;
    event.tissue = review.tissue;
    event.detail = review.detail;
    return event;
}

}  // namespace

std::vector<ErrorReview> ErrorReviews::history(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    Query rows(store_.connection(),
               "SELECT e.id, e.author_id, p.display_name, e.tick, e.kind, e.hand, e.tissue, e.detail, "
               "e.verdict, e.reason, e.time FROM error_review e JOIN person p ON p.id = e.author_id WHERE "
               "e.attempt_id = ? ORDER BY e.time, e.id");
    rows.bind(attempt_id);
    std::vector<ErrorReview> reviews;
    while (rows.next()) {
        const std::string place = "error_review " + rows.text(0);
        ErrorReview review;
        review.id = rows.text(0);
        review.attempt_id = attempt_id;
        review.author_id = rows.text(1);
        review.author_name = rows.text(2);
        review.tick = static_cast<std::uint32_t>(rows.integer(3));
        review.kind = enum_of(rows.text(4), event_kinds, place);
        review.hand = static_cast<std::uint8_t>(rows.integer(5));
        review.tissue = static_cast<std::int8_t>(rows.integer(6));
        review.detail = static_cast<std::int32_t>(rows.integer(7));
        review.verdict = enum_of(rows.text(8), error_verdicts, place);
        review.reason = rows.text(9);
        review.time = rows.integer(10);
        reviews.push_back(std::move(review));
    }
    return reviews;
}

std::vector<ErrorReview> ErrorReviews::in_force(const Session& session, const std::string& attempt_id) const {
    std::vector<ErrorReview> newest;
    for (ErrorReview& review : history(session, attempt_id)) {
        const Event event = event_of(review);
        const auto same = std::find_if(newest.begin(), newest.end(),
                                       [&](const ErrorReview& one) { return one.is_of(event); });
        if (same == newest.end())
            newest.push_back(std::move(review));
        else
            *same = std::move(review);
    }
    std::stable_sort(newest.begin(), newest.end(),
                     [](const ErrorReview& a, const ErrorReview& b) { return a.tick < b.tick; });
    return newest;
}

std::string ErrorReviews::add(const Session& educator, const std::string& attempt_id, const Event& event,
                              ErrorVerdict verdict, const std::string& reason) const {
    require_attempt(store_, educator, Operation::review_error, attempt_id);
    require_reason_of_review(reason);
    Transaction transaction(store_.connection());
    require_recorded_error(store_, educator, attempt_id, event);
    std::string id = random_uuid();
    Query(store_.connection(),
          "INSERT INTO error_review (id, attempt_id, author_id, tick, kind, hand, tissue, detail, verdict, "
          "reason, time) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(id)
        .bind(attempt_id)
        .bind(educator.person_id())
        .bind(static_cast<std::int64_t>(event.tick))
        .bind(std::string(event_name(event.kind)))
        .bind(static_cast<std::int64_t>(event.hand))
        .bind(static_cast<std::int64_t>(event.tissue))
        .bind(static_cast<std::int64_t>(event.detail))
        .bind(std::string(row_of(error_verdicts, verdict).name))
        .bind(reason)
        .bind(time_after_others(store_, attempt_id, event))
        .run();
    // The administrator reads the chain, not the reviews: neither verdict nor reason is in the payload.
    Audit(store_).append(educator, id, "error.review", json_object({{"attempt", attempt_id}}),
                         {{RecordKind::error_review, id}});
    transaction.commit();
    return id;
}

}  // namespace fulcrum::database
