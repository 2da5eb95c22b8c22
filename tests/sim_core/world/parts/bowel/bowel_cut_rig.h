// SPDX-License-Identifier: Apache-2.0
// Scissors in the right hand, a grasper in the left, at a bowel with a cuttable wall.
#pragma once

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum::test {

inline Scene enterotomy() {
    return load_scene(source_path("assets/scenes/bowel_enterotomy.json"));
}

struct BowelCutRig : SheetRig {
    explicit BowelCutRig(const Scene& chosen = enterotomy()) : SheetRig(chosen) {
        top = highest_near(world.snapshot().bowel.nodes[world.snapshot().bowel.nodes.size() / 2]);
    }

    const BowelPart& bowel() const { return *world.find<BowelPart>(); }
    BowelCut& cut() { return *world.find<BowelPart>()->cut(); }
    const BowelCut::HandState& blade() const { return bowel().cut()->hand(1); }
    Vector3 now(std::int32_t vertex) const {
        return skin_vertex(bowel().skin().rows()[static_cast<std::size_t>(vertex)], bowel().ring_frames());
    }
    Vector3 top_now() const { return now(top); }
    /// The highest wall vertex near a point, which instruments reach from above.
    std::int32_t highest_near(const Vector3& point) const {
        std::int32_t best = -1;
        for (std::int32_t v = 0; v < bowel().skin().vertices(); ++v) {
            if ((now(v) - point).norm() < 0.03 && (best < 0 || now(v).z() > now(best).z())) best = v;
        }
        return best;
    }
    std::vector<Vector3> positions() {
        std::vector<Vector3> all(static_cast<std::size_t>(cut().skin().surface().capacity().vertices),
                                 Vector3::Zero());
        cut().skin().place_all(bowel().ring_frames(), all.data());
        return all;
    }
    /// Out of the bowel at a vertex.
    Vector3 outward(std::int32_t vertex) const {
        const SkinRow& row = bowel().skin().rows()[static_cast<std::size_t>(vertex)];
        Vector3 centre = Vector3::Zero();
        for (int j = 0; j < skin_rings; ++j)
            centre += row.weight[j] * bowel().ring_frames()[row.first_ring + j].position;
        return (now(vertex) - centre).normalized();
    }
    /// A place of the wall as it is now.
    struct WallPlace {
        Vector3 point, outward;
        std::int32_t root;
    };
    /// Cuts along a path of wall positions. Returns the detached pieces.
    CutSkin::Report cut_along(const std::vector<WallPlace>& path) {
        CutSkin::Report sum;
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            BladeStep blade;
            blade.from = path[i].point;
            blade.to = path[i + 1].point;
            blade.end = BladeEnd::round;
            blade.normal = path[i].outward + path[i + 1].outward;
            blade.width = scene.bowel->blade_width;
            blade.depth = 0.003;
            blade.root = path[i].root;
            const CutSkin::Report one = cut().cut(blade, bowel().ring_frames(), tick, 1);
            sum.parted += one.parted;
            sum.parted_area += one.parted_area;
        }
        return sum;
    }
    /// From vertex to vertex of the skin.
    CutSkin::Report cut_along(const std::vector<std::int32_t>& path) {
        std::vector<WallPlace> places;
        for (const std::int32_t v : path)
            places.push_back({now(v), outward(v), *bowel().skin().adjacency().triangles_of(v).begin()});
        return cut_along(places);
    }
    /// In the rest pose, m along and around from a vertex.
    Vector3 rest_at(std::int32_t from, double along, double around) const {
        const Vector3& start = bowel().skin().rest().vertices[static_cast<std::size_t>(from)];
        const double size = std::sqrt(start.y() * start.y() + start.z() * start.z());
        double sine = 0, cosine = 1;
        math::sin_cos(around / size, sine, cosine);
        return {start.x() + along, cosine * start.y() - sine * start.z(),
                sine * start.y() + cosine * start.z()};
    }
    /// Vertex nearest to it.
    std::int32_t vertex_at(std::int32_t from, double along, double around) const {
        const Vector3 path = rest_at(from, along, around);
        std::int32_t best = from;
        for (std::int32_t v = 0; v < bowel().skin().vertices(); ++v) {
            const auto away = [&](std::int32_t one) {
                return (bowel().skin().rest().vertices[static_cast<std::size_t>(one)] - path).norm();
            };
            if (away(v) < away(best)) best = v;
        }
        return best;
    }
    /// Place of the wall nearest to it.
    WallPlace place_at(std::int32_t from, double along, double around) const {
        const Vector3 path = rest_at(from, along, around);
        const std::int32_t vertex = vertex_at(from, along, around);
        const TriangleMesh& rest = bowel().skin().rest();
        WallPlace place{now(vertex), outward(vertex), -1};
        double least = 1;
        for (const std::int32_t t : bowel().skin().adjacency().triangles_of(vertex)) {
            const Triangle& corners = rest.triangles[static_cast<std::size_t>(t)];
            const auto at_rest = [&](std::size_t c) {
                return rest.vertices[static_cast<std::size_t>(corners[c])];
            };
            const TrianglePoint near = closest_point_on_triangle(path, at_rest(0), at_rest(1), at_rest(2));
            if ((near.position - path).norm() >= least) continue;
            least = (near.position - path).norm();
            place.root = t;
            place.point = near.barycentric[0] * now(corners[0]) + near.barycentric[1] * now(corners[1]) +
                          near.barycentric[2] * now(corners[2]);
        }
        return place;
    }
    /// A circle around a vertex, approximated by blade steps.
    CutSkin::Report cut_round(std::int32_t vertex, double radius) {
        std::vector<WallPlace> path;
        for (int i = 0; i <= 34; ++i) {
            double sine = 0, cosine = 1;
            math::sin_cos(6.283185307179586 * i / 32, sine, cosine);
            path.push_back(place_at(vertex, radius * cosine, radius * sine));
        }
        return cut_along(path);
    }
    /// A slit along the bowel through a vertex.
    CutSkin::Report cut_slit(std::int32_t vertex, double length) {
        std::vector<WallPlace> path;
        for (int i = 0; i <= 16; ++i) path.push_back(place_at(vertex, length * (i / 16.0 - 0.5), 0));
        return cut_along(path);
    }
    /// About a circle of that radius around a vertex, from vertex to vertex.
    CutSkin::Report cut_circle(std::int32_t vertex, double radius) {
        std::vector<std::int32_t> path;
        for (int i = 0; i <= 34; ++i) {
            double sine = 0, cosine = 1;
            math::sin_cos(6.283185307179586 * i / 32, sine, cosine);
            const std::int32_t next = vertex_at(vertex, radius * cosine, radius * sine);
            if (path.empty() || path.back() != next) path.push_back(next);
        }
        return cut_along(path);
    }
    /// The blade in the wall at the top, along `path` from there, at a depth below the wall.
    void cut_by_hand(const Vector3& path, double depth = 0.003, double speed = 0.03) {
        const Vector3 start = top_now();
        go(1, start + Vector3(0, 0, 0.015), 0.2);
        wish[1].button = true;
        go(1, start + Vector3(0, 0, 0.0012), 0.05);
        go(1, start + 0.15 * path - Vector3(0, 0, depth), speed);
        go(1, start + path - Vector3(0, 0, depth), speed);
    }
    /// Left jaws on the wall next to the top.
    void hold_beside(const Vector3& off) {
        const std::int32_t vertex = highest_near(top_now() + off);
        go(0, tip_for(now(vertex) + Vector3(0, 0, 0.02)), 0.2);
        go(0, tip_for(now(vertex) + Vector3(0, 0, 0.001)), 0.1);
        steps(5);
        wish[0].closed = true;
        steps(20);
    }
    std::int32_t top = -1;
};

}  // namespace fulcrum::test
