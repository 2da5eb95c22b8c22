// SPDX-License-Identifier: GPL-3.0-or-later
// Pathology reports of constructed cuts, for tests of screens and paper.
#pragma once

#include <functional>
#include <vector>

#include "assessment/pathology/pathology.h"

namespace fulcrum::ui::window_test {

/// Four levels of 60 mm with a tumour at the second level; tolerance 2 mm.
inline SpecimenPlan specimen_plan() {
    constexpr double mm = 1e-3;
    return {4,      60 * mm, 20 * mm,
            3 * mm, 6 * mm,  18 * mm,
            2 * mm, 10 * mm, Tumour{1, Sector::mid, 8 * mm, 12 * mm}};
}

/// Cut in elements of 1 mm over the first `length` mm of the line; `distance(mm)` is the signed distance in
/// mm at a place on the line.
inline PathologyReport specimen(const std::function<double(int)>& distance, int length = 240) {
    constexpr double mm = 1e-3;
    std::vector<CutStroke> strokes(1);
    for (int i = 0; i < length; ++i) {
        CutElement e;
        e.begin = 0.1 * i;
        e.end = e.begin + 0.1;
        e.from = i * mm;
        e.to = (i + 1) * mm;
        e.from_distance = e.distance = distance(i) * mm;
        e.length = mm;
        strokes[0].elements.push_back(e);
    }
    return pathology_report(strokes, specimen_plan());
}

/// Level 1 in the plane; level 2 in part too deep; level 3 with a defect of 6 mm on the left; level 4 too
/// shallow. `length` below 240 leaves the rest undivided.
inline PathologyReport varied_specimen(int length = 240) {
    return specimen(
        [](int at) {
            if (at >= 165 && at < 175) return -9.0;
            if (at >= 60 && at < 80) return 5.0;
            if (at >= 80 && at < 100) return 3.0;
            if (at >= 200) return -2.8;
            return 0.4;
        },
        length);
}

}  // namespace fulcrum::ui::window_test
