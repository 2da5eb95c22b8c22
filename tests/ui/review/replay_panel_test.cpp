// SPDX-License-Identifier: GPL-3.0-or-later
// What the replay says while the pass through its record has not come to the moment chosen.
// FULCRUM_PICTURES=FOLDER stores it.
#include "ui/review/replay_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QSlider>
#include <utility>

#include "assessment/assets/assets.h"
#include "sim_core/scene/scene.h"
#include "tests/support/support.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/style/palette.h"

namespace fulcrum::ui::window_test {
namespace {

class SlowReplay : public ReplaySource {
  public:
    struct Shown {
        double prepared = 0, at = 0;
        bool is_new = true;
    };
    SlowReplay(Scene scene, WorldSnapshot world, std::shared_ptr<Shown> shown)
        : scene_(std::move(scene)), world_(std::move(world)), shown_(std::move(shown)) {}
    const Scene& scene() const override { return scene_; }
    double duration_s() const override { return 600; }
    void seek(double time_s) override {
        if (time_s <= 600 * shown_->prepared) *shown_ = {shown_->prepared, time_s, true};
    }
    bool update() override { return std::exchange(shown_->is_new, false); }
    const WorldSnapshot& snapshot() const override { return world_; }
    double shown_s() const override { return shown_->at; }
    double ready() const override { return shown_->prepared; }
    std::optional<double> differs_from_s() const override { return std::nullopt; }
    std::shared_ptr<const ReplayMoment> moment(double) const override { return nullptr; }

  private:
    Scene scene_;
    WorldSnapshot world_;
    std::shared_ptr<Shown> shown_;
};

class PreparingReplay : public ::testing::Test {
  protected:
    PreparingReplay() : task(load_task(task_file("A2"))) {
        auto made = std::make_shared<AttemptModel>();
        made->duration = 600;
        auto trace = std::make_shared<database::Trace>();
        made->trace = trace;
        panel.open(made, &task);
        panel.set_record(made,
                         std::make_unique<SlowReplay>(
                             load_scene(fulcrum::test::source_path("assets/scenes/" + task.scene)),
                             FakeServices().world_at_start(task, ""), state),
                         {});
        panel.resize(800, 600);
        panel.show();
    }
    bool says(const QString& text) {
        return wait_for([&] {
            for (const QLabel* label : panel.findChildren<QLabel*>())
                if (label->text() == text) return true;
            return false;
        });
    }
    bool says_nothing_of(const QString& part) {
        return wait_for([&] {
            for (const QLabel* label : panel.findChildren<QLabel*>())
                if (label->text().contains(part)) return false;
            return true;
        });
    }
    const TaskDefinition task;
    std::shared_ptr<SlowReplay::Shown> state = std::make_shared<SlowReplay::Shown>();
    ReplayPanel panel;
};

TEST_F(PreparingReplay, SaysHowFarItIsWithoutANewPicture) {
    EXPECT_TRUE(says(QStringLiteral("preparing 0\u00a0%")));
    state->prepared = 0.25;
    EXPECT_TRUE(says(QStringLiteral("preparing 25\u00a0%")));
    state->prepared = 1;
    EXPECT_TRUE(says_nothing_of(QStringLiteral("preparing")));
}

TEST_F(PreparingReplay, SaysWhichMomentIsShownAndAnEarlierOneEndsTheWait) {
    state->prepared = 0.5;
    EXPECT_TRUE(says(QStringLiteral("preparing 50\u00a0%")));
    panel.seek(540);
    *state = {0.6, 360, true};
    EXPECT_TRUE(says(QStringLiteral(
        "preparing 60\u00a0%: the tissue is that of 6:00.0 so far; earlier moments are shown at once")));
    const QString folder = qEnvironmentVariable("FULCRUM_PICTURES");
    for (const Theme theme : {Theme::dark, Theme::light}) {
        apply_theme(*qApp, theme);
        if (!folder.isEmpty())
            panel.grab().save(folder + (theme == Theme::dark ? "/preparing-dark.png" : "/preparing.png"));
    }
    panel.seek(100);
    EXPECT_TRUE(says(QStringLiteral("preparing 60\u00a0%")));
    EXPECT_EQ(panel.shown_time(), 100);
}

TEST_F(PreparingReplay, ARecordThatContinuesAnotherBeginsAtItsOwnFirstMoment) {
    auto practice = std::make_shared<AttemptModel>();
    practice->begin = 300;
    practice->duration = 320;
    practice->trace = std::make_shared<database::Trace>();
    panel.open(practice, &task);
    EXPECT_EQ(panel.time(), 300);
    panel.seek(0);
    EXPECT_EQ(panel.time(), 300);
    const auto* slider = panel.findChild<QSlider*>("replay_slider");
    EXPECT_EQ(slider->minimum(), 30000);
    EXPECT_EQ(slider->value(), 30000);
    EXPECT_EQ(slider->pageStep(), 100) << "of its own length";
    panel.seek(320);
    panel.play(true);
    EXPECT_EQ(panel.time(), 300) << "from the beginning once more";
}

TEST_F(PreparingReplay, WhyPracticeCannotBeginStaysUntilAnotherMomentIsChosen) {
    panel.offer_practice(true);
    EXPECT_TRUE(says(QStringLiteral("preparing 0\u00a0%")));
    click(panel, "replay_take_over");
    const QString why = QStringLiteral(
        "Practice cannot begin at this moment yet: wait until it is prepared, or choose a later one.");
    state->is_new = true;  // another picture does not take it away
    EXPECT_TRUE(wait_for([&] { return !state->is_new; }));
    EXPECT_TRUE(says(why));
    panel.seek(1);
    EXPECT_TRUE(
        says(QStringLiteral("preparing 0\u00a0%: the tissue is that of 0:00.0 so far; earlier moments "
                            "are shown at once")));
    click(panel, "replay_take_over");
    state->prepared = 1;
    EXPECT_TRUE(says_nothing_of(QStringLiteral("Practice cannot begin"))) << "it can now";
}

}  // namespace
}  // namespace fulcrum::ui::window_test
