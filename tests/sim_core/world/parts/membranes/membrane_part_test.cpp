// SPDX-License-Identifier: Apache-2.0
// The mesentery of masses and springs in the world: two-displacement with the rod, momentum kept, drawn,
// hashed.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/anatomy/scene_anatomy.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/lab/membrane_reference.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/world/couplings/membranes_on_bowel.h"
#include "sim_core/world/parts/bowel/bowel_anatomy.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/parts/membranes/membranes_part.h"
#include "sim_core/world/world.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr double dt = 0.005;

/// A straight rod with a sheet on its side, in space.
struct Pair {
    Scene scene;
    Rod rod;
    RodState state;
    RodScratch scratch;
    RodInputs inputs;
    MembraneSheet sheet;
    std::unique_ptr<MembranePart> part;
    std::unique_ptr<MembraneEdge> edge;

    static RodSpec rod_spec(RodEnd end) {
        RodSpec spec;
        spec.segments = 24;
        spec.length = 0.3;
        spec.mass_damping = 0;
        spec.ends[0] = spec.ends[1] = end;
        return spec;
    }
    static MembraneSpec mesentery() {
        MembraneSpec spec;
        spec.mass_damping = 0;
        return spec;
    }
    Pair(RodEnd end, bool root_held, const MembraneSpec& spec)
        : rod(rod_spec(end)), state(rod.make_state()), scratch(rod.make_scratch()) {
        scene.membranes = {spec};
        scene.fidelity.membrane = MembraneIntegrator::implicit;
        const int rows = 31, columns = 9;
        sheet.mesh = lab::make_sheet(columns, rows, 0.06, 0.24);
        for (Vector3& p : sheet.mesh.vertices) p = Vector3(0.03 + p.y(), 0.012 + p.x(), 0);
        for (int r = 0; r < rows; ++r) {
            sheet.bowel_vertices.push_back(r * columns);
            sheet.bowel_arc_lengths.push_back(sheet.mesh.vertices[static_cast<std::size_t>(r * columns)].x());
            if (root_held) sheet.wall_vertices.push_back(r * columns + columns - 1);
        }
        inputs.ends[0] = state.ends[0];
        inputs.ends[1] = state.ends[1];
        inputs.loads.reserve(64);
        part = std::make_unique<MembranePart>(scene, 0, sheet, dt);
        edge = std::make_unique<MembraneEdge>(scene, 0, *part, sheet, rod, state, dt);
    }
    std::uint32_t step_sheet() {
        edge->carry(rod, state, dt);
        const std::uint32_t outcome = part->step(dt);
        edge->sum_pulls(rod, state);
        inputs.loads = edge->pulls();
        return outcome;
    }
    std::uint32_t step() {
        const std::uint32_t outcome = step_sheet();
        rod.step(state, inputs, dt, scratch);
        return outcome;
    }
    Vector3 rod_momentum() const {
        Vector3 sum = Vector3::Zero();
        for (int i = 0; i <= rod.segments(); ++i)
            sum += rod.node_mass(i) * state.velocities[static_cast<std::size_t>(i)];
        return sum;
    }
    Vector3 sheet_momentum() const {
        Vector3 sum = Vector3::Zero();
        for (std::size_t v = 0; v < part->state().velocities.size(); ++v)
            sum += part->membrane().masses()[v] * part->state().velocities[v];
        return sum;
    }
};

TEST(MembranePart, RodAndSheetExchangeEqualAndOppositeMomentum) {
    Pair pair(RodEnd::free, false, Pair::mesentery());
    // Both drift free in space; the rod is thrown across the sheet. Momentum lost by one is gained by the
    // other in every step.
    for (Vector3& v : pair.state.velocities) v = Vector3(0, -0.2, 0.5);
    Vector3 given = Vector3::Zero();
    double size = 0;
    for (int i = 0; i < 100; ++i) {
        const Vector3 rod_before = pair.rod_momentum(), sheet_before = pair.sheet_momentum();
        ASSERT_EQ(pair.step(), 0U);
        const Vector3 impulse = dt * pair.edge->pull();
        Vector3 support = Vector3::Zero();
        for (const Vector3& r : pair.part->inputs().reactions) support += r;
        EXPECT_LT((support + pair.edge->pull()).norm(), 1e-12) << "exactly the same force";
        EXPECT_LT((pair.sheet_momentum() - sheet_before + impulse).norm(), 1e-9);
        EXPECT_LT((pair.rod_momentum() - rod_before - impulse).norm(), 1e-8);
        given += impulse;
        size += impulse.norm();
    }
    EXPECT_GT(size, 1e-3) << "they must have exchanged force";
}

