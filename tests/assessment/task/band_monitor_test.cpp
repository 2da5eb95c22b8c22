// SPDX-License-Identifier: Apache-2.0
// Events of bands: activations with the conditions that held throughout, divisions, bleeding, clips, doses;
// the goals and critical errors of B3.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "assessment/task/band_monitor.h"
#include "assessment/task/monitor.h"
#include "sim_core/instrument/device.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/allocation_count.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

class Kept : public EventSink {
  public:
    Kept() { events.reserve(4096); }
    void on_event(const Event& event) noexcept override {
        if (events.size() < events.capacity()) events.push_back(event);
    }
    std::vector<Event> of(EventKind kind) const {
        std::vector<Event> found;
        for (const Event& event : events)
            if (event.kind == kind) found.push_back(event);
        return found;
    }
    std::vector<Event> events;
};

/// B3 with a world set by the test.
struct Stage {
    Stage()
        : task(load_task(test::source_path("assets/tasks/B3.json"))),
          scene(load_scene(test::source_path("assets/scenes/b3_bands.json"))),
          monitor(task, scene, 1) {
        world.field.resize(1);
        world.bands.bands.resize(10);
        view().outlets.resize(6);
        view().tools[1].kind = InstrumentKind::harmonic;
        view().tools[1].clips_left = 12;
    }
    FieldView& view() { return world.field[0]; }
    std::vector<BandView>& bands() { return world.bands.bands; }
    void step(int steps = 1) {
        for (int i = 0; i < steps; ++i) {
            TickSample ticks[5];
            for (TickSample& sample : ticks) {
                sample.tick = ++tick;
                sample.hand[1].flags = static_cast<std::uint16_t>(hand_inside | (in_view ? hand_in_view : 0) |
                                                                  (view().tools[1].active ? hand_energy : 0));
                sample.hand[1].tip[0] = static_cast<std::int32_t>(tick) * per_tick;
            }
            monitor.on_step(ticks, 5, world, sink);
        }
    }
    void divide(std::size_t band, double tension = 0.5) {
        bands()[band].parted = 1U << 4U;
        bands()[band].parted_tension = static_cast<float>(tension);
    }
    TaskDefinition task;
    Scene scene;
    TaskMonitor monitor;
    WorldSnapshot world;
    Kept sink;
    bool in_view = true;
    std::int32_t per_tick = 500;  // 0.1 um that the right tip moves: 50 mm/s
    std::uint32_t tick = 0;
};

TEST(BandMonitor, AnActivationReportsTheConditionsThatHeldThroughout) {
    Stage stage;
    stage.step(100);
    HandToolView& tool = stage.view().tools[1];
    tool.active = true;
    tool.target = EnergyTarget::band;
    tool.nerve_distance = 0.008F;
    stage.step(10);
    tool.nerve_distance = 0.0035F;
    stage.step(10);
    tool.active = false;
    stage.step(5);
    // Again: out of view for one step, then near the nerve.
    tool.active = true;
    stage.in_view = false;
    stage.step(1);
    stage.in_view = true;
    tool.nerve_distance = 0.001F;
    stage.step(10);
    tool.active = false;
    stage.step(2);
    const std::vector<Event> begun = stage.sink.of(EventKind::activation_begin),
                             ended = stage.sink.of(EventKind::activation_end);
    ASSERT_EQ(begun.size(), 2U);
    ASSERT_EQ(ended.size(), 2U);
    const int all = detail_of(Activation{true, true, true});
    EXPECT_EQ(begun[0].detail, all);
    EXPECT_EQ(begun[0].hand, 1);
    EXPECT_EQ(begun[0].tissue, stage.scene.tissue_index("band"));
    EXPECT_EQ(ended[0].detail, all);
    EXPECT_NEAR(static_cast<double>(ended[0].value), 0.0035, 1e-7);
    EXPECT_EQ(ended[0].tick - begun[0].tick, 100U);
    EXPECT_EQ(ended[1].detail, detail_of(Activation{false, true, false}));
    EXPECT_NEAR(static_cast<double>(ended[1].value), 0.001, 1e-7);
}

