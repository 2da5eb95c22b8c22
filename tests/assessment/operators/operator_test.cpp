// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/operator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "assessment/operators/limb.h"
#include "assessment/operators/skill.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"
#include "tests/assessment/operators/kinematic_world.h"
#include "tests/support/allocation_count.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

struct Stage {
    TaskDefinition task;
    Scene scene;
    explicit Stage(const std::string& id)
        : task(load_task(test::source_path("assets/tasks/" + id + ".json"))),
          scene(load_scene(test::source_path("assets/scenes/" + task.scene))) {}
};

struct Performance {
    double time = 0, path = 0, force = 0;
    bool completed = false;
};

Performance perform(const Stage& stage, OperatorLevel preset, std::uint64_t seed) {
    const auto rig = make_operator(preset, stage.task, stage.scene, seed);
    test::KinematicWorld world(stage.scene, stage.task, *rig, seed);
    world.run();
    return {world.display().elapsed_s, world.path(Hand::left) + world.path(Hand::right),
            world.largest_force(), world.display().end == EventKind::completed};
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

class OperatorOnTask : public testing::TestWithParam<std::string> {};

TEST_P(OperatorOnTask, EveryPresetCompletesAndTheExpertIsFasterAndTravelsLess) {
    const Stage stage(GetParam());
    std::vector<double> time[3], path[3];
    constexpr OperatorLevel presets[] = {OperatorLevel::expert, OperatorLevel::intermediate,
                                         OperatorLevel::novice};
    for (int p = 0; p < 3; ++p) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const Performance performance = perform(stage, presets[p], seed);
            EXPECT_TRUE(performance.completed) << row_of(operator_levels, presets[p]).name << " " << seed;
            time[p].push_back(performance.time);
            path[p].push_back(performance.path);
        }
    }
    EXPECT_LT(median(time[0]), 0.8 * median(time[2]));
    EXPECT_LT(median(path[0]), 0.8 * median(path[2]));
    EXPECT_LT(median(time[0]), median(time[1]));
    EXPECT_LT(median(time[1]), median(time[2]));
}

TEST_P(OperatorOnTask, SameSeedGivesTheSameMovementAndOtherSeedsDoNot) {
    const Stage stage(GetParam());
    const auto record = [&](std::uint64_t seed) {
        const auto rig = make_operator(OperatorLevel::novice, stage.task, stage.scene, seed);
        test::KinematicWorld world(stage.scene, stage.task, *rig, 3);
        world.run();
        return world.samples;
    };
    const std::vector<TickSample> a = record(11), b = record(11), c = record(12);
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(TickSample)), 0);
    EXPECT_TRUE(a.size() != c.size() || std::memcmp(a.data(), c.data(), a.size() * sizeof(TickSample)) != 0);
}

/// The tasks of which the kinematic world has everything: targets, and a bowel to run and to lift.
std::vector<std::string> kinematic_tasks() {
    const auto is_kinematic = [](const Goal& goal) {
        return goal.kind == GoalKind::touch_targets || goal.kind == GoalKind::run_bowel ||
               goal.kind == GoalKind::lift_and_hold;
    };
    std::vector<std::string> ids;
    for (const std::string& id : test::task_ids()) {
        const TaskDefinition task = load_task(test::source_path("assets/tasks/" + id + ".json"));
        if (std::all_of(task.goals.begin(), task.goals.end(), is_kinematic)) ids.push_back(id);
    }
    return ids;
}

INSTANTIATE_TEST_SUITE_P(Tasks, OperatorOnTask, testing::ValuesIn(kinematic_tasks()),
                         [](const auto& of) { return of.param; });

TEST(Operator, TasksOfTheKinematicWorldAreFound) {
    EXPECT_GE(kinematic_tasks().size(), 2U);
}

TEST(Operator, ExpertTouchesMoreGentlyThanTheNovice) {
    const Stage stage("A2");
    std::vector<double> expert, novice;
    for (std::uint64_t seed = 1; seed <= 9; ++seed) {
        expert.push_back(perform(stage, OperatorLevel::expert, seed).force);
        novice.push_back(perform(stage, OperatorLevel::novice, seed).force);
    }
    EXPECT_LT(median(expert), median(novice));
}

