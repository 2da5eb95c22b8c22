// SPDX-License-Identifier: Apache-2.0
// Tips and jaws on the sheet: what lies under them, from which side, how they hold it, what the hand is
// given.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/world/parts/sheet/sheet_part.h"

namespace fulcrum {

using namespace blade_law;

namespace {

constexpr double reach = 0.020;         // m from the sheet within which the hand's model knows of it
constexpr double slide_friction = 0.2;  // of a tool that does not bite
constexpr double shaft_seen = 0.05;     // m of the shaft that may be in a slit
constexpr double sheet_springs = 4;     // springs whose stiffness a place of the sheet answers with
constexpr double jaw_span = 0.3;        // of the jaw's length, between places that it holds

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

double series(double a, double b) {
    return a > 0 && b > 0 ? a * b / (a + b) : 0.0;
}

}  // namespace

SheetPlace SheetPart::place_in(std::int32_t triangle, const Vector3& weights) const noexcept {
    SheetPlace found;
    const CutTriangle& row = surface_.triangle(triangle);
    Vector3 corner;
    for (std::size_t c = 0; c < 3; ++c) {
        if (!barycentric_in(surface_.model(), surface_.vertex(row.vertices[c]), row.root, corner))
            return SheetPlace();
        found.barycentric += weights[static_cast<int>(c)] * corner;
    }
    found.fragment = row.fragment;
    found.triangle = triangle;
    return found;
}

SheetPlace SheetPart::closest(const Vector3& point) const noexcept {
    double least = std::numeric_limits<double>::infinity();
    const auto on = [&](const Triangle& v) {
        return closest_point_on_triangle(point, state_.positions[at(v[0])], state_.positions[at(v[1])],
                                         state_.positions[at(v[2])]);
    };
    // A bound beyond what rounding can do to the distance, so that the first of the closest is found all the
    // same.
    for (const std::size_t k : recent_) {
        if (k < visible_.size())
            least = std::min(least,
                             (1 + 1e-9) * (on(visible_[k].vertices).position - point).squaredNorm() + 1e-30);
    }
    std::size_t closest = visible_.size();
    Vector3 weights = Vector3::Zero();
    for (std::size_t k = 0; k < visible_.size(); ++k) {
        const Triangle& v = visible_[k].vertices;
        if (box_distance(point, state_.positions[at(v[0])], state_.positions[at(v[1])],
                         state_.positions[at(v[2])]) >= least)
            continue;
        const TrianglePoint found = on(v);
        const double distance = (found.position - point).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        closest = k;
        weights = found.barycentric;
    }
    if (closest == visible_.size()) return SheetPlace();
    if (recent_[0] != closest) recent_ = {closest, recent_[0]};
    return place_in(visible_[closest].number, weights);
}

SheetPlace SheetPart::find_in_root(std::int32_t root, const Vector3& barycentric,
                                   double slack) const noexcept {
    SheetPlace found;
    double best = -std::numeric_limits<double>::infinity();
    for (std::int32_t t = surface_.root(root).first_visible; t >= 0; t = surface_.triangle(t).next_in_root) {
        const CutTriangle& row = surface_.triangle(t);
        Vector3 corner[3];
        bool good = true;
        for (std::size_t c = 0; c < 3; ++c)
            good =
                good && barycentric_in(surface_.model(), surface_.vertex(row.vertices[c]), root, corner[c]);
        if (!good || !(row.share > 0)) continue;
        double least = 1;
        for (int c = 0; c < 3; ++c)
            least =
                std::min(least, share_of(barycentric, corner[(c + 1) % 3], corner[(c + 2) % 3]) / row.share);
        if (least <= best) continue;
        best = least;
        found.fragment = row.fragment;
        found.triangle = t;
    }
    found.barycentric = barycentric;
    return best >= -slack ? found : SheetPlace();
}

SheetPart::Near SheetPart::find_near(const Vector3& tip, double radius) noexcept {
    Near near;
    near.distance = std::numeric_limits<double>::infinity();
    near.place = closest(tip);
    if (near.place.fragment < 0) return near;
    near.point = place(near.place);
    near.distance = (tip - near.point).norm();
    if (near.distance > reach) return near;
    // The normal over the tool's width, so that neither facets nor a fresh lip turn it at once.
    const double blend = std::max(2.5 * radius, spec_.spacing);
    near_.clear();
    Vector3 normal = Vector3::Zero();
    for (const VisibleTriangle& t : visible_) {
        const Triangle& v = t.vertices;
        const Vector3 &a = state_.positions[at(v[0])], &b = state_.positions[at(v[1])],
                      &c = state_.positions[at(v[2])];
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
        for (const VisibleTriangle& t : near_) {
            const Triangle& v = t.vertices;
            if (covers(sample, near.normal, state_.positions[at(v[0])], state_.positions[at(v[1])],
                       state_.positions[at(v[2])]))
                return true;
        }
        return false;
    });
    return near;
}

