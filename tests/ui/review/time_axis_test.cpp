// SPDX-License-Identifier: GPL-3.0-or-later
// The debrief on one time axis: force, speed, traction, energy and heat as the record holds them, zoomed
// together; a part chosen with real events, whose metrics are those of the page Compare. With
// FULCRUM_PICTURES=FOLDER pictures are stored.
#include <gtest/gtest.h>

#include <QChart>
#include <QComboBox>
#include <QLabel>
#include <QWheelEvent>
#include <cmath>

#include "assessment/metrics/registry.h"
#include "database/records/people.h"
#include "database/records/recorder.h"
#include "database/scoring/range_metrics.h"
#include "tests/support/support.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "tests/ui/heard.h"
#include "ui/charts/time_chart.h"
#include "ui/charts/time_charts.h"
#include "ui/language/language.h"
#include "ui/review/compare_page.h"
#include "ui/review/debrief_page.h"
#include "ui/review/replay_panel.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Role;
using database::Session;

/// What the charts of a record show.
struct AxisRecord {
    bool cutting = true, energy = true, heat = true;
    std::string task = "B2";
    bool pause = false;  // from 3.1 to 3.4 s, with energy on
};

class OneTimeAxis : public ::testing::Test {
  protected:
    OneTimeAxis() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        const database::People people(*services.store());
        const Session alma =
            people.create_programme("Surgery", "alma", "Alma Admin", "correct horse").administrator;
        const auto add = [&](const std::string& login, const std::string& name, Role role) {
            const auto made = people.create(alma, login, name, {role});
            return people.change_password(people.sign_in(login, made.one_time_password),
                                          made.one_time_password, "a long password");
        };
        tara = add("tara", "Tara Trainee", Role::trainee);
        ed = add("ed", "Ed Educator", Role::educator);
        const Session dora = add("dora", "Dora Director", Role::director);
        const std::string cohort = people.create_cohort(dora, "Spring");
        people.set_members(dora, cohort, {tara->person_id()});
        people.set_educators(dora, cohort, {ed->person_id()});
        window = std::make_unique<MainWindow>(services);
        window->resize(1012, 726);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        QApplication::setActiveWindow(window.get());
    }
    ~OneTimeAxis() override {
        window.reset();
        use_language(Language::english);
        apply_theme(*qApp, Theme::light);
        apply_text_size(*qApp, 100);
    }
    /// Six seconds: steps that end at 2, 5 and 6 s; a slip; a cut from 2.1 to 2.4 s; energy of the right hand
    /// from 3.0 to 3.5 and from 4.0 to 4.2 s, and heat.
    std::string record(const AxisRecord& like) {
        database::AttemptMeta meta;
        meta.person_id = tara->person_id();
        meta.task_id = like.task;
        meta.device = "test";
        meta.variant = meta.fidelity = "standard";
        meta.scene = "b2_plane.json";
        meta.program_version = "0.1.0-test";
        database::Recorder recorder(services.store()->path(), *tara, meta, {});
        std::multimap<std::uint32_t, Event> events;
        const auto happens = [&](std::uint32_t tick, EventKind kind, std::uint8_t hand, int detail,
                                 float value) {
            events.emplace(tick, Event{tick, kind, hand, -1, detail, value});
        };
        happens(1, EventKind::first_movement, 255, 0, 0);
        happens(2000, EventKind::phase_end, 255, 0, 0);
        happens(5000, EventKind::phase_end, 255, 1, 0);
        happens(5999, EventKind::phase_end, 255, 2, 0);
        happens(6000, EventKind::completed, 255, 0, 0);
        happens(600, EventKind::slip, 0, 0, 0);
        if (like.cutting) {
            happens(2100, EventKind::cut_begin, 1, 0, 0.010F);
            happens(2200, EventKind::cut_advance, 1, 0, 0.011F);
            happens(2200, EventKind::cut_traction, 1, 1000, 9.5F);
            happens(2300, EventKind::cut_advance, 1, 0, 0.012F);
            happens(2300, EventKind::cut_traction, 1, 1000, 21.0F);
            happens(2400, EventKind::cut_end, 1, 0, 0.012F);
        }
        if (like.heat) {
            happens(3600, EventKind::heat_area, 255, 0, 12.5F);
            happens(4300, EventKind::heat_area, 255, 0, 20.0F);
        }
        if (like.pause) {
            happens(3100, EventKind::pause, 255, 0, 0);
            happens(3400, EventKind::resume, 255, 0, 0);
        }
        for (std::uint32_t tick = 1; tick <= 6000; ++tick) {
            RigSample input;
            TickSample sample;
            input.tick = sample.tick = tick;
            recorder.append(input);
            const double x = 0.02 * std::sin(tick * 2e-3);
            for (HandSample& hand : sample.hand) {
                hand.tip[0] = static_cast<std::int32_t>(std::lround(x / sample_length_unit));
                hand.flags = hand_inside | hand_in_view;
            }
            if (like.energy && ((tick >= 3000 && tick < 3500) || (tick >= 4000 && tick < 4200)))
                sample.hand[1].flags |= hand_energy;
            sample.hand[0].force[2] = tick > 2000 && tick <= 5000 ? 3000 : 1000;
            recorder.append(sample);
            for (auto [at, last] = events.equal_range(tick); at != last; ++at) recorder.append(at->second);
        }
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = result.wall_s = 6;
        result.state_hash = "00ff";
        database::ScoreRow score;
        score.program_version = "0.1.0-test";
        database::MetricRow time;
        time.id = "time";
        time.version = find_metric("time")->version;
        time.value = 6;
        time.unit = "s";
        time.direction = Direction::lower;
        score.metrics = {time};
        score.passed = true;
        score.advice = Statement(StatementId::gates_met);
        result.score = score;
        recorder.finish(result);
        return recorder.attempt_id();
    }
    DebriefPage* debrief(const Session& who, const std::string& id) {
        window->context().set_session(who);
        emit window->context().debrief_wanted(QString::fromStdString(id), -1);
        auto* page = static_cast<DebriefPage*>(window->current_page());
        EXPECT_TRUE(wait_for([&] { return page->is_ready(); }));
        return page;
    }
    /// s, of the right hand, as the chart and as the metric says.
    static double energy_drawn(const AttemptModel& model) {
        double on = 0;
        for (const ChartSpan& span : model.energy[1]) on += span.to - span.from;
        return on;
    }
    double energy_measured(const std::string& id) {
        TaskDefinition task = load_task(test::source_path("assets/tasks/B2.json"));
        task.metrics = {"energy_time"};
        const auto rows = metrics_of_range(services.scene_for(task, "standard"), task, 7,
                                           database::Attempts(*services.store()).read_trace(*ed, id), 0, 6);
        return find_result(rows, "energy_time", "right", "")->value.value();
    }
    TimeChart* chart(const char* name) { return find<TimeChart>(*window, name); }
    static QPoint in_plot(TimeChart& of, double share) {
        const QRectF plot = of.chart()->plotArea();
        return QPointF(plot.left() + share * plot.width(), plot.center().y()).toPoint();
    }
    void select_by_mouse(TimeChart& of, double from_share, double to_share) {
        bring(of);
        ASSERT_TRUE(wait_for([&] { return of.chart()->plotArea().width() > 150; }));
        const QPoint from = in_plot(of, from_share), to = in_plot(of, to_share);
        QTest::mousePress(of.viewport(), Qt::LeftButton, Qt::ShiftModifier, from);
        QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, Qt::ShiftModifier);
        QApplication::sendEvent(of.viewport(), &move);
        QTest::mouseRelease(of.viewport(), Qt::LeftButton, Qt::ShiftModifier, to);
    }
    /// The value of a metric in a table, waiting until it is there.
    QString cell(const char* table_name, const QString& metric, const QString& hand, int column = 2) {
        QString found;
        const bool there = wait_for([&] {
            for (auto* table : window->findChildren<QTableWidget*>(QLatin1String(table_name)))
                for (int row = 0; row < table->rowCount(); ++row)
                    if (table->item(row, 0)->text() == metric && table->item(row, 1)->text() == hand)
                        found = table->item(row, column)->text().replace(QChar(0x202F), QLatin1Char(' '));
            return !found.isEmpty();
        });
        EXPECT_TRUE(there) << metric.toStdString();
        return found;
    }
    void keep(const char* name) { keep_picture(*window, QStringLiteral("time-axis-") + name); }

    FakeServices services;
    std::optional<Session> tara, ed;
    std::unique_ptr<MainWindow> window;
};

