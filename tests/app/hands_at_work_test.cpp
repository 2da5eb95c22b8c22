// SPDX-License-Identifier: GPL-3.0-or-later
// B1, B2 and C4 completed through the window by two mice of the X server and by a virtual game controller of
// SDL 2: minutes, because the window's clock is real. FULCRUM_HANDS_PAGE=docs/results does it and writes the
// page; the small forms are in newcomer_test.cpp and controller_window_test.cpp.
#include <gtest/gtest.h>

#include "sim_core/lab/result_page.h"
#include "tests/app/controller_hand.h"
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
    lab::ResultPage page("hands", "Tasks completed by two mice and by a game controller",
                         std::string(work_page_variable) +
                             "=docs/results xvfb-run -a -s '-screen 0 1280x800x24 -noreset' test_app "
                             "--gtest_filter=HandsAtWork*");
    page.paragraph(
        "The program's window under Xvfb (software rendering) with its own services, threads, world, "
        "recorder "
        "and store. A synthetic expert decides where the instruments go; raw events of two pointers of the X "
        "server (XInput 2), or sticks, triggers and buttons of a virtual controller of SDL 2, bring them "
        "there. "
        "Each attempt is made in practice mode, and each record is replayed bit for bit.");
    lab::ResultTable table;
    table.columns = {"device", "task", "how it ended", "time", "points of 100", "input events"};
    table.rows = rows_of_page();
    page.table(table);
    page.write(std::getenv(work_page_variable), lab::this_machine(lab::build_info()));
}

class AtWork : public Window {
  protected:
    /// Completes the tasks with the driver that `make` returns for an attempt.
    template <typename Make>
    void complete_all(const char* device, Make&& make) {
        const QStringList tasks = qEnvironmentVariable(task_variable, "B1,B2,C4").split(QLatin1Char(','));
        create_programme_and_trainee();
        for (const QString& name : tasks) {
            const QByteArray task = name.toLatin1();
            start(task.constData(), false);
            const auto mind = make_operator(OperatorLevel::expert, theatre().session()->task(),
                                            theatre().session()->scene(), 7);
            auto hand = make(theatre(), *mind);
            EXPECT_TRUE(hand.work_until([] { return false; }, longest_ms)) << task.constData();
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
            rows_of_page().push_back({attempt.meta.device, task.toStdString(),
                                      row_of(attempt_states, attempt.state).name,
                                      ui::plain(ui::clock_text(attempt.duration_s)),
                                      ui::plain(ui::figure(attempt.points)), std::to_string(hand.events())});
            for (const std::string& cell : rows_of_page().back()) std::cout << cell << "  ";
            std::cout << std::endl;
            home();
        }
        write_page();
    }
    bool theatre_ended() { return window.current_page()->objectName() != QLatin1String("theatre_page"); }
};

struct WorksWithMice {
    fulcrum::test::Variable device{"FULCRUM_DEVICE", "two-mice:virtual"};
    VirtualMice mice;
};
class HandsAtWorkMice : public WorksWithMice, public AtWork {};

TEST_F(HandsAtWorkMice, CompleteTheTasks) {
    if (!qEnvironmentVariableIsSet(work_page_variable)) GTEST_SKIP() << work_page_variable << " is not set";
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
    ASSERT_NE(pad, nullptr) << "needs SDL 2 with virtual controllers, and libsdl2-dev when it is compiled";
    complete_all("controller", [this](ui::TheatrePage& page, ObservingRig& mind) {
        return ControllerHand(page, mind, *pad);
    });
}

}  // namespace
}  // namespace fulcrum::app::program_test
