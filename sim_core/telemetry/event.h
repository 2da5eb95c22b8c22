// SPDX-License-Identifier: Apache-2.0
// Something that happened at a time.
#pragma once

#include <cstdint>

namespace fulcrum {

/// Permanent numbers: they are stored. Add at the end, never renumber.
enum class EventKind : std::uint16_t {
    attempt_begin = 0,
    first_movement = 1,
    phase_begin = 2,     ///< detail: phase index
    phase_end = 3,       ///< detail: phase index
    target_shown = 4,    ///< detail: target index
    target_reached = 5,  ///< detail: target index; a way-point
    grasp = 6,           ///< value: arc length on the bowel (m) or 0; detail: patch; a way-point
    release = 7,         ///< as grasp; a way-point
    slip = 8,            ///< tissue left the jaws against the operator's will
    drop = 9,
    regrasp = 10,           ///< the same patch grasped again within 2 s of release
    over_force_begin = 11,  ///< value: force (N); detail: limit in mN
    over_force_end = 12,    ///< value: peak (N)
    perforation = 13,       ///< critical; value: force (N)
    tool_collision = 14,    ///< tool against tool; value: depth (m)
    wall_contact = 15,      ///< tool against cavity
    pause = 16,
    resume = 17,
    device_lost = 18,
    device_back = 19,
    device_fault = 20,       ///< NaN, infinity, or a jump
    world_late = 21,         ///< detail: ticks late
    simulator_fault = 22,    ///< detail: StepRecord::outcome
    stability_limited = 23,  ///< Eq. 8 failed and the local model was reduced; value: K after
    goal_progress = 24,      ///< value: progress in the goal's unit; detail: goal index
    completed = 25,
    abandoned = 26,
    timed_out = 27,
    interrupted = 28,
    samples_lost = 29,  ///< detail: count
    tear = 30,
    jaw_pressure = 31,  ///< value: kPa, above the tissue's pressure limit
    cut_begin = 32,     ///< the blade has broken through; value: position along the marked line (m); detail:
                        ///< signed distance from it (um)
    cut_end = 33,       ///< the blade has left the tissue or its button opened; as cut_begin
    cut_advance = 34,   ///< value: position along the marked line (m); detail: signed distance from it (um),
                        ///< positive towards the fixed side
    cut_traction = 35,  ///< value: traction across the cut (N/m); detail: length of this advance (um)
    cut_rolled_back = 36,   ///< a step of the cut was invalid and undone; detail: retries
    piece_fallen = 37,      ///< tissue came free; value: area (m2)
    activation_begin = 38,  ///< energy is on; value: distance to the named structure (m); Activation; tissue:
                            ///< what it reaches
    activation_end = 39,    ///< value: least distance to the named structure (m); Activation, what held
                            ///< throughout; tissue: what it reached
    band_divided = 40,      ///< value: tension (N); detail: band
    bleed_begin = 41,     ///< value: flow (mL/min); detail: outlet; of bands 2 v trunk and 2 v + 1 branch of
                          ///< vessel v, of a wall in the order of opening
    bleed_end = 42,       ///< value: blood lost from it so far (mL); detail: outlet
    blood_loss = 43,      ///< value: blood lost so far (mL), all outlets
    clip_applied = 44,    ///< value: distance to what it sits on (m); detail: outlet, -1 another place
    heat_dose = 45,       ///< value: largest CEM43 over non-target patches so far (min); tissue: where
    vessel_injury = 46,   ///< critical: torn, or divided before it was closed; detail: outlet
    nerve_injury = 47,    ///< critical; value: CEM43 (min); NerveInjury
    tool_exchanged = 48,  ///< detail: index in the hand's list of instruments
    fibres_parted = 49,   ///< under tension, by no hand, from here to the cut_advance that follows; value,
                          ///< detail: as cut_begin
    heat_area = 50,       ///< value: non-target tissue at or above lethal_dose so far (mm2)
    lens_contact = 51,    ///< the scope's lens touched something; value: depth (m)
    target_lost = 52,     ///< a target to be followed was not framed until now; value: for how long (s);
                          ///< detail: target index
};
const char* event_name(EventKind kind);

/// hand: 0 left, 1 right, 255 none. tissue: index into the scene's tissue table, -1 none.
struct Event {
    std::uint32_t tick = 0;
    EventKind kind = EventKind::attempt_begin;
    std::uint8_t hand = 255;
    std::int8_t tissue = -1;
    std::int32_t detail = 0;
    float value = 0.0F;
};
static_assert(sizeof(Event) == 16);

// What the detail of some kinds holds, as fields. Records and exports keep the number (docs/FORMATS.md,
// events); nothing else takes it apart.

/// Of activation_begin and activation_end.
struct Activation {
    bool in_view = false;    ///< the tip was in the camera image
    bool on_target = false;  ///< it reached tissue that energy is for
    bool clear = false;      ///< it kept the safe distance from the named structure
    bool safe() const { return in_view && on_target && clear; }
};
std::int32_t detail_of(const Activation& activation);
Activation activation_of(const Event& event);

enum class InjuryCause : std::uint8_t { heat, blade };
/// Of nerve_injury.
struct NerveInjury {
    std::int32_t nerve = 0;
    InjuryCause cause = InjuryCause::heat;
};
std::int32_t detail_of(const NerveInjury& injury);
NerveInjury nerve_injury_of(const Event& event);

/// Of cut_begin, cut_advance, cut_end and fibres_parted: a place along the marked line.
struct CutPlace {
    double along = 0;     ///< m
    double distance = 0;  ///< m, signed, positive towards the fixed side
};
CutPlace cut_place_of(const Event& event);
/// Of cut_traction.
struct CutTraction {
    double traction = 0;  ///< N/m
    double length = 0;    ///< m, of this advance
};
CutTraction cut_traction_of(const Event& event);

}  // namespace fulcrum
