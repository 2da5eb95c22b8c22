// SPDX-License-Identifier: GPL-3.0-or-later
// The window with Force Dimension, Haply and SpaceMouse, each a fake that the test scripts: a fault pauses
// the attempt with force 0 and says what to do, when it has passed the attempt resumes, and nothing is lost.
// The first steps are those of the device.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/program_path.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_force_dimension.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/fake_haply.h"
#include "tests/support/fake_spacenavd.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

using fulcrum::test::FakeHaply;
using fulcrum::test::Variable;
using ui::window_test::find;
using ui::window_test::wait_for;

/// A device that a test moves, breaks and repairs.
class Breakable {
  public:
    virtual ~Breakable() = default;
    virtual void move(double metres) = 0;  ///< the right hand, to the right
    virtual void break_it() = 0;
    virtual void mend() = 0;
    /// What has no place of its own is moved, when it was opened again, to the instrument, which is so far
    /// away (m).
    virtual void go_back(double /*distance*/) {}
    virtual double force() const = 0;  ///< N, what the device got last; of one without force 0
    const char *words = "", *lines = "", *title = "";
    bool feels = true;
};

class BreakableForceDimension : public Breakable {
  public:
    BreakableForceDimension() {
        words = "does not answer. Check its cable";
        lines = "Handle of the device";
        title = "Force Dimension";
    }
    void move(double metres) override { page_->device[1].position[1] = metres; }
    void break_it() override { page_->device[1].pose_fails = 1; }
    void mend() override { page_->device[1].pose_fails = 0; }
    double force() const override {
        double most = 0;
        for (const auto& device : page_->device)
            for (const auto& f : device.force) most = std::max(most, std::abs(f.load()));
        return most;
    }

  private:
    fulcrum::test::FakePage<fulcrum::test::FakeForceDimensionPage> page_{"FAKE_FORCE_DIMENSION_PAGE"};
    Variable library_{"FULCRUM_LIBDRD", std::string(FULCRUM_FAKES) + "/libdrd.so"};
    Variable device_{"FULCRUM_DEVICE", "force-dimension"};
};

class BreakableHaply : public Breakable {
  public:
    BreakableHaply() {
        words = "readings that cannot be used";
        lines = "Grip of the Inverse3";
        title = "Haply";
        move(0);
    }
    void move(double metres) override {
        haply_.move(0, Vector3(0, 0.15, 0.1));
        haply_.move(1, Vector3(metres, 0.15, 0.1));
    }
    void break_it() override { haply_.mode = FakeHaply::Mode::garbage; }
    void mend() override { haply_.mode = FakeHaply::Mode::good; }
    double force() const override { return std::max(haply_.force(0).norm(), haply_.force(1).norm()); }

  private:
    FakeHaply haply_{{{"0A11", "left"}, {"0B22", "right"}}};
    Variable device_{"FULCRUM_DEVICE", haply_.specification()};
};

class BreakableSpaceMouse : public Breakable {
  public:
    BreakableSpaceMouse() {
        words = "spacenavd, which reads the SpaceMouse, ended";
        lines = "Cap to the side";
        title = "SpaceMouse";
        feels = false;
    }
    void move(double metres) override { cap_->send_event(0, {metres > 0 ? 350 : 0, 0, 0, 0, 0, 0, 16}); }
    void go_back(double distance) override { move(distance > 2e-3 ? 1 : 0); }
    /// Ends, and is started again.
    void break_it() override { cap_.reset(); }
    void mend() override { cap_ = std::make_unique<fulcrum::test::FakeSpacenavd>(path_, 1); }
    double force() const override { return 0; }

  private:
    fulcrum::test::OwnFolder folder_;
    std::string path_ = (folder_.path() / "spnav.sock").string();
    Variable socket_{"SPNAV_SOCKET", path_};
    std::unique_ptr<fulcrum::test::FakeSpacenavd> cap_ =
        std::make_unique<fulcrum::test::FakeSpacenavd>(path_, 1);
    Variable device_{"FULCRUM_DEVICE", "space-mouse:right"};
};

std::unique_ptr<Breakable> breakable(const std::string& kind) {
    if (kind == "ForceDimension") return std::make_unique<BreakableForceDimension>();
    if (kind == "Haply") return std::make_unique<BreakableHaply>();
    return std::make_unique<BreakableSpaceMouse>();
}

/// Before the services are made.
struct WithBreakable {
    explicit WithBreakable(const std::string& kind) : device(breakable(kind)) {}
    static std::string daemon() {
        const std::string program = program_path();
        return program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd";
    }
    Variable program{"FULCRUM_HAPTICD", daemon()};
    std::unique_ptr<Breakable> device;
};

struct OfParameter : ::testing::WithParamInterface<std::string>, WithBreakable {
    OfParameter() : WithBreakable(GetParam()) {}
};

class FaultWindow : public OfParameter, public Window {
  protected:
    QString panel() { return find<QLabel>(window, "panel_text")->text(); }
    ui::AttemptPhase phase() { return theatre().session()->phase(); }
};

TEST_P(FaultWindow, PausesTheAttemptWithForceZeroSaysWhatToDoAndLosesNothing) {
    create_programme_and_trainee();
    start("A2", false);
    ASSERT_TRUE(wait_for([&] { return ui::window_test::sees(window, "theatre_keys"); }));
    const QString strip =
        find<QFrame>(window, "theatre_keys")->findChild<QLabel*>()->text().replace("&nbsp;", " ");
    EXPECT_TRUE(strip.contains(device->lines)) << strip.toStdString();
    EXPECT_EQ(theatre().session()->health().force_felt[1], device->feels);
    const double begun = theatre().session()->snapshot().tools[1].tip.x();
    device->move(0.03);
    ASSERT_TRUE(wait_for([&] {
        return std::abs(theatre().session()->snapshot().tools[1].tip.x() - begun) > 2e-3;
    })) << "the device moves the instrument";
    const auto moved = [&] { return theatre().deeds().test(ui::bit_of(ui::HandDeed::moved)); };
    EXPECT_TRUE(device->feels || wait_for(moved));
    EXPECT_FALSE(device->feels && moved()) << "the left hand has a handle of its own, which rests";

    device->break_it();
    ASSERT_TRUE(wait_for([&] { return phase() == ui::AttemptPhase::device_lost; }));
    ASSERT_TRUE(wait_for([&] { return panel().contains(device->words); })) << panel().toStdString();
    EXPECT_TRUE(panel().contains("The force is 0 and the timer is stopped")) << panel().toStdString();
    EXPECT_EQ(device->force(), 0);
    const double stopped = theatre().session()->display().elapsed_s;
    device->mend();
    ASSERT_TRUE(wait_for([&] { return aligned().back; })) << panel().toStdString();
    ASSERT_TRUE(wait_for([&] {
        device->go_back(aligned().hand[1].distance);
        return aligned().in_place;
    })) << aligned().hand[1].distance;
    EXPECT_EQ(theatre().session()->display().elapsed_s, stopped);
    QTest::keyClick(theatre().view(), Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return phase() == ui::AttemptPhase::running; }));
    ASSERT_TRUE(wait_for([&] { return theatre().session()->display().elapsed_s > stopped; }));
    abandon();
    const database::AttemptSummary attempt = newest_attempt();
    EXPECT_NE(attempt.meta.device.find(device->title), std::string::npos) << attempt.meta.device;
    expect_replays(attempt.meta.id);
}

INSTANTIATE_TEST_SUITE_P(Devices, FaultWindow, ::testing::Values("ForceDimension", "Haply", "SpaceMouse"),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace fulcrum::app::program_test
