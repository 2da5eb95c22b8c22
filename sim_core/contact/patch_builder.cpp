// SPDX-License-Identifier: Apache-2.0
#include "sim_core/contact/patch_builder.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr int search_intervals = 3;   // ring gaps on each side of the nearest ring whose vertices are tested
constexpr double ahead_step = 0.004;  // m between the sampled positions on a fast tool's path
constexpr double surely_inside = 0.25;  // fraction of a ring's radius
constexpr int most_ahead_places = 128;  // for tools faster than any hand the samples are further apart

std::size_t index(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

// Distance from a point to the shaft, and the fraction of the shaft there.
struct ShaftDistance {
    double distance2 = 0, fraction = 1;
};

ShaftDistance to_shaft(const ToolKinematics& tool, const Vector3& point) {
    const Vector3 shaft = tool.tip - tool.trocar, from_trocar = point - tool.trocar;
    const double length2 = shaft.squaredNorm();
    ShaftDistance result;
    result.fraction = length2 > 0 ? std::clamp(from_trocar.dot(shaft) / length2, 0.0, 1.0) : 1.0;
    result.distance2 = (from_trocar - result.fraction * shaft).squaredNorm();
    return result;
}

void clear(SurfacePatch& patch) {
    patch.ring_count = patch.vertex_count = patch.triangle_count = patch.first_ring = 0;
    patch.seed_triangle = -1;
    patch.overflow = false;
    patch.cover = 1;
}

}  // namespace

PatchBuilder::PatchBuilder(const BowelSkin& skin, PatchOptions options,
                           std::vector<std::int16_t> tissue_patches)
    : skin_(skin), options_(options), tissue_patches_(std::move(tissue_patches)) {
    if (tissue_patches_.empty()) tissue_patches_.assign(static_cast<std::size_t>(skin.vertices()), -1);
    for (const auto& ring : skin.cage().templates) {
        double largest = 0;
        for (const Vector3& vertex : ring) largest = std::max(largest, vertex.norm());
        ring_radius_.push_back(largest);
    }
}

void PatchBuilder::set_wall(const LayeredWall* wall, std::vector<double> nodule) {
    options_.contact.wall = wall;
    nodule_ = std::move(nodule);
}

PatchBuilder::Scratch PatchBuilder::make_scratch() const {
    Scratch scratch;
    const auto vertices = static_cast<std::size_t>(skin_.vertices());
    scratch.local.assign(vertices, -1);
    scratch.found.reserve(vertices);
    scratch.distance.reserve(vertices);
    scratch.positions.reserve(vertices);
    scratch.order.reserve(vertices);
    scratch.triangle_local.assign(skin_.rest().triangles.size(), -1);
    scratch.connected.resize(hand_count);
    return scratch;
}

// Distance of the shaft to the tube, m, < 0 inside, and the ring where it is smallest.
double PatchBuilder::nearest_ring(const RingMotion* rings, const ToolKinematics& tool, int& nearest) const {
    double nearest_distance = 1e30;
    for (int r = 0; r < skin_.rings(); ++r) {
        const double distance =
            std::sqrt(to_shaft(tool, rings[r].frame.position).distance2) - ring_radius_[index(r)];
        if (distance < nearest_distance) {
            nearest_distance = distance;
            nearest = r;
        }
    }
    return nearest_distance;
}

// A tool that crosses its reach within the horizon would be past the tube before the next model. This moves
// it to the first position on its path that is surely in the tube, or to the nearest one.
void PatchBuilder::look_ahead(const RingMotion* rings, const PatchRequest& request,
                              ToolKinematics& tool) const {
    const double travel = request.horizon * tool.tip_velocity.norm();
    if (!(travel > options_.reach)) return;
    const int places = static_cast<int>(std::min<double>(most_ahead_places, std::ceil(travel / ahead_step)));
    const Vector3 start = tool.tip;
    double least = 1e30;
    for (int k = 0; k <= places; ++k) {
        ToolKinematics there = tool;
        there.tip = start + request.horizon * k / places * tool.tip_velocity;
        int nearest = 0;
        const double distance = nearest_ring(rings, there, nearest);
        if (distance >= least) continue;
        least = distance;
        tool.tip = there.tip;
        // The stored radius of a ring is its largest: a shaft just within it may still pass by.
        if (distance < -surely_inside * ring_radius_[index(nearest)]) return;
    }
}

// Ring frames as skin_vertex() takes them.
struct MotionFrames {
    const RingMotion* rings;
    const RingFrame& operator[](std::size_t r) const { return rings[r].frame; }
};

