// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/skill.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr std::uint64_t individual_stream = 0x736b696c;
constexpr std::uint64_t plane_stream = 0x706c616e;
constexpr std::uint64_t scope_stream = 0x73636f70;
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
    skill.bowel.stride = 0.064;
    skill.foresight = 0.97;
    skill.hesitation = 0;
    skill.target.standoff = 0.004;
    skill.traction.error = 0.06;
    skill.traction.slack = 0.15;
    skill.line.error = 0.00025;
    skill.line.stroke = 0.020;
    // Knows the plane's height where it is not seen; what is left is line.error.
    skill.plane.recognition = 1;
    skill.plane.blur = 0;
    skill.plane.lean = 0;
    skill.plane.care = skill.foresight;
    skill.scope.post_error = 0.06;
    skill.scope.level_error = 0.025;
    skill.scope.together = 0.95;
    skill.scope.lead = 0.8;
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
    skill.bowel.stride = 0.042;
    skill.foresight = 0.2;
    skill.hesitation = 2;
    skill.target.standoff = 0.0005;
    skill.traction.error = 0.70;
    skill.traction.slack = 0.50;
    skill.line.error = 0.0016;
    skill.line.stroke = 0.012;
    skill.plane.recognition = 0.2;
    skill.plane.blur = 0.006;
    skill.plane.lean = 0.006;
    skill.plane.care = skill.foresight;
    skill.scope.post_error = 0.45;
    skill.scope.level_error = 0.20;
    skill.scope.together = 0.1;
    skill.scope.lead = 0.1;
    return skill;
}

struct LevelRow {
    OperatorLevel kind;
    Skill (*typical)();
    double width;  ///< how far individuals are from the typical one, relative to experts
};

double bounded_normal(Random& random) {
    return std::clamp(random.normal(), -2.0, 2.0);
}

/// Applies the individual's tempo: it scales all durations, and slower operators aim a little better.
void change_pace(Skill& skill, double factor) {
    skill.duration_scale *= factor;
    skill.choice_s *= factor;
    skill.lift_speed /= factor;
    skill.dwell_s *= factor;
    skill.endpoint_noise /= std::sqrt(factor);
}

constexpr double Skill::*faculties[] = {&Skill::reaction_s,
                                        &Skill::choice_s,
                                        &Skill::duration_scale,
                                        &Skill::dwell_s,
                                        &Skill::gain,
                                        &Skill::gain_spread,
                                        &Skill::endpoint_noise,
                                        &Skill::path_noise,
                                        &Skill::depth_error,
                                        &Skill::gap_s,
                                        &Skill::gap_spread_s,
                                        &Skill::tremor,
                                        &Skill::drift,
                                        &Skill::touch_force,
                                        &Skill::grip_force,
                                        &Skill::grip_spread,
                                        &Skill::comfortable_force,
                                        &Skill::tolerance,
                                        &Skill::lift_speed,
                                        &Skill::foresight,
                                        &Skill::hesitation};

/// Half-way between an expert and a novice in the hands and their pace. Follows a line as an expert does,
/// feels the right traction a third of the way on a logarithmic scale, and makes a twentieth of a novice's
/// errors of the plane: half-way there nobody would stay within the limits of B2 and C4. At the plane
/// and on bands the hands are a third as unsteady as elsewhere, bands are lifted with less traction, and the
/// pedal is used with two thirds of an expert's foresight: without that none of 60 would pass C4, and 3 % B3.
/// Ends the first movement to a target two thirds of the way on a logarithmic scale: further off, 42 to 43 %
/// would pass A2. With rigid objects, which do not yield and which training begins with, the hands are half
/// as far from an expert's as elsewhere: without that 1 of 60 would pass A3. Chosen for these limits, not
/// measured on people.
Skill intermediate() {
    const Skill a = expert(), b = novice();
    const auto between = [](double x, double y) { return 0.5 * (x + y); };
    Skill skill;
    for (const auto faculty : faculties) skill.*faculty = between(a.*faculty, b.*faculty);
    const double nearer = std::cbrt(b.target.standoff / a.target.standoff);
    skill.target.standoff = a.target.standoff * nearer * nearer;
    skill.bowel.stride = between(a.bowel.stride, b.bowel.stride);
    skill.traction.error = a.traction.error * std::cbrt(b.traction.error / a.traction.error);
    skill.traction.slack = between(a.traction.slack, b.traction.slack);
    skill.traction.band = 0.8;
    skill.line = a.line;
    const auto twentieth = [](double x, double y) { return x + 0.05 * (y - x); };
    skill.plane.recognition = twentieth(a.plane.recognition, b.plane.recognition);
    skill.plane.blur = twentieth(a.plane.blur, b.plane.blur);
    skill.plane.lean = twentieth(a.plane.lean, b.plane.lean);
    skill.plane.steadiness = 0.35;
    skill.plane.care = a.foresight + (b.foresight - a.foresight) / 3;
    skill.scope.post_error = std::sqrt(a.scope.post_error * b.scope.post_error);
    skill.scope.level_error = std::sqrt(a.scope.level_error * b.scope.level_error);
    skill.scope.together = between(a.scope.together, b.scope.together);
    skill.scope.lead = between(a.scope.lead, b.scope.lead);
    skill.object.ease = 0.5;
    return skill;
}

