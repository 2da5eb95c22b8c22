// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt next to another one, an expert's and a cohort: aligned by steps, under one slider, with the
// differences of the metrics, of the whole and of a part. With FULCRUM_PICTURES=FOLDER pictures are stored.
#include "ui/review/compare_page.h"

#include <QChart>
#include <QPushButton>
#include <QSlider>

#include "assessment/assets/assets.h"
#include "assessment/task/task.h"
#include "database/records/ratings.h"
#include "database/scoring/range_metrics.h"
#include "database/sync/station_erasure.h"
#include "tests/support/support.h"
#include "tests/ui/review/comparing.h"
#include "ui/charts/time_chart.h"
#include "ui/review/replay_panel.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Session;

TEST_F(Comparing, TwoAttemptsMoveTogetherAlignedByTheirSteps) {
    record("tara", {2, 1, "standard", true, 90});
    const std::string own = record("tara", {});
    ComparePage& page = open("tara", own);
    ASSERT_NE(page.pair(), nullptr) << "the own best is shown at once";
    EXPECT_TRUE(find<QComboBox>(*window, "compare_with")->currentText().startsWith("Best attempt: "));
    EXPECT_EQ(notes(), "Aligned by the 3 steps that were completed in both.");
    auto* slider = find<QSlider>(*window, "compare_slider");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageUp);
    const double here = page.moment();
    EXPECT_GT(here, 0.2);
    auto* other = find<ReplayPanel>(*window, "compare_other_replay");
    EXPECT_NEAR(other->time(), page.pair()->map.to_second(here), 1e-9);
    EXPECT_NEAR(other->time(), 2 * here, 2e-3) << "it took twice as long";
    click(*window, "compare_step_forward");
    EXPECT_NEAR(page.moment(), here + 0.02, 1e-9);
    EXPECT_NEAR(other->time(), 2 * (here + 0.02), 2e-3);
    keep("compare-pair");
    EXPECT_EQ(line("Time"), (QStringList{"6 s", "12 s", "−6 s (−50 %)", "✓ better"}));
    keep("compare-metrics");
    click(*window, "compare_back");
    EXPECT_EQ(window->current_page()->objectName(), "debrief_page");
}

TEST_F(Comparing, PracticeFromALaterStepBeginsWhereTheOtherAttemptBeganThatStep) {
    record("tara", {2, 1, "standard", true, 90});
    ComparedRecord from_second_step;
    from_second_step.practice = true;
    ComparePage& page = open("tara", record("tara", from_second_step));
    ASSERT_NE(page.pair(), nullptr);
    EXPECT_EQ(page.pair()->map.first_goal(), 1);
    EXPECT_NEAR(page.pair()->map.to_second(2.001), 4, 1e-9) << "the other one had met the first step";
    EXPECT_NEAR(page.pair()->map.to_second(5), 10, 1e-9);
    EXPECT_EQ(notes(), "Aligned by the 2 steps that were completed in both.");
}

TEST_F(Comparing, TheButtonSaysPlayWhenBothReplaysHaveComeToTheEnd) {
    const std::string own = record("tara", {});
    ComparePage& page = open("tara", own);
    auto* speed = find<QComboBox>(*window, "compare_speed");
    speed->setFocus();
    QTest::keyClick(speed, Qt::Key_End);
    const auto button = [&] { return find<QPushButton>(*window, "compare_play")->text(); };
    bring(*find<QPushButton>(*window, "compare_play"));
    click(*window, "compare_play");
    EXPECT_EQ(button(), "Pause");
    auto* replay = find<ReplayPanel>(*window, "compare_own_replay");
    ASSERT_TRUE(wait_for([&] { return page.moment() >= 6 - 1e-6 && !replay->is_playing(); }));
    EXPECT_EQ(button(), "Play");
    click(*window, "compare_play");
    EXPECT_EQ(button(), "Pause") << "it begins again";
}