// Candidate vertices, by_ring()[first ..], with their positions. Returns the centre of the patch: the contact
// vertex
// (-1: none), or the candidate nearest to the shaft.
static Vector3 gather(const BowelSkin& skin, const MotionFrames& frames, std::int32_t first,
                      std::int32_t candidates, const ToolKinematics& tool, std::int32_t contact_vertex,
                      PatchBuilder::Scratch& scratch) {
    scratch.found.resize(index(candidates));
    scratch.positions.resize(index(candidates));
    scratch.distance.resize(index(candidates));
    scratch.order.resize(index(candidates));
    Vector3 centre = Vector3::Zero();
    double best2 = 1e30;
    for (std::int32_t k = 0; k < candidates; ++k) {
        const std::int32_t vertex = skin.by_ring()[index(first + k)];
        scratch.found[index(k)] = vertex;
        const Vector3 position = skin_vertex(skin.rows()[index(vertex)], frames);
        scratch.positions[index(k)] = position;
        if (contact_vertex >= 0) {
            if (vertex == contact_vertex) centre = position;
            continue;
        }
        const double distance2 = to_shaft(tool, position).distance2;
        if (distance2 < best2) {
            best2 = distance2;
            centre = position;
        }
    }
    return centre;
}

// The candidates within the radius, at most the patch's capacity, the nearest first choice; in ascending
// order of vertex. Returns how many there are, in scratch.order.
static std::int32_t keep_nearest(std::int32_t candidates, const Vector3& centre, double radius,
                                 PatchBuilder::Scratch& scratch, SurfacePatch& patch) {
    std::int32_t within = 0;
    const double radius2 = radius * radius;
    for (std::int32_t k = 0; k < candidates; ++k) {
        const double distance2 = (scratch.positions[index(k)] - centre).squaredNorm();
        scratch.distance[index(k)] = distance2;
        if (distance2 <= radius2) scratch.order[index(within++)] = k;
    }
    if (within > patch_vertex_capacity) {
        patch.overflow = true;
        std::nth_element(scratch.order.begin(), scratch.order.begin() + patch_vertex_capacity,
                         scratch.order.begin() + within, [&](std::int32_t a, std::int32_t b) {
                             const double da = scratch.distance[index(a)], db = scratch.distance[index(b)];
                             return da < db ||
                                    (da <= db && scratch.found[index(a)] < scratch.found[index(b)]);
                         });
        within = patch_vertex_capacity;
    }
    std::sort(scratch.order.begin(), scratch.order.begin() + within, [&](std::int32_t a, std::int32_t b) {
        return scratch.found[index(a)] < scratch.found[index(b)];
    });
    return within;
}

// Seed: a triangle completely in the patch at the vertex nearest to the shaft; -1 if there is none. best2:
// squared distance, m2.
static std::int32_t find_seed(const ToolKinematics& tool, std::int32_t within,
                              const PatchBuilder::Scratch& scratch, SurfacePatch& patch, double& best2) {
    best2 = 1e30;
    std::int32_t seed = -1;
    for (std::int32_t v = 0; v < within; ++v) {
        if (patch.border[index(v)] != 0) continue;
        const ShaftDistance found = to_shaft(tool, scratch.positions[index(scratch.order[index(v)])]);
        if (found.distance2 >= best2) continue;
        best2 = found.distance2;
        seed = v;
        patch.seed_shaft = found.fraction;
    }
    return seed;
}

