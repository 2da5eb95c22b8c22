// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/skill.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr std::uint64_t individual_stream = 0x736b696c;
constexpr std::uint64_t form_stream = 0x666f726d;
// Standard deviations of the logarithm of an expert's tempo: between individuals, between one's attempts.
constexpr double tempo_spread = 0.20, form_spread = 0.15;

Skill expert() {
    Skill skill;
    skill.reaction_s = 0.16;
    skill.choice_s = 0.18;
    skill.dwell_s = 0.35;
    skill.duration_scale = 1.0;
    skill.gain = 0.97;
    skill.gain_spread = 0.03;
    skill.endpoint_noise = 0.03;
    skill.path_noise = 0.03;
    skill.depth_error = 0.0012;
    skill.gap_s = -0.06;
    skill.gap_spread_s = 0.02;
    skill.tremor = 1.5e-5;
    skill.drift = 8e-5;
    skill.touch_force = 0.3;
    skill.grip_force = 3.5;
    skill.grip_spread = 0.2;
    skill.comfortable_force = 1.0;
    skill.tolerance = 0.7e-3;
    skill.lift_speed = 0.03;
    skill.stride = 0.064;
    skill.foresight = 0.97;
    skill.hesitation = 0;
    skill.standoff = 0.004;
    skill.traction_error = 0.06;
    skill.traction_slack = 0.15;
    skill.line_error = 0.00025;
    skill.stroke = 0.020;
    return skill;
}

Skill novice() {
    Skill skill;
    skill.reaction_s = 0.24;
    skill.choice_s = 0.55;
    skill.dwell_s = 0.4;
    skill.duration_scale = 1.45;
    skill.gain = 0.80;
    skill.gain_spread = 0.20;
    skill.endpoint_noise = 0.13;
    skill.path_noise = 0.32;
    skill.depth_error = 0.006;
    skill.gap_s = 0.02;
    skill.gap_spread_s = 0.06;
    skill.tremor = 3e-5;
    skill.drift = 2.5e-4;
    skill.touch_force = 0.8;
    skill.grip_force = 8.0;
    skill.grip_spread = 1.2;
    skill.comfortable_force = 2.2;
    skill.tolerance = 1.2e-3;
    skill.lift_speed = 0.018;
    skill.stride = 0.042;
    skill.foresight = 0.2;
    skill.hesitation = 2;
    skill.standoff = 0.0005;
    skill.traction_error = 0.70;
    skill.traction_slack = 0.50;
    skill.line_error = 0.0016;
    skill.stroke = 0.012;
    return skill;
}

double width_of(const std::string& preset) {
    return preset == "expert" ? 1.0 : preset == "intermediate" ? 1.15 : 1.3;
}

double bounded_normal(Random& random) {
    return std::clamp(random.normal(), -2.0, 2.0);
}

/// Tempo is a temperament as much as a skill: it stretches whatever the hands do, and who takes more time
/// aims a little better.
void change_pace(Skill& skill, double factor) {
    skill.duration_scale *= factor;
    skill.choice_s *= factor;
    skill.lift_speed /= factor;
    skill.dwell_s *= factor;
    skill.endpoint_noise /= std::sqrt(factor);
}

double between(double a, double b) {
    return 0.5 * (a + b);
}

Skill intermediate() {
    const Skill a = expert(), b = novice();
    Skill skill;
    skill.dwell_s = between(a.dwell_s, b.dwell_s);
    skill.reaction_s = between(a.reaction_s, b.reaction_s);
    skill.choice_s = between(a.choice_s, b.choice_s);
    skill.duration_scale = between(a.duration_scale, b.duration_scale);
    skill.gain = between(a.gain, b.gain);
    skill.gain_spread = between(a.gain_spread, b.gain_spread);
    skill.endpoint_noise = between(a.endpoint_noise, b.endpoint_noise);
    skill.path_noise = between(a.path_noise, b.path_noise);
    skill.depth_error = between(a.depth_error, b.depth_error);
    skill.gap_s = between(a.gap_s, b.gap_s);
    skill.gap_spread_s = between(a.gap_spread_s, b.gap_spread_s);
    skill.tremor = between(a.tremor, b.tremor);
    skill.drift = between(a.drift, b.drift);
    skill.touch_force = between(a.touch_force, b.touch_force);
    skill.grip_force = between(a.grip_force, b.grip_force);
    skill.grip_spread = between(a.grip_spread, b.grip_spread);
    skill.comfortable_force = between(a.comfortable_force, b.comfortable_force);
    skill.tolerance = between(a.tolerance, b.tolerance);
    skill.lift_speed = between(a.lift_speed, b.lift_speed);
    skill.stride = between(a.stride, b.stride);
    skill.foresight = between(a.foresight, b.foresight);
    skill.hesitation = between(a.hesitation, b.hesitation);
    skill.standoff = between(a.standoff, b.standoff);
    skill.traction_error = between(a.traction_error, b.traction_error);
    skill.traction_slack = between(a.traction_slack, b.traction_slack);
    skill.line_error = between(a.line_error, b.line_error);
    skill.stroke = between(a.stroke, b.stroke);
    return skill;
}

}  // namespace

bool draw_individual(const std::string& preset, std::uint64_t seed, Skill& skill) {
    if (preset == "expert") {
        skill = expert();
    } else if (preset == "intermediate") {
        skill = intermediate();
    } else if (preset == "novice") {
        skill = novice();
    } else {
        return false;
    }
    Random random(seed, individual_stream);
    const double width = width_of(preset);
    // Nobody lies further out than two standard deviations: an expert of a set is an expert.
    const auto deviate = [&] { return bounded_normal(random); };
    const double ability = deviate(), tempo = deviate();
    const auto vary = [&](double& value, double spread) {
        value *= math::exp(width * spread * (0.58 * ability + 0.82 * deviate()));
    };
    vary(skill.reaction_s, 0.08);
    vary(skill.gain_spread, 0.15);
    vary(skill.endpoint_noise, 0.15);
    vary(skill.path_noise, 0.15);
    vary(skill.depth_error, 0.15);
    vary(skill.tremor, 0.20);
    vary(skill.drift, 0.20);
    vary(skill.touch_force, 0.12);
    vary(skill.grip_force, 0.08);
    vary(skill.comfortable_force, 0.10);
    vary(skill.tolerance, 0.08);
    change_pace(skill, math::exp(width * tempo_spread * tempo));
    // Drawn last: an individual's other faculties are the same numbers as before there were blades.
    vary(skill.traction_error, 0.12);
    vary(skill.traction_slack, 0.10);
    vary(skill.line_error, 0.12);
    return true;
}

void draw_form(const std::string& preset, std::uint64_t attempt, Skill& skill) {
    Random random(attempt, form_stream);
    change_pace(skill, math::exp(width_of(preset) * form_spread * bounded_normal(random)));
}

}  // namespace fulcrum
