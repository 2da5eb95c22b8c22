// SPDX-License-Identifier: GPL-3.0-or-later
// The path of a newcomer, counted: from the page of sign-in to the first target of A2 that is touched, with
// each kind of device, by real input: keys and clicks, raw events of two mice, sticks, poses of a tracker and
// of devices with force. FULCRUM_NEWCOMER_PAGE=docs/results takes the path with each of them and writes the
// table; without it two mice do, and a joystick that is chosen on the way.
#include <gtest/gtest.h>

#include <QPushButton>

#include "sim_core/lab/result_page.h"
#include "tests/app/controller_hand.h"
#include "tests/app/held_devices.h"
#include "tests/app/held_hand.h"
#include "tests/app/input_watch.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/posed_hand.h"
#include "tests/app/two_mice_hand.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/built.h"
#include "tests/support/fake_trainer.h"
#include "ui/style/text.h"

namespace fulcrum::app::program_test {
namespace {

using fulcrum::test::Variable;
constexpr const char* newcomer_page_variable = "FULCRUM_NEWCOMER_PAGE";
constexpr const char* newcomer_password = "tara's password";
constexpr int newcomer_patience_ms = 120000;

class Newcomer : public Window {
  protected:
    void SetUp() override {
        if (!always() && !qEnvironmentVariableIsSet(newcomer_page_variable))
            GTEST_SKIP() << newcomer_page_variable << " is not set";
        create_programme_and_trainee();
        switch_user();
    }
    void TearDown() override {
        if (!chosen_.empty()) services.choose_device("mouse-keyboard");  // the settings outlive the window
    }
    /// Also where no page is wanted.
    virtual bool always() const { return false; }
    void fill_in(const char* field, const char* words) {
        auto* const edit = ui::window_test::find<QLineEdit>(window, field);
        ASSERT_NE(edit, nullptr);
        edit->clear();  // of the name that made the account
        QTest::mouseClick(edit, Qt::LeftButton);
        QTest::keyClicks(edit, QString::fromLatin1(words));
    }
    /// On the page *Settings*.
    void choose(const std::string& kind) {
        const std::string button = "use_" + kind;
        ui::window_test::click(window, "rail_settings");
        ASSERT_TRUE(ui::window_test::wait_for([&] { return ui::window_test::sees(window, button.c_str()); },
                                              newcomer_patience_ms));
        ui::window_test::bring(*ui::window_test::find<QPushButton>(window, button.c_str()));
        ui::window_test::click(window, button.c_str());
        EXPECT_EQ(services.device_in_use().kind, kind);
        ui::window_test::click(window, "rail_home");
        expect_page("home_page");
        chosen_ = kind;
    }
    /// Types name and password, chooses the device where it is one of those (`kind`), opens the briefing and
    /// begins; counts keys and clicks.
    void begin(const std::string& kind = "") {
        const InputWatch watch;
        ASSERT_NO_FATAL_FAILURE(fill_in("login", "tara"));
        ASSERT_NO_FATAL_FAILURE(fill_in("password", newcomer_password));
        QTest::keyClick(ui::window_test::find<QLineEdit>(window, "password"), Qt::Key_Return);
        expect_page("home_page");
        if (!kind.empty()) {
            ASSERT_NO_FATAL_FAILURE(choose(kind));
        }
        ui::window_test::click(window, "briefing_A2");
        expect_page("briefing_page");
        ui::window_test::check(window, "mode_practice");
        ui::window_test::click(window, "start_attempt");
        ASSERT_TRUE(ui::window_test::wait_for(
            [&] { return window.current_page()->objectName() == QLatin1String("theatre_page"); },
            newcomer_patience_ms))
            << shown("message_text").toStdString();
        ASSERT_TRUE(ui::window_test::wait_for(
            [&] { return theatre().session()->phase() == ui::AttemptPhase::running; }, newcomer_patience_ms));
        keys_ = watch.presses();
        // Name and password with a click into each field, Enter, the task, start; practice is a click where
        // it is not chosen already. A device: settings, the device, home.
        const auto letters =
            static_cast<int>(std::string("tara").size() + std::string(newcomer_password).size());
        EXPECT_GE(keys_, letters + 2 + 1 + 2 + (kind.empty() ? 0 : 3));
        EXPECT_LE(keys_, letters + 2 + 1 + 3 + (kind.empty() ? 0 : 3)) << "nothing else has to be pressed";
    }
    /// An instrument presses on the target that is lit.
    bool touched() {
        constexpr double felt = 0.02;  // N
        const TaskDisplay& display = theatre().session()->display();
        return display.hold_progress > 0 && std::max(display.force[0], display.force[1]) > felt;
    }
    /// `hand` works until the first target is touched; `unit` names what its events are.
    template <typename Work>
    void touch_first(const char* device, const char* unit, Work&& hand) {
        const auto mind = make_pointing_mind(theatre().session()->scene(), 1e-3);
        auto worker = hand(*mind);
        const double begun = theatre().session()->display().elapsed_s;
        ASSERT_TRUE(worker.work_until([&] { return touched(); }, newcomer_patience_ms)) << device;
        const std::uint32_t ticks = theatre().session()->health().ticks;
        EXPECT_GT(worker.events(), 3) << device;
        EXPECT_GE(theatre().session()->display().elapsed_s, begun);
        std::cout << device << ": " << worker.events() << " " << unit << ", " << 1e-3 * ticks << " s\n";
        rows().push_back({device, chosen_words(), std::to_string(keys_), std::to_string(worker.events()),
                          unit, decimal_words(1e-3 * ticks)});
        EXPECT_LT(1e-3 * ticks, 60) << device;
        abandon();
        const database::AttemptSummary attempt = newest_attempt();
        EXPECT_EQ(attempt.state, AttemptState::abandoned);
        EXPECT_TRUE(felt_a_target(attempt.meta.id)) << device;
        write();
    }
    /// By the record: a tip pressed on something.
    bool felt_a_target(const std::string& attempt) {
        const database::Trace trace =
            database::Attempts(*services.store()).read_trace(window.context().session(), attempt);
        return std::any_of(trace.samples.begin(), trace.samples.end(), [](const TickSample& sample) {
            return std::any_of(std::begin(sample.hand), std::end(sample.hand), [](const HandSample& hand) {
                return hand.force[0] != 0 || hand.force[1] != 0 || hand.force[2] != 0;
            });
        });
    }
    std::string chosen_words() const {
        if (!chosen_.empty()) return "on the page Settings";
        return qEnvironmentVariableIsSet("FULCRUM_DEVICE") ? "FULCRUM_DEVICE, by the station"
                                                           : "no choice needed";
    }
    static std::string decimal_words(double seconds) { return ui::plain(ui::decimal(seconds, 1)); }
    static std::vector<std::vector<std::string>>& rows() {
        static std::vector<std::vector<std::string>> all;
        return all;
    }
    static void write() {
        const char* const folder = std::getenv(newcomer_page_variable);
        if (folder == nullptr) return;
        lab::ResultPage page("newcomer", "From sign-in to the first target",
                             std::string(newcomer_page_variable) +
                                 "=docs/results xvfb-run -a -s '-screen 0 1280x800x24 -noreset' test_app "
                                 "--gtest_filter=Newcomer*");
        page.paragraph(
            "The path of a trainee whose account exists, in the program's window: name and password, the "
            "task "
            "A2, practice, start, then the device until the first sphere that is lit has been touched. Keys "
            "and "
            "clicks are counted as events that the window gets; a device that the page Settings offers is "
            "chosen there on the way, the others are named by whoever sets up the station. The hands know "
            "where "
            "to go and approach like the demonstration; a person takes longer. Seconds are those of the "
            "attempt's clock from its first tick. A pose is a reading of the device that differs from the "
            "one "
            "before: a hand that moves makes them by itself.");
        lab::ResultTable table;
        table.columns = {"device",
                         "device chosen",
                         "keys and clicks before the theatre",
                         "input in the theatre",
                         "of which kind",
                         "time in the theatre, s"};
        table.rows = rows();
        page.table(table);
        page.write(folder, lab::this_machine(lab::build_info()));
    }
    int keys_ = 0;
    std::string chosen_;  ///< kind of device
};

TEST_F(Newcomer, TouchesTheFirstTargetWithMouseAndKeyboard) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first("mouse and keyboard", "mouse and key events",
                [this](ObservingRig& mind) { return MouseHand(theatre(), mind); });
}

struct NewcomersMice {
    Variable device{"FULCRUM_DEVICE", "two-mice:virtual"};
    VirtualMice mice;
};
class NewcomerWithMice : public NewcomersMice, public Newcomer {
  protected:
    bool always() const override { return true; }
};
TEST_F(NewcomerWithMice, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first("two mice", "mouse events",
                [this](ObservingRig& mind) { return TwoMiceHand(theatre(), mind, mice); });
}

struct NewcomersPad {
    NewcomersPad() { page->controller[0].plugged = 1; }
    fulcrum::test::FakePage<fulcrum::test::FakeSdlPage> page{"FAKE_SDL_PAGE"};
    Variable library{"FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so")};
    FakePad pad{page->controller[0]};
};
class NewcomerWithController : public NewcomersPad, public Newcomer {};
TEST_F(NewcomerWithController, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin("controller"));
    touch_first("game controller", "changes of sticks and buttons",
                [this](ObservingRig& mind) { return ControllerHand(theatre(), mind, pad); });
}