void PatchBuilder::build(const RingMotion* rings, const PatchRequest& request, Scratch& scratch,
                         LocalModel& model) const {
    SurfacePatch& patch = model.patch;
    clear(patch);
    model.mode = LocalMode::none;
    const int ring_total = skin_.rings();
    if (!request.tool.inside || ring_total < skin_rings) return;

    // Nearest ring: at the tool's contact vertex if it has one, else where the shaft is nearest to the tube.
    const MotionFrames frames{rings};
    bool holds = request.contact_vertex >= 0 && request.contact_vertex < skin_.vertices();
    if (holds) {
        // A tool that has jumped away is no longer in contact, even if the tick still reported it.
        const Vector3 held = skin_vertex(skin_.rows()[index(request.contact_vertex)], frames);
        holds = to_shaft(request.tool, held).distance2 < options_.radius * options_.radius;
    }
    int nearest = 0;
    ToolKinematics tool = request.tool;
    if (holds) {
        nearest = skin_.rows()[index(request.contact_vertex)].first_ring + 1;
    } else {
        look_ahead(rings, request, tool);
        if (!(nearest_ring(rings, tool, nearest) < options_.reach)) return;
    }

    // Rings: a window around it. Vertices: those whose four rings are all in the window.
    const int window = std::min(ring_total, patch_ring_capacity);
    patch.first_ring = std::clamp(nearest - window / 2, 0, ring_total - window);
    patch.ring_count = window;
    for (int r = 0; r < window; ++r) patch.rings[index(r)] = rings[patch.first_ring + r];
    const int last_row = patch.first_ring + window - skin_rings;
    const int from = std::clamp(nearest - 1 - search_intervals, patch.first_ring, last_row);
    const int to = std::clamp(nearest - 1 + search_intervals, patch.first_ring, last_row);

    const auto& offsets = skin_.by_ring_offsets();
    const std::int32_t candidates = offsets[index(to + 1)] - offsets[index(from)];
    double best2 = 1e30;
    const Vector3 centre = gather(skin_, frames, offsets[index(from)], candidates, tool,
                                  holds ? request.contact_vertex : -1, scratch);

    const std::int32_t within = keep_nearest(candidates, centre, options_.radius, scratch, patch);
    for (std::int32_t v = 0; v < within; ++v) {
        const std::int32_t id = scratch.found[index(scratch.order[index(v)])];
        scratch.local[index(id)] = v;
        patch.vertex_id[index(v)] = id;
        patch.rows[index(v)] = skin_.rows()[index(id)];
        if (wide_ != nullptr) wide_->correct(id, frames, patch.rows[index(v)]);
        patch.rows[index(v)].first_ring -= patch.first_ring;
        patch.nodule[index(v)] = nodule_.empty() ? 0.0 : nodule_[index(id)];
        patch.vertex_area[index(v)] = skin_.vertex_areas()[index(id)];
        patch.tissue_patch[index(v)] = tissue_patches_[index(id)];
    }
    patch.vertex_count = within;
    connect(scratch, patch);

    const std::int32_t seed = find_seed(tool, within, scratch, patch, best2);
    for (std::int32_t v = 0; v < within; ++v) scratch.local[index(patch.vertex_id[index(v)])] = -1;
    patch.contact = options_.contact;
    patch.curvature_radius = ring_radius_[index(std::clamp(nearest, 0, ring_total - 1))];
    if (seed < 0) {
        clear(patch);
        return;
    }
    patch.seed_triangle = patch.vertex_triangles[index(patch.vertex_triangle_offsets[index(seed)])];
    patch.seed_distance = std::sqrt(best2);
    model.mode = LocalMode::surface;
}

namespace {

bool same_vertices(const SurfacePatch& a, const SurfacePatch& b) {
    return a.vertex_count == b.vertex_count &&
           std::equal(a.vertex_id.begin(), a.vertex_id.begin() + a.vertex_count, b.vertex_id.begin());
}

// Vertices, and what find_connections() writes.
void copy_connections(const SurfacePatch& from, SurfacePatch& to) {
    const auto copy = [](const auto& source, std::int32_t count, auto& target) {
        std::copy_n(source.begin(), count, target.begin());
    };
    const std::int32_t vertices = from.vertex_count, triangles = from.triangle_count;
    to.vertex_count = vertices;
    to.triangle_count = triangles;
    copy(from.vertex_id, vertices, to.vertex_id);
    copy(from.border, vertices, to.border);
    copy(from.triangle_id, triangles, to.triangle_id);
    copy(from.triangles, triangles, to.triangles);
    copy(from.triangle_neighbours, 3 * triangles, to.triangle_neighbours);
    copy(from.vertex_triangle_offsets, vertices + 1, to.vertex_triangle_offsets);
    copy(from.vertex_triangles, from.vertex_triangle_offsets[index(vertices)], to.vertex_triangles);
    copy(from.vertex_neighbour_offsets, vertices + 1, to.vertex_neighbour_offsets);
    copy(from.vertex_neighbours, from.vertex_neighbour_offsets[index(vertices)], to.vertex_neighbours);
}

}  // namespace

void PatchBuilder::connect(Scratch& scratch, SurfacePatch& patch) const {
    const bool cut_short = patch.overflow;
    for (const SurfacePatch& last : scratch.connected) {
        if (last.vertex_count == 0 || !same_vertices(last, patch)) continue;
        copy_connections(last, patch);
        patch.overflow = cut_short || last.overflow;
        return;
    }
    patch.overflow = false;
    find_connections(scratch, patch);
    SurfacePatch& last = scratch.connected[scratch.oldest];
    copy_connections(patch, last);
    last.overflow = patch.overflow;
    scratch.oldest = (scratch.oldest + 1) % scratch.connected.size();
    patch.overflow = patch.overflow || cut_short;
}

