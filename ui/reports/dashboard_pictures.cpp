// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/dashboard_pictures.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/language/language.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

using database::CheckSlot;
using database::CohortDashboard;
using database::DashboardPerson;
using database::PersonStandings;
using People = std::vector<PersonStandings>;

/// The context of the texts of this file.
struct DashboardTexts {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::DashboardTexts)
};

namespace {

QString short_day(std::int64_t day) {
    return QLocale().toString(QDate(1970, 1, 1).addDays(day), DashboardTexts::tr("d MMM"));
}

std::int64_t local_day_of(std::int64_t utc_ms) {
    return QDate(1970, 1, 1).daysTo(QDateTime::fromMSecsSinceEpoch(utc_ms).date());
}

QString whole_percent(double share) {
    return QString::number(qRound(100 * share));
}

QString people_words(std::size_t count) {
    return DashboardTexts::tr("%n people", nullptr, static_cast<int>(count));
}

QString task_of(const DashboardNames& names, const CohortDashboard& dashboard, const std::string& task) {
    for (std::size_t t = 0; t < dashboard.overview.size(); ++t)
        if (dashboard.overview[t].task == task) return names.tasks.value(static_cast<int>(t));
    return text(task);
}

QString slot_words(const CheckSlot& slot) {
    switch (slot.kind) {
        case CheckSlot::Kind::overdue:
            return DashboardTexts::tr("overdue");
        case CheckSlot::Kind::due:
            return DashboardTexts::tr("due now");
        case CheckSlot::Kind::ahead:
            return DashboardTexts::tr("%1 to %2").arg(short_day(slot.from), short_day(slot.to));
        case CheckSlot::Kind::later:
            break;
    }
    return DashboardTexts::tr("later");
}

ChartCell percent_cell(const std::optional<double>& share) {
    return ChartCell::value(share ? std::optional<double>(100 * *share) : std::nullopt);
}

QString person_key(const People& people, std::size_t person, const std::string& task = {}) {
    return text(people[person].person_id) + QLatin1Char(' ') + text(task);
}

DashboardPicture plan_picture(const CohortDashboard& dashboard, const People& people) {
    DashboardPicture picture;
    DotFigure figure;
    figure.x_title = DashboardTexts::tr("weeks since the first day of practice");
    figure.y_title = DashboardTexts::tr("tasks done");
    figure.x_high = 4;
    figure.line_x = dashboard.plan_weeks;
    figure.line_y = dashboard.tasks;
    figure.y_high = std::max(1, dashboard.tasks);
    figure.dot_name = DashboardTexts::tr("on plan");
    figure.marked_name = DashboardTexts::tr("behind it");
    figure.line_name = DashboardTexts::tr("plan: all tasks in %n weeks", nullptr, dashboard.plan_weeks);
    picture.table.columns = {
        {DashboardTexts::tr("Person")},
        {DashboardTexts::tr("Since the first day of practice"), DashboardTexts::tr("weeks")},
        {DashboardTexts::tr("Tasks done")},
        {DashboardTexts::tr("Tasks by the plan")},
        {DashboardTexts::tr("Behind by"), DashboardTexts::tr("tasks")}};
    int behind = 0;
    for (const database::PlanPoint& point : dashboard.plan) {
        const PersonStandings& person = people[point.person];
        figure.x_high = std::max(figure.x_high, point.weeks * 1.05);
        behind += point.behind() ? 1 : 0;
        figure.dots.push_back({person_key(people, point.person), point.weeks, static_cast<double>(point.done),
                               point.behind(),
                               DashboardTexts::tr("%1: week %2, %3 of %4 tasks done, %5 by the plan")
                                   .arg(text(person.name))
                                   .arg(qRound(point.weeks))
                                   .arg(point.done)
                                   .arg(dashboard.tasks)
                                   .arg(decimal(point.planned, 1))});
        picture.table.rows.push_back({{ChartCell::words(text(person.name)), ChartCell::value(point.weeks),
                                       ChartCell::count(point.done), ChartCell::value(point.planned),
                                       ChartCell::value(std::max(0.0, point.planned - point.done))},
                                      person_key(people, point.person)});
    }
    const QString never =
        DashboardTexts::tr("%n have not begun", nullptr, static_cast<int>(dashboard.not_begun.size()));
    picture.words =
        DashboardTexts::tr("%1 on plan, %2 behind it.").arg(dashboard.plan.size() - behind).arg(behind);
    if (!dashboard.not_begun.empty()) picture.words += QLatin1Char(' ') + never + QLatin1Char('.');
    picture.nothing = DashboardTexts::tr("Nobody has practised yet.");
    picture.figure = std::move(figure);
    return picture;
}

DashboardPicture rates_picture(const CohortDashboard& dashboard, const DashboardNames& names) {
    DashboardPicture picture;
    IntervalFigure figure;
    picture.table.columns = {{DashboardTexts::tr("Task")},
                             {DashboardTexts::tr("Tried"), DashboardTexts::tr("people")},
                             {DashboardTexts::tr("Passed"), DashboardTexts::tr("people")},
                             {DashboardTexts::tr("Share"), QStringLiteral("%")},
                             {DashboardTexts::tr("95 % interval from"), QStringLiteral("%")},
                             {DashboardTexts::tr("to"), QStringLiteral("%")}};
    for (std::size_t t = 0; t < dashboard.overview.size(); ++t) {
        const database::TaskOverview& task = dashboard.overview[t];
        const bool tried = task.attempted > 0;
        const auto of = [&](double share) { return tried ? std::optional<double>(share) : std::nullopt; };
        figure.rows.push_back({text(task.task), text(task.task),
                               tried ? DashboardTexts::tr("%1 of %2 (%3 %)")
                                           .arg(task.passed)
                                           .arg(task.attempted)
                                           .arg(whole_percent(task.share.share))
                                     : DashboardTexts::tr("not tried"),
                               of(task.share.share), task.share.low, task.share.high});
        picture.table.rows.push_back(
            {{ChartCell::words(names.tasks.value(static_cast<int>(t))), ChartCell::count(task.attempted),
              ChartCell::count(task.passed), percent_cell(of(task.share.share)),
              percent_cell(of(task.share.low)), percent_cell(of(task.share.high))},
             text(task.task)});
    }
    picture.words = DashboardTexts::tr(
        "People who passed at least once, of those who tried. Line: 95 % interval (Wilson).");
    picture.nothing = DashboardTexts::tr("There is nobody in this cohort.");
    picture.figure = std::move(figure);
    return picture;
}

/// The share that is there, from the share that waits.
StepCurve curve_of(const QString& key, const QString& name, const std::vector<SurvivalStep>& waiting,
                   std::size_t still) {
    StepCurve curve;
    curve.key = key;
    curve.name = name;
    curve.words =
        DashboardTexts::tr("%1: %n people who tried are not there yet", nullptr, static_cast<int>(still))
            .arg(name);
    for (const SurvivalStep& step : waiting)
        curve.steps.push_back({step.time, 1 - step.waiting, 1 - step.high, 1 - step.low});
    return curve;
}

QString half_words(const QString& name, const SurvivalMedian& days) {
    const auto whole = [](double value) { return figure(std::round(value)); };
    if (!days.median) return DashboardTexts::tr("%1: fewer than half so far.").arg(name);
    const QString low = whole(days.low.value_or(0));
    return days.high ? DashboardTexts::tr("%1: half are there after %2 days (95 % interval %3 to %4).")
                           .arg(name, whole(*days.median), low, whole(*days.high))
                     : DashboardTexts::tr("%1: half are there after %2 days (95 % interval %3 or more).")
                           .arg(name, whole(*days.median), low);
}

DashboardPicture times_picture(const CohortDashboard& dashboard, const DashboardNames& names, std::size_t t) {
    DashboardPicture picture;
    StepFigure figure;
    figure.x_title = DashboardTexts::tr("days since the first attempt that counts");
    picture.table.columns = {{DashboardTexts::tr("Task")},
                             {DashboardTexts::tr("Curve")},
                             {DashboardTexts::tr("Since the first attempt"), DashboardTexts::tr("days")},
                             {DashboardTexts::tr("Share"), QStringLiteral("%")},
                             {DashboardTexts::tr("95 % interval from"), QStringLiteral("%")},
                             {DashboardTexts::tr("to"), QStringLiteral("%")}};
    picture.nothing = DashboardTexts::tr("Nobody has tried this task yet.");
    if (t < dashboard.overview.size() && dashboard.overview[t].attempted > 0) {
        const database::TaskOverview& task = dashboard.overview[t];
        const QString pass = DashboardTexts::tr("first pass"), proficient = DashboardTexts::tr("proficient");
        figure.x_high = std::max(1.0, task.longest_days);
        figure.curves = {
            curve_of(QStringLiteral("pass"), pass, task.pass_curve, dashboard.waiting_to_pass[t].size()),
            curve_of(QStringLiteral("proficient"), proficient, task.proficiency_curve,
                     dashboard.waiting_for_proficiency[t].size())};
        for (const StepCurve& curve : figure.curves)
            for (const CurveStep& step : curve.steps)
                picture.table.rows.push_back(
                    {{ChartCell::words(names.tasks.value(static_cast<int>(t))), ChartCell::words(curve.name),
                      ChartCell::value(step.x), percent_cell(step.value), percent_cell(step.low),
                      percent_cell(step.high)},
                     {}});
        picture.words = half_words(capital(pass), task.days_to_pass) + QLatin1Char(' ') +
                        half_words(capital(proficient), task.days_to_proficiency) + QLatin1Char(' ') +
                        DashboardTexts::tr("By the method of Kaplan and Meier.");
    }
    picture.figure = std::move(figure);
    return picture;
}

DashboardPicture volume_picture(const CohortDashboard& dashboard) {
    DashboardPicture picture;
    ColumnFigure figure;
    figure.y_title = DashboardTexts::tr("attempts of any kind, by the week's Monday");
    picture.table.columns = {{DashboardTexts::tr("Week from")},
                             {DashboardTexts::tr("Attempts")},
                             {DashboardTexts::tr("People who practised"), DashboardTexts::tr("people")}};
    int attempts = 0;
    for (std::size_t w = 0; w < dashboard.weeks.size(); ++w) {
        const database::PracticeWeek& week = dashboard.weeks[w];
        attempts += week.attempts;
        const QString words = DashboardTexts::tr("week of %1: %n attempts", nullptr, week.attempts)
                                  .arg(short_day(week.monday)) +
                              QStringLiteral(", ") + people_words(week.people.size());
        figure.columns.push_back({QString::number(w),
                                  short_day(week.monday).replace(QLatin1Char(' '), QLatin1Char('\n')),
                                  week.attempts, ColumnFill::plain, words});
        picture.table.rows.push_back({{ChartCell::day(week.monday), ChartCell::count(week.attempts),
                                       ChartCell::count(static_cast<long long>(week.people.size()))},
                                      QString::number(w)});
    }
    picture.words = DashboardTexts::tr("%n attempts", nullptr, attempts) + QLatin1Char(' ') +
                    DashboardTexts::tr("in the last %1 weeks.").arg(database::dashboard_weeks);
    picture.nothing = DashboardTexts::tr("There is nobody in this cohort.");
    picture.figure = std::move(figure);
    return picture;
}

DashboardPicture checks_picture(const CohortDashboard& dashboard, const People& people,
                                const DashboardNames& names) {
    DashboardPicture picture;
    ColumnFigure figure;
    figure.y_title = DashboardTexts::tr("checks");
    picture.table.columns = {{DashboardTexts::tr("When")},
                             {DashboardTexts::tr("Person")},
                             {DashboardTexts::tr("Task")},
                             {DashboardTexts::tr("Due on")}};
    std::size_t planned = 0;
    for (std::size_t s = 0; s < dashboard.checks.size(); ++s) {
        const CheckSlot& slot = dashboard.checks[s];
        const auto count = static_cast<int>(slot.checks.size());
        planned += slot.checks.size();
        const bool ahead = slot.kind == CheckSlot::Kind::ahead;
        const QString label = ahead ? short_day(slot.from).replace(QLatin1Char(' '), QLatin1Char('\n'))
                                    : slot_words(slot).replace(QLatin1Char(' '), QLatin1Char('\n'));
        figure.columns.push_back(
            {QString::number(s), label, count,
             slot.kind == CheckSlot::Kind::overdue ? ColumnFill::bad
             : slot.kind == CheckSlot::Kind::due   ? ColumnFill::warning
             : ahead                               ? ColumnFill::plain
                                                   : ColumnFill::faint,
             slot_words(slot) + QStringLiteral(": ") + DashboardTexts::tr("%n checks", nullptr, count)});
        for (const DashboardPerson& check : slot.checks)
            picture.table.rows.push_back(
                {{ChartCell::words(slot_words(slot)), ChartCell::words(text(people[check.person].name)),
                  ChartCell::words(task_of(names, dashboard, check.task)),
                  ChartCell::day(local_day_of(check.at))},
                 person_key(people, check.person, check.task)});
    }
    if (planned == 0) figure.columns.clear();
    picture.words =
        dashboard.checks.empty()
            ? QString()
            : DashboardTexts::tr("%1 overdue, %2 due now, %3 planned.")
                  .arg(dashboard.checks[0].checks.size())
                  .arg(dashboard.checks[1].checks.size())
                  .arg(planned - dashboard.checks[0].checks.size() - dashboard.checks[1].checks.size());
    picture.nothing = DashboardTexts::tr("Nobody is proficient yet, so no check is planned.");
    picture.figure = std::move(figure);
    return picture;
}

QString step_words(const database::StageStep& step, const QString& stage) {
    return step.done ? DashboardTexts::tr("%1: done").arg(stage) : DashboardTexts::tr("%1: begun").arg(stage);
}

DashboardPicture stages_picture(const CohortDashboard& dashboard, const DashboardNames& names) {
    DashboardPicture picture;
    FunnelFigure figure;
    figure.all = dashboard.people;
    picture.table.columns = {{DashboardTexts::tr("Stage")},
                             {DashboardTexts::tr("People who got so far"), DashboardTexts::tr("people")},
                             {DashboardTexts::tr("Share of the cohort"), QStringLiteral("%")}};
    for (std::size_t s = 0; s < dashboard.stages.size(); ++s) {
        const database::StageStep& step = dashboard.stages[s];
        const double share = static_cast<double>(step.people.size()) / std::max(1, dashboard.people);
        const QString stage = text(step.stage);
        const QString label = step_words(step, names.stages.value(static_cast<int>(s / 2)));
        // The names of the stages are in the words below: two of them would be cut to the same letters.
        figure.steps.push_back(
            {QString::number(s), step_words(step, stage), static_cast<int>(step.people.size()), step.done,
             DashboardTexts::tr("%1 (%2 %)").arg(step.people.size()).arg(whole_percent(share))});
        picture.table.rows.push_back(
            {{ChartCell::words(label), ChartCell::count(static_cast<long long>(step.people.size())),
              percent_cell(share)},
             QString::number(s)});
    }
    if (!names.stages.isEmpty())
        picture.words = names.stages.join(QStringLiteral(", ")) + QStringLiteral(". ");
    picture.words += DashboardTexts::tr(
        "Begun: at least one attempt that counts. Done: proficient in every task of the stage, or its rule "
        "met by provisional limits.");
    picture.nothing = DashboardTexts::tr("There is nobody in this cohort.");
    picture.figure = std::move(figure);
    return picture;
}

}  // namespace