constexpr LevelRow level_rows[] = {
    {OperatorLevel::expert, expert, 1.0},
    {OperatorLevel::intermediate, intermediate, 1.15},
    {OperatorLevel::novice, novice, 1.3},
};
static_assert(in_order(level_rows));

}  // namespace

Skill with_objects(const Skill& skill) {
    if (skill.object.ease == 0) return skill;
    const Skill best = expert();
    Skill there = skill;
    for (const auto faculty : faculties)
        there.*faculty += skill.object.ease * (best.*faculty - skill.*faculty);
    return there;
}

void draw_individual(OperatorLevel level, std::uint64_t seed, Skill& skill) {
    skill = row_of(level_rows, level).typical();
    Random random(seed, individual_stream);
    const double width = row_of(level_rows, level).width;
    // Limited to two standard deviations, so that every drawn expert performs as an expert.
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
    // Drawn last, so that the other values of an individual do not depend on it.
    vary(skill.traction.error, 0.12);
    vary(skill.traction.slack, 0.10);
    vary(skill.line.error, 0.12);
    // A stream of its own, so that no other value of an individual depends on it.
    Random plane(seed, plane_stream);
    const double sight = math::exp(width * 0.3 * bounded_normal(plane));
    skill.plane.recognition = 1 - std::min(1.0, (1 - skill.plane.recognition) * sight);
    skill.plane.blur *= math::exp(width * 0.25 * bounded_normal(plane));
    skill.plane.lean *= math::exp(width * 0.25 * bounded_normal(plane));
    Random scope(seed, scope_stream);
    skill.scope.post_error *= math::exp(width * 0.15 * bounded_normal(scope));
    skill.scope.level_error *= math::exp(width * 0.15 * bounded_normal(scope));
}

void draw_form(OperatorLevel level, std::uint64_t attempt, Skill& skill) {
    Random random(attempt, form_stream);
    change_pace(skill, math::exp(row_of(level_rows, level).width * form_spread * bounded_normal(random)));
}

void draw_learner(double mastery, std::uint64_t individual, std::uint64_t attempt, Skill& skill) {
    const double at = std::clamp(mastery, 0.0, 1.0);
    const bool early = at < 0.5;
    // The same seed: all levels of an individual deviate in the same direction.
    Skill low, high;
    draw_individual(early ? OperatorLevel::novice : OperatorLevel::intermediate, individual, low);
    draw_individual(early ? OperatorLevel::intermediate : OperatorLevel::expert, individual, high);
    const double share = 2 * (early ? at : at - 0.5);
    const auto between = [share](double a, double b) { return a + share * (b - a); };
    skill = low;
    for (const auto faculty : faculties) skill.*faculty = between(low.*faculty, high.*faculty);
    skill.target.standoff = between(low.target.standoff, high.target.standoff);
    skill.bowel.stride = between(low.bowel.stride, high.bowel.stride);
    skill.traction.error = between(low.traction.error, high.traction.error);
    skill.traction.slack = between(low.traction.slack, high.traction.slack);
    skill.traction.band = between(low.traction.band, high.traction.band);
    skill.line.error = between(low.line.error, high.line.error);
    skill.line.stroke = between(low.line.stroke, high.line.stroke);
    skill.plane.recognition = between(low.plane.recognition, high.plane.recognition);
    skill.plane.blur = between(low.plane.blur, high.plane.blur);
    skill.plane.lean = between(low.plane.lean, high.plane.lean);
    skill.plane.steadiness = between(low.plane.steadiness, high.plane.steadiness);
    skill.plane.care = between(low.plane.care, high.plane.care);
    skill.scope.post_error = between(low.scope.post_error, high.scope.post_error);
    skill.scope.level_error = between(low.scope.level_error, high.scope.level_error);
    skill.scope.together = between(low.scope.together, high.scope.together);
    skill.scope.lead = between(low.scope.lead, high.scope.lead);
    skill.object.ease = between(low.object.ease, high.object.ease);
    draw_form(at < 0.25   ? OperatorLevel::novice
              : at < 0.75 ? OperatorLevel::intermediate
                          : OperatorLevel::expert,
              attempt, skill);
}

}  // namespace fulcrum
