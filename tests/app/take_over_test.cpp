// SPDX-License-Identifier: GPL-3.0-or-later
// Practice taken over from a moment of a replay, by the controls of the window: it begins with the scene as
// it was, is never scored, and replays bit for bit from its own record.
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QSlider>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/cli/attempt_document.h"
#include "database/store/kept_frames.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/window_fixture.h"
#include "ui/review/replay_panel.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

class TakeOver : public Window {
  protected:
    /// Tara touches the first sphere of A2 and abandons the attempt.
    database::AttemptSummary attempt_with_a_sphere() {
        create_programme_and_trainee();
        start("A2", false);
        const auto mind = make_pointing_mind(theatre().session()->scene());
        MouseHand hand(theatre(), *mind);
        EXPECT_TRUE(
            hand.work_until([&] { return theatre().session()->display().goal_progress > 0.05; }, 240000));
        abandon();
        return newest_attempt();
    }
    ReplayPanel& prepared_replay() {
        auto* panel = wait_for_debrief().findChild<ReplayPanel*>();
        EXPECT_TRUE(wait_for([&] { return panel->shown_time() >= 0; }, 120000));
        return *panel;
    }
};

TEST_F(TakeOver, BeginsWhereTheReplayIsAndReplaysFromItsOwnRecord) {
    const database::AttemptSummary source = attempt_with_a_sphere();
    ReplayPanel& panel = prepared_replay();
    auto* slider = find<QSlider>(window, "replay_slider");
    QTest::keyClick(slider, Qt::Key_End);
    for (int i = 0; i < 3; ++i) QTest::keyClick(slider, Qt::Key_PageDown);
    const double moment = panel.time();
    EXPECT_TRUE(wait_for([&] { return std::abs(panel.shown_time() - moment) < 0.02; }, 120000));
    ASSERT_GT(moment, 1);
    const QString frames = QString::fromStdString(database::kept_frames_folder(*services.store()) + "/" +
                                                  database::kept_frames_name(source.meta.id));
    EXPECT_TRUE(wait_for([&] { return QFile::exists(frames); }, 120000)) << "kept for the next opening";
    click(window, "replay_take_over");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }, 120000));
    EXPECT_FALSE(theatre().session()->assessed());
    EXPECT_FALSE(theatre().session()->display().moving_seen) << "the clock starts with the first movement";
    move_hands(20);
    EXPECT_LT(theatre().session()->display().elapsed_s, 20);
    ASSERT_TRUE(wait_for([&] { return theatre().session()->display().elapsed_s > 1; }, 60000));
    abandon();

    const database::AttemptSummary taken = newest_attempt();
    ASSERT_NE(taken.meta.id, source.meta.id);
    EXPECT_EQ(taken.meta.mode, AttemptMode::practice);
    EXPECT_EQ(taken.meta.seed, source.meta.seed);
    ASSERT_TRUE(taken.meta.origin);
    EXPECT_EQ(taken.meta.origin->source_id, source.meta.id);
    EXPECT_NEAR(taken.meta.origin->tick * 1e-3, moment, 0.011);
    EXPECT_FALSE(taken.passed);
    EXPECT_FALSE(taken.points);
    EXPECT_FALSE(taken.counting);
    EXPECT_FALSE(database::Attempts(*services.store()).score(window.context().session(), taken.meta.id));
    EXPECT_LT(taken.duration_s, 60);
    EXPECT_GT(taken.duration_s, 1);
    EXPECT_TRUE(shown("debrief_notes").contains("Practice from the moment"))
        << shown("debrief_notes").toStdString();
    expect_replays(taken.meta.id);
    const std::string exported = folder.filePath("taken").toStdString();
    export_trace(*services.store(), window.context().session(), taken.meta.id, exported);
    const nlohmann::json document = nlohmann::json::parse(std::ifstream(exported + "/attempt.json"));
    EXPECT_TRUE(document["passed"].is_null());
    EXPECT_TRUE(document["points"].is_null());
    EXPECT_TRUE(document["gates"].empty());
    EXPECT_FALSE(document["metrics"].empty());
    EXPECT_EQ(document["continues"]["attempt"], source.meta.id);
    EXPECT_DOUBLE_EQ(document["duration_s"].get<double>(), taken.duration_s);

    // Its own replay, and practice from there: a chain.
    ReplayPanel& again = prepared_replay();
    const double begin = taken.meta.origin->tick * 1e-3;
    EXPECT_NEAR(again.time(), begin, 1e-6) << "where its record begins";
    const auto tissue_is_of_the_moment = [&] {
        EXPECT_TRUE(wait_for([&] { return std::abs(again.shown_time() - again.time()) < 0.02; }, 120000));
        for (const QLabel* label : again.findChildren<QLabel*>())
            EXPECT_FALSE(label->text().contains("differs")) << label->text().toStdString();
    };
    QTest::keyClick(slider, Qt::Key_Home);
    click(window, "replay_forward");
    EXPECT_NEAR(again.time(), begin + 0.02, 1e-6);
    QTest::qWait(300);
    tissue_is_of_the_moment();
    click(window, "replay_play");
    EXPECT_TRUE(wait_for([&] { return again.time() > begin + 0.2; }));
    again.play(false);
    tissue_is_of_the_moment();
    QTest::keyClick(slider, Qt::Key_Home);
    EXPECT_NEAR(again.time(), begin, 1e-6);
    QTest::qWait(300);
    tissue_is_of_the_moment();
    QTest::keyClick(slider, Qt::Key_End);
    QTest::keyClick(slider, Qt::Key_PageDown);
    EXPECT_TRUE(wait_for([&] { return std::abs(again.shown_time() - again.time()) < 0.02; }, 120000));
    click(window, "replay_take_over");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }, 120000));
    move_hands(5);
    abandon();
    const database::AttemptSummary third = newest_attempt();
    ASSERT_TRUE(third.meta.origin);
    EXPECT_EQ(third.meta.origin->source_id, taken.meta.id);
    EXPECT_GT(third.meta.origin->tick, taken.meta.origin->tick);
    expect_replays(third.meta.id);
}