QString dashboard_title(DashboardPart part) {
    return QCoreApplication::translate("fulcrum::ui::DashboardTexts", row_of(dashboard_parts, part).title);
}

DashboardNames dashboard_names(const Curriculum& curriculum,
                               const std::vector<std::pair<std::string, std::string>>& task_titles) {
    DashboardNames names;
    for (const CurriculumTask& task : curriculum.tasks) {
        QString title = text(task.task);
        for (const auto& [id, shown] : task_titles)
            if (id == task.task && !shown.empty()) title += QStringLiteral(" · ") + asset_text(shown);
        names.tasks << title;
    }
    for (const CurriculumStage& stage : curriculum.stages)
        names.stages << text(stage.id) + QStringLiteral(" · ") + asset_text(stage.title);
    return names;
}

DashboardPicture dashboard_picture(DashboardPart part, const CohortDashboard& dashboard, const People& people,
                                   const DashboardNames& names, std::size_t task) {
    switch (part) {
        case DashboardPart::plan:
            return plan_picture(dashboard, people);
        case DashboardPart::pass_rates:
            return rates_picture(dashboard, names);
        case DashboardPart::times:
            return times_picture(dashboard, names, task);
        case DashboardPart::volume:
            return volume_picture(dashboard);
        case DashboardPart::checks:
            return checks_picture(dashboard, people, names);
        case DashboardPart::stages:
            break;
    }
    return stages_picture(dashboard, names);
}

