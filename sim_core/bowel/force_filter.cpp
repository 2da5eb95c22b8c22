// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/force_filter.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double blend_band =
    0.1;  // fraction of a threshold, on each side, over which two grades are blended
constexpr double second_threshold = 4;  // Eq. 3: grade 2 above four local triangles

// Two rings around the contact vertex: the vertex, its first ring, its second ring; each ascending.
struct Neighbourhood {
    std::int32_t count = 0;
    std::int32_t ring_end[3] = {0, 0, 0};
    bool overflow = false;
};

bool holds(const FilteredForce& result, std::int32_t count, std::int32_t vertex) {
    for (std::int32_t i = 0; i < count; ++i) {
        if (result.vertex[static_cast<std::size_t>(i)] == vertex) return true;
    }
    return false;
}

Neighbourhood gather(const SurfaceView& surface, std::int32_t vertex, int rings, FilteredForce& result) {
    Neighbourhood found;
    result.vertex[0] = vertex;
    found.count = 1;
    found.ring_end[0] = found.ring_end[1] = found.ring_end[2] = 1;
    std::int32_t begin = 0;
    for (int ring = 1; ring <= rings; ++ring) {
        const std::int32_t end = found.count;
        for (std::int32_t i = begin; i < end; ++i) {
            for (const auto neighbour : surface.neighbours_of(result.vertex[static_cast<std::size_t>(i)])) {
                if (holds(result, found.count, neighbour)) continue;
                if (found.count == filter_capacity) {
                    found.overflow = true;
                    break;
                }
                result.vertex[static_cast<std::size_t>(found.count++)] = neighbour;
            }
        }
        std::sort(result.vertex.begin() + end, result.vertex.begin() + found.count);
        begin = end;
        for (int r = ring; r < 3; ++r) found.ring_end[r] = found.count;
    }
    return found;
}

// Adds factor times the normalised weights of one grade (Eqs. 1-2).
void add_grade(const SurfaceView& surface, const Neighbourhood& around, int grade, double sigma,
               double factor, FilteredForce& result) {
    const std::int32_t count = around.ring_end[grade];
    std::array<double, filter_capacity> value;
    value[0] = 1.0;
    double sum = 1.0;
    const Vector3 centre = surface.positions[result.vertex[0]];
    for (std::int32_t i = 1; i < count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double distance_squared = (surface.positions[result.vertex[n]] - centre).squaredNorm();
        // sigma 0 (all edges of zero length) gives coincident vertices equal weights.
        const double exponent = sigma > 0.0 ? distance_squared / (2.0 * sigma * sigma) : 0.0;
        value[n] = math::exp(-exponent);
        sum += value[n];
    }
    for (std::int32_t i = 0; i < count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        result.weight[n] += factor * value[n] / sum;
    }
}

double smooth_step(double u) {
    return u * u * u * (6.0 * u * u - 15.0 * u + 10.0);
}

// Weight of the upper grade around a threshold: 0 below its band, 1 above.
double upper_share(double area, double threshold) {
    const double half = blend_band * threshold;
    if (half <= 0.0) return area > threshold ? 1.0 : 0.0;
    return smooth_step(std::clamp((area - threshold + half) / (2.0 * half), 0.0, 1.0));
}

}  // namespace

FilterMode filter_mode(FilterLevel level) {
    switch (level) {
        case FilterLevel::off:
        case FilterLevel::grade_0:
            return FilterMode::grade_0;
        case FilterLevel::grade_1:
            return FilterMode::grade_1;
        case FilterLevel::grade_2:
            return FilterMode::grade_2;
        case FilterLevel::adaptive:
            return FilterMode::adaptive;
    }
    return FilterMode::grade_0;
}

double contact_area(const TipBox& tip, const Vector3& normal) {
    const double a = tip.edges[0], b = tip.edges[1], c = tip.edges[2];
    return 0.5 * b * c * std::abs(tip.axes.col(0).dot(normal)) +
           0.25 * a * c * std::abs(tip.axes.col(1).dot(normal)) +
           0.25 * a * b * std::abs(tip.axes.col(2).dot(normal));
}

int filter_grade(double area, double local_triangle_area) {
    if (area < local_triangle_area) return 0;
    return area <= second_threshold * local_triangle_area ? 1 : 2;
}

void filter_force(const SurfaceView& surface, std::int32_t vertex, double area, const FilterOptions& options,
                  FilteredForce& result) {
    const double local_area = mean_triangle_area(surface, vertex);
    result.contact_area = area;
    result.local_triangle_area = local_area;
    result.weight.fill(0.0);

    double share_1 = 0.0, share_2 = 0.0;  // of grades 1 and 2; the remainder is that of grade 0
    if (options.mode == FilterMode::adaptive) {
        result.grade = filter_grade(area, local_area);
        const double above_first = upper_share(area, local_area);
        share_2 = upper_share(area, second_threshold * local_area);
        share_1 = above_first - share_2;
    } else {
        result.grade = static_cast<std::int32_t>(options.mode);
        share_1 = options.mode == FilterMode::grade_1 ? 1.0 : 0.0;
        share_2 = options.mode == FilterMode::grade_2 ? 1.0 : 0.0;
    }
    const int rings = share_2 > 0.0 ? 2 : (share_1 > 0.0 ? 1 : 0);
    const Neighbourhood around = gather(surface, vertex, rings, result);
    result.count = around.count;
    result.overflow = around.overflow;

    const double edge = rings > 0 ? mean_edge_length(surface, vertex) : 0.0;
    const auto sigma_of = [&](int grade) { return options.sigma > 0.0 ? options.sigma : grade * edge; };
    result.sigma = result.grade == 0 ? 0.0 : (rings > 0 ? sigma_of(result.grade) : 0.0);
    const double share_0 = 1.0 - share_1 - share_2;
    if (share_0 > 0.0) result.weight[0] += share_0;
    if (share_1 > 0.0) add_grade(surface, around, 1, sigma_of(1), share_1, result);
    if (share_2 > 0.0) add_grade(surface, around, 2, sigma_of(2), share_2, result);
}

void filter_force(const SurfaceView& surface, std::int32_t vertex, const TipBox& tip,
                  const FilterOptions& options, FilteredForce& result) {
    filter_force(surface, vertex, contact_area(tip, vertex_normal(surface, vertex)), options, result);
}

}  // namespace fulcrum
