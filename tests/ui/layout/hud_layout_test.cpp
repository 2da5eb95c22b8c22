// SPDX-License-Identifier: GPL-3.0-or-later
// What the head-up display writes never lies over something else that it writes, at any size of the picture.
#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <limits>

#include "painted_words.h"
#include "ui/theatre/hud.h"

namespace fulcrum::ui::test {
namespace {

/// All that can be said at once of a goal of this kind.
struct Shown {
    TaskDefinition task;
    HudState hud;
};

Shown everything(GoalKind kind) {
    Shown shown;
    Goal goal;
    goal.kind = kind;
    goal.text = "Divide the plane level by level down to the levator, taut";
    goal.count = 6;
    goal.length_m = 0.224;
    goal.height_m = 0.03;
    goal.hold_s = 3;
    goal.traction_low_n_m = 8;
    goal.traction_high_n_m = 18;
    shown.task.goals = {goal, goal, goal};
    HudState& hud = shown.hud;
    hud.place = QStringLiteral("replay ×0.5");
    hud.shows_active_hand = true;
    hud.force_felt = false;
    hud.tool[0] = QStringLiteral("grasper");
    hud.tool[1] = QStringLiteral("hook, in 1.2 s");
    hud.tool_active[1] = true;
    hud.display.goal = 1;
    hud.display.goal_progress = 0.6;
    hud.display.hold_progress = kind == GoalKind::divide_line ? 0 : 0.4;
    hud.display.cut_divided_m = 0.142;
    hud.display.traction_n_m = 1;
    hud.display.traction_warning = -1;
    hud.display.critical = true;
    hud.display.elapsed_s = 78;
    hud.display.remaining_s = 70.6;
    for (int h = 0; h < hand_count; ++h) {
        hud.display.force[h] = 2.4F;
        hud.display.force_limit[h] = 3;
        hud.display.warning[h] = true;
    }
    return shown;
}

/// px: lines of one paragraph stand closer by what ascent and descent are rounded up.
constexpr double rounding = 1;

void expect_apart(Shown& shown, QSize size) {
    shown.hud.task = &shown.task;
    WordsDevice device(size);
    QPainter painter(&device);
    paint_hud(painter, QRectF(QPointF(0, 0), QSizeF(size)), shown.hud);
    painter.end();
    if (const QString folder = qEnvironmentVariable("FULCRUM_PICTURES"); !folder.isEmpty()) {
        QImage picture(size, QImage::Format_RGB32);
        picture.fill(Qt::black);
        QPainter brush(&picture);
        paint_hud(brush, picture.rect(), shown.hud);
        brush.end();
        picture.save(folder + QStringLiteral("/hud-%1-%2.png")
                                  .arg(size.width())
                                  .arg(static_cast<int>(shown.task.goals[0].kind)));
    }
    const auto& words = device.words();
    ASSERT_GT(words.size(), 10U);
    const QRectF whole(QPointF(0, 0), QSizeF(size));
    for (std::size_t i = 0; i < words.size(); ++i) {
        EXPECT_TRUE(whole.contains(words[i].place)) << words[i].words.toStdString();
        for (std::size_t j = i + 1; j < words.size(); ++j) {
            const QRectF both = words[i].place & words[j].place;
            EXPECT_LE(std::min(both.width(), both.height()), rounding)
                << size.width() << " x " << size.height() << ": '" << words[i].words.toStdString()
                << "' and '" << words[j].words.toStdString() << "'";
        }
        for (const QRectF& shape : device.shapes()) {
            const QRectF both = words[i].place & shape;
            EXPECT_LE(std::min(both.width(), both.height()), rounding)
                << size.width() << " x " << size.height() << ": '" << words[i].words.toStdString()
                << "' on a bar at " << shape.top();
        }
    }
}

TEST(HudLayout, NothingLiesOverAnythingInTheReplaysPictureAndInTheTheatre) {
    for (const GoalKind kind : {GoalKind::divide_line, GoalKind::take_tension}) {
        // The debrief's picture at the smallest window, a wider one, the theatre's sizes.
        for (const QSize size : {QSize(557, 360), QSize(700, 400), QSize(800, 480), QSize(1000, 600),
                                 QSize(1280, 800), QSize(1920, 1080)}) {
            Shown shown = everything(kind);
            expect_apart(shown, size);
        }
    }
}

TEST(HudLayout, ForcesStandStillWhenAWarningComes) {
    const auto hand_at = [](Shown& shown) {
        shown.hud.task = &shown.task;
        WordsDevice device(QSize(557, 360));
        QPainter painter(&device);
        paint_hud(painter, QRectF(0, 0, 557, 360), shown.hud);
        painter.end();
        for (const PaintedWords& painted : device.words())
            if (painted.words.contains(QLatin1String("Left"))) return painted.place.top();
        return std::numeric_limits<double>::quiet_NaN();
    };
    Shown loud = everything(GoalKind::divide_line), quiet = loud;
    quiet.hud.display.traction_warning = 0;
    quiet.hud.display.traction_n_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(hand_at(loud), hand_at(quiet));
}

}  // namespace
}  // namespace fulcrum::ui::test
