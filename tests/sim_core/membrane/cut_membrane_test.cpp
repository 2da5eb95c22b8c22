// SPDX-License-Identifier: Apache-2.0
// A membrane cut by a blade: conserved quantities, bounds, and the motion of the halves afterwards.
#include "sim_core/membrane/cut_membrane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_core/numerics/input_error.h"
#include "tests/sim_core/membrane/sheet_cuts.h"
#include "tests/sim_core/membrane/sheets.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

constexpr double dt = 0.005;
constexpr double fixed = std::numeric_limits<double>::infinity();

MembraneMaterial tissue(double pre_strain) {
    MembraneMaterial material;
    material.structural_stiffness = 30;
    material.shear_stiffness = 15;
    material.bend_stiffness = 1.5;
    material.mass = 0.01;
    material.pre_strain = pre_strain;
    material.mass_damping = 10;
    material.stiffness_damping = 2e-5;
    return material;
}

std::vector<CutMembrane::Attachment> left_and_right(int columns, int rows) {
    std::vector<CutMembrane::Attachment> held;
    for (int r = 0; r < rows; ++r) {
        held.push_back({r * columns, fixed});
        held.push_back({r * columns + columns - 1, fixed});
    }
    return held;
}

bool anywhere(const Triangle&) {
    return true;
}

/// Highest squared frequency of the springs' bound (each no stiffer than k in every direction), from below.
double highest_squared(const CutMembraneState& state) {
    const auto n = static_cast<std::size_t>(state.node_end);
    std::vector<double> u(n), product(n);
    Random random(3);
    for (double& value : u) value = random.normal();
    double ratio = 0;
    for (int round = 0; round < 200; ++round) {
        std::fill(product.begin(), product.end(), 0.0);
        for (std::size_t s = 0; s < static_cast<std::size_t>(state.spring_end); ++s) {
            const auto a = static_cast<std::size_t>(state.first[s]),
                       b = static_cast<std::size_t>(state.second[s]);
            const double f = state.stiffness[s] * (u[a] - u[b]);
            product[a] += f;
            product[b] -= f;
        }
        double top = 0, bottom = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (!(state.masses[i] > 0)) continue;
            top += u[i] * product[i];
            bottom += state.masses[i] * u[i] * u[i];
            product[i] /= state.masses[i];
        }
        ratio = bottom > 0 ? top / bottom : 0;
        double size = 0;
        for (const double value : product) size = std::max(size, std::abs(value));
        if (!(size > 0)) break;
        for (std::size_t i = 0; i < n; ++i) u[i] = state.masses[i] > 0 ? product[i] / size : 0;
    }
    return ratio;
}

double pieces_mass(const CutMembrane& membrane, const CutMembraneState& state) {
    double sum = 0;
    for (const auto& piece : state.pieces) {
        if (piece.root >= 0) sum += piece.share * membrane.root_mass(piece.root);
    }
    return sum;
}

TEST(CutMembrane, UncutSheetMovesLikeAMembraneOfTheSameSprings) {
    const TriangleMesh mesh = test::sheet(8, 7);
    MembraneMaterial material = tissue(0.05);
    const CutMembrane cuttable(mesh, material, left_and_right(8, 7), 200);
    std::vector<std::int32_t> attached;
    for (const auto& a : left_and_right(8, 7)) attached.push_back(a.vertex);
    const Membrane plain(mesh, material, attached);
    CutMembraneState state = cuttable.make_state();
    CutMembraneScratch scratch = cuttable.make_scratch();
    CutMembraneInputs inputs;
    inputs.gravity = Vector3(0, 0, -9.81);
    // The same fine steps for both, so that only rounding and the lumping of masses at the corners differ.
    MembraneState other = plain.make_state();
    MembraneScratch plain_scratch = plain.make_scratch(1e-4);
    MembraneInputs plain_inputs;
    plain_inputs.gravity = inputs.gravity;
    MembraneSolve symplectic;
    symplectic.integrator = MembraneIntegrator::symplectic;
    for (int i = 0; i < 2000; ++i) {
        ASSERT_EQ(cuttable.step(state, inputs, 1e-4, scratch).fault, MembraneFault::none);
        plain.step(other, plain_inputs, 1e-4, plain_scratch, symplectic);
    }
    double moved = 0, apart = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        moved = std::max(moved, (state.positions[v] - mesh.vertices[v]).norm());
        apart = std::max(apart, (state.positions[v] - other.positions[v]).norm());
    }
    EXPECT_GT(moved, 1e-3);
    EXPECT_LT(apart, 1e-6 * moved);
    EXPECT_GT(cuttable.safe_frequency() * cuttable.safe_frequency(), highest_squared(state));
    EXPECT_LT(cuttable.safe_frequency(), 2.5 * std::sqrt(highest_squared(state)))
        << "the bound is tight enough";
}

