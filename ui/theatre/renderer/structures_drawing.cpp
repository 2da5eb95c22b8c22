// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/structures_drawing.h"

namespace fulcrum::ui {

void StructuresDrawing::add(const StructuresView& view, SceneFrame& frame) {
    constexpr double shown = 0.85;  // of its radius: the rest lies beneath
    veins_.begin(view.veins.size());
    for (const VeinView& vein : view.veins) {  // they shine through the wall, blue
        Ribbon& blue = veins_.next();
        blue.cord(vein.line, shown * vein.radius);
        frame.sheets.push_back(blue.drawn(0, QVector3D(0.07F, 0.12F, 0.40F), 0.85F));
    }
}

}  // namespace fulcrum::ui
