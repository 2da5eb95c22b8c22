// SPDX-License-Identifier: GPL-3.0-or-later
// The debrief as a screen: verdict, advice and product first; the replay and the traces on one screen, moving
// together; the rest in tabs; the meaning of each value one click away.
#include <gtest/gtest.h>

#include <QChart>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QThreadPool>
#include <cmath>
#include <functional>
#include <future>

#include "database/records/attempts.h"
#include "database/records/people.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "tests/ui/painted_words.h"
#include "tests/ui/specimens.h"
#include "ui/charts/time_chart.h"
#include "ui/language/language.h"
#include "ui/page/background_job.h"
#include "ui/review/attempt_model.h"
#include "ui/review/debrief_page.h"
#include "ui/review/replay_panel.h"
#include "ui/shell/main_window.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Role;
using database::Session;

class DebriefLayout : public ::testing::Test {
  protected:
    DebriefLayout() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        const database::People people(*services.store());
        const Session alma =
            people.create_programme("Surgery", "alma", "Alma Admin", "correct horse").administrator;
        const auto made = people.create(alma, "tara", "Tara Trainee", {Role::trainee});
        tara = std::make_unique<Session>(people.change_password(
            people.sign_in("tara", made.one_time_password), made.one_time_password, "a long password"));
    }
    ~DebriefLayout() override { apply_theme(*qApp, Theme::light); }

    /// An attempt of C4 of 12 s with three events, a moving left hand, and a specimen.
    std::string record(const PathologyReport& specimen) {
        database::AttemptMeta meta;
        meta.person_id = tara->person_id();
        meta.task_id = "C4";
        meta.mode = AttemptMode::practice;
        meta.device_class = DeviceClass::haptic;
        meta.device = "test";
        meta.variant = "standard";
        meta.fidelity = "standard";
        meta.scene = "c4_posterior.json";
        meta.limits = "C4-operators@1";
        meta.program_version = "0.1.0-test";
        database::Recorder recorder(services.store()->path(), *tara, meta, {});
        for (std::uint32_t tick = 1; tick <= 12000; ++tick) {
            RigSample input;
            recorder.append(input);
            TickSample sample;
            sample.tick = tick;
            // The left tip moves at 50 mm/s along x, the right one is still.
            sample.hand[0].tip[0] = static_cast<std::int32_t>(std::lround(tick * 5e-5 / sample_length_unit));
            for (HandSample& hand : sample.hand) hand.flags = hand_inside | hand_in_view;
            sample.hand[0].force[2] = static_cast<std::int32_t>(std::lround(2.0 / sample_force_unit));
            recorder.append(sample);
            const auto event = [&](EventKind kind, int detail = 0) {
                Event one;
                one.tick = tick;
                one.kind = kind;
                one.hand = 255;
                one.detail = detail;
                one.tissue = -1;
                recorder.append(one);
            };
            if (tick == 1) event(EventKind::attempt_begin);
            if (tick == 1000) event(EventKind::phase_begin, 0);
            if (tick == 6000) event(EventKind::phase_end, 0);
            if (tick == 6001) event(EventKind::phase_begin, 1);
            if (tick == 12000) event(EventKind::abandoned);
        }
        database::AttemptResult result;
        result.state = AttemptState::abandoned;
        result.duration_s = result.wall_s = 12;
        result.state_hash = "00ff";
        database::ScoreRow score;
        score.program_version = "0.1.0-test";
        score.limits = "C4-operators@1";
        database::MetricRow time;
        time.id = "time";
        time.value = 12;
        time.unit = "s";
        time.direction = Direction::lower;
        time.evidence = {{9.0, 10.0}};
        score.metrics = {time};
        database::GateRow gate;
        gate.metric = "time";
        gate.kind = GateKind::benchmark;
        gate.value = 12;
        gate.unit = "s";
        gate.limit = 200;
        gate.limit_source = "C4-operators@1";
        gate.passed = true;
        score.gates = {gate};
        score.passed = false;
        score.advice = Statement(StatementId::gates_met);
        score.pathology = pathology_json(specimen);
        if (change_score) change_score(score);
        result.score = score;
        recorder.finish(result);
        return recorder.attempt_id();
    }
    DebriefPage& open(const std::string& id, QSize size = {1012, 726}) {
        window = std::make_unique<MainWindow>(services);
        window->resize(size);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        window->context().set_session(*tara);
        emit window->context().debrief_wanted(text(id), -1);
        auto* debrief = static_cast<DebriefPage*>(window->current_page());
        EXPECT_TRUE(wait_for([&] { return debrief->is_ready(); }));
        QCoreApplication::processEvents();
        return *debrief;
    }
    int top_of(const char* name) {
        auto* widget = find<QWidget>(*window, name);
        return widget->mapTo(body(), QPoint(0, 0)).y();
    }
    QWidget* body() { return window->current_page()->findChild<QWidget*>(QStringLiteral("page_body")); }
    QScrollArea* area() { return qobject_cast<QScrollArea*>(body()->parentWidget()->parentWidget()); }
    void keep(const QString& name) {
        keep_picture(*window, name);
        if (!qEnvironmentVariableIsEmpty("FULCRUM_PICTURES"))
            keep_body(*window, *window->current_page(), name + "-whole");
    }

    FakeServices services;
    std::unique_ptr<Session> tara;
    std::unique_ptr<MainWindow> window;
    std::function<void(database::ScoreRow&)> change_score;
};

