// SPDX-License-Identifier: GPL-3.0-or-later
// The window with Force Dimension, Haply, SpaceMouse, a tracker and a joystick, each a fake that the test
// scripts: a fault pauses the attempt with force 0 and says what to do; when it has passed the attempt
// resumes, and nothing is lost. The first steps are those of the device.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/controllers/joystick_mapping.h"
#include "sim_core/numerics/files.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/posed_hand.h"
#include "tests/app/program_path.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_force_dimension.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/support/built.h"
#include "tests/support/fake_haply.h"
#include "tests/support/fake_spacenavd.h"
#include "tests/support/fake_tracker.h"
#include "tests/support/fake_trainer.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

using fulcrum::test::FakeHaply;
using fulcrum::test::FakeTracker;
using fulcrum::test::Variable;
using ui::window_test::find;
using ui::window_test::wait_for;

/// A device that a test moves, breaks and repairs.
class Breakable {
  public:
    virtual ~Breakable() = default;
    /// Device frame of docs/DEVICES.md, m.
    virtual void put(int hand, const Vector3& position) = 0;
    virtual Vector3 begin() const { return Vector3::Zero(); }
    virtual void break_it() = 0;
    virtual void repair() = 0;
    /// Begins at 0 when it is opened again: moves it on towards its instrument, which is so far away (m).
    virtual void go_back(double /*distance*/) {}
    virtual double force() const { return 0; }  ///< N, what the device got last
    const char *words = "", *lines = "", *title = "";
    bool feels = false;
};

class BreakableForceDimension : public Breakable {
  public:
    BreakableForceDimension() {
        words = "does not answer. Check its cable";
        lines = "Handle of the device";
        title = "omega.7";
        feels = true;
    }
    void put(int hand, const Vector3& p) override {
        const double place[3] = {p.z(), p.x(), p.y()};  // towards the person, to the right, up
        for (int axis = 0; axis < 3; ++axis) page_->device[hand].position[axis] = place[axis];
    }
    void break_it() override { page_->device[0].pose_fails = 1; }
    void repair() override { page_->device[0].pose_fails = 0; }
    double force() const override {
        double most = 0;
        for (const auto& device : page_->device)
            for (const auto& f : device.force) most = std::max(most, std::abs(f.load()));
        return most;
    }

  private:
    fulcrum::test::FakePage<fulcrum::test::FakeForceDimensionPage> page_{"FAKE_FORCE_DIMENSION_PAGE"};
    Variable library_{"FULCRUM_LIBDRD", fulcrum::test::fake_library("libdrd.so")};
    Variable device_{"FULCRUM_DEVICE", "force-dimension"};
};

class BreakableHaply : public Breakable {
  public:
    BreakableHaply() {
        words = "readings that cannot be used";
        lines = "Grip of the Inverse3";
        title = "Haply";
        feels = true;
        for (int hand = 0; hand < hand_count; ++hand) BreakableHaply::put(hand, BreakableHaply::begin());
    }
    void put(int hand, const Vector3& p) override {
        haply_.move(static_cast<std::size_t>(hand), Vector3(p.x(), -p.z(), p.y()));
    }
    Vector3 begin() const override { return {0.01, 0.1, 0.15}; }
    void break_it() override { haply_.mode = FakeHaply::Mode::garbage; }
    void repair() override { haply_.mode = FakeHaply::Mode::good; }
    double force() const override { return std::max(haply_.force(0).norm(), haply_.force(1).norm()); }

  private:
    FakeHaply haply_{{{"0A11", "left"}, {"0B22", "right"}}};
    Variable device_{"FULCRUM_DEVICE", haply_.specification()};
};

class BreakableTracker : public Breakable {
  public:
    BreakableTracker() {
        words = "sends no pose";
        lines = "Tracked instrument";
        title = "OpenIGTLink";
    }
    void put(int hand, const Vector3& position) override {
        igtl::Pose pose;
        pose.place = position;
        tracker_.move(static_cast<std::size_t>(hand), pose);
    }
    void break_it() override { tracker_.mode = FakeTracker::Mode::silent; }
    void repair() override { tracker_.mode = FakeTracker::Mode::good; }

  private:
    FakeTracker tracker_{{"LeftTipToPatient", "RightTipToPatient"}};
    Variable device_{"FULCRUM_DEVICE", "openigtlink:" + tracker_.address() +
                                           ",left=LeftTipToPatient,right=RightTipToPatient,length=0"};
};

