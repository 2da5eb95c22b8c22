// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/cups_drawing.h"

#include <cmath>

namespace fulcrum::ui {
namespace {

// As painted, sRGB: the rim differs from the wall by brightness alone.
const QVector3D wall_hue(0.30F, 0.36F, 0.44F), rim_hue(0.80F, 0.83F, 0.86F);
constexpr int staves = 20;
constexpr double pi = 3.14159265358979323846;

}  // namespace

void CupsDrawing::add(const CameraTargetsView& view, SceneFrame& frame) const {
    if (view.targets.empty()) return;
    // Staves that overlap close the wall; the wall's middle is between its inner and outer side.
    const double radius = view.cup_radius + 0.5 * view.wall;
    const double stave = std::max(0.5 * view.wall, 1.1 * radius * std::sin(pi / staves));
    const double rim = 1.12 * stave;  // covers the staves' ends
    for (const CameraTarget& cup : view.targets) {
        const Vector3 across = cup.axis.unitOrthogonal(), third = cup.axis.cross(across);
        const Vector3 bottom = cup.ball - view.ball_radius * cup.axis;
        const auto around = [&](int i) {
            const double angle = 2 * pi * i / staves;
            return Vector3(radius * (std::cos(angle) * across + std::sin(angle) * third));
        };
        for (int i = 0; i < staves; ++i) {
            frame.tubes.push_back(
                {bottom + around(i), cup.mouth - stave * cup.axis + around(i), stave, wall_hue, -1});
            frame.tubes.push_back(
                {cup.mouth + around(i), cup.mouth + around((i + 1) % staves), rim, rim_hue, -1});
        }
    }
}

}  // namespace fulcrum::ui
