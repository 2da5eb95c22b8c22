// SPDX-License-Identifier: Apache-2.0
// The skill of a synthetic operator: one set of numbers per individual, drawn around a preset. The presets
// were chosen for this project so that size and speed of movements agree with studies of laparoscopic novices
// and experts; they are not measurements of people. Individuals: every value varies by a log-normal factor; a
// third of its variance is shared by all values of an individual. Each individual also has a tempo that
// scales all durations (20 % among experts, 15 % more between attempts). All spreads are 1.15 times as wide
// for intermediates and 1.3 times for novices, and limited to two standard deviations.
// docs/results/operators_*.md shows the resulting spread of time and path.
#pragma once

#include <cstdint>

#include "assessment/operators/operator_level.h"

namespace fulcrum {

/// Skill used only on targets.
struct TargetSkill {
    double standoff = 0.002;  ///< m kept from a rigid target by the first movement, made good by the second
};
/// Skill used only on bowel.
struct BowelSkill {
    double stride = 0.055;  ///< m of bowel from one grasp to the next
};
/// Traction on a sheet or on bands.
struct TractionSkill {
    double error = 0.1;  ///< of the traction held for the right one, relative, from hold to hold
    double slack = 0.2;  ///< relative distance from it that is accepted
    double band = 1;     ///< share of comfortable_force with which a band is lifted before it is divided
};
/// Skill used only for dividing a sheet along a line.
struct LineSkill {
    double error = 0.0004;  ///< m off the line, from stroke to stroke
    double stroke = 0.018;  ///< m of one stroke of a blade
};

/// Skill used only for the plane between mesorectum and fascia.
struct PlaneSkill {
    double recognition = 1;  ///< share of the opened fibres that is recognised as the plane
    double blur = 0;         ///< m, standard deviation of the guessed height of a plane that is not seen
    double lean = 0;         ///< m, by which a guess leans towards the rectum, away from the veins
    double steadiness = 1;   ///< share of path and endpoint noise of the hands there and on bands
    double care = 0.5;       ///< foresight with the pedal
};

/// Skill used only where the scope itself is the instrument.
struct ScopeSkill {
    double post_error = 0.05;   ///< rad, standard deviation of a turn of the light post
    double level_error = 0.03;  ///< rad, standard deviation of a turn of the camera head
    double together = 1;        ///< share of turns that are made on the way, not after it
    double lead = 1;            ///< share of a tip's movement during the delay that is foreseen
};

/// Skill used only with rigid objects.
struct ObjectSkill {
    double ease = 0;  ///< share of the way to an expert's hands by which they are better there than elsewhere
};

/// Skill used by every behaviour, and the parts used by some.
struct Skill {
    double reaction_s = 0.2;    ///< from seeing to acting: decisions use what was shown this long ago
    double choice_s = 0.4;      ///< mean extra time to decide where to go next
    double duration_scale = 1;  ///< of a sub-movement, times the Fitts-like duration
    double dwell_s = 0.35;      ///< left to jaws that close or open before the hand continues
    double gain = 0.95;         ///< mean share of the distance that a sub-movement covers
    double gain_spread = 0.05;  ///< its standard deviation: above 1 in all is overshoot
    double endpoint_noise =
        0.05;  ///< standard deviation of a sub-movement's end, as a share of its length (signal-dependent)
    double path_noise = 0.05;    ///< lateral velocity noise during a movement, as a share of the speed
    double depth_error = 0.002;  ///< m, standard deviation of the misjudged depth before a movement
    double gap_s = 0.05;  ///< mean time from the end of one sub-movement to the next; negative: they overlap
    double gap_spread_s = 0.03;
    double tremor = 2e-5;      ///< m, root mean square an axis, 8 to 12 Hz
    double drift = 1e-4;       ///< m, root mean square an axis, slow wandering of a hand that holds still
    double touch_force = 0.3;  ///< N, pressed on what is touched
    double grip_force = 4;     ///< N, jaws on tissue
    double grip_spread = 0.3;  ///< N, from grasp to grasp
    double comfortable_force = 1.2;  ///< N, tissue force at which traction and pressing stop
    double tolerance = 1e-3;         ///< m, a smaller distance is accepted
    double lift_speed = 0.02;        ///< m/s, moving tissue that is held
    double foresight = 0.5;          ///< share of movements planned clear of the other instrument
    double hesitation = 0;           ///< pieces beyond one in which held tissue is moved
    TargetSkill target;
    BowelSkill bowel;
    TractionSkill traction;
    LineSkill line;
    PlaneSkill plane;
    ScopeSkill scope;
    ObjectSkill object;
};

/// The skill that shows with rigid objects: nearer to a typical expert's by object.ease. Pure.
Skill with_objects(const Skill& skill);
/// Draws an individual of a level. Pure.
void draw_individual(OperatorLevel level, std::uint64_t seed, Skill& skill);
/// The same individual on the day of one attempt: a little faster or slower. Pure.
void draw_form(OperatorLevel level, std::uint64_t attempt, Skill& skill);
/// The individual while it learns, in its form of one attempt: `mastery` 0 is what draw_individual() makes of
/// it as a novice, 0.5 as an intermediate, 1 as an expert, and every value between them lies between theirs.
/// Values outside 0 to 1 are the nearest of these. Pure.
void draw_learner(double mastery, std::uint64_t individual, std::uint64_t attempt, Skill& skill);

}  // namespace fulcrum
