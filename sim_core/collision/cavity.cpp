// SPDX-License-Identifier: Apache-2.0
#include "sim_core/collision/cavity.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/AABB.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr int stack_capacity = 128;  // nodes waiting: one a level of the tree, and one more

// FCL's nodes, laid out for queries: boxes side by side, leaves named by ~cluster.
struct Node {
    double low[3], high[3];
    std::int32_t left = 0;  ///< right = left + 1; a leaf: ~cluster
};

double squared_distance(const Node& node, const Vector3& p) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const double below = node.low[i] - p[i], above = p[i] - node.high[i];
        const double outside = std::max(std::max(below, above), 0.0);
        sum += outside * outside;
    }
    return sum;
}

}  // namespace

struct CavityModel::Hierarchy {
    std::vector<Node> nodes;
};

CavityModel::CavityModel(CavityModel&&) noexcept = default;
CavityModel& CavityModel::operator=(CavityModel&&) noexcept = default;
CavityModel::~CavityModel() = default;

CavityModel::CavityModel(const TriangleMesh& mesh, FreeSide side)
    : mesh_(mesh), side_(side), hierarchy_(std::make_unique<Hierarchy>()) {
    for (const Vector3& vertex : mesh_.vertices) {
        if (!vertex.allFinite()) {
            throw InputError("cavity mesh", "vertices", "a coordinate is not finite", "repair the mesh");
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
                         "give a mesh with at least one");
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

    fcl::BVHModel<fcl::AABB<double>> tree;
    tree.beginModel(static_cast<int>(usable.size()), static_cast<int>(mesh_.vertices.size()));
    tree.addSubModel(mesh_.vertices, usable);
    tree.endModel();
    // FCL's tree, its small subtrees gathered into clusters.
    struct Copy {
        int from;
        std::size_t to;
    };
    hierarchy_->nodes.emplace_back();
    std::vector<Copy> waiting{{0, 0}};
    while (!waiting.empty()) {
        const Copy copy = waiting.back();
        waiting.pop_back();
        const auto& from = tree.getBV(copy.from);
        Node node;
        for (int k = 0; k < 3; ++k) {
            node.low[k] = from.bv.min_[k];
            node.high[k] = from.bv.max_[k];
        }
        if (from.num_primitives <= cluster_size) {
            node.left = ~static_cast<std::int32_t>(clusters_.size());
            TriangleCluster& cluster = clusters_.emplace_back();
            cluster.count = 0;
            std::vector<int> below{copy.from};
            while (!below.empty()) {
                const auto& leaf = tree.getBV(below.back());
                below.pop_back();
                if (leaf.isLeaf()) {
                    cluster.triangle[cluster.count++] = number[static_cast<std::size_t>(leaf.primitiveId())];
                } else {
                    below.push_back(leaf.rightChild());
                    below.push_back(leaf.leftChild());
                }
            }
            fill_cluster(cluster);
        } else {
            node.left = static_cast<std::int32_t>(hierarchy_->nodes.size());
            hierarchy_->nodes.emplace_back();
            hierarchy_->nodes.emplace_back();
            waiting.push_back({from.rightChild(), static_cast<std::size_t>(node.left) + 1});
            waiting.push_back({from.leftChild(), static_cast<std::size_t>(node.left)});
        }
        hierarchy_->nodes[copy.to] = node;
    }
    // Children come after their parent, so one pass gives every depth.
    std::vector<int> level(hierarchy_->nodes.size(), 0);
    for (std::size_t i = 0; i < level.size(); ++i) {
        const Node& node = hierarchy_->nodes[i];
        if (node.left < 0) continue;
        for (int k = 0; k < 2; ++k) level[static_cast<std::size_t>(node.left + k)] = level[i] + 1;
        if (level[i] + 3 > stack_capacity) {
            throw InputError("cavity mesh", "triangles",
                             "they cluster so unevenly that the hierarchy is too deep",
                             "remove coincident triangles");
        }
    }
}

void CavityModel::fill_cluster(TriangleCluster& cluster) {
    const double sign = side_ == FreeSide::front ? 1.0 : -1.0;
    Vector3 low = Vector3::Constant(1e30), high = -low;
    for (std::size_t k = 0; k < static_cast<std::size_t>(cluster_size); ++k) {
        for (std::size_t plane = 0; plane < 4; ++plane) {
            cluster.x[plane][k] = cluster.y[plane][k] = cluster.z[plane][k] = 0;
            cluster.offset[plane][k] =
                1e9F;  // a plane that nothing is beyond, a triangle that nothing is near
        }
        for (std::size_t e = 0; e < 3; ++e) cluster.wedge[e][k] = -1e9F;
        if (k >= static_cast<std::size_t>(cluster.count)) {
            cluster.triangle[k] = -1;
            continue;
        }
        const auto t = static_cast<std::size_t>(cluster.triangle[k]);
        const CavityTriangle& triangle = triangles_[t];
        const auto set = [&](std::size_t plane, const Vector3& normal, const Vector3& point) {
            cluster.x[plane][k] = static_cast<float>(normal.x());
            cluster.y[plane][k] = static_cast<float>(normal.y());
            cluster.z[plane][k] = static_cast<float>(normal.z());
            cluster.offset[plane][k] = static_cast<float>(normal.dot(point));
        };
        set(0, triangle.normal, triangle.a);
        const Vector3 corner[3] = {triangle.a, triangle.b, triangle.c};
        for (std::size_t e = 0; e < 3; ++e) {
            low = low.cwiseMin(corner[e]);
            high = high.cwiseMax(corner[e]);
            const Vector3& from = corner[e];
            const Vector3 along = corner[(e + 1) % 3] - from;
            const std::int32_t other = adjacency_.triangle_neighbours[3 * t + e];
            if (other < 0 || triangles_[static_cast<std::size_t>(other)].normal.isZero()) {
                set(e + 1, sign * along.cross(triangle.normal).normalized(), from);
                cluster.wedge[e][k] = 1e9F;  // a rim: what is beyond it has its foot on it
                ridges_[3 * t + e] = {0, 0, 0, -1};
                continue;
            }
            double rise = 0;  // of the neighbour's far corner over this triangle's plane
            for (const std::int32_t vertex : mesh_.triangles[static_cast<std::size_t>(other)]) {
                const double height =
                    triangle.normal.dot(mesh_.vertices[static_cast<std::size_t>(vertex)] - from);
                if (std::abs(height) > std::abs(rise)) rise = height;
            }
            set(e + 1, sign * along.cross(triangle.normal).normalized(), from);
            // The foot of a point in a ridge's wedge is on the ridge, for both triangles: the lower number
            // keeps it.
            if (rise < -1e-12 && static_cast<std::int32_t>(t) < other) {
                const Vector3& across = triangles_[static_cast<std::size_t>(other)].normal;
                const double sine = triangle.normal.cross(across).norm();
                cluster.wedge[e][k] =
                    triangle.normal.dot(across) > 0 ? static_cast<float>(sine * (1 + 1e-5) + 1e-5) : 1e9F;
            }
            const Vector3 beyond =
                -sign * along.cross(triangles_[static_cast<std::size_t>(other)].normal).normalized();
            ridges_[3 * t + e] = {static_cast<float>(beyond.x()), static_cast<float>(beyond.y()),
                                  static_cast<float>(beyond.z()), static_cast<float>(beyond.dot(from))};
        }
    }
    cluster.low[3] = cluster.high[3] = 0;
    for (int i = 0; i < 3; ++i) {
        const double slack = 1e-7 + 2e-7 * std::max(std::abs(low[i]), std::abs(high[i]));
        cluster.low[i] = static_cast<float>(low[i] - slack);
        cluster.high[i] = static_cast<float>(high[i] + slack);
    }
}

std::size_t CavityModel::bytes() const {
    return sizeof(*this) + mesh_.vertices.capacity() * sizeof(Vector3) +
           mesh_.triangles.capacity() * sizeof(Triangle) + triangles_.capacity() * sizeof(CavityTriangle) +
           clusters_.capacity() * sizeof(TriangleCluster) + ridges_.capacity() * sizeof(ridges_[0]) +
           (normals_.capacity() + vertex_pseudonormals_.capacity() + edge_pseudonormals_.capacity()) *
               sizeof(Vector3) +
           (adjacency_.triangle_neighbours.capacity() + adjacency_.vertex_triangle_offsets.capacity() +
            adjacency_.vertex_triangles.capacity() + adjacency_.vertex_neighbour_offsets.capacity() +
            adjacency_.vertex_neighbours.capacity()) *
               sizeof(std::int32_t) +
           hierarchy_->nodes.capacity() * sizeof(Node);
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
    // On the wall itself the direction of the difference means nothing.
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
    // The foot is nearest in its own triangle; whether the wall beyond it comes nearer is seen from the
    // directions in which the triangles around it leave.
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

int CavityModel::list(const Vector3& point, double reach, ListedCluster* found, int capacity) const {
    const std::vector<Node>& nodes = hierarchy_->nodes;
    const double reach2 = reach * reach;
    std::int32_t stack[stack_capacity];
    int depth = 0, count = 0;
    if (!point.allFinite()) return 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = nodes[static_cast<std::size_t>(stack[--depth])];
        const double distance2 = squared_distance(node, point);
        if (distance2 > reach2) continue;
        if (node.left >= 0) {
            stack[depth++] = node.left + 1;
            stack[depth++] = node.left;
            continue;
        }
        if (count < capacity) {
            found[count] = {~node.left, static_cast<float>(std::sqrt(distance2) * (1 - 1e-6))};
        }
        ++count;
    }
    return count;
}

CavityPoint CavityModel::closest(const Vector3& point, double reach) const {
    const std::vector<Node>& nodes = hierarchy_->nodes;
    struct Waiting {
        std::int32_t node;
        double distance2;
    };
    Waiting stack[stack_capacity];
    int depth = 0;
    CavityPoint best;
    if (!point.allFinite()) return best;
    double best2 = reach * reach;
    std::int32_t nearest = -1;
    stack[depth++] = {0, squared_distance(nodes[0], point)};
    while (depth > 0) {
        const Waiting top = stack[--depth];
        if (top.distance2 > best2) continue;
        const Node& node = nodes[static_cast<std::size_t>(top.node)];
        if (node.left < 0) {
            const TriangleCluster& cluster = clusters_[static_cast<std::size_t>(~node.left)];
            for (int k = 0; k < cluster.count; ++k) {
                const std::int32_t number = cluster.triangle[k];
                const CavityTriangle& t = triangles_[static_cast<std::size_t>(number)];
                const double distance2 =
                    (point - closest_point_on_triangle(point, t.a, t.b, t.c).position).squaredNorm();
                // The lowest number wins a tie, so that the answer does not hang on the tree's order.
                if (distance2 < best2 || (distance2 <= best2 && (nearest < 0 || number < nearest))) {
                    best2 = distance2;
                    nearest = number;
                }
            }
            continue;
        }
        Waiting left{node.left, squared_distance(nodes[static_cast<std::size_t>(node.left)], point)};
        Waiting right{node.left + 1, squared_distance(nodes[static_cast<std::size_t>(node.left + 1)], point)};
        if (left.distance2 < right.distance2) std::swap(left, right);
        if (left.distance2 <= best2) stack[depth++] = left;
        if (right.distance2 <= best2) stack[depth++] = right;
    }
    return nearest < 0 ? best : closest_on(nearest, point);
}

}  // namespace fulcrum
