// SPDX-License-Identifier: Apache-2.0
#include "sim_core/collision/sphere_pairs.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/collision/triangle_packet.h"

namespace fulcrum {
namespace {

using Eight = Eigen::Array<float, SpherePairs::width, 1>;
using EightMap = Eigen::Map<const Eight>;

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

// Rounding error of a gap in single precision at a coordinate of the given size, m.
float slack_at(float coordinate) {
    return 1e-6F * (1.0F + std::abs(coordinate));
}

}  // namespace

SpherePairs::SpherePairs(const std::vector<double>& arc_lengths, const std::vector<double>& radii,
                         double rest_exclusion, double margin, double contact_margin, int row_capacity)
    : arc_lengths_(arc_lengths),
      radii_(radii),
      rest_exclusion_(rest_exclusion),
      margin_(margin),
      contact_margin_(contact_margin),
      row_capacity_(row_capacity) {
    radius_.assign(index(eights() * width), 0.0F);
    for (std::size_t i = 0; i < radii_.size(); ++i) {
        radius_[i] = static_cast<float>(radii_[i] * (1 + 1e-6));
        largest_radius_ = std::max(largest_radius_, radii_[i]);
    }
}

SpherePairs::Lists SpherePairs::make_lists() const {
    Lists lists;
    const float nowhere = std::numeric_limits<float>::quiet_NaN();
    for (auto* coordinate : {&lists.x, &lists.y, &lists.z}) coordinate->assign(radius_.size(), nowhere);
    for (int axis = 0; axis < 3; ++axis) {
        lists.low[axis].assign(index(eights()), 0.0F);
        lists.high[axis].assign(index(eights()), 0.0F);
    }
    lists.listed_at.assign(radii_.size(), Vector3::Zero());
    lists.rows.resize(index(row_capacity_));
    return lists;
}

std::size_t SpherePairs::bytes() const {
    return sizeof(*this) + radii_.size() * (2 * sizeof(double) + sizeof(Vector3)) +
           radius_.size() * 4 * sizeof(float) + index(eights()) * 6 * sizeof(float) +
           index(row_capacity_) * sizeof(Row);
}

bool SpherePairs::excluded(int a, int b) const {
    const double along = std::abs(arc_lengths_[index(a)] - arc_lengths_[index(b)]);
    return along < rest_exclusion_ * std::max(radii_[index(a)], radii_[index(b)]);
}

// Rows that could touch before both spheres have moved by the margin: groups of eight by their boxes, then
// each sphere of one group against the other group.
void SpherePairs::list(const Vector3* centres, Lists& lists) const {
    ++lists.listings;
    lists.count = 0;
    lists.overflow = false;
    const auto far = static_cast<float>(2 * margin_ + contact_margin_);
    for (int e = 0; e < eights(); ++e) {
        const std::vector<float>* coordinates[3] = {&lists.x, &lists.y, &lists.z};
        for (int axis = 0; axis < 3; ++axis) {
            float low = std::numeric_limits<float>::infinity(), high = -low;
            for (int k = 0; k < width; ++k) {
                const float value = (*coordinates[axis])[index(e * width + k)];
                if (value < low) low = value;
                if (value > high) high = value;
            }
            lists.low[axis][index(e)] = low;
            lists.high[axis][index(e)] = high;
        }
    }
    for (int i = 0; i < spheres(); ++i) {
        lists.listed_at[index(i)] = centres[i];
        const float x = lists.x[index(i)], y = lists.y[index(i)], z = lists.z[index(i)];
        const float slack = slack_at(x) + slack_at(y) + slack_at(z);
        const float box_reach =
            radius_[index(i)] + static_cast<float>(largest_radius_ * (1 + 1e-6)) + far + slack;
        const float p[3] = {x, y, z};
        for (int e = i / width; e < eights(); ++e) {
            // The last pair of this group that is far enough along the line decides whether the group is
            // tested.
            const int last = std::min((e + 1) * width, spheres()) - 1;
            if (last <= i) continue;
            bool near = true;
            for (int axis = 0; axis < 3 && near; ++axis) {
                near = lists.low[axis][index(e)] - p[axis] <= box_reach &&
                       p[axis] - lists.high[axis][index(e)] <= box_reach;
            }
            if (!near) continue;
            const std::size_t from = index(e * width);
            const Eight dx = EightMap(lists.x.data() + from) - x, dy = EightMap(lists.y.data() + from) - y,
                        dz = EightMap(lists.z.data() + from) - z;
            const Eight gap = (dx * dx + dy * dy + dz * dz).sqrt() - EightMap(radius_.data() + from) -
                              (radius_[index(i)] + static_cast<float>(contact_margin_) + slack);
            float gaps[width];
            Eigen::Map<Eight>{gaps} = gap;
            Row row;
            row.sphere = i;
            row.eight = e;
            row.gap = std::numeric_limits<float>::infinity();
            for_each_lane(lanes_below(gaps, far), [&](int lane) {
                const int other = e * width + lane;
                if (other <= i || excluded(i, other)) return;
                row.lanes |= 1U << static_cast<unsigned>(lane);
                row.gap = std::min(row.gap, gaps[lane]);
            });
            if (row.lanes == 0) continue;
            if (lists.count == row_capacity_) {
                lists.overflow = true;
                return;
            }
            lists.rows[index(lists.count++)] = row;
        }
    }
}

int SpherePairs::find(const Vector3* centres, Lists& lists, SphereContact* found, int capacity,
                      double& deepest) const {
    deepest = 0;
    double furthest2 = 0;  // largest squared motion since the listing
    for (int i = 0; i < spheres(); ++i) {
        const std::size_t k = index(i);
        lists.x[k] = static_cast<float>(centres[i].x());
        lists.y[k] = static_cast<float>(centres[i].y());
        lists.z[k] = static_cast<float>(centres[i].z());
        const double motion2 = (centres[i] - lists.listed_at[k]).squaredNorm();
        // A centre that is not finite contributes no motion; one that was not finite when listed may have
        // come from anywhere.
        if (motion2 > furthest2) furthest2 = motion2;
        if (!(motion2 >= 0) && centres[i].allFinite()) furthest2 = std::numeric_limits<double>::infinity();
    }
    double moved = std::sqrt(furthest2);
    if (lists.count < 0 || !(moved <= margin_)) {
        list(centres, lists);
        moved = 0;
    }
    const auto closed = static_cast<float>(2 * moved);
    int count = 0;
    for (int r = 0; r < lists.count; ++r) {
        const Row& row = lists.rows[index(r)];
        if (row.gap > closed) continue;
        ++lists.rows_seen;
        const std::size_t from = index(row.eight * width), i = index(row.sphere);
        const float x = lists.x[i], y = lists.y[i], z = lists.z[i];
        const Eight dx = EightMap(lists.x.data() + from) - x, dy = EightMap(lists.y.data() + from) - y,
                    dz = EightMap(lists.z.data() + from) - z;
        const Eight reach =
            EightMap(radius_.data() + from) +
            (radius_[i] + static_cast<float>(contact_margin_) + slack_at(x) + slack_at(y) + slack_at(z));
        float beyond[width];
        Eigen::Map<Eight>{beyond} = dx * dx + dy * dy + dz * dz - reach * reach;
        for_each_lane(lanes_below(beyond, 0.0F) & row.lanes, [&](int lane) {
            const int other = row.eight * width + lane;
            const Vector3 between = centres[row.sphere] - centres[other];
            const double together = radii_[i] + radii_[index(other)], near = together + contact_margin_;
            const double distance2 = between.squaredNorm();
            if (!(distance2 < near * near)) return;
            const double distance = std::sqrt(distance2);
            deepest = std::max(deepest, together - distance);
            if (count++ >= capacity) return;
            SphereContact& contact = found[count - 1];
            contact.first = row.sphere;
            contact.second = other;
            contact.gap = distance - together;
            contact.normal = distance > 1e-12 ? Vector3(between / distance) : Vector3(Vector3::UnitZ());
        });
    }
    return count;
}

}  // namespace fulcrum
