// SPDX-License-Identifier: GPL-3.0-or-later
// What the home page recommends and why: on a plateau the remedy that the curriculum names, and the way to
// it. With FULCRUM_PICTURES=FOLDER the page is stored there.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDateTime>
#include <QLabel>
#include <cmath>
#include <string>

#include "assessment/metrics/registry.h"
#include "database/records/recorder.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/four_people.h"
#include "tests/ui/hands.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"
#include "ui/trainee/next_task.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Role;

class OnAPlateau : public ::testing::Test {
  protected:
    OnAPlateau() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        sessions = make_four_people(*services.store());
        Curriculum alone = services.curriculum();
        for (CurriculumTask& task : alone.tasks)
            if (task.task != "A2") task.after = {"A2"};
        alone.tasks.erase(alone.tasks.begin());  // A1, which would be next
        services.set_curriculum(alone);
    }
    ~OnAPlateau() override { apply_theme(*qApp, Theme::light); }

    void record(double points, AttemptMode mode = AttemptMode::assessed) {
        const database::Session& tara = sessions.at(Role::trainee);
        database::AttemptMeta meta;
        meta.person_id = tara.person_id();
        meta.task_id = "A2";
        meta.mode = mode;
        meta.device_class = DeviceClass::mouse_keyboard;
        meta.device = "mouse and keyboard";
        meta.variant = meta.fidelity = "standard";
        meta.scene = "a2_targets.json";
        meta.limits = "A2-operators@1";
        meta.program_version = "test";
        meta.curriculum = services.curriculum().name();
        database::Recorder recorder(services.store()->path(), tara, meta);
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = 30;
        database::ScoreRow score;
        score.passed = false;
        score.points = points;
        const auto metric = [&](const char* id, const char* hand, double value, const char* unit) {
            const int version = find_metric(id)->version - (id == older_version ? 1 : 0);
            score.metrics.push_back({id, version, hand, "", value, {}, unit, Direction::lower, {}});
        };
        metric("path_len", "left", 905, "mm");
        metric("path_len", "right", 700, "mm");
        metric("f_max", "left", 2, "N");
        metric("f_max", "right", 4.8, "N");
        result.score = score;
        recorder.finish(result);
    }
    void level_off() {
        for (int i = 0; i < 16; ++i) record(45 - 25 * std::exp(-0.5 * i) + (i % 2 == 0 ? 0.8 : -0.8));
    }
    void use(const char* metric, RemedyKind kind) {
        Curriculum changed = services.curriculum();
        for (CurriculumTask& task : changed.tasks) {
            if (task.task != "A2") continue;
            Remedy remedy{metric, true, 4, "N", kind};
            if (kind == RemedyKind::practise_from) remedy.goal = "right_targets";
            task.remedies = {remedy};
        }
        services.set_curriculum(changed);
    }
    void open() {
        window = std::make_unique<MainWindow>(services);
        window->resize(1012, 726);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        window->context().set_session(sessions.at(Role::trainee));
        wait_until_read(*window);
    }
    QString reason() { return find<QLabel>(*window, "next_reason")->text(); }
    void keep(const QString& name) {
        QCoreApplication::processEvents();
        if (!qEnvironmentVariableIsSet("FULCRUM_PICTURES")) return;
        window->grab().save(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES")) + "/" + name + ".png");
    }

    FakeServices services;
    std::map<Role, database::Session> sessions;
    std::unique_ptr<MainWindow> window;
    std::string older_version;  ///< metric that is recorded as an older program measured it
};

TEST_F(OnAPlateau, TheRemedyOfTheWorstMetricIsNextAndLeadsToWhatItAsksFor) {
    level_off();
    open();
    EXPECT_EQ(
        reason().replace(QChar(0x202f), QLatin1Char(' ')).toStdString(),
        "Your curve in A2 · Fulcrum targeting levels off below the pass mark, and Largest force is above 4 N "
        "(median of your latest attempts: 4.8 N): look at the replay of the latest attempt.")
        << "20 % above its bound; the path 3 %";
    keep("home-remedy-light");
    window->set_theme(Theme::dark);
    keep("home-remedy-dark");
    window->set_theme(Theme::light);
    click(*window, "next_remedy");
    EXPECT_EQ(window->current_page()->objectName(), "debrief_page");
}

TEST_F(OnAPlateau, ValuesOfAnOlderVersionOfAMetricNameNoRemedy) {
    older_version = "f_max";
    level_off();
    open();
    EXPECT_TRUE(reason().contains("Path length is above")) << reason().toStdString();
    EXPECT_FALSE(reason().contains("Largest force")) << reason().toStdString();
}

TEST_F(OnAPlateau, APartIsPractisedFromItsGoalOnAndThenTheTaskIsNextAgain) {
    use("f_max", RemedyKind::practise_from);
    level_off();
    open();
    EXPECT_TRUE(
        reason().endsWith("practise it from the goal “Right hand: touch the lit sphere and hold it” on."))
        << reason().toStdString();
    click(*window, "next_remedy");
    EXPECT_EQ(window->current_page()->objectName(), "briefing_page");
    EXPECT_EQ(find<QComboBox>(*window, "begin_at")->currentData().toInt(), 1);
    EXPECT_TRUE(find<QAbstractButton>(*window, "mode_practice")->isChecked());
    record(30, AttemptMode::practice);
    click(*window, "rail_home");
    wait_until_read(*window);
    EXPECT_FALSE(reason().contains("levels off")) << reason().toStdString();
    EXPECT_TRUE(sees(*window, "next_briefing"));
}