TEST(MembranePart, PullingTheMesenteryBendsTheRod) {
    Pair pair(RodEnd::clamped, true, Pair::mesentery());
    for (int i = 0; i < 20; ++i) pair.step();
    EXPECT_LT(pair.edge->pull().norm(), 1e-9) << "no force at rest";
    const Vector3 before = pair.rod.wall_point(pair.state, 0.15, Vector3::Zero());
    // The bowel bends towards a root that retracts: the sheet shortens as if shrunk by a quarter.
    MembraneSpec tight = Pair::mesentery();
    tight.pre_strain = 0.3;
    Pair pulled(RodEnd::clamped, true, tight);
    for (int i = 0; i < 600; ++i) ASSERT_EQ(pulled.step(), 0U);
    const Vector3 after = pulled.rod.wall_point(pulled.state, 0.15, Vector3::Zero());
    EXPECT_GT(after.y() - before.y(), 0.003);
    EXPECT_GT(pulled.edge->pull().y(), 0.02);
    // In equilibrium the rod's ends carry the pull of the sheet.
    pulled.step_sheet();
    const RodReport report = pulled.rod.step(pulled.state, pulled.inputs, dt, pulled.scratch);
    const Vector3 ends = report.end_force[0] + report.end_force[1];
    EXPECT_LT((ends + pulled.edge->pull()).norm(), 0.03 * pulled.edge->pull().norm());
}

TEST(MembranePart, GraspedSheetPullsOnRodAndJaws) {
    // Rod and sheet drift free in space, held only by the jaws: the jaws' impulse equals their total gain in
    // momentum.
    Pair pair(RodEnd::free, false, Pair::mesentery());
    double least = 1e-4;
    Vector3 point;
    const std::int32_t triangle = pair.part->nearest_triangle(Vector3(0.15, 0.05, 0.002), least, point);
    ASSERT_GE(triangle, 0);
    EXPECT_NEAR(least, 4e-6, 1e-9);
    pair.part->take(0, triangle, point, 800);
    double size = 0;
    for (int i = 0; i < 60; ++i) {
        const Vector3 rod_before = pair.rod_momentum(), sheet_before = pair.sheet_momentum();
        point += Vector3(0, 1e-4, 1e-4);
        pair.part->carry(0, point);
        ASSERT_EQ(pair.step(), 0U);
        const Vector3 jaws = dt * pair.part->grip(0).reaction, passed_on = dt * pair.edge->pull();
        EXPECT_LT((pair.sheet_momentum() - sheet_before - jaws + passed_on).norm(), 1e-9);
        EXPECT_LT((pair.rod_momentum() - rod_before - passed_on).norm(), 1e-8);
        size += jaws.norm();
    }
    EXPECT_GT(size, 1e-3);
    EXPECT_GT(pair.rod_momentum().y(), 1e-4) << "the rod follows";
    EXPECT_LT((pair.part->grip(0).point - point).norm(), 1e-3);
    EXPECT_GT(pair.part->grip_stiffness(0), 10);
    EXPECT_LT(pair.part->grip_stiffness(0), 800);
    pair.part->let_go(0);
    pair.step();
    EXPECT_EQ(pair.part->grip(0).reaction, Vector3::Zero());
    EXPECT_EQ(pair.part->grip_stiffness(0), 0);
}

