// SPDX-License-Identifier: GPL-3.0-or-later
// The main paths of an educator, an administrator and a trainee on the delivered demonstration, by clicks and
// keys; the director's is in dashboard_window_test.cpp. The demonstration takes practice only and has no
// administrator: where a path needs more, the test opens its own copy for the making of it.
#include <QChart>
#include <QComboBox>
#include <QFile>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QSlider>
#include <QTableView>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "app/services/demo.h"
#include "assessment/trace/phase_alignment.h"
#include "database/records/people.h"
#include "database/records/reviews.h"
#include "database/rows/connection.h"
#include "tests/app/window_fixture.h"
#include "tests/database/station_keys.h"
#include "ui/administration/station_page.h"
#include "ui/charts/time_chart.h"
#include "ui/review/compare_page.h"
#include "ui/review/replay_panel.h"
#include "ui/style/text.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

/// As while the demonstration was made: it takes comments, roles and people.
void break_seal(const database::Store& demonstration) {
    demonstration.connection().execute("UPDATE setting SET value = '0' WHERE key = 'demo_sealed'");
}

class DemonstrationPaths : public Window {
  protected:
    void look_around_as(const QString& name) {
        expect_page("first_start_page");
        click(window, "look_around");
        ASSERT_TRUE(wait_for([&] { return sees(window, "pick_demo_person"); }));
        for (QAbstractButton* pick : window.findChildren<QAbstractButton*>("pick_demo_person")) {
            if (!pick->isVisible() || !pick->text().startsWith(name)) continue;
            bring(*pick);
            QCoreApplication::processEvents();
            QTest::mouseClick(pick, Qt::LeftButton);
            break;
        }
        ASSERT_TRUE(wait_for([&] { return window.context().signed_in(); })) << name.toStdString();
    }
    void press(const char* name) {
        auto* button = find<QAbstractButton>(window, name);
        ASSERT_NE(button, nullptr);
        bring(*button);
        QCoreApplication::processEvents();
        click(window, name);
    }
    /// Types a name and opens the cell of a task.
    void open_cell(const QString& name, const QString& task) {
        wait_until_read(window);
        type(window, "grid_name", name);
        auto* grid = find<QTableView>(window, "cohort_grid");
        ASSERT_EQ(grid->model()->rowCount(), 1) << name.toStdString();
        int column = 1;
        while (column < grid->model()->columnCount() &&
               grid->model()->headerData(column, Qt::Horizontal).toString() != task)
            ++column;
        const QModelIndex cell = grid->model()->index(0, column);
        ASSERT_TRUE(cell.isValid()) << task.toStdString();
        bring(*grid);
        grid->scrollTo(cell);
        QTest::mouseClick(grid->viewport(), Qt::LeftButton, {}, grid->visualRect(cell).center());
        EXPECT_EQ(grid->currentIndex(), cell);
        QTest::keyClick(grid, Qt::Key_Return);
        expect_page("progress_page");
    }
    /// The attempt whose recording was kept.
    std::string recorded_attempt(const std::string& task, const std::string& name) {
        database::AttemptFilter filter;
        filter.task_id = task;
        filter.limit = -1;
        for (const auto& one : database::Attempts(*services.store()).list(window.context().session(), filter))
            if (one.meta.keep_trace && one.person_name.rfind(name, 0) == 0) return one.meta.id;
        return {};
    }
    /// From the person's attempts at the task to the debrief of this one.
    void open_attempt(const std::string& id) {
        wait_until_read(window);
        auto* attempts = find<QTableWidget>(window, "progress_table");
        bring(*attempts);
        int row = 0;
        while (row < attempts->rowCount() &&
               attempts->item(row, 0)->data(Qt::UserRole).toString().toStdString() != id)
            ++row;
        ASSERT_LT(row, attempts->rowCount()) << id;
        choose_row(*attempts, row);
        QTest::keyClick(attempts, Qt::Key_Return);
        wait_for_debrief();
    }
    /// Its plot, laid out.
    TimeChart& chart(const char* name) {
        auto* found = find<TimeChart>(window, name);
        bring(*found);
        EXPECT_TRUE(wait_for([&] { return found->chart()->plotArea().width() > 150; }));
        return *found;
    }
    static QPoint in_plot(TimeChart& of, double share) {
        const QRectF plot = of.chart()->plotArea();
        return QPointF(plot.left() + share * plot.width(), plot.center().y()).toPoint();
    }
    /// A drag with Shift.
    static void choose_part(TimeChart& of, double from_share, double to_share) {
        QTest::mousePress(of.viewport(), Qt::LeftButton, Qt::ShiftModifier, in_plot(of, from_share));
        QMouseEvent move(QEvent::MouseMove, in_plot(of, to_share), Qt::NoButton, Qt::LeftButton,
                         Qt::ShiftModifier);
        QApplication::sendEvent(of.viewport(), &move);
        QTest::mouseRelease(of.viewport(), Qt::LeftButton, Qt::ShiftModifier, in_plot(of, to_share));
    }
    /// The row of a metric, waiting until it is there; -1: it never came.
    int metric_row(const char* table_name, const QString& metric) {
        int found = -1;
        const bool there = wait_for([&] {
            if (!sees(window, table_name)) return false;
            auto* table = find<QTableWidget>(window, table_name);
            for (int row = 0; row < table->rowCount() && found < 0; ++row)
                if (table->item(row, 0)->text() == metric) found = row;
            return found >= 0;
        });
        EXPECT_TRUE(there) << table_name << ": no " << metric.toStdString();
        return found;
    }
    void compare_with_the_expert() {
        press("debrief_compare");
        expect_page("compare_page");
        auto* page = static_cast<ComparePage*>(window.current_page());
        const auto ready = [&] { return page->is_ready(); };
        ASSERT_TRUE(wait_for(ready, 120000));
        auto* with = find<QComboBox>(window, "compare_with");
        const int row = with->findText("An expert", Qt::MatchStartsWith);
        ASSERT_GE(row, 0);
        with->setFocus();
        QTest::keyClick(with, Qt::Key_Home);
        for (int i = 0; i < row; ++i) QTest::keyClick(with, Qt::Key_Down);
        ASSERT_EQ(with->currentIndex(), row);
        ASSERT_TRUE(wait_for(ready, 120000));
        ASSERT_NE(page->pair(), nullptr) << "the program simulates one";
        EXPECT_TRUE(shown("compare_other_words").contains("Expert of the benchmark"));
        EXPECT_TRUE(shown("compare_notes").contains("Aligned by the"))
            << shown("compare_notes").toStdString();
        choose_tab(window, "compare_tabs", "Metrics");
        const int time = metric_row("comparison_table", "Time");
        ASSERT_GE(time, 0);
        auto* metrics = find<QTableWidget>(window, "comparison_table");
        for (const int column : {2, 3}) EXPECT_TRUE(metrics->item(time, column)->text().endsWith("s"));
    }
};

