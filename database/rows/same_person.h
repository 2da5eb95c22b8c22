// SPDX-License-Identifier: GPL-3.0-or-later
// To whom rows belong whose person was merged into another one (person.merged_into, schema step 19). What is
// signed keeps the id under which it was made; whoever reads it asks here. A merge counts while its target is
// not merged itself: where two stations merged crosswise, each row belongs to itself until one merge is
// undone.
#pragma once

#include <QString>

namespace fulcrum::database {

/// SQL: every person with the one it belongs to, as columns person_id and owner_id.
inline constexpr const char* person_owners =
    "(SELECT same_row.id AS person_id, COALESCE(same_into.id, same_row.id) AS owner_id FROM person same_row "
    "LEFT "
    "JOIN person same_into ON same_into.id = same_row.merged_into AND same_into.merged_into = '')";

/// SQL condition with one `?`: what `column` names belongs to this person.
inline QString belongs_to(const QString& column) {
    return column + " IN (SELECT person_id FROM " + person_owners + " same WHERE same.owner_id = ?)";
}

/// SQL: id of the person to whom what `column` (named with its table) belongs. Its own names begin with
/// `same_`, so that no table of the caller is hidden.
inline QString owner_of(const QString& column) {
    return "(SELECT COALESCE(same_into.id, same_row.id) FROM person same_row LEFT JOIN person same_into ON "
           "same_into.id = same_row.merged_into AND same_into.merged_into = '' WHERE same_row.id = " +
           column + ")";
}

/// SQL: joins the person `as` to whom what `column` names belongs.
inline QString join_owner(const QString& column, const QString& as) {
    // Nearly nobody is merged: only then another row is looked up.
    return QString(
               "JOIN person %2_row ON %2_row.id = %1 JOIN person %2 ON %2.id = CASE WHEN %2_row.merged_into "
               "= '' "
               "THEN %2_row.id ELSE %3 END ")
        .arg(column, as, owner_of(as + "_row.id"));
}

}  // namespace fulcrum::database
