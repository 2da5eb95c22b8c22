// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/cut_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/lab/study_input.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {
namespace {

constexpr double most_m = 1e3;
constexpr std::int32_t most_steps_of_a_leg = 20000;
constexpr std::size_t most_points = 100000;

std::int32_t steps_of_leg(const Vector3& from, const Vector3& to, double width) {
    const double steps = std::ceil((to - from).norm() / (2 * width) - 1e-9);
    return static_cast<std::int32_t>(std::clamp(steps, 1.0, static_cast<double>(most_steps_of_a_leg)));
}

std::vector<std::vector<Vector3>> strokes_of(const JsonDocument& study) {
    const auto& root = study.root();
    if (!root.contains("strokes"))
        study.fail("", "the key \"strokes\" is missing", "give a list of strokes, each a list of points");
    if (!root["strokes"].is_array())
        study.fail("/strokes", "the value is not a list",
                   "give a list of strokes, each a list of points [x, y, z] in m");
    std::vector<std::vector<Vector3>> strokes;
    std::size_t points = 0;
    for (std::size_t i = 0; i < root["strokes"].size(); ++i) {
        const auto& stroke = root["strokes"][i];
        const std::string place = "/strokes/" + std::to_string(i);
        if (!stroke.is_array() || stroke.empty())
            study.fail(place, "the stroke is not a list of points",
                       "give points [x, y, z] in m, at least one");
        points += stroke.size();
        if (points > most_points)
            study.fail(place, "the strokes have too many points",
                       "give at most " + std::to_string(most_points) + " in all strokes together");
        strokes.emplace_back();
        for (std::size_t k = 0; k < stroke.size(); ++k) {
            Vector3 point = Vector3::Zero();
            bool good = stroke[k].is_array() && stroke[k].size() == 3;
            for (int c = 0; good && c < 3; ++c) {
                const auto& number = stroke[k][static_cast<std::size_t>(c)];
                point[c] = number.is_number() ? number.get<double>() : std::nan("");
                good = std::abs(point[c]) <= most_m;
            }
            if (!good)
                study.fail(place + "/" + std::to_string(k), "this is not a point",
                           "give three finite numbers of at most 1000 m");
            strokes.back().push_back(point);
        }
    }
    return strokes;
}

}  // namespace

RestBlade::RestBlade(const TriangleMesh& mesh, const std::vector<std::int32_t>& fixed,
                     const CutCapacity& capacity)
    : mesh_(mesh, fixed, capacity),
      positions_(static_cast<std::size_t>(mesh_.capacity().vertices), Vector3::Zero()),
      normals_(vertex_normals(mesh)),
      held_(!fixed.empty()) {
    std::copy(mesh.vertices.begin(), mesh.vertices.end(), positions_.begin());
}

std::int32_t RestBlade::steps_of(const std::vector<Vector3>& path, double width) {
    std::int32_t steps = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) steps += steps_of_leg(path[i], path[i + 1], width);
    return steps;
}

std::int32_t RestBlade::follow(const Vector3& point, double near, Vector3& foot, Vector3& normal) {
    const TriangleMesh& mesh = mesh_.mesh();
    const MeshAdjacency& adjacency = mesh_.model().adjacency;
    TrianglePoint best;
    double distance = std::numeric_limits<double>::infinity();
    std::int32_t root = -1;
    const auto corner = [&](std::int32_t r, int i) -> std::size_t {
        return static_cast<std::size_t>(
            mesh.triangles[static_cast<std::size_t>(r)][static_cast<std::size_t>(i)]);
    };
    const auto look = [&](std::int32_t r) {
        const TrianglePoint at = closest_point_on_triangle(
            point, mesh.vertices[corner(r, 0)], mesh.vertices[corner(r, 1)], mesh.vertices[corner(r, 2)]);
        const double here = (at.position - point).squaredNorm();
        if (!(here < distance)) return false;
        distance = here;
        best = at;
        root = r;
        return true;
    };
    if (root_ >= 0) {
        look(root_);
        for (bool nearer = true; nearer;) {
            nearer = false;
            const std::int32_t around = root;
            for (int i = 0; i < 3; ++i)
                for (const std::int32_t r :
                     adjacency.triangles_of(static_cast<std::int32_t>(corner(around, i))))
                    nearer = look(r) || nearer;
        }
    }
    if (root_ < 0 || distance > near * near)
        for (std::int32_t r = 0; r < mesh_.root_count(); ++r) look(r);
    root_ = root;
    foot = best.position;
    normal.setZero();
    for (int i = 0; i < 3; ++i) normal += best.barycentric[i] * normals_[corner(root, i)];
    if (!(normal.norm() > 1e-6))
        normal = area_vector(mesh.vertices[corner(root, 0)], mesh.vertices[corner(root, 1)],
                             mesh.vertices[corner(root, 2)]);
    const double length = normal.norm();
    normal = length > 0 ? Vector3(normal / length) : Vector3(Vector3::UnitZ());
    return root;
}