TEST_F(DemonstrationPaths, AnEducatorGoesFromACellOfTheGridToAMarkInTheReplay) {
    look_around_as("Dr Hanna");
    expect_page("cohort_page");
    open_cell("Kavya", "B2");
    EXPECT_TRUE(find<QComboBox>(window, "progress_person")->currentText().startsWith("Kavya Rao"));
    EXPECT_EQ(find<QComboBox>(window, "progress_task")->currentData().toString(), "B2");
    const std::string id = recorded_attempt("B2", "Kavya Rao");
    ASSERT_FALSE(id.empty());
    open_attempt(id);
    DebriefPage& debrief = wait_for_debrief();

    // The mark that is there leads to its moment; the demonstration takes no further one.
    const auto before = database::Reviews(*services.store()).comments(window.context().session(), id);
    ASSERT_EQ(before.size(), 1U);
    press("comment_moment");
    EXPECT_NEAR(debrief.moment(), before[0].time_s, 0.02);
    EXPECT_EQ(shown("comment_words").toStdString(), before[0].text);
    EXPECT_FALSE(sees(window, "comment_text"));

    // A range, and its metrics next to those of the whole.
    choose_part(chart("force_chart"), 0.25, 0.6);
    const int time = metric_row("part_table", "Time");
    ASSERT_GE(time, 0);
    auto* part = find<QTableWidget>(window, "part_table");
    EXPECT_NE(part->item(time, 2)->text(), part->item(time, 3)->text());
    EXPECT_TRUE(shown("review_part_words").contains(" to "));

    compare_with_the_expert();
    break_seal(*services.store());
    press("compare_back");
    ASSERT_EQ(&wait_for_debrief(), &debrief);
    TimeChart& force = chart("force_chart");
    QTest::mouseClick(force.viewport(), Qt::LeftButton, {}, in_plot(force, 0.5));
    const double moment = debrief.moment();
    EXPECT_NEAR(moment, (force.first_shown() + force.last_shown()) / 2, 0.5);
    auto* comment = find<QPlainTextEdit>(window, "comment_text");
    ASSERT_NE(comment, nullptr);
    bring(*comment);
    comment->setFocus();
    QTest::keyClicks(comment, "Here the traction is right.");
    press("comment_send");
    const auto after = database::Reviews(*services.store()).comments(window.context().session(), id);
    ASSERT_EQ(after.size(), 2U);
    const auto mark = std::find_if(after.begin(), after.end(), [](const database::Comment& one) {
        return one.text == "Here the traction is right.";
    });
    ASSERT_NE(mark, after.end());
    EXPECT_NEAR(mark->time_s, moment, 1e-9);
    EXPECT_GT(mark->sent, 0);
}

