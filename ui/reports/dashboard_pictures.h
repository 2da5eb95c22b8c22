// SPDX-License-Identifier: GPL-3.0-or-later
// The six pictures of a cohort with their words and tables, for the screen and for paper.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "database/records/cohort_dashboard.h"
#include "sim_core/numerics/name_table.h"
#include "ui/charts/chart_table.h"
#include "ui/charts/figure.h"

namespace fulcrum::ui {

enum class DashboardPart { plan, pass_rates, times, volume, checks, stages };
inline constexpr NameRow<DashboardPart> dashboard_parts[] = {
    {DashboardPart::plan, "plan",
     QT_TRANSLATE_NOOP("fulcrum::ui::DashboardTexts", "Progress against the plan")},
    {DashboardPart::pass_rates, "pass_rates",
     QT_TRANSLATE_NOOP("fulcrum::ui::DashboardTexts", "People who passed each task")},
    {DashboardPart::times, "times", QT_TRANSLATE_NOOP("fulcrum::ui::DashboardTexts", "Time to proficiency")},
    {DashboardPart::volume, "volume", QT_TRANSLATE_NOOP("fulcrum::ui::DashboardTexts", "Attempts each week")},
    {DashboardPart::checks, "checks",
     QT_TRANSLATE_NOOP("fulcrum::ui::DashboardTexts", "Retention checks that are due")},
    {DashboardPart::stages, "stages",
     QT_TRANSLATE_NOOP("fulcrum::ui::DashboardTexts", "How far people are in the stages")},
};
static_assert(in_order(dashboard_parts));
QString dashboard_title(DashboardPart part);

/// Titles of stages and tasks by their place in the curriculum.
struct DashboardNames {
    QStringList tasks;   ///< "A2 · Fulcrum targeting"
    QStringList stages;  ///< "A · Instruments"
};
DashboardNames dashboard_names(const Curriculum& curriculum,
                               const std::vector<std::pair<std::string, std::string>>& task_titles);

struct DashboardPicture {
    Figure figure;
    ChartTable table;
    QString words;    ///< all of it in a sentence or two, for the foot of the picture
    QString nothing;  ///< in place of an empty figure
};

/// `task`: of `times`, its place in the curriculum.
DashboardPicture dashboard_picture(DashboardPart part, const database::CohortDashboard& dashboard,
                                   const std::vector<database::PersonStandings>& people,
                                   const DashboardNames& names, std::size_t task = 0);
/// The task whose time to proficiency says most: the first one that somebody is proficient in, else the
/// first one that somebody has passed, else the first.
std::size_t telling_task(const database::CohortDashboard& dashboard);

/// Who is behind a part of a picture.
struct BehindPicture {
    QString caption;
    ChartTable table;  ///< a row's key: the person's id, a blank and the task's ("" for none)
};
/// `key`: of the part in the figure; `task`: of `times`. Empty caption where there is nobody to show.
BehindPicture behind_picture(DashboardPart part, const QString& key,
                             const database::CohortDashboard& dashboard,
                             const std::vector<database::PersonStandings>& people,
                             const DashboardNames& names, std::size_t task = 0);

}  // namespace fulcrum::ui