// 60 arbitrary cuts in a row: nothing moves, mass and momentum are conserved, and no sliver becomes a stiff
// spring.
TEST(CutMembrane, SwapKeepsMassAndMomentumAndNeverRaisesEnergyOrFrequency) {
    const int columns = 7, rows = 6;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const CutMembrane membrane(test::sheet(columns, rows), tissue(seed % 2 == 0 ? 0.1 : -0.2),
                                   seed % 3 == 0
                                       ? std::vector<CutMembrane::Attachment>()
                                       : std::vector<CutMembrane::Attachment>{{0, fixed}, {5, 40}, {6, 40}},
                                   5000);
        CutMembraneState state = membrane.make_state();
        CutMembraneScratch scratch = membrane.make_scratch();
        CutMembraneInputs inputs;
        Random random(seed);
        test::shake(state.velocities, 0.1, seed);
        for (std::size_t n = static_cast<std::size_t>(state.node_end); n < state.velocities.size(); ++n)
            state.velocities[n].setZero();
        for (int i = 0; i < 60; ++i) {
            const MembraneCut cut = test::random_cut(membrane, state, random);
            const CutMembraneState before = state;
            const double mass = membrane.mass(state);
            ASSERT_NEAR(mass, pieces_mass(membrane, state), 1e-12 * 0.01);
            ASSERT_TRUE(membrane.part(state, cut, scratch)) << "capacity";
            const double lost = state.removed_mass - before.removed_mass;
            ASSERT_NEAR(membrane.mass(state) + lost, mass, 1e-12 * 0.01);
            ASSERT_NEAR(pieces_mass(membrane, state), membrane.mass(state), 1e-12 * 0.01);
            // Momentum of removed pieces, each at the velocity of its nodes.
            Vector3 gone = Vector3::Zero();
            for (const std::int32_t root : cut.roots) {
                for (std::int32_t p = before.first_piece[static_cast<std::size_t>(root)]; p >= 0;
                     p = before.pieces[static_cast<std::size_t>(p)].next) {
                    double left = before.pieces[static_cast<std::size_t>(p)].share;
                    for (const MembranePiece& piece : cut.pieces) left -= piece.from == p ? piece.share : 0;
                    gone += left * membrane.root_mass(root) *
                            CutMembrane::velocity(before, p, Vector3::Constant(1.0 / 3));
                }
            }
            ASSERT_LT((membrane.momentum(state) + gone - membrane.momentum(before)).norm(), 1e-12);
            const MembraneEnergy old = membrane.energy(before), now = membrane.energy(state);
            ASSERT_LE(now.structural, old.structural * (1 + 1e-12) + 1e-18);
            ASSERT_LE(now.shear, old.shear * (1 + 1e-12) + 1e-18);
            ASSERT_LE(now.bend, old.bend * (1 + 1e-12) + 1e-18);
            ASSERT_LE(now.kinetic, old.kinetic * (1 + 1e-12) + 1e-18);
            if (i % 6 == 0) {
                ASSERT_LE(highest_squared(state),
                          membrane.safe_frequency() * membrane.safe_frequency() * (1 + 1e-9));
            }
            for (std::size_t k = 0; k < cut.pieces.size(); ++k) {  // no position jumps
                const Vector3 b(0.2, 0.3, 0.5);
                ASSERT_LT((CutMembrane::point(state, cut.pieces[k].slot, b) -
                           CutMembrane::point(before, cut.pieces[k].from, b))
                              .norm(),
                          1e-15);
            }
            const MembraneReport report = membrane.step(state, inputs, dt, scratch);
            ASSERT_EQ(report.fault, MembraneFault::none);
            const MembraneEnergy then = membrane.energy(state);
            // Symplectic Euler conserves a nearby energy; damping reduces it.
            ASSERT_LE(then.elastic() + then.kinetic, (now.elastic() + now.kinetic) / (1 - 0.98 * 0.98));
        }
    }
}

