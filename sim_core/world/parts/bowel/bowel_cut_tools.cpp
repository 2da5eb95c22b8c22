// SPDX-License-Identifier: Apache-2.0
// Tools on and in the bowel's wall: what the blade law finds there and what it does to it.
#include <algorithm>
#include <cmath>

#include "sim_core/world/parts/bowel/bowel_cut.h"
#include "sim_core/world/parts/bowel/bowel_part.h"

namespace fulcrum {

using namespace blade_law;

namespace {

constexpr double ground_reach = 0.006;  // m about a contact within which its ground is looked at
constexpr double through_by = 2.0;  // of the tool's radius: without tissue under it, it is through the wall
constexpr double steep = 0.15;      // of the shaft to the wall, cosine: flatter, the lips do not hold it
constexpr double furthest_lip = 0.02;  // m along the wall that the lips draw a shaft back over
constexpr double lip_grip = 1e6;       // N: lips let nothing slide

double series(double a, double b) {
    return a > 0 && b > 0 ? a * b / (a + b) : 0.0;
}

}  // namespace

struct BowelCut::Approach {
    BowelCut& cut;
    HandState& hand;
    int number;
    const ToolAction& action;
    const RingFrame* frames;
    std::uint32_t tick;
    bool was_linked;

    const ToolKinematics& tool() const { return action.tool; }
    double radius() const { return action.instrument->tip_radius; }
    void forget() { hand.cover = 1; }
    bool lost() const { return false; }
    void stay() {
        hand.normal = cut.normal_at(hand.place, frames);
        const Vector3 here = cut.where(hand.place, frames);
        const double back =
            std::clamp((tool().tip - here).dot(tool().axis), 0.0, action.instrument->jaw_length);
        hand.target = tool().tip - back * tool().axis;
        hand.slope = cut.tissue_.stiffness;
        hand.linked = true;
    }
    void leave() { cut.leave(number, tick); }
    bool find() {
        const ToolContactResult& near = *action.near;
        if (near.triangle < 0) return false;
        cut.gather(near.point, near.triangle, std::max(ground_reach, 2 * radius()), frames);
        return true;
    }
    bool clear() const { return action.near->distance > clear_by; }
    bool between(bool is_clear) {
        if (is_clear)
            hand.cover = 0;
        else
            cut.between_lips(hand, tool(), frames);
        return true;
    }
    double cover() const {
        const ToolContactResult& near = *action.near;
        return cut.near_cut_ ? cover_under(near.point, near.normal, radius(),
                                           [&](const Vector3& p) { return cut.covered(p, near.normal); })
                             : 1.0;
    }
    BladePress press() const {
        if (hand.cover < least_cover && action.near->distance < -through_by * radius())
            return BladePress::through;
        return action.contact == nullptr ? BladePress::none : BladePress::pressed;
    }
    void fall_through() {
        hand.place = cut.on_skin(action.near->point, frames);
        hand.cover = 0;
    }
    void touch(bool fresh) {
        const ToolContactResult& near = *action.near;
        const double from_tip = (1 - near.shaft) * (tool().tip - tool().trocar).norm();
        if (!action.instrument->cuts() || !button(tool()) || !cut.tissue_.cutting ||
            !(from_tip < action.instrument->jaw_length))
            return;
        hand.normal = near.normal;
        hand.reaction = action.contact->surface_force;
        if (fresh || !was_linked) {
            hand.place = cut.on_skin(near.point, frames);
            hand.arm = from_tip;
        }
        hand.target = tool().tip - hand.arm * tool().axis;
        hand.grip = cut.tissue_.friction * std::max(0.0, -hand.reaction.dot(hand.normal));
        hand.slope = cut.tissue_.stiffness * hand.cover;
        hand.linked = hand.place.root >= 0;
    }
    void release() {}
};

void BowelCut::approach(int number, const ToolAction& action, const RingMotion* rings, std::uint32_t tick,
                        double dt) noexcept {
    HandState& hand = hands_[static_cast<std::size_t>(number)];
    const bool was_linked = hand.linked;
    hand.linked = hand.free = false;
    hand.reaction.setZero();
    for (std::size_t r = 0; r < frames_.size(); ++r) frames_[r] = rings[r].frame;
    const ToolKinematics& tool = action.tool;
    // An instrument whose device does not answer stays where it was.
    const bool reaches = action.instrument != nullptr && tool.inside && tool.tip.allFinite() &&
                         !action.busy && (action.near != nullptr || hand.touch == BladeTouch::cutting);
    if (reaches) hand.tip = tool.tip;
    blade_law::approach(hand, reaches, dt,
                        Approach{*this, hand, number, action, frames_.data(), tick, was_linked});
    if (hand.touch == BladeTouch::cutting) hand.grip = tissue_.cutting->dynamic_friction;
    if (!hand.linked) hand.drag.setZero();
    if (hand.linked) hand.velocity = skin_velocity(row(hand.place), rings);
}

// A shaft in the wall: free along the cut, held where it meets what is left.
void BowelCut::between_lips(HandState& hand, const ToolKinematics& tool, const RingFrame* frames) noexcept {
    if (hand.place.root < 0) return;
    const Vector3 here = where(hand.place, frames);
    hand.normal = normal_at(hand.place, frames);
    const double slant = tool.axis.dot(hand.normal);
    if (!(slant < -steep)) return;
    const double back = (tool.tip - here).dot(hand.normal) / slant;
    if (!(back > 0)) return;  // the tip is not through it any more
    hand.target = tool.tip - back * tool.axis;
    Vector3 way = hand.target - here;
    way -= way.dot(hand.normal) * hand.normal;
    if (!(way.norm() < furthest_lip)) return;
    gather(here, hand.place.root, std::max(ground_reach, way.norm() + 0.002), frames);
    constexpr int places = 8;
    int free = 0;
    while (free < places && !covered(here + (free + 1.0) / places * way, hand.normal)) ++free;
    if (free > 0) {
        const SkinPlace next = on_skin(here + static_cast<double>(free) / places * way, frames);
        if (next.root >= 0) hand.place = next;
    }
    hand.linked = true;
    hand.free = free == places;
    hand.slope = hand.free ? 0.0 : tissue_.stiffness;
    hand.grip = lip_grip;
}

Vector3 BowelCut::wanted(int number, const RingFrame* frames) const noexcept {
    const HandState& hand = hands_[static_cast<std::size_t>(number)];
    if (!hand.linked) return Vector3::Zero();
    const Vector3 way = along_surface(hand.target - where(hand.place, frames), hand.normal);
    Vector3 force = hand.slope * way;
    const double size = force.norm();
    if (size > hand.grip) force *= hand.grip / size;
    return force;
}

void BowelCut::bear(int number, const Vector3& drag, double stiffness) noexcept {
    HandState& hand = hands_[static_cast<std::size_t>(number)];
    hand.drag = drag;
    hand.slope = series(hand.slope, stiffness);
}

void BowelCut::leave(int number, std::uint32_t tick) noexcept {
    HandState& hand = hands_[static_cast<std::size_t>(number)];
    add_place_event(tick, EventKind::cut_end, number, hand.place);
    hand.touch = BladeTouch::clearing;
    hand.cover = 0;
}

struct BowelCut::Follow {
    BowelCut& cut;
    HandState& hand;
    int number;
    const RingFrame* frames;
    std::uint32_t tick;

