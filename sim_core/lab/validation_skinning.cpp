// SPDX-License-Identifier: Apache-2.0
// The surface on its cage: coordinates, rest pose, what a bend shows across rings, volume (docs/THEORY.md,
// section 1.3 and 1.4).
#include <algorithm>
#include <cmath>
#include <string>

#include "sim_core/bowel/mean_value.h"
#include "sim_core/lab/reference_skin.h"
#include "sim_core/lab/validation_rooms.h"
#include "sim_core/numerics/random.h"

namespace fulcrum::lab {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double length = 0.32, mean_radius = 0.016, spacing = 0.016;

struct Solid {
    std::vector<Vector3> vertices;
    std::vector<Triangle> triangles;
};

// A dented star: not convex, so that the planes of some triangles pass through its inside.
Solid star() {
    Solid solid;
    solid.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const Triangle faces[8] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                               {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (const auto& face : faces) {
        Vector3 centre = Vector3::Zero();
        for (const auto v : face) centre += solid.vertices[static_cast<std::size_t>(v)];
        const auto middle = static_cast<std::int32_t>(solid.vertices.size());
        solid.vertices.push_back(0.35 * centre);
        for (std::size_t e = 0; e < 3; ++e) solid.triangles.push_back({face[e], face[(e + 1) % 3], middle});
    }
    return solid;
}

void coordinates(std::vector<ValidationCase>& cases) {
    const Solid solid = star();
    const CageTopology topology(solid.triangles);
    std::vector<double> weights(solid.vertices.size());
    MeanValueScratch scratch;
    double unity = 0, linear = 0;
    const auto check = [&](const Vector3& point) {
        mean_value_weights(solid.vertices, topology, point, scratch, weights.data());
        double sum = 0;
        Vector3 position = Vector3::Zero();
        for (std::size_t i = 0; i < weights.size(); ++i) {
            sum += weights[i];
            position += weights[i] * solid.vertices[i];
        }
        unity = std::max(unity, std::fabs(sum - 1));
        linear = std::max(linear, (position - point).norm());
    };
    Random random(7);
    for (int i = 0; i < 2000; ++i)
        check(0.2 * Vector3(random.uniform(), random.uniform(), random.uniform()) +
              Vector3(0.05, 0.05, 0.05));
    // Towards faces, edges and vertices, down to rounding distance; and through the planes of the triangles.
    for (const Triangle& triangle : solid.triangles) {
        const Vector3 &a = solid.vertices[static_cast<std::size_t>(triangle[0])],
                      &b = solid.vertices[static_cast<std::size_t>(triangle[1])],
                      &c = solid.vertices[static_cast<std::size_t>(triangle[2])];
        for (const Vector3& target : {a, Vector3(0.5 * (a + b)), Vector3((a + b + c) / 3)}) {
            check(target);
            for (double distance = 1e-16; distance < 0.2; distance *= 4)
                check(target - distance * target.normalized());
        }
    }
    for (double height = 1e-17; height < 0.1; height *= 4) check(Vector3(0.2, 0.1, height));
    const std::string name = "mean value coordinates in a dented star: inside, on and near its triangles";
    cases.push_back(absolute_case("skinning", name, "largest |sum of weights - 1|", unity, 0,
                                  "partition of unity", 1e-12));
    cases.push_back(absolute_case("skinning", name, "largest error of a reproduced point (cage of size 1)",
                                  linear, 0, "linear reproduction", 1e-12));
}

void rest_pose(std::vector<ValidationCase>& cases, const BowelSkin& skin) {
    std::vector<Vector3> positions(static_cast<std::size_t>(skin.vertices()));
    skin_all(skin, rest_frames(skin.cage()).data(), positions.data());
    double worst = 0, unity = 0;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        worst = std::max(worst, (positions[v] - skin.rest().vertices[v]).norm());
        const SkinRow& row = skin.rows()[v];
        unity = std::max(unity, std::fabs(row.weight[0] + row.weight[1] + row.weight[2] + row.weight[3] - 1));
    }
    cases.push_back(absolute_case("skinning", "haustral tube at rest", "worst distance of a vertex, m", worst,
                                  0, "the mesh itself", 1e-10, 1, "m"));
    cases.push_back(absolute_case("skinning", "haustral tube, merged rows", "largest |sum of weights - 1|",
                                  unity, 0, "partition of unity", 1e-12));
}

// Lines along the tube, sampled finely across each ring in a bend of 30 mm radius: the surface must not tear
// or crease there.
void across_rings(std::vector<ValidationCase>& cases) {
    const BowelSkin skin = make_skin(length, mean_radius, spacing, 80, 32, plain_radius(mean_radius));
    const Cage& cage = skin.cage();
    const auto frames = bent_frames(cage, 0.030);
    SkinBinder binder(cage);
    double jump = 0, kink = 0;
    constexpr double step = 1e-5;
    for (int ring = 2; ring + 2 < cage.rings(); ++ring) {
        for (int line = 0; line < 32; ++line) {
            const double angle = 2 * pi * (line + 0.3) / 32,
                         start = cage.arc_lengths[static_cast<std::size_t>(ring)];
            const auto at = [&](int gap, double offset) {
                return skin_vertex(binder.bind(gap, Vector3(start + offset, mean_radius * std::cos(angle),
                                                            mean_radius * std::sin(angle))),
                                   frames);
            };
            jump = std::max(jump, (at(ring, 0) - at(ring - 1, 0)).norm());
            const auto place = [&](double x) { return at(x < 0 ? ring - 1 : ring, x); };
            const auto turn = [&](double centre) {
                const Vector3 a = place(centre) - place(centre - step),
                              b = place(centre + step) - place(centre);
                return std::atan2(a.cross(b).norm(), a.dot(b));
            };
            kink = std::max(kink, turn(0) / std::max(turn(-2 * step), turn(2 * step)));
        }
    }
    const std::string name = "across the rings of a bend of 30 mm radius";
    cases.push_back(
        absolute_case("skinning", name, "largest jump, m", jump, 0, "a continuous surface", 1e-9, 1, "m"));
    ValidationCase crease =
        absolute_case("skinning", name, "turn at a ring over the turn next to it", kink, 1,
                      "a smooth surface: at most 1.2 (docs/THEORY.md, section 1.4)", 0.2);
    crease.error = std::max(0.0, kink - 1);
    crease.passed = crease.error <= crease.tolerance;
    cases.push_back(crease);
}

void volume(std::vector<ValidationCase>& cases, const BowelSkin& skin) {
    const double rest = enclosed_volume(skin.rest().vertices, skin.rest().triangles);
    std::vector<Vector3> positions(static_cast<std::size_t>(skin.vertices()));
    const auto under = [&](const std::vector<RingFrame>& frames) {
        skin_all(skin, frames.data(), positions.data());
        return enclosed_volume(positions, skin.rest().triangles);
    };
    for (const double radii : {3.0, 4.0, 6.0}) {
        cases.push_back(relative_case(
            "skinning",
            "bend of 90 degrees, radius " + std::to_string(static_cast<int>(radii)) + " tube radii",
            "volume, m3", under(quarter_bend_frames(skin.cage(), radii * mean_radius)), rest,
            "volume at rest (divergence theorem)", 0.02));
    }
    const double gap = skin.cage().arc_lengths[1] - skin.cage().arc_lengths[0];
    cases.push_back(relative_case("skinning", "twist of 10 degrees per ring gap", "volume, m3",
                                  under(twisted_frames(skin.cage(), 10 * pi / 180 / gap)), rest,
                                  "volume at rest (divergence theorem)", 0.01));
}

void local_against_global(std::vector<ValidationCase>& cases, const BowelSkin& skin) {
    const Cage& cage = skin.cage();
    auto rings = cage_vertices(cage, rest_frames(cage).data());
    rings.resize(rings.size() - 2);
    RingWindows windows(rings, ring_size, 1);
    const auto frames = quarter_bend_frames(cage, 3 * mean_radius);
    const auto deformed = cage_vertices(cage, frames.data());
    WindowWeights weights;
    double worst = 0;
    for (int v = 0; v < skin.vertices(); v += 37) {
        const auto n = static_cast<std::size_t>(v);
        windows.global_weights(skin.rest().vertices[n], weights);
        Vector3 position = Vector3::Zero();
        for (std::size_t i = 0; i < weights.weight.size(); ++i) position += weights.weight[i] * deformed[i];
        worst = std::max(worst, (position - skin_vertex(skin.rows()[n], frames)).norm());
    }
    cases.push_back(absolute_case("skinning",
                                  "local windows against the whole cage, 90 degrees over 3 tube radii",
                                  "worst distance of a vertex, m", worst, 0, "global mean value coordinates",
                                  0.1, mean_radius, "of the tube's radius"));
}

void power(std::vector<ValidationCase>& cases, const BowelSkin& skin) {
    const auto frames = twisted_frames(skin.cage(), 15);
    std::vector<RingMotion> motions(frames.size());
    for (std::size_t r = 0; r < frames.size(); ++r) {
        const double s = static_cast<double>(r);
        motions[r].frame = frames[r];
        motions[r].velocity = Vector3(std::sin(s), std::cos(1.7 * s), std::sin(0.3 * s));
        motions[r].angular_velocity = Vector3(3 * std::cos(s), 4, -5 * std::sin(2 * s));
    }
    std::vector<RingWrench> wrenches(frames.size());
    double on_surface = 0, size = 0;
    for (int v = 1000; v < 1400; v += 3) {
        const SkinRow& row = skin.rows()[static_cast<std::size_t>(v)];
        const Vector3 force(std::sin(0.1 * v), 1.0, std::cos(0.2 * v));
        const double part = force.dot(skin_velocity(row, motions.data()));
        on_surface += part;
        size += std::fabs(part);
        add_ring_wrenches(row, frames.data(), force, wrenches.data());
    }
    double on_rings = 0;
    for (std::size_t r = 0; r < frames.size(); ++r) {
        on_rings +=
            wrenches[r].force.dot(motions[r].velocity) + wrenches[r].moment.dot(motions[r].angular_velocity);
    }
    cases.push_back(absolute_case("skinning", "134 forces on a moving, twisted surface",
                                  "power on the rings, W", on_rings, on_surface,
                                  "power on the surface (virtual work)", 1e-12, size, "of the summed sizes"));
}

}  // namespace

std::vector<ValidationCase> skinning_validation() {
    const BowelSkin skin = make_skin(length, mean_radius, spacing, 160, 48, haustral_radius(mean_radius));
    std::vector<ValidationCase> cases;
    coordinates(cases);
    rest_pose(cases, skin);
    across_rings(cases);
    volume(cases, skin);
    local_against_global(cases, skin);
    power(cases, skin);
    return cases;
}

}  // namespace fulcrum::lab
