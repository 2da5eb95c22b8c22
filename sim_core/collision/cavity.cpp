// SPDX-License-Identifier: Apache-2.0
#include "sim_core/collision/cavity.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/AABB.h>

#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

// Numbers of the triangles in the order of the leaves of FCL's tree over them.
std::vector<std::size_t> leaf_order(const std::vector<Vector3>& vertices,
                                    const std::vector<fcl::Triangle>& triangles) {
    fcl::BVHModel<fcl::AABB<double>> tree;
    tree.beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
    tree.addSubModel(vertices, triangles);
    tree.endModel();
    std::vector<std::size_t> order;
    order.reserve(triangles.size());
    std::vector<int> waiting{0};
    while (!waiting.empty()) {
        const auto& node = tree.getBV(waiting.back());
        waiting.pop_back();
        if (node.isLeaf()) {
            order.push_back(static_cast<std::size_t>(node.primitiveId()));
            continue;
        }
        waiting.push_back(node.rightChild());
        waiting.push_back(node.leftChild());
    }
    return order;
}

}  // namespace

CavityModel::CavityModel(const TriangleMesh& mesh, FreeSide side) : mesh_(mesh), side_(side) {
    for (const Vector3& vertex : mesh_.vertices) {
        if (!vertex.allFinite() || vertex.cwiseAbs().maxCoeff() > 1e6) {
            throw InputError("cavity mesh", "vertices", "a coordinate is not finite or exceeds 1,000 km",
                             "correct the mesh; its unit is the metre");
        }
    }
    adjacency_ = build_adjacency(mesh_);
    const double sign = side_ == FreeSide::front ? 1.0 : -1.0;
    const std::size_t count = mesh_.triangles.size();
    triangles_.resize(count);
    ridges_.resize(3 * count);
    edge_pseudonormals_.assign(3 * count, Vector3::Zero());
    vertex_pseudonormals_.assign(mesh_.vertices.size(), Vector3::Zero());
    normals_.assign(mesh_.vertices.size(), Vector3::Zero());
    std::vector<fcl::Triangle> usable;
    std::vector<std::int32_t> number;
    usable.reserve(count);
    for (std::size_t t = 0; t < count; ++t) {
        const Triangle& corners = mesh_.triangles[t];
        const Vector3 p[3] = {mesh_.vertices[static_cast<std::size_t>(corners[0])],
                              mesh_.vertices[static_cast<std::size_t>(corners[1])],
                              mesh_.vertices[static_cast<std::size_t>(corners[2])]};
        CavityTriangle& triangle = triangles_[t];
        triangle.a = p[0];
        triangle.b = p[1];
        triangle.c = p[2];
        const Vector3 twice_area = sign * (p[1] - p[0]).cross(p[2] - p[0]);
        const double size = twice_area.norm();
        const double longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
        if (!(size > 1e-12 * longest * longest) || longest <= 0) continue;
        triangle.normal = twice_area / size;
        for (int k = 0; k < 3; ++k) {
            const Vector3 u = p[(k + 1) % 3] - p[k], v = p[(k + 2) % 3] - p[k];
            const auto corner = static_cast<std::size_t>(corners[static_cast<std::size_t>(k)]);
            vertex_pseudonormals_[corner] += math::atan2(u.cross(v).norm(), u.dot(v)) * triangle.normal;
            normals_[corner] += twice_area;
        }
        usable.emplace_back(static_cast<std::size_t>(corners[0]), static_cast<std::size_t>(corners[1]),
                            static_cast<std::size_t>(corners[2]));
        number.push_back(static_cast<std::int32_t>(t));
    }
    if (usable.empty()) {
        throw InputError("cavity mesh", "triangles", "no triangle has an area",
                         "give a mesh with at least one triangle of non-zero area");
    }
    for (std::size_t e = 0; e < 3 * count; ++e) {
        const std::int32_t other = adjacency_.triangle_neighbours[e];
        edge_pseudonormals_[e] = triangles_[e / 3].normal;
        if (other >= 0) edge_pseudonormals_[e] += triangles_[static_cast<std::size_t>(other)].normal;
    }
    for (Vector3& normal : normals_) {
        const double length = normal.norm();
        if (length > 0) normal /= length;
    }

    // Eight consecutive triangles in the tree's leaf order form a packet.
    std::vector<Box> boxes;
    packets_.reserve((usable.size() + packet_size - 1) / packet_size);
    int lane = packet_size;
    for (const std::size_t leaf : leaf_order(mesh_.vertices, usable)) {
        if (lane == packet_size) {
            packets_.emplace_back();
            boxes.emplace_back();
            lane = 0;
        }
        const std::int32_t t = number[leaf];
        fill(packets_.back(), lane++, t);
        const CavityTriangle& triangle = triangles_[static_cast<std::size_t>(t)];
        for (const Vector3& corner : {triangle.a, triangle.b, triangle.c}) boxes.back().add(corner);
    }
    for (; lane < packet_size; ++lane) packets_.back().clear(lane);
    boxes_ = BoxTree(std::move(boxes));
}

