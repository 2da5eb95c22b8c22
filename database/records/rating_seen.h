// SPDX-License-Identifier: GPL-3.0-or-later
// Who knows name and score of an attempt, so that a rating of theirs is not blind. Internal to the database.
#pragma once

#include <QString>
#include <string>

#include "database/rows/connection.h"
#include "database/store/store.h"

namespace fulcrum::database {

/// SELECT of the ids of the attempts that a person, its one binding, opened with name and score, and of the
/// copies that a reassignment made of them: the score is the same, and whose it is was said there.
QString seen_attempts();
/// Whether the attempt is one of these for the rater.
bool has_seen(Connection& connection, const Session& rater, const std::string& attempt_id);
/// Notes the copies of the attempts in table `s`, rating_seen, for which `whose` holds with this value as
/// seen by those who opened these: what is noted of an original goes with it, and is not where it is not
/// sent. Within a transaction.
void note_copies(Connection& connection, const QString& whose, const std::string& value);

}  // namespace fulcrum::database