TEST(BandMonitor, AnActivationEndsWhereWhatTheJawsHoldHasPartedOnBothSides) {
    Stage stage;
    stage.step(100);
    HandToolView& tool = stage.view().tools[1];
    tool.active = true;
    tool.band = 2;
    tool.target = EnergyTarget::band;
    stage.step(200);
    tool.target = EnergyTarget::nothing;  // the pedal stays down
    stage.step(2000);
    stage.in_view = false;
    stage.step(2000);
    stage.in_view = true;
    const auto begun = [&](std::size_t i) { return stage.sink.of(EventKind::activation_begin).at(i); };
    const auto ended = [&](std::size_t i) { return stage.sink.of(EventKind::activation_end).at(i); };
    ASSERT_EQ(stage.sink.of(EventKind::activation_begin).size(), 1U);
    ASSERT_EQ(stage.sink.of(EventKind::activation_end).size(), 1U);
    EXPECT_EQ(ended(0).tick - begun(0).tick, 1000U) << "nothing after it counts";
    EXPECT_TRUE(activation_of(ended(0)).safe());
    // It reaches tissue: another one.
    tool.target = EnergyTarget::band;
    stage.step(20);
    tool.active = false;
    stage.step(2);
    ASSERT_EQ(stage.sink.of(EventKind::activation_end).size(), 2U);
    EXPECT_TRUE(activation_of(ended(1)).safe());
    // A pedal that is pressed on nothing is not on target, in the jaws as in the open air.
    tool.active = true;
    tool.target = EnergyTarget::nothing;
    stage.step(20);
    tool.active = false;
    stage.step(2);
    ASSERT_EQ(stage.sink.of(EventKind::activation_end).size(), 3U);
    EXPECT_FALSE(activation_of(ended(2)).on_target);
    EXPECT_EQ(ended(2).tick - begun(2).tick, 100U);
    // Jaws that open under power give it to the open air.
    tool.active = true;
    tool.target = EnergyTarget::band;
    stage.step(20);
    tool.target = EnergyTarget::nothing;
    stage.step(20);
    tool.band = -1;
    stage.step(20);
    tool.active = false;
    stage.step(2);
    ASSERT_EQ(stage.sink.of(EventKind::activation_end).size(), 5U);
    EXPECT_TRUE(activation_of(ended(3)).safe());
    EXPECT_FALSE(activation_of(ended(4)).on_target);
}

// Else all clips could be set before the clock runs, slowly and with a second try.
TEST(BandMonitor, AClipStartsTheClock) {
    Stage stage;
    stage.per_tick = 0;
    stage.step(100);
    EXPECT_FALSE(stage.monitor.display().moving_seen);
    stage.view().tools[1].clips_fired = 1;
    stage.step();
    EXPECT_TRUE(stage.monitor.display().moving_seen) << "leaving the attempt now fails it";
    std::vector<Event> begun = stage.sink.of(EventKind::first_movement);
    ASSERT_EQ(begun.size(), 1U);
    EXPECT_EQ(begun[0].hand, 1);
    EXPECT_EQ(begun[0].tick, stage.tick);
    EXPECT_NEAR(stage.monitor.display().elapsed_s, 0.001, 1e-9);
    stage.step(200);
    EXPECT_NEAR(stage.monitor.display().elapsed_s, 1.001, 1e-9);
    EXPECT_NEAR(stage.monitor.display().remaining_s, stage.task.time_limit_s - 1.001, 1e-9);
    stage.view().tools[1].clips_fired = 2;
    stage.step();
    EXPECT_EQ(stage.sink.of(EventKind::first_movement).size(), 1U);
    EXPECT_EQ(stage.sink.of(EventKind::clip_applied).size(), 2U);
}

TEST(BandMonitor, SuctionIsNotAnActivation) {
    Stage stage;
    stage.view().tools[1].kind = InstrumentKind::suction;
    stage.view().tools[1].index = 2;
    stage.view().tools[1].active = true;
    stage.step(10);
    EXPECT_TRUE(stage.sink.of(EventKind::activation_begin).empty());
    ASSERT_EQ(stage.sink.of(EventKind::tool_exchanged).size(), 1U);
    EXPECT_EQ(stage.sink.of(EventKind::tool_exchanged)[0].detail, 2);
}

