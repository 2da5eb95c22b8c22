// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/experiment.h"

#include <algorithm>
#include <cmath>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/experiment_bowel.h"
#include "sim_core/lab/experiment_kinds.h"

namespace fulcrum::lab {
namespace {

constexpr double pi = 3.14159265358979323846;

struct Kind {
    const char* name;
    void (*run)(const JsonDocument& file, ExperimentResult& result);
};

constexpr Kind kinds[] = {
    {"filter", run_filter_experiment},
    {"laws", run_law_experiment},
    {"bend", run_bend_experiment},
    {"fall", run_fall_experiment},
    {"subdivision", run_subdivision_experiment},
    {"cut_bowel", run_cut_bowel_experiment},
};

}  // namespace

ExperimentResult run_experiment(const std::string& path) {
    const JsonDocument file = JsonDocument::load(path);
    ExperimentResult result;
    result.id = text_of(file, "id");
    for (const char c : result.id) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        if (!plain) file.fail("/id", "the id is used as a file name", "use small letters, digits and _ only");
    }
    result.figure = text_of(file, "figure");
    result.caption = text_of(file, "caption");
    const std::string name = text_of(file, "kind");
    std::string known;
    for (const Kind& kind : kinds) {
        if (name == kind.name) {
            kind.run(file, result);
            return result;
        }
        known += std::string(known.empty() ? "" : ", ") + kind.name;
    }
    file.fail("/kind", "unknown kind of experiment \"" + name.substr(0, 40) + "\"", "use one of: " + known);
}

// The bowel held at one end while the other end is moved around a quarter, a half or more of a circle; cage
// and surface.
void run_bend_experiment(const JsonDocument& file, ExperimentResult& result) {
    ExperimentBowelSpec spec;
    spec.length = number_of(file, "length_m", 0.32, 0.1, 2);
    spec.radius = number_of(file, "radius_m", 0.016, 0.005, 0.05);
    spec.segments = static_cast<int>(number_of(file, "segments", 64, 8, 512));
    spec.sphere_spacing = spec.radius;
    spec.sections = 180;
    spec.around = 48;
    spec.ends[0] = spec.ends[1] = RodEnd::clamped;
    const double most = number_of(file, "bend_deg", 180, 10, 270) * pi / 180;
    ExperimentBowel bowel(spec);
    bowel.inputs().gravity.setZero();
    const RodFrame rest = bowel.state().ends[1];
    const double at_rest = enclosed_volume(bowel.skin().rest().vertices, bowel.skin().rest().triangles);
    const auto show = [&](const char* title, bool cage, bool surface) {
        ExperimentPanel panel;
        panel.title = title;
        if (surface) panel.meshes.push_back(bowel.surface());
        if (cage) panel.meshes.push_back(bowel.cage());
        Vector3 low = Vector3::Constant(1e9), high = -low;
        for (const Vector3& v : (surface ? panel.meshes[0] : panel.meshes.back()).mesh.vertices) {
            low = low.cwiseMin(v);
            high = high.cwiseMax(v);
        }
        panel.target = 0.5 * (low + high);
        panel.eye = panel.target + Vector3(0.05, -0.35, 0.62) * (1.15 * (high - low).norm() / 0.36);
        panel.field_of_view = 0.40;
        panel.up = Vector3::UnitY();
        result.panels.push_back(panel);
    };
    show("rest: surface in its cage", true, true);
    constexpr int steps = 60;
    for (int i = 1; i <= steps; ++i) {
        const double angle = most * i / steps, radius = spec.length / angle;
        RodFrame& end = bowel.inputs().ends[1];
        end.position = Vector3(radius * std::sin(angle), radius * (1 - std::cos(angle)), 0);
        const Matrix3 turn = Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
        end.rotation = turn * rest.rotation;
        bowel.rod().solve(bowel.state(), bowel.inputs(), bowel.scratch());
    }
    show("bent: surface in its cage", true, true);
    show("bent: the cage alone", true, false);
    show("bent: the surface alone", false, true);
    const double volume =
        enclosed_volume(result.panels.back().meshes[0].mesh.vertices, bowel.skin().rest().triangles);
    result.figures.push_back({"bend", "degrees", most * 180 / pi});
    result.figures.push_back({"bend radius over tube radius", "", spec.length / most / spec.radius});
    result.figures.push_back({"volume change of the surface", "%", 100 * (volume / at_rest - 1)});
    result.columns = 2;
}