// The program's own expert, who performs in the scene of the stored attempt.
TEST_F(DemonstrationPaths, TheExpertNextToAnAttemptIsAlignedByStepsAndHasTheExpertsOwnValues) {
    look_around_as("Dr Hanna");
    open_cell("Kavya", "B2");
    const std::string id = recorded_attempt("B2", "Kavya Rao");
    ASSERT_FALSE(id.empty());
    open_attempt(id);
    const AttemptModel& opened = *wait_for_debrief().model();
    const double tick = opened.tick;
    const PhaseMoments mine = phase_moments(opened.trace->events, tick, opened.duration);
    compare_with_the_expert();
    auto* page = static_cast<ComparePage*>(window.current_page());
    const database::Attempts attempts(*services.store());
    const database::Session& session = window.context().session();
    const database::AttemptSummary own = attempts.read(session, id);
    const std::optional<ExpertAttempt> expert = services.expert_attempt(session, own)({});
    ASSERT_TRUE(expert.has_value());
    EXPECT_EQ(expert->summary.meta.operator_name, "expert");
    EXPECT_EQ(expert->summary.state, AttemptState::completed);

    // Each step that both met ends at the same place of the time axis.
    const PhaseMoments theirs =
        phase_moments(expert->trace->events, tick, expert->trace->samples.back().tick * tick);
    const PhaseMap& map = page->pair()->map;
    ASSERT_FALSE(map.common_goals().empty());
    for (const int goal : map.common_goals())
        EXPECT_NEAR(map.to_second(mine.met.at(goal)), theirs.met.at(goal), 1e-6) << "step " << goal;

    // Both pictures, next to each other, at one moment of the same step.
    auto* own_picture = find<ReplayPanel>(window, "compare_own_replay");
    auto* other_picture = find<ReplayPanel>(window, "compare_other_replay");
    bring(*own_picture);
    const auto place = [this](QWidget* one) { return QRect(one->mapTo(&window, QPoint()), one->size()); };
    const QRect left = place(own_picture), right = place(other_picture);
    EXPECT_LT(left.right(), right.left());
    EXPECT_LT(std::max(left.top(), right.top()), std::min(left.bottom(), right.bottom()));
    const auto shows = [](ReplayPanel* one) {
        return one->shown_time() >= 0 && std::abs(one->shown_time() - one->time()) < 0.05;
    };
    auto* slider = find<QSlider>(window, "compare_slider");
    slider->setFocus();
    for (const int goal : map.common_goals()) {
        slider->setValue(static_cast<int>(std::lround(mine.met.at(goal) * 100)) - 1);
        QTest::keyClick(slider, Qt::Key_Right);
        EXPECT_NEAR(page->moment(), mine.met.at(goal), 0.02) << "step " << goal;
        EXPECT_NEAR(other_picture->time(), map.to_second(page->moment()), 0.02) << "step " << goal;
        EXPECT_TRUE(wait_for([&] { return shows(own_picture) && shows(other_picture); }, 120000))
            << "step " << goal << ": " << own_picture->shown_time() << " and " << other_picture->shown_time();
    }

    // The table has the stored values of the attempt and those of the expert's score.
    using Cells = std::map<std::pair<QString, QString>, QString>;
    const auto values_of = [](const database::ScoreRow& score) {
        Cells cells;
        for (const database::MetricRow& row : score.metrics)
            if (row.tissue.empty())
                cells[{metric_text(row.id), QString::fromStdString(row.hand)}] =
                    figure_with_unit(row.value, row.unit);
        return cells;
    };
    const auto stored = attempts.score(session, id);
    ASSERT_TRUE(stored.has_value());
    const Cells own_values = values_of(*stored), expert_values = values_of(expert->score);
    auto* table = find<QTableWidget>(window, "comparison_table");
    int compared = 0;
    for (int row = 0; row < table->rowCount(); ++row) {
        const std::pair<QString, QString> metric(table->item(row, 0)->text(), table->item(row, 1)->text());
        const std::string what = (metric.first + QLatin1Char(' ') + metric.second).toStdString();
        ASSERT_EQ(own_values.count(metric), 1U) << what;
        EXPECT_EQ(table->item(row, 2)->text(), own_values.at(metric)) << what;
        if (expert_values.count(metric) == 0) continue;  // a metric of an older version
        EXPECT_EQ(table->item(row, 3)->text(), expert_values.at(metric)) << what;
        ++compared;
    }
    EXPECT_GT(compared, 5);
}