TEST_F(OneTimeAxis, ShowsWhatTheRecordHoldsBelowEachOtherAndZoomsTogether) {
    const std::string id = record({});
    DebriefPage* page = debrief(*ed, id);
    const char* const names[] = {"force_chart", "speed_chart", "traction_chart", "energy_chart"};
    std::vector<TimeChart*> charts;
    for (const char* name : names) charts.push_back(chart(name));
    const auto left_of = [&](TimeChart* one) {
        return one->mapTo(window.get(), QPoint()).x() + one->chart()->plotArea().left();
    };
    EXPECT_TRUE(wait_for([&] {
        for (TimeChart* one : charts)
            if (std::abs(left_of(one) - left_of(charts[0])) > 1.5) return false;
        return true;
    })) << left_of(charts[0])
        << " " << left_of(charts[1]) << " " << left_of(charts[2]) << " " << left_of(charts[3]);
    EXPECT_NEAR(charts[0]->chart()->plotArea().width(), charts[3]->chart()->plotArea().width(), 1.5);

    const AttemptModel& model = *page->model();
    ASSERT_EQ(model.traction.steps.size(), 2U);
    EXPECT_TRUE(model.traction.per_length);
    EXPECT_NEAR(model.traction.steps[0].from, 2.1, 1e-9);
    EXPECT_NEAR(model.traction.steps[0].to, 2.2, 1e-9);
    EXPECT_NEAR(model.traction.steps[1].value, 21, 1e-6);
    EXPECT_TRUE(model.energy[0].empty());
    ASSERT_EQ(model.energy[1].size(), 2U) << "one span across a chunk of the record stays one";
    EXPECT_NEAR(model.energy[1][0].from, 3.0, 1e-9);
    EXPECT_NEAR(model.energy[1][0].to, 3.5, 1e-9);
    ASSERT_NE(model.heat, nullptr);
    EXPECT_EQ(model.heat->highest(), 20);
    EXPECT_EQ(model.heat->value_at(3.7), 12.5);
    EXPECT_NEAR(energy_drawn(model), 0.7, 1e-9);
    EXPECT_NEAR(energy_measured(id), energy_drawn(model), 1e-9);

    bring(*charts[0]);
    QWheelEvent wheel(in_plot(*charts[0], 0.5), charts[0]->viewport()->mapToGlobal(in_plot(*charts[0], 0.5)),
                      {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(charts[0]->viewport(), &wheel);
    EXPECT_GT(charts[0]->first_shown(), 0.1);
    for (TimeChart* one : charts) {
        EXPECT_NEAR(one->first_shown(), charts[0]->first_shown(), 1e-9);
        EXPECT_NEAR(one->last_shown(), charts[0]->last_shown(), 1e-9);
    }
    QTest::mouseClick(charts[3]->viewport(), Qt::LeftButton, {}, in_plot(*charts[3], 0.5));
    EXPECT_NEAR(page->moment(), (charts[3]->first_shown() + charts[3]->last_shown()) / 2, 0.1);
    for (TimeChart* one : charts) EXPECT_NEAR(one->cursor(), page->moment(), 1e-9);
    charts[2]->setFocus();
    QTest::keyClick(charts[2], Qt::Key_0);
    EXPECT_NEAR(charts[0]->first_shown(), 0, 1e-9);
    keep("light");
    emit window->context().theme_wanted(Theme::dark);
    keep("dark");
}

TEST_F(OneTimeAxis, APauseWithThePedalDownIsNoEnergy) {
    AxisRecord paused;
    paused.pause = true;
    const std::string id = record(paused);
    const AttemptModel& model = *debrief(*ed, id)->model();
    ASSERT_EQ(model.energy[1].size(), 3U);
    EXPECT_NEAR(model.energy[1][0].to, 3.1, 2e-3);
    EXPECT_NEAR(model.energy[1][1].from, 3.4, 2e-3);
    EXPECT_NEAR(model.energy[1][1].to, 3.5, 1e-9);
    EXPECT_NEAR(energy_drawn(model), 0.4, 2e-3);
    EXPECT_NEAR(energy_measured(id), energy_drawn(model), 1e-6);

    // A device that was lost, and a pause that nobody ended.
    const std::vector<Event> open{{1500, EventKind::device_lost, 255, -1, 0, 0.0F},
                                  {2000, EventKind::device_back, 255, -1, 0, 0.0F},
                                  {4500, EventKind::pause, 255, -1, 0, 0.0F}};
    const std::vector<ChartSpan> left =
        without_pauses({{0, 1}, {1, 2.5}, {3, 4}, {4.2, 6}, {6.5, 7}}, open, 1e-3, 7);
    ASSERT_EQ(left.size(), 5U);
    EXPECT_NEAR(left[0].to, 1, 1e-9);
    EXPECT_NEAR(left[1].to, 1.501, 1e-9);
    EXPECT_NEAR(left[2].from, 2, 1e-9);
    EXPECT_NEAR(left[3].to, 4, 1e-9);
    EXPECT_NEAR(left[4].to, 4.501, 1e-9);
}

TEST_F(OneTimeAxis, ALineEndsAtAPauseAndBeginsAgainAfterIt) {
    AxisRecord paused;
    paused.pause = true;
    const AttemptModel& model = *debrief(*ed, record(paused))->model();
    EXPECT_NEAR(model.duration, 6, 1e-9);
    for (std::size_t hand = 0; hand < hand_count; ++hand) {
        for (const MinMaxPyramid* values : {model.force[hand].get(), model.speed[hand].get()}) {
            EXPECT_TRUE(values->at(3.0)) << hand;
            EXPECT_FALSE(values->at(3.25)) << hand;
            EXPECT_TRUE(values->at(3.5)) << hand;
        }
    }
    for (const char* name : {"force_chart", "speed_chart"}) {
        const std::vector<ChartLine>& lines = chart(name)->lines_of(0);
        ASSERT_EQ(lines.size(), 2U) << name;
        EXPECT_LE(lines[0].points.back().x, 3.1 + 1e-9) << name;
        EXPECT_GE(lines[1].points.front().x, 3.4 - 1e-9) << name;
    }
    int rows = 0;
    for (const ChartRow& row : window->findChild<TimeCharts*>()->table().rows) {
        const double time = std::stod(row.cells.at(0).copied);
        if (time < 3.11 || time > 3.39) continue;
        ++rows;
        for (std::size_t column = 1; column <= 4; ++column)
            EXPECT_EQ(row.cells.at(column).copied, "") << time << " s, column " << column;
    }
    EXPECT_GT(rows, 0) << "a copy has the gap too";
}

TEST(JoinedSamples, AreThoseThatTheMetricsMeasureAcross) {
    const std::vector<double> time{0, 0.1, 0.2, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.05};
    const std::vector<Event> events{{650, EventKind::samples_lost, 255, -1, 3, 0.0F},
                                    {1000, EventKind::completed, 255, -1, 0, 0.0F}};
    const std::vector<TraceBlock> blocks = joined_samples(time, events, 1e-3);
    ASSERT_EQ(blocks.size(), 3U);
    EXPECT_EQ(blocks[0].last, 3U) << "a gap of the record";
    EXPECT_EQ(blocks[1].first, 3U);
    EXPECT_EQ(blocks[1].last, 5U) << "lost samples";
    EXPECT_EQ(blocks[2].last, 10U) << "what follows the end stays";
    EXPECT_TRUE(joined_samples({}, {}, 1e-3).empty());
    // A device that was taken up elsewhere has not moved there.
    std::vector<double> raster;
    std::vector<Vector3> tip;
    for (int i = 0; i < 10; ++i) {
        raster.push_back(0.01 * i);
        tip.emplace_back(i < 5 ? 0 : 0.1, 0, 0);
    }
    const std::vector<bool> inside(10, true);
    for (const float speed : tip_speed(raster, tip, inside, {5})) EXPECT_EQ(speed, 0);
    EXPECT_GT(tip_speed(raster, tip, inside)[5], 1000);
}

TEST_F(OneTimeAxis, LeavesOutWhatWasNotRecorded) {
    debrief(*ed, record({false, false, false}));
    EXPECT_TRUE(sees(*window, "speed_chart"));
    EXPECT_FALSE(sees(*window, "traction_chart"));
    EXPECT_FALSE(sees(*window, "energy_chart"));
    DebriefPage* page = debrief(*ed, record({false, true, false}));
    EXPECT_TRUE(sees(*window, "energy_chart"));
    bring(*chart("energy_chart"));
    QTest::mouseClick(chart("energy_chart")->viewport(), Qt::LeftButton, {},
                      in_plot(*chart("energy_chart"), 0.5));
    EXPECT_NEAR(page->moment(), 3, 0.1) << "a chart of lanes alone knows its time too";
    EXPECT_FALSE(chart("energy_chart")->accessibleName().contains("mm²"));
    debrief(*ed, record({true, false, false}));
    EXPECT_TRUE(sees(*window, "traction_chart"));
    EXPECT_FALSE(sees(*window, "energy_chart"));
}

TEST_F(OneTimeAxis, APartHasTheMetricsThatComparingShows) {
    const std::string id = record({});
    DebriefPage* page = debrief(*ed, id);
    EXPECT_FALSE(sees(*window, "part_table")) << "nothing is chosen";
    auto* step = find<QComboBox>(*window, "review_step");
    bring(*step);
    step->setFocus();
    QTest::keyClick(step, Qt::Key_Down);
    QTest::keyClick(step, Qt::Key_Down);
    EXPECT_EQ(find<QLabel>(*window, "review_part_words")->text(), "0:02.0 to 0:05.0");
    EXPECT_NEAR(page->moment(), 2, 1e-3);
    const QString force = cell("part_table", "Largest force", "left"), time = cell("part_table", "Time", "");
    EXPECT_EQ(time, "3 s");
    EXPECT_EQ(cell("part_table", "Time", "", 3), "6 s") << "the whole, next to it";
    keep("part");
    click(*window, "review_part_zoom");
    for (const char* name : {"force_chart", "energy_chart"}) {
        EXPECT_NEAR(chart(name)->first_shown(), 2, 1e-6);
        EXPECT_NEAR(chart(name)->last_shown(), 5, 1e-6);
    }
    // By the mouse in any chart: the same part in all of them.
    select_by_mouse(*chart("traction_chart"), 0.25, 0.5);
    EXPECT_EQ(step->currentText(), "Own range");
    EXPECT_EQ(find<QLabel>(*window, "review_part_words")->text().left(5), "0:02.");
    EXPECT_TRUE(wait_for([&] { return cell("part_table", "Time", "") != "3 s"; }));
    // By the buttons.
    click(*window, "review_part_whole");
    EXPECT_FALSE(sees(*window, "part_table"));
    EXPECT_NEAR(chart("force_chart")->last_shown(), 6, 1e-6) << "all is shown again";
    page->findChild<ReplayPanel*>()->seek(2);
    click(*window, "review_part_begin");
    page->findChild<ReplayPanel*>()->seek(5);
    click(*window, "review_part_end");
    EXPECT_EQ(find<QLabel>(*window, "review_part_words")->text(), "0:02.0 to 0:05.0");
    EXPECT_EQ(cell("part_table", "Largest force", "left"), force);

    bring(*find<QAbstractButton>(*window, "debrief_compare"));
    click(*window, "debrief_compare");
    auto* compare = static_cast<ComparePage*>(window->current_page());
    ASSERT_TRUE(wait_for([&] { return sees(*window, "compare_step"); }));
    auto* same = find<QComboBox>(*window, "compare_step");
    same->setFocus();
    QTest::keyClick(same, Qt::Key_Down);
    QTest::keyClick(same, Qt::Key_Down);
    ASSERT_TRUE(wait_for([&] { return compare->is_ready(); }));
    EXPECT_EQ(cell("comparison_table", "Largest force", "left"), force);
    EXPECT_EQ(cell("comparison_table", "Time", ""), time);
}

TEST_F(OneTimeAxis, APartOfATaskThatIsNotThereSaysSoAndWhoRatesBlindSeesNoMetrics) {
    AxisRecord unknown;
    unknown.task = "Z9";
    DebriefPage* page = debrief(*ed, record(unknown));
    page->findChild<ReplayPanel*>()->seek(1);
    auto* begin = find<QAbstractButton>(*window, "review_part_begin");
    bring(*begin);
    click(*window, "review_part_begin");
    EXPECT_TRUE(find<QLabel>(*window, "review_part_words")->text().contains("no metrics of a part"));
    EXPECT_FALSE(sees(*window, "part_table"));

    emit window->context().rating_wanted(QString::fromStdString(record({})));
    page = static_cast<DebriefPage*>(window->current_page());
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    ASSERT_TRUE(sees(*window, "rating_blind_notice"));
    EXPECT_TRUE(sees(*window, "traction_chart"));
    EXPECT_FALSE(sees(*window, "review_step")) << "its metrics are those of the score";
    select_by_mouse(*chart("force_chart"), 0.2, 0.6);
    QTest::qWait(200);
    EXPECT_FALSE(sees(*window, "part_table"));
    click(*window, "lift_blinding");
    EXPECT_TRUE(sees(*window, "review_step"));
}

TEST_F(OneTimeAxis, LeavingWhileAPartIsMeasuredStopsIt) {
    const std::string id = record({});
    debrief(*ed, id);
    for (int i = 0; i < 5; ++i) {
        select_by_mouse(*chart("speed_chart"), 0.1 * i, 0.1 * i + 0.3);
        EXPECT_TRUE(sees(*window, "part_table"));
        debrief(*ed, id);
        EXPECT_FALSE(sees(*window, "part_table"));
    }
    EXPECT_FALSE(sees(*window, "message_text"));
}

TEST_F(OneTimeAxis, FitsTheSmallestWindowWithLargeTextInBothThemesAndLanguages) {
    const std::string id = record({});
    struct Look {
        Theme theme;
        Language language;
        const char* name;
    };
    for (const Look& look : {Look{Theme::light, Language::english, "large-light"},
                             Look{Theme::dark, Language::german, "large-dark-german"}}) {
        emit window->context().theme_wanted(look.theme);
        emit window->context().language_wanted(look.language);
        window->set_text_size(200);
        DebriefPage* page = debrief(*ed, id);
        for (const char* name : {"force_chart", "energy_chart", "review_step", "review_part_begin",
                                 "review_part_end", "review_part_whole"}) {
            auto* widget = find<QWidget>(*window, name);
            bring(*widget);
            const auto place = [&] { return QRect(widget->mapTo(window.get(), QPoint()), widget->size()); };
            EXPECT_TRUE(wait_for([&] { return place().left() >= 0 && place().right() <= window->width(); }))
                << look.name << " " << name << ": " << place().left() << " to " << place().right();
            EXPECT_FALSE(spoken_name(widget).isEmpty()) << name;
            // A chart is covered by its viewport.
            if (auto* shown = qobject_cast<TimeChart*>(widget)) widget = shown->viewport();
            EXPECT_FALSE(widget->visibleRegion().isEmpty()) << look.name << " " << name;
        }
        page->findChild<ReplayPanel*>()->seek(1);
        click(*window, "review_part_begin");
        ASSERT_TRUE(wait_for([&] { return sees(*window, "part_table"); }));
        bring(*find<QWidget>(*window, "part_table"));
        keep(look.name);
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
