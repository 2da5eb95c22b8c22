// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/bowel/bowel_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/world/parts/bowel/bowel_part.h"

namespace fulcrum {

using namespace blade_law;

namespace {

constexpr std::int32_t surface_steps = 600;  // room for so many steps of a blade
constexpr double ground_reach = 0.006;       // m about a contact within which its ground is looked at
constexpr double through_by = 2.0;  // of the tool's radius: without tissue under it, it is through the wall
constexpr double steep = 0.15;      // of the shaft to the wall, cosine: flatter, the lips do not hold it
constexpr double furthest_lip = 0.02;  // m along the wall that the lips draw a shaft back over
constexpr double lip_grip = 1e6;       // N: lips let nothing slide
constexpr int most_near = 4096;        // triangles about one contact

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

double series(double a, double b) {
    return a > 0 && b > 0 ? a * b / (a + b) : 0.0;
}

}  // namespace

BowelCut::BowelCut(const Scene& scene, const BowelSkin& skin, const std::vector<std::int32_t>& held)
    : whole_(skin),
      tissue_(scene.tissues[at(scene.tissue_index(scene.bowel->tissue))]),
      tissue_index_(static_cast<std::int16_t>(scene.tissue_index(scene.bowel->tissue))),
      blade_width_(scene.bowel->blade_width),
      thickness_(scene.bowel->wall_thickness),
      gravity_(scene.gravity),
      skin_(skin, held, surface_steps),
      frames_(at(skin.rings())),
      root_mark_(skin.rest().triangles.size(), 0) {
    near_.reserve(most_near);
    roots_.reserve(skin.rest().triangles.size());
}

SkinRow BowelCut::row(const SkinPlace& place) const noexcept {
    const Triangle& corner = whole_.rest().triangles[at(place.root)];
    return interpolate_rows(whole_.rows()[at(corner[0])], whole_.rows()[at(corner[1])],
                            whole_.rows()[at(corner[2])], place.barycentric, whole_.cage().arc_lengths);
}

Vector3 BowelCut::where(const SkinPlace& place, const RingFrame* frames) const noexcept {
    Vector3 sum = Vector3::Zero();
    const Triangle& corner = whole_.rest().triangles[at(place.root)];
    for (std::size_t k = 0; k < 3; ++k)
        sum += place.barycentric[static_cast<int>(k)] * skin_vertex(whole_.rows()[at(corner[k])], frames);
    return sum;
}

// The rest normals, turned with the rings: smooth over facets and lips.
Vector3 BowelCut::normal_at(const SkinPlace& place, const RingFrame* frames) const noexcept {
    const Triangle& corner = whole_.rest().triangles[at(place.root)];
    Vector3 rest = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        rest += place.barycentric[static_cast<int>(k)] * whole_.rest_normals()[at(corner[k])];
    const SkinRow around = row(place);
    // The rest pose's directors: d1 = +y, d2 = +z, d3 = +x.
    const Vector3 in_ring(rest.y(), rest.z(), rest.x());
    Vector3 now = Vector3::Zero();
    for (int j = 0; j < skin_rings; ++j)
        now += around.weight[j] * (frames[around.first_ring + j].rotation * in_ring);
    const double size = now.norm();
    return size > 1e-9 ? Vector3(now / size) : Vector3(Vector3::UnitZ());
}

Vector3 BowelCut::rest(const SkinPlace& place) const noexcept {
    Vector3 sum = Vector3::Zero();
    const Triangle& corner = whole_.rest().triangles[at(place.root)];
    for (std::size_t k = 0; k < 3; ++k)
        sum += place.barycentric[static_cast<int>(k)] * whole_.rest().vertices[at(corner[k])];
    return sum;
}

// Roots from `start` on along the surface while they come within reach of the point, and what is left of
// them.
void BowelCut::gather(const Vector3& point, std::int32_t start, double reach,
                      const RingFrame* frames) noexcept {
    near_.clear();
    roots_.clear();
    near_cut_ = false;
    if (start < 0 || start >= skin_.surface().root_count()) return;
    if (++mark_ == 0) {
        std::fill(root_mark_.begin(), root_mark_.end(), 0U);
        mark_ = 1;
    }
    const CutMesh& surface = skin_.surface();
    const double reach2 = reach * reach;
    root_mark_[at(start)] = mark_;
    roots_.push_back(start);
    std::size_t kept = 0;
    for (std::size_t head = 0; head < roots_.size(); ++head) {
        const std::int32_t root = roots_[head];
        const Triangle& corner = whole_.rest().triangles[at(root)];
        const Vector3 a = skin_vertex(whole_.rows()[at(corner[0])], frames);
        const Vector3 b = skin_vertex(whole_.rows()[at(corner[1])], frames);
        const Vector3 c = skin_vertex(whole_.rows()[at(corner[2])], frames);
        if (head > 0 && !(box_distance(point, a, b, c) < reach2)) continue;
        if (skin_.touched(root)) {
            near_cut_ = true;
            for (std::int32_t t = surface.root(root).first_visible; t >= 0;
                 t = surface.triangle(t).next_in_root) {
                const Triangle& v = surface.triangle(t).vertices;
                if (skin_.loose_of(v[0]) != 0 || near_.size() == most_near) continue;
                near_.push_back({t, skin_.position(v[0], frames), skin_.position(v[1], frames),
                                 skin_.position(v[2], frames)});
            }
        } else if (skin_.loose_of(corner[0]) != 0) {
            near_cut_ = true;
        } else if (near_.size() < most_near) {
            near_.push_back({root, a, b, c});
        }
        for (std::size_t e = 0; e < 3; ++e) {
            const std::int32_t next = surface.model().adjacency.triangle_neighbours[3 * at(root) + e];
            if (next < 0 || root_mark_[at(next)] == mark_) continue;
            root_mark_[at(next)] = mark_;
            roots_.push_back(next);
        }
        roots_[kept++] = root;
    }
    roots_.resize(kept);
}

bool BowelCut::covered(const Vector3& point, const Vector3& normal) const noexcept {
    for (const NearTriangle& t : near_)
        if (covers(point, normal, t.a, t.b, t.c)) return true;
    return false;
}

SkinPlace BowelCut::closest_left(const Vector3& point, double& distance) const noexcept {
    SkinPlace found;
    double least = std::numeric_limits<double>::infinity();
    const NearTriangle* best = nullptr;
    Vector3 weights = Vector3::Zero();
    for (const NearTriangle& t : near_) {
        if (box_distance(point, t.a, t.b, t.c) >= least) continue;
        const TrianglePoint foot = closest_point_on_triangle(point, t.a, t.b, t.c);
        const double away = (foot.position - point).squaredNorm();
        if (!(away < least)) continue;
        least = away;
        best = &t;
        weights = foot.barycentric;
    }
    distance = std::sqrt(least);
    if (best == nullptr) return found;
    const CutTriangle& row = skin_.surface().triangle(best->triangle);
    for (std::size_t k = 0; k < 3; ++k) {
        Vector3 corner;
        if (!barycentric_in(skin_.surface().model(), skin_.surface().vertex(row.vertices[k]), row.root,
                            corner))
            return found;
        found.barycentric += weights[static_cast<int>(k)] * corner;
    }
    found.root = row.root;
    return found;
}

// The skin as if it were whole, among the roots gathered last.
SkinPlace BowelCut::on_skin(const Vector3& point, const RingFrame* frames) const noexcept {
    SkinPlace found;
    double least = std::numeric_limits<double>::infinity();
    for (const std::int32_t root : roots_) {
        const Triangle& corner = whole_.rest().triangles[at(root)];
        const Vector3 a = skin_vertex(whole_.rows()[at(corner[0])], frames);
        const Vector3 b = skin_vertex(whole_.rows()[at(corner[1])], frames);
        const Vector3 c = skin_vertex(whole_.rows()[at(corner[2])], frames);
        if (box_distance(point, a, b, c) >= least) continue;
        const TrianglePoint foot = closest_point_on_triangle(point, a, b, c);
        const double away = (foot.position - point).squaredNorm();
        if (!(away < least)) continue;
        least = away;
        found.root = root;
        found.barycentric = foot.barycentric;
    }
    return found;
}

std::int32_t BowelCut::nearest_left(const Vector3& point, std::int32_t start, double reach,
                                    const RingFrame* frames) noexcept {
    gather(point, start, reach, frames);
    double distance = 0;
    const SkinPlace place = closest_left(point, distance);
    if (place.root < 0 || !(distance < reach)) return -1;
    int heaviest = 0;
    place.barycentric.maxCoeff(&heaviest);
    return whole_.rest().triangles[at(place.root)][static_cast<std::size_t>(heaviest)];
}

double BowelCut::vertex_share(std::int32_t vertex) const noexcept {
    const CutMesh& surface = skin_.surface();
    double left = 0;
    for (const std::int32_t root : whole_.adjacency().triangles_of(vertex)) {
        double share = 0;
        for (std::int32_t t = surface.root(root).first_visible; t >= 0; t = surface.triangle(t).next_in_root)
            if (skin_.loose_of_triangle(t) == 0) share += surface.triangle(t).share;
        left += share * surface.model().areas[at(root)] / 3;
    }
    return std::min(1.0, left / whole_.vertex_areas()[at(vertex)]);
}

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
    const bool reaches = action.instrument != nullptr && tool.inside && tool.present &&
                         tool.tip.allFinite() && !action.busy &&
                         (action.near != nullptr || hand.touch == BladeTouch::cutting);
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
        if (action.instrument == nullptr) continue;
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

void BowelCut::fill_local_model(int number, LocalModel& model) const noexcept {
    const HandState& hand = hands_[static_cast<std::size_t>(number)];
    model.topology_version = static_cast<std::uint32_t>(skin_.version());
    model.patch.cover =
        hand.touch == BladeTouch::clearing || hand.touch == BladeTouch::cutting ? 0.0 : hand.cover;
    if (!hand.linked) return;
    SheetContactModel& blade = model.sheet;
    blade = SheetContactModel();
    blade.tissue = tissue_index_;
    blade.tip = hand.tip;
    blade.normal = hand.normal;
    blade.velocity = hand.velocity;
    blade.drag = hand.drag;
    blade.drag_stiffness = hand.slope;
    blade.grip = hand.grip;
    blade.cutting = hand.touch == BladeTouch::cutting;
}

void BowelCut::add_event(std::uint32_t tick, EventKind kind, int hand, double value, double detail) noexcept {
    events_.add(tick, kind, hand, tissue_index_, value, detail);
}

// Along the bowel, and around it from d1 towards d2.
void BowelCut::add_place_event(std::uint32_t tick, EventKind kind, int hand,
                               const SkinPlace& place) noexcept {
    const Vector3 rest_place = rest(place);
    const double size = std::sqrt(rest_place.y() * rest_place.y() + rest_place.z() * rest_place.z());
    add_event(tick, kind, hand, rest_place.x(), 1e6 * size * math::atan2(rest_place.z(), rest_place.y()));
}

void BowelCut::size_snapshot(WorldSnapshot& snapshot) const {
    BowelCutView& view = snapshot.bowel_cut;
    const CutCapacity& room = skin_.surface().capacity();
    view.first_vertex = whole_.vertices();
    const std::size_t vertices = at(room.vertices - view.first_vertex);
    // What a loose part hides and shows of whole triangles comes on top of what cuts made.
    view.vertex_roots.resize(vertices, 0);
    view.barycentric.resize(vertices, Vector3::Zero());
    view.triangles.resize(at(room.triangles), Triangle{0, 0, 0});
    view.triangle_roots.resize(at(room.triangles), 0);
    view.triangle_loose.resize(at(room.triangles), 0);
    view.hidden.resize(at(skin_.surface().root_count()), 0);
    view.thickness = thickness_;
    view.topology = 0xFFFFFFFFU;  // filled with the first picture
    events_.size(snapshot);
}

void BowelCut::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    BowelCutView& view = snapshot.bowel_cut;
    for (std::size_t k = 0; k < view.fallen.size(); ++k) view.fallen[k] = skin_.loose()[k].displacement;
    const auto version = static_cast<std::uint32_t>(skin_.version());
    if (view.topology != version) {
        const CutMesh& surface = skin_.surface();
        view.topology = version;
        view.vertex_count = surface.vertex_count() - view.first_vertex;
        for (std::int32_t v = 0; v < view.vertex_count; ++v) {
            const CutVertex& vertex = surface.vertex(view.first_vertex + v);
            view.vertex_roots[at(v)] = std::max(0, vertex.root);
            view.barycentric[at(v)] = vertex.barycentric;
        }
        view.triangle_count = 0;
        const bool falls = std::any_of(skin_.loose().begin(), skin_.loose().end(),
                                       [](const CutSkin::Loose& one) { return one.falls; });
        for (std::int32_t r = 0; r < surface.root_count(); ++r) {
            // By the roots' own short rows: most were never touched.
            const CutRoot& root = surface.root(r);
            const bool whole = root.visible_count == 1 && root.first_visible == r;
            const bool own = whole && (!falls || skin_.loose_of_triangle(r) == 0);
            view.hidden[at(r)] = own ? 0 : 1;
            for (std::int32_t t = own ? -1 : root.first_visible; t >= 0;
                 t = surface.triangle(t).next_in_root) {
                const std::size_t k = at(view.triangle_count++);
                view.triangles[k] = surface.triangle(t).vertices;
                view.triangle_roots[k] = r;
                view.triangle_loose[k] = static_cast<std::uint8_t>(skin_.loose_of_triangle(t));
            }
        }
        view.visible_area = surface.area_visible();
        view.removed_area = surface.area_removed();
    }
    events_.append_to(snapshot);
}

void BowelCut::list_state(StateList& list) {
    list.hashed_through([this] { return skin_.save(); },
                        [this](const CutSkin::State& state) {
                            skin_.restore(state);
                            followed_ = skin_.version();
                        },
                        [this](StateHash& hash) { hash.add(skin_.digest()); }, [] { return 0; });
    list.hashed(hands_, [this](StateHash& hash) {
        for (const HandState& hand : hands_) {
            hash.add(static_cast<std::int64_t>(hand.touch));
            hash.add(static_cast<std::int64_t>(hand.place.root));
            hash.add(hand.place.barycentric);
            hash.add(hand.cover);
            hash.add(hand.target);
            hash.add(hand.drag);
        }
    });
}

std::size_t BowelCut::bytes() const {
    return skin_.bytes() + near_.capacity() * sizeof(NearTriangle) +
           roots_.capacity() * sizeof(std::int32_t) + root_mark_.capacity() * sizeof(std::uint32_t) +
           frames_.capacity() * sizeof(RingFrame);
}

}  // namespace fulcrum
