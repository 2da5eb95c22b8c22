// SPDX-License-Identifier: Apache-2.0
// The pictures of cutting of Pan et al. 2011: triangles subdivided along a blade's route (Fig. 13) and a
// bowel cut while it is bent (Fig. 15).
#include <algorithm>
#include <cmath>

#include "sim_core/lab/cut_study.h"
#include "sim_core/lab/experiment_bowel.h"
#include "sim_core/lab/experiment_kinds.h"

namespace fulcrum::lab {
namespace {

constexpr double pi = 3.14159265358979323846;

// Visible triangles, each vertex interpolated from `corners` (positions of the uncut mesh's vertices).
TriangleMesh cut_surface(const CutMesh& cut, const std::vector<Vector3>& corners) {
    TriangleMesh mesh;
    std::vector<std::int32_t> number(static_cast<std::size_t>(cut.vertex_count()), -1);
    for (const Triangle& triangle : cut.visible_triangles()) {
        Triangle shown;
        for (std::size_t c = 0; c < 3; ++c) {
            std::int32_t& name = number[static_cast<std::size_t>(triangle[c])];
            if (name < 0) {
                name = static_cast<std::int32_t>(mesh.vertices.size());
                const CutVertex& vertex = cut.vertex(triangle[c]);
                const Triangle& root = cut.mesh().triangles[static_cast<std::size_t>(vertex.root)];
                Vector3 place = Vector3::Zero();
                for (std::size_t k = 0; k < 3; ++k)
                    place +=
                        vertex.barycentric[static_cast<int>(k)] * corners[static_cast<std::size_t>(root[k])];
                mesh.vertices.push_back(place);
            }
            shown[c] = name;
        }
        mesh.triangles.push_back(shown);
    }
    return mesh;
}

void figures_of(const RestBlade& blade, const RestBlade::Tally& tally, ExperimentResult& result) {
    const CutMesh& cut = blade.mesh();
    result.figures.push_back({"triangles before", "", static_cast<double>(cut.root_count())});
    result.figures.push_back({"triangles after", "", static_cast<double>(cut.visible_count())});
    result.figures.push_back({"area before", "mm2", 1e6 * cut.area_before()});
    result.figures.push_back({"area after", "mm2", 1e6 * area_at_rest(cut)});
    result.figures.push_back({"area removed", "mm2", 1e6 * cut.area_removed()});
    result.figures.push_back(
        {"before less after and removed, share of before", "",
         std::abs(cut.area_before() - area_at_rest(cut) - cut.area_removed()) / cut.area_before()});
    result.figures.push_back({"least angle", "degrees", least_angle_deg(cut)});
    result.figures.push_back({"steps rolled back", "", static_cast<double>(tally.roll_backs)});
    for (std::size_t k = 0; k < tally.cases.count.size(); ++k)
        result.figures.push_back({std::string("case 12") + static_cast<char>('a' + k), "",
                                  static_cast<double>(tally.cases.count[k])});
}

// Thin bars along a path, raised slightly off the surface.
std::vector<ExperimentMesh> route(const std::vector<Vector3>& path, double width, const Vector3& lift) {
    std::vector<ExperimentMesh> bars;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        ExperimentMesh bar;
        bar.name = "route";
        bar.mesh = make_bar(path[i] + lift, path[i + 1] + lift, width);
        bar.colour = {0.75F, 0.02F, 0.02F};
        bar.smooth = false;
        bars.push_back(bar);
    }
    return bars;
}

}  // namespace

// A few triangles, the route of a blade over them, and the subdivision stage by stage.
void run_subdivision_experiment(const JsonDocument& file, ExperimentResult& result) {
    const double edge = number_of(file, "edge_m", 0.010, 0.001, 0.1),
                 width = number_of(file, "width_m", 0.0012, 1e-5, 0.02);
    const int stages = static_cast<int>(number_of(file, "stages", 3, 1, 11));
    // Rows of equilateral triangles.
    TriangleMesh mesh;
    constexpr int columns = 5, rows = 3;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i)
            mesh.vertices.emplace_back(edge * (i + 0.5 * (j % 2)), edge * j * std::sqrt(0.75), 0);
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const std::int32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
            mesh.triangles.push_back(j % 2 == 0 ? Triangle{a, b, c} : Triangle{a, b, d});
            mesh.triangles.push_back(j % 2 == 0 ? Triangle{b, d, c} : Triangle{a, d, c});
        }
    }
    std::vector<Vector3> path;
    constexpr int points = 48;
    for (int k = 0; k <= points; ++k) {
        const double share = static_cast<double>(k) / points;
        path.emplace_back(edge * (0.9 + 3.5 * share), edge * (1.25 + 0.55 * std::sin(2.6 * pi * share)), 0);
    }
    ExperimentPanel panel;
    panel.target = 0.5 * (mesh.vertices.front() + mesh.vertices.back());
    panel.eye = panel.target + Vector3(0, 0, 11 * edge);
    panel.up = Vector3::UnitY();
    panel.field_of_view = 0.37;
    const auto show = [&](const std::string& title, const TriangleMesh& surface, std::size_t until) {
        panel.title = title;
        panel.meshes.clear();
        ExperimentMesh face, edges;
        face.name = "sheet";
        face.mesh = surface;
        face.colour = {0.86F, 0.62F, 0.52F};
        edges = face;
        edges.wireframe = true;
        edges.colour = {0.10F, 0.08F, 0.08F};
        panel.meshes = {face, edges};
        if (until > 1)
            for (ExperimentMesh& bar :
                 route({path.begin(), path.begin() + static_cast<std::ptrdiff_t>(until)}, 0.02 * edge,
                       Vector3(0, 0, 0.02 * edge)))
                panel.meshes.push_back(std::move(bar));
        result.panels.push_back(panel);
    };
    show("the mesh and the blade's route", mesh, path.size());
    for (int stage = 1; stage <= stages; ++stage) {
        const std::size_t until =
            1 + path.size() * static_cast<std::size_t>(stage) / static_cast<std::size_t>(stages + 1);
        const std::vector<Vector3> part(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(until));
        RestBlade blade(mesh, {}, CutMesh::capacity_for(mesh, RestBlade::steps_of(part, width) + 8));
        RestBlade::Tally tally;
        blade.stroke(part, width, BladeEnd::square, tally);
        show("subdivided behind the blade, stage " + std::to_string(stage),
             cut_surface(blade.mesh(), mesh.vertices), until);
    }
    RestBlade blade(mesh, {}, CutMesh::capacity_for(mesh, RestBlade::steps_of(path, width) + 8));
    RestBlade::Tally tally;
    blade.stroke(path, width, BladeEnd::square, tally);
    show("the result", cut_surface(blade.mesh(), mesh.vertices), 0);
    figures_of(blade, tally, result);
    result.columns = 2;
}

