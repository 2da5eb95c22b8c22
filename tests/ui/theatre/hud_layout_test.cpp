// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the head-up display do not overlap, at any size of the picture.
#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <limits>

#include "tests/support/support.h"
#include "tests/ui/painted_words.h"
#include "ui/language/language.h"
#include "ui/style/palette.h"
#include "ui/theatre/hud.h"
#include "ui/theatre/key_map.h"

namespace fulcrum::ui::window_test {
namespace {

/// All texts that a goal of this kind can show at the same time.
struct Shown {
    TaskDefinition task;
    HudState hud;
};

/// The other texts that can be shown at the same time.
void say_all(HudState& hud) {
    hud.place = QStringLiteral("replay ×0.5");
    hud.shows_active_hand = true;
    hud.force_felt = false;
    hud.tool[0] = QStringLiteral("grasper");
    hud.tool[1] = QStringLiteral("hook, in 1.2 s");
    hud.tool_active[1] = true;
    hud.next_key = QStringLiteral("T");
    hud.pedal_key = QStringLiteral("B");
    hud.display.goal_progress = 0.6;
    hud.display.hold_progress = 0.4;
    hud.display.run_covered_m = 0.142;
    hud.display.lift_height_m = 0.016;
    hud.display.cut_divided_m = 0.142;
    hud.display.blood_ml = 120.5F;
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
}

Shown everything(GoalKind kind) {
    Shown shown;
    Goal goal;
    goal.kind = kind;
    goal.text = "Divide the plane level by level under traction";
    goal.count = 10;
    goal.length_m = 0.224;
    goal.height_m = 0.03;
    goal.hold_s = 3;
    goal.traction_low_n_m = 8;
    goal.traction_high_n_m = 18;
    shown.task.goals = {goal, goal, goal};
    shown.hud.display.goal = 1;
    say_all(shown.hud);
    if (kind == GoalKind::divide_line) shown.hud.display.hold_progress = 0;
    return shown;
}

/// px: lines of one paragraph are closer because ascent and descent are rounded up, in pixels of the
/// layout.
double rounding_at(int dots_per_inch) {
    return std::max(1.0, dots_per_inch / 96.0);
}

/// No text overlaps another, none is cut off.
void expect_apart(Shown& shown, QSize size, int dots_per_inch, const std::string& what, int covered = 0) {
    shown.hud.task = &shown.task;
    WordsDevice device(size, dots_per_inch);
    QPainter painter(&device);
    paint_hud(painter, QRectF(QPointF(0, 0), QSizeF(size)), shown.hud, covered);
    painter.end();
    if (const QString folder = qEnvironmentVariable("FULCRUM_PICTURES"); !folder.isEmpty()) {
        QImage picture(size, QImage::Format_RGB32);
        picture.setDotsPerMeterX(qRound(dots_per_inch / 0.0254));
        picture.setDotsPerMeterY(qRound(dots_per_inch / 0.0254));
        picture.fill(Qt::black);
        QPainter brush(&picture);
        paint_hud(brush, picture.rect(), shown.hud, covered);
        brush.end();
        picture.save(QStringLiteral("%1/hud-%2-%3-%4.png")
                         .arg(folder, QString::fromStdString(what))
                         .arg(size.width())
                         .arg(dots_per_inch));
    }
    const std::string where = what + ", " + std::to_string(size.width()) + " x " +
                              std::to_string(size.height()) + " at " + std::to_string(dots_per_inch) + ": ";
    const auto& words = device.words();
    ASSERT_GT(words.size(), 8U) << where;
    const double rounding = rounding_at(dots_per_inch);
    const QRectF whole(0, 0, size.width(), size.height() - covered);
    for (std::size_t i = 0; i < words.size(); ++i) {
        EXPECT_TRUE(whole.contains(words[i].place)) << where << words[i].words.toStdString();
        EXPECT_TRUE(words[i].whole) << where << "cut off: " << words[i].words.toStdString();
        for (std::size_t j = i + 1; j < words.size(); ++j) {
            const QRectF both = words[i].place & words[j].place;
            EXPECT_LE(std::min(both.width(), both.height()), rounding)
                << where << "'" << words[i].words.toStdString() << "' and '" << words[j].words.toStdString()
                << "'";
        }
        for (const QRectF& shape : device.shapes()) {
            const QRectF both = words[i].place & shape;
            EXPECT_LE(std::min(both.width(), both.height()), rounding)
                << where << "'" << words[i].words.toStdString() << "' on a bar at " << shape.top();
        }
    }
}

/// The debrief's picture at the smallest window, a wider one, the theatre's sizes.
const QSize sizes[] = {QSize(557, 360),  QSize(700, 400),  QSize(800, 480),  QSize(1000, 600),
                       QSize(1280, 720), QSize(1280, 800), QSize(1920, 1080)};
/// Text at 75, 100, 125, 150 and 200 % of the desktop's usual size.
const int text_scales[] = {72, 96, 120, 144, 192};

TEST(HudLayout, TextsOfEveryGoalKindDoNotOverlap) {
    for (const GoalType& type : goal_types) {
        Shown shown = everything(type.kind);
        for (const QSize size : sizes)
            for (const int scale : text_scales)
                expect_apart(shown, size, scale, std::string("goal-") + type.name);
    }
}

TEST(HudLayout, TextsAboveWhatCoversTheFootDoNotOverlap) {
    for (const GoalType& type : goal_types) {
        Shown shown = everything(type.kind);
        for (const QSize size : {QSize(1024, 630), QSize(1280, 660), QSize(960, 460)})
            for (const int scale : text_scales)
                for (const int covered : {40, 60, 200})
                    if (size.height() - covered >= hud_height_above)
                        expect_apart(shown, size, scale, std::string("above-") + type.name, covered);
    }
}

TEST(HudLayout, FollowsTheTextSizeOfTheWindow) {
    const auto painted = [](int dots_per_inch, int percent) {
        apply_text_size(*qApp, percent);
        Shown shown = everything(GoalKind::divide_line);
        shown.hud.task = &shown.task;
        WordsDevice device(QSize(1920, 1080), dots_per_inch);
        QPainter painter(&device);
        paint_hud(painter, QRectF(0, 0, 1920, 1080), shown.hud);
        painter.end();
        apply_text_size(*qApp, 100);
        return device.words();
    };
    const std::vector<PaintedWords> usual = painted(96, 100), large = painted(96, 150),
                                    desktop = painted(144, 100);
    ASSERT_EQ(large.size(), desktop.size());
    ASSERT_GT(large.size(), 8U);
    EXPECT_GT(large.front().place.height(), 1.4 * usual.front().place.height());
    for (std::size_t i = 0; i < large.size(); ++i) EXPECT_EQ(large[i].place, desktop[i].place);
}

// Each goal of each task with its texts, instruments, warnings and modes.
TEST(HudLayout, TextsOfEveryTaskDoNotOverlap) {
    const QString places[] = {QString(), QStringLiteral("demonstration: synthetic expert"),
                              QStringLiteral("replay ×0.25")};
    int goals = 0;
    for (const std::string& id : fulcrum::test::task_ids()) {
        const TaskDefinition task = load_task(fulcrum::test::source_path("assets/tasks/" + id + ".json"));
        for (std::size_t g = 0; g < task.goals.size(); ++g, ++goals) {
            for (const QString& place : places) {
                for (int warning = -1; warning <= 1; ++warning) {
                    Shown shown;
                    shown.task = task;
                    say_all(shown.hud);
                    HudState& hud = shown.hud;
                    hud.place = place;
                    hud.became_practice = warning == 0;
                    hud.assessed = warning == 1;
                    hud.shows_active_hand = place.isEmpty();
                    hud.active_hand = warning == 0 ? Hand::left : Hand::right;
                    const bool replay = place.startsWith(QLatin1String("replay"));
                    if (!replay) hud.health = QStringLiteral("12345 of 234567 ticks missed");
                    hud.display.goal = static_cast<std::int32_t>(g);
                    hud.display.traction_warning = static_cast<std::int8_t>(warning);
                    hud.display.distance_warning = warning == 0;
                    hud.display.cut_distance_m = 0.0123;
                    hud.display.traction_n_m = 123;
                    HandToolView tool;
                    tool.kind = warning < 0 ? InstrumentKind::scissors : InstrumentKind::clip_applier;
                    tool.clips_left = 10;
                    tool.exchange_left = 1.5F;
                    hud.tool[0] = hud.tool[1] = tool_words(tool);
                    for (const int scale : {text_scales[0], text_scales[4]})
                        for (const QSize size : {QSize(1280, 720), QSize(557, 360)})
                            if (replay || size.width() > 1000)
                                expect_apart(shown, size, scale,
                                             id + ("-" + std::to_string(g)) + "-" + std::to_string(warning) +
                                                 (place.isEmpty() ? "" : "-" + place.left(4).toStdString()));
                }
            }
        }
    }
    EXPECT_GE(goals, 12);
}

/// The hint at the instruments of both hands: whole, in the picture, on nothing else.
void expect_hints(Shown& shown, QSize size, const QString& words) {
    shown.hud.task = &shown.task;
    WordsDevice device(size);
    QPainter painter(&device);
    paint_hud(painter, QRectF(QPointF(0, 0), QSizeF(size)), shown.hud);
    painter.end();
    int hints = 0;
    for (const PaintedWords& hint : device.words()) {
        if (hint.words != words) continue;
        ++hints;
        EXPECT_TRUE(hint.whole) << words.toStdString();
        EXPECT_TRUE(QRectF(QPointF(0, 0), QSizeF(size)).contains(hint.place)) << words.toStdString();
        for (const PaintedWords& other : device.words()) {
            if (&other == &hint) continue;
            const QRectF both = hint.place & other.place;
            EXPECT_LE(std::min(both.width(), both.height()), rounding_at(96))
                << words.toStdString() << " on " << other.words.toStdString();
        }
    }
    EXPECT_EQ(hints, 2) << words.toStdString() << ", " << size.width() << " x " << size.height();
}

TEST(HudLayout, TheHintNamesTheKeysOfThePerson) {
    KeyMap longest = KeyMap::standard(false);
    longest.assign(KeyAction::jaws, Qt::Key_G);
    longest.assign(KeyAction::pedal, Qt::Key_Space);
    longest.assign(KeyAction::exchange, Qt::Key_Backspace);
    const KeyMap maps[] = {KeyMap::standard(false), KeyMap::standard(true), longest};
    const char* const english[] = {"T next · B pedal", "Y next · N pedal", "Backspace next · Space pedal"};
    const char* const german[] = {"T nächstes · B Pedal", "Y nächstes · N Pedal",
                                  "Rücktaste nächstes · Leertaste Pedal"};
    for (const Language language : {Language::english, Language::german}) {
        use_language(language);
        for (std::size_t i = 0; i < std::size(maps); ++i) {
            Shown shown = everything(GoalKind::divide_bands);
            shown.hud.next_key = maps[i].words(KeyAction::exchange);
            shown.hud.pedal_key = maps[i].words(KeyAction::pedal);
            const QString words = QString::fromUtf8(language == Language::english ? english[i] : german[i]);
            for (const QSize size : {QSize(1000, 600), QSize(1280, 720), QSize(1920, 1080)})
                expect_hints(shown, size, words);
        }
    }
    use_language(Language::english);
}

// A bar in newtons could be taken for what the hand feels, also where a controller rumbles.
TEST(HudLayout, SaysWhereForceIsShownAndNotFelt) {
    for (const bool felt : {false, true}) {
        Shown shown = everything(GoalKind::divide_line);
        shown.hud.task = &shown.task;
        shown.hud.force_felt = felt;
        WordsDevice device(QSize(1280, 720));
        QPainter painter(&device);
        paint_hud(painter, QRectF(0, 0, 1280, 720), shown.hud);
        painter.end();
        QString words;
        for (const PaintedWords& painted : device.words()) words += painted.words + QLatin1Char('\n');
        EXPECT_TRUE(words.contains("2.4 N")) << words.toStdString();
        EXPECT_EQ(words.contains("force is shown, not felt"), !felt) << words.toStdString();
    }
}

TEST(HudLayout, ForcesKeepTheirPlaceWhenAWarningAppears) {
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
}  // namespace fulcrum::ui::window_test
