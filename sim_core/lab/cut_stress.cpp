// SPDX-License-Identifier: Apache-2.0
// Stress cases of docs/QUALITY.md for cuts: for any mesh and blade, every invariant holds after each step and
// whatever could not be cut is reported.
#include <algorithm>
#include <cmath>

#include "sim_core/lab/cut_strokes.h"
#include "sim_core/lab/membrane_reference.h"
#include "sim_core/lab/random_values.h"

namespace fulcrum::lab {
namespace {

constexpr double cell = 0.01;    // m
constexpr double extent = 0.08;  // m, of the largest sheet
constexpr int steps_of_a_mesh = 12;

enum Case : std::size_t {
    slivers,
    coincident,
    one_point,
    folded,
    one_sliver,
    one_triangle,
    plain,
    every_triangle,
    one_vertex,
    one_metre,
    case_count
};

TriangleMesh mesh_of(Case which, Random& random) {
    if (which == one_triangle) {
        TriangleMesh mesh;
        mesh.vertices = {Vector3(0, 0, 0), Vector3(0.08, 0, 0), Vector3(0.02, 0.07, 0)};
        mesh.triangles = {{0, 1, 2}};
        return mesh;
    }
    const auto columns = static_cast<int>(1 + random.below(8)), rows = static_cast<int>(1 + random.below(8));
    TriangleMesh mesh = make_sheet(columns + 1, rows + 1, cell * columns, cell * rows);
    const auto any = [&]() -> Vector3& {
        return mesh.vertices[random.below(static_cast<std::uint32_t>(mesh.vertices.size()))];
    };
    switch (which) {
        case slivers:
            for (Vector3& p : mesh.vertices) p.y() *= 1e-6;
            break;
        case coincident:
            for (int i = 0; i < 4; ++i) any() = mesh.vertices[0];
            break;
        case one_point:
            for (Vector3& p : mesh.vertices) p = Vector3(0.03, 0.03, 0);
            break;
        case folded:
            for (Vector3& p : mesh.vertices)
                p += cell * inside_unit_box(random).cwiseProduct(Vector3(1, 1, 0.2));
            break;
        case one_sliver:
            any() += Vector3((1 - 1e-6) * cell, 0, 0);
            break;
        default:
            break;
    }
    return mesh;
}

class Stress {
  public:
    Stress(Case which, std::uint64_t seed, StrokeTally& tally)
        : random_(seed, which + 1),
          which_(which),
          mesh_(mesh_of(which, random_), {0}, {8000, 24000, 6000, 6000}),
          positions_(static_cast<std::size_t>(mesh_.capacity().vertices), Vector3::Zero()),
          tally_(tally) {
        std::copy(mesh_.mesh().vertices.begin(), mesh_.mesh().vertices.end(), positions_.begin());
        for (const bool flat : mesh_.model().flat) tally_.flat += flat ? 1 : 0;
        ++tally_.strokes;
    }

    void run() {
        if (which_ == every_triangle) return hatch();
        for (int k = 0; k < steps_of_a_mesh; ++k) {
            BladeStep step = any_step();
            if (k % 4 == 1) std::swap(step.from, step.to);
            if (!(random_.below(12) == 0 ? refuses(step) : cuts(step))) return;
        }
    }

