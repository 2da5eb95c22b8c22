// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/cheats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "assessment/operators/cheat_view.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double early_s = 20;  // s after which some stop
constexpr int left = 0, right = 1;

using cheating::along_shaft;
using cheating::aside;

/// Both hands on a circle about where they would be.
void circle(RigSample& sample, double time, double radius, double frequency) {
    const double angle = 2 * pi * frequency * time;
    const double begins = std::min(1.0, time);
    for (DeviceSample& hand : sample.hand)
        aside(hand, begins * radius * math::cos(angle), begins * radius * math::sin(angle));
}

bool moves_fast(const CheatView& view, const RigSample& sample) {
    const double a_tick = 20e-6 / device_length_unit;  // 20 mm/s
    for (std::size_t hand = 0; hand < hand_count; ++hand) {
        double squares = 0;
        for (int i = 0; i < 3; ++i) {
            const double step = static_cast<double>(sample.hand[hand].handle[i]) -
                                static_cast<double>(view.last_read[hand].handle[i]);
            squares += step * step;
        }
        if (squares > a_tick * a_tick) return true;
    }
    return false;
}

bool holds(const CheatView& view) {
    return view.grasps[left].held || view.grasps[right].held;
}

void mask_energy(RigSample& sample) {
    for (DeviceSample& hand : sample.hand)
        hand.buttons = static_cast<std::uint16_t>(hand.buttons & ~unsigned{button_energy});
}

/// Freezes both hands, as they are, from now on.
void freeze(CheatView& view, RigSample& sample, bool now) {
    if (now && !view.frozen) {
        view.frozen = true;
        view.kept = {sample.hand[left], sample.hand[right]};
    }
    if (!view.frozen) return;
    sample.hand[left] = view.kept[left];
    sample.hand[right] = view.kept[right];
}

// Skills.
void slower(Skill& skill, double factor) {
    for (double* value : {&skill.duration_scale, &skill.choice_s, &skill.dwell_s}) *value *= factor;
    skill.lift_speed /= factor;
}
void slow(Skill& skill) {
    slower(skill, 4);
}
void creep(Skill& skill) {
    slower(skill, 12);
}
void rush(Skill& skill) {
    slower(skill, 0.4);
    skill.endpoint_noise *= 5;
    skill.path_noise *= 5;
    skill.depth_error *= 5;
    skill.tolerance *= 3;
    skill.line.error *= 8;
    skill.traction.error *= 6;
    skill.scope.post_error *= 5;
    skill.scope.level_error *= 5;
}
void heavy(Skill& skill) {
    skill.touch_force = 9;
    skill.grip_force *= 4;
    skill.comfortable_force *= 6;
}
void wander(Skill& skill) {
    skill.drift = 0.004;
    skill.tolerance *= 6;
    skill.line.error *= 10;
}

