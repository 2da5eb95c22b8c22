// SPDX-License-Identifier: Apache-2.0
// Septa as a part: their position, forces exchanged with the rectum, the effect of a cut, valid scene values.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/anatomy/rectum.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/world/couplings/septa_on_rectum.h"
#include "sim_core/world/parts/sheet/sheet_part.h"
#include "tests/sim_core/world/parts/sheet/septa_rig.h"

namespace fulcrum {
namespace {

constexpr double dt = 0.005;

TEST(Rectum, WallAndTubeAreConcentricAboutTheSacralCurve) {
    const Scene scene = test::septa_scene();
    const RectumParameters parameters = rectum_parameters(scene);
    const SacralCurve& curve = parameters.curve;
    const BowelShape rectum = make_rectum(parameters);
    EXPECT_LT((rectum.centre_line.front() - curve.centre_line(0)).norm(), 1e-12);
    EXPECT_LT((rectum.centre_line.back() - curve.centre_line(parameters.length)).norm(), 1e-12);
    for (const Vector3& v : rectum.surface.vertices)
        EXPECT_LE(std::hypot(v.y(), v.z()), curve.rectum_radius + 1e-12);
    for (const double s : {0.02, 0.07, 0.11}) {
        EXPECT_NEAR(curve.posterior(s).dot(curve.cranial(s)), 0, 1e-15);
        for (const double turn : {-0.9, 0.0, 0.7}) {
            const Vector3 muscularis = curve.point(s, turn, curve.gap), fascia = curve.point(s, turn, 0);
            EXPECT_NEAR((muscularis - curve.centre_line(s)).norm(), curve.rectum_radius, 1e-12);
            EXPECT_NEAR((fascia - muscularis).norm(), curve.gap, 1e-12);
            EXPECT_EQ(fascia.x() > 0, turn > 0) << "left is left";
        }
    }
    // The wall is behind the fascia, by no more than its unevenness, and faces the rectum.
    const CavityModel wall(make_presacral_wall(parameters), FreeSide::front);
    Random random(3, 1);
    for (int i = 0; i < 300; ++i) {
        const double s = random.uniform(0.0, 0.95 * parameters.promontory), turn = random.uniform(-1.1, 1.1);
        const double height = random.uniform(0.0, curve.gap);
        const CavityPoint near = wall.closest(curve.point(s, turn, height), 0.05);
        // 3.5 mm triangles on a curve of 33 mm: the chord is slightly in front of it.
        EXPECT_GT(near.distance, height - 1e-4);
        EXPECT_LT(near.distance, height + parameters.unevenness + 1e-6);
    }
    RectumParameters other = parameters;
    other.seed = 2;
    EXPECT_NE(make_presacral_wall(other).vertices[100], make_presacral_wall(parameters).vertices[100])
        << "another patient";
    for (double* value :
         {&other.length, &other.unevenness, &other.curve.gap, &other.curve.curve_radius, &other.promontory}) {
        const double kept = *value;
        for (const double bad : {-1.0, std::nan(""), 1e9}) {
            *value = bad;
            EXPECT_THROW(make_presacral_wall(other), InputError);
        }
        *value = kept;
    }
}

TEST(Septa, AreBetweenFasciaAndMuscularisWithConsecutiveLines) {
    const Scene scene = test::septa_scene();
    const SacralCurve curve = rectum_parameters(scene).curve;
    const SheetLayout layout = lay_out_septa(*scene.septa, curve);
    ASSERT_EQ(layout.pieces, scene.septa->count);
    ASSERT_EQ(layout.rest.size(), layout.mesh.vertices.size());
    ASSERT_EQ(layout.zones.size(), layout.mesh.triangles.size());
    for (std::size_t v = 0; v < layout.rest.size(); ++v) {
        const auto piece = static_cast<std::int32_t>(v) / (layout.rows * layout.columns);
        const double s = layout.arc_lengths[static_cast<std::size_t>(piece)],
                     height = layout.rest[v].y() + scene.septa->plane_height;
        const Vector3& place = layout.mesh.vertices[v];
        EXPECT_NEAR((place - curve.centre_line(s)).norm(), curve.fascia_radius() - height, 1e-12)
            << "height is the distance to the fascia";
        EXPECT_NEAR((place - curve.centre_line(s)).dot(curve.cranial(s)), 0, 1e-12) << "across the rectum";
        EXPECT_GE(layout.rest[v].x(), piece * scene.septa->width - 1e-12);
        EXPECT_LE(layout.rest[v].x(), (piece + 1) * scene.septa->width + 1e-12);
    }
    for (std::int32_t k = 0; k + 1 < layout.pieces; ++k) {
        const Vector3 here =
            curve.point(layout.arc_lengths[static_cast<std::size_t>(k)], 0, scene.septa->plane_height);
        const Vector3 next =
            curve.point(layout.arc_lengths[static_cast<std::size_t>(k) + 1], 0, scene.septa->plane_height);
        EXPECT_GT(here.y(), next.y()) << "the first is the most cranial";
        EXPECT_NEAR((here - next).norm(), scene.septa->spacing, 0.01 * scene.septa->spacing);
    }
}

const std::vector<RodLoad>& pulls_on_rectum(const test::SeptaRig& rig) {
    return rig.world.find<SeptaOnRectum>()->edge().pulls();
}

/// Septa on a rod that floats free in space.
struct Afloat {
    Scene scene = test::septa_scene();
    Rod rod;
    RodState state;
    RodScratch scratch;
    RodInputs inputs;
    SheetPart sheet;
    SeptaEdge edge;

