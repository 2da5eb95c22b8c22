// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/page_table.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/administration/audit_page.h"
#include "ui/administration/cohorts_page.h"
#include "ui/administration/people_page.h"
#include "ui/administration/personal_data_page.h"
#include "ui/administration/station_page.h"
#include "ui/administration/tissues_page.h"
#include "ui/dashboards/attempts_page.h"
#include "ui/dashboards/benchmark_page.h"
#include "ui/dashboards/cohort_page.h"
#include "ui/dashboards/curriculum_page.h"
#include "ui/dashboards/dashboard_page.h"
#include "ui/dashboards/limits_page.h"
#include "ui/dashboards/schedules_page.h"
#include "ui/dashboards/to_rate_page.h"
#include "ui/shell/settings_page.h"
#include "ui/trainee/home_page.h"
#include "ui/trainee/metrics_page.h"
#include "ui/trainee/progress_page.h"

namespace fulcrum::ui {
namespace {

using database::Role;

template <typename P>
PageEntry entry(const char* name, const char* title, std::vector<Role> roles, bool at_station_only = false) {
    return {name,
            title,
            std::move(roles),
            typeid(P),
            [](Context& context) -> Page* { return new P(context); },
            at_station_only};
}

constexpr bool station_only = true;

}  // namespace

const std::vector<PageEntry>& page_table() {
    constexpr Role trainee = Role::trainee, educator = Role::educator, director = Role::director,
                   administrator = Role::administrator;
    // clang-format off
    static const std::vector<PageEntry> table = {
        entry<HomePage>    ("rail_home",     QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Home"),           {trainee}, station_only),
        entry<ProgressPage>("rail_progress", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "My progress"),    {trainee}),
        entry<AttemptsPage>("rail_attempts", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "My attempts"),    {trainee}),
        entry<DashboardPage>("rail_dashboard", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Dashboard"),    {director}),
        entry<CohortPage>  ("rail_cohort",   QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Cohorts"),        {educator, director}),
        entry<AttemptsPage>("rail_attempts", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Attempts"),       {educator, director}),
        entry<ToRatePage>  ("rail_rate",     QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Rate"),           {educator, director}, station_only),
        entry<ProgressPage>("rail_progress", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Progress"),       {educator, director}),
        entry<CurriculumPage>("rail_curriculum", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Curriculum"), {educator, director}),
        entry<LimitsPage>  ("rail_limits",   QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Limits"),         {educator, director}),
        entry<BenchmarkPage>("rail_benchmark", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Build limits"), {educator}, station_only),
        entry<MetricsPage> ("rail_metrics",  QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Metrics"),        {trainee, educator, director}),
        entry<PeoplePage>  ("rail_people",   QT_TRANSLATE_NOOP("fulcrum::ui::pages", "People"),         {administrator}, station_only),
        entry<StationPage> ("rail_station",  QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Station"),        {administrator}, station_only),
        entry<AuditPage>   ("rail_audit",    QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Audit log"),      {administrator}, station_only),
        entry<CohortsPage> ("rail_assign",   QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Assign cohorts"), {director}, station_only),
        entry<PersonalDataPage>("rail_data", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Personal data"), {director}, station_only),
        entry<SchedulesPage>("rail_schedules", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Reports"),      {director}, station_only),
        entry<TissuesPage> ("rail_tissues",  QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Tissue"),         {educator, director}, station_only),
        entry<SettingsPage>("rail_settings", QT_TRANSLATE_NOOP("fulcrum::ui::pages", "Settings"),       {trainee, educator, director, administrator}),
    };
    // clang-format on
    return table;
}

std::vector<const PageEntry*> pages_of(Context& context) {
    std::vector<const PageEntry*> shown;
    if (!context.signed_in() || context.session().must_change_password()) return shown;
    const bool server = context.store().is_server();
    for (const PageEntry& one : page_table()) {
        if (server && one.at_station_only) continue;
        if (std::find(one.roles.begin(), one.roles.end(), context.session().role()) != one.roles.end())
            shown.push_back(&one);
    }
    return shown;
}

QString page_title(const PageEntry& entry) {
    return QCoreApplication::translate("fulcrum::ui::pages", entry.title);
}

}  // namespace fulcrum::ui