// Suspends the bowel from both ends: a static solve from a U in a slightly tilted plane, so that it does not
// fall exactly onto its own line.
static void suspend(const ExperimentBowelSpec& spec, double span, double height, ExperimentBowel& bowel) {
    const auto n = static_cast<std::size_t>(spec.segments);
    std::vector<Vector3> nodes;
    const double drop = 0.5 * (spec.length - 0.5 * pi * span);
    for (std::size_t i = 0; i <= n; ++i) {
        const double s = spec.length * static_cast<double>(i) / static_cast<double>(n);
        Vector3 p;
        if (s < drop)
            p = Vector3(-0.5 * span, 0, height - s);
        else if (s > spec.length - drop)
            p = Vector3(0.5 * span, 0, height - (spec.length - s));
        else {
            const double angle = (s - drop) / (0.5 * span);
            p = Vector3(-0.5 * span * std::cos(angle), 0, height - drop - 0.5 * span * std::sin(angle));
        }
        nodes.push_back(p);
    }
    bowel.state() = bowel.rod().make_state(nodes);
    RodInputs hung;
    hung.gravity = bowel.inputs().gravity;
    for (const double s : {0.0, spec.length}) {
        RodGrasp grasp;
        grasp.s = s;
        grasp.target = bowel.rod().wall_point(bowel.state(), s, grasp.offset);
        hung.grasps.push_back(grasp);
    }
    for (int i = 0; i < 600; ++i) bowel.rod().step(bowel.state(), hung, 0.005, bowel.scratch());
    Rod::stop(bowel.state());
    // Not exactly a plane: a small disturbance moves the middle sideways.
    for (std::size_t i = 0; i <= n; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(n);
        bowel.state().velocities[i] =
            Vector3(0.05 * std::sin(5 * share), 0.12 * std::sin(2 * pi * share) + 0.05, 0);
    }
}

// The intestine is suspended from its two ends and released: it falls to the ground and onto itself.
void run_fall_experiment(const JsonDocument& file, ExperimentResult& result) {
    ExperimentBowelSpec spec;
    spec.length = number_of(file, "length_m", 0.9, 0.2, 2);
    spec.radius = number_of(file, "radius_m", 0.015, 0.005, 0.05);
    spec.segments = static_cast<int>(number_of(file, "segments", 90, 16, 512));
    spec.sphere_spacing = 0.8 * spec.radius;
    spec.floor = true;
    const int frames = static_cast<int>(number_of(file, "frames", 44, 2, 400));
    const double rate = number_of(file, "frames_per_second", 33, 5, 200),
                 height = number_of(file, "height_m", 0.5, 0.1, 3);
    const double span = number_of(file, "span_m", 0.16, 0.05, 1.5);
    ExperimentBowel bowel(spec);
    suspend(spec, span, height, bowel);
    ExperimentMesh ground;
    ground.name = "floor";
    ground.mesh = make_floor(0.6);
    ground.colour = {0.62F, 0.64F, 0.60F};
    const auto show = [&](const std::string& title, bool layers) {
        ExperimentPanel panel;
        panel.title = title;
        panel.meshes.push_back(ground);
        if (layers) {
            for (ExperimentMesh& ball : bowel.spheres()) panel.meshes.push_back(std::move(ball));
            panel.meshes.push_back(bowel.cage());
        } else {
            panel.meshes.push_back(bowel.surface());
        }
        panel.eye = Vector3(0.22, -1.15, 0.75);
        panel.target = Vector3(0, 0, layers ? 0.30 : 0.20);
        panel.field_of_view = layers ? 0.36 : 0.50;
        result.panels.push_back(panel);
    };
    show("spheres and cage, hung", true);
    result.columns = 4;
    const int sub = std::max(1, static_cast<int>(std::lround(1 / rate / 0.005)));
    double worst_self = 0, worst_floor = 0, worst_residual = 0;
    int unconverged = 0, shown = 0, self_contacts = 0;
    for (int frame = 1; frame <= frames; ++frame) {
        for (int i = 0; i < sub; ++i) {
            const RodReport report = bowel.step(1 / rate / sub);
            worst_residual = std::max(worst_residual, report.residual);
            unconverged += report.converged ? 0 : 1;
            self_contacts = std::max(self_contacts, static_cast<int>(bowel.inputs().self_contacts.size()));
        }
        worst_self = std::max(worst_self, bowel.self_overlap());
        worst_floor = std::max(worst_floor, bowel.floor_overlap());
        // Eleven pictures, evenly from the first frame to the last.
        if (frame == static_cast<int>(std::lround(1 + shown * (frames - 1) / 10.0))) {
            show("frame " + std::to_string(frame), false);
            ++shown;
        }
    }
    double speed = 0;
    for (const Vector3& v : bowel.state().velocities) speed = std::max(speed, v.norm());
    result.figures = {{"frames", "", static_cast<double>(frames)},
                      {"time simulated", "s", frames / rate},
                      {"deepest overlap of two spheres at the end of a frame", "m", worst_self},
                      {"deepest overlap with the ground at the end of a frame", "m", worst_floor},
                      {"most pairs in contact at once", "", static_cast<double>(self_contacts)},
                      {"steps that did not converge", "", static_cast<double>(unconverged)},
                      {"fastest point in the last frame", "m/s", speed}};
}

}  // namespace fulcrum::lab
