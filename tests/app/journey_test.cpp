// SPDX-License-Identifier: GPL-3.0-or-later
// The whole workflow with the real program: programme, people, attempts by mouse and keyboard, debrief,
// replay, comment, void, the director's files. By default A2 is abandoned after one sphere. With
// FULCRUM_JOURNEY_PAGE=docs/results it is completed, the minute of a lost device is waited for, and the page
// is written. FULCRUM_PICTURES=FOLDER stores the screens.
#include <QComboBox>
#include <QHeaderView>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QSlider>
#include <QTabWidget>
#include <nlohmann/json.hpp>

#include "assessment/metrics/statement_words.h"
#include "tests/app/journey_page.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/window_fixture.h"
#include "tests/ui/files.h"
#include "ui/reports/report.h"
#include "ui/review/replay_panel.h"
#include "ui/style/text.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

using Cells = std::vector<std::string>;

std::vector<Cells> csv_rows(const std::string& csv) {
    std::vector<Cells> rows(1, Cells(1));
    bool quoted = false;
    for (const char c : csv) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            rows.back().emplace_back();
        } else if (c == '\n' && !quoted) {
            rows.emplace_back(1);
        } else if (c != '\r' || quoted) {
            rows.back().back() += c;
        }
    }
    rows.pop_back();
    return rows;
}

/// By the header's name.
std::string cell_of(const std::vector<Cells>& rows, std::size_t row, const std::string& column) {
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
        if (rows[0][i] == column) return rows[row][i];
    }
    ADD_FAILURE() << "no column " << column;
    return {};
}

