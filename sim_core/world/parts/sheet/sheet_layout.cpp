// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/sheet/sheet_layout.h"

#include <cmath>
#include <limits>

#include "sim_core/anatomy/scene_anatomy.h"

namespace fulcrum {
namespace {

// One rectangle of quads, cut by alternate diagonals.
void add_triangles(SheetLayout& layout, std::int32_t first) {
    for (std::int32_t r = 0; r + 1 < layout.rows; ++r) {
        for (std::int32_t c = 0; c + 1 < layout.columns; ++c) {
            const std::int32_t a = first + r * layout.columns + c, b = a + 1, d = a + layout.columns,
                               e = d + 1;
            if ((r + c) % 2 == 0) {
                layout.mesh.triangles.push_back({a, b, e});
                layout.mesh.triangles.push_back({a, e, d});
            } else {
                layout.mesh.triangles.push_back({a, b, d});
                layout.mesh.triangles.push_back({b, e, d});
            }
        }
    }
}

}  // namespace

SheetLayout lay_out_sheet(const SheetSpec& spec) {
    SheetLayout layout;
    layout.columns = static_cast<std::int32_t>(std::lround(spec.length / spec.spacing)) + 1;
    layout.rows = static_cast<std::int32_t>(std::lround(spec.width / spec.spacing)) + 1;
    for (std::int32_t r = 0; r < layout.rows; ++r) {
        for (std::int32_t c = 0; c < layout.columns; ++c) {
            const double x = (static_cast<double>(c) / (layout.columns - 1) - 0.5) * spec.length;
            const double y = (static_cast<double>(r) / (layout.rows - 1) - 0.5) * spec.width;
            layout.mesh.vertices.push_back(spec.centre + x * spec.along + y * spec.across);
        }
    }
    add_triangles(layout, 0);
    for (std::int32_t c = 0; c < layout.columns; ++c) {
        const std::int32_t flap = (layout.rows - 1) * layout.columns + c;
        layout.attachments.push_back({c, std::numeric_limits<double>::infinity()});
        layout.attachments.push_back({flap, spec.flap_stiffness / layout.columns});
        layout.held.push_back(c);
        layout.held.push_back(flap);
    }
    return layout;
}

SheetLayout lay_out_septa(const SeptaSpec& spec, const SacralCurve& curve) {
    SheetLayout layout;
    layout.pieces = spec.count;
    layout.columns = static_cast<std::int32_t>(std::lround(spec.width / spec.node_spacing)) + 1;
    layout.rows = spec.areolar_rows + spec.fat_rows + 1;
    layout.envelope_row = spec.areolar_rows;
    const double plane_radius = curve.fascia_radius() - spec.plane_height;
    const auto height = [&](std::int32_t row) {
        if (row <= spec.areolar_rows) return spec.areolar_height * row / spec.areolar_rows;
        return spec.areolar_height +
               (spec.fat_height - spec.areolar_height) * (row - spec.areolar_rows) / spec.fat_rows;
    };
    for (std::int32_t k = 0; k < spec.count; ++k) {
        const auto first = static_cast<std::int32_t>(layout.mesh.vertices.size());
        const double s = septum_arc_length(spec, curve, k);
        layout.arc_lengths.push_back(s);
        for (std::int32_t r = 0; r < layout.rows; ++r) {
            for (std::int32_t c = 0; c < layout.columns; ++c) {
                const double share = static_cast<double>(c) / (layout.columns - 1);
                layout.mesh.vertices.push_back(
                    curve.point(s, (share - 0.5) * spec.width / plane_radius, height(r)));
                layout.rest.emplace_back((k + share) * spec.width, height(r) - spec.plane_height, 0);
            }
        }
        const std::size_t before = layout.mesh.triangles.size();
        add_triangles(layout, first);
        for (std::size_t t = before; t < layout.mesh.triangles.size(); ++t) {
            const std::int32_t row = (layout.mesh.triangles[t][0] - first) / layout.columns;
            layout.zones.push_back(row < spec.areolar_rows ? 1.0 : spec.fat_stiffness);
        }
        for (std::int32_t c = 0; c < layout.columns; ++c) {
            const std::int32_t wall = first + (layout.rows - 1) * layout.columns + c;
            for (const std::int32_t v : {first + c, wall}) {
                layout.attachments.push_back({v, std::numeric_limits<double>::infinity()});
                layout.held.push_back(v);
            }
            layout.driven.push_back(wall);
        }
    }
    return layout;
}

SheetSpec common_spec(const SeptaSpec& spec) {
    SheetSpec sheet;
    sheet.tissue = spec.tissue;
    sheet.spacing = spec.node_spacing;
    sheet.thickness = spec.thickness;
    sheet.structural_stiffness = spec.structural_stiffness;
    sheet.shear_stiffness = spec.shear_stiffness;
    sheet.bend_stiffness = spec.bend_stiffness;
    sheet.surface_density = spec.surface_density;
    sheet.pre_strain = spec.pre_strain;
    sheet.stiffness_damping = spec.stiffness_damping;
    sheet.mass_damping = spec.mass_damping;
    sheet.weight = spec.weight;
    sheet.blade_width = spec.blade_width;
    sheet.fibres = spec.fibres;
    return sheet;
}

}  // namespace fulcrum
