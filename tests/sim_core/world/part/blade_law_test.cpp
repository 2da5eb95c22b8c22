// SPDX-License-Identifier: Apache-2.0
// The blade law on a flat tissue that answers with springs: when a blade goes in, how far it advances, when
// it comes out and when it touches again.
#include "sim_core/world/part/blade_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace fulcrum {
namespace {

constexpr double dt = 0.005, stiffness = 1000, tip_radius = 0.0025;

/// Tissue in the plane z = 0, all of it.
struct Flat {
    BladeHand& hand;
    ToolKinematics& tool;
    const CuttingSpec* cutting = nullptr;
    Vector3 reaction = Vector3::Zero();
    double share = 1;                 // of the tool's width with tissue
    double friction = 0.3, grip = 0;  // N
    bool gone = false;
    std::string log = {};
    Vector3 advanced = Vector3::Zero(), slid_to = Vector3::Zero();

    void forget() { log += "forget "; }
    bool lost() const { return gone; }
    void stay() { log += "stay "; }
    void leave() {
        log += "leave ";
        hand.touch = BladeTouch::clearing;
    }
    bool find() const { return true; }
    bool clear() const { return tool.tip.z() > tip_radius + blade_law::clear_by; }
    static bool between(bool) { return true; }
    double cover() const { return share; }
    BladePress press() const {
        if (hand.cover < blade_law::least_cover && tool.tip.z() < -tip_radius) return BladePress::through;
        return tool.tip.z() < tip_radius ? BladePress::pressed : BladePress::none;
    }
    void fall_through() { log += "through "; }
    void touch(bool fresh) { log += fresh ? "touch " : ""; }
    void release() { log += "release "; }

    BladeContact contact() const {
        BladeContact at;
        at.reaction = reaction;
        at.stiffness = stiffness;
        at.friction = friction;
        at.grip = grip;
        at.cutting = cutting;
        at.bites = blade_law::button(tool);
        return at;
    }
    void enter(const Vector3&, const Vector3&) {
        log += "enter ";
        hand.touch = BladeTouch::cutting;
    }
    void slide(const Vector3& to) { slid_to = to; }
    static Vector3 lead(const Vector3& by) { return by; }
    void advance(const Vector3&, const Vector3& by) { advanced += by; }