class Journey : public Window {
  protected:
    void find_row(QTableWidget& table, std::initializer_list<QString> wanted) {
        for (int row = 0; row < table.rowCount(); ++row) {
            bool has_all = true;
            for (const QString& words : wanted) {
                bool has = false;
                for (int column = 0; column < table.columnCount(); ++column)
                    has = has ||
                          (table.item(row, column) != nullptr && table.item(row, column)->text() == words);
                has_all = has_all && has;
            }
            if (has_all) return choose_row(table, row);
        }
        FAIL() << "no row with " << wanted.begin()->toStdString();
    }
    /// Performs A2 until it has ended, or until one sphere has been held.
    void work_at_a2(bool to_its_end) {
        const auto mind = make_pointing_mind(theatre().session()->scene());
        MouseHand hand(theatre(), *mind);
        const double share = to_its_end ? 0.45 : 0.05;
        ASSERT_TRUE(
            hand.work_until([&] { return theatre().session()->display().goal_progress > share; }, 240000));
        page.step("A2", "A2 by mouse: the lit sphere is touched and held");
        if (to_its_end) {
            ASSERT_TRUE(hand.work_until([] { return false; }, 600000));
        }
        page.say("mouse and key events of A2", std::to_string(hand.events()));
    }
    /// Uses the controls of the replay: an event, a step, slow playback, the slider, a penalty.
    void replay(DebriefPage& debrief) {
        auto* events = find<QListWidget>(window, "event_list");
        const auto choose_event = [&](int row) {
            bring(*events);
            QListWidgetItem* item = events->item(row);
            events->scrollToItem(item);
            QTest::mouseClick(events->viewport(), Qt::LeftButton, {}, events->visualItemRect(item).center());
            EXPECT_DOUBLE_EQ(debrief.moment(), item->data(Qt::UserRole).toDouble());
        };
        ASSERT_GT(events->count(), 0);
        choose_event(events->count() / 2);
        auto* slider = find<QSlider>(window, "replay_slider");
        QTest::keyClick(slider, Qt::Key_Home);
        double before = debrief.moment();
        EXPECT_EQ(before, 0);
        click(window, "replay_forward");
        EXPECT_NEAR(debrief.moment(), before + 0.02, 1e-9);
        click(window, "replay_back");
        EXPECT_NEAR(debrief.moment(), before, 1e-9);
        QTest::keyClick(find<QComboBox>(window, "replay_speed"), Qt::Key_Home);
        click(window, "replay_play");
        EXPECT_TRUE(wait_for([&] { return debrief.moment() > before + 0.03; }));
        click(window, "replay_play");
        before = debrief.moment();
        QTest::keyClick(slider, Qt::Key_PageUp);
        EXPECT_GT(debrief.moment(), before);
        auto* picture = debrief.findChild<TheatreView*>();
        EXPECT_TRUE(wait_for([&] { return picture->pictures() > 0; }, 120000));
        check(window, "penalties_only");
        const bool penalised = events->item(0)->data(Qt::UserRole).isValid();  // or one line: nothing
        if (!penalised) check(window, "penalties_only", false);
        choose_event(events->count() / 2);
        auto* panel = debrief.findChild<ReplayPanel*>();
        EXPECT_TRUE(wait_for([&] { return std::abs(panel->shown_time() - debrief.moment()) < 0.02; }, 120000))
            << panel->shown_time() << " shown, asked for " << debrief.moment();
    }
    /// No heading or cell of the table is cut off.
    void expect_whole(QTableWidget& table) {
        const auto expect_room = [&](int column, int height, const QString& words, int weight) {
            QFont font = table.font();
            font.setWeight(weight);
            const QRect room(0, 0, table.columnWidth(column) - 22, 1000);
            const QRect needed = QFontMetrics(font).boundingRect(room, Qt::TextWordWrap, words);
            EXPECT_LE(needed.width(), room.width()) << plain(words);
            EXPECT_LE(needed.height() + 10, height) << plain(words);
        };
        for (int column = 0; column < table.columnCount(); ++column) {
            expect_room(column, table.horizontalHeader()->height(),
                        table.horizontalHeaderItem(column)->text(), QFont::DemiBold);
            for (int row = 0; row < table.rowCount(); ++row)
                expect_room(column, table.rowHeight(row), table.item(row, column)->text(), QFont::Normal);
        }
    }
    void save_report(const char* button, const QString& path) {
        bring(*find<QWidget>(window, "export_path"));
        type(window, "export_path", path);
        click(window, button);
        ASSERT_TRUE(wait_for(
            [&] { return sees(window, "message_text") && shown("message_text").endsWith(path); }, 120000))
            << path.toStdString();
    }
    /// Compares every value of the debrief with the file that the trainee saved.
    void compare_figures(const std::vector<Cells>& file, const database::AttemptSummary& attempt) {
        std::size_t row = 2;
        while (row < file.size() && cell_of(file, row, "attempt_id") != attempt.meta.id) ++row;
        ASSERT_LT(row, file.size());
        EXPECT_EQ(cell_of(file, row, "points"), csv_number(attempt.points));
        choose_tab(window, "debrief_tabs", "All metrics");
        auto* table = find<QTableWidget>(window, "metrics_table");
        int values = 0;
        for (int line = 0; line < table->rowCount(); ++line) {
            std::string name = plain(table->item(line, 0)->toolTip().section('\n', -1).section(',', 0, 0));
            for (const int column : {1, 2}) {
                const std::string part = plain(table->item(line, column)->text());
                if (!part.empty()) name += "." + part;
            }
            const std::string value = cell_of(file, row, name), unit = cell_of(file, 1, name);
            const std::optional<double> number =
                value.empty() ? std::nullopt : std::optional<double>(std::stod(value));
            EXPECT_EQ(plain(table->item(line, 3)->text()),
                      plain(figure_with_unit(number, unit == "-" ? "" : unit)))
                << name;
            values += number ? 1 : 0;
        }
        EXPECT_GT(values, 20);
        page.say("values of the attempt that are the same in debrief and CSV", std::to_string(values));
    }

    JourneyPage page{window, "journey"};
};

