// SPDX-License-Identifier: GPL-3.0-or-later
// The cutting tasks through the window, by mouse and keys. By default the test uses pedal and instrument
// exchange in B3 and abandons it. With FULCRUM_JOURNEY_PAGE=docs/results a synthetic expert performs B2, B3
// and C4 by mouse and key events, from briefing to debrief, replay and reports, and the test writes their
// page. FULCRUM_PICTURES=FOLDER stores the screens.
#include <QComboBox>
#include <QProcess>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "assessment/task/attempt_words.h"
#include "tests/app/journey_page.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/window_fixture.h"
#include "ui/reports/report.h"
#include "ui/style/text.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

class CuttingJourney : public Window {
  protected:
    void brief(const char* task) {
        home();
        click(window, qPrintable(QStringLiteral("briefing_") + QLatin1String(task)));
        expect_page("briefing_page");
        home();
    }
    const WorldSnapshot& world() { return theatre().session()->snapshot(); }
    const TaskDisplay& display() { return theatre().session()->display(); }
    bool in_theatre() {
        return window.current_page()->objectName() == QLatin1String("theatre_page") &&
               theatre().session() != nullptr && theatre().session()->phase() == AttemptPhase::running;
    }
    static int count(const std::vector<Event>& events, EventKind kind) {
        return static_cast<int>(std::count_if(events.begin(), events.end(),
                                              [kind](const Event& event) { return event.kind == kind; }));
    }

    struct Moment {
        std::string what;
        std::function<bool()> reached;
        bool pictured = false;
    };
    /// Performs the task by mouse until all moments are reached or the time is up, then abandons it if
    /// necessary.
    std::vector<Event> perform(const char* task, int milliseconds, const std::vector<Moment>& moments) {
        brief(task);
        start(task, false);
        const auto mind = make_operator(OperatorLevel::expert, theatre().session()->task(),
                                        theatre().session()->scene(), 7);
        MouseHand hand(theatre(), *mind);
        QElapsedTimer timer;
        timer.start();
        const auto left = [&] { return milliseconds - static_cast<int>(timer.elapsed()); };
        for (const Moment& moment : moments) {
            if (left() <= 0 || !hand.work_until(moment.reached, left()) || !in_theatre()) break;
            if (moment.pictured) page.step(std::string(task) + "-work", moment.what);
        }
        if (left() > 0 && in_theatre()) hand.work_until([] { return false; }, left());
        const bool over = !in_theatre();
        if (over) {
            wait_for_debrief();
        } else {
            abandon();
        }
        const database::AttemptSummary attempt = newest_attempt();
        std::vector<Event> events = database::Attempts(*services.store())
                                        .read_trace(window.context().session(), attempt.meta.id)
                                        .events;
        page.say(std::string(task) + ": mouse and key events", std::to_string(hand.events()));
        page.say(std::string(task) + ": how it ended, time",
                 std::string(row_of(attempt_states, attempt.state).name) + ", " +
                     plain(clock_text(attempt.duration_s)));
        page.say(std::string(task) + ": advances of a cut",
                 std::to_string(count(events, EventKind::cut_advance)));
        page.say(std::string(task) + ": activations of energy",
                 std::to_string(count(events, EventKind::activation_begin)));
        page.say(std::string(task) + ": instruments exchanged",
                 std::to_string(count(events, EventKind::tool_exchanged)));
        look_back(task, attempt.meta.id);
        return events;
    }
    /// Opens the debrief, its replay at an event, and the reports.
    void look_back(const char* task, const std::string& id) {
        DebriefPage& debrief = wait_for_debrief();
        page.step(std::string(task) + "-debrief", std::string("The debrief of ") + task);
        auto* events = find<QListWidget>(window, "event_list");
        bring(*events);
        if (events->count() > 0) {
            QListWidgetItem* item = events->item(events->count() / 2);
            events->scrollToItem(item);
            QTest::mouseClick(events->viewport(), Qt::LeftButton, {}, events->visualItemRect(item).center());
        }
        auto* picture = debrief.findChild<TheatreView*>();
        EXPECT_TRUE(wait_for([&] { return picture->pictures() > 0; }, 120000));
        expect_replays(id);
        for (const auto& [format, ending] :
             {std::pair(ReportFormat::pdf, ".pdf"), std::pair(ReportFormat::csv, ".csv")}) {
            ReportRequest request;
            request.attempt_id = id;
            request.format = format;
            request.path = folder.filePath(text(std::string(task) + ending)).toStdString();
            write_report(*services.store(), window.context().session(), request, services.tasks(), "journey");
            EXPECT_GT(QFileInfo(text(request.path)).size(), 500) << request.path;
        }
        pages_of(folder.filePath(text(std::string(task) + ".pdf")), std::string("The report of ") + task);
    }
    /// Adds the pages of a PDF as pictures.
    void pages_of(const QString& pdf, const std::string& what) {
        const QString pictures = qEnvironmentVariable("FULCRUM_PICTURES");
        if (pictures.isEmpty()) return;
        const QString name = page.next_name(QFileInfo(pdf).baseName().toStdString() + "-report");
        QProcess process;
        process.start(QStringLiteral("pdftoppm"),
                      {QStringLiteral("-png"), QStringLiteral("-r"), QStringLiteral("60"),
                       QStringLiteral("-singlefile"), pdf, pictures + '/' + name});
        EXPECT_TRUE(process.waitForFinished(60000)) << "pdftoppm (poppler-utils) is needed";
        page.list(name, what);
    }

