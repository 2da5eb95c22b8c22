// SPDX-License-Identifier: GPL-3.0-or-later
// The true path with nothing faked: the program's own services, threads, world, recorder and store behind the window, driven by real
// mouse and key events.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QRadioButton>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "app/application.h"
#include "app/live_attempt.h"
#include "app/performance.h"
#include "database/attempts.h"
#include "tests/ui/journey/hands.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/main_window.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::app {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::test;

class Window : public ::testing::Test {
  protected:
    Window() : services(make_services(folder.path().toStdString())), window(*services) {
        window.resize(1280, 800);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.activateWindow();
        window.start();
    }
    void expect_page(const char* name) {
        EXPECT_TRUE(wait_for([&] { return window.current_page()->objectName() == QLatin1String(name); }, 60000))
            << name << ", not " << window.current_page()->objectName().toStdString();
    }
    void create_programme_and_trainee() {
        expect_page("first_start_page");
        click(window, "create_programme");
        type(window, "programme_name", "Department of Surgery");
        type(window, "administrator_name", "Alma Admin");
        type(window, "administrator_login", "alma");
        type(window, "administrator_password", "correct horse");
        type(window, "administrator_password_again", "correct horse");
        click(window, "create_confirm");
        ASSERT_TRUE(wait_for([&] { return sees(window, "recovery_code"); }));
        find<QAbstractButton>(window, "code_noted")->setChecked(true);
        click(window, "code_continue");
        expect_page("people_page");
        type(window, "new_person_name", "Tara Trainee");
        type(window, "new_person_login", "tara");
        click(window, "add_person");
        const QString once = find<QLabel>(window, "one_time_password")->property("password").toString();
        click(window, "switch_user");
        expect_page("sign_in_page");
        type(window, "login", "tara");
        type(window, "password", once);
        QTest::keyClick(find<QLineEdit>(window, "password"), Qt::Key_Return);
        expect_page("password_page");
        type(window, "old_password", once);
        type(window, "new_password", "tara's password");
        type(window, "new_password_again", "tara's password");
        click(window, "password_change");
        expect_page("home_page");
    }
    /// Starts, moves both hands for some seconds of real time, abandons; returns the attempt's id.
    std::string perform_and_abandon(const char* task, int moves) {
        click(window, qPrintable(QStringLiteral("briefing_") + QLatin1String(task)));
        expect_page("briefing_page");
        find<QRadioButton>(window, "mode_assessed")->setChecked(true);
        click(window, "start_attempt");
        expect_page("theatre_page");
        auto* theatre = static_cast<TheatrePage*>(window.current_page());
        TheatreView* view = theatre->view();
        EXPECT_TRUE(wait_for([&] { return theatre->session()->phase() == AttemptPhase::running; }, 60000));
        const QPoint middle = view->rect().center();
        for (int i = 0; i < moves; ++i) {
            QTest::mouseMove(view, middle + QPoint(5 * (i % 24), -3 * (i % 24)));
            QTest::qWait(25);
        }
        QTest::keyPress(view, Qt::Key_D);
        EXPECT_TRUE(wait_for([&] { return theatre->session()->display().moving_seen; }, 20000));
        QTest::keyRelease(view, Qt::Key_D);
        keep_picture(window, QStringLiteral("20-real-theatre-") + QLatin1String(task));
        click(window, "theatre_abandon");
        click(window, "panel_abandon");
        expect_page("debrief_page");
        auto* debrief = static_cast<DebriefPage*>(window.current_page());
        EXPECT_TRUE(wait_for([&] { return debrief->is_ready(); }, 60000));
        keep_picture(window, QStringLiteral("21-real-debrief-") + QLatin1String(task));
        const auto list = database::Attempts(*services->store()).list(window.context().session());
        EXPECT_FALSE(list.empty());
        return list.empty() ? std::string() : list.front().meta.id;
    }

    QTemporaryDir folder;
    std::unique_ptr<ApplicationServices> services;
    MainWindow window;
};

TEST_F(Window, ATraineeTouchesTheRealWorldAndTheRecordReplaysBitForBit) {
    create_programme_and_trainee();
    for (const char* task : {"A2", "B1"}) {
        const std::string id = perform_and_abandon(task, 60);
        ASSERT_FALSE(id.empty());
        const database::Attempts attempts(*services->store());
        const database::AttemptSummary summary = attempts.read(window.context().session(), id);
        EXPECT_EQ(summary.state, "abandoned");
        EXPECT_EQ(summary.passed, std::optional<bool>(false));
        EXPECT_EQ(summary.lost_samples, 0U);
        database::Trace trace = attempts.read_trace(window.context().session(), id);
        EXPECT_GT(trace.samples.size(), 1000U);
        const LoadedTask loaded = load_task_and_scene(task);
        AttemptEngine engine(loaded.scene, loaded.task, summary.meta.seed);
        const AttemptRecord record{trace.inputs, trace.samples, trace.steps, trace.events};
        const ReplayOutcome replay = replay_record(engine, record);
        EXPECT_TRUE(replay.identical) << task << " differs from " << replay.first_divergence_s << " s on";
        click(window, "rail_home");
        expect_page("home_page");
    }
}

