// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/cut_run.h"

#include <algorithm>
#include <cmath>

#include "sim_core/lab/membrane_reference.h"

namespace fulcrum::lab {
namespace {

int cells_of(int triangles) {
    return std::max(8, static_cast<int>(std::lround(std::sqrt(0.5 * triangles))));
}

TriangleMesh sheet_of(int triangles) {
    const int cells = cells_of(triangles);
    return make_sheet(cells + 1, cells + 1, cells * CutRun::cell, cells * CutRun::cell);
}

}  // namespace

CutRun::CutRun(int triangles)
    : mesh(sheet_of(triangles), {0}, CutMesh::capacity_for(sheet_of(triangles), 1500)),
      positions(static_cast<std::size_t>(mesh.capacity().vertices), Vector3::Zero()),
      side_(cells_of(triangles) * cell),
      cells_(cells_of(triangles)) {
    std::copy(mesh.mesh().vertices.begin(), mesh.mesh().vertices.end(), positions.begin());
    step.width = width;
    step.depth = 2 * width;
    begin_row();
}

void CutRun::begin_row() {
    place_ = 0;
    mesh.begin_stroke();
    step.start = BladeEnd::square;
}

void CutRun::advance_blade() {
    // Waves of 3 mm over 40 mm: the direction turns from step to step and rows stay apart.
    const auto at = [this](int k) {
        const double x = 2 * cell + advance * k, phase = x / 0.04 - std::floor(x / 0.04);
        const double bend = phase < 0.5 ? phase * (0.5 - phase) : (phase - 0.5) * (phase - 1);
        return Vector3(x, 2 * cell + 0.009 * row_ + 0.048 * bend + 0.0011 * (row_ % 3), 0);
    };
    if (at(place_ + 1).x() > side_ - 2 * cell) {
        ++row_;
        begin_row();
        if (at(0).y() > side_ - 3 * cell || mesh.triangle_count() > mesh.capacity().triangles - 4000) {
            row_ = 0;
            mesh.reset();
        }
    }
    const auto box_of = [this](const Vector3& p) {
        const auto clamp = [this](double v) { return std::clamp(static_cast<int>(v / cell), 0, cells_ - 1); };
        return 2 * (clamp(p.y()) * cells_ + clamp(p.x()));
    };
    step.from = at(place_);
    step.to = at(place_ + 1);
    if (place_ > 0) step.start = BladeEnd::round;
    step.root = box_of(0.5 * (step.from + step.to));
    ++place_;
    ++steps;
}

}  // namespace fulcrum::lab