/// A deflection is a speed: a place is reached where the cap is let go.
class BreakableSpaceMouse : public Breakable {
  public:
    BreakableSpaceMouse() {
        words = "systemctl restart spacenavd";
        lines = "Cap to the side";
        title = "SpaceMouse";
    }
    void put(int, const Vector3&) override { push(full); }
    /// The nearer, the slower: a window that looks seldom must not let it run past its instrument and away.
    void go_back(double distance) override {
        constexpr double near = 4e-3, counts_a_metre = 15000;
        push(distance > near ? static_cast<int>(std::min<double>(full, counts_a_metre * distance)) : 0);
    }
    /// Ends, and is started again.
    void break_it() override {
        push(0);
        cap_.reset();
    }
    void repair() override { cap_ = std::make_unique<fulcrum::test::FakeSpacenavd>(path_, 1); }

  private:
    static constexpr int full = 350;
    void push(int counts) const { cap_->send_event(0, {counts, 0, 0, 0, 0, 0, 16}); }
    fulcrum::test::OwnFolder folder_;
    std::string path_ = (folder_.path() / "spnav.sock").string();
    Variable socket_{"SPNAV_SOCKET", path_};
    std::unique_ptr<fulcrum::test::FakeSpacenavd> cap_ =
        std::make_unique<fulcrum::test::FakeSpacenavd>(path_, 1);
    Variable device_{"FULCRUM_DEVICE", "space-mouse:left"};
};

/// A joystick of SDL 2 whose six axes are the angles and the lengths of two instruments.
class BreakableJoystick : public Breakable {
  public:
    BreakableJoystick() {
        words = "of the name Odd Stick is connected; connect it";
        lines = "Instrument on the joystick";
        title = name;
        page_->controller[0].known = 0;
        std::snprintf(page_->controller[0].name, sizeof page_->controller[0].name, "%s", name);
        for (int hand = 0; hand < hand_count; ++hand)
            BreakableJoystick::put(hand, BreakableJoystick::begin());
        page_->controller[0].plugged = 1;
        write_whole_file(file_, joystick_mapping_text(mapping()));
    }
    void put(int hand, const Vector3& handle) override {
        const Vector3 to_the_tip = -handle.normalized();
        const double of_instrument[] = {std::asin(to_the_tip.y()),
                                        std::atan2(to_the_tip.x(), -to_the_tip.z()),
                                        fulcrum::test::trainer_length - handle.norm()};
        for (int i = 0; i < axes_of_hand; ++i) {
            const double share = (of_instrument[i] - least[i]) / (most[i] - least[i]);
            page_->controller[0].axis[axes_of_hand * hand + i] =
                static_cast<std::int32_t>(std::lround(65535 * share)) - 32768;
        }
    }
    Vector3 begin() const override { return {0, 0, 0.24}; }
    void break_it() override { page_->controller[0].plugged = 0; }
    void repair() override { page_->controller[0].plugged = 1; }

  private:
    static constexpr int axes_of_hand = 3;
    static constexpr double least[axes_of_hand] = {-0.8, -0.8, 0}, most[axes_of_hand] = {0.8, 0.8, 0.3};
    static constexpr const char* name = "Odd Stick";
    static JoystickMapping mapping() {
        JoystickMapping made;
        made.name = name;
        for (int hand = 0; hand < hand_count; ++hand)
            for (int i = 0; i < axes_of_hand; ++i) {
                JoystickAxis& axis = made.part[hand].motion[i];
                axis.axis = axes_of_hand * hand + i;
                axis.at_low = least[i];
                axis.at_high = most[i];
                axis.at_rest = 0.5 * (least[i] + most[i]);
            }
        return made;
    }
    fulcrum::test::FakePage<fulcrum::test::FakeSdlPage> page_{"FAKE_SDL_PAGE"};
    Variable library_{"FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so")};
    fulcrum::test::OwnFolder folder_;
    std::string file_ = (folder_.path() / "joystick.json").string();
    Variable device_{"FULCRUM_DEVICE", "joystick:" + file_};
};