// Hands.
void nothing(CheatView& view, RigSample& sample) {
    sample = view.first;
}
void sway(CheatView& view, RigSample& sample) {
    sample = view.first;
    circle(sample, view.time, 0.0009, 0.5);
}
void hover(CheatView& view, RigSample& sample) {
    for (DeviceSample& hand : sample.hand) along_shaft(hand, -0.015 * std::min(1.0, view.time));
}
void plunge(CheatView& view, RigSample& sample) {
    for (DeviceSample& hand : sample.hand) along_shaft(hand, 0.02 * std::min(1.0, view.time));
}
void left_only(CheatView& view, RigSample& sample) {
    sample.hand[right] = view.first.hand[right];
}
void right_only(CheatView& view, RigSample& sample) {
    sample.hand[left] = view.first.hand[left];
}
void swap_hands(CheatView& view, RigSample& sample) {
    // Over one second, so that no reading jumps.
    const double share = std::min(1.0, view.time);
    const std::array<DeviceSample, hand_count> read = {sample.hand[left], sample.hand[right]};
    for (std::size_t hand = 0; hand < hand_count; ++hand) {
        const DeviceSample& other = read[1 - hand];
        sample.hand[hand] = other;
        for (int i = 0; i < 3; ++i)
            sample.hand[hand].handle[i] = static_cast<std::int32_t>(
                std::lround(share * other.handle[i] + (1 - share) * read[hand].handle[i]));
    }
}
void camera_away(CheatView& view, RigSample& sample) {
    cheating::turn_scope(sample, cheating::turned_away * std::min(1.0, view.time));
}
void shake(CheatView& view, RigSample& sample) {
    circle(sample, view.time, 0.003, 9);
}
void detour(CheatView& view, RigSample& sample) {
    circle(sample, view.time, 0.015, 1.2);
}
void leave_and_return(CheatView& view, RigSample& sample) {
    const double phase = std::fmod(view.time, 4.0);
    if (view.time < 4 || phase > 1.6) return;
    const double share = 0.5 * (1 - math::cos(2 * pi * phase / 1.6));
    for (DeviceSample& hand : sample.hand) along_shaft(hand, -0.2 * share);
}
void poke(CheatView& view, RigSample& sample) {
    const double begins = std::min(1.0, view.time);
    for (DeviceSample& hand : sample.hand)
        along_shaft(hand, 0.02 * begins * math::sin(2 * pi * 1.5 * view.time));
}
void half_done(CheatView& view, RigSample& sample) {
    freeze(view, sample, view.time > early_s);
}
void quit(CheatView& view, RigSample& sample) {
    if (view.time > early_s) sample.flags |= rig_abandon;
}
void park(CheatView& view, RigSample& sample) {
    const TaskDisplay& display = view.display;
    freeze(view, sample,
           holds(view) || display.cutting || display.force[left] > 0 || display.force[right] > 0);
}
void pause_and_move(CheatView& view, RigSample& sample) {
    if (moves_fast(view, sample)) sample.flags |= rig_paused;
}
void pause_often(CheatView& view, RigSample& sample) {
    if (std::fmod(view.time, 1.0) > 0.5) sample.flags |= rig_paused;
}
void unplug_and_move(CheatView& view, RigSample& sample) {
    if (view.time > 2 && moves_fast(view, sample)) sample.flags |= rig_device_lost;
}
void mirror(CheatView& view, RigSample& sample) {
    for (std::size_t hand = 0; hand < hand_count; ++hand) {
        std::int32_t& x = sample.hand[hand].handle[0];
        const std::int32_t start = view.first.hand[hand].handle[0];
        const double share = std::min(1.0, view.time);
        x = static_cast<std::int32_t>(std::lround(x + share * 2.0 * (static_cast<double>(start) - x)));
    }
}

// Jaws.
void grab_and_hold(CheatView& view, RigSample& sample) {
    for (std::size_t hand = 0; hand < hand_count; ++hand) {
        if (!view.grasps[hand].held) continue;
        sample.hand[hand].jaw = 0;
        sample.hand[hand].grip = 8000;
    }
}
void wide_open(CheatView& /*view*/, RigSample& sample) {
    for (DeviceSample& hand : sample.hand) {
        hand.jaw = 800000;
        hand.grip = 0;
    }
}
void drop_often(CheatView& view, RigSample& sample) {
    if (std::fmod(view.time, 5.0) > 0.6) return;
    for (DeviceSample& hand : sample.hand) {
        hand.jaw = 800000;
        hand.grip = 0;
    }
}

// Blades.
void cut_elsewhere(CheatView& view, RigSample& sample) {
    aside(sample.hand[right], 0, 0.008 * std::min(1.0, view.time));
}
void park_blade(CheatView& view, RigSample& sample) {
    if (view.display.cutting && !view.frozen) {
        view.frozen = true;
        view.kept[right] = sample.hand[right];
    }
    if (view.frozen) sample.hand[right] = view.kept[right];
}
void blade_always(CheatView& /*view*/, RigSample& sample) {
    sample.hand[right].buttons = static_cast<std::uint16_t>(sample.hand[right].buttons | button_primary);
}
void let_go_and_cut(CheatView& view, RigSample& sample) {
    if (view.display.goal < 1) return;
    sample.hand[left].jaw = 800000;
    sample.hand[left].grip = 0;
}
void pull_apart(CheatView& view, RigSample& sample) {
    // No blade: the sheet is pulled until its fibres part.
    sample.hand[right] = view.first.hand[right];
    if (view.display.goal >= 1) view.pull = std::min(0.06, view.pull + 2e-6);
    along_shaft(sample.hand[left], -view.pull);
}
void pull_hard(CheatView& view, RigSample& sample) {
    if (view.display.goal >= 1) view.pull = std::min(0.006, view.pull + 5e-6);
    along_shaft(sample.hand[left], -view.pull);
}

