// SPDX-License-Identifier: Apache-2.0
// The rectum in the sacral hollow: a tube that follows an arc in the median plane, and concentric with it the
// presacral fascia as a smooth wall. Objects in the hollow (septa, veins, nerves) are placed with
// SacralCurve. Pure functions, as in anatomy.h; m, rad, patient frame.
#pragma once

#include <cstdint>

#include "sim_core/anatomy/anatomy.h"

namespace fulcrum {

/// Curved coordinates of the sacral hollow.
struct SacralCurve {
    Vector3 centre = Vector3::Zero();  ///< m, of the arc
    double curve_radius = 0;           ///< m, of the rectum's centre line about `centre`
    double caudal_angle = 0;           ///< rad on the arc, where s = 0; 0 is directly posterior to the centre
    double rectum_radius = 0;          ///< m, of the muscularis
    double gap = 0;                    ///< m, from the muscularis to the fascia

    double fascia_radius() const { return rectum_radius + gap; }  ///< m, about the rectum's centre line
    double angle(double s) const { return caudal_angle + s / curve_radius; }
    double arc_length(double angle) const { return curve_radius * (angle - caudal_angle); }  ///< m
    Vector3 posterior(double s) const;  ///< unit, from the centre line to the fascia
    Vector3 cranial(double s) const;    ///< unit, along the centre line, direction of increasing s
    Vector3 centre_line(double s) const;
    /// m. s along the rectum's centre line from the levator; turn: about it, from posterior, positive to the
    /// patient's left; height above the fascia, towards the rectum (the muscularis is at `gap`).
    Vector3 point(double s, double turn, double height) const;
};

struct RectumParameters {
    SacralCurve curve;
    double length = 0.14;      ///< m, of the rectum, 0.05 .. 0.3
    double promontory = 0.12;  ///< m along the rectum, where the wall leaves the curve and slopes posteriorly
    int vertices = 3000;       ///< requested, 200 .. 200000; the generator rounds
    double unevenness = 4e-4;  ///< m, largest depth of the wall below the fascia, 0 .. 0.003
    std::uint64_t seed = 1;
};

/// The tube at rest and its centre line in the hollow, s = 0 at the levator. No root line, no taeniae. Throws
/// InputError.
BowelShape make_rectum(const RectumParameters& parameters);

/// The presacral wall, an open trough whose triangles face the rectum (FreeSide::front). Lateral to the
/// hollow it continues to the sides, above the promontory straight on, sloping posteriorly, so that
/// instruments from the abdomen approach it from the front. Throws InputError.
TriangleMesh make_presacral_wall(const RectumParameters& parameters);

}  // namespace fulcrum
