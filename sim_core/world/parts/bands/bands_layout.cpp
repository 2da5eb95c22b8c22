// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/bands/bands_layout.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/random.h"
#include "sim_core/strand/strand.h"

namespace fulcrum {
namespace {

constexpr double cell = 0.008;  // m
constexpr int nerve_points = 24;
constexpr double root_size = 0.003;    // m, edge of the tissue around a vessel's root
constexpr double root_offset = 0.004;  // m beyond the post

double bed_height(const BandsSpec& spec, double x, double y) {
    const double u = (x - spec.centre.x()) / spec.half_extent.x(),
                 v = (y - spec.centre.y()) / spec.half_extent.y();
    return spec.centre.z() + 0.5 * spec.half_extent.z() * (u * u + v * v);
}

}  // namespace

BandsLayout place_bands(const BandsSpec& spec, std::uint64_t seed) {
    BandsLayout layout;
    PoolModel& pool = layout.bed.pool;
    pool.cell = cell;
    pool.columns = std::max(2, static_cast<int>(std::ceil(2 * spec.half_extent.x() / cell)));
    pool.rows = std::max(2, static_cast<int>(std::ceil(2 * spec.half_extent.y() / cell)));
    layout.bed.corner = spec.centre - Vector3(0.5 * cell * pool.columns, 0.5 * cell * pool.rows, 0);
    for (int row = 0; row < pool.rows; ++row)
        for (int column = 0; column < pool.columns; ++column)
            pool.ground.push_back(bed_height(spec, layout.bed.corner.x() + (column + 0.5) * cell,
                                             layout.bed.corner.y() + (row + 0.5) * cell));

    Random random(seed, 0xBA2D5U);
    const int rows = (spec.count + 1) / 2;
    const double pitch = 2 * spec.half_extent.y() / rows;
    const double column_x = 0.5 * spec.half_extent.x();
    for (int i = 0; i < spec.count; ++i) {
        BandPlace band;
        const double side = i % 2 == 0 ? -1 : 1;
        const Vector3 middle = spec.centre + Vector3(side * column_x + spec.jitter * random.uniform(-1, 1),
                                                     -spec.half_extent.y() + (i / 2 + 0.5) * pitch +
                                                         spec.jitter * random.uniform(-1, 1),
                                                     spec.height);
        const double angle = spec.tilt * random.uniform(-1, 1);
        const Vector3 half(0.5 * spec.length * math::cos(angle), 0.5 * spec.length * math::sin(angle), 0);
        // The root lies on the outer side: vessels come from there.
        band.root = middle + side * half;
        band.end = middle - side * half;
        band.vessel_root = band.root + root_offset * side * half.normalized();
        band.vessel_root.z() = layout.bed.ground(band.vessel_root);
        layout.bands.push_back(band);
    }
    std::vector<std::int32_t> order;
    for (int i = 0; i < spec.count; ++i) order.push_back(i);
    for (int i = spec.count - 1; i > 0; --i)
        std::swap(order[static_cast<std::size_t>(i)], order[random.below(static_cast<std::uint32_t>(i + 1))]);
    for (int v = 0; v < spec.vessels; ++v) {
        layout.vessel_bands.push_back(order[static_cast<std::size_t>(v)]);
        layout.bands[static_cast<std::size_t>(order[static_cast<std::size_t>(v)])].vessel = v;
    }
    const double nerve_side = random.below(2) == 0 ? -1 : 1;
    const double nerve_x =
        spec.centre.x() + nerve_side * column_x + 0.25 * spec.length * random.uniform(-1, 1);
    const double phase = random.uniform(0, 6.283185307179586);
    for (int i = 0; i < nerve_points; ++i) {
        const double share = static_cast<double>(i) / (nerve_points - 1);
        layout.nerve.emplace_back(nerve_x + 0.002 * math::sin(phase + 7 * share),
                                  spec.centre.y() + spec.half_extent.y() * (2 * share - 1),
                                  spec.centre.z() + spec.height - spec.nerve_gap);
    }
    return layout;
}

TriangleMesh bed_mesh(const BandsSpec& spec) {
    constexpr int columns = 24, rows = 20;
    constexpr double margin = 1.3;  // the bed continues beyond what blood can reach
    TriangleMesh mesh;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const double x = spec.centre.x() + margin * spec.half_extent.x() * (2.0 * column / columns - 1);
            const double y = spec.centre.y() + margin * spec.half_extent.y() * (2.0 * row / rows - 1);
            mesh.vertices.emplace_back(x, y, bed_height(spec, x, y));
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::int32_t a = row * (columns + 1) + column, b = a + 1, c = a + columns + 1, d = c + 1;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    }
    return mesh;
}

FieldModel make_bands_field(const BandsSpec& spec, const BandsLayout& layout, BandPatches& patches) {
    FieldModel model;
    model.bed = layout.bed;
    VesselModel vessel;
    vessel.radius = spec.vessel_radius;
    vessel.pressure = spec.vessel_pressure;
    vessel.feeding_length = spec.feeding_length;
    vessel.clotting_time = spec.clotting_time;
    model.vessels.push_back(vessel);

    FieldHeat heat(spec, model.heat);
    const double segment = spec.length / strand_segments, section = spec.width * spec.thickness;
    for (std::size_t b = 0; b < layout.bands.size(); ++b) {
        for (int s = 0; s < strand_segments; ++s) {
            const std::int32_t here =
                heat.patch(section * segment, 2 * (spec.width + spec.thickness) * segment);
            if (s > 0) patches.segment_links.push_back(heat.link(here - 1, here, section, segment));
        }
    }
    patches.roots = model.heat.patches.size();
    for (std::size_t v = 0; v < layout.vessel_bands.size(); ++v)
        heat.patch(root_size * root_size * root_size, root_size * root_size);
    model.first_bed = heat.bed(layout.bed);
    for (std::size_t v = 0; v < layout.vessel_bands.size(); ++v) {
        const Vector3& root = layout.bands[static_cast<std::size_t>(layout.vessel_bands[v])].vessel_root;
        heat.link(static_cast<std::int32_t>(patches.roots + v),
                  static_cast<std::int32_t>(model.first_bed + layout.bed.cell(root)), root_size * root_size,
                  root_size);
    }
    model.nerves.push_back(
        {layout.nerve, heat.nerve(layout.nerve, layout.bed, model.first_bed, [&](const Vector3& point) {
             return point.z() - layout.bed.ground(point);
         })});
    return model;
}

}  // namespace fulcrum
