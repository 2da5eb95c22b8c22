// SPDX-License-Identifier: GPL-3.0-or-later
// Colours that mean different things, and are next to each other, differ for people with a colour vision
// deficiency in both themes; standings also differ by shape alone. A theme that is switched reaches each
// widget once.
#include "ui/style/palette.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDateEdit>
#include <QDialog>
#include <QEvent>
#include <QFrame>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QVBoxLayout>
#include <QtTest>
#include <vector>

#include "tests/ui/colour_vision.h"
#include "ui/style/standing_badge.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui::window_test {
namespace {

struct ColourPair {
    const char* names;
    QColor Palette::*one;
    QColor Palette::*other;
};
constexpr ColourPair pairs_that_differ[] = {
    {"left and right hand", &Palette::left_hand, &Palette::right_hand},
    {"good and bad", &Palette::good, &Palette::bad},
    {"good and warning", &Palette::good, &Palette::warning},
    {"bad and warning", &Palette::bad, &Palette::warning},
    {"good and neutral", &Palette::good, &Palette::neutral},
    {"bad and neutral", &Palette::bad, &Palette::neutral},
    {"warning and neutral", &Palette::warning, &Palette::neutral},
    // A line over traces of both hands, over bars of passed and failed attempts, over the experts' range.
    {"limit and left hand", &Palette::limit, &Palette::left_hand},
    {"limit and right hand", &Palette::limit, &Palette::right_hand},
    {"limit and good", &Palette::limit, &Palette::good},
    {"limit and bad", &Palette::limit, &Palette::bad},
    {"limit and neutral", &Palette::limit, &Palette::neutral},
};

TEST(Colours, ThatMeanDifferentThingsDifferForPeopleWithAColourVisionDeficiency) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        const Palette& palette = palette_of(theme);
        for (const ColourPair& pair : pairs_that_differ)
            EXPECT_GE(least_apart(palette.*pair.one, palette.*pair.other), 0.2)
                << pair.names << (theme == Theme::light ? ", light" : ", dark");
    }
}

/// Where a standing's sign has ink, whatever its colour.
std::vector<bool> ink_of(const TaskStanding& standing) {
    constexpr int side = 64;
    QImage picture(side, side, QImage::Format_RGB32);
    picture.fill(colours().card);
    QPainter painter(&picture);
    paint_standing(painter, QRectF(0, 0, side, side), standing);
    painter.end();
    std::vector<bool> ink;
    const QColor ground = colours().card;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const QColor here = picture.pixelColor(x, y);
            ink.push_back(std::abs(here.red() - ground.red()) + std::abs(here.green() - ground.green()) +
                              std::abs(here.blue() - ground.blue()) >
                          120);
        }
    return ink;
}

TEST(Colours, OfStandingsAreNeededByNobodyBecauseTheirShapesDiffer) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        apply_theme(*qApp, theme);
        std::vector<std::vector<bool>> inks;
        for (const auto& row : standing_names) {
            TaskStanding one;
            one.standing = row.kind;
            inks.push_back(ink_of(one));
        }
        for (std::size_t a = 0; a < inks.size(); ++a)
            for (std::size_t b = a + 1; b < inks.size(); ++b) {
                std::size_t differ = 0;
                for (std::size_t i = 0; i < inks[a].size(); ++i) differ += inks[a][i] != inks[b][i] ? 1 : 0;
                EXPECT_GE(differ, inks[a].size() / 50)
                    << standing_names[a].name << " and " << standing_names[b].name
                    << (theme == Theme::light ? ", light" : ", dark");
            }
    }
    apply_theme(*qApp, Theme::light);
}

/// Counts how often it is given its style.
class StyledLabel : public QLabel {
  public:
    using QLabel::QLabel;
    int times = 0;

  protected:
    void changeEvent(QEvent* event) override {
        if (event->type() == QEvent::StyleChange) ++times;
        QLabel::changeEvent(event);
    }
};

TEST(ThemeSwitch, StylesEachWidgetOnceHoweverManyAreAroundIt) {
    apply_theme(*qApp, Theme::light);
    QWidget window;
    QWidget* around = &window;
    for (int depth = 0; depth < 8; ++depth) {
        auto* frame = new QFrame(around);
        frame->setProperty("role", "card");
        around = frame;
    }
    auto* label = new StyledLabel(QStringLiteral("words"), around);
    label->setProperty("role", "muted");
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    EXPECT_EQ(label->palette().color(QPalette::WindowText), palette_of(Theme::light).muted);
    label->times = 0;
    apply_theme(*qApp, Theme::dark);
    EXPECT_EQ(label->times, 1);
    EXPECT_EQ(label->palette().color(QPalette::WindowText), palette_of(Theme::dark).muted);
    apply_theme(*qApp, Theme::light);
    EXPECT_EQ(label->times, 2);
    EXPECT_EQ(label->palette().color(QPalette::WindowText), palette_of(Theme::light).muted);
}

TEST(StyleSheet, AFieldForADayShowsTheKeyboardAsOtherFieldsDo) {
    apply_theme(*qApp, Theme::light);
    QWidget window;
    auto* column = new QVBoxLayout(&window);
    auto* day = new QDateEdit;
    day->setCalendarPopup(true);
    auto* words = new QLineEdit;
    column->addWidget(day);
    column->addWidget(words);
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    const auto edge = [](QWidget* field) {
        return field->grab().toImage().pixelColor(0, field->height() / 2).name().toStdString();
    };
    for (QWidget* field : {static_cast<QWidget*>(day), static_cast<QWidget*>(words)}) {
        field->setFocus();
        EXPECT_EQ(edge(field), palette_of(Theme::light).accent.name().toStdString());
    }
    EXPECT_EQ(edge(day), palette_of(Theme::light).line.name().toStdString());
}

TEST(ThemeSwitch, ReachesWhatIsHiddenWithTheRoleAndTheSizeOfTextThatAreInForce) {
    apply_theme(*qApp, Theme::light);
    QWidget window, never_shown;
    QDialog dialog(&window);
    std::vector<QLabel*> labels;
    for (QWidget* place : {&window, &never_shown, static_cast<QWidget*>(&dialog)}) {
        labels.push_back(new QLabel(QStringLiteral("words"), place));
        labels.back()->setProperty("role", "muted");
        labels.back()->ensurePolished();
    }
    auto* title = new QLabel(QStringLiteral("words"), &never_shown);
    title->setProperty("role", "title");
    title->ensurePolished();
    EXPECT_DOUBLE_EQ(title->font().pointSizeF(), 20);
    const auto shown = [](const QLabel* label) { return label->palette().color(QPalette::WindowText); };
    apply_theme(*qApp, Theme::dark);
    for (const QLabel* label : labels) EXPECT_EQ(shown(label), palette_of(Theme::dark).muted);
    set_role(labels[1], "good");
    EXPECT_EQ(shown(labels[1]), palette_of(Theme::dark).good);
    apply_theme(*qApp, Theme::light);
    EXPECT_EQ(shown(labels[0]), palette_of(Theme::light).muted);
    EXPECT_EQ(shown(labels[1]), palette_of(Theme::light).good);
    EXPECT_EQ(shown(labels[2]), palette_of(Theme::light).muted);
    apply_text_size(*qApp, 200);
    EXPECT_DOUBLE_EQ(title->font().pointSizeF(), 40);
    EXPECT_EQ(shown(labels[2]), palette_of(Theme::light).muted);
    apply_text_size(*qApp, 100);
    EXPECT_DOUBLE_EQ(title->font().pointSizeF(), 20);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