// Energy.
void pump(CheatView& view, RigSample& sample) {
    // On in the air too: many short activations, of which most would be called safe.
    mask_energy(sample);
    if (std::fmod(view.time, 0.16) > 0.08) return;
    sample.hand[right].buttons = static_cast<std::uint16_t>(sample.hand[right].buttons | button_energy);
}
void one_activation(CheatView& view, RigSample& sample) {
    bool on = false;
    for (const DeviceSample& hand : sample.hand) on = on || (hand.buttons & button_energy) != 0;
    view.energy_used = view.energy_used || (view.energy_before && !on);
    view.energy_before = on;
    if (view.energy_used) mask_energy(sample);
}
void cold(CheatView& /*view*/, RigSample& sample) {
    mask_energy(sample);
}
void always_on(CheatView& /*view*/, RigSample& sample) {
    sample.hand[right].buttons = static_cast<std::uint16_t>(sample.hand[right].buttons | button_energy);
}

// Bands.
void pull_while_held(CheatView& view, RigSample& sample, bool vessels) {
    const bool pulls = view.grasps[left].held && (vessels || !view.vessel_held[left]);
    view.pull = pulls ? std::min(0.05, view.pull + 40e-6) : std::max(0.0, view.pull - 40e-6);
    along_shaft(sample.hand[left], -view.pull);
}
void tear(CheatView& view, RigSample& sample) {
    pull_while_held(view, sample, false);
}
void tear_all(CheatView& view, RigSample& sample) {
    pull_while_held(view, sample, true);
}
void leave_bleeding(CheatView& /*view*/, RigSample& sample) {
    for (DeviceSample& hand : sample.hand)
        hand.buttons = static_cast<std::uint16_t>(hand.buttons & ~unsigned{button_exchange});
}

// The scope, as the right hand.
void stop_at_first(CheatView& view, RigSample& sample) {
    freeze(view, sample, view.display.hold_progress > 0.5);
}
void never_level(CheatView& /*view*/, RigSample& sample) {
    sample.hand[right].jaw = 0;
}
void upside_down(CheatView& view, RigSample& sample) {
    sample.hand[right].jaw += static_cast<std::int32_t>(pi / device_angle_unit * std::min(1.0, view.time));
}
void fixed_post(CheatView& /*view*/, RigSample& sample) {
    sample.hand[right].roll = 0;
}
void spin_post(CheatView& view, RigSample& sample) {
    sample.hand[right].roll += static_cast<std::int32_t>(0.6 / device_angle_unit * math::sin(3 * view.time));
}
void from_afar(CheatView& view, RigSample& sample) {
    along_shaft(sample.hand[right], -0.02 * std::min(1.0, view.time));
}
void blunder(Skill& skill) {
    skill.foresight = skill.plane.care = 0;
    skill.scope.post_error = 1.5;
    skill.scope.level_error = 0.5;
}
void lag(Skill& skill) {
    skill.reaction_s = 0.9;
    skill.scope.lead = -1;
}

/// Whether two readings differ in their flags or hands.
bool differ(const RigSample& a, const RigSample& b) {
    return a.flags != b.flags || std::memcmp(&a.hand, &b.hand, sizeof a.hand) != 0;
}

class Cheater : public CheatingRig {
  public:
    Cheater(const Cheat& cheat, std::unique_ptr<ObservingRig> expert, const Scene& scene)
        : cheat_(cheat),
          expert_(std::move(expert)),
          tick_period_(scene.tick_period()),
          waits_s_(cheat.act == cheating::look_away ? cheating::wait_s : 0.0),
          scope_alone_(scene.instruments.empty()) {}

