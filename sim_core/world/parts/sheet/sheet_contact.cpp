// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/sheet/sheet_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/geometry/closest_point.h"

namespace fulcrum {

using sheet_rows::at;

using namespace blade_law;

namespace {

constexpr double reach = 0.020;      // m from the sheet within which the hand's model knows of it
constexpr double shaft_seen = 0.05;  // m of the shaft that may be in a slit
constexpr double sheet_springs = 4;  // springs whose stiffness a place of the sheet answers with
constexpr double jaw_span = 0.3;     // of the jaw's length, between places that it holds

double series(double a, double b) {
    return a > 0 && b > 0 ? a * b / (a + b) : 0.0;
}

}  // namespace

SheetContact::SheetContact(SheetBody& sheet) : sheet_(sheet) {
    near_.reserve(at(sheet.surface().capacity().triangles));
}

SheetContact::Near SheetContact::find_near(const Vector3& tip, double radius) noexcept {
    Near near;
    near.distance = std::numeric_limits<double>::infinity();
    near.place = sheet_.closest(tip);
    if (near.place.fragment < 0) return near;
    near.point = sheet_.place(near.place);
    near.distance = (tip - near.point).norm();
    if (near.distance > reach) return near;
    // The normal over the tool's width, so that neither facets nor a fresh lip turn it at once.
    const double blend = std::max(2.5 * radius, sheet_.spec().spacing);
    near_.clear();
    Vector3 normal = Vector3::Zero();
    for (const SheetBody::VisibleTriangle& t : sheet_.visible()) {
        const Triangle& v = t.vertices;
        const Vector3 &a = sheet_.state().positions[at(v[0])], &b = sheet_.state().positions[at(v[1])],
                      &c = sheet_.state().positions[at(v[2])];
        if (box_distance(near.point, a, b, c) > blend * blend) continue;
        const double distance =
            (closest_point_on_triangle(near.point, a, b, c).position - near.point).squaredNorm();
        if (distance >= blend * blend) continue;
        near_.push_back(t);
        normal += (1 - distance / (blend * blend)) * (b - a).cross(c - a);
    }
    near.normal = normal.norm() > 1e-18 ? Vector3(normal.normalized()) : Vector3(Vector3::UnitZ());
    near.gap = (tip - near.point).dot(near.normal);
    near.cover = cover_under(tip - near.gap * near.normal, near.normal, radius, [&](const Vector3& sample) {
        for (const SheetBody::VisibleTriangle& t : near_) {
            const Triangle& v = t.vertices;
            if (covers(sample, near.normal, sheet_.state().positions[at(v[0])],
                       sheet_.state().positions[at(v[1])], sheet_.state().positions[at(v[2])]))
                return true;
        }
        return false;
    });
    return near;
}

// What came free falls off the tool that was in it or on it, or is gone with the place.
bool SheetContact::has_lost(const SheetHand& hand) const noexcept {
    if (hand.touch != BladeTouch::touching && hand.touch != BladeTouch::cutting) return false;
    if (hand.place.fragment < 0) return true;
    return sheet_.state().loose[at(hand.place.fragment)] != 0 &&
           (sheet_.place(hand.place) - hand.target).norm() > off_by;
}

struct SheetContact::Approach {
    SheetContact& contact;
    SheetBody& sheet;
    SheetHand& hand;
    int number;
    const ToolKinematics& tool;
    double radius;
    std::uint32_t tick;
    bool keeps_side;  // the instrument is out of the body, and what it was on has a side still
    bool comes_back;  // it was out of the body until now, or is another one
    Near near = {};
    double now = 1;          // side that the tip is on
    bool held_back = false;  // it comes back and has not come through to that side