/// However long the scene takes to prepare, nothing is on the clock meanwhile: the first tick comes after the first picture, and hands that
/// moved before it are no movement of the attempt. Who leaves while it prepares leaves no attempt behind.
TEST_F(Window, TheClockBeginsWhenTheSceneIsPreparedAndShown) {
    create_programme_and_trainee();
    const auto begin = [&] {
        click(window, "briefing_B1");
        expect_page("briefing_page");
        click(window, "start_attempt");
        expect_page("theatre_page");
        return static_cast<TheatrePage*>(window.current_page());
    };
    TheatrePage* theatre = begin();
    ASSERT_FALSE(theatre->view()->is_loaded());
    QTest::keyClick(theatre->view(), Qt::Key_Escape);
    expect_page("briefing_page");
    EXPECT_TRUE(database::Attempts(*services->store()).list(window.context().session()).empty());
    click(window, "rail_home");
    expect_page("home_page");
    theatre = begin();
    TheatreView* view = theatre->view();
    QTest::keyPress(view, Qt::Key_D);  // impatient hands
    int before = 0;
    while (theatre->session()->phase() != AttemptPhase::running) {
        ASSERT_EQ(theatre->session()->health().ticks, 0U);
        QTest::mouseMove(view, view->rect().center() + QPoint(before % 40, 0));
        QTest::qWait(10);
        ASSERT_LT(++before, 6000);
    }
    EXPECT_GT(before, 2);
    EXPECT_TRUE(view->is_loaded());
    EXPECT_GT(view->pictures(), 0);
    EXPECT_EQ(database::Attempts(*services->store()).list(window.context().session()).size(), 1U);
    QTest::keyRelease(view, Qt::Key_D);
    QTest::qWait(400);
    EXPECT_FALSE(theatre->session()->display().moving_seen) << "what was moved before the beginning counts for nothing";
    click(window, "theatre_abandon");
    click(window, "panel_abandon");
    expect_page("debrief_page");
}

/// Resident memory of this process, bytes.
double resident_bytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * 4096.0;
}

/// Eight seconds in the suite; FULCRUM_SOAK_S=590 for the long run whose figures are in docs/results.
TEST_F(Window, KeepsItsClockAndLosesNothingWhileItDraws) {
    create_programme_and_trainee();
    const char* asked = std::getenv("FULCRUM_SOAK_S");
    const int seconds = asked != nullptr ? std::atoi(asked) : 8;
    click(window, "briefing_B1");
    expect_page("briefing_page");
    find<QRadioButton>(window, "mode_practice")->setChecked(true);
    click(window, "start_attempt");
    expect_page("theatre_page");
    auto* theatre = static_cast<TheatrePage*>(window.current_page());
    TheatreView* view = theatre->view();
    const QPoint middle = view->rect().center();
    const auto* live = dynamic_cast<const LiveAttempt*>(theatre->session());
    ASSERT_NE(live, nullptr);
    // Geometry and textures of the scene are made once, on a thread of their own: what they take is no growth.
    ASSERT_TRUE(wait_for([&] { return theatre->session()->phase() == AttemptPhase::running; }, 60000));
    QElapsedTimer clock;
    clock.start();
    double settled = 0;
    for (int i = 0; clock.elapsed() < seconds * 1000LL; ++i) {
        QTest::mouseMove(view, middle + QPoint(static_cast<int>(60 * std::sin(0.05 * i)), static_cast<int>(40 * std::cos(0.04 * i))));
        QTest::qWait(20);
        if (settled == 0 && clock.elapsed() > seconds * 250LL) settled = resident_bytes();
    }
    const double grown = resident_bytes() - settled;
    const LoopStatistics statistics = live->statistics();  // while the threads run: they count in atomics
    std::printf("ticks %llu, missed by program %llu, by scheduler %llu, late steps %llu, lost %llu, real-time priority %d\n",
                static_cast<unsigned long long>(statistics.ticks), static_cast<unsigned long long>(statistics.missed_by_program),
                static_cast<unsigned long long>(statistics.missed_by_scheduler), static_cast<unsigned long long>(statistics.late_steps),
                static_cast<unsigned long long>(statistics.lost_samples), statistics.real_time_priority ? 1 : 0);
    std::printf("wake p50 %.0f p99 %.0f p99.9 %.0f worst %.0f us; tick p50 %.0f p99 %.0f worst %.0f us; step p50 %.0f p99 %.0f worst %.0f us\n",
                statistics.wake_p50_us, statistics.wake_p99_us, statistics.wake_p999_us, statistics.wake_worst_us, statistics.tick_p50_us,
                statistics.tick_p99_us, statistics.tick_worst_us, statistics.step_p50_us, statistics.step_p99_us, statistics.step_worst_us);
    std::printf("memory grown since the first quarter %.1f MiB, last frame %.1f ms\n", grown / 1048576.0, view->last_frame_ms());
    click(window, "theatre_abandon");
    click(window, "panel_abandon");
    expect_page("debrief_page");
    const database::Attempts attempts(*services->store());
    const auto list = attempts.list(window.context().session());
    ASSERT_EQ(list.size(), 1U);
    const database::Trace trace = attempts.read_trace(window.context().session(), list[0].meta.id);
    EXPECT_EQ(statistics.lost_samples, 0U);
    ASSERT_GT(trace.samples.size(), static_cast<std::size_t>(seconds) * 900U);
    for (std::size_t i = 0; i < trace.samples.size(); ++i) ASSERT_EQ(trace.samples[i].tick, i + 1);
    EXPECT_LT(grown, 64.0 * 1048576.0);
}

}  // namespace
}  // namespace fulcrum::app