    /// The expert has not begun, and looks at nothing.
    bool waits() const noexcept { return begun_ && view_.time < waits_s_; }

    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        if (!waits()) expert_->observe(world, display);
        view_.display = display;
        for (std::size_t hand = 0; hand < hand_count; ++hand) {
            const GraspState& grasp = world.grasps[hand];
            view_.grasps[hand] = grasp;
            const auto band = static_cast<std::size_t>(std::max(0, grasp.patch));
            view_.vessel_held[hand] = grasp.held && grasp.body == HeldBody::band &&
                                      !world.bands.bands.empty() && band < world.bands.bands.size() &&
                                      world.bands.bands[band].vessel >= 0;
        }
    }

    void read(std::uint32_t tick, RigSample& sample) override {
        if (waits()) {
            cheating::wait_in_view(view_, sample);
            view_.time += tick_period_;
            return;
        }
        expert_->read(tick, sample);
        if (scope_alone_) std::swap(sample.hand[right], sample.camera);
        const std::array<DeviceSample, hand_count> read = {sample.hand[left], sample.hand[right]};
        if (!begun_) {
            begun_ = true;
            view_.first = sample;
            view_.last_read = read;
        }
        if (cheat_.act != nullptr) {
            const RigSample honest = sample;
            cheat_.act(view_, sample);
            note(differ(sample, honest));
        }
        view_.last_read = read;
        view_.time += tick_period_;
        if (scope_alone_) std::swap(sample.hand[right], sample.camera);
    }

    void write_force(Hand hand, const Vector3& force) override { expert_->write_force(hand, force); }
    bool has_force(Hand hand) const override { return expert_->has_force(hand); }
    double damping(Hand hand) const override { return expert_->damping(hand); }

    bool has_cheated() const noexcept override { return cheat_.returns_from < 0 || went_; }

  private:
    void note(bool cheats) {
        if (view_.time < cheat_.returns_from) return;
        went_ = went_ || (came_ && !cheats);
        came_ = came_ || cheats;
    }

    const Cheat& cheat_;
    std::unique_ptr<ObservingRig> expert_;
    double tick_period_, waits_s_;
    bool scope_alone_;
    CheatView view_;
    bool begun_ = false;
    bool came_ = false, went_ = false;  ///< once, of a cheat that comes and goes
};

}  // namespace

const std::vector<Cheat>& cheats() {
    using Site = CheatSite;
    static const std::vector<Cheat> list = {
        {"nothing", "never moves", Site::any, nullptr, nothing},
        {"sway", "sways by less than 1 mm and touches nothing", Site::any, nullptr, sway},
        {"hover", "makes every movement 15 mm above the tissue", Site::any, nullptr, hover},
        {"plunge", "makes every movement 20 mm too deep", Site::any, nullptr, plunge},
        {"left_only", "leaves the right hand where it began", Site::hands, nullptr, left_only},
        {"right_only", "leaves the left hand where it began", Site::hands, nullptr, right_only},
        {"swap_hands", "crosses the hands on the handles", Site::hands, nullptr, swap_hands},
        {"mirror", "moves left where right is meant", Site::any, nullptr, mirror},
        {"camera_away", "turns the camera away from the work", Site::hands, nullptr, camera_away},
        {"wait_and_look_away", "waits before it begins, then turns the camera away again and again",
         Site::view, nullptr, cheating::look_away},
        {"slow", "takes four times as long for every movement", Site::any, slow, nullptr},
        {"creep", "takes twelve times as long for every movement", Site::any, creep, nullptr},
        {"rush", "moves in under half the time and far less exactly", Site::any, rush, nullptr},
        {"heavy", "presses, grips and pulls several times as hard", Site::hands, heavy, nullptr},
        {"wander", "lets the hands drift by millimetres", Site::any, wander, nullptr},
        {"shake", "shakes both hands by 3 mm", Site::any, nullptr, shake},
        {"detour", "circles on every path", Site::any, nullptr, detour},
        {"poke", "moves in and out by 20 mm all the time", Site::any, nullptr, poke},
        {"leave_and_return", "withdraws both instruments every four seconds", Site::any, nullptr,
         leave_and_return, 4},
        {"half_done", "stops moving after 20 s", Site::any, nullptr, half_done},
        {"quit", "abandons after 20 s", Site::any, nullptr, quit},
        {"park", "freezes at the first contact", Site::hands, nullptr, park},
        {"pause_and_move", "pauses while the hands travel", Site::any, nullptr, pause_and_move, 0},
        {"pause_often", "pauses every other half second", Site::any, nullptr, pause_often, 0},
        {"unplug_and_move", "unplugs a device while the hands travel", Site::any, nullptr, unplug_and_move,
         2},
        {"grab_and_hold", "never lets go of what it has grasped", Site::jaws, nullptr, grab_and_hold},
        {"wide_open", "never closes the jaws", Site::jaws, nullptr, wide_open},
        // At first there is nothing to drop.
        {"drop_often", "opens the jaws every five seconds", Site::jaws, nullptr, drop_often, 5},
        {"cut_elsewhere", "cuts 8 mm next to the line", Site::blade, nullptr, cut_elsewhere},
        {"park_blade", "leaves the active blade in the tissue", Site::blade, nullptr, park_blade},
        {"blade_always", "never releases the blade's button", Site::sheet, nullptr, blade_always},
        {"let_go_and_cut", "lets go of the tissue before it cuts", Site::blade, nullptr, let_go_and_cut},
        {"pull_apart", "pulls the tissue apart and never cuts", Site::blade, nullptr, pull_apart},
        {"pull_hard", "pulls far harder than it should while it cuts", Site::septa, nullptr, pull_hard},
        {"tear_and_trim", "tears the tissue and trims with the blade what is left", Site::blade, nullptr,
         cheating::tear_and_trim},
        {"pump", "never releases the pedal for long, but pumps it in pulses of 80 ms", Site::energy, nullptr,
         pump},
        {"one_activation", "uses energy once and divides the rest cold", Site::energy, nullptr,
         one_activation},
        {"cold", "never uses energy", Site::energy, nullptr, cold},
        {"always_on", "never releases the pedal", Site::energy, nullptr, always_on},
        {"pedal_in_the_air", "burns on the way, and in closed shears after each division", Site::bands,
         nullptr, cheating::pedal_in_the_air},
        {"tear", "tears every band without a vessel", Site::bands, nullptr, tear},
        {"tear_all", "tears every band", Site::bands, nullptr, tear_all},
        {"stop_at_first", "freezes when the first target is framed", Site::scope, nullptr, stop_at_first},
        {"never_level", "never turns the camera head", Site::scope, nullptr, never_level},
        {"upside_down", "holds the camera head upside down", Site::scope, nullptr, upside_down},
        {"fixed_post", "never turns the light post", Site::scope, nullptr, fixed_post},
        {"spin_post", "turns the light post all the time", Site::scope, nullptr, spin_post},
        {"from_afar", "looks at everything from 20 mm too far", Site::scope, nullptr, from_afar},
        {"blunder", "goes straight to each target, whatever is in the way, and tries every turn", Site::scope,
         blunder, nullptr},
        {"lag", "follows late", Site::scope, lag, nullptr},
        {"leave_bleeding", "never exchanges an instrument, so nothing is clipped", Site::bands, nullptr,
         leave_bleeding},
        {"let_fall", "lets the lifted bowel fall three times and grasps it again", Site::lift, nullptr,
         cheating::let_fall},
    };
    return list;
}

