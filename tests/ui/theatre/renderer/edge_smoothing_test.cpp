// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/edge_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace fulcrum::ui {
namespace {

constexpr int picture_side = 96;

/// White with mark 0 where `inside` is true at the pixel's centre, otherwise black with mark 255. Bottom row
/// first.
QImage drawn(const std::function<double(double, double)>& inside) {
    QImage image(picture_side, picture_side, QImage::Format_RGB32);
    for (int y = 0; y < picture_side; ++y) {
        for (int x = 0; x < picture_side; ++x) {
            auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
            row[x] = inside(x + 0.5, y + 0.5) > 0 ? 0x00ffffffU : 0xff000000U;
        }
    }
    return image;
}

/// Mean difference, 0 .. 255, of a picture from the exact coverage, over the pixels that the edge crosses.
double error_along_edge(const QImage& shown, const std::function<double(double, double)>& inside) {
    constexpr int samples = 16;
    double sum = 0;
    int count = 0;
    for (int y = 2; y < picture_side - 2; ++y) {
        for (int x = 2; x < picture_side - 2; ++x) {
            int covered = 0;
            for (int k = 0; k < samples * samples; ++k)
                covered += inside(x + (k % samples + 0.5) / samples, y + (k / samples + 0.5) / samples) > 0;
            if (covered == 0 || covered == samples * samples) continue;
            const int value = qRed(shown.pixel(x, picture_side - 1 - y));
            sum += std::abs(value - 255.0 * covered / (samples * samples));
            ++count;
        }
    }
    return sum / count;
}

TEST(EdgeSmoothing, ReducesTheErrorOfSlantedAndRoundEdgesByTwoFifths) {
    const std::function<double(double, double)> shapes[] = {
        [](double x, double y) { return y - 20 - x / 7; },
        [](double x, double y) { return x - 30 + y / 5; },
        [](double x, double y) { return 40 - x - 0.4 * y; },
        [](double x, double y) { return 30 - std::hypot(x - 48, y - 48); },
    };
    for (const auto& shape : shapes) {
        const QImage raw = drawn(shape);
        QImage plain(picture_side, picture_side, QImage::Format_RGB32),
            smooth(picture_side, picture_side, QImage::Format_RGB32);
        copy_upright(raw, plain);
        copy_with_smooth_edges(raw, smooth);
        EXPECT_LT(error_along_edge(smooth, shape), 0.6 * error_along_edge(plain, shape));
    }
}

TEST(EdgeSmoothing, DoesNotChangeStraightEdgesAndUnmarkedContrast) {
    const auto half = [](double x, double) { return 48 - x; };
    const QImage raw = drawn(half);
    QImage plain(picture_side, picture_side, QImage::Format_RGB32),
        smooth(picture_side, picture_side, QImage::Format_RGB32);
    copy_upright(raw, plain);
    copy_with_smooth_edges(raw, smooth);
    EXPECT_EQ(smooth, plain);
    // Two tissues: the same mark on both sides of a slanted edge.
    QImage tissue = drawn([](double x, double y) { return y - 20 - x / 7; });
    for (int y = 0; y < picture_side; ++y) {
        for (int x = 0; x < picture_side; ++x) reinterpret_cast<QRgb*>(tissue.scanLine(y))[x] |= 0xff000000U;
    }
    copy_upright(tissue, plain);
    copy_with_smooth_edges(tissue, smooth);
    EXPECT_EQ(smooth, plain);
}

TEST(EdgeSmoothing, TurnsThePictureUprightAndMakesItOpaque) {
    QImage raw = drawn([](double, double y) { return 10 - y; });
    QImage shown(picture_side, picture_side, QImage::Format_RGB32);
    copy_with_smooth_edges(raw, shown);
    EXPECT_EQ(shown.pixel(5, picture_side - 1), 0xffffffffU);
    EXPECT_EQ(shown.pixel(5, 0), 0xff000000U);
    for (int y = 0; y < picture_side; ++y) {
        for (int x = 0; x < picture_side; ++x)
            EXPECT_EQ(reinterpret_cast<const QRgb*>(shown.constScanLine(y))[x] >> 24U, 0xffU);
    }
}

}  // namespace
}  // namespace fulcrum::ui
