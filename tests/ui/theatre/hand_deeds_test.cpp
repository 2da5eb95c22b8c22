// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/hand_deeds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/instrument/mouse_mapping.h"
#include "tests/support/allocation_count.h"
#include "tests/support/support.h"

namespace fulcrum::ui {
namespace {

Scene scene_of(const char* name) {
    return load_scene(fulcrum::test::source_path(std::string("assets/scenes/") + name + ".json"));
}

/// Readings of devices that rest where the scene begins.
struct Readings {
    explicit Readings(const Scene& scene) {
        for (const InstrumentSpec& spec : scene.instruments)
            hand[static_cast<int>(spec.hand)] = start_reading(spec.trocar.shaft_length, spec.start_insertion,
                                                              spec.jaw_opening * open_jaw_share);
        camera = start_reading(scene.camera->trocar.shaft_length, scene.camera->start_insertion, 0);
    }
    RigSample sample() const {
        RigSample made;
        for (int h = 0; h < hand_count; ++h) made.hand[h] = quantise(hand[h], {});
        made.camera = quantise(camera, {});
        return made;
    }
    DeviceReading hand[hand_count], camera;
};

std::string names(const HandDeeds& deeds) {
    const char* const all[] = {"moved", "other",  "in",    "roll", "jaws",
                               "pedal", "change", "scope", "post", "head"};
    std::string words;
    for (std::size_t i = 0; i < hand_deed_count; ++i)
        if (deeds.test(i)) words += (words.empty() ? "" : " ") + std::string(all[i]);
    return words;
}

TEST(HandDeeds, AreNeededWhereTheSceneHasAUseForThem) {
    EXPECT_EQ(names(needed_deeds(scene_of("a1_camera"), true)), "in scope post head");
    EXPECT_EQ(names(needed_deeds(scene_of("a2_targets"), true)), "moved other in scope");
    EXPECT_EQ(names(needed_deeds(scene_of("a2_targets"), false)), "moved in scope");
    EXPECT_EQ(names(needed_deeds(scene_of("b1_bowel"), false)), "moved in roll jaws scope");
    EXPECT_EQ(names(needed_deeds(scene_of("b3_bands"), false)), "moved in roll jaws pedal change scope");
    EXPECT_EQ(names(needed_deeds(scene_of("c4_posterior"), true)),
              "moved other in roll jaws pedal change scope");
}

TEST(HandDeeds, FollowWhatTheHandsDoAndNotTheirTremor) {
    const Scene scene = scene_of("c4_posterior");
    HandWatch watch(scene);
    Readings now(scene);
    const auto deeds = [&](bool one_mouse = false) {
        watch.see(now.sample());
        return names(watch.done(one_mouse));
    };
    EXPECT_EQ(deeds(), "");
    for (int tick = 0; tick < 300; ++tick) {
        const double shake = std::sin(0.06 * tick);
        for (DeviceReading& hand : now.hand) {
            hand.handle += 2e-5 * shake * Vector3(1, 1, 1);
            hand.roll = 0.05 * shake;
        }
        EXPECT_EQ(deeds(true), "");
    }
    now.hand[1].handle.x() += 0.02;
    EXPECT_EQ(deeds(), "") << "each hand has its own handle, and one has not moved";
    EXPECT_EQ(deeds(true), "moved");
    now.hand[0].handle.y() += 0.02;
    EXPECT_EQ(deeds(true), "moved other");
    now.hand[0].handle *= 0.9;
    EXPECT_EQ(deeds(true), "moved other in");
    now.hand[1].roll = -0.5;
    EXPECT_EQ(deeds(true), "moved other in roll");
    now.hand[0].jaw = 0;
    EXPECT_EQ(deeds(true), "moved other in roll jaws");
    now.hand[0].buttons = button_energy | button_exchange;
    EXPECT_EQ(deeds(true), "moved other in roll jaws") << "a grasper has no pedal and is not exchanged";
    now.hand[1].buttons = button_energy;
    EXPECT_EQ(deeds(true), "moved other in roll jaws pedal");
    now.hand[1].buttons = button_exchange;
    EXPECT_EQ(deeds(true), "moved other in roll jaws pedal change");
    now.camera.handle.x() += 0.02;
    EXPECT_EQ(deeds(true), "moved other in roll jaws pedal change scope");
    now.hand[0].buttons = now.hand[1].buttons = 0;
    now.hand[0].jaw = 0.6;
    EXPECT_EQ(deeds(true), "moved other in roll jaws pedal change scope") << "what was done stays done";
    watch.restart();
    EXPECT_EQ(names(watch.done(true)), "") << "before the next reading too";
    EXPECT_EQ(deeds(true), "") << "from where the hands are now";
    now.hand[1].handle.x() -= 0.03;
    EXPECT_EQ(deeds(true), "moved");
}

TEST(HandDeeds, JawsThatWereNeverOpenAndReadingsThatAreNoneDoNotCount) {
    const Scene scene = scene_of("b1_bowel");
    HandWatch watch(scene);
    Readings now(scene);
    for (DeviceReading& hand : now.hand) hand.jaw = 0;
    watch.see(now.sample());
    EXPECT_EQ(names(watch.done(false)), "");
    RigSample away = now.sample();
    for (DeviceSample& hand : away.hand) {
        hand.handle[0] += 1'000'000;
        hand.present = 0;
    }
    watch.see(away);
    EXPECT_EQ(names(watch.done(false)), "");
    for (DeviceSample& hand : away.hand) {
        hand.present = 1;
        hand.faulty = 1;
    }
    watch.see(away);
    EXPECT_EQ(names(watch.done(false)), "");
    for (DeviceSample& hand : away.hand) hand.faulty = 0;
    EXPECT_EQ(fulcrum::test::allocations_in([&] { watch.see(away); }), 0U);
    EXPECT_EQ(names(watch.done(false)), "moved in");
}

TEST(HandDeeds, AHandThatMovesOrPressesIsInUseAndOneThatRestsIsNot) {
    const Scene scene = scene_of("b1_bowel");
    HandWatch watch(scene);
    Readings now(scene);
    const auto uses = [&] {
        watch.see(now.sample());
        return watch.uses();
    };
    EXPECT_EQ(uses(), 0U);
    for (int i = 0; i < 50; ++i) {
        now.hand[0].handle.x() += (i % 2 == 0 ? 1 : -1) * 0.003;  // a hand that trembles
        ASSERT_EQ(uses(), 0U) << i;
    }
    now.hand[0].handle.x() += 0.006;
    EXPECT_EQ(uses(), 1U);
    EXPECT_EQ(uses(), 1U);
    now.hand[1].buttons = button_primary;
    EXPECT_EQ(uses(), 2U);
    now.hand[1].buttons = 0;
    EXPECT_EQ(uses(), 3U);
    now.hand[1].present = false;
    now.hand[1].handle.x() += 0.1;
    EXPECT_EQ(uses(), 3U);
}

TEST(HandDeeds, OfTheScopeAloneAreItsOwn) {
    const Scene scene = scene_of("a1_camera");
    HandWatch watch(scene);
    Readings now(scene);
    const auto deeds = [&] {
        watch.see(now.sample());
        return names(watch.done(true));
    };
    EXPECT_EQ(deeds(), "");
    now.camera.roll = 0.5;
    EXPECT_EQ(deeds(), "post");
    now.camera.jaw = -0.5;
    EXPECT_EQ(deeds(), "post head");
    now.camera.handle.x() += 0.03;
    EXPECT_EQ(deeds(), "scope post head");
    now.camera.handle *= 0.9;
    EXPECT_EQ(deeds(), "in scope post head");
}

}  // namespace
}  // namespace fulcrum::ui
