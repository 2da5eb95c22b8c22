// SPDX-License-Identifier: GPL-3.0-or-later
// Why an educator should look at a trainee now, as one sentence.
#pragma once

#include <QString>

#include "assessment/curriculum/concern.h"

namespace fulcrum::ui {

/// `task_title`: of the concern's task, "" for all. `now`: UTC ms.
QString concern_text(const Concern& concern, const QString& task_title, std::int64_t now);

}  // namespace fulcrum::ui