TEST_F(DebriefLayout, WhyAnAttemptWasNotScoredAppearsOnce) {
    const Statement why(StatementId::device_class_differs, {{"device", "controller"}});
    change_score = [&](database::ScoreRow& score) {
        score.passed.reset();
        score.not_scored_because = why;
        score.advice = Statement(StatementId::not_scored, {{"because", why}});
        score.gates[0].passed.reset();
        score.gates[0].limit.reset();
        score.gates[0].limit_source.clear();
        score.gates[0].not_passed_because = why;
    };
    open(record(varied_specimen()));
    EXPECT_TRUE(find<QLabel>(*window, "advice")->text().contains("not comparable: there are no limits"))
        << find<QLabel>(*window, "advice")->text().toStdString();
    const auto* notes = window->current_page()->findChild<QLabel*>(QStringLiteral("debrief_notes"));
    ASSERT_NE(notes, nullptr);
    EXPECT_FALSE(notes->text().contains("comparable")) << notes->text().toStdString();
    keep("debrief-no-limits");
    // Where the advice is about something else, the note says why.
    change_score = [&, before = change_score](database::ScoreRow& score) {
        before(score);
        score.advice = Statement(StatementId::attempt_abandoned);
    };
    open(record(varied_specimen()));
    EXPECT_TRUE(find<QLabel>(*window, "debrief_notes")->text().contains("Not scored: not comparable"));
}

TEST_F(DebriefLayout, ProvisionalLimitsAreThoseOfSimulatedExpertsOrOfTheTaskItself) {
    const auto notes = [&] {
        open(record(varied_specimen()));
        return find<QLabel>(*window, "debrief_notes")->text();
    };
    change_score = [](database::ScoreRow& score) { score.gates[0].provisional = true; };
    EXPECT_TRUE(notes().contains("they come from simulated experts"));
    change_score = [](database::ScoreRow& score) {
        score.gates[0].limit_source = "experts of this site, set 4, 10 experts";
        score.gates.push_back(score.gates[0]);
        score.gates[1].metric = "grasp_max";
        score.gates[1].hand = "left";
        score.gates[1].kind = GateKind::absolute;
        score.gates[1].unit = "N";
        score.gates[1].limit_source = "training limit";
        score.gates[1].provisional = true;
    };
    const QString with_set_of_site = notes();
    EXPECT_TRUE(with_set_of_site.contains("no benchmark set of the site has taken them over"))
        << with_set_of_site.toStdString();
    EXPECT_FALSE(with_set_of_site.contains("simulated experts"));
}

TEST_F(DebriefLayout, VerdictAdviceAndProductComeFirstThenTheReplayThenTabs) {
    open(record(varied_specimen()));
    EXPECT_LT(top_of("verdict"), top_of("advice"));
    EXPECT_LT(top_of("advice"), top_of("headline_0"));
    EXPECT_LT(top_of("headline_0"), top_of("product"));
    EXPECT_LT(top_of("product"), top_of("specimen_map"));
    EXPECT_LT(top_of("specimen_map"), top_of("replay_block"));
    EXPECT_LT(top_of("replay_block"), top_of("debrief_tabs"));
    EXPECT_EQ(
        find<QLabel>(*window, "product")->text(),
        "1 of 3 steps done. Left: Divide the plane level by level under traction; Release the rectum and "
        "withdraw.");
    EXPECT_FALSE(sees(*window, "metrics_table"));
    EXPECT_FALSE(sees(*window, "action_reason"));
    choose_tab(*window, "debrief_tabs", "All metrics");
    EXPECT_TRUE(sees(*window, "metrics_table"));
    EXPECT_FALSE(sees(*window, "gates_table"));
}