std::size_t telling_task(const CohortDashboard& dashboard) {
    using database::TaskOverview;
    for (const auto curve : {&TaskOverview::proficiency_curve, &TaskOverview::pass_curve})
        for (std::size_t t = 0; t < dashboard.overview.size(); ++t)
            if (!(dashboard.overview[t].*curve).empty()) return t;
    return 0;
}

namespace {

BehindPicture list_of(const QString& caption, const std::vector<DashboardPerson>& behind,
                      const CohortDashboard& dashboard, const People& people, const DashboardNames& names,
                      const ChartColumn& count, bool with_day) {
    BehindPicture shown;
    shown.caption = caption + QStringLiteral(": ") + people_words(behind.size());
    shown.table.columns = {{DashboardTexts::tr("Person")}};
    const bool with_task = !behind.empty() && !behind.front().task.empty();
    if (with_task) shown.table.columns.push_back({DashboardTexts::tr("Task")});
    if (with_day) shown.table.columns.push_back({DashboardTexts::tr("Due on")});
    if (!count.name.isEmpty()) shown.table.columns.push_back(count);
    for (const DashboardPerson& one : behind) {
        ChartRow row{{ChartCell::words(account_text(people[one.person].name, people[one.person].active))},
                     person_key(people, one.person, one.task)};
        if (with_task) row.cells.push_back(ChartCell::words(task_of(names, dashboard, one.task)));
        if (with_day) row.cells.push_back(ChartCell::day(local_day_of(one.at)));
        if (!count.name.isEmpty()) row.cells.push_back(ChartCell::count(one.count));
        shown.table.rows.push_back(std::move(row));
    }
    return shown;
}

}  // namespace

