// SPDX-License-Identifier: Apache-2.0
// Random two-handed scripts on every scene: grasp, pull, twist, cross, hand over, let go. Whatever the hands
// do, jaws exert no more than their faces hold, every value stays finite and the tissue gains no energy.
//
// The world has no account of its energy: contacts, friction and bands have none. What is held to a bound is
// the elastic and kinetic energy of bowel, membranes and sheet: when all is at rest again it is at most that
// of the same scene that nobody touched, and the work of the hands (force times path, all of it counted as
// put in). In between, speeds are bounded.
//
// FULCRUM_BIMANUAL_SCRIPTS: how many scripts in all (default 27; 2,000 is the full test).
// FULCRUM_BIMANUAL_PAGE: a folder for the page bimanual.md; the command that it names makes it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "sim_core/contact/jaws.h"
#include "sim_core/lab/chart.h"
#include "sim_core/lab/result_page.h"
#include "sim_core/numerics/random.h"
#include "sim_core/world/parts/membranes/membranes_part.h"
#include "tests/sim_core/world/hands_on_tissue.h"

namespace fulcrum {
namespace {

/// That have hands.
std::vector<std::string> all_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_path("assets/scenes"))) {
        if (entry.path().extension() != ".json") continue;
        if (!load_scene(entry.path().string()).instruments.empty())
            names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// In CI three for each scene: one alone may meet no tissue.
int scripts_in_all(std::size_t scenes) {
    const char* asked = std::getenv("FULCRUM_BIMANUAL_SCRIPTS");
    return asked != nullptr ? std::max(1, std::atoi(asked)) : 3 * static_cast<int>(scenes);
}

int scripts_of(std::size_t scene, std::size_t scenes) {
    const int all = scripts_in_all(scenes);
    return all / static_cast<int>(scenes) + (scene < static_cast<std::size_t>(all) % scenes ? 1 : 0);
}

/// Where hands find tissue now: any place of any part.
Vector3 somewhere_on_tissue(const World& world, Random& random) {
    const WorldSnapshot& now = world.snapshot();
    std::vector<Vector3> places;
    const auto pick = [&](const std::vector<Vector3>& of, std::size_t count) {
        if (count > 0)
            places.push_back(of[static_cast<std::size_t>(random.uniform() * static_cast<double>(count))]);
    };
    pick(now.bowel.nodes, now.bowel.nodes.size());
    if (!now.bowel.nodes.empty()) places.back() += world.scene().bowel->outer_radius * Vector3::UnitZ();
    for (const MembraneView& membrane : now.membranes) pick(membrane.positions, membrane.positions.size());
    pick(now.sheet.positions, static_cast<std::size_t>(now.sheet.vertex_count));
    if (const std::vector<BandView>& bands = now.bands.bands; !bands.empty()) {
        const auto band = static_cast<std::size_t>(random.uniform() * static_cast<double>(bands.size()));
        places.push_back(bands[band].position[strand_nodes / 2]);
    }
    if (!now.objects.objects.empty())
        places.push_back(
            now.objects.objects[random.below(static_cast<std::uint32_t>(now.objects.objects.size()))]
                .position);
    for (const TargetSphere& target : now.targets) places.push_back(target.centre);
    if (places.empty()) return Vector3::Zero();
    return places[static_cast<std::size_t>(random.uniform() * static_cast<double>(places.size()))];
}

struct Script {
    test::SheetRig& rig;
    Random random;
    double most_excess = 0;                      ///< N, of a reaction over what the faces hold
    double bowel_speed = 0, membrane_speed = 0;  ///< m/s, largest
    double largest = 0;                          ///< N, reaction
    double work = 0;                             ///< J, of the hands, at most
    Vector3 worked_from[hand_count];             ///< tip at the last step, m
    double rolled_from[hand_count] = {0, 0};     ///< rad
    double force_before[hand_count] = {0, 0};    ///< N
    int held_steps = 0, both_held = 0, twisted = 0;
    std::int32_t area[hand_count] = {0, 0};  ///< as samples have it, of the present hold
    std::uint32_t worst_outcome = 0;

    Random twists;  ///< of its own, so that the other actions are those that they were without twists

    Script(test::SheetRig& on, std::uint64_t seed)
        : rig(on),
          random(seed, 0x62696d61),
          worked_from{on.wish[0].tip, on.wish[1].tip},
          twists(seed, 0x74776973) {}

    double signed_unit() { return 2 * random.uniform() - 1; }
    Vector3 direction() { return Vector3(signed_unit(), signed_unit(), signed_unit() + 0.3).normalized(); }
    /// Force times path, tip and turn of the jaws, whichever direction.
    void add_work(int h) {
        constexpr double jaw_reach = 0.02;  // m, from the shaft to tissue between the jaws, at most
        const test::Wish& wish = rig.wish[h];
        const double force =
            std::max(test::recorded_force(rig, h), rig.world.snapshot().grasps[h].reaction.norm());
        work += std::max(force, force_before[h]) *
                ((wish.tip - worked_from[h]).norm() + jaw_reach * std::abs(wish.roll - rolled_from[h]));
        worked_from[h] = wish.tip;
        rolled_from[h] = wish.roll;
        force_before[h] = force;
    }
    void check() {
        const World& world = rig.world;
        for (int h = 0; h < hand_count; ++h) {
            const GraspState& grasp = world.snapshot().grasps[h];
            ASSERT_TRUE(grasp.reaction.allFinite() && grasp.point.allFinite());
            ASSERT_TRUE(std::isfinite(test::recorded_force(rig, h)));
            add_work(h);
            const HandSample& sample = rig.outputs.back().sample.hand[h];
            const bool grasping = (sample.flags & hand_grasping) != 0;
            if (grasping && area[h] > 0) {
                ASSERT_EQ(sample.jaw_area, area[h]);
            }
            area[h] = grasping ? sample.jaw_area : 0;
            if (!grasp.held || grasp.tissue < 0) continue;
            ++held_steps;
            both_held += world.snapshot().grasps[1 - h].held ? 1 : 0;
            largest = std::max(largest, grasp.reaction.norm());
            const TissueSpec& tissue = world.scene().tissues[static_cast<std::size_t>(grasp.tissue)];
            const double holds = jaw_capacity(rig.outputs.back().contact[h].tool.grip, tissue.friction);
            most_excess = std::max(most_excess, grasp.reaction.norm() - holds);
        }
        for (const Vector3& node : world.snapshot().bowel.nodes) ASSERT_TRUE(node.allFinite());
        for (const MembraneView& membrane : world.snapshot().membranes)
            for (const Vector3& place : membrane.positions) ASSERT_TRUE(place.allFinite());
        const SheetView& sheet = world.snapshot().sheet;
        for (std::size_t v = 0; v < static_cast<std::size_t>(sheet.vertex_count); ++v)
            ASSERT_TRUE(sheet.positions[v].allFinite());
        if (const BowelPart* bowel = rig.world.find<BowelPart>()) {
            for (const Vector3& velocity : bowel->state().velocities)
                bowel_speed = std::max(bowel_speed, velocity.norm());
        }
        if (const MembranesPart* membranes = rig.world.find<MembranesPart>()) {
            for (const MembranePart& membrane : membranes->membranes())
                for (const Vector3& velocity : membrane.state().velocities)
                    membrane_speed = std::max(membrane_speed, velocity.norm());
        }
        worst_outcome = std::max(worst_outcome, rig.record.outcome);
    }
    /// Both hands to their targets at speeds of their own, checked in every step.
    void move(const Vector3 (&to)[hand_count], double seconds) {
        const Vector3 from[hand_count] = {rig.wish[0].tip, rig.wish[1].tip};
        const int count = std::max(1, static_cast<int>(seconds / 0.005));
        for (int i = 1; i <= count; ++i) {
            for (int h = 0; h < hand_count; ++h)
                rig.wish[h].tip = from[h] + (static_cast<double>(i) / count) * (to[h] - from[h]);
            rig.step();
            check();
            if (testing::Test::HasFatalFailure()) return;
        }
    }
    /// One hand turns about its shaft, holding or not, by up to half a turn; slowly or as fast as fingers do.
    void twist() {
        const int h = twists.uniform() < 0.5 ? 0 : 1;
        const double from = rig.wish[h].roll, by = std::acos(-1.0) * (2 * twists.uniform() - 1);
        const int count = twists.uniform() < 0.3 ? 20 : 80;  // 0.1 s, 0.4 s
        for (int i = 1; i <= count && !testing::Test::HasFatalFailure(); ++i) {
            rig.wish[h].roll = from + by * i / count;
            rig.step();
            check();
        }
        twisted += rig.world.snapshot().grasps[h].held ? 1 : 0;
    }
    void one_action() {
        Vector3 to[hand_count] = {rig.wish[0].tip, rig.wish[1].tip};
        const int h = random.uniform() < 0.5 ? 0 : 1;
        const double kind = random.uniform();
        if (kind < 0.35) {  // grasp: open, go there, close
            rig.wish[h].closed = false;
            const Vector3 place = somewhere_on_tissue(rig.world, random);
            to[h] = test::tip_for_jaws(rig, h, place + Vector3(0, 0, 0.02));
            move(to, 0.25);
            to[h] = test::tip_for_jaws(rig, h, place);
            move(to, 0.1);
            rig.wish[h].closed = true;
            move(to, 0.15);
        } else if (kind < 0.6) {  // pull, slowly or with a jerk
            to[h] += 0.06 * random.uniform() * direction();
            move(to, random.uniform() < 0.3 ? 0.05 : 0.4);
        } else if (kind < 0.75) {  // pull apart or cross
            const double by = 0.05 * signed_unit();
            const Vector3 line = (to[1] - to[0]).norm() > 1e-6 ? Vector3((to[1] - to[0]).normalized())
                                                               : Vector3(Vector3::UnitX());
            to[0] -= by * line;
            to[1] += by * line;
            move(to, 0.3);
        } else if (kind < 0.9) {  // hand over: the other hand takes hold where this one holds
            rig.wish[1 - h].closed = false;
            const Vector3 place =
                rig.world.snapshot().grasps[h].point + 0.015 * random.uniform() * direction();
            to[1 - h] = test::tip_for_jaws(rig, 1 - h, place + Vector3(0, 0, 0.02));
            move(to, 0.2);
            to[1 - h] = test::tip_for_jaws(rig, 1 - h, place);
            move(to, 0.1);
            rig.wish[1 - h].closed = true;
            move(to, 0.15);
            if (random.uniform() < 0.7) rig.wish[h].closed = false;
            move(to, 0.1);
        } else {  // let go
            rig.wish[h].closed = false;
            move(to, 0.1);
        }
    }
};

/// J, elastic and kinetic, of the parts that have such an account.
double energy_of(const World& world) {
    double sum = 0;
    if (const BowelPart* bowel = world.find<BowelPart>()) {
        const RodEnergy energy = bowel->rod().energy(bowel->state(), RodInputs{});
        sum += energy.elastic() + energy.kinetic;
    }
    if (const MembranesPart* membranes = world.find<MembranesPart>()) {
        for (const MembranePart& membrane : membranes->membranes()) {
            const MembraneEnergy energy = membrane.membrane().energy(membrane.state());
            sum += energy.elastic() + energy.kinetic;
        }
    }
    if (const SheetPart* sheet = world.find<SheetPart>()) {
        const MembraneEnergy energy = sheet->membrane().energy(sheet->state().membrane);
        sum += energy.elastic() + energy.kinetic;
    }
    return sum;
}

/// What the scripts of one scene came to.
struct ScriptFigures {
    std::string scene;
    int scripts = 0, held_steps = 0, both_held = 0, twisted = 0;
    double largest = 0, excess = 0;              // N
    double work = 0, stored = 0;                 // J, of the script with most
    double bowel_speed = 0, membrane_speed = 0;  // m/s, while the hands act
    double bowel_left = 0, membrane_left = 0;    // m/s, when they have been away for 1.5 s
    std::uint32_t outcome = 0;
};

class Bimanual : public testing::TestWithParam<std::string> {
  protected:
    static std::vector<ScriptFigures>& figures() {
        static std::vector<ScriptFigures> all;
        return all;
    }
    static void TearDownTestSuite() {
        const char* folder = std::getenv("FULCRUM_BIMANUAL_PAGE");
        if (folder == nullptr || testing::UnitTest::GetInstance()->failed_test_count() > 0) return;
        const std::string count = std::to_string(scripts_in_all(all_scenes().size()));
        lab::ResultPage page("bimanual", count + " random scripts of two hands",
                             "FULCRUM_BIMANUAL_SCRIPTS=" + count + " FULCRUM_BIMANUAL_PAGE=" + folder +
                                 " test_sim_core --gtest_filter=Scenes/Bimanual.*");
        page.paragraph(
            "Two graspers do eight random actions in every scene that has hands: grasp, pull slowly or with "
            "a "
            "jerk, pull apart, cross, hand over, let go; before each, with a chance of 0.3, one of them "
            "twists by up to half a turn. Every value is checked for being finite in every "
            "step. Excess: reaction of a hold over what the faces of its jaws can hold by friction. Speeds "
            "bound the energy: the largest while the hands act, and what is left when both have let go and "
            "been away for 1.5 s (at most 0.02 m/s for bowel, 0.05 m/s for membranes). "
            "Stored: elastic and kinetic energy of bowel, membranes and sheet at that time over that of the "
            "scene that nobody touched; at most the work of the hands. Worst outcome of a "
            "step: "
            "0 normal, 1 made in smaller steps, 2 a part kept still, 3 restored, 4 a fault of the "
            "simulator.");
        lab::ResultTable table;
        table.name = "bimanual";
        table.columns = {"scene",           "scripts",      "steps with a hold", "of these with both hands",
                         "twists of holds", "largest, N",   "excess, N",         "bowel, m/s",
                         "membrane, m/s",   "bowel after",  "membrane after",    "work, J",
                         "stored, J",       "worst outcome"};
        for (const ScriptFigures& one : figures())
            table.rows.push_back(
                {one.scene, std::to_string(one.scripts), std::to_string(one.held_steps),
                 std::to_string(one.both_held), std::to_string(one.twisted), lab::short_number(one.largest),
                 lab::short_number(std::max(0.0, one.excess)), lab::short_number(one.bowel_speed),
                 lab::short_number(one.membrane_speed), lab::short_number(one.bowel_left),
                 lab::short_number(one.membrane_left), lab::short_number(one.work),
                 lab::short_number(one.stored), std::to_string(one.outcome)});
        page.table(table);
        page.write(folder, lab::this_machine(lab::build_info()));
    }
};

/// J, of the scene that nobody touches.
double energy_at_rest(const Scene& scene) {
    test::SheetRig rig(scene);
    rig.steps(400);
    return energy_of(rig.world);
}

TEST_P(Bimanual, RandomScriptsStayWithinWhatJawsHold) {
    const std::vector<std::string> scenes = all_scenes();
    const auto number =
        static_cast<std::size_t>(std::find(scenes.begin(), scenes.end(), GetParam()) - scenes.begin());
    const Scene scene = test::two_graspers(GetParam());
    ScriptFigures sum;
    sum.scene = GetParam();
    const double untouched = energy_at_rest(scene);
    for (int script = 0; script < scripts_of(number, scenes.size()); ++script) {
        test::SheetRig rig(scene);
        Script run(rig, 1000 * number + static_cast<std::uint64_t>(script));
        for (int action = 0; action < 8; ++action) {
            if (run.twists.uniform() < 0.3) run.twist();
            run.one_action();
            if (HasFatalFailure()) {
                ADD_FAILURE() << "script " << script << ", action " << action;
                return;
            }
        }
        ++sum.scripts;
        sum.held_steps += run.held_steps;
        sum.both_held += run.both_held;
        sum.twisted += run.twisted;
        sum.largest = std::max(sum.largest, run.largest);
        sum.excess = std::max(sum.excess, run.most_excess);
        sum.bowel_speed = std::max(sum.bowel_speed, run.bowel_speed);
        sum.membrane_speed = std::max(sum.membrane_speed, run.membrane_speed);
        sum.outcome = std::max(sum.outcome, run.worst_outcome);
        EXPECT_LE(run.most_excess, 1e-6) << "script " << script;
        EXPECT_LT(run.bowel_speed, 5) << "script " << script;
        EXPECT_LT(run.membrane_speed, 20) << "script " << script << ": 0.1 g snap back from a pull";
        EXPECT_LT(run.worst_outcome, 4U) << "script " << script;
        // Left alone it comes to rest: what the hands put in is gone, nothing was gained.
        for (test::Wish& wish : rig.wish) wish.closed = false;
        rig.steps(20);
        Vector3 away[hand_count];
        for (int h = 0; h < hand_count; ++h) {
            const Vector3 trocar = rig.trocar[h].position;
            away[h] = trocar + 0.02 * (rig.wish[h].tip - trocar).normalized();
        }
        run.move(away, 0.3);
        rig.steps(300);
        run.bowel_speed = run.membrane_speed = 0;
        run.check();
        sum.bowel_left = std::max(sum.bowel_left, run.bowel_speed);
        sum.membrane_left = std::max(sum.membrane_left, run.membrane_speed);
        EXPECT_LT(run.bowel_speed, 0.02) << "script " << script << ": it does not come to rest";
        EXPECT_LT(run.membrane_speed, 0.05) << "script " << script << ": it does not come to rest";
        // 0.02 J: 0.1 kg of bowel that has another 2 cm to fall to where it comes to rest.
        const double stored = energy_of(rig.world) - untouched;
        EXPECT_LE(stored, run.work + 0.02) << "script " << script << ": it has more than the hands put in";
        sum.work = std::max(sum.work, run.work);
        sum.stored = std::max(sum.stored, stored);
    }
    figures().push_back(sum);
    const std::string counts = std::to_string(sum.held_steps) + " steps of a hand that holds, " +
                               std::to_string(sum.both_held) + " of both, largest force " +
                               std::to_string(sum.largest) + " N";
    RecordProperty("holds", counts);
    std::cout << GetParam() << ": " << counts << "\n";
    if (scene.bowel || scene.sheet) {
        EXPECT_GT(sum.held_steps, 0) << "the scripts grasp something";
    }
}

// A script among 2,000: the hand that let go was in a fold of the rectum, the place nearest to it changed
// from 11 to 42 mm of depth, and the push of 20 N folded a segment over (47 m/s).
TEST(BimanualScript, ThatLeavesAHandInAFoldMovesNothingAtOnce) {
    test::SheetRig rig(test::two_graspers("c4_posterior_narrow"));
    const std::vector<std::string> scenes = all_scenes();
    const auto number = static_cast<std::uint64_t>(
        std::find(scenes.begin(), scenes.end(), "c4_posterior_narrow") - scenes.begin());
    Script run(rig, 1000 * number + 86);
    for (int action = 0; action < 8 && !HasFatalFailure(); ++action) run.one_action();
    EXPECT_LT(run.bowel_speed, 2);
    EXPECT_LT(run.worst_outcome, 2U);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Bimanual, testing::ValuesIn(all_scenes()),
                         [](const testing::TestParamInfo<std::string>& scene) { return scene.param; });

}  // namespace
}  // namespace fulcrum