template <typename Visit>
bool SheetPart::visit_crossings(const Vector3& from, const Vector3& to, Visit&& visit) const noexcept {
    const Vector3 way = to - from;
    for (const VisibleTriangle& t : visible_) {
        const Triangle& v = t.vertices;
        const Vector3 &a = state_.positions[at(v[0])], &b = state_.positions[at(v[1])],
                      &c = state_.positions[at(v[2])];
        const Vector3 n = (b - a).cross(c - a);
        const double before = (from - a).dot(n), after = (to - a).dot(n);
        if (before * after > 0 || before == after) continue;
        const double share = before / (before - after);
        if (covers(from + share * way, n, a, b, c) && visit(t.number, share)) return true;
    }
    return false;
}

bool SheetPart::crosses(const Vector3& from, const Vector3& to) const noexcept {
    return visit_crossings(from, to, [](std::int32_t, double) { return true; });
}

void SheetPart::find_under(const Vector3& point, const Vector3& normal, double depth,
                           UnderBlade& found) const noexcept {
    const Vector3 from = point - depth * normal, to = point + depth * normal;
    visit_crossings(from, to, [&](std::int32_t t, double share) {
        const Vector3 where = from + share * (to - from);
        const Triangle& v = surface_.triangle(t).vertices;
        const Vector3 &a = state_.positions[at(v[0])], &b = state_.positions[at(v[1])],
                      &c = state_.positions[at(v[2])];
        add_under(place_in(t, closest_point_on_triangle(where, a, b, c).barycentric), std::abs(share - 0.5),
                  found);
        return false;
    });
}

void SheetPart::add_under(const SheetPlace& where, double away, UnderBlade& found) const noexcept {
    if (where.fragment < 0) return;
    std::size_t i = std::min(found.count, UnderBlade::capacity);
    if (i == UnderBlade::capacity && away >= found.layers[i - 1].away) return;
    if (i == UnderBlade::capacity) --i;
    for (; i > 0 && found.layers[i - 1].away > away; --i) found.layers[i] = found.layers[i - 1];
    found.layers[i] = {on_septum(where, rest(where)), surface_.fragment(where.fragment).root, away};
    found.count = std::min(found.count + 1, UnderBlade::capacity);
}

double SheetPart::friction(const SheetAction& action) const noexcept {
    const bool bites =
        action.instrument->cuts() && (action.tool.buttons & button_primary) != 0 && tissue_.cutting;
    return bites ? tissue_.friction : std::min(slide_friction, tissue_.friction);
}

// What came free falls off the tool that was in it or on it, or is gone with the place.
bool SheetPart::has_lost(const HandState& hand) const noexcept {
    if (hand.touch != BladeTouch::touching && hand.touch != BladeTouch::cutting) return false;
    if (hand.place.fragment < 0) return true;
    return state_.loose[at(hand.place.fragment)] != 0 && (place(hand.place) - hand.target).norm() > off_by;
}

struct SheetPart::Approach {
    SheetPart& sheet;
    HandState& hand;
    int number;
    const ToolKinematics& tool;
    double radius;
    std::uint32_t tick;
    Near near = {};
    double now = 1;  // side that the tip is on