TEST(ComparedPairs, HaveNothingOfTheOtherAttemptBeyondTheOwnRecord) {
    const auto side = [](double end, double first, double peak_at) {
        std::vector<double> time;
        std::vector<float> force;
        for (int i = 0; i <= static_cast<int>(std::lround(10 * (end - first))); ++i) {
            time.push_back(first + 0.1 * i);
            force.push_back(std::abs(time.back() - peak_at) < 0.01 ? 6.0F : 1.0F);
        }
        ComparedSide made;
        made.model.begin = first;
        made.model.duration = end;
        for (std::size_t h = 0; h < hand_count; ++h)
            made.model.force[h] = made.model.speed[h] = std::make_shared<const MinMaxPyramid>(time, force);
        made.moments.begin = first;
        made.moments.end = end;
        made.moments.met[1] = first + 10;
        return made;
    };
    const ComparedSide own = side(20, 0, -1);
    const ComparedPair cut_off = align(own, side(90, 0, 80));
    EXPECT_EQ(cut_off.force[0]->highest(), 1) << "the other one's peak comes after the own end";
    EXPECT_LE(cut_off.force[0]->last_x(), 20);
    EXPECT_GE(cut_off.force[0]->last_x(), 19.8);
    EXPECT_EQ(align(own, side(90, 0, 15)).force[0]->highest(), 6) << "this one is within";
    // Practice that began 300 s into its attempt, in the second step.
    ComparedSide later = side(320, 300, -1);
    later.moments.first_goal = 1;
    ComparedSide other = side(30, 0, 2);
    other.moments.met[0] = 8;
    other.moments.met[1] = 18;
    const ComparedPair begun = align(later, other);
    EXPECT_EQ(begun.force[0]->highest(), 1) << "the peak was in the first step";
    EXPECT_GE(begun.force[0]->first_x(), 300);
    EXPECT_LE(begun.force[0]->first_x(), 300.2);
    EXPECT_LE(begun.force[0]->last_x(), 320);
}

TEST_F(Comparing, APartHasTheMetricsOfBothByTheSameFunction) {
    const std::string earlier = record("tara", {2, 1, "standard", true, 90});
    const std::string own = record("tara", {1, 1.5});
    ComparePage& page = open("tara", own);
    auto* step = find<QComboBox>(*window, "compare_step");
    step->setFocus();
    QTest::keyClick(step, Qt::Key_Down);
    QTest::keyClick(step, Qt::Key_Down);  // the second step: 2 to 5 s, in the other one 4 to 10 s
    ASSERT_TRUE(wait_for([&] { return page.is_ready(); }));
    EXPECT_EQ(find<QLabel>(*window, "compare_part_words")->text(),
              "0:02.0 to 0:05.0; other attempt 0:04.0 to 0:10.0");
    EXPECT_NEAR(page.moment(), 2, 1e-3);
    const QStringList force = line("Largest force", "left");
    ASSERT_EQ(force.size(), 4);
    EXPECT_EQ(force[0], "3 N");
    EXPECT_EQ(force[1], "2 N");
    const database::Trace trace = database::Attempts(*services.store()).read_trace(sessions.at("tara"), own);
    const TaskDefinition task = load_task(test::source_path("assets/tasks/B2.json"));
    const Scene scene = services.scene_for(task, "standard");
    const auto part = metrics_of_range(scene, task, 7, trace, 2, 5);
    const auto whole = metrics_of_range(scene, task, 7, trace, 0, 6);
    const auto of_packed = metrics_of_range(
        scene, task, 7, database::Attempts(*services.store()).read_packed_trace(sessions.at("tara"), own), 2,
        5);
    ASSERT_EQ(of_packed.size(), part.size());
    for (std::size_t i = 0; i < part.size(); ++i) EXPECT_EQ(of_packed[i].value, part[i].value) << part[i].id;
    const auto value = [](const std::vector<MetricResult>& of, const char* id, const char* hand) {
        return find_result(of, id, hand, "")->value.value_or(-1);
    };
    EXPECT_NEAR(value(part, "time", ""), 3, 0.01);
    EXPECT_NEAR(value(whole, "time", ""), 6, 0.3);
    EXPECT_NEAR(value(part, "f_max", "left"), 3, 0.05);
    EXPECT_LT(value(part, "path_len", "left"), 0.7 * value(whole, "path_len", "left"));

    // A range of one's own, by mouse with Shift in a chart and by the buttons.
    choose_tab(*window, "compare_tabs", "Force and speed");
    auto* chart = find<TimeChart>(*window, "compare_left");
    bring(*chart);
    ASSERT_TRUE(wait_for([&] { return chart->chart()->plotArea().width() > 150; }));
    const QRectF plot = chart->chart()->plotArea();
    const QPoint from(static_cast<int>(plot.left() + plot.width() / 4), static_cast<int>(plot.center().y()));
    QTest::mousePress(chart->viewport(), Qt::LeftButton, Qt::ShiftModifier, from);
    QTest::mouseMove(chart->viewport(), from + QPoint(40, 0));
    QMouseEvent move(QEvent::MouseMove, from + QPoint(60, 0), Qt::NoButton, Qt::LeftButton,
                     Qt::ShiftModifier);
    QApplication::sendEvent(chart->viewport(), &move);
    QTest::mouseRelease(chart->viewport(), Qt::LeftButton, Qt::ShiftModifier, from + QPoint(60, 0));
    ASSERT_TRUE(wait_for([&] { return page.is_ready(); }));
    EXPECT_EQ(step->currentText(), "Own range");
    keep("compare-range");
    click(*window, "compare_part_whole");
    EXPECT_FALSE(sees(*window, "compare_part_words"));
    EXPECT_EQ(line("Time")[0], "6 s");
    (void)earlier;
}