TEST(MembranePart, PullingTheHeldMesenteryBendsTheRod) {
    Pair pair(RodEnd::clamped, true, Pair::mesentery());
    double least = 1e-4;
    Vector3 point;
    pair.part->take(0, pair.part->nearest_triangle(Vector3(0.15, 0.03, 0), least, point), point, 800);
    const Vector3 before = pair.rod.wall_point(pair.state, 0.15, Vector3::Zero());
    for (int i = 0; i < 600; ++i) {
        if (i < 200) point.z() += 1e-4;  // 20 mm out of the sheet's plane
        pair.part->carry(0, point);
        ASSERT_EQ(pair.step(), 0U);
    }
    const Vector3 bent = pair.rod.wall_point(pair.state, 0.15, Vector3::Zero()) - before;
    EXPECT_GT(bent.z(), 0.001) << "the rod follows the jaws";
    // At rest the jaws' force is carried by the root and, through the sheet, by the rod's ends.
    pair.step_sheet();
    const RodReport report = pair.rod.step(pair.state, pair.inputs, dt, pair.scratch);
    const Vector3 jaws = pair.part->grip(0).reaction;
    Vector3 supports = Vector3::Zero();
    for (const Vector3& r : pair.part->inputs().reactions) supports += r;
    EXPECT_GT(jaws.z(), 0.05);
    EXPECT_LT((jaws + supports).norm(), 0.01 * jaws.norm());
    EXPECT_LT((report.end_force[0] + report.end_force[1] + pair.edge->pull()).norm(),
              0.03 * pair.edge->pull().norm());
}