    void forget() {
        hand.known = hand.linked = hand.over = false;
        hand.cover = 0;
        hand.reaction.setZero();
    }
    bool lost() const { return sheet.has_lost(hand); }
    void stay() { hand.normal = sheet.find_near(sheet.place(hand.place), radius).normal; }
    void leave() { sheet.leave(number, tick); }
    bool find() {
        near = sheet.find_near(tool.tip, radius);
        if (const std::int32_t septum = sheet.septum_of(near.place); septum != hand.septum) {
            // Another one is nearer now: what side of the last one it was on says nothing of this one.
            hand.septum = septum;
            hand.touch = BladeTouch::away;
            forget();
        }
        if (near.distance > reach) {
            // Which side it is on now shows where it comes back from, unless it went through tissue
            // in between.
            if (!hand.known || near.place.fragment < 0 || !sheet.crosses(hand.tip, tool.tip)) {
                hand.touch = BladeTouch::away;
                forget();
                return false;
            }
            hand.touch = BladeTouch::touching;  // held on its side
        }
        hand.normal = near.normal;
        now = near.gap >= 0 ? 1 : -1;
        if (!hand.known) {
            hand.known = true;
            hand.side = now;
            hand.tip = tool.tip;
        }
        return true;
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
        const bool through = (near.cover > 0 && hand.over) || sheet.crosses(hand.tip, tool.tip);
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

void SheetPart::approach(int number, const SheetAction& action, std::uint32_t tick, double dt) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    const ToolKinematics& tool = action.tool;
    const bool reaches =
        tool.inside && tool.present && tool.tip.allFinite() && !hand.jaws.held() && !action.busy;
    blade_law::approach(hand, reaches, dt,
                        Approach{*this, hand, number, tool, action.instrument->tip_radius, tick});
}

// m2 of both sides of what is visible, by the middles of its triangles.
double SheetPart::area_in(const JawBox& box) const noexcept {
    double area = 0;
    for (const VisibleTriangle& t : visible_) {
        const Triangle& v = t.vertices;
        const Vector3 &a = state_.positions[at(v[0])], &b = state_.positions[at(v[1])],
                      &c = state_.positions[at(v[2])];
        if (box.contains((a + b + c) / 3)) area += (b - a).cross(c - a).norm();
    }
    return area;
}

void SheetPart::take(int number, const SheetAction& action) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    hand.jaws.clear_points();
    for (const double share : {-0.5, -0.5 + jaw_span, -0.5 - jaw_span}) {
        const Vector3 offset(0, 0, share * action.instrument->jaw_length);
        const Vector3 jaw = action.tool.tip + action.tool.rotation * offset;
        const SheetPlace nearest = closest(jaw);
        if (nearest.fragment < 0) return;
        const Vector3 tissue = place(nearest);
        if ((tissue - jaw).norm() > Jaws::reach) {
            if (hand.jaws.count() == 0) return;
            continue;
        }
        hand.held_at[static_cast<std::size_t>(hand.jaws.count())] = nearest;
        hand.jaws.add_point(offset, jaw, tissue);
    }
    const JawBox box(action.tool, action.tool.jaw_angle, action.instrument->jaw_length,
                     action.instrument->tip_box.y());
    hand.jaws.take(action.tool, {tissue_.stiffness, tissue_.friction}, box.contact_area(area_in(box)));
    hand.pull.setZero();
}

bool SheetPart::closing(int number, const SheetAction& action) const noexcept {
    return type_of(action.instrument->kind).grasps &&
           state_.hands[static_cast<std::size_t>(number)].jaws.closing(action.tool,
                                                                       action.instrument->jaw_opening);
}

double SheetPart::offer(int number, const HeldTool& held) const noexcept {
    SheetAction action;
    action.instrument = held.instrument;
    action.tool = held.tool;
    if (!closing(number, action)) return no_offer;
    const Vector3 offset(0, 0, -0.5 * held.instrument->jaw_length);
    const Vector3 jaw = held.tool.tip + held.tool.rotation * offset;
    const SheetPlace nearest = closest(jaw);
    if (nearest.fragment < 0) return no_offer;
    const double distance = (place(nearest) - jaw).norm();
    return distance <= Jaws::reach ? distance : no_offer;
}

void SheetPart::update_jaws(int number, const SheetAction& action, double dt) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    if (!type_of(action.instrument->kind).grasps) return;
    std::array<Vector3, Jaws::most_points> tissue;
    switch (hand.jaws.step(action.tool, action.instrument->jaw_opening, hand.jaws.count() == 0)) {
        case JawAction::none:
            break;
        case JawAction::close:  // what they take follows them from the next step on
            if (action.takes) take(number, action);
            break;
        case JawAction::hold:
            for (std::size_t g = 0; g < static_cast<std::size_t>(hand.jaws.count()); ++g)
                tissue[g] = place(hand.held_at[g]);
            hand.jaws.carry(action.tool, {tissue_.stiffness, tissue_.friction}, tissue.data(),
                            action.instrument->jaw_length, dt);
            break;
        case JawAction::let_go:
            hand.pull.setZero();
            break;
    }
}

