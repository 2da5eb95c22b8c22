// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/bowel_cut_drawing.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::ui {
namespace {

std::size_t at(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

Vector3 three(const float* values, std::int32_t vertex) {
    const float* v = values + 3 * at(vertex);
    return {v[0], v[1], v[2]};
}

std::size_t corner_at(const Triangle& triangle, std::int32_t vertex) {
    return vertex == triangle[1] ? 1 : vertex == triangle[2] ? 2 : 0;
}

}  // namespace

BowelCutDrawing::BowelCutDrawing(const BowelSkin& skin, bool domes)
    : skin_(skin), surface_(make_bowel_surface(skin.rest(), domes)) {}

BowelCutDrawing::Corner BowelCutDrawing::corner_of_root(const SceneFrame& frame, std::int32_t root,
                                                        std::size_t corner) const {
    const std::int32_t vertex = skin_.rest().triangles[at(root)][corner];
    const std::size_t split = 2 * surface_.indices[3 * at(root) + corner];
    return {three(frame.bowel_positions, vertex), three(frame.bowel_normals, vertex),
            Vector3(surface_.coordinates[split], surface_.coordinates[split + 1], 0)};
}

BowelCutDrawing::Corner BowelCutDrawing::corner_of(const BowelCutView& view, const SceneFrame& frame,
                                                   std::int32_t vertex, std::int32_t root) const {
    if (vertex < view.first_vertex) {
        return corner_of_root(frame, root, corner_at(skin_.rest().triangles[at(root)], vertex));
    }
    const std::size_t made = at(vertex - view.first_vertex);
    const std::int32_t own = view.vertex_roots[made];
    Corner sum{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
    for (std::size_t c = 0; c < 3; ++c) {
        const Corner one = corner_of_root(frame, own, c);
        const double share = view.barycentric[made][static_cast<int>(c)];
        sum.position += share * one.position;
        sum.normal += share * one.normal;
        sum.coordinates += share * one.coordinates;
    }
    sum.normal.normalize();
    // On an edge it may be the neighbour's, on the other side of the texture's seam.
    const double u = corner_of_root(frame, root, 0).coordinates.x();
    sum.coordinates.x() += std::round(u - sum.coordinates.x());
    return sum;
}

std::int32_t BowelCutDrawing::add_vertex(const Corner& corner, std::int32_t place) {
    positions_.push_back(corner.position);
    normals_.push_back(corner.normal);
    coordinates_.push_back(corner.coordinates);
    places_.push_back(place);
    return static_cast<std::int32_t>(places_.size()) - 1;
}

// The edges at which whole triangles adjoin.
void BowelCutDrawing::add_neighbours(const SceneFrame& frame, std::int32_t root) {
    const Triangle& corners = skin_.rest().triangles[at(root)];
    for (std::size_t c = 0; c < 3; ++c) {
        const std::int32_t other = skin_.adjacency().triangle_neighbours[3 * at(root) + c];
        if (other < 0 || frame.bowel_hidden[other] != 0) continue;
        // It has the edge the other way round.
        const Triangle& its = skin_.rest().triangles[at(other)];
        const std::int32_t from = corners[(c + 1) % 3], to = corners[c];
        const auto drawn = [&](std::int32_t vertex) {
            return add_vertex(corner_of_root(frame, other, corner_at(its, vertex)), vertex);
        };
        const std::int32_t first = drawn(from);
        beside_.push_back({first, drawn(to)});
    }
}

void BowelCutDrawing::add(const BowelCutView& view, SceneFrame& frame) {
    const auto roots = static_cast<std::int32_t>(skin_.rest().triangles.size());
    if (static_cast<std::int32_t>(view.hidden.size()) != roots ||
        std::find(view.hidden.begin(), view.hidden.end(), 1) == view.hidden.end())
        return;
    frame.bowel_hidden = view.hidden.data();
    frame.bowel_thickness = view.thickness;
    positions_.clear();
    normals_.clear();
    coordinates_.clear();
    places_.clear();
    triangles_.clear();
    beside_.clear();
    for (std::int32_t t = 0; t < view.triangle_count; ++t) {
        Triangle drawn;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::int32_t vertex = view.triangles[at(t)][c];
            Corner corner = corner_of(view, frame, vertex, view.triangle_roots[at(t)]);
            if (const std::uint8_t loose = view.triangle_loose[at(t)]; loose != 0)
                corner.position += view.fallen[loose - 1U];
            drawn[c] = add_vertex(corner, vertex);
        }
        triangles_.push_back(drawn);
    }
    for (std::int32_t r = 0; r < roots; ++r) {
        if (view.hidden[at(r)] != 0) add_neighbours(frame, r);
    }
    DrawnSheet sheet;
    sheet.surface = {positions_.data(), coordinates_.data(), positions_.size(),
                     triangles_.data(), triangles_.size(),   view.thickness};
    sheet.surface.normals = normals_.data();
    sheet.surface.places = places_.data();
    sheet.surface.beside = beside_.data();
    sheet.surface.beside_count = beside_.size();
    sheet.surface.wall = true;
    sheet.wear = SheetWear::bowel;
    frame.sheets.push_back(sheet);
}

}  // namespace fulcrum::ui