// An administrator for a copy of the demonstration, by the functions that made its other people.
TEST_F(DemonstrationPaths, AnAdministratorLooksAfterPeopleStoreAndLogAndSeesNoScores) {
    const database::test::KeysOfOneTest keys;
    ASSERT_TRUE(unpack_demo(services.store_path(true), {}));
    {
        database::Store store = database::Store::open(services.store_path(true));
        const database::Session station = store.station_session();
        break_seal(store);
        const database::People people(store);
        people.set_demo_roles(
            station, people.ensure_synthetic(station, "demo-administrator", "Sam Lindholm (synthetic)").id,
            {database::Role::administrator});
        store.seal_demo(station);
    }
    look_around_as("Sam Lindholm");
    expect_page("people_page");
    for (const char* page : {"rail_cohort", "rail_attempts", "rail_progress", "rail_dashboard"})
        EXPECT_FALSE(sees(window, page)) << page;
    auto* people = find<QTableWidget>(window, "people_table");
    ASSERT_EQ(people->rowCount(), 24 + 3 + 1 + 1);
    const QList<QTableWidgetItem*> amara = people->findItems("Amara Okafor", Qt::MatchStartsWith);
    ASSERT_EQ(amara.size(), 1);
    bring(*people);
    choose_row(*people, amara.front()->row());
    press("toggle_active");
    ASSERT_TRUE(wait_for([&] { return sees(window, "message_text"); }));
    const auto all = database::People(*services.store()).list(window.context().session());
    EXPECT_TRUE(std::all_of(all.begin(), all.end(), [](const database::Person& one) { return one.active; }))
        << "the demonstration takes practice only";
    click(window, "close_message");

    choose_page(window, "rail_station");
    press("check_store");
    ASSERT_TRUE(wait_for([&] { return sees(window, "check_verdict"); }, 120000));
    EXPECT_TRUE(shown("check_verdict").contains("The store is intact"))
        << shown("check_verdict").toStdString();
    const QString copy = folder.filePath("copy.db");
    static_cast<StationPage*>(window.current_page())->back_up_to(copy);  // what the dialog of files asks for
    ASSERT_TRUE(wait_for(
        [&] { return sees(window, "message_text") && shown("message_text").contains("Backed up to"); },
        120000));
    EXPECT_TRUE(QFile::exists(copy));

    choose_page(window, "rail_audit");
    ASSERT_TRUE(wait_for([&] { return shown("audit_chain").contains("The audit log is intact"); }, 120000));
    auto* kind = find<QComboBox>(window, "audit_kind");
    kind->setFocus();
    QTest::keyClick(kind, Qt::Key_End);
    auto* log = find<QTableWidget>(window, "audit_table");
    ASSERT_GE(log->rowCount(), 1);
    for (int row = 0; row < log->rowCount(); ++row) EXPECT_EQ(log->item(row, 3)->text(), kind->currentText());
    switch_user();
    EXPECT_TRUE(wait_for([&] { return sees(window, "pick_demo_person"); }));
}

/// Apart from the other paths: an attempt runs in real time.
class DemonstrationPractice : public DemonstrationPaths {};

TEST_F(DemonstrationPractice, ATraineePractisesAfterTheBriefingAndSeesTheDebrief) {
    look_around_as("Amara");
    expect_page("home_page");
    click(window, "briefing_A2");
    expect_page("briefing_page");
    EXPECT_FALSE(find<QRadioButton>(window, "mode_assessed")->isEnabled());
    EXPECT_EQ(shown("mode_note"), "The demonstration accepts practice attempts only.");
    home();
    start("A2", false);
    move_hands(10);
    ASSERT_TRUE(wait_for([&] { return theatre().session()->display().elapsed_s > 1.5; }));
    abandon();
    DebriefPage& debrief = wait_for_debrief();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_EQ(attempt.meta.person_id, window.context().session().person_id());
    EXPECT_EQ(attempt.meta.mode, AttemptMode::practice);
    EXPECT_EQ(attempt.state, AttemptState::abandoned);
    EXPECT_FALSE(attempt.counting);
    EXPECT_TRUE(shown("debrief_about").contains("practice")) << shown("debrief_about").toStdString();
    auto* replay = debrief.findChild<ReplayPanel*>();
    EXPECT_TRUE(wait_for([&] { return replay->shown_time() >= 0; }, 120000));
    EXPECT_FALSE(sees(window, "comment_text"));
    expect_replays(attempt.meta.id);
    click(window, "rail_progress");
    wait_until_read(window);
    expect_page("progress_page");
    auto* attempts = find<QTableWidget>(window, "progress_table");
    const QString newest = QString::fromStdString(attempt.meta.id);
    bool listed = false;
    for (int row = 0; row < attempts->rowCount(); ++row)
        listed = listed || attempts->item(row, 0)->data(Qt::UserRole).toString() == newest;
    EXPECT_TRUE(listed) << "the page is of the task that was practised last";
    switch_user();
}

}  // namespace
}  // namespace fulcrum::app::program_test
