// SPDX-License-Identifier: GPL-3.0-or-later
// What must be known about a voided attempt, the same on screens and on paper.
#pragma once

#include <QStringList>

#include "database/rows/attempt_records.h"

namespace fulcrum::ui {

/// Who voided it, when and why, and whether a copy was stored; empty where it is not voided.
QStringList void_notes(const database::AttemptSummary& attempt);

}  // namespace fulcrum::ui
