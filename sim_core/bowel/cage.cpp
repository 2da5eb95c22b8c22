// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/cage.h"

namespace fulcrum {

RingFrame rest_frame(double s) {
    RingFrame frame;
    frame.position = Vector3(s, 0.0, 0.0);
    frame.rotation.col(0) = Vector3::UnitY();
    frame.rotation.col(1) = Vector3::UnitZ();
    frame.rotation.col(2) = Vector3::UnitX();
    return frame;
}

std::vector<Vector3> cage_vertices(const Cage& cage, const RingFrame* frames) {
    std::vector<Vector3> vertices;
    vertices.reserve(cage.templates.size() * ring_size + 2);
    for (std::size_t r = 0; r < cage.templates.size(); ++r) {
        for (const auto& x : cage.templates[r])
            vertices.push_back(frames[r].position + frames[r].rotation * x);
    }
    const auto mean = [&vertices](std::size_t first) {
        Vector3 sum = Vector3::Zero();
        for (std::size_t k = 0; k < ring_size; ++k) sum += vertices[first + k];
        return Vector3(sum / ring_size);
    };
    const std::size_t last = vertices.size() - ring_size;
    const Vector3 start = mean(0), end = mean(last);
    vertices.push_back(start);
    vertices.push_back(end);
    return vertices;
}

std::vector<Triangle> cage_triangles(int rings, int vertices_per_ring) {
    std::vector<Triangle> triangles;
    const int n = vertices_per_ring;
    const int start = rings * n, end = start + 1;
    for (int r = 0; r + 1 < rings; ++r) {
        for (int k = 0; k < n; ++k) {
            const int next = (k + 1) % n;
            const int a = r * n + k, b = r * n + next, c = (r + 1) * n + next, d = (r + 1) * n + k;
            // Alternating diagonals, so that the tube has no handedness.
            if ((r + k) % 2 == 0) {
                triangles.push_back({a, b, c});
                triangles.push_back({a, c, d});
            } else {
                triangles.push_back({a, b, d});
                triangles.push_back({b, c, d});
            }
        }
    }
    const int last = (rings - 1) * n;
    for (int k = 0; k < n; ++k) {
        const int next = (k + 1) % n;
        triangles.push_back({start, next, k});
        triangles.push_back({end, last + k, last + next});
    }
    return triangles;
}

}  // namespace fulcrum