TEST_F(Journey, FromTheFirstStartToTheDirectorsFiles) {
    const char* page_folder = std::getenv("FULCRUM_JOURNEY_PAGE");
    const bool whole = page_folder != nullptr;
    services.spoils_devices = true;
    expect_page("first_start_page");
    page.step("first-start", "First start");
    create_programme();
    const QString tara_once = add_person("Tara Trainee", "tara", "trainee");
    const QString ed_once = add_person("Ed Educator", "ed", "educator");
    const QString dora_once = add_person("Dora Director", "dora", "director");
    page.step("people", "The administrator adds people; each gets a one-time password");
    switch_user();
    first_sign_in("dora", dora_once, "dora's password");
    click(window, "rail_assign");
    type(window, "new_cohort_name", "Spring");
    click(window, "add_cohort");
    check_item(*find<QListWidget>(window, "cohort_members"), 0);
    check_item(*find<QListWidget>(window, "cohort_educators"), 0);
    click(window, "save_cohort");
    page.step("cohort-made", "The director makes a cohort");
    switch_user();

    first_sign_in("tara", tara_once, "tara's password");
    expect_page("home_page");
    page.step("home", "The trainee's home: the next thing to do");
    click(window, "briefing_A2");
    expect_page("briefing_page");
    page.step("briefing-A2", "The briefing of A2");
    home();
    start("A2", true);
    work_at_a2(whole);
    if (!whole) abandon();
    DebriefPage& debrief = wait_for_debrief();
    const database::AttemptSummary first = newest_attempt();
    EXPECT_EQ(first.state, whole ? AttemptState::completed : AttemptState::abandoned);
    EXPECT_TRUE(first.counting) << row_of(attempt_modes, first.meta.mode).name << ", "
                                << words_of(first.not_scored_because);
    const QString first_state = attempt_state(first.state), first_points = figure(first.points);
    const QString first_time = shown("headline_0");
    EXPECT_EQ(shown("debrief_about").contains(" · " + first_points + " of 100 points"),
              first.points.has_value());
    page.step("A2-debrief", "The debrief of A2");
    replay(debrief);
    bring(*find<QWidget>(window, "event_list"));
    page.step("A2-replay", "Replay of A2, at an event");
    expect_replays(first.meta.id);
    const QString by_trainee = folder.filePath("tara.csv");
    click(window, "rail_progress");
    wait_until_read(window);
    page.step("progress", "The trainee's progress");
    save_report("export_person", by_trainee);
    find_row(*find<QTableWidget>(window, "progress_table"), {first_state, first_time, first_points});
    auto* attempts = find<QTableWidget>(window, "progress_table");
    QTest::keyClick(attempts, Qt::Key_Return);
    wait_for_debrief();
    compare_figures(csv_rows(read_text(by_trainee)), first);

    home();
    click(window, "briefing_B1");
    expect_page("briefing_page");
    EXPECT_FALSE(find<QRadioButton>(window, "mode_assessed")->isEnabled())
        << "B1 is not assessed with mouse and keyboard";
    home();
    start("B1", false);
    move_hands(10);
    ASSERT_TRUE(wait_for([&] { return theatre().session()->display().elapsed_s > 1.5; }, 60000));
    page.step("B1-begun", "B1 at the start");
    abandon();
    const database::AttemptSummary abandoned = newest_attempt();
    EXPECT_EQ(abandoned.state, AttemptState::abandoned);
    EXPECT_TRUE(shown("advice").contains("abandoned")) << shown("advice").toStdString();
    page.step("B1-abandoned", "Debrief of an abandoned B1");
    replay(wait_for_debrief());
    expect_replays(abandoned.meta.id);
    home();
    start("A2", true);
    move_hands(10);
    ASSERT_TRUE(wait_for([&] { return theatre().session()->display().elapsed_s > 1.5; }, 60000));
    services.rig->spoil(SpoiltRig::Fault::silence);
    ASSERT_TRUE(wait_for([&] { return sees(window, "theatre_panel"); }));
    page.step("device-gone", "The device is lost: the force is zero, the timer is stopped");
    if (!whole) click(window, "panel_abandon");
    // Without action the attempt is closed after one minute.
    ASSERT_TRUE(wait_for([&] { return window.current_page()->objectName() == "debrief_page"; }, 240000));
    DebriefPage& of_lost = wait_for_debrief();
    const database::AttemptSummary lost = newest_attempt();
    EXPECT_EQ(lost.state, whole ? AttemptState::interrupted : AttemptState::abandoned);
    page.step("device-gone-debrief", "Debrief of the interrupted attempt");
    replay(of_lost);
    expect_replays(lost.meta.id);
    home();
    switch_user();

    // The educator comments on the first and voids the abandoned B1.
    first_sign_in("ed", ed_once, "eduard's word");
    expect_page("cohort_page");
    click(window, "rail_attempts");
    expect_page("attempts_page");
    attempts = find<QTableWidget>(window, "attempts_table");
    EXPECT_EQ(attempts->rowCount(), 3);
    find_row(*attempts, {"A2", first_state, first_points});
    page.step("educator", "The educator's list of the cohort's attempts");
    click(window, "open_attempt");
    DebriefPage& review = wait_for_debrief();
    replay(review);
    const double moment = review.moment();
    auto* comment = find<QPlainTextEdit>(window, "comment_text");
    bring(*comment);
    QTest::keyClicks(comment, "Slow down before you touch.");
    page.step("educator-comment", "The educator comments at a moment");
    click(window, "comment_send");
    click(window, "rail_attempts");
    find_row(*find<QTableWidget>(window, "attempts_table"), {"B1", "abandoned"});
    click(window, "open_attempt");
    wait_for_debrief();
    choose_tab(window, "debrief_tabs", "Corrections");
    bring(*find<QWidget>(window, "action_reason"));
    type(window, "action_reason", "started by mistake");
    click(window, "void_attempt");
    bring(*find<QWidget>(window, "void_attempt_sure"));
    click(window, "void_attempt_sure");
    ASSERT_TRUE(wait_for([&] { return sees(window, "verdict") && shown("verdict") == "Voided"; }, 60000));
    wait_for_debrief();
    page.step("educator-void", "The educator voids the abandoned attempt, with a reason");
    switch_user();

    sign_in("tara", "tara's password");
    expect_page("home_page");
    page.step("home-comment", "The trainee finds an unread comment");
    click(window, "unread_comment");
    EXPECT_NEAR(wait_for_debrief().moment(), moment, 1e-9);
    EXPECT_EQ(shown("comment_words"), "Slow down before you touch.");
    bring(*find<QWidget>(window, "comment_words"));
    page.step("comment-read", "The trainee reads the comment at its moment of the replay");
    home();
    EXPECT_FALSE(sees(window, "unread_comment"));
    click(window, "rail_attempts");
    find_row(*find<QTableWidget>(window, "attempts_table"), {"B1", "voided"});
    page.step("attempts-voided", "The voided attempt stays visible, struck through");
    click(window, "open_attempt");
    wait_for_debrief();
    EXPECT_TRUE(shown("debrief_notes").contains("started by mistake"));
    switch_user();

    // The director's files contain the values of the trainee's debrief.
    sign_in("dora", "dora's password");
    expect_page("dashboard_page");
    click(window, "rail_cohort");
    wait_until_read(window);
    expect_page("cohort_page");
    page.step("director-grid", "The director's cohort: where each person stands, with the latest attempts");
    find<QTabWidget>(window, "cohort_views")->setCurrentIndex(4);
    auto* table = find<QTableWidget>(window, "cohort_table");
    ASSERT_EQ(table->rowCount(), 1);
    int a2 = 1;
    while (!table->horizontalHeaderItem(a2)->text().startsWith("A2")) ++a2;
    const QString shown_cell = table->item(0, a2)->toolTip();  // the cell itself has signs
    EXPECT_EQ(shown_cell.contains("best " + first_points), first.points.has_value());
    for (const char* name : {"cohort.pdf", "cohort.csv", "cohort.json"})
        save_report("export_cohort", folder.filePath(name));
    QCoreApplication::processEvents();
    expect_whole(*table);
    page.step("director", "The director's cohort table, saved as PDF, CSV and JSON");
    const std::vector<Cells> csv = csv_rows(read_text(folder.filePath("cohort.csv")));
    const nlohmann::json json = nlohmann::json::parse(read_text(folder.filePath("cohort.json")));
    std::size_t row = 2;
    while (row < csv.size() && cell_of(csv, row, "task") != "A2") ++row;
    ASSERT_LT(row, csv.size());
    EXPECT_EQ(cell_of(csv, row, "best_points"), csv_number(first.points));
    EXPECT_TRUE(shown_cell.contains("attempts " + text(cell_of(csv, row, "attempts"))))
        << shown_cell.toStdString() << cell_of(csv, row, "attempts");
    bool found = false;
    for (const nlohmann::json& one : json["rows"]) {
        if (one["task"] != "A2") continue;
        found = true;
        EXPECT_EQ(std::to_string(one["attempts"].get<int>()), cell_of(csv, row, "attempts"));
        EXPECT_EQ(one["best_points"].is_number(), first.points.has_value());
        if (first.points) {
            EXPECT_DOUBLE_EQ(one["best_points"].get<double>(), *first.points);
        }
    }
    EXPECT_TRUE(found);
    const std::string pdf = pdf_text(folder.filePath("cohort.pdf"));
    EXPECT_NE(pdf.find("best " + plain(first_points)), std::string::npos) << pdf;
    EXPECT_NE(pdf.find("Spring"), std::string::npos);
    page.say("points of the first A2 in debrief, progress, list, table, PDF, CSV and JSON",
             plain(first_points));
    page.say("time of the first A2 in debrief and progress", plain(first_time));
    if (whole && !HasFailure())
        page.write(page_folder, "journey", "The main workflow, end to end", "Journey.*",
                   "One run of the program's window under Xvfb (software rendering) with its own services, "
                   "threads, world, recorder and store, driven by mouse and key events: programme, people, "
                   "attempts, debrief, replay, comment, void, and the files that the director saves.");
}

}  // namespace
}  // namespace fulcrum::app::program_test
