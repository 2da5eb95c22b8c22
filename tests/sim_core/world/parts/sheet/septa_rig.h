// SPDX-License-Identifier: Apache-2.0
// Two hands at the plane behind the rectum: the left grasps and lifts the rectum, the right moves a hook
// along a septum.
#pragma once

#include "sim_core/anatomy/scene_anatomy.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum::test {

inline Scene septa_scene() {
    return load_scene(source_path("assets/scenes/c4_posterior.json"));
}

struct SeptaRig : SheetRig {
    SacralCurve curve;

    explicit SeptaRig(const Scene& chosen = septa_scene())
        : SheetRig(chosen), curve(rectum_parameters(scene).curve) {}
    const SheetView& view() const { return world.snapshot().sheet; }
    /// m along the rectum, of a septum.
    double arc_length(int septum) const {
        return sheet().layout().arc_lengths[static_cast<std::size_t>(septum)];
    }
    /// A fraction of a septum's line in its present shape, `before` m cranially of it.
    Vector3 on_line(int septum, double share, double before) const {
        const auto count = view().line.size() / static_cast<std::size_t>(scene.septa->count);
        const double at =
            std::clamp(share * static_cast<double>(count) - 0.5, 0.0, static_cast<double>(count) - 1);
        const auto i = std::min(static_cast<std::size_t>(at), count - 2);
        const std::size_t first = static_cast<std::size_t>(septum) * count + i;
        const Vector3 step = view().line[first + 1] - view().line[first];
        const Vector3 here =
            view().line[first] + (share * static_cast<double>(count) - 0.5 - static_cast<double>(i)) * step;
        return here + before * curve.cranial(arc_length(septum));
    }
    /// N/m, mean over a septum's line.
    double traction(int septum) const {
        const auto count = view().line_traction.size() / static_cast<std::size_t>(scene.septa->count);
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i)
            sum += view().line_traction[static_cast<std::size_t>(septum) * count + i];
        return sum / static_cast<double>(count);
    }
    /// m, the rectum's front near the first septum.
    Vector3 front() const {
        const double s = arc_length(0) + 0.006;
        return curve.centre_line(s) - curve.rectum_radius * curve.posterior(s);
    }
    Vector3 lifted(double by) const {
        return front() +
               by * (0.3 * curve.cranial(arc_length(0)) - curve.posterior(arc_length(0))).normalized();
    }
    void take_rectum() {
        go(0, tip_for(front() + Vector3(0, 0, 0.02)), 0.2);
        go(0, tip_for(front() + Vector3(0, 0, 0.003)), 0.1);
        wish[0].closed = true;
        steps(40);
    }
    void lift(double by) {
        go(0, tip_for(lifted(by)), 0.04);
        steps(60);
    }
    /// The hook placed on a septum at fraction `from` of its line, pressed in and moved to `to`, 5 mm behind
    /// the line.
    void divide(int septum, double from, double to, double speed = 0.03) {
        set_on(septum, from);
        wish[1].button = true;
        go(1, on_line(septum, from + 0.1, -0.006), 0.03);
        draw(septum, from + 0.1, to, speed);
    }
    /// Where the approach through the plane passes a septum, 4 mm cranially of it.
    Vector3 pass(int septum, double share, double height) const {
        const double turn =
            (share - 0.5) * scene.septa->width / (curve.fascia_radius() - scene.septa->plane_height);
        return curve.point(arc_length(septum) + 0.004, turn, height);
    }
    /// Through the divided part, then onto the line.
    void set_on(int septum, double share) {
        const Vector3 mouth = pass(0, share, 0.0045);
        go(1, mouth + 0.07 * (trocar[1].position - mouth).normalized(), 0.2);
        for (int k = 0; k <= septum; ++k) go(1, pass(k, share, k < septum ? 0.0045 : 0.003), 0.1);
    }
    void draw(int septum, double from, double to, double speed) {
        for (double share = from; share < to; share += 0.02) go(1, on_line(septum, share, -0.005), speed);
    }
    void withdraw(int septum = 0, double share = 0.8) {
        wish[1].button = false;
        steps(4);
        for (int k = septum; k >= 0; --k) go(1, pass(k, share, 0.0045), 0.1);
        go(1, wish[1].tip + 0.07 * (trocar[1].position - wish[1].tip).normalized(), 0.2);
    }
};

}  // namespace fulcrum::test
