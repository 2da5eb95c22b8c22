// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/dent.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double vanished = 1e-9;  // m: a dent without load below this depth is removed

DentVertex* find_or_add(DentState& state, std::int32_t vertex) {
    DentVertex* const begin = state.entries.data();
    DentVertex* const end = begin + state.count;
    DentVertex* const place =
        std::lower_bound(begin, end, vertex,
                         [](const DentVertex& entry, std::int32_t wanted) { return entry.vertex < wanted; });
    if (place != end && place->vertex == vertex) return place;
    if (state.count == dent_capacity) {
        state.overflow = true;
        return nullptr;
    }
    std::move_backward(place, end, end + 1);
    ++state.count;
    place->vertex = vertex;
    place->displacement.setZero();
    return place;
}

std::int32_t surface_vertex(const std::int32_t* vertex_of, std::int32_t vertex) {
    return vertex_of != nullptr ? vertex_of[vertex] : vertex;
}

double compliance(const WinklerBed& bed, const double* vertex_areas, std::int32_t vertex) {
    return 1.0 / (bed.stiffness_per_area * vertex_areas[vertex]);
}

}  // namespace

WinklerBed winkler_bed(double young, double poisson, double wall_thickness, double backing,
                       double time_constant) {
    assert(young > 0.0 && poisson >= 0.0 && poisson < 0.5 && wall_thickness > 0.0 && backing > 0.0);
    // A contact that is wide compared with the thickness does not let the wall bulge sideways: constrained
    // modulus.
    const double constrained = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    const double wall = constrained / wall_thickness;
    WinklerBed bed;
    bed.stiffness_per_area = 1.0 / (1.0 / wall + 1.0 / backing);
    bed.time_constant = time_constant;
    return bed;
}

void step_dents(const WinklerBed& bed, const double* vertex_areas, const SurfaceLoad* loads, int load_count,
                double dt, DentState& state) {
    const double keep = math::exp(-dt / bed.time_constant);
    state.overflow = false;
    for (std::int32_t i = 0; i < state.count; ++i)
        state.entries[static_cast<std::size_t>(i)].displacement *= keep;
    for (int l = 0; l < load_count; ++l) {
        const SurfaceLoad& load = loads[l];
        if (load.filtered == nullptr) continue;
        const double own = contact_stiffness(bed, vertex_areas, *load.filtered, load.vertex_of);
        const Vector3 force = load.stiffness > 0.0 ? Vector3(own / load.stiffness * load.force) : load.force;
        for (std::int32_t i = 0; i < load.filtered->count; ++i) {
            const auto n = static_cast<std::size_t>(i);
            const std::int32_t vertex = surface_vertex(load.vertex_of, load.filtered->vertex[n]);
            const Vector3 linear = compliance(bed, vertex_areas, vertex) * load.filtered->weight[n] * force;
            const Vector3 target =
                linear / std::sqrt(1.0 + linear.squaredNorm() / (bed.most_depth * bed.most_depth));
            if (target.squaredNorm() <= vanished * vanished) continue;
            DentVertex* const entry = find_or_add(state, vertex);
            if (entry != nullptr) entry->displacement += (1.0 - keep) * target;
        }
    }
    const auto end = state.entries.begin() + state.count;
    const auto last = std::remove_if(state.entries.begin(), end, [](const DentVertex& entry) {
        return entry.displacement.squaredNorm() <= vanished * vanished;
    });
    std::fill(last, end, DentVertex{});
    state.count = static_cast<std::int32_t>(last - state.entries.begin());
}

double contact_stiffness(const WinklerBed& bed, const double* vertex_areas, const FilteredForce& filtered,
                         const std::int32_t* vertex_of) {
    double sum = 0.0;
    for (std::int32_t i = 0; i < filtered.count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double w = filtered.weight[n];
        sum += w * w * compliance(bed, vertex_areas, surface_vertex(vertex_of, filtered.vertex[n]));
    }
    return 1.0 / sum;
}

Vector3 dent_at(const DentState& state, std::int32_t vertex) {
    const DentVertex* const begin = state.entries.data();
    const DentVertex* const end = begin + state.count;
    const DentVertex* const place =
        std::lower_bound(begin, end, vertex,
                         [](const DentVertex& entry, std::int32_t wanted) { return entry.vertex < wanted; });
    return place != end && place->vertex == vertex ? place->displacement : Vector3(Vector3::Zero());
}

}  // namespace fulcrum