    static RodSpec spec(const Scene& scene) {
        RodSpec spec;
        spec.segments = scene.bowel->segments;
        spec.length = scene.bowel->length;
        spec.outer_radius = scene.bowel->outer_radius;
        spec.inner_radius = scene.bowel->outer_radius - scene.bowel->wall_thickness;
        spec.linear_density = scene.bowel->linear_density;
        spec.mass_damping = 0;
        spec.ends[0] = spec.ends[1] = RodEnd::free;
        const SacralCurve curve = rectum_parameters(scene).curve;
        for (int i = 0; i <= spec.segments; ++i)
            spec.rest_nodes.push_back(curve.centre_line(spec.length * i / spec.segments));
        return spec;
    }
    static Scene undamped(Scene scene) {
        scene.septa->mass_damping = 0;
        return scene;
    }
    Afloat()
        : rod(spec(scene)),
          state(rod.make_state()),
          scratch(rod.make_scratch()),
          sheet(undamped(scene), dt),
          edge(scene, sheet, rod, state, dt) {
        inputs.ends[0] = state.ends[0];
        inputs.ends[1] = state.ends[1];
        inputs.loads.reserve(64);
    }
    Vector3 momentum() const {
        Vector3 sum = Vector3::Zero();
        for (int i = 0; i <= rod.segments(); ++i)
            sum += rod.node_mass(i) * state.velocities[static_cast<std::size_t>(i)];
        return sum;
    }
};

TEST(Septa, PullOnTheRectumIsEqualAndOppositeToTheEdgeSupport) {
    Afloat pair;
    for (Vector3& v : pair.state.velocities) v = Vector3(0.05, -0.1, 0.3);
    const SheetAction nothing[hand_count];
    double size = 0;
    for (int i = 0; i < 60; ++i) {
        const Vector3 before = pair.momentum();
        pair.edge.carry(pair.rod, pair.state, dt);
        ASSERT_EQ(pair.sheet.step(nothing, 0, dt), 0U);
        pair.edge.sum_pulls();
        Vector3 held = Vector3::Zero(), pull = Vector3::Zero();
        for (const DrivenVertex& driven : pair.sheet.inputs().driven) held += driven.reaction;
        for (const RodLoad& load : pair.edge.pulls()) pull += load.force;
        EXPECT_LT((held + pull).norm(), 1e-10) << "exactly the same force";
        pair.inputs.loads = pair.edge.pulls();
        pair.rod.step(pair.state, pair.inputs, dt, pair.scratch);
        EXPECT_LT((pair.momentum() - before - dt * pull).norm(), 1e-8) << "and the rod gains that impulse";
        size += dt * pull.norm();
    }
    EXPECT_GT(size, 1e-3);
}

// Only the supports of both edges act: the membrane gains their impulse, and at rest the two balance.
TEST(Septa, MomentumOfTheSeptaEqualsTheImpulseOfTheirEdges) {
    const Scene scene = Afloat::undamped(test::septa_scene());
    const SheetLayout layout = lay_out_septa(*scene.septa, rectum_parameters(scene).curve);
    MembraneMaterial material;
    material.structural_stiffness = 6;
    material.shear_stiffness = 2.5;
    material.bend_stiffness = 0.2;
    material.mass = 0.02;
    material.pre_strain = 0.05;
    material.zones = layout.zones;
    for (const double damping : {0.0, 200.0}) {
        material.mass_damping = damping;
        const CutMembrane membrane(layout.mesh, material, layout.attachments,
                                   static_cast<std::int32_t>(layout.mesh.triangles.size()));
        CutMembraneState state = membrane.make_state();
        CutMembraneScratch scratch = membrane.make_scratch();
        CutMembraneInputs inputs;
        for (const std::int32_t v : layout.held)
            inputs.driven.push_back({v, layout.mesh.vertices[static_cast<std::size_t>(v)], Vector3::Zero()});
        const Vector3 up(0, 0.002, 0.004);
        double fascia = 0;
        for (int i = 0; i < 300; ++i) {
            const Vector3 before = membrane.momentum(state);
            Vector3 given = Vector3::Zero(), below = Vector3::Zero();
            for (DrivenVertex& driven : inputs.driven) {
                const bool wall = layout.rest[static_cast<std::size_t>(driven.vertex)].y() > 0;
                driven.target = layout.mesh.vertices[static_cast<std::size_t>(driven.vertex)] +
                                (wall ? std::min(1.0, (i + 1) / 50.0) * up : Vector3(Vector3::Zero()));
            }
            ASSERT_EQ(membrane.step(state, inputs, dt, scratch).fault, MembraneFault::none);
            for (const DrivenVertex& driven : inputs.driven) {
                given += driven.reaction;
                if (layout.rest[static_cast<std::size_t>(driven.vertex)].y() < 0) below += driven.reaction;
                const std::size_t v = static_cast<std::size_t>(driven.vertex);
                ASSERT_LT((state.positions[v] - driven.target).norm(), 1e-12)
                    << "the edge follows its prescribed motion";
            }
            fascia = below.norm();
            const Vector3 change = membrane.momentum(state) - before;
            if (damping == 0) {
                ASSERT_LT((change - dt * given).norm(), 1e-10) << i;
            } else if (i == 299) {
                EXPECT_LT(given.norm(), 1e-3 * fascia)
                    << "in equilibrium the fascia carries the pull of the rectum";
            }
        }
        EXPECT_GT(fascia, 0.05);
    }
}

// Along the plane from border to border: two pieces, both held; the pull on the rectum vanishes; no swap
// raises the energy.
TEST(Septa, CutFromBorderToBorderMakesTwoPiecesAndReleasesTheRectum) {
    test::SeptaRig rig;
    rig.take_rectum();
    rig.lift(0.008);
    rig.steps(100);
    SheetPart& sheet = *rig.world.find<SheetPart>();
    const SeptaSpec& spec = *rig.scene.septa;
    for (int k : {1, 3}) {
        const double pull = pulls_on_rectum(rig)[static_cast<std::size_t>(k)].force.norm();
        std::vector<double> others;
        for (const RodLoad& load : pulls_on_rectum(rig)) others.push_back(load.force.norm());
        const std::size_t count = rig.view().line.size() / 4;
        std::vector<Vector3> path;
        const Vector3* line = &rig.view().line[static_cast<std::size_t>(k) * count];
        path.push_back(line[0] + 1.0 * (line[0] - line[1]));
        for (std::size_t i = 0; i < count; ++i) path.push_back(line[i]);
        path.push_back(line[count - 1] + 1.0 * (line[count - 1] - line[count - 2]));
        std::int32_t root = -1;
        const Vector3 normal = rig.curve.cranial(rig.arc_length(k));
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const MembraneEnergy before = sheet.membrane().energy(sheet.state().membrane);
            BladeStep blade;
            blade.from = path[i] - 0.0003 * (path[i + 1] - path[i]).normalized();
            blade.to = path[i + 1];
            blade.normal = normal;
            blade.width = spec.blade_width;
            blade.depth = 0.004;
            blade.root =
                root >= 0 ? root : sheet.surface().nearest_root(path[1], sheet.state().positions.data());
            const CutReport report = sheet.cut(blade);
            if (report.root >= 0) root = report.root;
            const MembraneEnergy after = sheet.membrane().energy(sheet.state().membrane);
            ASSERT_LE(after.structural, before.structural * (1 + 1e-12));
            ASSERT_LE(after.shear, before.shear * (1 + 1e-12));
            ASSERT_LE(after.bend, before.bend * (1 + 1e-12));
            ASSERT_LE(after.kinetic, before.kinetic * (1 + 1e-12));
        }
        CutMesh surface = sheet.surface();
        const std::int32_t pieces = surface.find_pieces();
        EXPECT_EQ(pieces, k == 1 ? 5 : 6);
        for (std::int32_t p = 0; p < pieces; ++p)
            EXPECT_TRUE(surface.piece(p).fixed) << "one is attached to the fascia, one to the rectum";
        rig.steps(100);
        EXPECT_LT(pulls_on_rectum(rig)[static_cast<std::size_t>(k)].force.norm(), 0.05 * pull);
        EXPECT_GT(pulls_on_rectum(rig)[0].force.norm(), 0.8 * others[0]) << "the others still pull";
        EXPECT_TRUE(check_cut(sheet.surface(), sheet.state().positions.data()).passed());
    }
    EXPECT_EQ(rig.record.outcome, 0U);
}

TEST(Septa, ZonesHaveTheirOwnStiffness) {
    const Scene scene = test::septa_scene();
    const SheetLayout layout = lay_out_septa(*scene.septa, rectum_parameters(scene).curve);
    MembraneMaterial material;
    const std::vector<MembraneSpring> plain = derive_springs(layout.mesh, material);
    material.zones = layout.zones;
    const std::vector<MembraneSpring> zoned = derive_springs(layout.mesh, material);
    ASSERT_EQ(plain.size(), zoned.size());
    int soft = 0, tough = 0;
    for (std::size_t s = 0; s < plain.size(); ++s) {
        const double ratio = zoned[s].stiffness / plain[s].stiffness;
        EXPECT_GE(ratio, 1 - 1e-12);
        EXPECT_LE(ratio, scene.septa->fat_stiffness + 1e-12);
        soft += std::abs(ratio - 1) < 1e-12 ? 1 : 0;
        tough += std::abs(ratio - scene.septa->fat_stiffness) < 1e-12 ? 1 : 0;
    }
    EXPECT_GT(soft, 500);
    EXPECT_GT(tough, 500);
    material.zones.pop_back();
    EXPECT_THROW(derive_springs(layout.mesh, material), InputError);
    material.zones.push_back(0);
    EXPECT_THROW(derive_springs(layout.mesh, material), InputError);
}

// Any scene values: refused with a hint, or the scene runs and stays finite.
TEST(Septa, ExtremeScenesRunOrAreRefused) {
    Random random(20, 5);
    int ran = 0;
    for (int i = 0; i < 10; ++i) {
        // Each at an end of its range, or as it is.
        const auto at_end = [&](auto& value, double low, double high) {
            const double drawn = random.uniform(0.0, 1.0);
            if (drawn < 0.3) value = static_cast<std::remove_reference_t<decltype(value)>>(low);
            if (drawn > 0.7) value = static_cast<std::remove_reference_t<decltype(value)>>(high);
        };
        Scene scene = test::septa_scene();
        SeptaSpec& spec = *scene.septa;
        spec.node_spacing = 0.006;
        at_end(spec.count, 1, 3);
        at_end(spec.structural_stiffness, 1e-3, 400);
        at_end(spec.shear_stiffness, 0, 400);
        at_end(spec.bend_stiffness, 0, 100);
        at_end(spec.fat_stiffness, 0.1, 20);
        at_end(spec.surface_density, 0.01, 20);
        at_end(spec.pre_strain, -0.5, 1);
        at_end(spec.stiffness_damping, 0, 0.01);
        at_end(spec.mass_damping, 0, 200);
        at_end(spec.weight, 0, 1);
        at_end(spec.areolar_rows, 1, 4);
        at_end(spec.fat_rows, 1, 4);
        try {
            test::SeptaRig rig(scene);
            ++ran;
            rig.go(0, rig.tip_for(rig.front()), 1.0);
            rig.wish[0].closed = true;
            rig.steps(10);
            rig.go(0, rig.tip_for(rig.lifted(0.05)), 2.0);
            rig.steps(20);
            for (const Vector3& position : rig.sheet().state().positions) ASSERT_TRUE(position.allFinite());
            for (const Vector3& node : rig.world.snapshot().bowel.nodes) ASSERT_TRUE(node.allFinite());
            EXPECT_LE(rig.largest_force, scene.force_limit + 1e-9);
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("/septa"), std::string::npos) << error.what();
        }
    }
    EXPECT_GT(ran, 1);
}