  private:
    BladeStep any_step() {
        BladeStep step;
        const std::int32_t t = any_visible();
        const Triangle& corners = mesh_.triangle(t).vertices;
        const auto where = which_ == one_vertex ? 3 : random_.below(3);
        const Vector3 anywhere(random_.uniform(-0.02, 0.1), random_.uniform(-0.02, 0.1), 0);
        double u = random_.uniform(), w = random_.uniform();
        if (u + w > 1) u = 1 - u, w = 1 - w;
        const Vector3 &a = at(corners[0]), &b = at(corners[1]), &c = at(corners[2]);
        step.from = where == 0 ? anywhere : where == 1 ? Vector3(a + u * (b - a) + w * (c - a)) : a;
        const Vector3 heading = direction(random_).cwiseProduct(Vector3(1, 1, 0.1));
        const double length = which_ == one_metre ? 1.0 : between(random_, 1e-4, 2.0);
        if (where == 3) {
            // Two blades alternating: every step begins, ends or passes at the same corner of the mesh.
            const Vector3& vertex = positions_[mesh_.mesh().vertices.size() / 2];
            step.from = vertex - std::array<double, 3>{0, 0.5, 1}[random_.below(3)] * length * heading;
        }
        step.to = step.from + length * heading;
        step.width = between(random_, 1e-7, 0.1);
        step.depth = between(random_, 1e-6, 0.1);
        step.normal = Vector3(0.3 * random_.normal(), 0.3 * random_.normal(), 1);
        step.start = random_.below(2) == 0 ? BladeEnd::round : BladeEnd::square;
        step.end = random_.below(2) == 0 ? BladeEnd::round : BladeEnd::square;
        step.root = where == 0 ? mesh_.nearest_root(0.5 * (step.from + step.to), positions_.data())
                               : mesh_.triangle(t).root;
        if (where == 3)
            step.root = mesh_.nearest_root(positions_[mesh_.mesh().vertices.size() / 2], positions_.data());
        return step;
    }
    void hatch() {
        // Lines closer than the cells, along x and along y, at a slant.
        const double width = between(random_, 1e-6, 2e-3), slant = 0.1 * random_.uniform(-1, 1);
        for (int pass = 0; pass < 2; ++pass)
            for (double x = random_.uniform(0, 0.4 * cell); x < extent; x += 0.4 * cell) {
                BladeStep step;
                step.from = Vector3(x, -cell, 0);
                step.to = Vector3(x + slant * extent, extent + cell, 0);
                if (pass == 1) std::swap(step.from.x(), step.from.y());
                if (pass == 1) std::swap(step.to.x(), step.to.y());
                step.width = width;
                step.root = mesh_.nearest_root(0.5 * (step.from + step.to), positions_.data());
                if (!cuts(step)) return;
            }
    }
    const Vector3& at(std::int32_t v) const { return positions_[static_cast<std::size_t>(v)]; }
    std::int32_t any_visible() {
        for (;;) {
            const auto t =
                static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(mesh_.triangle_count())));
            if (mesh_.visible(t)) return t;
        }
    }
    bool refuses(BladeStep& step) {
        const double bad = not_a_length(random_);
        switch (random_.below(4)) {
            case 0:
                step.from.y() = bad;
                break;
            case 1:
                step.to.x() = bad;
                break;
            case 2:
                step.width = bad;
                break;
            default:
                step.normal.z() = bad;
        }
        const std::uint64_t before = mesh_.version();
        ++tally_.refused;
        if (mesh_.cut(step, positions_.data()).outcome != CutOutcome::invalid)
            return fails("an invalid step is accepted");
        return mesh_.version() == before || fails("an invalid step cuts");
    }
    /// False if the run ends: nothing is left to cut, or an invariant is violated.
    bool cuts(const BladeStep& step) {
        tally_.count(mesh_.cut(step, positions_.data()), step.width);
        const CutCheck check = check_cut(mesh_, positions_.data());
        tally_.area_error = std::max(tally_.area_error, check.area_error);
        if (!check.passed()) return fails(check.complaint());
        return mesh_.visible_count() > 0;
    }
    bool fails(const char* complaint) {
        ++tally_.violations;
        if (tally_.complaint.empty()) tally_.complaint = stress_names()[which_] + ": " + complaint;
        return false;
    }

    Random random_;
    Case which_;
    CutMesh mesh_;
    std::vector<Vector3> positions_;
    StrokeTally& tally_;
};

}  // namespace

std::vector<std::string> stress_names() {
    return {"slivers of aspect 1e6",
            "coincident vertices, edges of zero length",
            "every vertex in one point",
            "folded over itself",
            "one sliver among good triangles",
            "a single triangle",
            "a plain sheet",
            "every triangle cut, both ways",
            "two blades on one vertex",
            "steps of a metre"};
}

void run_stress(std::size_t which, std::uint64_t seed, StrokeTally& tally) {
    Stress(static_cast<Case>(which % case_count), seed, tally).run();
}

}  // namespace fulcrum::lab
