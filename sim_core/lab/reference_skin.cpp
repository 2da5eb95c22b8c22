// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/reference_skin.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::lab {
BowelSkin make_skin(double length, double mean_radius, double spacing, int sections, int around,
                    const TubeRadius& radius) {
    TriangleMesh mesh = make_tube(length, sections, around, radius);
    const SphereChain spheres =
        sample_spheres(length, spacing, [mean_radius](double) { return mean_radius; });
    Cage cage = build_cage(mesh, length, spheres);
    return BowelSkin(std::move(mesh), std::move(cage));
}

std::vector<RingFrame> bent_frames(const Cage& cage, double bend_radius) {
    std::vector<RingFrame> frames(static_cast<std::size_t>(cage.rings()));
    ring_frames(
        cage,
        [bend_radius](double s) {
            const double angle = s / bend_radius;
            RingFrame frame;
            frame.position =
                Vector3(bend_radius * std::sin(angle), bend_radius * (1.0 - std::cos(angle)), 0.0);
            frame.rotation.col(0) = Vector3(-std::sin(angle), std::cos(angle), 0.0);
            frame.rotation.col(1) = Vector3::UnitZ();
            frame.rotation.col(2) = Vector3(std::cos(angle), std::sin(angle), 0.0);
            return frame;
        },
        frames.data());
    return frames;
}

std::vector<RingFrame> twisted_frames(const Cage& cage, double rate) {
    std::vector<RingFrame> frames(static_cast<std::size_t>(cage.rings()));
    ring_frames(
        cage,
        [rate](double s) {
            RingFrame frame = rest_frame(s);
            const double c = std::cos(rate * s), n = std::sin(rate * s);
            frame.rotation.col(0) = Vector3(0.0, c, n);
            frame.rotation.col(1) = Vector3(0.0, -n, c);
            return frame;
        },
        frames.data());
    return frames;
}

std::vector<RingFrame> quarter_bend_frames(const Cage& cage, double bend_radius) {
    constexpr double pi = 3.14159265358979323846;
    std::vector<RingFrame> frames(static_cast<std::size_t>(cage.rings()));
    const double begin = 0.5 * (cage.length - 0.5 * pi * bend_radius), end = begin + 0.5 * pi * bend_radius;
    ring_frames(
        cage,
        [&](double s) {
            const double along = std::clamp(s, begin, end) - begin, angle = along / bend_radius;
            const Vector3 tangent(std::cos(angle), std::sin(angle), 0.0);
            RingFrame frame;
            frame.position =
                Vector3(begin + bend_radius * std::sin(angle), bend_radius * (1.0 - std::cos(angle)), 0.0);
            if (s < begin) frame.position = Vector3(s, 0.0, 0.0);
            if (s > end) frame.position += (s - end) * tangent;
            frame.rotation.col(0) = Vector3(-std::sin(angle), std::cos(angle), 0.0);
            frame.rotation.col(1) = Vector3::UnitZ();
            frame.rotation.col(2) = tangent;
            return frame;
        },
        frames.data());
    return frames;
}

std::vector<RingFrame> rest_frames(const Cage& cage) {
    std::vector<RingFrame> frames(static_cast<std::size_t>(cage.rings()));
    ring_frames(
        cage, [](double s) { return rest_frame(s); }, frames.data());
    return frames;
}

}  // namespace fulcrum::lab