TEST(Septa, BadScenesAreReportedWithPlaceAndHint) {
    const std::string text = read_text_file(test::source_path("assets/scenes/c4_posterior.json"), 1U << 20U);
    const auto with = [&](const std::string& old, const std::string& by) {
        std::string changed = text;
        const std::size_t at = changed.find(old);
        EXPECT_NE(at, std::string::npos) << old;
        changed.replace(at, old.size(), by);
        return changed;
    };
    EXPECT_NO_THROW(parse_scene(text, "c4"));
    const std::pair<const char*, const char*> wrong[] = {
        {"\"plane_height\": 0.003", "\"plane_height\": 0.007"},
        {"\"areolar_height\": 0.006", "\"areolar_height\": 0.017"},
        {"\"width\": 0.056", "\"width\": 0.12"},
        {"\"count\": 4", "\"count\": 12"},
        {"\"layout\": \"rectum\"", "\"layout\": \"colon\""},
        {"\"promontory_angle_deg\": 41", "\"promontory_angle_deg\": 80"},
        {"\"first_angle_deg\": 36", "\"first_angle_deg\": 48"},
    };
    for (const auto& [old, by] : wrong) {
        try {
            parse_scene(with(old, by), "c4");
            ADD_FAILURE() << by;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("c4"), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace fulcrum
