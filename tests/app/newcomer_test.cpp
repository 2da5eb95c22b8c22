// SPDX-License-Identifier: GPL-3.0-or-later
// The path of a newcomer, counted: from the page of sign-in to the first target of A2 that is touched, with
// each kind of device, by real input: keys and clicks, raw events of two mice, sticks, poses of a tracker and
// of devices with force. FULCRUM_NEWCOMER_PAGE=docs/results takes the path with each of them and writes the
// table; without it two mice do.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <fstream>

#include "app/live/device_rig.h"
#include "sim_core/controllers/sdl_library.h"
#include "sim_core/lab/result_page.h"
#include "tests/app/controller_hand.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/posed_hand.h"
#include "tests/app/program_path.h"
#include "tests/app/two_mice_hand.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_force_dimension.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_touch.h"
#include "tests/support/built.h"
#include "tests/support/fake_haply.h"
#include "tests/support/fake_spacenavd.h"
#include "tests/support/fake_tracker.h"
#include "tests/support/fake_trainer.h"
#include "tests/support/own_folder.h"
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
    /// Also where no page is wanted.
    virtual bool always() const { return false; }
    /// Types name and password, opens the briefing and begins; counts keys and clicks.
    void begin() {
        sign_in("tara", newcomer_password);
        expect_page("home_page");
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
        const std::size_t letters = std::string("tara").size() + std::string(newcomer_password).size();
        keys_ = static_cast<int>(letters) + 1 + 2 + 3;  // Enter; into two fields; the task, practice, start
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
        rows().push_back({device, std::to_string(keys_), std::to_string(worker.events()), unit,
                          decimal_words(1e-3 * ticks)});
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
            "A2, practice, start, then the device until the first sphere that is lit has been touched. The "
            "hands know where to go and approach like the demonstration; a person takes longer. Seconds are "
            "those of the attempt's clock from its first tick. A pose is a reading of the device that "
            "differs "
            "from the one before: a hand that moves makes them by itself.");
        lab::ResultTable table;
        table.columns = {"device", "keys and clicks before the theatre", "input in the theatre",
                         "of which kind", "time in the theatre, s"};
        table.rows = rows();
        page.table(table);
        page.write(folder, lab::this_machine(lab::build_info()));
    }
    int keys_ = 0;
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
    Variable device{"FULCRUM_DEVICE", "controller"};
    FakePad pad{page->controller[0]};
};
class NewcomerWithController : public NewcomersPad, public Newcomer {};
TEST_F(NewcomerWithController, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first("game controller", "changes of sticks and buttons",
                [this](ObservingRig& mind) { return ControllerHand(theatre(), mind, pad); });
}

/// fulcrum-hapticd next to the program.
std::string newcomers_daemon() {
    const std::string program = program_path();
    return program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd";
}

/// Both hands by devices whose pose a test sets.
struct NewcomersTouch {
    Variable daemon{"FULCRUM_HAPTICD", newcomers_daemon()};
    fulcrum::test::FakePage<fulcrum::test::FakeTouchPage> page{"FAKE_TOUCH_PAGE"};
    Variable library{"FULCRUM_LIBHD", fulcrum::test::fake_library("libHD.so")};
    Variable device{"FULCRUM_DEVICE", "touch:Left Device,Right Device"};
};
class NewcomerWithTouch : public NewcomersTouch, public Newcomer {};
TEST_F(NewcomerWithTouch, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first("3D Systems Touch (fake of its library)", "poses", [this](ObservingRig& mind) {
        return PosedHand(theatre(), mind, [this](int hand, const Vector3& position) {
            for (int axis = 0; axis < 3; ++axis) page->device[hand].position[axis] = 1e3 * position[axis];
        });
    });
    double felt = 0;
    for (int h = 0; h < 2; ++h)
        for (const auto& force : page->device[h].force) felt = std::max(felt, std::abs(force.load()));
    EXPECT_EQ(felt, 0) << "after the attempt";
}

struct NewcomersHaply {
    Variable daemon{"FULCRUM_HAPTICD", newcomers_daemon()};
    fulcrum::test::FakeHaply haply{{{"0A11", "left"}, {"0B22", "right"}}};
    Variable device{"FULCRUM_DEVICE", haply.specification()};
};
class NewcomerWithHaply : public NewcomersHaply, public Newcomer {};
TEST_F(NewcomerWithHaply, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first("Haply Inverse3 (fake of its service)", "poses", [this](ObservingRig& mind) {
        return PosedHand(
            theatre(), mind,
            [this](int hand, const Vector3& p) {
                haply.move(static_cast<std::size_t>(hand), Vector3(p.x(), -p.z(), p.y()));
            },
            Vector3(0.01, 0.1, 0.15));
    });
}

struct NewcomersForceDimension {
    Variable daemon{"FULCRUM_HAPTICD", newcomers_daemon()};
    fulcrum::test::FakePage<fulcrum::test::FakeForceDimensionPage> page{"FAKE_FORCE_DIMENSION_PAGE"};
    Variable library{"FULCRUM_LIBDRD", fulcrum::test::fake_library("libdrd.so")};
    Variable device{"FULCRUM_DEVICE", "force-dimension"};
};
class NewcomerWithForceDimension : public NewcomersForceDimension, public Newcomer {};
TEST_F(NewcomerWithForceDimension, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first("Force Dimension (fake of its library)", "poses", [this](ObservingRig& mind) {
        return PosedHand(theatre(), mind, [this](int hand, const Vector3& p) {
            const double place[3] = {p.z(), p.x(), p.y()};  // towards the person, to the right, up
            for (int axis = 0; axis < 3; ++axis) page->device[hand].position[axis] = place[axis];
        });
    });
    for (int h = 0; h < 2; ++h)
        for (const auto& force : page->device[h].force) EXPECT_EQ(force.load(), 0) << "after the attempt";
}

