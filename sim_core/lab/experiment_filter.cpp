// SPDX-License-Identifier: Apache-2.0
// Figs. 3 and 5: the same force on the same vertex through filter grades 0, 1 and 2, pushed with a needle and
// pulled with a grasper.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "sim_core/bowel/dent.h"
#include "sim_core/lab/experiment_bowel.h"
#include "sim_core/lab/experiment_kinds.h"

namespace fulcrum::lab {

// The contact vertex: the top of the tube (+z), on a bulge near the middle.
static std::int32_t contact_vertex(const std::vector<Vector3>& rest, double length) {
    std::int32_t vertex = 0;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < rest.size(); ++v) {
        const double distance =
            std::hypot(rest[v].x() - 0.5 * length - 0.25 * 0.06, 0.5 * rest[v].y()) - rest[v].z();
        if (distance < best) {
            best = distance;
            vertex = static_cast<std::int32_t>(v);
        }
    }
    return vertex;
}

void run_filter_experiment(const JsonDocument& file, ExperimentResult& result) {
    const double length = number_of(file, "length_m", 0.12, 0.05, 0.5),
                 radius = number_of(file, "radius_m", 0.016, 0.005, 0.05);
    const int sections = static_cast<int>(number_of(file, "sections", 60, 20, 400)),
              around = static_cast<int>(number_of(file, "around", 40, 12, 200));
    const double push = number_of(file, "push_n", 0.6, 0.001, 20),
                 pull = number_of(file, "pull_n", 0.6, 0.001, 20);
    const double young = number_of(file, "young_pa", 32.3e3, 1, 1e9),
                 wall = number_of(file, "wall_m", 0.003, 1e-4, 0.02);
    const double backing = number_of(file, "backing_n_m3", 2e6, 1, 1e12);
    const BowelSkin skin = make_skin(length, radius, radius, sections, around, haustral_radius(radius));
    const MeshAdjacency& adjacency = skin.adjacency();
    const std::vector<Vector3>& rest = skin.rest().vertices;
    const SurfaceView view = view_of(skin.rest(), adjacency);
    const std::int32_t vertex = contact_vertex(rest, length);
    const Vector3 normal = skin.rest_normals()[static_cast<std::size_t>(vertex)];
    const WinklerBed bed = winkler_bed(young, 0.35, wall, backing, 0.08);
    result.columns = 3;
    for (const bool pulling : {false, true}) {
        for (const FilterMode mode : {FilterMode::grade_0, FilterMode::grade_1, FilterMode::grade_2}) {
            FilterOptions options;
            options.mode = mode;
            FilteredForce filtered;
            filter_force(view, vertex, 0, options, filtered);
            SurfaceLoad load;
            load.filtered = &filtered;
            load.force = (pulling ? pull : -push) * normal;
            DentState dents;
            for (int i = 0; i < 400; ++i) step_dents(bed, skin.vertex_areas().data(), &load, 1, 0.005, dents);
            ExperimentMesh surface;
            surface.name = "bowel";
            surface.mesh = skin.rest();
            surface.colour = {0.72F, 0.30F, 0.26F};
            double deepest = 0;
            for (std::int32_t i = 0; i < dents.count; ++i) {
                const DentVertex& dent = dents.entries[static_cast<std::size_t>(i)];
                surface.mesh.vertices[static_cast<std::size_t>(dent.vertex)] += dent.displacement;
                deepest = std::max(deepest, dent.displacement.norm());
            }
            ExperimentMesh lines = surface;
            lines.name = "mesh";
            lines.wireframe = true;
            lines.colour = {0.30F, 0.10F, 0.09F};
            const Vector3 tip = surface.mesh.vertices[static_cast<std::size_t>(vertex)];
            ExperimentPanel panel;
            const int grade = static_cast<int>(mode);
            panel.title = std::string(pulling ? "pulled" : "pushed") + ", grade " + std::to_string(grade);
            panel.meshes = {surface, lines};
            ExperimentMesh tool;
            tool.name = "tool";
            // A needle is drawn in the dent that it makes, which may be one vertex wide; a grasper may come
            // at an angle.
            const Vector3 direction = pulling ? Vector3(normal + Vector3(0.35, 0.1, 0)).normalized() : normal;
            tool.mesh = make_bar(tip + 0.0004 * normal, tip + 0.05 * direction, pulling ? 0.0022 : 0.0005);
            tool.colour = {0.45F, 0.48F, 0.52F};
            tool.smooth = false;
            panel.meshes.push_back(tool);
            // The contact vertex magenta, the others that the filter reaches yellow, as in Pan et al. 2011.
            for (int i = 0; i < filtered.count; ++i) {
                const std::int32_t v = filtered.vertex[static_cast<std::size_t>(i)];
                ExperimentMesh mark;
                mark.name = "touched vertex";
                mark.mesh = make_ball(surface.mesh.vertices[static_cast<std::size_t>(v)], 0.00038, 6);
                mark.colour = v == vertex ? std::array<float, 3>{0.85F, 0.05F, 0.55F}
                                          : std::array<float, 3>{0.95F, 0.80F, 0.05F};
                panel.meshes.push_back(mark);
            }
            panel.target = rest[static_cast<std::size_t>(vertex)] - 0.003 * normal;
            panel.eye =
                panel.target + (pulling ? Vector3(-0.015, -0.085, 0.05) : Vector3(-0.01, -0.055, 0.085));
            panel.field_of_view = pulling ? 0.42 : 0.34;
            result.panels.push_back(panel);
            result.figures.push_back(
                {panel.title + ": vertices that the force reaches", "", static_cast<double>(filtered.count)});
            result.figures.push_back({panel.title + ": largest displacement", "mm", 1000 * deepest});
        }
    }
}

}  // namespace fulcrum::lab