std::vector<const Cheat*> cheats_for(const TaskDefinition& task, const Scene& scene) {
    const bool jaws = scene.bowel || scene.sheet || scene.septa || scene.bands || scene.objects;
    const bool blade = scene.sheet || scene.septa;
    const bool view = std::any_of(task.gates.begin(), task.gates.end(),
                                  [](const GateSpec& gate) { return gate.metric == "off_screen"; });
    const bool lift = std::any_of(task.goals.begin(), task.goals.end(),
                                  [](const Goal& goal) { return goal.kind == GoalKind::lift_and_hold; });
    std::vector<const Cheat*> chosen;
    for (const Cheat& cheat : cheats()) {
        const bool fits = cheat.site == CheatSite::any || (cheat.site == CheatSite::jaws && jaws) ||
                          (cheat.site == CheatSite::blade && blade) ||
                          (cheat.site == CheatSite::sheet && scene.sheet) ||
                          (cheat.site == CheatSite::septa && scene.septa) ||
                          (cheat.site == CheatSite::energy && scene.field() != nullptr) ||
                          (cheat.site == CheatSite::bands && scene.bands) ||
                          (cheat.site == CheatSite::hands && !scene.instruments.empty()) ||
                          (cheat.site == CheatSite::scope && scene.instruments.empty()) ||
                          (cheat.site == CheatSite::view && view && !scene.instruments.empty()) ||
                          (cheat.site == CheatSite::lift && lift);
        if (fits) chosen.push_back(&cheat);
    }
    return chosen;
}

std::unique_ptr<CheatingRig> make_cheat(const Cheat& cheat, const TaskDefinition& task, const Scene& scene,
                                        std::uint64_t seed) {
    Skill skill;
    draw_individual(OperatorLevel::expert, seed, skill);
    draw_form(OperatorLevel::expert, seed, skill);
    if (cheat.skill != nullptr) cheat.skill(skill);
    return std::make_unique<Cheater>(cheat, make_operator(skill, task, scene, seed), scene);
}

}  // namespace fulcrum