// A bowel cut along its wall: the cut is made at rest; the cage's frames then carry the remaining surface
// through a bend, as they carry an uncut surface.
void run_cut_bowel_experiment(const JsonDocument& file, ExperimentResult& result) {
    ExperimentBowelSpec spec;
    spec.length = number_of(file, "length_m", 0.24, 0.1, 1);
    spec.radius = number_of(file, "radius_m", 0.016, 0.005, 0.05);
    spec.segments = 48;
    spec.sphere_spacing = spec.radius;
    spec.sections = static_cast<int>(number_of(file, "sections", 96, 16, 1000));
    spec.around = static_cast<int>(number_of(file, "around", 36, 8, 400));
    spec.ends[0] = spec.ends[1] = RodEnd::clamped;
    const double width = number_of(file, "width_m", 0.0015, 1e-5, 0.02),
                 most = number_of(file, "bend_deg", 90, 0, 200) * pi / 180;
    ExperimentBowel bowel(spec);
    bowel.inputs().gravity.setZero();
    // The blade goes along the wall on the outside of the bend, oscillating about it. At rest the tube is
    // along +x.
    std::vector<Vector3> path;
    constexpr int points = 60;
    for (int k = 0; k <= points; ++k) {
        const double share = static_cast<double>(k) / points, angle = 2.5 + 0.5 * std::sin(3 * pi * share);
        path.emplace_back(spec.length * (0.25 + 0.5 * share), spec.radius * std::cos(angle),
                          spec.radius * std::sin(angle));
    }
    const TriangleMesh& rest = bowel.skin().rest();
    RestBlade blade(rest, {}, CutMesh::capacity_for(rest, RestBlade::steps_of(path, width) + 64));
    RestBlade::Tally tally;
    blade.stroke(path, width, BladeEnd::round, tally);
    const RodFrame start = bowel.state().ends[1];
    constexpr int steps = 40;
    for (int i = 1; i <= steps && most > 0; ++i) {
        const double angle = most * i / steps, radius = spec.length / angle;
        RodFrame& end = bowel.inputs().ends[1];
        end.position = Vector3(radius * std::sin(angle), radius * (1 - std::cos(angle)), 0);
        end.rotation = Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix() * start.rotation;
        bowel.rod().solve(bowel.state(), bowel.inputs(), bowel.scratch());
    }
    ExperimentMesh before = bowel.surface(), after = before;
    after.mesh = cut_surface(blade.mesh(), before.mesh.vertices);
    // Visible through the gap: the uncut wall again, deeper and paler.
    ExperimentMesh beneath = before;
    beneath.colour = {0.93F, 0.78F, 0.66F};
    const std::vector<Vector3> normals = vertex_normals(before.mesh);
    for (std::size_t v = 0; v < normals.size(); ++v)
        beneath.mesh.vertices[v] -= 0.1 * spec.radius * normals[v];
    const auto show = [&](const char* title, const ExperimentMesh& surface, bool edges) {
        ExperimentPanel panel;
        panel.title = title;
        ExperimentMesh face = surface;
        if (edges) {
            face.colour = {0.88F, 0.74F, 0.68F};
            panel.meshes.push_back(face);
            face.wireframe = true;
            face.colour = {0.12F, 0.10F, 0.10F};
        }
        panel.meshes.push_back(face);
        panel.meshes.push_back(beneath);
        Vector3 low = Vector3::Constant(1e9), high = -low;
        for (const Vector3& v : before.mesh.vertices) {
            low = low.cwiseMin(v);
            high = high.cwiseMax(v);
        }
        panel.target = 0.5 * (low + high);
        panel.eye = panel.target + Vector3(0.06, -0.40, 0.30) * ((high - low).norm() / 0.36);
        panel.up = Vector3::UnitZ();
        panel.field_of_view = 0.33;
        result.panels.push_back(panel);
    };
    show("(a) surface before cutting", before, false);
    show("(b) mesh before cutting", before, true);
    show("(c) surface after cutting", after, false);
    show("(d) mesh after cutting", after, true);
    figures_of(blade, tally, result);
    result.columns = 2;
}

}  // namespace fulcrum::lab