    void forget() {
        hand.known = hand.known && keeps_side;
        hand.over = hand.over && keeps_side;
        hand.linked = false;
        hand.cover = 0;
        hand.reaction.setZero();
    }
    bool lost() const { return contact.has_lost(hand); }
    void stay() { hand.normal = contact.find_near(sheet.place(hand.place), radius).normal; }
    void leave() { sheet.leave(number, tick); }
    bool find() {
        near = contact.find_near(tool.tip, radius);
        if (const std::int32_t septum = sheet.septum_of(near.place); septum != hand.septum) {
            // Another one is nearer now: what side of the last one it was on says nothing of this one.
            hand.septum = septum;
            hand.touch = BladeTouch::away;
            forget();
        }
        if (near.distance > reach) {
            // Which side it is on now shows where it comes back from, unless it went through tissue
            // in between.
            if (!hand.known || comes_back || near.place.fragment < 0 || !sheet.crosses(hand.tip, tool.tip)) {
                hand.touch = BladeTouch::away;
                forget();
                return false;
            }
            hand.touch = BladeTouch::touching;  // held on its side
        }
        hand.normal = near.normal;
        now = near.gap >= 0 ? 1 : -1;
        if (comes_back) come_back();
        if (!hand.known) {
            hand.known = true;
            hand.side = now;
            hand.tip = tool.tip;
        }
        return true;
    }
    // An instrument comes in along its shaft, and where the last one was shows what is between. It is through
    // the tissue only where nothing of it crosses the shaft, as in a slit or round a rim, or nothing the path
    // from there; a lip may cross the shaft alone.
    void come_back() {
        const bool sprang = hand.known && hand.over && near.cover > 0 && hand.side != now;  // what it pressed
        held_back = (sprang || sheet.crosses(hand.tip, tool.tip, hand.septum)) &&
                    sheet.crosses(tool.tip - shaft_seen * tool.axis, tool.tip, hand.septum);
        hand.known = true;
        hand.side = held_back ? -now : now;
        hand.tip = tool.tip;
    }
    // The shaft is still in the slit: the tip comes out by it, or has found a way on which nothing crosses
    // the shaft.
    bool clear() const {
        const bool out = hand.side * near.gap > radius + clear_by;
        return out || (hand.side * near.gap < -radius - clear_by &&
                       !sheet.crosses(tool.tip - shaft_seen * tool.axis, tool.tip));
    }
    bool between(bool is_clear) {
        if (is_clear) hand.side = now;
        return false;
    }
    double cover() {
        // A tip that is on the other side went round a rim or through a slit; over tissue before and now, it
        // or the sheet was too fast for one step.
        const bool through = held_back || (near.cover > 0 && hand.over) || sheet.crosses(hand.tip, tool.tip);
        if (hand.touch == BladeTouch::away && hand.side != now && !through) hand.side = now;
        hand.over = near.cover > 0;
        return near.cover;
    }
    BladePress press() {
        hand.gap = hand.side * near.gap;
        return hand.gap < radius && hand.cover > least_cover ? BladePress::pressed : BladePress::none;
    }
    void fall_through() {}
    void touch(bool fresh) {
        if (!fresh) return;
        hand.place = near.place;
        hand.linked = false;
    }
    void release() {
        hand.linked = false;
        hand.reaction.setZero();
    }
};

void SheetContact::approach(int number, const SheetAction& action, std::uint32_t tick, double dt) noexcept {
    SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    const ToolKinematics& tool = action.tool;
    // An instrument whose device does not answer stays where it was.
    const bool reaches = tool.inside && (tool.present || hand.known) && tool.tip.allFinite() &&
                         !hand.jaws.held() && !action.busy;
    // While one is exchanged its side is remembered, but no cut that it was in.
    const bool keeps_side =
        !tool.inside && (hand.touch == BladeTouch::away || hand.touch == BladeTouch::touching);
    const bool comes_back = tool.inside && hand.been_in && !hand.in;
    blade_law::approach(hand, reaches, dt,
                        Approach{*this, sheet_, hand, number, tool, action.instrument->tip_radius, tick,
                                 keeps_side, comes_back});
}

// m2 of both sides of what is visible, by the middles of its triangles.
double SheetContact::area_in(const JawBox& box) const noexcept {
    double area = 0;
    for (const SheetBody::VisibleTriangle& t : sheet_.visible()) {
        const Triangle& v = t.vertices;
        const Vector3 &a = sheet_.state().positions[at(v[0])], &b = sheet_.state().positions[at(v[1])],
                      &c = sheet_.state().positions[at(v[2])];
        if (box.contains((a + b + c) / 3)) area += (b - a).cross(c - a).norm();
    }
    return area;
}

void SheetContact::take(int number, const SheetAction& action) noexcept {
    SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    hand.jaws.clear_points();
    for (const double share : {-0.5, -0.5 + jaw_span, -0.5 - jaw_span}) {
        const Vector3 offset(0, 0, share * action.instrument->jaw_length);
        const Vector3 jaw = action.tool.tip + action.tool.rotation * offset;
        const SheetPlace nearest = sheet_.closest(jaw);
        if (nearest.fragment < 0) return;
        const Vector3 tissue = sheet_.place(nearest);
        if ((tissue - jaw).norm() > Jaws::reach) {
            if (hand.jaws.count() == 0) return;
            continue;
        }
        hand.held_at[static_cast<std::size_t>(hand.jaws.count())] = nearest;
        hand.jaws.add_point(offset, jaw, tissue);
    }
    const JawBox box(action.tool, action.tool.jaw_angle, action.instrument->jaw_length,
                     action.instrument->tip_box.y());
    hand.jaws.take(action.tool, {sheet_.tissue().stiffness, sheet_.tissue().friction},
                   box.contact_area(area_in(box)));
    hand.pull.setZero();
}

bool SheetContact::closing(int number, const SheetAction& action) const noexcept {
    return type_of(action.instrument->kind).grasps &&
           sheet_.state().hands[static_cast<std::size_t>(number)].jaws.closing(
               action.tool, action.instrument->jaw_opening);
}

double SheetContact::offer(int number, const HeldTool& held) const noexcept {
    SheetAction action;
    action.instrument = held.instrument;
    action.tool = held.tool;
    if (!closing(number, action)) return Part::no_offer;
    const Vector3 offset(0, 0, -0.5 * held.instrument->jaw_length);
    const Vector3 jaw = held.tool.tip + held.tool.rotation * offset;
    const SheetPlace nearest = sheet_.closest(jaw);
    if (nearest.fragment < 0) return Part::no_offer;
    const double distance = (sheet_.place(nearest) - jaw).norm();
    return distance <= Jaws::reach ? distance : Part::no_offer;
}

void SheetContact::update_jaws(int number, const SheetAction& action, double dt) noexcept {
    SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    if (!type_of(action.instrument->kind).grasps) {
        hand.jaws.block();
        return;
    }
    std::array<Vector3, Jaws::most_points> tissue;
    switch (hand.jaws.step(action.tool, action.instrument->jaw_opening, hand.jaws.count() == 0)) {
        case JawAction::none:
            break;
        case JawAction::close:  // what they take follows them from the next step on
            if (action.takes) take(number, action);
            break;
        case JawAction::hold:
            for (std::size_t g = 0; g < static_cast<std::size_t>(hand.jaws.count()); ++g)
                tissue[g] = sheet_.place(hand.held_at[g]);
            hand.jaws.carry(action.tool, {sheet_.tissue().stiffness, sheet_.tissue().friction}, tissue.data(),
                            action.instrument->jaw_length, dt);
            break;
        case JawAction::let_go:
            hand.pull.setZero();
            break;
    }
}

void SheetContact::add_links(const SheetAction* actions) noexcept {
    sheet_.inputs().links.clear();
    for (int h = 0; h < hand_count; ++h) {
        SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(h)];
        tip_link_[static_cast<std::size_t>(h)] = jaw_link_[static_cast<std::size_t>(h)] = -1;
        if (actions[h].instrument == nullptr) continue;
        const InstrumentSpec& instrument = *actions[h].instrument;
        const ToolKinematics& tool = actions[h].tool;
        if (hand.jaws.held()) {
            jaw_link_[static_cast<std::size_t>(h)] = static_cast<int>(sheet_.inputs().links.size());
            for (int g = 0; g < hand.jaws.count(); ++g) {
                const SheetPlace& held = hand.held_at[static_cast<std::size_t>(g)];
                CutMembraneLink link;
                link.piece = held.fragment;
                link.barycentric = held.barycentric;
                link.stiffness = hand.jaws.stiffness();
                link.start = hand.jaws.point(g).last;
                link.target = hand.jaws.point(g).target;
                link.grip = hand.jaws.most();
                sheet_.inputs().links.push_back(link);
            }
            continue;
        }
        if (hand.touch != BladeTouch::touching && hand.touch != BladeTouch::cutting) continue;
        CutMembraneLink link;
        link.piece = hand.place.fragment;
        link.barycentric = hand.place.barycentric;
        if (hand.touch == BladeTouch::touching) {
            link.normal = hand.side * hand.normal;
            link.stiffness = sheet_.tissue().stiffness * hand.cover;
            link.target = tool.tip - instrument.tip_radius * link.normal;
            link.start = hand.linked ? hand.target : Vector3(hand.tip - instrument.tip_radius * link.normal);
            link.friction = sheet_.friction(actions[h]);
        } else {
            link.normal = hand.normal;
            link.push = false;
            link.stiffness = sheet_.tissue().stiffness;
            link.grip = hand.cut_friction;
            const Vector3 here = sheet_.place(hand.place);
            const double back = std::clamp((tool.tip - here).dot(tool.axis), 0.0, instrument.jaw_length);
            link.target = tool.tip - back * tool.axis;
            link.start = hand.linked ? hand.target : link.target;
            if (hand.adrift) {  // nothing holds it
                hand.target = link.target;
                hand.linked = false;
                hand.reaction.setZero();
                continue;
            }
        }
        hand.target = link.target;
        hand.linked = true;
        tip_link_[static_cast<std::size_t>(h)] = static_cast<int>(sheet_.inputs().links.size());
        sheet_.inputs().links.push_back(link);
    }
}