BehindPicture behind_picture(DashboardPart part, const QString& key, const CohortDashboard& dashboard,
                             const People& people, const DashboardNames& names, std::size_t task) {
    const auto index = static_cast<std::size_t>(std::max(0, key.toInt()));
    const ChartColumn attempts{DashboardTexts::tr("Attempts")};
    switch (part) {
        case DashboardPart::pass_rates:
            for (std::size_t t = 0; t < dashboard.overview.size(); ++t)
                if (text(dashboard.overview[t].task) == key && !dashboard.waiting_to_pass[t].empty())
                    return list_of(DashboardTexts::tr("%1, tried and not passed yet")
                                       .arg(names.tasks.value(static_cast<int>(t))),
                                   dashboard.waiting_to_pass[t], dashboard, people, names, attempts, false);
            break;
        case DashboardPart::volume:
            if (index < dashboard.weeks.size() && !dashboard.weeks[index].people.empty())
                return list_of(DashboardTexts::tr("Practised in the week of %1")
                                   .arg(short_day(dashboard.weeks[index].monday)),
                               dashboard.weeks[index].people, dashboard, people, names, attempts, false);
            break;
        case DashboardPart::checks:
            if (index < dashboard.checks.size() && !dashboard.checks[index].checks.empty())
                return list_of(DashboardTexts::tr("Checks, %1").arg(slot_words(dashboard.checks[index])),
                               dashboard.checks[index].checks, dashboard, people, names, {}, true);
            break;
        case DashboardPart::stages:
            if (index < dashboard.stages.size() && !dashboard.stages[index].people.empty())
                return list_of(
                    step_words(dashboard.stages[index], names.stages.value(static_cast<int>(index / 2))),
                    dashboard.stages[index].people, dashboard, people, names, {}, false);
            break;
        case DashboardPart::times: {
            if (task >= dashboard.overview.size()) break;
            const bool pass = key == QLatin1String("pass");
            const auto& waiting =
                pass ? dashboard.waiting_to_pass[task] : dashboard.waiting_for_proficiency[task];
            if (waiting.empty()) break;
            return list_of((pass ? DashboardTexts::tr("%1, tried and not passed yet")
                                 : DashboardTexts::tr("%1, tried and not proficient yet"))
                               .arg(names.tasks.value(static_cast<int>(task))),
                           waiting, dashboard, people, names, attempts, false);
        }
        case DashboardPart::plan:
            break;
    }
    return {};
}

}  // namespace fulcrum::ui