TEST(MembranePart, GraspedSheetInTheWorldPullsOnTheJawsAndBendsTheBowel) {
    Scene scene = load_scene(test::source_path("assets/scenes/b1_mesentery.json"));
    scene.fidelity.membrane_iterations = 12;  // momentum is closed but for the solve's residual
    World world(scene, 1);
    const MembranePart& part = world.find<MembranesPart>()->membranes()[0];
    const MembraneEdge& edge = world.find<MembranesOnBowel>()->edges()[0];
    const Membrane& membrane = part.membrane();
    // The free vertex farthest from the sheet's held edges and from the bowel.
    std::int32_t chosen = -1;
    double best = 0;
    for (std::int32_t v = 0; v < membrane.vertices(); ++v) {
        const Vector3& p = part.state().positions[static_cast<std::size_t>(v)];
        double nearest = 1;
        for (const std::int32_t held : membrane.attached())
            nearest = std::min(nearest, (p - part.state().positions[static_cast<std::size_t>(held)]).norm());
        if (nearest <= best) continue;
        best = nearest;
        chosen = v;
    }
    ASSERT_GE(chosen, 0);
    const InstrumentSpec& grasper = scene.instruments[0];
    TickOutput output;
    ToolKinematics& tool = output.contact[0].tool;
    tool.present = tool.inside = true;
    tool.insertion = 0.1;
    tool.tip =
        part.state().positions[static_cast<std::size_t>(chosen)] + 0.5 * grasper.jaw_length * tool.axis;
    tool.jaw_angle = grasper.jaw_opening;
    double unexplained = 0, exchanged = 0;  // N s
    const auto step = [&](int steps, const Vector3& displacement) {
        for (int i = 0; i < steps; ++i) {
            output.sample.tick += 5;
            tool.tip += displacement;
            tool.tip_velocity = displacement / dt;
            const Vector3 before = [&] {
                Vector3 sum = Vector3::Zero();
                for (std::size_t v = 0; v < membrane.masses().size(); ++v)
                    sum += membrane.masses()[v] * part.state().velocities[v];
                return sum;
            }();
            ASSERT_EQ(world.step(&output, 1).outcome, 0U);
            // Only supports, jaws and drag change the sheet's momentum; its support at the bowel is the rod's
            // load.
            Vector3 after = Vector3::Zero(), supports = Vector3::Zero(), drag = Vector3::Zero();
            for (std::size_t v = 0; v < membrane.masses().size(); ++v)
                after += membrane.masses()[v] * part.state().velocities[v];
            for (const Vector3& r : part.inputs().reactions) supports += r;
            for (std::size_t v = 0; v < membrane.masses().size(); ++v)
                drag -= membrane.material().mass_damping * membrane.masses()[v] * part.state().velocities[v];
            const Vector3 weight = membrane.material().mass * part.inputs().gravity;
            const Vector3 forces = supports + part.grip(0).reaction + drag + weight;
            unexplained += (after - before - dt * forces).norm();
            exchanged += dt * (edge.pull().norm() + part.grip(0).reaction.norm());
            Vector3 held = Vector3::Zero();
            for (std::size_t k = 0; k < part.attachments(); ++k) held += part.inputs().reactions[k];
            EXPECT_LT((held + edge.pull()).norm(), 1e-12);
        }
    };
    step(4, Vector3::Zero());
    EXPECT_FALSE(part.grip(0).held);
    tool.jaw_angle = 0;
    tool.grip = grasper.grip_force;
    step(4, Vector3::Zero());
    ASSERT_TRUE(part.grip(0).held);
    EXPECT_FALSE(world.find<BowelPart>()->grasp(Hand::left).held);
    const std::vector<Vector3> nodes = world.find<BowelPart>()->state().nodes;
    const Triangle& corners = membrane.triangles()[static_cast<std::size_t>(part.grip(0).triangle)];
    const auto corner = [&](std::size_t c) {
        return part.state().positions[static_cast<std::size_t>(corners[c])];
    };
    const Vector3 out = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    step(60, 2e-4 * out);  // 40 mm/s
    ASSERT_TRUE(part.grip(0).held);
    EXPECT_GT(part.grip(0).reaction.dot(out), 0.02);
    const LocalModel& model = world.local_models().hand[0];
    EXPECT_EQ(model.mode, LocalMode::grasp);
    EXPECT_EQ(model.grasp.reaction, part.grip(0).reaction) << "the hand feels the force on the sheet";
    EXPECT_GT(model.grasp.stiffness(0, 0), 1);
    const WorldSnapshot& snapshot = world.snapshot();
    EXPECT_TRUE(snapshot.grasps[0].held);
    EXPECT_EQ(snapshot.grasps[0].reaction, part.grip(0).reaction);
    EXPECT_EQ(snapshot.grasps[0].point, part.grip(0).point);
    EXPECT_LT(snapshot.grasps[0].arc_length, 0) << "no position along the bowel";
    EXPECT_FALSE(snapshot.grasps[1].held);
    double moved = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        moved = std::max(moved, (world.find<BowelPart>()->state().nodes[i] - nodes[i]).norm());
    EXPECT_GT(moved, 5e-4) << "the bowel follows";
    tool.jaw_angle = grasper.jaw_opening;
    step(2, Vector3::Zero());
    EXPECT_FALSE(part.grip(0).held);
    EXPECT_FALSE(snapshot.grasps[0].held || snapshot.grasps[0].slipped) << "released";
    EXPECT_NE(world.local_models().hand[0].mode, LocalMode::grasp);
    EXPECT_GT(exchanged, 0.1);
    EXPECT_LT(unexplained, 0.02 * exchanged) << "residual of the solve";
}

TEST(MembranePart, JawsOfAnExchangedInstrumentTakeNothingBeforeTheyWereOpen) {
    const Scene scene = load_scene(test::source_path("assets/scenes/b1_mesentery.json"));
    MembranesPart part(scene);
    const MembranePart& sheet = part.membranes()[0];
    Vector3 place = Vector3::Zero();  // in the middle of a triangle that can move
    for (const Triangle& corners : sheet.membrane().triangles()) {
        if (!sheet.membrane().any_free(corners)) continue;
        place.setZero();
        for (const std::int32_t corner : corners)
            place += sheet.state().positions[static_cast<std::size_t>(corner)] / 3;
    }
    const InstrumentSpec& grasper = scene.instruments[0];
    InstrumentSpec hook = grasper;
    hook.kind = InstrumentKind::hook;
    StepInput input;
    input.dt = dt;
    input.taker[0] = &part;
    ToolKinematics& tool = input.held[0].tool;
    tool.present = tool.inside = true;
    tool.tip = place + 0.5 * grasper.jaw_length * tool.axis;
    const auto holds_with = [&](const InstrumentSpec& spec, bool closed) {
        input.held[0].instrument = &spec;
        tool.jaw_angle = closed ? 0.02 : spec.jaw_opening;
        tool.grip = closed ? 4 : 0;
        part.apply(input);
        return part.holds(0);
    };
    EXPECT_FALSE(holds_with(hook, true));
    EXPECT_FALSE(holds_with(grasper, true)) << "closed since before the exchange";
    EXPECT_FALSE(holds_with(grasper, false));
    EXPECT_TRUE(holds_with(grasper, true));
}