TEST(CutMembrane, HalvesOfACutSheetMoveIndependently) {
    const int columns = 9, rows = 8;
    for (const double kerf : {0.0, 0.002}) {
        const CutMembrane membrane(test::sheet(columns, rows), tissue(0.05), {}, 600);
        CutMembraneState state = membrane.make_state();
        CutMembraneScratch scratch = membrane.make_scratch();
        ASSERT_TRUE(membrane.part(state, test::straight_cut(membrane, 112, 0.047, kerf, anywhere), scratch));
        // Thrown apart, each half moves as a free body: its momentum is conserved.
        std::vector<std::uint8_t> right(state.positions.size(), 0);
        for (std::size_t p = 0; p < state.pieces.size(); ++p) {
            const auto& piece = state.pieces[p];
            if (piece.root < 0) continue;
            double x = 0;
            for (int c = 0; c < 3; ++c) {
                if (((piece.corners >> c) & 1) != 0)
                    x = membrane
                            .rest()[static_cast<std::size_t>(membrane.triangles()[static_cast<std::size_t>(
                                piece.root)][static_cast<std::size_t>(c)])]
                            .x();
            }
            ASSERT_NE(piece.corners, 0) << "a line leaves no piece without a corner";
            for (const std::int32_t n : piece.nodes) right[static_cast<std::size_t>(n)] = x > 0.047 ? 1 : 0;
            EXPECT_TRUE(piece.isolated);
        }
        Vector3 speed[2] = {Vector3(-0.1, 0, 0.02), Vector3(0.1, 0.03, 0)};
        double mass[2] = {0, 0};
        for (std::size_t n = 0; n < static_cast<std::size_t>(state.node_end); ++n) {
            if (!(state.masses[n] > 0)) continue;
            state.velocities[n] = speed[right[n]];
            mass[right[n]] += state.masses[n];
        }
        EXPECT_NEAR(mass[0] / 0.01, (0.047 - kerf / 2) / 0.1, 1e-9);
        CutMembraneInputs inputs;
        for (int i = 0; i < 100; ++i)
            ASSERT_EQ(membrane.step(state, inputs, dt, scratch).fault, MembraneFault::none);
        double fade = std::exp(-10 * 100 * dt);
        for (int side = 0; side < 2; ++side) {
            Vector3 momentum = Vector3::Zero();
            for (std::size_t n = 0; n < static_cast<std::size_t>(state.node_end); ++n) {
                if (right[n] == side) momentum += state.masses[n] * state.velocities[n];
            }
            EXPECT_LT((momentum / mass[side] - fade * speed[side]).norm(), 0.02 * speed[side].norm()) << side;
        }
    }
}

/// Width of the gap at the middle of a sheet held left and right and cut along its middle, over the middle
/// half of its height; without the kerf.
double opening(double pre_strain, CutMembraneState* kept = nullptr) {
    const int columns = 11, rows = 17;
    const CutMembrane membrane(lab::make_sheet(columns, rows, 0.06, 0.1), tissue(pre_strain),
                               left_and_right(columns, rows), 2000);
    CutMembraneState state = membrane.make_state();
    CutMembraneScratch scratch = membrane.make_scratch();
    CutMembraneInputs inputs;
    const auto middle = [&](const Triangle& t) {
        for (const std::int32_t v : t) {
            const double y = membrane.rest()[static_cast<std::size_t>(v)].y();
            if (y < 0.02 || y > 0.08) return false;
        }
        return true;
    };
    EXPECT_TRUE(membrane.part(state, test::straight_cut(membrane, 320, 0.031, 0, middle), scratch));
    for (int i = 0; i < 200; ++i)
        EXPECT_EQ(membrane.step(state, inputs, dt, scratch).fault, MembraneFault::none);
    // Both sides of the line at the root triangles across the middle.
    double left = -1e9, right = 1e9;
    for (std::size_t p = 0; p < state.pieces.size(); ++p) {
        const auto& piece = state.pieces[p];
        if (piece.root < 0 || piece.share > 0.999) continue;
        const Triangle& t = membrane.triangles()[static_cast<std::size_t>(piece.root)];
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector3 &a = membrane.rest()[static_cast<std::size_t>(t[c])],
                          &b = membrane.rest()[static_cast<std::size_t>(t[(c + 1) % 3])];
            if ((a.x() - 0.031) * (b.x() - 0.031) >= 0 || std::abs(a.y() - 0.05) > 0.01) continue;
            Vector3 weight = Vector3::Zero();
            const double s = (0.031 - a.x()) / (b.x() - a.x());
            weight[static_cast<int>(c)] = 1 - s;
            weight[static_cast<int>((c + 1) % 3)] = s;
            const double x = CutMembrane::point(state, static_cast<std::int32_t>(p), weight).x();
            bool on_left = false;
            for (std::size_t k = 0; k < 3; ++k) {
                if (((piece.corners >> k) & 1) != 0)
                    on_left = membrane.rest()[static_cast<std::size_t>(t[k])].x() < 0.031;
            }
            if (on_left)
                left = std::max(left, x);
            else
                right = std::min(right, x);
        }
    }
    if (kept != nullptr) *kept = state;
    return right - left;
}

