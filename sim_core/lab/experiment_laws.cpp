// SPDX-License-Identifier: Apache-2.0
// Fig. 7: the linear law and EXP2, as drawn by Pan et al. 2011 (stress over strain) and on two rods under the
// same tension.
#include <algorithm>
#include <cmath>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/experiment_bowel.h"
#include "sim_core/lab/experiment_kinds.h"
#include "sim_core/lab/reference_rod.h"

namespace fulcrum::lab {
namespace {

constexpr double pi = 3.14159265358979323846;

struct LawRod {
    Rod rod;
    double area;
    LawRod(MaterialLaw law, double young, double exponent, double length, double radius)
        : rod(spec_of(law, young, exponent, length, radius)) {
        area = pi * radius * radius * (1 - 0.64);
    }
    static RodSpec spec_of(MaterialLaw law, double young, double exponent, double length, double radius) {
        RodSpec spec;
        spec.segments = 32;
        spec.length = length;
        spec.outer_radius = radius;
        spec.inner_radius = 0.8 * radius;
        spec.young_modulus = young;
        spec.exponent = exponent;
        spec.law = law;
        spec.ends[0] = RodEnd::clamped;
        return spec;
    }
    RodState pulled(const Vector3& force) const {
        RodInputs inputs;
        inputs.nodal_forces.assign(33, Vector3::Zero());
        inputs.nodal_forces.back() = force;
        return solve_rod(rod, inputs, rod.make_state()).state;
    }
};

// The bowel around a rod: 0 linear, in front and blue; 1 EXP2, behind and red.
ExperimentMesh shown_rod(const BowelSkin& skin, const LawRod& law, const RodState& state, int k) {
    std::vector<RingFrame> frames(static_cast<std::size_t>(skin.rings()));
    ring_frames(
        skin.cage(),
        [&](double s) {
            const RodMotion motion = law.rod.frame_at(state, s);
            return RingFrame{motion.frame.position + Vector3(0, k == 0 ? -0.021 : 0.021, 0),
                             motion.frame.rotation};
        },
        frames.data());
    ExperimentMesh shown;
    shown.name = k == 0 ? "linear" : "EXP2";
    shown.mesh.triangles = skin.rest().triangles;
    shown.mesh.vertices.resize(static_cast<std::size_t>(skin.vertices()));
    skin_all(skin, frames.data(), shown.mesh.vertices.data());
    shown.colour =
        k == 0 ? std::array<float, 3>{0.18F, 0.36F, 0.62F} : std::array<float, 3>{0.72F, 0.30F, 0.26F};
    return shown;
}

}  // namespace

void run_law_experiment(const JsonDocument& file, ExperimentResult& result) {
    const double linear_young = number_of(file, "linear_young_pa", 32.3e3, 1, 1e9),
                 exp2_young = number_of(file, "exp2_young_pa", 30.0e3, 1, 1e9);
    const double exponent = number_of(file, "exponent", 3, 0.01, 100),
                 length = number_of(file, "length_m", 0.12, 0.05, 2);
    const double radius = number_of(file, "radius_m", 0.015, 0.003, 0.05);
    const LawRod linear(MaterialLaw::linear, linear_young, exponent, length, radius),
        exp2(MaterialLaw::exp2, exp2_young, exponent, length, radius);
    Chart chart;
    chart.title = "Fig. 7: stress over strain of rods pulled along";
    chart.x_label = "strain of the rod";
    chart.y_label = "force over rest section, kPa";
    ChartSeries lines[2], closed;
    lines[0].name = "linear rod";
    lines[1].name = "EXP2 rod";
    closed.name = "EXP2, closed form";
    closed.markers = false;
    closed.dashed = true;
    const double parted = std::sqrt(std::log(1.2 * linear_young / exp2_young) / exponent);
    double at_22 = std::nan("");
    for (int i = 0; i <= 40; ++i) {
        const double strain = 0.01 * i, stress = exp2_young * strain * std::exp(exponent * strain * strain);
        closed.x.push_back(strain);
        closed.y.push_back(stress / 1000);
        const double apart = std::fabs(stress / (linear_young * strain) - 1);
        if (i == 22) at_22 = apart;
        if (i % 4 != 0) continue;
        const double force = stress * exp2.area;
        const LawRod* rods[2] = {&linear, &exp2};
        for (int k = 0; k < 2; ++k) {
            lines[k].x.push_back(rods[k]->pulled(Vector3(force, 0, 0)).nodes.back().x() / length - 1);
            lines[k].y.push_back(stress / 1000);
        }
    }
    chart.series = {lines[0], lines[1], closed};
    chart.note = "Both rods take the same forces; where the curves part, the linear rod stretches too far.";
    result.charts.push_back(
        {result.id + "_stress", "stress over strain of a linear and an EXP2 rod", svg_chart(chart)});
    result.figures.push_back({"stress of the two laws apart at 22 % strain", "%", 100 * at_22});
    result.figures.push_back({"strain from which they are 20 % apart", "%", 100 * parted});
    // On the bowel: linear in front (blue), EXP2 behind (red), both pulled along and down by the same force.
    const BowelSkin skin = make_skin(length, radius, radius, 100, 40, haustral_radius(radius));
    result.columns = 3;
    for (const double strain : {0.10, 0.22, 0.40}) {
        ExperimentPanel panel;
        const double force = exp2_young * strain * std::exp(exponent * strain * strain) * exp2.area;
        panel.title = short_number(force) + " N";
        double reach[2] = {0, 0};
        for (int k = 0; k < 2; ++k) {
            const LawRod& law = k == 0 ? linear : exp2;
            const RodState state = law.pulled(Vector3(force, 0, 0));
            panel.meshes.push_back(shown_rod(skin, law, state, k));
            reach[k] = state.nodes.back().x() / length - 1;
        }
        panel.title +=
            ": linear +" + short_number(100 * reach[0]) + " %, EXP2 +" + short_number(100 * reach[1]) + " %";
        panel.target = Vector3(0.8 * length, 0, 0);
        // From a distance through a narrow lens: the rod in front must not look longer than the one behind.
        panel.eye = panel.target + 20 * Vector3(0, -0.16, 0.42);
        panel.field_of_view = 2 * std::atan(std::tan(0.19) / 20);
        result.panels.push_back(panel);
        result.figures.push_back(
            {"stretch under " + short_number(force) + " N, linear rod", "%", 100 * reach[0]});
        result.figures.push_back(
            {"stretch under " + short_number(force) + " N, EXP2 rod", "%", 100 * reach[1]});
    }
}

}  // namespace fulcrum::lab
