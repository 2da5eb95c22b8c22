// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/scope_picture.h"

#include <gtest/gtest.h>

namespace fulcrum::ui {
namespace {

QImage painted(QSize size, int side) {
    QImage white(side, side, QImage::Format_RGB32), canvas(size, QImage::Format_RGB32);
    white.fill(Qt::white);
    canvas.fill(Qt::green);
    QPainter painter(&canvas);
    ScopePicture scope;
    scope.paint(painter, canvas.rect(), white);
    return canvas;
}

TEST(ScopePicture, ARoundImageInABlackFrameDarkerTowardsItsRim) {
    const QImage image = painted(QSize(400, 200), 90);
    const auto grey = [&image](int x, int y) { return qGray(image.pixel(x, y)); };
    EXPECT_EQ(grey(200, 100), 255);
    for (const QPoint& outside :
         {QPoint(0, 0), QPoint(99, 100), QPoint(300, 100), QPoint(399, 199), QPoint(104, 4)})
        EXPECT_EQ(image.pixel(outside), qRgb(0, 0, 0)) << outside.x();
    EXPECT_LT(grey(200 + 92, 100), 200);
    EXPECT_GT(grey(200 + 92, 100), 100);
    EXPECT_EQ(grey(200 + 55, 100), 255);  // the centre is not darkened
    EXPECT_NEAR(grey(200 - 80, 100), grey(200 + 79, 100), 1);
}

TEST(ScopePicture, ANotchMarksUp) {
    const QImage image = painted(QSize(400, 400), 100);
    EXPECT_EQ(qGray(image.pixel(200, 5)), 0);
    EXPECT_GT(qGray(image.pixel(200, 394)), 50);
}

TEST(ScopePicture, AreasOfAPixelArePainted) {
    EXPECT_NE(painted(QSize(1, 1), 4).pixel(0, 0), qRgb(0, 255, 0));
    const QImage flat = painted(QSize(40, 1), 4);
    EXPECT_EQ(flat.pixel(0, 0), qRgb(0, 0, 0));
    EXPECT_EQ(flat.pixel(39, 0), qRgb(0, 0, 0));
}

}  // namespace
}  // namespace fulcrum::ui