TEST(BandMonitor, TaskIsCompletedAfterDivisionBleedingAndHaemostasis) {
    Stage stage;
    stage.step(100);
    for (std::size_t b = 0; b < 9; ++b) stage.divide(b);
    OutletView& branch = stage.view().outlets[1];
    branch.opened = stage.view().outlets[0].opened = true;
    branch.flow = 20e-6 / 60;
    branch.lost = 0.1e-6;
    stage.view().lost = 0.1e-6;
    stage.step(2);
    EXPECT_EQ(stage.sink.of(EventKind::band_divided).size(), 9U);
    EXPECT_TRUE(stage.sink.of(EventKind::tear).empty());
    EXPECT_EQ(stage.monitor.display().bands_divided, 9);
    EXPECT_NEAR(stage.monitor.display().goal_progress, 0.9, 1e-12);
    ASSERT_EQ(stage.sink.of(EventKind::bleed_begin).size(), 1U);
    EXPECT_NEAR(static_cast<double>(stage.sink.of(EventKind::bleed_begin)[0].value), 20.0, 1e-5);
    for (int i = 0; i < 50; ++i) {
        branch.lost += 0.05e-6;
        stage.view().lost = branch.lost;
        stage.step();
    }
    EXPECT_NEAR(static_cast<double>(stage.sink.of(EventKind::blood_loss).size()), 2.5 / 0.25, 2);
    branch.flow = 0;
    branch.clipped = true;
    stage.view().tools[1].clips_fired = 1;
    stage.view().tools[1].clips_left = 11;
    stage.view().tools[1].last_clip_outlet = 1;
    stage.step();
    EXPECT_NEAR(static_cast<double>(stage.sink.of(EventKind::bleed_end)[0].value), 2.6, 1e-4);
    EXPECT_EQ(stage.sink.of(EventKind::clip_applied).size(), 1U);
    EXPECT_EQ(stage.monitor.display().clips_left, 11);
    EXPECT_EQ(stage.monitor.display().vessels_dry, 1);

    stage.divide(9);
    stage.step(2);
    EXPECT_EQ(stage.monitor.display().goal, 1);
    for (OutletView& outlet : stage.view().outlets) outlet.opened = true;
    stage.step(500);
    EXPECT_FALSE(stage.monitor.display().ended);
    stage.step(150);
    EXPECT_TRUE(stage.monitor.display().ended);
    EXPECT_EQ(stage.monitor.display().end, EventKind::completed);
    EXPECT_FALSE(stage.monitor.display().critical);
    // The sum is reported once more before the end, so that the record is complete.
    EXPECT_NEAR(static_cast<double>(stage.sink.of(EventKind::blood_loss).back().value), 2.6, 1e-4);
    EXPECT_EQ(stage.sink.events.back().kind, EventKind::completed);
}

TEST(BandMonitor, ATornBandIsNeverDividedAndBelongsToTheHandThatPulled) {
    Stage stage;
    stage.step(100);
    for (std::size_t b = 0; b < 7; ++b) stage.divide(b);
    // Both hands hold band 7, the left one pulls harder; it gives way after the left hand has let go.
    const double pull[] = {2.6, 0.4};
    for (int hand = 0; hand < hand_count; ++hand) {
        GraspState& grasp = stage.world.grasps[hand];
        grasp.held = true;
        grasp.body = HeldBody::band;
        grasp.patch = 7;
        grasp.reaction = Vector3(0, 0, pull[hand]);
    }
    stage.step(3);
    for (GraspState& grasp : stage.world.grasps) grasp = GraspState();
    stage.divide(7, 2.6);
    stage.bands()[7].torn = true;
    stage.divide(8, 3.0);  // nobody held this one
    stage.bands()[8].torn = true;
    stage.step(2);
    const std::vector<Event> torn = stage.sink.of(EventKind::tear);
    ASSERT_EQ(torn.size(), 2U);
    EXPECT_EQ(torn[0].detail, 7);
    EXPECT_EQ(torn[0].hand, 0);
    EXPECT_FLOAT_EQ(torn[0].value, 2.6F);
    EXPECT_EQ(torn[1].hand, 255);
    EXPECT_EQ(stage.sink.of(EventKind::band_divided).size(), 7U);
    EXPECT_EQ(stage.monitor.display().bands_divided, 7);
    EXPECT_EQ(stage.monitor.display().bands_torn, 2);

    // All bands are apart and no vessel bleeds: the goal stays unmet.
    stage.divide(9);
    for (OutletView& outlet : stage.view().outlets) outlet.opened = true;
    stage.step(2000);
    EXPECT_EQ(stage.monitor.display().bands_divided, 8);
    EXPECT_EQ(stage.monitor.display().goal, 0);
    EXPECT_FALSE(stage.monitor.display().ended);
}