// Triangles whose three vertices are in the patch, and their adjacency in patch numbers.
void PatchBuilder::find_connections(Scratch& scratch, SurfacePatch& patch) const {
    const MeshAdjacency& adjacency = skin_.adjacency();
    const auto& triangles = skin_.rest().triangles;
    std::int32_t count = 0;
    for (std::int32_t v = 0; v < patch.vertex_count; ++v) {
        const std::int32_t id = patch.vertex_id[index(v)];
        for (const std::int32_t t : adjacency.triangles_of(id)) {
            const Triangle& corner = triangles[index(t)];
            // Each triangle once: at its lowest vertex.
            if (id != std::min({corner[0], corner[1], corner[2]})) continue;
            if (scratch.local[index(corner[0])] < 0 || scratch.local[index(corner[1])] < 0 ||
                scratch.local[index(corner[2])] < 0) {
                continue;
            }
            if (count == patch_triangle_capacity) {
                patch.overflow = true;
                continue;
            }
            patch.triangle_id[index(count++)] = t;
        }
    }
    std::sort(patch.triangle_id.begin(), patch.triangle_id.begin() + count);
    patch.triangle_count = count;
    for (std::int32_t t = 0; t < count; ++t) scratch.triangle_local[index(patch.triangle_id[index(t)])] = t;
    for (std::int32_t t = 0; t < count; ++t) {
        const std::int32_t id = patch.triangle_id[index(t)];
        for (std::size_t k = 0; k < 3; ++k) {
            patch.triangles[index(t)][k] = scratch.local[index(triangles[index(id)][k])];
            const std::int32_t other = adjacency.triangle_neighbours[3 * index(id) + k];
            patch.triangle_neighbours[3 * index(t) + k] =
                other < 0 ? -1 : scratch.triangle_local[index(other)];
        }
    }
    std::int32_t around = 0, neighbours = 0;
    for (std::int32_t v = 0; v < patch.vertex_count; ++v) {
        const std::int32_t id = patch.vertex_id[index(v)];
        patch.vertex_triangle_offsets[index(v)] = around;
        patch.vertex_neighbour_offsets[index(v)] = neighbours;
        patch.border[index(v)] = 0;
        for (const std::int32_t t : adjacency.triangles_of(id)) {
            if (scratch.triangle_local[index(t)] < 0) {
                patch.border[index(v)] = 1;
            } else {
                patch.vertex_triangles[index(around++)] = scratch.triangle_local[index(t)];
            }
        }
        for (const std::int32_t other : adjacency.neighbours_of(id)) {
            if (scratch.local[index(other)] < 0) continue;
            if (neighbours == patch_neighbour_capacity) {
                patch.overflow = true;
                break;
            }
            patch.vertex_neighbours[index(neighbours++)] = scratch.local[index(other)];
        }
    }
    patch.vertex_triangle_offsets[index(patch.vertex_count)] = around;
    patch.vertex_neighbour_offsets[index(patch.vertex_count)] = neighbours;
    for (std::int32_t t = 0; t < count; ++t) scratch.triangle_local[index(patch.triangle_id[index(t)])] = -1;
}

std::vector<std::int16_t> divide_into_patches(const BowelSkin& skin, int rings_per_patch, int sectors) {
    constexpr double two_pi = 6.283185307179586;
    std::vector<std::int16_t> patches;
    patches.reserve(static_cast<std::size_t>(skin.vertices()));
    for (const Vector3& vertex : skin.rest().vertices) {
        // The rest pose is along +x with d1 = +y, d2 = +z.
        const auto& arcs = skin.cage().arc_lengths;
        const auto next = std::upper_bound(arcs.begin(), arcs.end(), vertex.x());
        const auto ring = std::clamp<std::ptrdiff_t>(next - arcs.begin() - 1, 0, skin.rings() - 1);
        double turn = math::atan2(vertex.z(), vertex.y()) / two_pi;
        if (turn < 0) turn += 1;
        const int sector = std::min(sectors - 1, static_cast<int>(turn * sectors));
        patches.push_back(
            static_cast<std::int16_t>(static_cast<int>(ring) / rings_per_patch * sectors + sector));
    }
    return patches;
}

int patch_count(const BowelSkin& skin, int rings_per_patch, int sectors) {
    return ((skin.rings() - 1) / rings_per_patch + 1) * sectors;
}

}  // namespace fulcrum
