// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/cut_strokes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/lab/membrane_reference.h"
#include "sim_core/lab/processor_time.h"
#include "sim_core/lab/random_values.h"
#include "sim_core/lab/reference_tube.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {
namespace {

constexpr int steps_before_reset = 900;  // number of steps that the capacity is sized for
constexpr int strokes_before_reset = 150;

// A smooth shape that moves with time: stretches of up to a third, bends, turns.
Vector3 moved(const Vector3& rest, double time) {
    const double wave = 0.2 * math::sin(25 * rest.x() + 1.3 * time),
                 sway = 0.15 * math::cos(31 * rest.y() + time);
    return Vector3(
        rest.x() * (1 + sway) + 0.3 * rest.z(), rest.y() * (1 + wave) - 0.2 * rest.x(),
        rest.z() + 0.01 * math::sin(20 * rest.x() + time) + 0.008 * math::cos(27 * rest.y() - time));
}

std::vector<std::int32_t> some_fixed(const TriangleMesh& shape) {
    std::vector<std::int32_t> fixed;
    for (std::size_t v = 0; v < shape.vertices.size(); v += 37) fixed.push_back(static_cast<std::int32_t>(v));
    return fixed;
}

class Strokes {
  public:
    Strokes(const TriangleMesh& shape, bool deform, std::uint64_t seed)
        : mesh_(shape, some_fixed(shape), CutMesh::capacity_for(shape, steps_before_reset)),
          positions_(static_cast<std::size_t>(mesh_.capacity().vertices), Vector3::Zero()),
          random_(seed),
          deform_(deform) {}

    void run(int strokes, StrokeTally& tally) {
        for (int i = 0; i < strokes; ++i) {
            if (i % strokes_before_reset == 0 || mesh_.area_visible() < 0.4 * mesh_.area_before())
                mesh_.reset();
            time_ += 0.05;
            place();
            stroke(tally);
            ++tally.strokes;
            if (i % 10 != 9 && i + 1 < strokes) continue;
            const CutCheck check = check_cut(mesh_, positions_.data());
            tally.area_error = std::max(tally.area_error, check.area_error);
            if (!check.passed()) {
                ++tally.violations;
                tally.complaint = "stroke " + std::to_string(i) + ": " + check.complaint() + " at " +
                                  std::to_string(check.first_bad);
                return;
            }
            drop(tally);
        }
    }

  private:
    void place() {
        for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
            const Vector3& rest = mesh_.vertex(v).rest;
            positions_[static_cast<std::size_t>(v)] = deform_ ? moved(rest, time_) : rest;
        }
    }
    const Vector3& at(std::int32_t v) const { return positions_[static_cast<std::size_t>(v)]; }
    Vector3 normal_of(std::int32_t t) const {
        const Triangle& v = mesh_.triangle(t).vertices;
        return area_vector(at(v[0]), at(v[1]), at(v[2]));
    }
    std::int32_t any_visible() {
        for (;;) {
            const auto t =
                static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(mesh_.triangle_count())));
            if (mesh_.visible(t)) return t;
        }
    }
    Vector3 tangent(const Vector3& normal) {
        const Vector3 d = direction(random_);
        const Vector3 n = normal.normalized();
        return (d - n.dot(d) * n).normalized();
    }
    void stroke(StrokeTally& tally) {
        mesh_.begin_stroke();
        const std::int32_t t = any_visible();
        const Triangle& corners = mesh_.triangle(t).vertices;
        BladeStep step;
        step.width = between(random_, 0.0002, 0.006);
        step.depth = 2 * step.width;
        step.start = random_.below(2) == 0 ? BladeEnd::square : BladeEnd::round;
        step.end = random_.below(4) == 0 ? BladeEnd::round : BladeEnd::square;
        step.root = mesh_.triangle(t).root;
        double u = random_.uniform(), w = random_.uniform();
        const auto where = random_.below(6);
        if (where == 0)
            u = w = 0;  // from a vertex
        else if (where == 1)
            w = 0;  // from an edge
        else if (u + w > 1)
            u = 1 - u, w = 1 - w;
        step.from =
            at(corners[0]) + u * (at(corners[1]) - at(corners[0])) + w * (at(corners[2]) - at(corners[0]));
        step.normal = normal_of(t);
        Vector3 heading = tangent(step.normal);
        if (where == 2) heading = (at(corners[1]) - at(corners[0])).normalized();  // along an edge
        if (where == 2) step.from = at(corners[0]);
        const int steps = static_cast<int>(1 + random_.below(4));
        const double length = between(random_, 0.0003, 0.02);
        for (int k = 0; k < steps; ++k) {
            step.to = step.from + length * heading;
            const double begin = processor_time_us();
            const CutReport report = mesh_.cut(step, positions_.data());
            tally.step_us.push_back(static_cast<float>(processor_time_us() - begin));
            tally.count(report, step.width);
            if (mesh_.visible_count() == 0) return;
            // Forward along the surface, sometimes back.
            step.root = mesh_.nearest_root(step.to, positions_.data());
            step.normal = normal_of(mesh_.root(step.root).first_visible);
            step.from = step.to;
            step.start = BladeEnd::round;
            if (random_.below(5) == 0) heading = -heading;
            const Vector3 n = step.normal.normalized();
            heading += 0.4 * inside_unit_box(random_);
            heading -= n.dot(heading) * n;
            if (heading.norm() < 1e-3) heading = tangent(n);
            heading.normalize();
        }
    }
    void drop(StrokeTally& tally) {
        const std::int32_t pieces = mesh_.find_pieces();
        for (std::int32_t p = 0; p < pieces; ++p) {
            if (mesh_.piece(p).fixed) continue;
            if (mesh_.remove_piece(p, positions_.data()).outcome == CutOutcome::cut) {
                ++tally.pieces;
            } else {
                ++tally.violations;
                tally.complaint = "a piece was not removed";
            }
            return;
        }
    }

    CutMesh mesh_;
    std::vector<Vector3> positions_;
    Random random_;
    bool deform_;
    double time_ = 0;
};

}  // namespace