    /// Performs B2, B3 and C4; takes minutes.
    void divide_tissue() {
        const std::vector<Event> plane = perform(
            "B2", 150000,
            {{"B2: the flap is held taut", [&] { return display().goal >= 1; }},
             {"B2: the sheet is divided along its line", [&] { return display().cut_divided_m > 0.01; },
              true},
             {"B2: a third of the line is divided", [&] { return display().cut_divided_m > 0.033; }}});
        EXPECT_GT(count(plane, EventKind::cut_advance), 0);
        const auto tool = [&]() -> const HandToolView& { return world().field[0].tools[1]; };
        const std::vector<Event> bands =
            perform("B3", 150000,
                    {{"B3: a band is held, the shears are on", [&] { return tool().active; }},
                     {"B3: an instrument is exchanged", [&] { return tool().exchange_left > 0; }, true},
                     {"B3: three bands divided", [&] { return display().bands_divided >= 3; }}});
        EXPECT_GT(count(bands, EventKind::activation_begin), 0);
        const std::vector<Event> posterior =
            perform("C4", 180000,
                    {{"C4: the rectum is held up", [&] { return display().goal >= 1; }},
                     {"C4: the plane is opened", [&] { return display().cut_divided_m > 0.005; }, true},
                     {"C4: further down", [&] { return display().cut_divided_m > 0.03; }}});
        EXPECT_GT(count(posterior, EventKind::cut_advance), 0);
        click(window, "rail_progress");
        choose_progress_of("C4");
        page.step("progress", "The trainee's progress, at C4");
    }
    /// Selects a task in the list by keys; the table then shows its attempts.
    void choose_progress_of(const char* task) {
        auto* tasks = find<QComboBox>(window, "progress_task");
        const int wanted = tasks->findData(QString::fromLatin1(task));
        ASSERT_GE(wanted, 0) << task;
        QTest::keyClick(tasks, Qt::Key_Home);
        for (int i = 0; i < wanted; ++i) QTest::keyClick(tasks, Qt::Key_Down);
        EXPECT_EQ(tasks->currentIndex(), wanted);
        wait_until_read(window);
        EXPECT_GT(find<QTableWidget>(window, "progress_table")->rowCount(), 0) << task;
    }

    JourneyPage page{window, "cutting"};
};

TEST_F(CuttingJourney, KeysOperatePedalAndExchange) {
    constexpr int patience = 120000;  // ms; long enough for a slow machine
    create_programme_and_trainee();
    start("B3", false);
    ASSERT_FALSE(world().field.empty());
    const auto tool = [&]() -> const HandToolView& { return world().field[0].tools[1]; };
    ASSERT_EQ(theatre().input()->active_hand(), Hand::right);
    EXPECT_EQ(tool().kind, InstrumentKind::harmonic);
    QTest::keyPress(theatre().view(), Qt::Key_B);
    EXPECT_TRUE(wait_for([&] { return tool().active; }, patience)) << "the pedal";
    QTest::keyRelease(theatre().view(), Qt::Key_B);
    EXPECT_TRUE(wait_for([&] { return !tool().active; }, patience));
    QTest::keyPress(theatre().view(), Qt::Key_T);
    EXPECT_TRUE(wait_for([&] { return tool().kind == InstrumentKind::clip_applier; }, patience))
        << "the next instrument";
    QTest::keyRelease(theatre().view(), Qt::Key_T);
    abandon();
    click(window, "rail_progress");
    choose_progress_of("B3");
    if (const char* page_folder = std::getenv("FULCRUM_JOURNEY_PAGE")) {
        divide_tissue();
        if (!HasFailure())
            page.write(page_folder, "journey_cutting", "Cutting tasks in the window", "CuttingJourney.*",
                       "The program's window under Xvfb (software rendering) with its own services, threads, "
                       "world, recorder and store. Mouse moves, wheel turns, clicks and keys drive the "
                       "instruments; a synthetic expert decides where they go. Each task is performed in "
                       "practice mode for at most three minutes and then abandoned if it is not finished. "
                       "Each record is replayed bit for bit.");
    }
}

}  // namespace
}  // namespace fulcrum::app::program_test