TEST(CutMembrane, PreStrainedSheetGapesAndShrinksBack) {
    const double none = opening(0.0), some = opening(0.05), more = opening(0.10), most = opening(0.20);
    EXPECT_NEAR(none, 0, 1e-6);
    EXPECT_GT(some, 5e-4);
    EXPECT_GT(more, 1.5 * some);
    EXPECT_GT(most, 1.5 * more);
    EXPECT_LT(most, 0.06 * 0.2) << "not wider than its pre-stretch";
}

TEST(CutMembrane, SheetCutOffItsHoldIsIsolatedAndFalls) {
    const int columns = 6, rows = 5;
    const CutMembrane membrane(test::sheet(columns, rows), tissue(0), left_and_right(columns, rows), 400);
    CutMembraneState state = membrane.make_state();
    CutMembraneScratch scratch = membrane.make_scratch();
    CutMembraneInputs inputs;
    inputs.isolated_gravity = Vector3(0, 0, -9.81);
    // Along the hold itself, within the first triangles: what is attached to the held vertices stays with
    // them.
    ASSERT_TRUE(membrane.part(state, test::straight_cut(membrane, 40, 0.005, 0.001, anywhere), scratch));
    for (const auto& piece : state.pieces)
        EXPECT_FALSE(piece.root >= 0 && piece.isolated) << "held on the other side";
    // The same for the right hold.
    ASSERT_TRUE(membrane.part(state, test::straight_cut(membrane, 80, 0.095, 0.001, anywhere), scratch));
    double loose = 0;
    for (const auto& piece : state.pieces)
        loose += piece.root >= 0 && piece.isolated ? piece.share * membrane.root_mass(piece.root) : 0;
    EXPECT_NEAR(loose / 0.01, 0.089 / 0.1, 1e-9);
    for (int i = 0; i < 20; ++i) membrane.step(state, inputs, dt, scratch);
    double lowest = 0, held = 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(state.node_end); ++n) {
        if (state.isolated[n] != 0) lowest = std::min(lowest, state.positions[n].z());
        if (state.held[n] != 0) held = std::min(held, state.positions[n].z());
    }
    EXPECT_LT(lowest, -0.02);
    EXPECT_EQ(held, 0);
}

TEST(CutMembrane, LinkForcesStayWithinTheirLimits) {
    const CutMembrane membrane(test::sheet(8, 7), tissue(0.05), left_and_right(8, 7), 200);
    for (int kind = 0; kind < 3; ++kind) {
        CutMembraneState state = membrane.make_state();
        CutMembraneScratch scratch = membrane.make_scratch();
        CutMembraneInputs inputs;
        inputs.links.resize(1);
        CutMembraneLink& link = inputs.links[0];
        link.piece = 40;
        link.stiffness = 300;
        link.start = link.target =
            CutMembrane::point(state, 40, link.barycentric) + Vector3(0.001, 0, -0.004);
        if (kind == 0) link.grip = fixed;
        if (kind > 0) link.normal = Vector3(0, 0, 1);
        link.friction = 0.1;
        if (kind == 2) {
            link.push = false;
            link.grip = 0.02;
        }
        Vector3 before = Vector3::Zero();
        for (int i = 0; i < 300; ++i) {
            before = link.reaction;
            membrane.step(state, inputs, dt, scratch);
        }
        const double across = std::hypot(link.reaction.x(), link.reaction.y());
        if (kind == 0) {
            EXPECT_LT(link.reaction.z(), -0.01);
            EXPECT_GT(across, 0.01);
        } else if (kind == 1) {
            EXPECT_LT(link.reaction.z(), -0.01);
            EXPECT_LE(across, 0.1 * -link.reaction.z() * (1 + 1e-9));
            link.start = link.target = link.target + Vector3(0, 0, 0.02);  // lifted off: no attractive force
            membrane.step(state, inputs, dt, scratch);
            membrane.step(state, inputs, dt, scratch);
            EXPECT_EQ(link.reaction, Vector3(0, 0, 0));
        } else {
            EXPECT_NEAR(link.reaction.z(), 0, 1e-12);
            EXPECT_NEAR(across, 0.02, 1e-4);
        }
        EXPECT_LT((link.reaction - before).norm(), kind == 1 ? 10.0 : 1e-3) << "at rest";
    }
}