void CavityModel::fill(TrianglePacket& packet, int lane, std::int32_t number) {
    const double sign = side_ == FreeSide::front ? 1.0 : -1.0;
    const auto t = static_cast<std::size_t>(number);
    const CavityTriangle& triangle = triangles_[t];
    packet.clear(lane);
    packet.triangle[lane] = number;
    const auto set = [&](std::size_t plane, const Vector3& normal, const Vector3& point) {
        packet.x[plane][lane] = static_cast<float>(normal.x());
        packet.y[plane][lane] = static_cast<float>(normal.y());
        packet.z[plane][lane] = static_cast<float>(normal.z());
        packet.offset[plane][lane] = static_cast<float>(normal.dot(point));
    };
    set(0, triangle.normal, triangle.a);
    const Vector3 corner[3] = {triangle.a, triangle.b, triangle.c};
    for (std::size_t e = 0; e < 3; ++e) {
        const Vector3& from = corner[e];
        const Vector3 along = corner[(e + 1) % 3] - from;
        set(e + 1, sign * along.cross(triangle.normal).normalized(), from);
        const std::int32_t other = adjacency_.triangle_neighbours[3 * t + e];
        if (other < 0 || triangles_[static_cast<std::size_t>(other)].normal.isZero()) {
            packet.wedge[e][lane] = 1e9F;  // a border: points beyond it have their foot on it
            ridges_[3 * t + e] = {0, 0, 0, -1};
            continue;
        }
        double rise = 0;  // height of the neighbour's far corner over this triangle's plane
        for (const std::int32_t vertex : mesh_.triangles[static_cast<std::size_t>(other)]) {
            const double height =
                triangle.normal.dot(mesh_.vertices[static_cast<std::size_t>(vertex)] - from);
            if (std::abs(height) > std::abs(rise)) rise = height;
        }
        // The foot of a point in a ridge's wedge lies on the ridge, for both triangles: the lower triangle
        // number reports it.
        const Vector3& across = triangles_[static_cast<std::size_t>(other)].normal;
        if (rise < -1e-12 && number < other) {
            const double sine = triangle.normal.cross(across).norm();
            packet.wedge[e][lane] =
                triangle.normal.dot(across) > 0 ? static_cast<float>(sine * (1 + 1e-5) + 1e-5) : 1e9F;
        }
        const Vector3 beyond = -sign * along.cross(across).normalized();
        ridges_[3 * t + e] = {static_cast<float>(beyond.x()), static_cast<float>(beyond.y()),
                              static_cast<float>(beyond.z()), static_cast<float>(beyond.dot(from))};
    }
}

std::size_t CavityModel::bytes() const {
    return sizeof(*this) + mesh_.vertices.capacity() * sizeof(Vector3) +
           mesh_.triangles.capacity() * sizeof(Triangle) + triangles_.capacity() * sizeof(CavityTriangle) +
           packets_.capacity() * sizeof(TrianglePacket) + ridges_.capacity() * sizeof(ridges_[0]) +
           (normals_.capacity() + vertex_pseudonormals_.capacity() + edge_pseudonormals_.capacity()) *
               sizeof(Vector3) +
           (adjacency_.triangle_neighbours.capacity() + adjacency_.vertex_triangle_offsets.capacity() +
            adjacency_.vertex_triangles.capacity() + adjacency_.vertex_neighbour_offsets.capacity() +
            adjacency_.vertex_neighbours.capacity()) *
               sizeof(std::int32_t) +
           boxes_.bytes();
}

// Sign by the pseudonormal of the foot's feature.
CavityPoint CavityModel::sign(std::int32_t triangle, const Vector3& point, const Vector3& foot,
                              TriangleFeature feature) const {
    const auto index = static_cast<std::size_t>(triangle);
    const Triangle& corners = mesh_.triangles[index];
    const auto kind = static_cast<std::size_t>(feature);
    const Vector3* pseudonormal = &triangles_[index].normal;
    if (feature <= TriangleFeature::vertex_c) {
        pseudonormal = &vertex_pseudonormals_[static_cast<std::size_t>(corners[kind])];
    } else if (feature != TriangleFeature::face) {
        pseudonormal =
            &edge_pseudonormals_[3 * index + kind - static_cast<std::size_t>(TriangleFeature::edge_ab)];
    }
    CavityPoint result;
    result.triangle = triangle;
    result.position = foot;
    const Vector3 out = point - foot;
    const double length = out.norm();
    const bool behind = out.dot(*pseudonormal) < 0;
    result.distance = behind ? -length : length;
    // On the wall itself the difference has no direction.
    result.normal = length > 1e-12 ? Vector3((behind ? -out : out) / length) : triangles_[index].normal;
    return result;
}