/// Both hands by devices of fulcrum-hapticd whose poses a test sets.
struct WithHeld : ::testing::WithParamInterface<std::string> {
    static bool is_chosen() { return GetParam() == "Joystick"; }
    std::unique_ptr<HeldDevice> held = make_held(GetParam(), !is_chosen());
};
class NewcomerWithDevice : public WithHeld, public Newcomer {
  protected:
    bool always() const override { return is_chosen(); }
};
TEST_P(NewcomerWithDevice, TouchesTheFirstTarget) {
    if (GetParam() == "Trainer" && !fulcrum::test::FakeTrainer::is_possible())
        GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    ASSERT_NO_FATAL_FAILURE(begin(is_chosen() ? "joystick" : ""));
    touch_first(held->title, "poses", [this](ObservingRig& mind) {
        return PosedHand(
            theatre(), mind, [this](int hand, const Vector3& position) { held->put(hand, position); },
            held->begin());
    });
    EXPECT_EQ(held->commanded(), 0) << "after the attempt";
}
INSTANTIATE_TEST_SUITE_P(Newcomer, NewcomerWithDevice,
                         ::testing::Values("Touch", "Haply", "ForceDimension", "Tracker", "Trainer",
                                           "Joystick"),
                         [](const auto& of) { return of.param; });

/// A2 asks for the left hand first.
struct NewcomersCap {
    std::unique_ptr<HeldDevice> cap = make_held("SpaceMouse");
};
class NewcomerWithSpaceMouse : public NewcomersCap, public Newcomer {};
TEST_F(NewcomerWithSpaceMouse, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first(cap->title, "deflections of the cap",
                [this](ObservingRig& mind) { return HeldHand(theatre(), mind, *cap); });
}

}  // namespace
}  // namespace fulcrum::app::program_test
