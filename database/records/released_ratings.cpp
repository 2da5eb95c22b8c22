// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/ratings.h"
#include "database/rows/enum_column.h"
#include "database/rows/same_person.h"

namespace fulcrum::database {

std::vector<ReleasedRating> released_ratings(Connection& connection, const std::string& person_id) {
    Query rows(
        connection,
        "SELECT r.id, r.attempt_id, " + owner_of("r.rater_id") +
            ", r.form, r.blinding, l.time, i.item, i.value FROM "
            "rating r JOIN rating_release l ON l.rating_id = r.id JOIN attempt a ON a.id = r.attempt_id "
            "LEFT JOIN rating_item i ON i.rating_id = r.id AND i.value IS NOT NULL WHERE " +
            belongs_to("a.person_id") + " AND COALESCE(" + owner_of("r.rater_id") +
            ", '') <> ? ORDER BY r.id, i.number");
    rows.bind(person_id).bind(person_id);
    std::vector<ReleasedRating> released;
    while (rows.next()) {
        if (released.empty() || released.back().id != rows.text(0)) {
            ReleasedRating one;
            one.id = rows.text(0);
            one.attempt = rows.text(1);
            one.rater = rows.text(2);
            one.form = rows.text(3).substr(0, rows.text(3).find('@'));
            one.blind = enum_of(rows.text(4), blindings, "blinding of rating " + one.id) == Blinding::kept;
            one.time = rows.integer(5);
            released.push_back(std::move(one));
        }
        if (!rows.is_null(6)) released.back().answers[rows.text(6)] = static_cast<int>(rows.integer(7));
    }
    return released;
}

}  // namespace fulcrum::database