TEST(CutMembrane, CutsAndStepsAllocateNothingAndCopiesContinueIdentically) {
    const CutMembrane membrane(test::sheet(8, 7), tissue(0.1), left_and_right(8, 7), 2000);
    CutMembraneState state = membrane.make_state(), restored = state;
    CutMembraneScratch scratch = membrane.make_scratch(), other = membrane.make_scratch();
    CutMembraneInputs inputs;
    Random random(8);
    std::vector<MembraneCut> cuts;
    for (int i = 0; i < 20; ++i) {
        cuts.push_back(test::random_cut(membrane, state, random));
        const std::uint64_t allocations = test::allocation_count();
        ASSERT_TRUE(membrane.part(state, cuts.back(), scratch));
        membrane.step(state, inputs, dt, scratch);
        if (i == 9) restored = state;  // a save in the middle
        EXPECT_EQ(test::allocation_count(), allocations);
    }
    for (std::size_t i = 10; i < 20; ++i) {
        ASSERT_TRUE(membrane.part(restored, cuts[i], other));
        membrane.step(restored, inputs, dt, other);
    }
    EXPECT_EQ(restored.positions, state.positions);
    EXPECT_EQ(restored.velocities, state.velocities);
    EXPECT_EQ(restored.masses, state.masses);
    EXPECT_EQ(restored.stiffness, state.stiffness);
    EXPECT_EQ(restored.topology, 20U);
}

TEST(CutMembrane, InputWithoutRoomOrOutOfRangeIsRefused) {
    const TriangleMesh mesh = test::sheet(5, 4);
    const CutMembrane membrane(mesh, tissue(0), {{0, fixed}}, 26);
    CutMembraneState state = membrane.make_state();
    CutMembraneScratch scratch = membrane.make_scratch();
    const MembraneCut cut = test::straight_cut(membrane, 24, 0.04, 0, anywhere);
    const std::vector<double> before = state.stiffness;
    EXPECT_FALSE(membrane.part(state, cut, scratch)) << "room for two more pieces";
    EXPECT_EQ(state.stiffness, before);
    CutMembraneInputs inputs;
    inputs.links.resize(1);
    inputs.links[0].piece = 25;
    EXPECT_EQ(membrane.step(state, inputs, dt, scratch).fault, MembraneFault::refused) << "no such piece";
    inputs.links[0].piece = 3;
    inputs.links[0].target = Vector3(0, NAN, 0);
    EXPECT_EQ(membrane.step(state, inputs, dt, scratch).fault, MembraneFault::refused);
    inputs.links.clear();
    EXPECT_EQ(membrane.step(state, inputs, dt, scratch, 1).fault, MembraneFault::refused)
        << "one substep is too few";

    EXPECT_THROW(CutMembrane(mesh, tissue(0), {{99, fixed}}, 26), InputError);
    EXPECT_THROW(CutMembrane(mesh, tissue(0), {{0, 0}}, 26), InputError);
    EXPECT_THROW(CutMembrane(mesh, tissue(0), {}, 10), InputError);
    TriangleMesh flat = mesh;
    flat.vertices[6] = flat.vertices[5];
    EXPECT_THROW(CutMembrane(flat, tissue(0), {}, 26), InputError);
    TriangleMesh three = mesh;
    three.vertices.push_back(Vector3(0, 0, 1));
    three.triangles.push_back({6, 7, 20});
    EXPECT_THROW(CutMembrane(three, tissue(0), {}, 30), InputError);
}

}  // namespace
}  // namespace fulcrum