CavityPoint CavityModel::closest_on(std::int32_t triangle, const Vector3& point) const {
    const CavityTriangle& t = triangles_[static_cast<std::size_t>(triangle)];
    const TrianglePoint foot = closest_point_on_triangle(point, t.a, t.b, t.c);
    return sign(triangle, point, foot.position, foot.feature);
}

bool CavityModel::examine(std::int32_t triangle, const Vector3& point, double reach2, CavityPoint& result,
                          bool& local_minimum) const {
    const auto index = static_cast<std::size_t>(triangle);
    const CavityTriangle& t = triangles_[index];
    const TrianglePoint foot = closest_point_on_triangle(point, t.a, t.b, t.c);
    const Vector3 out = point - foot.position;
    const double distance2 = out.squaredNorm();
    if (!(distance2 <= reach2)) return false;
    result = sign(triangle, point, foot.position, foot.feature);
    // The foot is nearest within its own triangle. Whether the surrounding wall is nearer follows from the
    // directions of the adjacent triangles.
    local_minimum = true;
    if (foot.feature == TriangleFeature::face) return true;
    const double tolerance = 1e-12 + 1e-9 * distance2;  // m2
    const auto kind = static_cast<std::size_t>(foot.feature);
    if (foot.feature <= TriangleFeature::vertex_c) {
        const std::int32_t vertex = mesh_.triangles[index][kind];
        for (const std::int32_t other : adjacency_.neighbours_of(vertex)) {
            if (out.dot(mesh_.vertices[static_cast<std::size_t>(other)] - foot.position) > tolerance)
                local_minimum = false;
        }
        return true;
    }
    const std::size_t edge = kind - static_cast<std::size_t>(TriangleFeature::edge_ab);
    const std::int32_t other = adjacency_.triangle_neighbours[3 * index + edge];
    if (other < 0) return true;
    const Triangle& corners = mesh_.triangles[index];
    for (const std::int32_t vertex : mesh_.triangles[static_cast<std::size_t>(other)]) {
        if (vertex == corners[edge] || vertex == corners[(edge + 1) % 3]) continue;
        if (out.dot(mesh_.vertices[static_cast<std::size_t>(vertex)] - foot.position) > tolerance)
            local_minimum = false;
    }
    return true;
}

int CavityModel::list(const Vector3& point, double reach, double margin, ListedPacket* found, int capacity,
                      int& boxes) const {
    const FloatPoint at(point);
    const auto near = static_cast<float>(reach), soon = static_cast<float>(margin + sleep_slack);
    int count = 0;
    boxes = 0;
    if (!point.allFinite()) return 0;
    boxes_.within(point, reach + margin, [&](std::int32_t box) {
        ++boxes;
        const TrianglePacket& packet = packets_[static_cast<std::size_t>(box)];
        float concern[packet_size];
        double first = 1e30;
        for_each_lane(packet.concern(at, near, soon, concern), [&](int lane) {
            auto awake = static_cast<double>(concern[lane]);
            if (awake >= first) return;
            if (awake < 0) {
                // The plane extends beyond the triangle: compute the exact distance.
                const CavityTriangle& t = triangles_[static_cast<std::size_t>(packet.triangle[lane])];
                const Vector3 foot = closest_point_on_triangle(point, t.a, t.b, t.c).position;
                awake = std::max(awake, (point - foot).norm() - reach);
            }
            first = std::min(first, awake);
        });
        if (!(first < margin + sleep_slack)) return;
        if (count < capacity) found[count] = {box, static_cast<float>(first - sleep_slack)};
        ++count;
    });
    return count;
}

CavityPoint CavityModel::closest(const Vector3& point, double reach) const {
    CavityPoint best;
    if (!point.allFinite()) return best;
    double best2 = reach * reach;
    std::int32_t nearest = -1;
    boxes_.nearest(point, reach, [&](std::int32_t box) {
        for (const std::int32_t number : packets_[static_cast<std::size_t>(box)].triangle) {
            if (number < 0) break;
            const CavityTriangle& t = triangles_[static_cast<std::size_t>(number)];
            const double distance2 =
                (point - closest_point_on_triangle(point, t.a, t.b, t.c).position).squaredNorm();
            // The lowest number wins a tie, so that the answer does not depend on the tree's order.
            if (distance2 < best2 || (distance2 <= best2 && (nearest < 0 || number < nearest))) {
                best2 = distance2;
                nearest = number;
            }
        }
        return std::sqrt(best2);
    });
    return nearest < 0 ? best : closest_on(nearest, point);
}

}  // namespace fulcrum