    void approach(bool reaches = true) { blade_law::approach(hand, reaches, dt, *this); }
    void follow() { blade_law::follow(hand, tool, tip_radius, *this); }
};

struct BladeLaw : ::testing::Test {
    BladeHand hand;
    ToolKinematics tool;
    CuttingSpec spec;
    Flat flat{hand, tool, &spec};
    BladeLaw() {
        tool.buttons = button_primary;
        hand.cover = 1;
        hand.linked = true;
        spec.penetrate = 0.5;
        spec.static_friction = 0.2;
        spec.dynamic_friction = flat.grip = 0.1;
    }
};

TEST_F(BladeLaw, TouchesOnceAndLetsGoWhenTheToolIsLifted) {
    flat.approach();
    flat.approach();
    EXPECT_EQ(hand.touch, BladeTouch::touching);
    tool.tip.z() = 0.003;
    flat.approach();
    EXPECT_EQ(hand.touch, BladeTouch::away);
    EXPECT_EQ(flat.log, "touch release ");
}

TEST_F(BladeLaw, CoverFollowsTheTissueInItsTime) {
    flat.share = 0.25;
    double expected = 1;
    for (int i = 0; i < 10; ++i) {
        flat.approach();
        expected += (0.25 - expected) * dt / (0.015 + dt);
        EXPECT_NEAR(hand.cover, expected, 1e-15);
    }
}

TEST_F(BladeLaw, EntersAboveBothForcesWithItsButtonHeld) {
    hand.touch = BladeTouch::touching;
    const auto enters = [&](double across, double along, bool pressed, double ease_of_cutting) {
        spec.penetrate = 0.5 * ease_of_cutting;
        spec.static_friction = 0.2 * ease_of_cutting;
        tool.buttons = pressed ? button_primary : button_none;
        hand.touch = BladeTouch::touching;
        flat.reaction = Vector3(along, 0, -across);
        flat.follow();
        return hand.touch == BladeTouch::cutting;
    };
    EXPECT_TRUE(enters(0.51, 0.21, true, 1));
    EXPECT_FALSE(enters(0.49, 0.21, true, 1)) << "it must press";
    EXPECT_FALSE(enters(0.51, 0.19, true, 1)) << "it must be drawn";
    EXPECT_FALSE(enters(0.51, 0.21, false, 1));
    flat.cutting = nullptr;
    EXPECT_FALSE(enters(5, 5, true, 1)) << "no blade cuts this tissue";
}

TEST_F(BladeLaw, SlidesWhereTheSpringAsksForMoreThanFriction) {
    hand.touch = BladeTouch::touching;
    tool.buttons = button_none;
    flat.reaction = Vector3(0, 0, -1);   // friction holds 0.3 N
    hand.target = Vector3(0.001, 0, 0);  // its spring asks for 1 N
    flat.follow();
    EXPECT_NEAR(flat.slid_to.x(), 0.7e-3, 1e-15);
}

TEST_F(BladeLaw, AdvancesUntilItsSpringIsAtTheDynamicFriction) {
    hand.touch = BladeTouch::cutting;
    hand.target = Vector3(0.002, 0, 0.001);  // 2 N along the surface; across it nothing is cut
    flat.follow();
    EXPECT_NEAR(stiffness * (0.002 - flat.advanced.x()), 0.1, 1e-12);
    EXPECT_EQ(flat.advanced.z(), 0);
    // Less than the friction, or less than the least advance: nothing yet.
    flat.advanced.setZero();
    for (const double x : {0.00009, 0.0004}) {
        hand.target = Vector3(x, 0, 0);
        flat.follow();
        EXPECT_EQ(flat.advanced, Vector3::Zero()) << x;
    }
    hand.target = Vector3(0.05, 0, 0);
    flat.follow();
    EXPECT_NEAR(flat.advanced.x(), blade_law::longest_advance, 1e-15);
}

TEST_F(BladeLaw, ComesOutWithTheButtonOrTheTipAndTouchesAgainOnlyWhenClear) {
    hand.touch = BladeTouch::cutting;
    tool.tip.z() = tip_radius + 0.0009;
    flat.follow();
    EXPECT_EQ(hand.touch, BladeTouch::cutting);
    tool.tip.z() = tip_radius + 0.0011;
    flat.follow();
    EXPECT_EQ(hand.touch, BladeTouch::clearing);
    hand.touch = BladeTouch::cutting;
    tool.tip.z() = 0;
    tool.buttons = button_none;
    flat.follow();
    EXPECT_EQ(hand.touch, BladeTouch::clearing);
    for (const double z : {-0.01, 0.0, 0.0029}) {
        tool.tip.z() = z;
        flat.approach();
        EXPECT_EQ(hand.touch, BladeTouch::clearing) << "no contact in its own cut, " << z;
    }
    tool.tip.z() = 0.0031;
    flat.approach();
    EXPECT_EQ(hand.touch, BladeTouch::away);
    tool.tip.z() = 0;
    flat.approach();
    EXPECT_EQ(hand.touch, BladeTouch::touching);
}

TEST_F(BladeLaw, EndsItsCutWhenTheToolIsGoneOrTheTissueIs) {
    hand.touch = BladeTouch::cutting;
    flat.approach();
    EXPECT_EQ(hand.touch, BladeTouch::cutting);
    flat.approach(false);
    EXPECT_EQ(hand.touch, BladeTouch::away);
    hand.touch = BladeTouch::cutting;
    flat.gone = true;
    flat.approach();
    EXPECT_EQ(hand.touch, BladeTouch::clearing);
    EXPECT_EQ(flat.log, "stay leave forget leave ");
}

TEST_F(BladeLaw, GoesThroughAGap) {
    flat.share = 0;
    tool.tip.z() = -0.003;
    for (int i = 0; i < 40 && hand.touch != BladeTouch::clearing; ++i) flat.approach();
    EXPECT_EQ(hand.touch, BladeTouch::clearing);
    EXPECT_LT(hand.cover, blade_law::least_cover);
}

}  // namespace
}  // namespace fulcrum