void SheetPart::add_links(const SheetAction* actions) noexcept {
    inputs_.links.clear();
    for (int h = 0; h < hand_count; ++h) {
        HandState& hand = state_.hands[static_cast<std::size_t>(h)];
        tip_link_[static_cast<std::size_t>(h)] = jaw_link_[static_cast<std::size_t>(h)] = -1;
        if (actions[h].instrument == nullptr) continue;
        const InstrumentSpec& instrument = *actions[h].instrument;
        const ToolKinematics& tool = actions[h].tool;
        if (hand.jaws.held()) {
            jaw_link_[static_cast<std::size_t>(h)] = static_cast<int>(inputs_.links.size());
            for (int g = 0; g < hand.jaws.count(); ++g) {
                const SheetPlace& held = hand.held_at[static_cast<std::size_t>(g)];
                CutMembraneLink link;
                link.piece = held.fragment;
                link.barycentric = held.barycentric;
                link.stiffness = hand.jaws.stiffness();
                link.start = hand.jaws.point(g).last;
                link.target = hand.jaws.point(g).target;
                link.grip = hand.jaws.most();
                inputs_.links.push_back(link);
            }
            continue;
        }
        if (hand.touch != BladeTouch::touching && hand.touch != BladeTouch::cutting) continue;
        CutMembraneLink link;
        link.piece = hand.place.fragment;
        link.barycentric = hand.place.barycentric;
        if (hand.touch == BladeTouch::touching) {
            link.normal = hand.side * hand.normal;
            link.stiffness = tissue_.stiffness * hand.cover;
            link.target = tool.tip - instrument.tip_radius * link.normal;
            link.start = hand.linked ? hand.target : Vector3(hand.tip - instrument.tip_radius * link.normal);
            link.friction = friction(actions[h]);
        } else {
            link.normal = hand.normal;
            link.push = false;
            link.stiffness = tissue_.stiffness;
            link.grip = hand.cut_friction;
            const Vector3 here = place(hand.place);
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
        tip_link_[static_cast<std::size_t>(h)] = static_cast<int>(inputs_.links.size());
        inputs_.links.push_back(link);
    }
}

void SheetPart::read_links() noexcept {
    for (std::size_t h = 0; h < hand_count; ++h) {
        HandState& hand = state_.hands[h];
        if (tip_link_[h] >= 0) hand.reaction = inputs_.links[static_cast<std::size_t>(tip_link_[h])].reaction;
        if (jaw_link_[h] < 0) continue;
        hand.pull.setZero();
        for (int g = 0; g < hand.jaws.count(); ++g)
            hand.pull += inputs_.links[static_cast<std::size_t>(jaw_link_[h] + g)].reaction;
    }
}

void SheetPart::fill_touch(const HandState& hand, SheetContactModel& model) const noexcept {
    const double k = tissue_.stiffness * (hand.touch == BladeTouch::cutting ? 1.0 : hand.cover);
    const double slope = series(k, sheet_springs * spec_.structural_stiffness);
    model.tissue = tissue_index_;
    model.tip = hand.tip;
    if (hand.linked)
        model.velocity = CutMembrane::velocity(state_.membrane, hand.place.fragment, hand.place.barycentric);
    model.stiffness = model.drag_stiffness = slope;
    model.damping = tissue_.damping * std::min(1.0, hand.cover);
    const Vector3 way = hand.linked ? Vector3(hand.target - place(hand.place)) : Vector3(Vector3::Zero());
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
        model.friction = slide_friction;
        model.push = -slope * std::max(0.0, hand.gap - hand.radius);
    }
}

void SheetPart::fill_grasp(const HandState& hand, LocalModel& model) const noexcept {
    model.mode = LocalMode::grasp;
    model.grasp = GraspModel();
    hand.jaws.fill(model.grasp);
    model.grasp.reaction = hand.pull;
    model.grasp.stiffness = series(Jaws::pinch_share * tissue_.stiffness,
                                   sheet_springs * hand.jaws.count() * spec_.structural_stiffness) *
                            Matrix3::Identity();
    model.grasp.damping = tissue_.damping;
    model.grasp.friction = tissue_.friction;
    model.grasp.tissue = tissue_index_;
}

void SheetPart::publish_model(int number, const TickOutput& /*last*/, LocalModel& model) noexcept {
    const HandState& hand = state_.hands[static_cast<std::size_t>(number)];
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
