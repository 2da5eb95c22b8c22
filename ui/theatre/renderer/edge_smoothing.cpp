// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/edge_smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum::ui {
namespace {

constexpr std::uint32_t kind_bits = 0xff000000U;

std::uint32_t mix(std::uint32_t own, std::uint32_t other, double share) {
    const auto weight = static_cast<std::uint32_t>(256 * share);
    std::uint32_t mixed = kind_bits;
    for (int shift = 0; shift < 24; shift += 8) {
        const std::uint32_t a = (own >> shift) & 0xffU, b = (other >> shift) & 0xffU;
        mixed |= ((a * (256 - weight) + b * weight) >> 8U) << static_cast<std::uint32_t>(shift);
    }
    return mixed;
}

/// Two neighbouring lines of pixels, rows or columns, and where each is shown.
struct Lines {
    const std::uint32_t *near, *far;  ///< as drawn
    std::uint32_t *near_shown, *far_shown;
    std::ptrdiff_t step, shown_step;  ///< from one pixel of a line to the next
    int length;

    std::uint32_t near_kind(int i) const { return near[i * step] & kind_bits; }
    std::uint32_t far_kind(int i) const { return far[i * step] & kind_bits; }
    bool edge(int i) const { return ((near[i * step] ^ far[i * step]) & kind_bits) != 0; }
};

/// Where the edge leaves a run of steps at one of its ends: +0.5 into the far line, -0.5 into the near one, 0
/// not at all.
double leaves(const Lines& lines, int inside, int outside) {
    if (outside < 0 || outside >= lines.length || lines.edge(outside)) return 0;
    const std::uint32_t kind = lines.near_kind(outside);
    if (kind == lines.near_kind(inside)) return 0.5;
    if (kind == lines.far_kind(inside)) return -0.5;
    return 0;
}

void give(const Lines& lines, int i, double area) {
    const std::uint32_t near = lines.near[i * lines.step], far = lines.far[i * lines.step];
    std::uint32_t& shown =
        area > 0 ? lines.far_shown[i * lines.shown_step] : lines.near_shown[i * lines.shown_step];
    shown = mix(shown, area > 0 ? near : far, std::min(std::abs(area), 0.5));
}

/// The edge between `first` and `last` is a straight line from each of its ends to the middle of the run.
void smooth_run(const Lines& lines, int first, int last) {
    const double begin = leaves(lines, first, first - 1), end = leaves(lines, last, last + 1);
    if (begin == 0 && end == 0) return;
    const double length = last - first + 1, middle = 0.5 * length;
    for (int i = first; i <= last; ++i) {
        const double from = i - first, to = from + 1;
        // Area between the line and the boundary of the pixels, left and right of the middle.
        if (begin != 0 && from < middle) {
            const double until = std::min(to, middle);
            give(lines, i, begin * (until - from) * (1 - (from + until) / length));
        }
        if (end != 0 && to > middle) {
            const double since = std::max(from, middle);
            give(lines, i, end * (to - since) * ((since + to) / length - 1));
        }
    }
}

void smooth(const Lines& lines) {
    for (int i = 0; i < lines.length;) {
        if (!lines.edge(i)) {
            ++i;
            continue;
        }
        const int first = i;
        const std::uint32_t near = lines.near_kind(i), far = lines.far_kind(i);
        while (i + 1 < lines.length && lines.near_kind(i + 1) == near && lines.far_kind(i + 1) == far) ++i;
        smooth_run(lines, first, i);
        ++i;
    }
}

const std::uint32_t* drawn_row(const QImage& drawn, int row) {
    return reinterpret_cast<const std::uint32_t*>(drawn.constScanLine(row));
}

std::uint32_t* shown_row(QImage& shown, int row) {
    return reinterpret_cast<std::uint32_t*>(shown.scanLine(shown.height() - 1 - row));
}

}  // namespace

void copy_upright(const QImage& drawn, QImage& shown) {
    for (int row = 0; row < drawn.height(); ++row) {
        const std::uint32_t* from = drawn_row(drawn, row);
        std::uint32_t* to = shown_row(shown, row);
        for (int x = 0; x < drawn.width(); ++x) to[x] = from[x] | kind_bits;
    }
}

void copy_with_smooth_edges(const QImage& drawn, QImage& shown) {
    copy_upright(drawn, shown);
    const int width = drawn.width(), height = drawn.height();
    if (width < 2 || height < 2) return;
    // Columns that have an edge next to them at all: most have none.
    std::vector<std::uint32_t> differs(static_cast<std::size_t>(width), 0);
    for (int row = 0; row < height; ++row) {
        const std::uint32_t* line = drawn_row(drawn, row);
        for (int x = 0; x + 1 < width; ++x) differs[static_cast<std::size_t>(x)] |= line[x] ^ line[x + 1];
        if (row + 1 == height) break;
        const std::uint32_t* next = drawn_row(drawn, row + 1);
        std::uint32_t any = 0;
        for (int x = 0; x < width; ++x) any |= line[x] ^ next[x];
        if ((any & kind_bits) == 0) continue;
        smooth({line, next, shown_row(shown, row), shown_row(shown, row + 1), 1, 1, width});
    }
    const std::ptrdiff_t step = drawn.bytesPerLine() / 4, shown_step = -(shown.bytesPerLine() / 4);
    const std::uint32_t* lowest = drawn_row(drawn, 0);
    std::uint32_t* lowest_shown = shown_row(shown, 0);
    for (int x = 0; x + 1 < width; ++x) {
        if ((differs[static_cast<std::size_t>(x)] & kind_bits) == 0) continue;
        smooth(
            {lowest + x, lowest + x + 1, lowest_shown + x, lowest_shown + x + 1, step, shown_step, height});
    }
}

}  // namespace fulcrum::ui
