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
constexpr int most_near = 4096;              // triangles about one contact

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
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

void BowelCut::fill_local_model(int number, LocalModel& model) const noexcept {
    const HandState& hand = hands_[static_cast<std::size_t>(number)];
    model.topology_version = static_cast<std::uint32_t>(skin_.version());
    model.patch.cover =
        hand.touch == BladeTouch::clearing || hand.touch == BladeTouch::cutting ? 0.0 : hand.cover;
    if (!hand.linked) return;
    SheetContactModel& blade = model.sheet;
    blade = SheetContactModel();
    blade.tissue = tissue_index_;
    blade.back = (hand.tip - hand.target).norm();
    blade.place = hand.target;
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
    BowelCutView& view = snapshot.bowel.cut;
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
    BowelCutView& view = snapshot.bowel.cut;
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
        view.vertex_roots.used = view.barycentric.used = at(view.vertex_count);
        view.triangles.used = view.triangle_roots.used = view.triangle_loose.used = at(view.triangle_count);
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