    BladeContact contact() const {
        BladeContact at;
        at.here = cut.where(hand.place, frames);
        at.normal = at.outward = hand.normal;
        at.reaction = hand.reaction + hand.drag;
        at.stiffness = cut.tissue_.stiffness;
        at.friction = cut.tissue_.friction;
        at.grip = hand.grip;
        at.cutting = &*cut.tissue_.cutting;
        at.bites = true;  // only a blade is linked to the wall
        return at;
    }
    void enter(const Vector3& here, const Vector3& /*along*/) {
        cut.gather(here, hand.place.root, ground_reach, frames);
        double distance = 0;
        const SkinPlace next = cut.closest_left(here, distance);
        if (next.root < 0 || distance > off_by) return;
        hand.place = next;
        hand.touch = BladeTouch::cutting;
        hand.linked = false;  // the blade hangs on it otherwise
        hand.cover = 0;
        hand.drag.setZero();
        cut.skin_.begin_stroke();
        cut.add_place_event(tick, EventKind::cut_begin, number, hand.place);
    }
    void slide(const Vector3& to) {
        cut.gather(cut.where(hand.place, frames), hand.place.root, ground_reach, frames);
        const SkinPlace next = cut.on_skin(to, frames);
        if (next.root >= 0) hand.place = next;
    }
    void leave() { cut.leave(number, tick); }
    static Vector3 lead(const Vector3& by) { return by; }
    void advance(const Vector3& here, const Vector3& by) { cut.advance(number, here, by, frames, tick); }
};

bool BowelCut::follow(const ToolAction* actions, const RingFrame* frames, std::uint32_t tick,
                      double dt) noexcept {
    for (int number = 0; number < hand_count; ++number) {
        HandState& hand = hands_[static_cast<std::size_t>(number)];
        const ToolAction& action = actions[number];
        if (action.instrument == nullptr || !action.tool.present) continue;
        blade_law::follow(hand, action.tool, action.instrument->tip_radius,
                          Follow{*this, hand, number, frames, tick});
    }
    skin_.fall(gravity_, dt);
    const bool changed = skin_.version() != followed_;
    followed_ = skin_.version();
    return changed;
}

CutSkin::Report BowelCut::cut(const BladeStep& blade, const RingFrame* frames, std::uint32_t tick,
                              int hand) noexcept {
    const CutSkin::Report report = skin_.cut(blade, frames);
    if (report.cut.roll_backs > 0)
        add_event(tick, EventKind::cut_rolled_back, hand, 0, report.cut.roll_backs);
    if (report.parted > 0) add_event(tick, EventKind::piece_fallen, -1, report.parted_area, 0);
    return report;
}

void BowelCut::advance(int number, const Vector3& here, const Vector3& excess, const RingFrame* frames,
                       std::uint32_t tick) noexcept {
    HandState& hand = hands_[static_cast<std::size_t>(number)];
    const Vector3 way = excess.normalized();
    const BladeStep blade = make_step(here, excess, hand.normal, blade_width_, hand.place.root);
    const CutReport report = cut(blade, frames, tick, number).cut;
    if (report.outcome != CutOutcome::cut && report.outcome != CutOutcome::nothing) return;
    gather(blade.to, report.root >= 0 ? report.root : hand.place.root, ground_reach, frames);
    double distance = 0;
    const SkinPlace next = closest_left(blade.to + ahead * way, distance);
    const bool gone = next.root < 0 || distance > off_by + ahead;
    if (!gone) hand.place = next;
    if (report.outcome == CutOutcome::cut) add_place_event(tick, EventKind::cut_advance, number, hand.place);
    if (gone) leave(number, tick);
}

}  // namespace fulcrum
