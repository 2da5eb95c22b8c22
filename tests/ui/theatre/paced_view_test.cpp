// SPDX-License-Identifier: GPL-3.0-or-later
// The live view draws the scene at the resolution chosen by DrawingPace, and text always at full resolution.
// The durations are set by the test. FULCRUM_PICTURES=FOLDER stores the pictures.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QEventLoop>

#include "sim_core/world/world.h"
#include "tests/support/support.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui {
namespace {

class PacedView : public ::testing::Test {
  protected:
    PacedView() : snapshot(World(scene, 1).snapshot()) {
        task.title = "Targets";
        hud.task = &task;
        hud.place = QStringLiteral("here");
        view.resize(480, 320);
        view.load(scene, snapshot);
        QEventLoop waiting;
        QObject::connect(&view, &TheatreView::loaded, &waiting, &QEventLoop::quit);
        QObject::connect(&view, &TheatreView::load_failed, &waiting, &QEventLoop::quit);
        waiting.exec();
        view.set_hud(hud);
    }
    QImage picture(const char* name) {
        const QImage image = view.grab().toImage();
        const QString folder = qEnvironmentVariable("FULCRUM_PICTURES");
        if (!folder.isEmpty()) image.save(QDir(folder).filePath(QString::fromLatin1(name) + ".png"));
        return image;
    }
    /// Two averaging windows of the pace: at least one contains only these durations.
    void tell(double ms) {
        for (int i = 0; i < 30; ++i) view.pace().drawn(ms);
    }
    Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    WorldSnapshot snapshot;
    TaskDefinition task;
    HudState hud;
    TheatreView view;
};

TEST_F(PacedView, SceneIsDrawnAtThePacesResolutionAndTextAtFullResolution) {
    ASSERT_TRUE(view.is_loaded()) << view.drawing_error().toStdString();
    constexpr int coarsest = DrawingPace::levels - 1;
    // Without pacing, the durations have no effect.
    const QImage fine = picture("fine");
    const double full = view.resolution();
    EXPECT_GT(full, 0.5);
    tell(1000);
    EXPECT_EQ(picture("not-paced"), fine);
    EXPECT_EQ(view.resolution(), full);

    view.set_paced(true);
    EXPECT_EQ(view.pace().level(), 0);
    tell(1000);
    ASSERT_EQ(view.pace().level(), coarsest);
    const QImage coarse = picture("coarse");
    EXPECT_NEAR(view.resolution(), full * DrawingPace::share_at(coarsest), 0.005);
    ASSERT_EQ(coarse.size(), fine.size());
    EXPECT_NE(coarse, fine);
    // The same picture, less sharp; identical outside the round image, where the text is.
    double difference = 0;
    int beside = 0, words = 0;
    const double middle_x = 0.5 * fine.width(), middle_y = 0.5 * fine.height();
    for (int y = 0; y < fine.height(); ++y) {
        for (int x = 0; x < fine.width(); ++x) {
            const QRgb a = fine.pixel(x, y), b = coarse.pixel(x, y);
            difference += std::abs(qGray(a) - qGray(b));
            if (std::hypot(x + 0.5 - middle_x, y + 0.5 - middle_y) < middle_y + 1) continue;
            beside += a != b ? 1 : 0;
            words += qGray(a) > 100 ? 1 : 0;
        }
    }
    EXPECT_LT(difference / (fine.width() * fine.height()), 4);
    EXPECT_EQ(beside, 0);
    EXPECT_GT(words, 50);

    view.set_paced(false);
    EXPECT_EQ(picture("fine-again"), fine);
    EXPECT_EQ(view.resolution(), full);
}

}  // namespace
}  // namespace fulcrum::ui
