// SPDX-License-Identifier: Apache-2.0
// The extremes of docs/QUALITY.md for the surface on its cage and its dents, generated: slivers of aspect
// 1e6, tubes of a millimetre and of metres, rings at one point, thrown apart or twisted by ten turns, forces
// of a kilonewton. All results are finite, rigid motion stays rigid, power is conserved, meshes that are not
// tubes are refused.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstdio>
#include <memory>

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/bowel/dent.h"
#include "sim_core/bowel/display_skin.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/extremes.h"
#include "tests/support/tube.h"

namespace fulcrum {
namespace {

struct Tube {
    std::unique_ptr<BowelSkin> skin;
    std::unique_ptr<DisplaySkin> display;
    double scale = 1;  ///< over the size of a bowel
};

TriangleMesh extreme_tube(Random& random, double scale, bool& refused) {
    const int sections = static_cast<int>(8 + random.below(24)),
              around = static_cast<int>(6 + random.below(10));
    const double length = 0.16 * scale, radius = 0.016 * scale;
    TriangleMesh mesh = test::make_tube(
        length, sections, around,
        random.below(2) == 0 ? test::plain_radius(radius) : [scale](double x, double angle) {
            return scale * test::haustral_radius(0.016)(x / scale, angle);
        });
    const auto count = static_cast<std::uint32_t>(sections * around);
    const auto kind = random.below(8);
    if (kind == 0) {  // every second circle next to the previous one: slivers of aspect 1e6
        for (int i = 1; i < sections; i += 2) {
            for (int k = 0; k < around; ++k)
                mesh.vertices[static_cast<std::size_t>(i * around + k)].x() =
                    length / sections * (i - 1 + 1e-6);
        }
    } else if (kind == 1) {  // coincident vertices
        const std::uint32_t at = random.below(count - 1);
        mesh.vertices[at] = mesh.vertices[at + 1];
    } else if (kind == 2) {
        mesh.vertices[random.below(count)][static_cast<int>(random.below(3))] = test::not_a_length(random);
        refused = true;
    } else if (kind == 3) {  // inside out
        for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
        refused = true;
    } else if (kind == 4) {  // open
        mesh.triangles.pop_back();
        refused = true;
    }
    return mesh;
}

std::unique_ptr<Tube> build(std::uint64_t number, int& refusals) {
    Random random(number, 32);
    auto tube = std::make_unique<Tube>();
    tube->scale = random.below(3) == 0 ? test::between(random, 0.06, 6) : 1;
    bool refused = false;
    TriangleMesh mesh = extreme_tube(random, tube->scale, refused);
    const double length = 0.16 * tube->scale, radius = 0.016 * tube->scale;
    try {
        const SphereChain spheres = sample_spheres(length, radius, [radius](double) { return radius; });
        Cage cage = build_cage(mesh, length, spheres);
        tube->skin = std::make_unique<BowelSkin>(std::move(mesh), std::move(cage));
        tube->display = std::make_unique<DisplaySkin>(*tube->skin);
        EXPECT_FALSE(refused) << number;
    } catch (const InputError&) {
        ++refusals;
        return nullptr;
    }
    return tube;
}

Matrix3 rotation(const Vector3& turn) {
    const double angle = turn.norm();
    return angle > 0 ? Matrix3(Eigen::AngleAxisd(angle, turn / angle)) : Matrix3(Matrix3::Identity());
}

void carry(std::uint64_t number, const Tube& tube) {
    Random random(number, 33);
    const BowelSkin& skin = *tube.skin;
    const std::vector<RingFrame> rest = test::rest_frames(skin.cage());
    std::vector<RingFrame> frames = rest;
    std::vector<RingMotion> motion(frames.size());
    const auto kind = random.below(6);
    double reach = 1;  // m, of the coordinates
    const Vector3 by = 10 * test::inside_unit_box(random);
    const Matrix3 turned = rotation(10 * test::inside_unit_box(random));
    for (std::size_t r = 0; r < frames.size(); ++r) {
        RingFrame& frame = frames[r];
        if (kind == 0) {
            frame.position = turned * frame.position + by;
            frame.rotation = turned * frame.rotation;
        } else if (kind == 1) {  // all at one point
            frame.position = by;
        } else if (kind == 2) {  // ten turns from end to end
            frame.rotation = rotation(Vector3(20 * 3.141592653589793 * static_cast<double>(r) /
                                                  static_cast<double>(frames.size()),
                                              0, 0)) *
                             frame.rotation;
        } else if (kind == 3) {  // torn apart
            frame.position += test::between(random, 1e-3, 1e3) * test::direction(random);
        } else {
            frame.position += 0.01 * tube.scale * test::inside_unit_box(random);
            frame.rotation = rotation(3 * test::inside_unit_box(random)) * frame.rotation;
        }
        motion[r].frame = frame;
        motion[r].velocity = test::between(random, 1e-3, 1e3) * test::direction(random);
        motion[r].angular_velocity = test::between(random, 1e-3, 1e4) * test::direction(random);
        reach = std::max(reach, frame.position.cwiseAbs().maxCoeff());
    }
    std::vector<Vector3> positions(static_cast<std::size_t>(skin.vertices()));
    skin_all(skin, frames.data(), positions.data());
    std::vector<float> floats(12 * frames.size()), drawn(3 * positions.size()), normals(3 * positions.size());
    tube.display->evaluate(frames.data(), floats.data(), drawn.data(), normals.data());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        ASSERT_TRUE(positions[v].allFinite()) << v;
        if (kind == 0) {
            ASSERT_LT((positions[v] - (turned * skin.rest().vertices[v] + by)).norm(),
                      1e-10 * (1 + tube.scale))
                << v;
        }
        const Vector3 there(drawn[3 * v], drawn[3 * v + 1], drawn[3 * v + 2]);
        ASSERT_LT((there - positions[v]).norm(), 1e-6 * std::max(1.0, reach) * std::max(1.0, tube.scale))
            << v;
        const Vector3 normal(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
        ASSERT_TRUE(normal.allFinite()) << v;
        ASSERT_LT(normal.norm(), 1 + 1e-4) << v;
    }
    // The power of a force of up to a kilonewton on a vertex equals that on its rings.
    const auto vertex = random.below(static_cast<std::uint32_t>(skin.vertices()));
    const SkinRow& row = skin.rows()[vertex];
    const Vector3 force = test::between(random, 1e-6, 1e3) * test::direction(random);
    std::vector<RingWrench> wrenches(frames.size());
    add_ring_wrenches(row, frames.data(), force, wrenches.data());
    double on_rings = 0, size = 0;
    for (std::size_t r = 0; r < frames.size(); ++r) {
        const double power =
            wrenches[r].force.dot(motion[r].velocity) + wrenches[r].moment.dot(motion[r].angular_velocity);
        on_rings += power;
        size += wrenches[r].force.norm() * motion[r].velocity.norm() +
                wrenches[r].moment.norm() * motion[r].angular_velocity.norm();
    }
    EXPECT_NEAR(on_rings, force.dot(skin_velocity(row, motion.data())), 1e-12 * size);
    // Its dent: bounded in depth, never past its equilibrium, gone without load.
    WinklerBed bed;
    bed.stiffness_per_area = test::between(random, 1, 1e12);
    bed.time_constant = test::between(random, 1e-6, 10);
    FilterOptions options;
    options.mode = static_cast<FilterMode>(random.below(4));
    FilteredForce filtered;
    filter_force(view_of(skin.rest(), skin.adjacency(), positions.data()), static_cast<std::int32_t>(vertex),
                 test::between(random, 1e-12, 1e3), options, filtered);
    double sum = 0;
    for (int i = 0; i < filtered.count; ++i) sum += filtered.weight[static_cast<std::size_t>(i)];
    ASSERT_NEAR(sum, 1, 1e-12);
    DentState dents;
    const SurfaceLoad load{&filtered, nullptr, force};
    for (int step = 0; step < 8; ++step) {
        step_dents(bed, skin.vertex_areas().data(), &load, step < 5 ? 1 : 0,
                   test::between(random, 5e-5, 0.05), dents);
        ASSERT_LE(dents.count, dent_capacity);
        for (int i = 0; i < dents.count; ++i) {
            const Vector3& dent = dents.entries[static_cast<std::size_t>(i)].displacement;
            ASSERT_TRUE(dent.allFinite());
            ASSERT_LE(dent.norm(), bed.most_depth * (1 + 1e-12));
        }
    }
}

TEST(SkinExtremes, SurfaceStaysFiniteAndInvalidTubesAreRefused) {
    std::vector<std::unique_ptr<Tube>> tubes;
    int refusals = 0;
    for (std::uint64_t number = 0; number < 60; ++number) {
        if (auto tube = build(number, refusals)) tubes.push_back(std::move(tube));
    }
    std::printf("%d tubes, %d refused\n", static_cast<int>(tubes.size()), refusals);
    EXPECT_GT(refusals, 0);
    ASSERT_GT(tubes.size(), 20U);
    for (int i = 0; i < test::cases_asked() && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(i);
        carry(static_cast<std::uint64_t>(i), *tubes[static_cast<std::size_t>(i) % tubes.size()]);
    }
}

}  // namespace
}  // namespace fulcrum
