// SPDX-License-Identifier: GPL-3.0-or-later
// Colours as people with a colour vision deficiency see them.
#pragma once

#include <QColor>
#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum::ui::window_test {

/// Machado, Oliveira and Fernandes 2009: complete protanopia, deuteranopia, tritanopia.
inline constexpr std::array<std::array<double, 9>, 3> deficient_sights = {{
    {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998},
    {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881},
    {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900},
}};

/// Distance in RGB, whose axes are 1 long, as that sight has it.
inline double apart(const std::array<double, 9>& sight, const QColor& a, const QColor& b) {
    const double d[] = {a.redF() - b.redF(), a.greenF() - b.greenF(), a.blueF() - b.blueF()};
    double sum = 0;
    for (std::size_t row = 0; row < 3; ++row) {
        double one = 0;
        for (std::size_t column = 0; column < 3; ++column) one += sight[3 * row + column] * d[column];
        sum += one * one;
    }
    return std::sqrt(sum);
}

/// For the sight that tells them apart worst.
inline double least_apart(const QColor& a, const QColor& b) {
    double least = 2;
    for (const auto& sight : deficient_sights) least = std::min(least, apart(sight, a, b));
    return least;
}

}  // namespace fulcrum::ui::window_test
