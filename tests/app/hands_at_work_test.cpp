// SPDX-License-Identifier: GPL-3.0-or-later
// A1 and A3 (by mouse only), B1, B2 and C4 completed through the window by mouse and keyboard, after the
// first steps, by two mice of the X server and by a virtual game controller of SDL 2: minutes, because the
// window's clock is real. FULCRUM_HANDS_PAGE=docs/results does it and writes the page; the small forms are in
// newcomer_test.cpp and controller_window_test.cpp.
#include <gtest/gtest.h>

#include <type_traits>

#include "sim_core/lab/result_page.h"
#include "tests/app/controller_hand.h"
#include "tests/app/input_watch.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/two_mice_hand.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_page.h"
#include "ui/style/text.h"

namespace fulcrum::app::program_test {
namespace {

constexpr int longest_ms = 900000;
constexpr const char *work_page_variable = "FULCRUM_HANDS_PAGE", *task_variable = "FULCRUM_HANDS_TASKS";

/// Of all devices that were used in this process.
std::vector<std::vector<std::string>>& rows_of_page() {
    static std::vector<std::vector<std::string>> rows;
    return rows;
}

void write_page() {
    lab::ResultPage page("hands",
                         "Tasks completed by mouse and keyboard, by two mice and by a game controller",
                         std::string(work_page_variable) +
                             "=docs/results xvfb-run -a -s '-screen 0 1280x800x24 -noreset' test_app "
                             "--gtest_filter=HandsAtWork*");
    page.paragraph(
        "The program's window under Xvfb (software rendering) with its own services, threads, world, "
        "recorder "
        "and store. A synthetic expert decides where the instruments go; events of one mouse and the "
        "keyboard, "
        "raw events of two pointers of the X server (XInput 2), or sticks, triggers and buttons of a virtual "
        "controller of SDL 2, bring them there. With mouse and keyboard the trainee does the first steps of "
        "the "
        "theatre before, in C4, until each line is marked. Each attempt is made in practice mode, and each "
        "record is replayed bit for bit. Held are keys (with Shift) and mouse buttons by the events that the "
        "window gets; of two mice and of the controller their buttons, and triggers from a tenth on.");
    lab::ResultTable table;
    table.columns = {"device",
                     "task",
                     "how it ended",
                     "time",
                     "points of 100",
                     "input events",
                     "most held at the same time",
                     "time with more than two held"};
    table.rows = rows_of_page();
    page.table(table);
    page.write(std::getenv(work_page_variable), lab::this_machine(lab::build_info()));
}

class AtWork : public Window {
  protected:
    /// Most that were held at the same time, and the share of the time with more than two.
    static std::vector<std::string> held_words(InputWatch& watch) {
        return {std::to_string(watch.most_held()),
                ui::plain(ui::decimal(100 * watch.share_above(2), 1)) + " %"};
    }
    static void add_row(std::vector<std::string> row, const std::vector<std::string>& held) {
        row.insert(row.end(), held.begin(), held.end());
        for (const std::string& cell : row) std::cout << cell << "  ";
        std::cout << std::endl;
        rows_of_page().push_back(std::move(row));
    }
    /// Completes the tasks with the driver that `make` returns for an attempt.
    template <typename Make>
    void complete_all(const char* device, Make&& make, const char* usual = "B1,B2,C4") {
        const bool one_mouse = std::string(device) == "mouse";
        InputWatch watch(std::string(device) == "two-mice" ? InputWatch::MouseButtons::of_hold
                                                           : InputWatch::MouseButtons::of_events);
        const QStringList tasks =
            qEnvironmentVariable(task_variable, QLatin1String(usual)).split(QLatin1Char(','));
        for (const QString& name : tasks) {
            const QByteArray task = name.toLatin1();
            start(task.constData(), false);
            const auto mind = make_operator(OperatorLevel::expert, theatre().session()->task(),
                                            theatre().session()->scene(), 7);
            auto hand = make(theatre(), *mind);
            if constexpr (std::is_base_of_v<WorkingHand, decltype(hand)>)
                hand.on_hold = [&watch](int number, bool held) { watch.hold(number, held); };
            watch.restart();
            EXPECT_TRUE(hand.work_until([] { return false; }, longest_ms)) << task.constData();
            const std::vector<std::string> held = held_words(watch);
            EXPECT_TRUE(!one_mouse || watch.share_above(2) < 0.1) << "more than two keys and buttons";
            const bool ended = theatre_ended();
            if (ended)
                wait_for_debrief();
            else
                abandon();
            ui::window_test::keep_picture(window,
                                          QStringLiteral("hands-%1-%2").arg(QLatin1String(device), name));
            const database::AttemptSummary attempt = newest_attempt();
            EXPECT_EQ(attempt.state, AttemptState::completed) << task.constData();
            expect_replays(attempt.meta.id);
            add_row({attempt.meta.device, task.toStdString(), row_of(attempt_states, attempt.state).name,
                     ui::plain(ui::clock_text(attempt.duration_s)), ui::plain(ui::figure(attempt.points)),
                     std::to_string(hand.events())},
                    held);
            home();
        }
        write_page();
    }
    bool theatre_ended() { return window.current_page()->objectName() != QLatin1String("theatre_page"); }
};

/// A trainee who has never used the window: the first steps by mouse and keys, then the tasks.
class HandsAtWorkMouse : public AtWork {
  protected:
    QString strip() {
        return ui::window_test::find<QFrame>(window, "theatre_keys")->findChild<QLabel*>()->text();
    }
    bool learns() { return ui::window_test::sees(window, "theatre_keys") && strip().contains("Enter"); }
    void move(const QPoint& by, Qt::KeyboardModifiers with = Qt::NoModifier) {
        events_ += slide_mouse(*theatre().view(), by, with);
    }
    void key(Qt::Key key, int milliseconds) {
        QTest::keyPress(theatre().view(), key);
        QTest::qWait(milliseconds);
        QTest::keyRelease(theatre().view(), key);
        ++events_;
    }
    void button(Qt::MouseButton button, int milliseconds) {
        ui::TheatreView* const view = theatre().view();
        QTest::mousePress(view, button, {}, view->rect().center());
        QTest::qWait(milliseconds);
        QTest::mouseRelease(view, button, {}, view->rect().center());
        ++events_;
    }
    /// What each line says, until all are marked.
    void do_first_steps() {
        start("C4", false);
        QTest::mouseMove(theatre().view(), theatre().view()->rect().center());
        ASSERT_TRUE(ui::window_test::wait_for([this] { return learns(); }, 30000));
        const double begun = theatre().session()->display().elapsed_s;
        InputWatch watch;
        for (int again = 0; again < 3 && learns(); ++again) {
            for (int hand = 0; hand < hand_count; ++hand) {
                move({60, 20});
                move({-60, -20});
                button(Qt::RightButton, 50);
            }
            turn_wheel(*theatre().view(), -240);
            QTest::qWait(300);
            turn_wheel(*theatre().view(), 240);
            events_ += 2;
            move({160, 0}, Qt::ShiftModifier);
            move({-160, 0}, Qt::ShiftModifier);
            button(Qt::LeftButton, 500);
            key(Qt::Key_B, 200);
            key(Qt::Key_T, 200);
            key(Qt::Key_Left, 600);
            key(Qt::Key_Right, 600);
            ui::window_test::wait_for([this] { return !learns(); }, 2000);
        }
        EXPECT_FALSE(learns()) << strip().toStdString();
        const double took = theatre().session()->display().elapsed_s - begun;
        const std::vector<std::string> held = held_words(watch);
        abandon();
        add_row({newest_attempt().meta.device, "first steps, in C4", "each line marked",
                 ui::plain(ui::clock_text(took)), "", std::to_string(events_)},
                held);
    }
    int events_ = 0;
};

TEST_F(HandsAtWorkMouse, CompletesTheTasksAfterTheFirstSteps) {
    if (!qEnvironmentVariableIsSet(work_page_variable)) GTEST_SKIP() << work_page_variable << " is not set";
    create_programme_and_trainee();
    ASSERT_NO_FATAL_FAILURE(do_first_steps());
    home();
    complete_all(
        "mouse", [](ui::TheatrePage& page, ObservingRig& mind) { return MouseHand(page, mind); },
        "A1,A3,B1,B2,C4");
}

struct WorksWithMice {
    fulcrum::test::Variable device{"FULCRUM_DEVICE", "two-mice:virtual"};
    VirtualMice mice;
};
class HandsAtWorkMice : public WorksWithMice, public AtWork {};

TEST_F(HandsAtWorkMice, CompleteTheTasks) {
    if (!qEnvironmentVariableIsSet(work_page_variable)) GTEST_SKIP() << work_page_variable << " is not set";
    create_programme_and_trainee();
    complete_all("two-mice",
                 [this](ui::TheatrePage& page, ObservingRig& mind) { return TwoMiceHand(page, mind, mice); });
}

struct WorksWithPad {
    std::unique_ptr<VirtualPad> pad = qEnvironmentVariableIsSet(work_page_variable)
                                          ? make_pad_of_sdl("Virtual controller of SDL 2")
                                          : nullptr;
    fulcrum::test::Variable device{"FULCRUM_DEVICE", "controller:Virtual controller of SDL 2"};
};
class HandsAtWorkController : public WorksWithPad, public AtWork {};

TEST_F(HandsAtWorkController, CompletesTheTasks) {
    if (!qEnvironmentVariableIsSet(work_page_variable)) GTEST_SKIP() << work_page_variable << " is not set";
    ASSERT_NE(pad, nullptr) << "this SDL 2 has no virtual controllers";
    create_programme_and_trainee();
    complete_all("controller", [this](ui::TheatrePage& page, ObservingRig& mind) {
        return ControllerHand(page, mind, *pad);
    });
}

}  // namespace
}  // namespace fulcrum::app::program_test
