// SPDX-License-Identifier: Apache-2.0
#include "tests/support/tube.h"

#include <cmath>

namespace fulcrum::test {
namespace {
constexpr double pi = 3.14159265358979323846;
}

TriangleMesh make_tube(double length, int sections, int around, const TubeRadius& radius) {
    TriangleMesh mesh;
    for (int i = 0; i <= sections; ++i) {
        const double x = length * i / sections;
        for (int k = 0; k < around; ++k) {
            // Each circle is turned by half a step against the last: near-equilateral triangles.
            const double angle = 2.0 * pi * (k + 0.5 * (i % 2)) / around;
            const double r = radius(x, angle);
            mesh.vertices.emplace_back(x, r * std::cos(angle), r * std::sin(angle));
        }
    }
    const auto start = static_cast<std::int32_t>(mesh.vertices.size()), end = start + 1;
    mesh.vertices.emplace_back(0.0, 0.0, 0.0);
    mesh.vertices.emplace_back(length, 0.0, 0.0);
    for (int i = 0; i < sections; ++i) {
        for (int k = 0; k < around; ++k) {
            const int next = (k + 1) % around;
            const int a = i * around + k, b = i * around + next, c = (i + 1) * around + next,
                      d = (i + 1) * around + k;
            if (i % 2 == 0) {
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({b, c, d});
            } else {
                mesh.triangles.push_back({a, b, c});
                mesh.triangles.push_back({a, c, d});
            }
        }
    }
    const int last = sections * around;
    for (int k = 0; k < around; ++k) {
        const int next = (k + 1) % around;
        mesh.triangles.push_back({start, next, k});
        mesh.triangles.push_back({end, last + k, last + next});
    }
    return mesh;
}

TubeRadius plain_radius(double radius) {
    return [radius](double, double) { return radius; };
}

TubeRadius haustral_radius(double mean) {
    return [mean](double x, double angle) {
        const double bulge = std::abs(std::sin(pi * x / 0.030));
        return mean * (1.0 + 0.12 * (bulge - 0.64) * (1.0 - 0.4 * std::cos(3.0 * angle)) +
                       0.02 * std::cos(3.0 * angle));
    };
}

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

std::vector<RingFrame> rest_frames(const Cage& cage) {
    std::vector<RingFrame> frames(static_cast<std::size_t>(cage.rings()));
    ring_frames(
        cage, [](double s) { return rest_frame(s); }, frames.data());
    return frames;
}

}  // namespace fulcrum::test
