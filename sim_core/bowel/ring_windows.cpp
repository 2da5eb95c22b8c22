// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/ring_windows.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim_core/bowel/cage.h"

namespace fulcrum {

RingWindows::RingWindows(std::vector<Vector3> vertices, int vertices_per_ring, int neighbours)
    : rings_(static_cast<int>(vertices.size()) / vertices_per_ring),
      per_ring_(vertices_per_ring),
      neighbours_(neighbours),
      vertices_(std::move(vertices)),
      window_(cage_triangles(std::min(rings_, 2 * neighbours_ + 1), per_ring_)),
      global_(cage_triangles(rings_, per_ring_)) {
    assert(rings_ >= 2 && per_ring_ >= 3 && neighbours_ >= 1);
    for (int r = 0; r < rings_; ++r) {
        Vector3 centre = Vector3::Zero(), area = Vector3::Zero();
        for (int k = 0; k < per_ring_; ++k) centre += vertices_[static_cast<std::size_t>(r * per_ring_ + k)];
        centre /= per_ring_;
        for (int k = 0; k < per_ring_; ++k) {
            const Vector3& here = vertices_[static_cast<std::size_t>(r * per_ring_ + k)];
            const Vector3& next = vertices_[static_cast<std::size_t>(r * per_ring_ + (k + 1) % per_ring_)];
            area += (here - centre).cross(next - centre);
        }
        centres_.push_back(centre);
        normals_.push_back(area.normalized());
    }
}

double RingWindows::fraction(int gap, const Vector3& point) const {
    const auto j = static_cast<std::size_t>(gap);
    const double before = (point - centres_[j]).dot(normals_[j]);
    const double after = (centres_[j + 1] - point).dot(normals_[j + 1]);
    const double sum = before + after;
    return sum > 0.0 ? before / sum : 0.5;
}

int RingWindows::gap_of(const Vector3& point) const {
    int best = -1;
    double best_distance = 0.0;
    for (int j = 0; j + 1 < rings_; ++j) {
        const auto i = static_cast<std::size_t>(j);
        const bool after_first = j == 0 || (point - centres_[i]).dot(normals_[i]) >= 0.0;
        const bool before_second = j + 2 == rings_ || (point - centres_[i + 1]).dot(normals_[i + 1]) < 0.0;
        if (!after_first || !before_second) continue;
        // The ring planes of a bent tube cross outside it: of several gaps the nearest is chosen.
        const double distance = (point - 0.5 * (centres_[i] + centres_[i + 1])).squaredNorm();
        if (best < 0 || distance < best_distance) {
            best = j;
            best_distance = distance;
        }
    }
    return std::max(best, 0);
}

void RingWindows::window_weights(int first, int count, const Vector3& point) {
    const int per_ring = per_ring_;
    const auto begin = vertices_.begin() + first * per_ring;
    cage_.assign(begin, begin + count * per_ring);
    cage_.push_back(centres_[static_cast<std::size_t>(first)]);
    cage_.push_back(centres_[static_cast<std::size_t>(first + count - 1)]);
    cage_weights_.resize(cage_.size());
    mean_value_weights(cage_, count == rings_ ? global_ : window_, point, scratch_, cage_weights_.data());
    // Distribute the weights of the cap centres, which are means, to their rings.
    const auto ring_vertices = static_cast<std::size_t>(count * per_ring);
    for (int k = 0; k < per_ring; ++k) {
        cage_weights_[static_cast<std::size_t>(k)] += cage_weights_[ring_vertices] / per_ring;
        cage_weights_[static_cast<std::size_t>((count - 1) * per_ring + k)] +=
            cage_weights_[ring_vertices + 1] / per_ring;
    }
}

void RingWindows::weights(int gap, const Vector3& point, WindowWeights& result) {
    assert(gap >= 0 && gap + 1 < rings_);
    const int count = std::min(rings_, 2 * neighbours_ + 1);
    const int first = std::clamp(gap - neighbours_, 0, rings_ - count);
    const int second = std::clamp(gap + 1 - neighbours_, 0, rings_ - count);
    const double u = fraction(gap, point);
    const double blend = u * u * u * (6.0 * u * u - 15.0 * u + 10.0);
    result.first = first;
    result.rings = second - first + count;
    result.weight.assign(static_cast<std::size_t>(result.rings * per_ring_), 0.0);
    const auto add = [&](int window, double factor) {
        window_weights(window, count, point);
        const auto shift = static_cast<std::size_t>((window - first) * per_ring_);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count * per_ring_); ++i) {
            result.weight[shift + i] += factor * cage_weights_[i];
        }
    };
    if (first == second) {
        add(first, 1.0);
    } else {
        if (blend != 1.0) add(first, 1.0 - blend);
        if (blend != 0.0) add(second, blend);
    }
}

void RingWindows::global_weights(const Vector3& point, WindowWeights& result) {
    window_weights(0, rings_, point);
    result.first = 0;
    result.rings = rings_;
    result.weight.assign(cage_weights_.begin(), cage_weights_.begin() + rings_ * per_ring_);
}

}  // namespace fulcrum