TEST_F(Comparing, SaysWhatCannotBeCompared) {
    record("tara", {1, 1, "standard", false, 90});
    record("tara", {1, 1, "deep", true, 20});
    const std::string own = record("tara", {});
    ComparePage& page = open("tara", own);
    EXPECT_TRUE(notes().startsWith("Other attempt: The recording of this attempt was not kept"))
        << notes().toStdString();
    EXPECT_EQ(line("Time"), (QStringList{"6 s", "6 s", "0 s (0 %)", "–"}));
    choose(page, "Latest attempt");
    EXPECT_TRUE(notes().startsWith("Different variants: Standard and Deeper plane."))
        << notes().toStdString();

    // The attempt itself without a trace: no replay, the metrics alone.
    const std::string bare = record("tara", {1, 1, "standard", false, 40});
    ComparePage& again = open("tara", bare);
    EXPECT_TRUE(notes().contains("This attempt: The recording of this attempt was not kept"));
    EXPECT_FALSE(sees(*window, "compare_slider"));
    EXPECT_FALSE(sees(*window, "compare_own_replay"));
    EXPECT_EQ(line("Time")[0], "6 s");
    EXPECT_FALSE(find<QAbstractButton>(*window, "compare_part_begin")->isEnabled());
    EXPECT_TRUE(again.is_ready());
}

TEST_F(Comparing, AVoidedAttemptHasNoResultThere) {
    record("tara", {2, 1, "standard", true, 90});
    const std::string own = record("tara", {});
    database::Attempts(*services.store()).void_attempt(sessions.at("ed"), own, "wrong person");
    open("ed", own);
    const QString words = find<QLabel>(*window, "compare_own_words")->text();
    EXPECT_TRUE(words.contains("voided")) << words.toStdString();
    EXPECT_FALSE(words.contains("passed")) << words.toStdString();
    EXPECT_FALSE(words.contains("50 of 100")) << words.toStdString();
    EXPECT_TRUE(notes().startsWith("Voided by Ed Educator")) << notes().toStdString();
    EXPECT_TRUE(notes().contains("wrong person"));
    EXPECT_TRUE(notes().contains("Aligned by the 3 steps")) << notes().toStdString();
    EXPECT_TRUE(find<QLabel>(*window, "compare_other_words")->text().contains("90 of 100"));
}

TEST_F(Comparing, AnExpertIsSimulatedInTheBackgroundAndCanBeStopped) {
    const std::string model = record("other0", {0.5, 0.5});
    const std::string own = record("tara", {});
    window = std::make_unique<MainWindow>(services);
    window->resize(1012, 726);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->start();
    window->context().set_session(sessions.at("tara"));
    services.expert_waits = true;
    // With no other attempt the expert is the first choice; this one never ends by itself.
    emit window->context().compare_wanted(text(own));
    auto* page = static_cast<ComparePage*>(window->current_page());
    ASSERT_TRUE(wait_for([&] { return sees(*window, "compare_slider") && sees(*window, "cancel_job"); }));
    EXPECT_FALSE(page->is_ready());
    auto* slider = find<QSlider>(*window, "compare_slider");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageUp);
    EXPECT_GT(page->moment(), 0.2) << "the window answers while the expert works";
    click(*window, "cancel_job");
    EXPECT_TRUE(page->is_ready());
    EXPECT_EQ(page->pair(), nullptr);

    ExpertAttempt expert;
    expert.summary = database::Attempts(*services.store()).read(sessions.at("other0"), model);
    expert.summary.meta.id.clear();
    expert.summary.meta.device_class = DeviceClass::synthetic;
    expert.score = *database::Attempts(*services.store()).score(sessions.at("other0"), model);
    expert.trace = std::make_shared<const database::Trace>(
        database::Attempts(*services.store()).read_trace(sessions.at("other0"), model));
    services.expert = expert;
    services.expert_waits = false;
    emit window->context().compare_wanted(text(own));
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    ASSERT_NE(page->pair(), nullptr);
    EXPECT_NEAR(page->pair()->map.to_second(2), 1, 1e-6);
    EXPECT_TRUE(find<QLabel>(*window, "compare_other_words")->text().contains("Expert of the benchmark"));
}

