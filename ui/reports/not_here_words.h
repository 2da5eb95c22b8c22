// SPDX-License-Identifier: GPL-3.0-or-later
// Of whose standing nothing can be said, the same on screens and on paper.
#pragma once

#include <QString>
#include <vector>

#include "database/records/cohort_standings.h"

namespace fulcrum::ui {

/// Names the people who follow a version of the curriculum that is not at this station; empty: there are
/// none.
QString not_here_line(const std::vector<database::PersonStandings>& people);

}  // namespace fulcrum::ui