/// Follows a wanted place with the deflection of the cap, as a person does who looks at the screen. The other
/// hand rests.
class CapHand {
  public:
    CapHand(ui::TheatrePage& theatre, ObservingRig& mind, const fulcrum::test::FakeSpacenavd& cap, int hand)
        : theatre_(theatre), mind_(mind), cap_(cap), hand_(hand) {}
    bool work_until(const std::function<bool()>& done, int milliseconds) {
        QElapsedTimer timer;
        timer.start();
        while (timer.elapsed() < milliseconds) {
            QTest::qWait(10);
            const ui::AttemptSession* const session = theatre_.session();
            if (session == nullptr || done()) return true;
            if (session->phase() == ui::AttemptPhase::running) push(*session);
        }
        return false;
    }
    int events() const { return events_; }

  private:
    void push(const ui::AttemptSession& session) {
        mind_.observe(session.snapshot(), session.display());
        while (tick_ < session.health().ticks) mind_.read(++tick_, wish_);
        if (tick_ == 0) return;
        const InstrumentSpec& spec = *session.scene().instrument(static_cast<Hand>(hand_));
        const Trocar trocar = make_trocar(spec.trocar);
        const ToolPose& now = session.snapshot().tools[hand_];
        // The handle is on the shaft's line, outside.
        const Vector3 handle =
            trocar.rotation.transpose() * (now.tip - spec.trocar.shaft_length * now.axis - now.trocar);
        const Vector3 way = DeviceRig::turned(handle_of(wish_.hand[hand_]) - handle);
        std::array<std::int32_t, 7> counts{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            constexpr double counts_a_metre = 15000;
            const double wanted = (axis == 2 ? -1 : 1) * counts_a_metre * way[static_cast<int>(axis)];
            counts[axis] = static_cast<std::int32_t>(std::clamp(wanted, -350.0, 350.0));
        }
        counts[6] = 16;
        cap_.send_event(0, counts);
        ++events_;
    }
    ui::TheatrePage& theatre_;
    ObservingRig& mind_;
    const fulcrum::test::FakeSpacenavd& cap_;
    RigSample wish_;
    std::uint32_t tick_ = 0;
    int hand_ = 0, events_ = 0;
};

/// A2 asks for the left hand first.
struct NewcomersCap {
    Variable daemon{"FULCRUM_HAPTICD", newcomers_daemon()};
    fulcrum::test::OwnFolder cap_folder;
    std::string path = (cap_folder.path() / "spnav.sock").string();
    Variable socket{"SPNAV_SOCKET", path};
    fulcrum::test::FakeSpacenavd cap{path, 1};
    Variable device{"FULCRUM_DEVICE", "space-mouse:left"};
};
class NewcomerWithSpaceMouse : public NewcomersCap, public Newcomer {};
TEST_F(NewcomerWithSpaceMouse, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first("SpaceMouse for the left hand (fake of spacenavd)", "deflections of the cap",
                [this](ObservingRig& mind) { return CapHand(theatre(), mind, cap, 0); });
}

struct NewcomersTracker {
    Variable daemon{"FULCRUM_HAPTICD", newcomers_daemon()};
    fulcrum::test::FakeTracker tracker{{"LeftTipToPatient", "RightTipToPatient"}};
    Variable device{"FULCRUM_DEVICE", "openigtlink:" + tracker.address() +
                                          ",left=LeftTipToPatient,right=RightTipToPatient,length=0"};
};
class NewcomerWithTracker : public NewcomersTracker, public Newcomer {};
TEST_F(NewcomerWithTracker, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first("tracked instruments over OpenIGTLink", "poses", [this](ObservingRig& mind) {
        return PosedHand(theatre(), mind, [this](int hand, const Vector3& position) {
            igtl::Pose pose;
            pose.place = position;
            tracker.move(static_cast<std::size_t>(hand), pose);
        });
    });
}

struct NewcomersTrainer {
    Variable daemon{"FULCRUM_HAPTICD", newcomers_daemon()};
    fulcrum::test::FakeTrainer trainer{"LR"};
    Variable device{"FULCRUM_DEVICE", trainer.specification()};
};
class NewcomerWithTrainer : public NewcomersTrainer, public Newcomer {};
TEST_F(NewcomerWithTrainer, TouchesTheFirstTarget) {
    ASSERT_NO_FATAL_FAILURE(begin());
    touch_first("box trainer on a serial port (pseudo-terminal)", "poses", [this](ObservingRig& mind) {
        return PosedHand(
            theatre(), mind,
            [this](int hand, const Vector3& position) { trainer.move(hand == 0 ? 'L' : 'R', position); },
            Vector3(0, 0, 0.24));
    });
}

}  // namespace
}  // namespace fulcrum::app::program_test