TEST_F(Comparing, AChoiceThatIsRefusedStopsWhatWasReadForTheOneBefore) {
    record("tara", {2, 1, "standard", true, 90});
    ComparePage& page = open("ed", record("tara", {}));
    ASSERT_NE(page.pair(), nullptr);
    services.expert_waits = true;
    auto* box = find<QComboBox>(*window, "compare_with");
    const int row = box->findText("An expert", Qt::MatchStartsWith);
    ASSERT_GT(row, 0);
    box->setFocus();
    for (int i = 0; i < row; ++i) QTest::keyClick(box, Qt::Key_Down);
    ASSERT_TRUE(wait_for([&] { return sees(*window, "cancel_job"); }));
    EXPECT_FALSE(page.is_ready());
    {
        const database::Store other = database::Store::open(services.store()->path());
        database::erase_person(other, sessions.at("dora"), sessions.at("tara").person_id(), "asked", false);
    }
    QTest::keyClick(box, Qt::Key_Home);
    EXPECT_TRUE(sees(*window, "message_text")) << "the attempt is gone";
    EXPECT_TRUE(page.is_ready()) << "and the expert is not waited for";
    EXPECT_FALSE(sees(*window, "cancel_job"));
    EXPECT_EQ(page.pair(), nullptr);
}

TEST_F(Comparing, TheCohortIsABandOfFivePeopleOrMore) {
    for (int i = 0; i < 4; ++i) record("other" + std::to_string(i), {1 + 0.1 * i, 1 + 0.1 * i});
    const std::string own = record("tara", {});
    {
        ComparePage& page = open("ed", own);
        choose(page, "Cohort Spring");
        EXPECT_TRUE(notes().contains("A band needs at least 5")) << notes().toStdString();
        ASSERT_NE(page.cohort(), nullptr);
        EXPECT_TRUE(page.cohort()->force[0].empty());
        EXPECT_TRUE(page.cohort()->metrics.empty()) << "nothing of fewer than five";
    }
    record("other4", {1.4, 1.4});
    ComparePage& page = open("ed", own);
    choose(page, "Cohort Spring");
    ASSERT_NE(page.cohort(), nullptr);
    EXPECT_EQ(page.cohort()->people, 5U);
    const std::vector<BandPoint>& band = page.cohort()->force[0];
    ASSERT_GT(band.size(), 300U);
    // Forces of 1, 1.1 … 1.4 N in the first step, twice that in the second, whatever the pace.
    const auto at = [&](double t) {
        return std::find_if(band.begin(), band.end(), [&](const BandPoint& p) { return p.time >= t; })
            ->spread;
    };
    EXPECT_NEAR(at(1.0).middle, 1.2, 1e-3);
    EXPECT_NEAR(at(1.0).low, 1.1, 1e-3);
    EXPECT_NEAR(at(1.0).high, 1.3, 1e-3);
    EXPECT_NEAR(at(4.0).middle, 2.4, 1e-3);
    EXPECT_FALSE(sees(*window, "compare_other_replay"));
    EXPECT_EQ(line("Time")[1], "7.2 s (6.6 to 7.8)");
    choose_tab(*window, "compare_tabs", "Force and speed");
    keep("compare-cohort");

    // A trainee compares with no one else.
    ComparePage& theirs = open("tara", own);
    for (const ComparisonChoice& one : theirs.choices())
        EXPECT_NE(one.kind, ComparisonChoice::Kind::cohort) << one.title.toStdString();
}

TEST_F(Comparing, AnAttemptThatARaterSawNextToAnotherIsNotRatedBlindAfterwards) {
    const std::string begun = record("tara", {1, 1, "standard", true, 90});
    const std::string seen = record("tara", {1, 1, "standard", true, 60});
    const std::string own = record("tara", {});
    const Session& ed = sessions.at("ed");
    // The window opens the store once more.
    const auto ratings = [&] { return database::Ratings(*services.store()); };
    ratings().begin(ed, begun, load_form(asset_path("forms/goals.json")));
    const auto would_be_blind = [&](const std::string& id) {
        for (const database::RatableAttempt& one : ratings().to_rate(ed))
            if (one.attempt_id == id) return one.blind;
        ADD_FAILURE() << "not in the list of raters";
        return false;
    };
    EXPECT_TRUE(would_be_blind(seen));
    ComparePage& page = open("ed", own);
    ASSERT_NE(page.pair(), nullptr);
    EXPECT_TRUE(find<QLabel>(*window, "compare_other_words")->text().contains("60 of 100"));
    EXPECT_FALSE(would_be_blind(seen)) << "its name and points were next to its replay";
    for (const ComparisonChoice& one : page.choices())
        EXPECT_NE(one.id, begun) << "that would lift the blinding of the form";
    EXPECT_TRUE(ratings().is_blind(ed, begun));
}