TEST_F(TakeOver, PartTaskPracticeBeginsAtTheGoalThatTheBriefingNames) {
    create_programme_and_trainee();
    click(window, "briefing_A2");
    expect_page("briefing_page");
    auto* begin = find<QComboBox>(window, "begin_at");
    ASSERT_EQ(begin->count(), 2) << "A2 has a goal for each hand";
    bring(*begin);
    QTest::keyClick(begin, Qt::Key_Down);
    EXPECT_EQ(begin->currentData().toInt(), 1);
    check(window, "mode_assessed");
    EXPECT_FALSE(begin->isEnabled()) << "an assessed attempt begins at the beginning";
    check(window, "mode_practice");
    click(window, "start_attempt");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }, 120000));
    EXPECT_EQ(theatre().session()->display().goal, 1);
    move_hands(10);
    abandon();
    const database::AttemptSummary part = newest_attempt();
    EXPECT_EQ(part.meta.mode, AttemptMode::practice);
    ASSERT_TRUE(part.meta.origin);
    EXPECT_TRUE(part.meta.origin->source_id.empty());
    EXPECT_EQ(part.meta.origin->goal, 1);
    EXPECT_FALSE(part.points);
    EXPECT_TRUE(shown("debrief_notes").contains("step 2 of a demonstration"));
    expect_replays(part.meta.id);
}

TEST_F(TakeOver, AGhostIsDrawnInPracticeAndChangesNothing) {
    create_programme_and_trainee();
    click(window, "briefing_A2");
    expect_page("briefing_page");
    check(window, "with_ghost");
    check(window, "mode_assessed");
    EXPECT_FALSE(find<QCheckBox>(window, "with_ghost")->isEnabled());
    check(window, "mode_practice");
    click(window, "start_attempt");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }, 240000));
    ASSERT_TRUE(theatre().session()->ghost());
    // The page gives the view its ghost with every picture.
    EXPECT_TRUE(wait_for([&] {
        const QImage with = theatre().view()->grab().toImage();
        theatre().view()->set_ghost(nullptr);
        return theatre().view()->grab().toImage() != with;
    }));
    move_hands(20);
    if (const char* pictures = std::getenv("FULCRUM_PICTURES"))
        window.grab().save(QString::fromUtf8(pictures) + QStringLiteral("/ghost-A2.png"));
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_FALSE(attempt.meta.origin);
    EXPECT_EQ(attempt.meta.seed, 7U) << "the scene of the demonstration";
    expect_replays(attempt.meta.id);
}

}  // namespace
}  // namespace fulcrum::app::program_test