TEST_F(OnAPlateau, TheGhostIsChosenInTheBriefing) {
    use("f_max", RemedyKind::ghost);
    level_off();
    open();
    click(*window, "next_remedy");
    EXPECT_TRUE(find<QAbstractButton>(*window, "with_ghost")->isChecked());
    EXPECT_EQ(find<QComboBox>(*window, "begin_at")->currentData().toInt(), 0);
    emit window->context().briefing_wanted("A2");
    EXPECT_FALSE(find<QAbstractButton>(*window, "with_ghost")->isChecked()) << "another time it is not";
}

TEST_F(OnAPlateau, ARisingCurveHasNoRemedy) {
    for (int i = 0; i < 10; ++i) record(20 + 3 * i);
    open();
    EXPECT_FALSE(reason().contains("levels off")) << reason().toStdString();
}

TEST_F(OnAPlateau, WhatCannotAssessTheTasksThatAreLeftIsTheDeviceInUse) {
    services.in_use.device_class = DeviceClass::controller;  // A2 counts with mouse and keyboard
    open();
    EXPECT_EQ(reason().toStdString(),
              "The remaining tasks cannot be assessed with game controller, but you can practise this one.");
}

TEST(RemedyHistory, IsOfTheAttemptsThatCountWithTheDeviceClassUsedLast) {
    const auto attempt = [](std::int64_t started, bool counting) {
        database::ProgressPoint point;
        point.attempt_id = "attempt " + std::to_string(started);
        point.started = started;
        point.counting = counting;
        point.points = 48;
        return point;
    };
    database::ProgressSeries haptic, mouse;
    haptic.device_class = DeviceClass::haptic;
    for (int i = 1; i <= 16; ++i) haptic.points.push_back(attempt(i, false));  // the task was locked
    haptic.points.push_back(attempt(18, true));
    mouse.device_class = DeviceClass::mouse_keyboard;
    // Counted when they were performed, whatever the version in force now counts.
    mouse.points = {attempt(19, true), attempt(20, true), attempt(30, false)};
    database::PersonProgress progress;
    progress.series = {haptic, mouse};
    const TaskHistory history = history_of(progress);
    EXPECT_EQ(history.points.size(), 2U);
    EXPECT_EQ(history.values.size(), 2U);
    EXPECT_EQ(history.last, 20);
    EXPECT_EQ(latest_counting(progress), "attempt 20");
    for (database::ProgressSeries& series : progress.series)
        for (database::ProgressPoint& point : series.points) point.counting = false;
    EXPECT_TRUE(history_of(progress).values.empty());
    EXPECT_EQ(latest_counting(progress), "");
}

TEST(NextReason, SaysWhatProvisionalLimitsCannotDo) {
    Recommendation next;
    next.reason = RecommendationReason::check_provisional;
    const auto reason = [&] { return reason_text(next, "Basics", DeviceClass::haptic, 0); };
    EXPECT_TRUE(reason().startsWith("Your results in this task have fallen below proficiency."));
    next.check = 86'400'000;
    EXPECT_TRUE(reason().contains("Provisional limits cannot complete it")) << reason().toStdString();
    next.reason = RecommendationReason::rule_never_met;
    EXPECT_TRUE(reason().startsWith("Nobody can meet the rule of this task"));
}

TEST(NextReason, NamesTheDevicesThatACheckNeeds) {
    Recommendation next;
    next.check = 86'400'000;
    next.devices = {DeviceClass::haptic, DeviceClass::tracked};
    const QString both =
        device_class_text(DeviceClass::haptic) + ", " + device_class_text(DeviceClass::tracked);
    for (const RecommendationReason why :
         {RecommendationReason::check_elsewhere, RecommendationReason::relapsed_elsewhere}) {
        next.reason = why;
        const QString reason = reason_text(next, "Basics", DeviceClass::mouse_keyboard, 0);
        EXPECT_TRUE(reason.contains(device_class_text(DeviceClass::mouse_keyboard)));
        EXPECT_TRUE(reason.contains("but with: " + both + ".")) << reason.toStdString();
        next.provisional_here = true;
        const QString limits = reason_text(next, "Basics", DeviceClass::tracked, 0);
        EXPECT_TRUE(limits.contains("The limits for tracked instruments are provisional"));
        EXPECT_TRUE(limits.contains("passes with these count: " + both + ".")) << limits.toStdString();
        next.provisional_here = false;
    }
}

TEST(NextReason, DaysAgoAreLocalDates) {
    const auto reason = [](RecommendationReason why, const QDateTime& last, const QDateTime& now) {
        Recommendation next;
        next.reason = why;
        next.last = last.toMSecsSinceEpoch();
        return reason_text(next, "Basics", DeviceClass::mouse_keyboard, now.toMSecsSinceEpoch());
    };
    const QDate monday(2026, 11, 23);
    const auto at = [&](int days, int hour) { return QDateTime(monday.addDays(days), QTime(hour, 0)); };
    for (const RecommendationReason why :
         {RecommendationReason::longest_ago, RecommendationReason::all_done}) {
        EXPECT_TRUE(reason(why, at(0, 18), at(1, 8)).contains("(yesterday)"));
        EXPECT_TRUE(reason(why, at(0, 9), at(2, 8)).contains("(2 days ago)"));
        EXPECT_TRUE(reason(why, at(0, 8), at(0, 18)).contains("(today)"));
        EXPECT_TRUE(reason(why, at(0, 8), at(1, 18)).contains("(yesterday)"));
        EXPECT_TRUE(reason(why, at(1, 8), at(0, 8)).contains("(today)")) << "the clock was set back";
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