TEST_F(Comparing, ValuesOfTwoVersionsOfAMetricAreNotHeldAgainstEachOther) {
    const ComparedRecord old_one{2, 1, "standard", true, 90, "B2", 2};
    ComparedRecord present;
    present.version = 3;
    record("tara", old_one);
    for (int i = 0; i < 5; ++i) record("other" + std::to_string(i), i == 0 ? old_one : present);
    ComparePage& page = open("ed", record("tara", present));
    EXPECT_EQ(line("Time"), (QStringList{"6 s", "12 s", "–", "measured by another version of the metric"}));
    choose(page, "Cohort Spring");
    ASSERT_NE(page.cohort(), nullptr);
    EXPECT_TRUE(page.cohort()->metrics.empty()) << "of fewer than five by the same version";
    EXPECT_TRUE(notes().contains("another version of the metric measured are left out: Time."))
        << notes().toStdString();
    EXPECT_EQ(line("Time"), (QStringList{"6 s", "–", "–", "–"}));
}

// A part is chosen while something else happens to the page.
TEST_F(Comparing, APartOutlivesHastyChoicesAThemeAndTheErasureOfItsTrainee) {
    record("tara", {2, 1, "standard", true, 90});
    const std::string own = record("tara", {});
    ComparePage& page = open("ed", own);
    auto* step = find<QComboBox>(*window, "compare_step");
    step->setFocus();
    for (int i = 0; i < 12; ++i) QTest::keyClick(step, i % 4 == 3 ? Qt::Key_Up : Qt::Key_Down);
    QTest::keyClick(step, Qt::Key_Home);
    QTest::keyClick(step, Qt::Key_Down);  // the first step: to 2 s
    ASSERT_TRUE(wait_for([&] { return page.is_ready(); }));
    EXPECT_EQ(line("Time")[0], "2 s") << "of the part that was chosen last";
    const QString words = find<QLabel>(*window, "compare_part_words")->text();
    for (const Theme theme : {Theme::dark, Theme::light}) {
        window->set_theme(theme);
        EXPECT_EQ(find<QLabel>(*window, "compare_part_words")->text(), words);
        EXPECT_EQ(line("Time")[0], "2 s");
    }
    // The trainee is erased by another program: what is read is shown until the page is left.
    const auto erase = [&] {
        const database::Store other = database::Store::open(services.store()->path());
        database::erase_person(other, sessions.at("dora"), sessions.at("tara").person_id(), "asked", false);
    };
    erase();
    choose_tab(*window, "compare_tabs", "Force and speed");
    step->setFocus();
    QTest::keyClick(step, Qt::Key_Down);
    ASSERT_TRUE(wait_for([&] { return page.is_ready(); }));
    EXPECT_EQ(line("Time")[0], "3 s");
    EXPECT_FALSE(sees(*window, "message_text"));
    click(*window, "compare_back");
    EXPECT_TRUE(sees(*window, "message_text")) << "the attempt is gone";
    EXPECT_FALSE(sees(*window, "comment_text"));
    choose_page(*window, "rail_metrics");
    EXPECT_EQ(window->current_page()->objectName(), "metrics_page");
}

TEST_F(Comparing, APartOfATaskThatIsNotThereHasNoMetricsInsteadOfThoseOfTheWhole) {
    ComparedRecord unknown;
    unknown.task = "Z9";
    ComparePage& page = open("tara", record("tara", unknown));
    EXPECT_EQ(line("Time")[0], "6 s");
    choose_tab(*window, "compare_tabs", "Force and speed");
    auto* slider = find<QSlider>(*window, "compare_slider");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageUp);
    click(*window, "compare_part_begin");
    ASSERT_TRUE(wait_for([&] { return page.is_ready(); }));
    EXPECT_TRUE(find<QLabel>(*window, "compare_part_words")->text().contains("no metrics of a part"))
        << find<QLabel>(*window, "compare_part_words")->text().toStdString();
    EXPECT_TRUE(line("Time").isEmpty());
    click(*window, "compare_part_whole");
    EXPECT_EQ(line("Time")[0], "6 s");
}

}  // namespace
}  // namespace fulcrum::ui::window_test
