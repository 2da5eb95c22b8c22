// SPDX-License-Identifier: GPL-3.0-or-later
// Where a trainee stands in a task, as a shape with a colour and as words. The shape says it without colour.
#pragma once

#include <QWidget>

#include "assessment/curriculum/standing.h"

class QPainter;

namespace fulcrum::ui {

/// Locked: a padlock; open: a ring; attempted: a ring with a dot; passed: a tick in a ring (provisional: the
/// ring dashed); awaiting rating: a ring with three dots; proficient: a filled disc with a tick; maintained:
/// the same with a second ring; due: a clock; relapsed: a triangle. Proficient by decision of an educator: a
/// diamond at the corner as well. Colours of the theme in force.
void paint_standing(QPainter& painter, const QRectF& box, const TaskStanding& standing);

/// A question mark: the standing is not known here, because the person's version of the curriculum is not
/// installed. As large as paint_standing().
void paint_unknown_standing(QPainter& painter, const QRectF& box);
/// "not known here".
QString unknown_standing_name();

/// A few words: "locked", "passed (provisional)", "check overdue", "proficient (decision)".
QString standing_name(const TaskStanding& standing);
/// "passed (provisional)", "locked until you are proficient in B1, B2", in the second person.
QString standing_text(const TaskStanding& standing);
/// The role of the label that shows it: the same colour for the same standing on every page.
const char* standing_role(Standing standing);
/// What is missing or comes next, one sentence; empty where there is nothing to say.
QString standing_detail(const TaskStanding& standing);
/// A date without its time, "12 Nov 2026".
QString date_text(std::int64_t utc_ms);

/// The shape, as high as a line of the heading. Its words are its accessible name and tool tip.
class StandingBadge : public QWidget {
  public:
    explicit StandingBadge(const TaskStanding& standing);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    TaskStanding standing_;
};

}  // namespace fulcrum::ui