TEST(DebriefProduct, OfPracticeFromALaterStepIsThatOfTheStepsFromThereOn) {
    TaskDefinition task;
    for (const char* words : {"first", "second", "third", "fourth"}) {
        task.goals.emplace_back();
        task.goals.back().text = words;
    }
    AttemptModel model;
    model.summary.state = model.summary.recorded_state = AttemptState::abandoned;
    EXPECT_EQ(product_text(model, task), "0 of 4 steps done. Left: first; second; third; fourth.");
    model.summary.meta.origin.emplace();
    model.summary.meta.origin->goal = 2;
    EXPECT_EQ(product_text(model, task), "0 of 2 steps done. Left: third; fourth.");
    model.goals_done = {2};
    EXPECT_EQ(product_text(model, task), "1 of 2 steps done. Left: fourth.");
    model.goals_done = {2, 3};
    model.summary.state = model.summary.recorded_state = AttemptState::completed;
    EXPECT_EQ(product_text(model, task), "All 4 steps done.");
    // A goal that the task no longer has.
    model.goals_done.clear();
    model.summary.state = model.summary.recorded_state = AttemptState::abandoned;
    model.summary.meta.origin->goal = 9;
    EXPECT_EQ(product_text(model, task), "0 of 1 steps done. Left: fourth.");
}

TEST_F(DebriefLayout, ReplayTracesAndEventsFitOneScreenAtEverySize) {
    const std::string id = record(varied_specimen());
    for (const QSize size : {QSize(1012, 726), QSize(1268, 758), QSize(1908, 1038)}) {
        for (const Theme theme : {Theme::light, Theme::dark}) {
            apply_theme(*qApp, theme);
            DebriefPage& debrief = open(id, size);
            // A choice further down shows the replay.
            auto* gates = find<QTableWidget>(*window, "gates_table");
            QTest::mouseClick(gates->viewport(), Qt::LeftButton, {},
                              gates->visualItemRect(gates->item(0, 0)).center());
            EXPECT_DOUBLE_EQ(debrief.moment(), 9.0);
            QCoreApplication::processEvents();
            for (const char* name : {"replay_slider", "force_chart", "speed_chart", "event_list"}) {
                auto* widget = find<QWidget>(*window, name);
                const QRect place(widget->mapTo(area()->viewport(), QPoint(0, 0)), widget->size());
                EXPECT_TRUE(area()->viewport()->rect().contains(place))
                    << name << " at " << size.width() << ": " << place.top() << " to " << place.bottom()
                    << " of " << area()->viewport()->height();
            }
            keep(QStringLiteral("debrief-%1-%2")
                     .arg(size.width())
                     .arg(theme == Theme::light ? "light" : "dark"));
        }
    }
}

TEST_F(DebriefLayout, ReplayChartsAndEventListMoveEachOther) {
    DebriefPage& debrief = open(record(varied_specimen()));
    auto* events = find<QListWidget>(*window, "event_list");
    auto* force = find<TimeChart>(*window, "force_chart");
    auto* speed = find<TimeChart>(*window, "speed_chart");
    ASSERT_EQ(events->count(), 4);
    ASSERT_TRUE(wait_for([&] { return force->chart()->plotArea().width() > 150; })) << "laid out";
    // Events move the replay and both cursors.
    events->scrollToItem(events->item(2));
    QTest::mouseClick(events->viewport(), Qt::LeftButton, {},
                      events->visualItemRect(events->item(2)).center());
    EXPECT_NEAR(debrief.moment(), 6.001, 1e-9);
    EXPECT_NEAR(force->cursor(), 6.001, 1e-9);
    EXPECT_NEAR(speed->cursor(), 6.001, 1e-9);
    // A click in either chart moves the replay, the other cursor and the list.
    for (TimeChart* chart : {force, speed}) {
        const QRectF plot = chart->chart()->plotArea();
        const double wanted = chart == force ? 2.0 : 9.0;
        const double share = (wanted - chart->first_shown()) / (chart->last_shown() - chart->first_shown());
        QTest::mouseClick(chart->viewport(), Qt::LeftButton, {},
                          QPoint(static_cast<int>(plot.left() + share * plot.width()),
                                 static_cast<int>(plot.center().y())));
        EXPECT_NEAR(debrief.moment(), wanted, 0.1);
        EXPECT_DOUBLE_EQ(force->cursor(), debrief.moment());
        EXPECT_DOUBLE_EQ(speed->cursor(), debrief.moment());
        EXPECT_EQ(events->currentRow(), chart == force ? 1 : 2);
    }
    // The replay moves both.
    auto* slider = find<QSlider>(*window, "replay_slider");
    QTest::keyClick(slider, Qt::Key_End);
    EXPECT_DOUBLE_EQ(speed->cursor(), debrief.moment());
    EXPECT_EQ(events->currentRow(), 3);
    QTest::keyClick(slider, Qt::Key_Home);
    EXPECT_EQ(events->currentRow(), -1) << "before the first event";
}

