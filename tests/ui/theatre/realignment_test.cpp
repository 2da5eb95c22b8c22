// SPDX-License-Identifier: GPL-3.0-or-later
// The box that leads the instruments back after a device was lost: nothing of it is cut off in any language,
// and it is as large as the text that the person chose.
#include "ui/theatre/realignment.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QPainter>

#include "tests/ui/painted_words.h"
#include "ui/language/language.h"
#include "ui/style/palette.h"

namespace fulcrum::ui::window_test {
namespace {

class RealignmentBox : public ::testing::Test {
  protected:
    ~RealignmentBox() override {
        use_language(Language::english);
        apply_text_size(*qApp, 100);
    }
    static std::vector<PaintedWords> words_of_box(bool in_place, QSize size, int dots_per_inch) {
        Realignment shown;
        shown.back = true;
        shown.in_place = in_place;
        for (Realignment::OneHand& one : shown.hand) {
            one.exists = true;
            one.in_place = in_place;
            one.distance = 0.123;
            one.angle = 2.5;
        }
        WordsDevice device(size, dots_per_inch);
        QPainter painter(&device);
        paint_realignment(painter, QRectF(QPointF(0, 0), QSizeF(size)), shown);
        painter.end();
        return device.words();
    }
};

TEST_F(RealignmentBox, CutsNothingOffInAnyLanguageAtAnySize) {
    for (const Language language : {Language::english, Language::german}) {
        use_language(language);
        for (const QSize size : {QSize(960, 460), QSize(1024, 630), QSize(1280, 720), QSize(1920, 1080)})
            for (const int dots_per_inch : {96, 144, 192})
                for (const bool in_place : {false, true}) {
                    const auto words = words_of_box(in_place, size, dots_per_inch);
                    EXPECT_GE(words.size(), 4U);
                    for (const PaintedWords& one : words) {
                        EXPECT_TRUE(one.whole) << one.words.toStdString() << ", " << size.width();
                        EXPECT_TRUE(QRectF(QPointF(0, 0), QSizeF(size)).contains(one.place))
                            << one.words.toStdString() << ", " << size.width();
                    }
                }
    }
}

TEST_F(RealignmentBox, IsLargeWhereTheTextIs) {
    const auto usual = words_of_box(false, {1280, 720}, 96);
    apply_text_size(*qApp, 200);
    const auto large = words_of_box(false, {1280, 720}, 96);
    ASSERT_FALSE(usual.empty() || large.empty());
    EXPECT_GT(large.front().place.height(), 1.5 * usual.front().place.height());
}

}  // namespace
}  // namespace fulcrum::ui::window_test