TEST(BandMonitor, InjuriesAreCriticalAndReportedOnce) {
    Stage stage;
    stage.step(10);
    stage.view().outlets[2].injured = true;
    stage.step(5);
    EXPECT_TRUE(stage.monitor.display().critical);
    EXPECT_EQ(stage.sink.of(EventKind::vessel_injury).size(), 1U);
    EXPECT_EQ(stage.sink.of(EventKind::vessel_injury)[0].detail, 2);

    Stage other;
    other.step(10);
    other.view().nerves.resize(2);
    other.view().nerves[1].dose.assign(3, 59.0F);
    other.view().worst_nerve_dose = other.view().lateral_dose = 59;
    other.step(200);
    EXPECT_FALSE(other.monitor.display().critical);
    ASSERT_FALSE(other.sink.of(EventKind::heat_dose).empty());
    EXPECT_NEAR(static_cast<double>(other.sink.of(EventKind::heat_dose).back().value), 59, 1e-5);
    EXPECT_EQ(other.sink.of(EventKind::heat_dose).back().tissue, other.scene.tissue_index("nerve"));
    other.view().nerves[1].dose[2] = 61.0F;
    other.view().worst_nerve_dose = other.view().lateral_dose = 61;
    other.step(5);
    EXPECT_TRUE(other.monitor.display().critical);
    other.monitor.begin_again();
    EXPECT_FALSE(other.monitor.display().critical) << "practice from a moment has none of its own";
    ASSERT_EQ(other.sink.of(EventKind::nerve_injury).size(), 1U);
    EXPECT_EQ(other.sink.of(EventKind::nerve_injury)[0].detail, 1);
    EXPECT_EQ(other.sink.of(EventKind::nerve_injury)[0].value, 61.0F);
    // A blade through the other nerve is another injury.
    other.view().nerves[0].divided = true;
    other.step(5);
    ASSERT_EQ(other.sink.of(EventKind::nerve_injury).size(), 2U);
    EXPECT_EQ(nerve_injury_of(other.sink.of(EventKind::nerve_injury)[1]).cause, InjuryCause::blade);
}

TEST(BandMonitor, AWallWithVeinsReportsTheSameEvents) {
    const Scene scene = load_scene(test::source_path("assets/scenes/c4_posterior.json"));
    BandMonitor monitor(scene);
    WorldSnapshot world;
    world.field.resize(1);
    FieldView& view = world.field[0];
    view.outlets.resize(field_outlet_capacity);
    view.nerves.resize(2);
    for (NerveView& nerve : view.nerves) nerve.dose.assign(4, 0.0F);
    view.tools[1].kind = InstrumentKind::hook;
    view.tools[1].clips_left = scene.structures->clips;
    Kept sink;
    std::uint32_t tick = 0;
    const auto step = [&] { monitor.step(world, tick += 5, sink); };
    step();
    EXPECT_TRUE(sink.events.empty());

    // Power in the areolar plane is on target and clear of the nerves; then too near to one.
    view.tools[1].active = true;
    view.tools[1].target = EnergyTarget::sheet;
    view.tools[1].nerve_distance = 0.006F;
    step();
    view.tools[1].nerve_distance = 0.001F;
    step();
    view.tools[1].active = false;
    step();
    ASSERT_EQ(sink.of(EventKind::activation_end).size(), 1U);
    EXPECT_EQ(sink.of(EventKind::activation_begin)[0].detail, detail_of(Activation{true, true, true}));
    EXPECT_EQ(sink.of(EventKind::activation_begin)[0].tissue, scene.tissue_index("areolar"));
    EXPECT_EQ(sink.of(EventKind::activation_end)[0].detail, detail_of(Activation{true, true, false}));

    // In the mesorectum it is not, from the first moment or later on.
    for (const bool later : {false, true}) {
        sink.events.clear();
        view.tools[1].active = true;
        view.tools[1].nerve_distance = 0.006F;
        view.tools[1].target = later ? EnergyTarget::sheet : EnergyTarget::fat;
        step();
        view.tools[1].target = EnergyTarget::fat;
        step();
        view.tools[1].active = false;
        step();
        ASSERT_EQ(sink.of(EventKind::activation_end).size(), 1U);
        EXPECT_EQ(sink.of(EventKind::activation_end)[0].detail, detail_of(Activation{true, false, true}));
        EXPECT_EQ(sink.of(EventKind::activation_begin)[0].tissue,
                  scene.tissue_index(later ? "areolar" : "fat"));
    }

    // The sixteenth vein bleeds, is clipped and stops bleeding.
    OutletView& outlet = view.outlets[field_outlet_capacity - 1];
    outlet.opened = outlet.injured = true;
    outlet.flow = 2e-6;
    outlet.lost = view.lost = 0.5e-6;
    step();
    ASSERT_EQ(sink.of(EventKind::vessel_injury).size(), 1U);
    EXPECT_EQ(sink.of(EventKind::vessel_injury)[0].detail, 15);
    EXPECT_EQ(sink.of(EventKind::vessel_injury)[0].tissue, scene.tissue_index("vein"));
    ASSERT_EQ(sink.of(EventKind::bleed_begin).size(), 1U);
    EXPECT_NEAR(static_cast<double>(sink.of(EventKind::bleed_begin)[0].value), 120, 1e-3);
    ASSERT_EQ(sink.of(EventKind::blood_loss).size(), 1U);
    view.tools[1].kind = InstrumentKind::clip_applier;
    view.tools[1].index = 2;
    view.tools[1].clips_fired = 1;
    view.tools[1].last_clip_outlet = 15;
    outlet.clipped = true;
    outlet.flow = 0;
    step();
    EXPECT_EQ(sink.of(EventKind::tool_exchanged).size(), 1U);
    ASSERT_EQ(sink.of(EventKind::clip_applied).size(), 1U);
    EXPECT_EQ(sink.of(EventKind::clip_applied)[0].detail, 15);
    EXPECT_EQ(sink.of(EventKind::bleed_end).size(), 1U);
    EXPECT_EQ(monitor.dry(), 0);  // no vessel was to be divided
    EXPECT_EQ(monitor.divided(), 0);

    // Heat outside the plane is reported with the sheet's tissue, a divided nerve once.
    view.lateral_dose = 30;
    view.lateral_area = 2.5e-6;
    view.nerves[0].divided = true;
    tick += 1000;
    step();
    step();
    ASSERT_EQ(sink.of(EventKind::heat_dose).size(), 1U);
    EXPECT_EQ(sink.of(EventKind::heat_dose)[0].tissue, scene.tissue_index("fat"));
    ASSERT_EQ(sink.of(EventKind::heat_area).size(), 1U);
    EXPECT_NEAR(static_cast<double>(sink.of(EventKind::heat_area)[0].value), 2.5, 1e-5);
    ASSERT_EQ(sink.of(EventKind::nerve_injury).size(), 1U);
    EXPECT_EQ(nerve_injury_of(sink.of(EventKind::nerve_injury)[0]).cause, InjuryCause::blade);
}