TEST(Operator, DoesNotReactBeforeItsReactionTime) {
    const Stage stage("A2");
    for (const OperatorLevel preset : {OperatorLevel::expert, OperatorLevel::novice}) {
        const auto rig = make_operator(preset, stage.task, stage.scene, 4);
        Skill skill;
        draw_individual(preset, 4, skill);
        draw_form(preset, 4, skill);
        const InstrumentModel model = make_instrument(*stage.scene.instrument(Hand::left), 1e-3);
        WorldSnapshot world;
        TaskDisplay display;
        world.targets.push_back({Vector3(0, 0.02, -0.02), 0.006, Hand::left});
        RigSample sample;
        std::uint32_t tick = 1;
        double before = 0, after = 0;
        rig->observe(world, display);
        for (; tick <= 3000; ++tick) {
            if (tick == 1000) display.active_target = 0;
            const Vector3 last = tool_pose(model, sample.hand[0]).tip;
            rig->read(tick, sample);
            const double speed = tick > 1 ? (tool_pose(model, sample.hand[0]).tip - last).norm() * 1000 : 0;
            // One reaction time and the shortest time to decide must pass before the hand moves.
            const double free_at = 1000 + 1000 * (skill.reaction_s + 0.6 * skill.choice_s);
            (tick < free_at ? before : after) = std::max(tick < free_at ? before : after, speed);
            if (tick % 5 == 0) rig->observe(world, display);
        }
        EXPECT_LT(before, 0.012) << row_of(operator_levels, preset).name << ": tremor alone, m/s";
        EXPECT_GT(after, 0.05) << row_of(operator_levels, preset).name;
    }
}

TEST(Operator, ReadNeitherAllocatesNorJumps) {
    const Stage stage("B1");
    const auto rig = make_operator(OperatorLevel::expert, stage.task, stage.scene, 2);
    WorldSnapshot world;
    for (int i = 0; i <= stage.scene.bowel->segments; ++i) {
        world.bowel.node_arc_lengths.push_back(stage.scene.bowel->length * i / stage.scene.bowel->segments);
        world.bowel.nodes.emplace_back(0.1 - 0.2 * i / stage.scene.bowel->segments, 0.05, -0.02);
    }
    const TaskDisplay display;
    rig->observe(world, display);
    RigSample sample, last;
    std::int32_t largest = 0;
    const std::uint64_t allocations = test::allocations_in([&] {
        for (std::uint32_t tick = 1; tick <= 20000; ++tick) {
            last = sample;
            rig->read(tick, sample);
            if (tick % 5 == 0) rig->observe(world, display);
            for (int h = 0; tick > 1 && h < hand_count; ++h) {
                for (int i = 0; i < 3; ++i)
                    largest = std::max(largest, std::abs(sample.hand[h].handle[i] - last.hand[h].handle[i]));
            }
        }
    });
    EXPECT_EQ(allocations, 0U);
    EXPECT_GT(largest, 0);
    EXPECT_LT(largest * device_length_unit, 0.001) << "1 m/s";
}

TEST(Operator, UnknownNamesAreRefused) {
    EXPECT_THROW(operator_level("wizard"), InputError);
    EXPECT_EQ(operator_level("novice"), OperatorLevel::novice);
    Stage one_handed("B1");
    one_handed.scene.instruments.resize(1);
    EXPECT_THROW(make_operator(OperatorLevel::expert, one_handed.task, one_handed.scene, 1), InputError);
}

TEST(Limb, SubMovementsAreMinimumJerkWithoutNoise) {
    Skill skill;
    skill.gain = 1;
    skill.gain_spread = skill.endpoint_noise = skill.path_noise = skill.tremor = skill.drift = 0;
    const Stage stage("A2");
    Limb limb(skill, stage.scene.instruments[0], 1e-3, Random(1));
    const Vector3 start = limb.destination();
    limb.carry(Vector3(0.06, 0, 0), 1.0);
    double peak = 0;
    Vector3 last = start;
    for (int i = 0; i < 1200; ++i) {
        limb.tick();
        peak = std::max(peak, (limb.tip() - last).norm() * 1000);
        last = limb.tip();
        if (i != 499) continue;
        EXPECT_NEAR((limb.tip() - start).x(), 0.03, 1e-5) << "half way at half time";
    }
    EXPECT_NEAR(peak, 1.875 * 0.06, 1e-4) << "peak speed of a minimum-jerk movement";
    EXPECT_NEAR((limb.tip() - start - Vector3(0.06, 0, 0)).norm(), 0, 1e-12);
}