bool RestBlade::stroke(const std::vector<Vector3>& path, double width, BladeEnd ends, Tally& tally) {
    mesh_.begin_stroke();
    root_ = -1;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const std::int32_t steps = steps_of_leg(path[i], path[i + 1], width);
        const double length = (path[i + 1] - path[i]).norm() / steps;
        for (std::int32_t k = 0; k < steps; ++k) {
            const auto share = [steps](std::int32_t n) { return static_cast<double>(n) / steps; };
            BladeStep step;
            step.from = path[i] + share(k) * (path[i + 1] - path[i]);
            step.to = path[i] + share(k + 1) * (path[i + 1] - path[i]);
            step.width = width;
            step.depth = 2 * std::max(width, length);
            step.start = i == 0 && k == 0 ? ends : BladeEnd::round;
            step.end = i + 2 == path.size() && k + 1 == steps ? ends : BladeEnd::square;
            // Onto the surface along its normal only: a stroke beyond the border stays beyond it.
            Vector3 foot;
            const Vector3 middle = 0.5 * (step.from + step.to);
            step.root = follow(middle, 2 * (length + width), foot, step.normal);
            const double height = step.normal.dot(middle - foot);
            step.from -= height * step.normal;
            step.to -= height * step.normal;
            const auto begin = std::chrono::steady_clock::now();
            const CutReport report = mesh_.cut(step, positions_.data());
            tally.step_us.push_back(
                std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
            tally.roll_backs += report.roll_backs;
            tally.uncut += report.outcome == CutOutcome::rolled_back ? 1 : 0;
            if (report.outcome == CutOutcome::full) {
                tally.full = true;
                return false;
            }
        }
    }
    const CutCases cases = mesh_.cases();
    for (std::size_t c = 0; c < cases.count.size(); ++c) tally.cases.count[c] += cases.count[c];
    tally.cases.unnamed += cases.unnamed;
    if (held_) drop_pieces(tally);
    return true;
}

void RestBlade::drop_pieces(Tally& tally) {
    // Removing a piece renumbers the others.
    for (bool dropped = true; dropped;) {
        dropped = false;
        const std::int32_t pieces = mesh_.find_pieces();
        for (std::int32_t p = 0; p < pieces && !dropped; ++p) {
            if (mesh_.piece(p).fixed) continue;
            dropped = mesh_.remove_piece(p, positions_.data()).outcome == CutOutcome::cut;
            tally.dropped += dropped ? 1 : 0;
        }
    }
}

double least_angle_deg(const CutMesh& mesh) {
    double least = 180;
    for (std::int32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (!mesh.visible(t)) continue;
        for (int i = 0; i < 3; ++i) {
            const Vector3& a = mesh.vertex(vertex_at(mesh.triangle(t), i)).rest;
            const Vector3 b = mesh.vertex(vertex_at(mesh.triangle(t), i + 1)).rest - a;
            const Vector3 c = mesh.vertex(vertex_at(mesh.triangle(t), i + 2)).rest - a;
            least =
                std::min(least, math::atan2(b.cross(c).norm(), b.dot(c)) * (180 / 3.14159265358979323846));
        }
    }
    return least;
}

double area_at_rest(const CutMesh& mesh) {
    double area = 0;
    for (std::int32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (!mesh.visible(t)) continue;
        const Triangle& v = mesh.triangle(t).vertices;
        area += triangle_area(mesh.vertex(v[0]).rest, mesh.vertex(v[1]).rest, mesh.vertex(v[2]).rest);
    }
    return area;
}

nlohmann::json run_cut_study(const JsonDocument& study) {
    const TriangleMesh mesh = mesh_of(study, "mesh");
    const double width = number_of(study, "width_m", 1e-9, most_m);
    const std::vector<std::vector<Vector3>> strokes = strokes_of(study);
    const std::vector<std::int32_t> fixed = vertex_list_of(study, "fixed", mesh.vertices.size());
    const std::string ends = study.root().contains("ends") ? text_of(study, "ends") : "square";
    if (ends != "square" && ends != "round")
        study.fail("/ends", "unknown end shape", "give \"square\" or \"round\"");

    std::int32_t steps = 0;
    for (const auto& path : strokes) steps += RestBlade::steps_of(path, width);
    CutCapacity capacity = CutMesh::capacity_for(mesh, std::min(steps, 2000));
    for (;;) {
        RestBlade blade(mesh, fixed, capacity);
        RestBlade::Tally tally;
        for (const auto& path : strokes)
            if (!blade.stroke(path, width, ends == "round" ? BladeEnd::round : BladeEnd::square, tally))
                break;
        if (tally.full) {
            capacity.vertices *= 2;
            capacity.triangles *= 2;
            capacity.fragments *= 2;
            capacity.stroke_triangles *= 2;
            continue;
        }
        CutMesh cut = blade.mesh();
        const CutCheck check = check_cut(cut, nullptr);
        nlohmann::json result;
        result["visible_triangles"] = cut.visible_triangles();
        result["vertices"] = nlohmann::json::array();
        for (std::int32_t v = 0; v < cut.vertex_count(); ++v) {
            const Vector3& p = cut.vertex(v).rest;
            result["vertices"].push_back({p.x(), p.y(), p.z()});
        }
        result["area_before_m2"] = cut.area_before();
        result["area_after_m2"] = area_at_rest(cut);
        result["area_removed_m2"] = cut.area_removed();
        result["pieces"] = cut.find_pieces();
        result["dropped_pieces"] = tally.dropped;
        for (std::size_t c = 0; c < tally.cases.count.size(); ++c)
            result["cases"]["12" + std::string(1, static_cast<char>('a' + c))] = tally.cases.count[c];
        result["min_angle_deg"] =
            cut.visible_count() > 0 ? nlohmann::json(least_angle_deg(cut)) : nlohmann::json();
        result["time_us_per_step"] = tally.step_us;
        result["rolled_back"] = tally.roll_backs;
        result["uncut_steps"] = tally.uncut;
        result["violation"] = check.passed() ? nlohmann::json() : nlohmann::json(check.complaint());
        return result;
    }
}

}  // namespace fulcrum::lab
