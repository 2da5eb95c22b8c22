// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a cohort on one page. Internal to this room.
#pragma once

#include "ui/reports/paper.h"

namespace fulcrum::ui {

/// From where the sheet is down to the foot of the page.
void paint_dashboard(Sheet& sheet, const CohortReport& report);

}  // namespace fulcrum::ui