TEST_F(DebriefLayout, ChartsZoomTogether) {
    open(record(varied_specimen()));
    auto* force = find<TimeChart>(*window, "force_chart");
    auto* speed = find<TimeChart>(*window, "speed_chart");
    EXPECT_DOUBLE_EQ(force->last_shown(), speed->last_shown());
    force->setFocus();
    QTest::keyClick(force, Qt::Key_Plus);
    EXPECT_LT(force->last_shown() - force->first_shown(), 11);
    EXPECT_DOUBLE_EQ(force->first_shown(), speed->first_shown());
    EXPECT_DOUBLE_EQ(force->last_shown(), speed->last_shown());
    QTest::keyClick(speed, Qt::Key_0);
    EXPECT_NEAR(force->last_shown(), 12, 0.05);
}

TEST_F(DebriefLayout, SpeedIsThatOfTheTips) {
    const DebriefPage& debrief = open(record(varied_specimen()));
    EXPECT_NEAR(debrief.model()->speed[0]->value_at(5), 50, 0.5);
    EXPECT_NEAR(debrief.model()->speed[1]->value_at(5), 0, 1e-9);
    // A lost second or an instrument outside the body has no speed.
    const std::vector<double> time{0, 0.01, 0.02, 0.03, 1.04, 1.05, 1.06, 1.07, 1.08};
    std::vector<Vector3> tip;
    for (const double t : time) tip.emplace_back(0.1 * t, 0, 0);
    std::vector<bool> inside(time.size(), true);
    std::vector<float> speed = tip_speed(time, tip, inside);
    EXPECT_NEAR(speed[1], 100, 1e-3);
    EXPECT_TRUE(std::isnan(speed[3]));
    EXPECT_NEAR(speed[6], 100, 1e-3);
    inside[6] = false;
    speed = tip_speed(time, tip, inside);
    EXPECT_TRUE(std::isnan(speed[6]));
    EXPECT_TRUE(tip_speed({}, {}, {}).empty());
}

TEST_F(DebriefLayout, MeaningOfEachValueIsOneClickAwayAndBack) {
    DebriefPage& debrief = open(record(varied_specimen()));
    const std::string id = debrief.model()->summary.meta.id;
    click(*window, "explain_headline");  // the last of them: damage
    EXPECT_EQ(window->current_page()->objectName(), "metrics_page");
    EXPECT_FALSE(find<QLabel>(*window, "metric_explanation")->text().isEmpty());
    click(*window, "metrics_back");
    EXPECT_TRUE(wait_for([&] { return debrief.is_ready(); }));
    EXPECT_EQ(debrief.model()->summary.meta.id, id);
    auto* gates = find<QTableWidget>(*window, "gates_table");
    QTest::mouseClick(gates->viewport(), Qt::LeftButton, {},
                      gates->visualItemRect(gates->item(0, 6)).center());
    EXPECT_EQ(window->current_page()->objectName(), "metrics_page");
    auto* table = find<QTableWidget>(*window, "metric_table");
    EXPECT_EQ(table->item(table->currentRow(), 0)->text(), metric_text("time"));
    // Opened from the rail it leads nowhere back.
    click(*window, "rail_home");
    click(*window, "rail_metrics");
    EXPECT_FALSE(sees(*window, "metrics_back"));
}