TEST(Limb, TremorHasTheGivenStrengthBetweenEightAndTwelveHertz) {
    Skill skill;
    skill.path_noise = skill.drift = 0;
    skill.tremor = 2e-5;
    const Stage stage("A2");
    Limb limb(skill, stage.scene.instruments[0], 1e-3, Random(5));
    constexpr int n = 20000;
    std::vector<double> x;
    for (int i = 0; i < n; ++i) {
        limb.tick();
        x.push_back((limb.tip() - limb.destination()).x());
    }
    double power = 0, band = 0, all = 0;
    for (const double value : x) power += value * value / n;
    EXPECT_NEAR(std::sqrt(power), 2e-5, 0.4e-5);
    for (int k = 10; k <= 30 * 20; k += 2) {  // 0.5 to 30 Hz in steps of 0.1 Hz
        double re = 0, im = 0;
        for (int i = 0; i < n; ++i) {
            const double phase = 6.283185307179586 * k * i / n;
            re += x[static_cast<std::size_t>(i)] * math::cos(phase);
            im += x[static_cast<std::size_t>(i)] * math::sin(phase);
        }
        const double frequency = k / 20.0, share = re * re + im * im;
        all += share;
        if (frequency >= 7.5 && frequency <= 12.5) band += share;
    }
    EXPECT_GT(band, 0.95 * all);
}

TEST(Limb, EndpointErrorGrowsWithTheDistance) {
    Skill skill;
    skill.path_noise = skill.drift = skill.tremor = 0;
    skill.gain = 1;
    skill.gain_spread = 0;
    skill.endpoint_noise = 0.1;
    const Stage stage("A2");
    const auto spread = [&](double distance) {
        double squares = 0;
        Limb limb(skill, stage.scene.instruments[0], 1e-3, Random(9));
        for (int i = 0; i < 400; ++i) {
            const Vector3 wish(i % 2 == 0 ? distance : -distance, 0, 0), from = limb.destination();
            limb.reach(wish, 0.006);
            squares += (limb.destination() - from - wish).squaredNorm() / 400;
            for (int k = 0; k < 3000 && limb.remaining() >= 0; ++k) limb.tick();
        }
        return std::sqrt(squares);
    };
    EXPECT_NEAR(spread(0.06), 0.006, 0.0006);
    EXPECT_NEAR(spread(0.02), 0.002, 0.0002);
}

TEST(Skill, IndividualsVaryAroundTheirPresetAndAreRepeatable) {
    Skill a, b;
    std::vector<double> expert, novice;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        draw_individual(OperatorLevel::expert, seed, a);
        draw_individual(OperatorLevel::expert, seed, b);
        EXPECT_EQ(a.endpoint_noise, b.endpoint_noise);
        draw_individual(OperatorLevel::novice, seed, b);
        expert.push_back(a.endpoint_noise);
        novice.push_back(b.endpoint_noise);
    }
    EXPECT_LT(*std::max_element(expert.begin(), expert.end()),
              *std::min_element(novice.begin(), novice.end()));
    EXPECT_GT(*std::max_element(expert.begin(), expert.end()),
              1.2 * *std::min_element(expert.begin(), expert.end()));
}

TEST(Skill, TempoVariesAsAmongPeopleWithinTwoStandardDeviations) {
    constexpr OperatorLevel presets[] = {OperatorLevel::expert, OperatorLevel::intermediate,
                                         OperatorLevel::novice};
    double spread[3], slowest[3], fastest[3];
    for (int p = 0; p < 3; ++p) {
        std::vector<double> logarithms;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            Skill skill;
            draw_individual(presets[p], seed, skill);
            logarithms.push_back(std::log(skill.choice_s));
        }
        const double mean = std::accumulate(logarithms.begin(), logarithms.end(), 0.0) / 400;
        double square = 0;
        for (const double x : logarithms) square += (x - mean) * (x - mean) / 399;
        spread[p] = std::sqrt(square);
        slowest[p] = std::exp(*std::max_element(logarithms.begin(), logarithms.end()) - mean);
        fastest[p] = std::exp(*std::min_element(logarithms.begin(), logarithms.end()) - mean);
        EXPECT_LT(slowest[p], 2.3);
        EXPECT_GT(fastest[p], 0.43);
    }
    EXPECT_NEAR(spread[0], 0.19, 0.02) << "0.20, nobody beyond two standard deviations";
    EXPECT_LT(spread[0], spread[1]);
    EXPECT_LT(spread[1], spread[2]);
}

}  // namespace
}  // namespace fulcrum