void SheetContact::read_links() noexcept {
    for (std::size_t h = 0; h < hand_count; ++h) {
        SheetHand& hand = sheet_.state().hands[h];
        if (tip_link_[h] >= 0)
            hand.reaction = sheet_.inputs().links[static_cast<std::size_t>(tip_link_[h])].reaction;
        if (jaw_link_[h] < 0) continue;
        hand.pull.setZero();
        for (int g = 0; g < hand.jaws.count(); ++g)
            hand.pull += sheet_.inputs().links[static_cast<std::size_t>(jaw_link_[h] + g)].reaction;
    }
}

void SheetContact::fill_touch(const SheetHand& hand, SheetContactModel& model) const noexcept {
    const double k = sheet_.tissue().stiffness * (hand.touch == BladeTouch::cutting ? 1.0 : hand.cover);
    const double slope = series(k, sheet_springs * sheet_.spec().structural_stiffness);
    model.tissue = sheet_.tissue_index();
    model.place = hand.tip;
    if (hand.linked)
        model.velocity =
            CutMembrane::velocity(sheet_.state().membrane, hand.place.fragment, hand.place.barycentric);
    model.stiffness = model.drag_stiffness = slope;
    model.damping = sheet_.tissue().damping * std::min(1.0, hand.cover);
    const Vector3 way =
        hand.linked ? Vector3(hand.target - sheet_.place(hand.place)) : Vector3(Vector3::Zero());
    if (hand.touch == BladeTouch::cutting) {
        model.normal = hand.normal;
        model.cutting = true;
        model.grip = hand.adrift ? 0.0 : hand.cut_friction;
        model.drag = k * (way - way.dot(model.normal) * model.normal);
        const double size = model.drag.norm();
        if (size > model.grip) model.drag *= model.grip / size;
        return;
    }
    model.normal = hand.side * hand.normal;
    model.pushes = true;
    if (hand.touch == BladeTouch::touching && hand.linked) {
        const double depth = -way.dot(model.normal);
        model.friction = hand.friction;
        model.push = depth > 0 ? k * depth : slope * depth;
        model.drag = k * (way + depth * model.normal);
        const double size = model.drag.norm(), most = model.friction * std::max(0.0, model.push);
        if (size > most) model.drag *= most / size;
    } else {
        model.friction = SheetBody::slide_friction;
        model.push = -slope * std::max(0.0, hand.gap - hand.radius);
    }
}

void SheetContact::fill_grasp(const SheetHand& hand, LocalModel& model) const noexcept {
    model.mode = LocalMode::grasp;
    model.grasp = GraspModel();
    hand.jaws.fill(model.grasp);
    model.grasp.reaction = hand.pull;
    model.grasp.stiffness = series(Jaws::pinch_share * sheet_.tissue().stiffness,
                                   sheet_springs * hand.jaws.count() * sheet_.spec().structural_stiffness) *
                            Matrix3::Identity();
    model.grasp.damping = sheet_.tissue().damping;
    model.grasp.friction = sheet_.tissue().friction;
    model.grasp.tissue = sheet_.tissue_index();
}

void SheetContact::publish(int number, LocalModel& model) const noexcept {
    const SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    if (hand.jaws.held()) {
        fill_grasp(hand, model);
        return;
    }
    const bool near = hand.touch == BladeTouch::away && hand.known && hand.cover > least_cover;
    const bool taken = model.sheet.tissue >= 0;  // by a blade in another part's tissue
    if (!taken && (hand.touch == BladeTouch::touching || hand.touch == BladeTouch::cutting || near))
        fill_touch(hand, model.sheet);
}

}  // namespace fulcrum