TEST_F(DebriefLayout, ADefectOnTheMapMovesTheReplay) {
    open(record(varied_specimen(120)));
    EXPECT_TRUE(find<QWidget>(*window, "specimen_map")->accessibleDescription().contains("Not gradable"));
    DebriefPage& graded = open(record(specimen([](int at) { return at >= 40 && at < 50 ? -9.0 : 0.4; })));
    EXPECT_EQ(graded.moment(), 0.0);
    click(*window, "specimen_cell_1_left");
    click(*window, "specimen_show");
    EXPECT_NEAR(graded.moment(), 4.0, 1e-9);
}

TEST_F(DebriefLayout, AReportThatIsWrittenAfterTheDebriefWasLeftIsSaved) {
    open(record(varied_specimen()));
    QTemporaryDir folder;
    QThreadPool& pool = *QThreadPool::globalInstance();
    pool.waitForDone();
    QCoreApplication::processEvents();
    const int threads = pool.maxThreadCount();
    pool.setMaxThreadCount(1);
    std::promise<void> release;
    QObject owner;
    BackgroundJob::run(
        &owner, [released = release.get_future().share()](const Progress&) { released.wait(); }, [] {},
        [](const QString&) {});
    type(*window, "export_path", folder.filePath("late.json"));
    bring(*find<QPushButton>(*window, "export_attempt"));
    click(*window, "export_attempt");
    EXPECT_TRUE(sees(*window, "cancel_job"));
    bring(*find<QPushButton>(*window, "debrief_back"));
    click(*window, "debrief_back");
    EXPECT_NE(window->current_page()->objectName(), "debrief_page");
    release.set_value();
    pool.waitForDone();
    pool.setMaxThreadCount(threads);
    EXPECT_TRUE(wait_for([&] {
        return sees(*window, "message_text") &&
               find<QLabel>(*window, "message_text")->text().contains("late.json");
    }));
    EXPECT_TRUE(QFile::exists(folder.filePath("late.json")));
}

TEST_F(DebriefLayout, CancelOfAReportThatWasBegunEarlierStaysInTheDebrief) {
    const std::string second = record(varied_specimen());
    DebriefPage& debrief = open(record(varied_specimen()));
    QThreadPool& pool = *QThreadPool::globalInstance();
    const int threads = pool.maxThreadCount();
    pool.setMaxThreadCount(threads + 1);
    std::promise<void> release;
    QObject owner;
    BackgroundJob* report = BackgroundJob::run(
        &owner, [released = release.get_future().share()](const Progress&) { released.wait(); }, [] {},
        [](const QString&) {});
    debrief.findChild<JobBar*>()->watch(report, QStringLiteral("Writing the report …"));
    emit window->context().debrief_wanted(text(second), -1);
    EXPECT_TRUE(wait_for([&] { return debrief.is_ready(); }));
    EXPECT_TRUE(sees(*window, "cancel_job")) << "the report is still being written";
    bring(*find<QPushButton>(*window, "cancel_job"));
    click(*window, "cancel_job");
    EXPECT_FALSE(sees(*window, "cancel_job"));
    EXPECT_EQ(window->current_page(), &debrief);
    EXPECT_TRUE(debrief.is_ready());
    // Where the attempt is still being read, it leaves.
    emit window->context().debrief_wanted(text(second), -1);
    click(*window, "cancel_job");
    EXPECT_NE(window->current_page(), &debrief);
    release.set_value();
    pool.waitForDone();
    pool.setMaxThreadCount(threads);
}

TEST_F(DebriefLayout, ALimitOfForceNamesItsTissuesWholeAndInTheReadersLanguage) {
    use_language(Language::german);
    open(record(varied_specimen()));
    auto* chart = find<TimeChart>(*window, "force_chart");
    EXPECT_TRUE(wait_for([&] { return chart->chart()->plotArea().width() > 100; }));
    WordsDevice device(chart->size());
    QPainter painter(&device);
    chart->render(&painter);
    painter.end();
    QString painted;
    for (const PaintedWords& line : device.words()) {
        painted += line.words.trimmed() + QLatin1Char(' ');
        EXPECT_LE(line.place.right(), chart->width()) << line.words.toStdString();
    }
    for (const char* words : {"Grenze, Darm, Faszie", "lockeres", "Bindegewebe"})
        EXPECT_TRUE(painted.contains(words)) << words << " in " << painted.toStdString();
    keep("debrief-limit-de");
    use_language(Language::english);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
