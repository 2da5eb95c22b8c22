// SPDX-License-Identifier: GPL-3.0-or-later
// The first steps and then B1 and C4 (and others: see usual_tasks) completed through the window with each
// kind of device: minutes for each, because the window's clock is real. FULCRUM_HANDS_PAGE=docs/results does
// it and writes the page, FULCRUM_HANDS_DEVICES and FULCRUM_HANDS_TASKS choose parts of it; the small forms
// are in newcomer_test.cpp, first_steps_window_test.cpp and controller_window_test.cpp.
#include <gtest/gtest.h>

#include <QSettings>

#include "tests/app/hands_page.h"
#include "tests/app/taught_devices.h"
#include "tests/support/fake_trainer.h"
#include "ui/style/text.h"

namespace fulcrum::app::program_test {
namespace {

constexpr int longest_ms = 900000;
constexpr const char *task_variable = "FULCRUM_HANDS_TASKS", *device_variable = "FULCRUM_HANDS_DEVICES";

/// Words of a list in a variable; none: `usual`.
QStringList chosen_words(const char* variable, const QString& usual) {
    return qEnvironmentVariable(variable, usual).split(QLatin1Char(','));
}

QString usual_tasks(const std::string& kind) {
    if (kind == "Mouse") return QStringLiteral("A1,A3,B1,B2,C4");
    if (kind == "TwoMice" || kind == "ControllerOfSdl") return QStringLiteral("B1,B2,C4");
    return QStringLiteral("B1,C4");
}

bool is_measured(const std::string& kind) {
    const QString name = QString::fromStdString(kind);
    return hands_folder() != nullptr && chosen_words(device_variable, name).contains(name);
}

class TasksWith : public ::testing::WithParamInterface<std::string>, public TaughtWindow {
  protected:
    TasksWith() : TaughtWindow(is_measured(GetParam()) ? make_taught(GetParam()) : nullptr) {}
    void SetUp() override {
        if (!is_measured(GetParam()))
            GTEST_SKIP() << "FULCRUM_HANDS_PAGE is not set, or another device is chosen";
        if (GetParam() == "Trainer" && !fulcrum::test::FakeTrainer::is_possible())
            GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
        ASSERT_NE(taught, nullptr) << "this SDL 2 has no virtual controllers";
        QSettings().clear();
    }
    void learn() {
        start("C4", false);
        const double begun = theatre().session()->display().elapsed_s;
        InputWatch watch(taught->buttons);
        ASSERT_NO_FATAL_FAILURE(do_first_steps());
        const double took = theatre().session()->display().elapsed_s - begun;
        const bool marked = !HasFailure();
        // What is held on a device that the window does not read is not reported here.
        const std::vector<std::string> held =
            GetParam() == "Mouse" ? held_words(watch) : std::vector<std::string>(2);
        abandon();
        const std::string all =
            marked ? "each of " + std::to_string(lines_done_) + " lines marked" : "not completed";
        enter(first_steps_task, {taught->title, "first steps, in C4", all, clock(took), "", ""}, held);
    }
    void complete(const QString& name) {
        const QByteArray task = name.toLatin1();
        start(task.constData(), false);
        const auto mind = make_operator(OperatorLevel::expert, theatre().session()->task(),
                                        theatre().session()->scene(), 7);
        const std::unique_ptr<Worker> hand = taught->worker(theatre(), *mind);
        InputWatch watch(taught->buttons);
        hand->on_hold = [&watch](int number, bool held) { watch.hold(number, held); };
        EXPECT_TRUE(hand->work_until([] { return false; }, longest_ms)) << task.constData();
        const std::vector<std::string> held = held_words(watch);
        EXPECT_TRUE(GetParam() != "Mouse" || watch.share_above(2) < 0.1) << "more than two keys and buttons";
        if (theatre_ended())
            wait_for_debrief();
        else
            abandon();
        ui::window_test::keep_picture(
            window, QStringLiteral("hands-%1-%2").arg(QString::fromStdString(GetParam()), name));
        const database::AttemptSummary attempt = newest_attempt();
        EXPECT_NE(attempt.meta.device.find(taught->model), std::string::npos) << attempt.meta.device;
        EXPECT_EQ(attempt.state, AttemptState::completed) << task.constData();
        expect_replays(attempt.meta.id);
        enter(task.toStdString(),
              {taught->title, task.toStdString(),
               row_of(attempt_states, attempt.state).name + losses_words(hand->losses()),
               clock(attempt.duration_s), ui::plain(ui::figure(attempt.points)),
               std::to_string(hand->events())},
              held);
    }

  private:
    static std::string clock(double seconds) { return ui::plain(ui::clock_text(seconds)); }
    static std::string losses_words(int losses) {
        return losses == 0 ? "" : ", the device lost and back: " + std::to_string(losses);
    }
    bool theatre_ended() { return window.current_page()->objectName() != QLatin1String("theatre_page"); }
    /// Most that were held at the same time, and the share of the time with more than two.
    static std::vector<std::string> held_words(InputWatch& watch) {
        return {std::to_string(watch.most_held()),
                ui::plain(ui::decimal(100 * watch.share_above(2), 1)) + " %"};
    }
    static void enter(const std::string& task, std::vector<std::string> cells,
                      const std::vector<std::string>& held) {
        cells.insert(cells.end(), held.begin(), held.end());
        for (const std::string& cell : cells) std::cout << cell << "  ";
        std::cout << std::endl;
        enter_hands({GetParam(), task, std::move(cells)});
    }
};

TEST_P(TasksWith, AreCompletedAfterTheFirstSteps) {
    create_programme_and_trainee();
    ASSERT_NO_FATAL_FAILURE(learn());
    home();
    for (const QString& task : chosen_words(task_variable, usual_tasks(GetParam()))) {
        complete(task);
        home();
    }
}

INSTANTIATE_TEST_SUITE_P(HandsAtWork, TasksWith, ::testing::ValuesIn(hands_kinds()),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace fulcrum::app::program_test
