// SPDX-License-Identifier: Apache-2.0
// Bounding volume tree with eight boxes per node, in single precision, rounded outward, over a list of boxes
// that is already well ordered (the leaf order of FCL's tree). It groups eight neighbours per node and level,
// so its depth is logarithmic in the number of boxes for any input. Constant after construction: any thread
// may read.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>
#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "sim_core/collision/triangle_packet.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

struct Box {
    Vector3 low = Vector3::Constant(1e30), high = Vector3::Constant(-1e30);  ///< m; empty at first

    void add(const Vector3& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
};

class BoxTree {
  public:
    static constexpr int width = 8;

    BoxTree() = default;
    explicit BoxTree(std::vector<Box> boxes) {
        while (true) {
            const std::size_t count = boxes.size();
            std::vector<Box> above((count + width - 1) / width);
            const auto first = static_cast<std::int32_t>(nodes_.size());
            nodes_.resize(nodes_.size() + above.size());
            for (std::size_t i = 0; i < above.size() * width; ++i) {
                Node& node = nodes_[static_cast<std::size_t>(first) + i / width];
                const Box box = i < count ? boxes[i] : Box{};
                for (int axis = 0; axis < 3; ++axis) {
                    const double size = std::max(std::abs(box.low[axis]), std::abs(box.high[axis]));
                    const double slack = size < 1e29 ? 1e-7 + 2e-7 * size : 0.0;
                    node.low[axis][i % width] = static_cast<float>(box.low[axis] - slack);
                    node.high[axis][i % width] = static_cast<float>(box.high[axis] + slack);
                }
                // The nodes of the level below were created consecutively, so their index can be computed.
                node.below = levels_ == 0 ? ~(static_cast<std::int32_t>(i / width) * width)
                                          : below_ + static_cast<std::int32_t>(i / width) * width;
                above[i / width].add(box.low);
                above[i / width].add(box.high);
            }
            below_ = first;
            ++levels_;
            if (above.size() == 1) break;
            boxes = std::move(above);
        }
    }

    std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

    /// Rounding error of a distance computed at a point, m.
    static double slack_at(const Vector3& point) { return 1e-6 * (1.0 + point.cwiseAbs().maxCoeff()); }

    /// Calls visit(box) for every box within `reach` m of the point, in list order, and possibly for some
    /// that are further away by no more than rounding. The point must be finite.
    template <class Visit>
    void within(const Vector3& point, double reach, Visit&& visit) const {
        const FloatPoint at(point);
        const auto far = static_cast<float>((reach + slack_at(point)) * (1 + 1e-5));
        std::int32_t stack[stack_capacity];
        int waiting = 0;
        stack[waiting++] = static_cast<std::int32_t>(nodes_.size()) - 1;
        float distance2[width];
        while (waiting > 0) {
            const Node& node = nodes_[static_cast<std::size_t>(stack[--waiting])];
            unsigned near = node.distances(at, far * far, distance2);
            if (node.below < 0) {
                for_each_lane(near, [&](int lane) { visit(~node.below + lane); });
                continue;
            }
            for (; near != 0;) {
                const int lane = 31 - __builtin_clz(near);
                near ^= 1U << static_cast<unsigned>(lane);
                stack[waiting++] = node.below + lane;
            }
        }
    }

    /// Branch and bound: calls visit(box), which returns the best distance found so far (m), nearest boxes
    /// first as far as the tree allows; boxes further away than that are skipped.
    template <class Visit>
    void nearest(const Vector3& point, double reach, Visit&& visit) const {
        struct Waiting {
            std::int32_t node;
            float distance2;
        };
        const FloatPoint at(point);
        const double slack = slack_at(point);
        const auto limit2 = [&](double best) {
            const double far = std::min((best + slack) * (1 + 1e-5), 1e18);
            return static_cast<float>(far * far * (1 + 1e-6));
        };
        float far2 = limit2(reach);
        Waiting stack[stack_capacity];
        int waiting = 0;
        stack[waiting++] = {static_cast<std::int32_t>(nodes_.size()) - 1, 0.0F};
        float distance2[width];
        while (waiting > 0) {
            const Waiting top = stack[--waiting];
            if (top.distance2 > far2) continue;
            if (top.node < 0) {
                far2 = limit2(visit(~top.node));
                continue;
            }
            const Node& node = nodes_[static_cast<std::size_t>(top.node)];
            const int first = waiting;
            for_each_lane(node.distances(at, far2, distance2), [&](int lane) {
                const std::int32_t name = node.below < 0 ? ~(~node.below + lane) : node.below + lane;
                stack[waiting++] = {name, distance2[lane]};
                for (int k = waiting - 1; k > first && stack[k].distance2 > stack[k - 1].distance2; --k)
                    std::swap(stack[k], stack[k - 1]);
            });
        }
    }

  private:
    static constexpr int stack_capacity =
        128;  // at most seven pending per level; memory cannot hold 16 levels
    struct alignas(32) Node {
        float low[3][width], high[3][width];
        std::int32_t below;  ///< first of its children; ~first box at the lowest level

        unsigned distances(const FloatPoint& at, float far2, float (&distance2)[width]) const {
#if defined(__AVX__)
            const float* coordinate = &at.x;
            __m256 sum = _mm256_setzero_ps();
            for (int axis = 0; axis < 3; ++axis) {
                const __m256 p = _mm256_set1_ps(coordinate[axis]);
                const __m256 outside =
                    _mm256_max_ps(_mm256_max_ps(_mm256_sub_ps(_mm256_load_ps(low[axis]), p),
                                                _mm256_sub_ps(p, _mm256_load_ps(high[axis]))),
                                  _mm256_setzero_ps());
                sum = _mm256_add_ps(sum, _mm256_mul_ps(outside, outside));
            }
            _mm256_storeu_ps(distance2, sum);
            return static_cast<unsigned>(
                _mm256_movemask_ps(_mm256_cmp_ps(sum, _mm256_set1_ps(far2), _CMP_LE_OQ)));
#else
            const float p[3] = {at.x, at.y, at.z};
            unsigned near = 0;
            for (int lane = 0; lane < width; ++lane) {
                distance2[lane] = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    const float outside =
                        std::max(std::max(low[axis][lane] - p[axis], p[axis] - high[axis][lane]), 0.0F);
                    distance2[lane] += outside * outside;
                }
                if (distance2[lane] <= far2) near |= 1U << static_cast<unsigned>(lane);
            }
            return near;
#endif
        }
    };
    std::vector<Node> nodes_;  ///< lowest level first, root last
    std::int32_t below_ = 0, levels_ = 0;
};

}  // namespace fulcrum