TEST(BandMonitor, OpenActivationsEndWithTheAttempt) {
    Stage stage;
    stage.step(100);
    stage.view().tools[1].active = true;
    stage.view().tools[1].target = EnergyTarget::bed;
    stage.view().outlets[1].opened = true;
    stage.view().outlets[1].flow = 1e-6;
    stage.view().outlets[1].lost = stage.view().lost = 0.1e-6;
    stage.step(10);
    TickSample last;
    last.tick = ++stage.tick;
    last.rig_flags = rig_abandon;
    stage.monitor.on_step(&last, 1, stage.world, stage.sink);
    EXPECT_EQ(stage.sink.of(EventKind::activation_end).size(), 1U);
    EXPECT_FALSE(activation_of(stage.sink.of(EventKind::activation_end)[0]).on_target);
    EXPECT_EQ(stage.sink.of(EventKind::bleed_end).size(), 1U);
    ASSERT_EQ(stage.sink.of(EventKind::blood_loss).size(), 1U);
    EXPECT_EQ(stage.sink.events.back().kind, EventKind::abandoned);
}

TEST(BandMonitor, AllocatesNothing) {
    Stage stage;
    stage.step(20);
    EXPECT_EQ(test::allocations_in([&] {
                  stage.view().tools[1].active = true;
                  stage.step(5);
                  stage.divide(0);
                  stage.view().outlets[0].flow = 1e-6;
                  stage.step(5);
                  stage.view().tools[1].active = false;
                  stage.step(5);
              }),
              0u);
}

TEST(BandTask, RequiresOnlyWhatTheSceneHas) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/B3.json"));
    ASSERT_EQ(task.goals.size(), 2U);
    EXPECT_EQ(task.goals[0].kind, GoalKind::divide_bands);
    EXPECT_EQ(task.goals[1].kind, GoalKind::stop_bleeding);
    Scene scene = load_scene(test::source_path("assets/scenes/b3_bands.json"));
    scene.bands->count = 6;
    EXPECT_THROW(TaskMonitor(task, scene, 1), InputError);
    scene.bands->count = 10;
    scene.bands->vessels = 2;
    EXPECT_THROW(TaskMonitor(task, scene, 1), InputError);
    scene.bands.reset();
    EXPECT_THROW(TaskMonitor(task, scene, 1), InputError);
}

}  // namespace
}  // namespace fulcrum