std::unique_ptr<Breakable> breakable(const std::string& kind) {
    if (kind == "ForceDimension") return std::make_unique<BreakableForceDimension>();
    if (kind == "Haply") return std::make_unique<BreakableHaply>();
    if (kind == "OpenIGTLink") return std::make_unique<BreakableTracker>();
    if (kind == "Joystick") return std::make_unique<BreakableJoystick>();
    return std::make_unique<BreakableSpaceMouse>();
}

/// Before the services are made.
struct WithBreakable : ::testing::WithParamInterface<std::string> {
    static std::string daemon() {
        const std::string program = program_path();
        return program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd";
    }
    Variable program{"FULCRUM_HAPTICD", daemon()};
    std::unique_ptr<Breakable> device = breakable(GetParam());
};

class FaultWindow : public WithBreakable, public Window {
  protected:
    QString panel() { return find<QLabel>(window, "panel_text")->text(); }
    ui::AttemptPhase phase() { return theatre().session()->phase(); }
    /// The left hand presses on the first sphere; without poses of its own it moves.
    bool works(int milliseconds) {
        const auto mind = make_pointing_mind(theatre().session()->scene(), 1e-3);
        PosedHand hand(
            theatre(), *mind, [this](int h, const Vector3& position) { device->put(h, position); },
            device->begin());
        return hand.work_until(
            [&] {
                const TaskDisplay& display = theatre().session()->display();
                const bool presses = device->feels ? device->force() > 0.05 : display.moving_seen;
                return display.moving_seen && display.elapsed_s > 0.05 && presses;
            },
            milliseconds);
    }
};

TEST_P(FaultWindow, PausesTheAttemptWithForceZeroSaysWhatToDoAndLosesNothing) {
    create_programme_and_trainee();
    start("A2", false);
    ASSERT_TRUE(wait_for([&] { return ui::window_test::sees(window, "theatre_keys"); }));
    const QString strip =
        find<QFrame>(window, "theatre_keys")->findChild<QLabel*>()->text().replace("&nbsp;", " ");
    EXPECT_TRUE(strip.contains(device->lines)) << strip.toStdString();
    EXPECT_EQ(theatre().session()->health().force_felt[0], device->feels);
    ASSERT_TRUE(works(20000)) << "force at the device: " << device->force();

    const std::int64_t broken = monotonic_ns();
    device->break_it();
    while (device->force() != 0 && monotonic_ns() - broken < 1'000'000'000) usleep(200);
    EXPECT_LE(monotonic_ns() - broken, 50'000'000) << "until the force is 0";
    ASSERT_TRUE(wait_for([&] { return phase() == ui::AttemptPhase::device_lost; }));
    ASSERT_TRUE(wait_for([&] { return panel().contains(device->words); }, 10000)) << panel().toStdString();
    EXPECT_TRUE(panel().contains("The force is 0 and the timer is stopped")) << panel().toStdString();
    EXPECT_EQ(device->force(), 0);
    // The display of a late step can come after the panel.
    const std::uint32_t lost_at = theatre().session()->health().ticks;
    ASSERT_TRUE(wait_for([&] { return theatre().session()->snapshot().tick >= lost_at; }));
    const double stopped = theatre().session()->display().elapsed_s;
    EXPECT_GT(stopped, 0);
    device->repair();
    ASSERT_TRUE(wait_for([&] { return aligned().back; }, 20000)) << panel().toStdString();
    ASSERT_TRUE(wait_for(
        [&] {
            device->go_back(aligned().hand[0].distance);
            return aligned().in_place;
        },
        20000))
        << aligned().hand[0].distance;
    EXPECT_EQ(device->force(), 0) << "until the person resumes";
    EXPECT_EQ(theatre().session()->display().elapsed_s, stopped);
    QTest::keyClick(theatre().view(), Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return phase() == ui::AttemptPhase::running; }, 10000));
    ASSERT_TRUE(wait_for([&] { return theatre().session()->display().elapsed_s > stopped; }, 10000));
    EXPECT_TRUE(!device->feels || wait_for([&] { return device->force() > 0.05; }, 10000))
        << "the force comes back";
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_NE(attempt.meta.device.find(device->title), std::string::npos) << attempt.meta.device;
    expect_replays(attempt.meta.id);
}

INSTANTIATE_TEST_SUITE_P(Devices, FaultWindow,
                         ::testing::Values("ForceDimension", "Haply", "SpaceMouse", "OpenIGTLink",
                                           "Joystick"),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace fulcrum::app::program_test