void StrokeTally::count(const CutReport& report, double step_width) {
    ++steps;
    cuts += report.outcome == CutOutcome::cut ? 1 : 0;
    nothing += report.outcome == CutOutcome::nothing ? 1 : 0;
    full += report.outcome == CutOutcome::full ? 1 : 0;
    uncut += report.outcome == CutOutcome::rolled_back ? 1 : 0;
    roll_backs += report.roll_backs;
    retried += report.roll_backs > 0 && report.outcome == CutOutcome::cut ? 1 : 0;
    widened += report.width > step_width ? 1 : 0;
}

void StrokeTally::add(const StrokeTally& other) {
    strokes += other.strokes;
    steps += other.steps;
    refused += other.refused;
    cuts += other.cuts;
    nothing += other.nothing;
    full += other.full;
    roll_backs += other.roll_backs;
    retried += other.retried;
    uncut += other.uncut;
    widened += other.widened;
    violations += other.violations;
    pieces += other.pieces;
    flat += other.flat;
    if (complaint.empty()) complaint = other.complaint;
    area_error = std::max(area_error, other.area_error);
    step_us.insert(step_us.end(), other.step_us.begin(), other.step_us.end());
}

TriangleMesh make_sphere(int times, double radius) {
    const double g = 0.5 * (1 + std::sqrt(5.0));
    TriangleMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int k = 0; k < times; ++k) {
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
        const auto middle = [&](std::int32_t a, std::int32_t b) {
            const auto key = std::make_pair(std::min(a, b), std::max(a, b));
            const auto [place, fresh] = middles.emplace(key, static_cast<std::int32_t>(mesh.vertices.size()));
            if (fresh)
                mesh.vertices.push_back(0.5 * (mesh.vertices[static_cast<std::size_t>(a)] +
                                               mesh.vertices[static_cast<std::size_t>(b)]));
            return place->second;
        };
        std::vector<Triangle> finer;
        for (const Triangle& t : mesh.triangles) {
            const std::int32_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
            finer.push_back({t[0], a, c});
            finer.push_back({a, t[1], b});
            finer.push_back({c, b, t[2]});
            finer.push_back({a, b, c});
        }
        mesh.triangles = finer;
    }
    for (Vector3& v : mesh.vertices) v *= radius / v.norm();
    return mesh;
}

std::vector<StrokeSurface> stroke_surfaces() {
    BowelParameters bowel;
    bowel.vertices = 1000;
    return {{"sheet", make_sheet(25, 25, 0.096, 0.096)},
            {"sphere", make_sphere(3, 0.04)},
            {"tube", make_tube(0.12, 30, 20, plain_radius(0.016))},
            {"bowel", make_bowel(bowel, PelvisParameters()).surface}};
}

StrokeTally run_strokes(const TriangleMesh& mesh, bool deform, int strokes, std::uint64_t seed) {
    StrokeTally tally;
    tally.step_us.reserve(static_cast<std::size_t>(4 * std::max(strokes, 0)));
    Strokes(mesh, deform, seed).run(strokes, tally);
    return tally;
}

}  // namespace fulcrum::lab
