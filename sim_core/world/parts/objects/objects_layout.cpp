// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/objects/objects_layout.h"

#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr std::uint64_t stream = 21;   // of the seed, for positions
constexpr double buried = 0.003;       // m of a peg below the tray
constexpr int peg_sides = 8;           // of a peg as instruments feel it
constexpr double overlap = 0.00005;    // m, of a ring at rest with the tray
constexpr double least_upright = 0.3;  // cosine: a ring that stands on its edge is around no peg

void add_peg(TriangleMesh& mesh, const ObjectsSpec& spec, const Vector3& foot) {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    const double shoulder = spec.peg_height - spec.peg_radius;
    for (const double z : {-buried, shoulder}) {
        for (int i = 0; i < peg_sides; ++i) {
            const double angle = 2 * pi * i / peg_sides;
            mesh.vertices.emplace_back(
                foot + Vector3(spec.peg_radius * math::cos(angle), spec.peg_radius * math::sin(angle), z));
        }
    }
    mesh.vertices.emplace_back(foot + Vector3(0, 0, spec.peg_height));
    for (std::int32_t i = 0; i < peg_sides; ++i) {
        const std::int32_t next = (i + 1) % peg_sides;
        const std::int32_t a = first + i, b = first + next, c = b + peg_sides, d = a + peg_sides;
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
        mesh.triangles.push_back({d, c, first + 2 * peg_sides});
    }
}

}  // namespace

ObjectsLayout place_objects(const ObjectsSpec& spec, const Vector3& gravity, std::uint64_t seed) {
    ObjectsLayout layout;
    layout.ring = make_ring(spec.sides, spec.corner_radius, spec.tube_radius, spec.mass);
    layout.ground.point = spec.centre;
    layout.ground.gravity = gravity;
    layout.ground.friction = spec.friction;
    Random random(seed, stream);
    const double side = spec.from == Hand::left ? 1 : -1;
    const int rows = (spec.count + 1) / 2;
    for (const double group : {side, -side}) {
        for (int i = 0; i < spec.count; ++i) {
            const double x = 0.5 * group * spec.gap + (i % 2 - 0.5) * spec.spacing;
            const double y = (i / 2 - 0.5 * (rows - 1)) * spec.spacing;
            const double dx = random.uniform(-spec.jitter, spec.jitter);
            const double dy = random.uniform(-spec.jitter, spec.jitter);
            layout.feet.emplace_back(spec.centre + Vector3(x + dx, y + dy, 0));
        }
    }
    for (const Vector3& foot : layout.feet)
        layout.ground.posts.push_back({foot - Vector3(0, 0, buried),
                                       foot + Vector3(0, 0, spec.peg_height - spec.peg_radius),
                                       spec.peg_radius});
    for (int i = 0; i < spec.count; ++i) {
        BodyState body;
        body.position = layout.feet[static_cast<std::size_t>(i)] + Vector3(0, 0, spec.tube_radius - overlap);
        const double half = 0.5 * random.uniform(0, 2 * pi);
        body.rotation = Quaternion(math::cos(half), 0, 0, math::sin(half));
        layout.bodies.push_back(body);
    }
    return layout;
}

TriangleMesh tray_mesh(const ObjectsSpec& spec, const std::vector<Vector3>& feet) {
    constexpr int columns = 12, rows = 8;
    constexpr double beyond = 1.6;
    TriangleMesh mesh;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column)
            mesh.vertices.emplace_back(spec.centre +
                                       Vector3(beyond * spec.half_length * (2.0 * column / columns - 1),
                                               beyond * spec.half_width * (2.0 * row / rows - 1), 0));
    }
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::int32_t a = row * (columns + 1) + column, b = a + 1, c = a + columns + 1, d = c + 1;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    }
    for (const Vector3& foot : feet) add_peg(mesh, spec, foot);
    return mesh;
}

bool goes_through(const BodyShape& ring, const BodyState& body, const Vector3& foot, double peg_height) {
    const Vector3 normal = body.rotation * Vector3::UnitZ();
    if (std::abs(normal.z()) < least_upright) return false;
    const double up = normal.dot(body.position - foot) / normal.z();
    if (up < 0 || up > peg_height) return false;
    const Vector3 in_ring = body.rotation.conjugate() * (foot + Vector3(0, 0, up) - body.position);
    const std::size_t count = ring.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        const Vector3& from = ring.corners[k];
        const Vector3 along = ring.corners[(k + 1) % count] - from, to = in_ring - from;
        if (along.x() * to.y() - along.y() * to.x() <= 0) return false;
    }
    return true;
}

}  // namespace fulcrum