TEST(MembranePart, RefusesMembranesTooHeavyForTheRod) {
    MembraneSpec stiff = Pair::mesentery();
    EXPECT_LT(Pair(RodEnd::clamped, true, stiff).edge->coupling(), 0.5);
    stiff.structural_stiffness = 10000;
    stiff.shear_stiffness = 10000;
    EXPECT_THROW(Pair(RodEnd::clamped, true, stiff), InputError);
}

TEST(MembranePart, EveryIntegratorRunsTheScene) {
    for (const auto& [integrator, name, title] : membrane_integrators) {
        Scene scene = load_scene(test::source_path("assets/scenes/b1_mesentery.json"));
        scene.fidelity.membrane = integrator;
        const BowelAnatomy anatomy = bowel_anatomy(scene);
        const std::vector<MembraneSheet> sheets = lay_out_membranes(scene);
        ASSERT_EQ(sheets.size(), 1U);
        RodSpec spec;
        spec.ends[0] = spec.ends[1] = RodEnd::clamped;
        spec.segments = static_cast<int>(anatomy.centre_line.size()) - 1;
        spec.rest_nodes = anatomy.centre_line;
        const Rod rod(spec);
        RodState state = rod.make_state();
        RodScratch scratch = rod.make_scratch();
        RodInputs inputs;
        inputs.ends[0] = state.ends[0];
        inputs.ends[1] = state.ends[1];
        MembranePart part(scene, 0, sheets[0], dt);
        MembraneEdge edge(scene, 0, part, sheets[0], rod, state, dt);
        inputs.gravity = scene.gravity;
        for (int i = 0; i < 2; ++i) {
            edge.carry(rod, state, dt);
            EXPECT_EQ(part.step(dt), 0U) << name;
            edge.sum_pulls(rod, state);
            inputs.loads = edge.pulls();
            rod.step(state, inputs, dt, scratch);
        }
        EXPECT_TRUE(Membrane::finite(part.state()));
        EXPECT_GT(edge.pull().norm(), 1e-4) << name << ": the sagging bowel must load it";
    }
}

TEST(MembranePart, TheSnapshotShowsTheSheetOnTheBowel) {
    const Scene scene = load_scene(test::source_path("assets/scenes/b1_mesentery.json"));
    const World world(scene, 1);
    ASSERT_EQ(world.snapshot().membranes.size(), 1U);
    const MembraneView& view = world.snapshot().membranes[0];
    const MembranePart& part = world.find<MembranesPart>()->membranes()[0];
    EXPECT_EQ(view.positions.size(), part.membrane().masses().size());
    EXPECT_EQ(view.triangles, part.membrane().triangles());
    // The edge is on the bowel's wall: at the distance from the centre line given by the anatomy.
    const RodFrame frame =
        world.find<BowelPart>()->rod().frame_at(world.find<BowelPart>()->state(), 0.45).frame;
    double nearest = 1;
    for (const Vector3& p : view.positions) nearest = std::min(nearest, (p - frame.position).norm());
    EXPECT_GT(nearest, 0.5 * scene.bowel->outer_radius);
    EXPECT_LT(nearest, 1.2 * scene.bowel->outer_radius);
    bool listed = false;
    for (const PartCost& cost : world.costs()) {
        if (cost.part != "membranes") continue;
        listed = true;
        EXPECT_GT(cost.bytes, 100000U);
    }
    EXPECT_TRUE(listed);
}

}  // namespace
}  // namespace fulcrum
