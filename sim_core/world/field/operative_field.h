// SPDX-License-Identifier: Apache-2.0
// What instruments find that are exchanged for one another: a bed on which blood lies, nerves, vessels that
// are open, heat in all of it, smoke above. Bands (B3) and a wall with its veins (C4) add what they divide.
// World thread. Nothing allocates after construction.
//
// Energy goes to what is nearest to the blade (reach_*), steam and hot liquid next to it reach nerves and bed
// (spread); a hot blade heats what it touches (touch*). A step: begin_step, each hand, step_heat, what the
// owner does with the heat, seal_outlets, bleed, end_step.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "sim_core/bleeding/vessel.h"
#include "sim_core/collision/cavity.h"
#include "sim_core/energy/energy_tool.h"
#include "sim_core/energy/heat.h"
#include "sim_core/instrument/tick_output.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/field/field_bed.h"
#include "sim_core/world/part/field_view.h"
#include "sim_core/world/part/jaws.h"
#include "sim_core/world/part/state_list.h"

namespace fulcrum {

/// Nerves, bed and vessels of a field and what they are as heat patches. Constant for an attempt.
struct FieldModel {
    struct Nerve {
        std::vector<Vector3> line;  ///< m
        std::size_t first = 0;      ///< heat patch of its first point
    };
    FieldBed bed;
    const CavityModel* wall =
        nullptr;  ///< what instruments feel of a bed that is not level; null: level cells
    HeatModel heat;
    std::size_t first_bed = 0;  ///< heat patch of the bed's first cell
    std::vector<Nerve> nerves;
    std::vector<VesselModel> vessels;  ///< what outlets bleed from
};

/// Tissue as heat patches and links: volumes, surfaces to the gas and sections to what they are.
class FieldHeat {
  public:
    FieldHeat(const FieldSpec& spec, HeatModel& model) : spec_(spec), model_(model) {}
    /// A patch of `volume` m3 with `surface` m2 to the gas; returns its number.
    std::int32_t patch(double volume, double surface);
    /// Conduction through `area` m2 over `distance` m; returns the link's number.
    std::int32_t link(std::int32_t a, std::int32_t b, double area, double distance);
    /// A patch for each cell of the bed, linked to its neighbours; returns the first.
    std::size_t bed(const FieldBed& bed);
    /// A patch for each point of a nerve, linked along it and to the bed, which is above(point) m beneath;
    /// returns the first.
    std::size_t nerve(const std::vector<Vector3>& line, const FieldBed& bed, std::size_t first_bed,
                      const std::function<double(const Vector3&)>& above);

  private:
    const FieldSpec& spec_;
    HeatModel& model_;
};

/// A place where a vessel can bleed.
struct FieldOutlet {
    BleedState bleed;
    std::int32_t vessel = 0;  ///< in FieldModel::vessels
    bool opened = false, injured = false;
    bool exposed = false;                ///< clips and energy reach it
    Vector3 position = Vector3::Zero();  ///< m
    std::size_t patch = 0;               ///< heat patch around it
};

/// What a hand's exchangeable instrument is and does.
struct FieldHand {
    std::shared_ptr<const InstrumentSpec> instrument;  ///< as the scene has it; null: no such hand
    std::array<InstrumentKind, 6> kinds{};
    int kind_count = 1, index = 0;
    double exchange_left = 0;   ///< s
    std::uint16_t buttons = 0;  ///< of the last tick
    Jaws jaws;
    bool active = false;
    EnergyTarget target = EnergyTarget::nothing;
    double nerve_distance = 1;  ///< m
    std::int32_t clips_fired = 0, last_clip_outlet = -1;
    double last_clip_distance = 0;  ///< m
    BladeState blade;
    std::array<std::int32_t, 16> touched{};  ///< heat patches that the blade touches
    int touched_count = 0;
    Vector3 last_tip = Vector3::Zero();  ///< m, where a blade was; means something while `cutting`
    bool cutting = false;                ///< a blade in the last step
    InstrumentKind kind() const { return kinds[static_cast<std::size_t>(index)]; }
    bool usable() const { return exchange_left <= 0; }
    /// All that changes: what the hand can hold does not.
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(index, exchange_left, buttons, jaws, active, target, nerve_distance, clips_fired,
              last_clip_outlet, last_clip_distance, blade, touched, touched_count, last_tip, cutting);
    }
};

/// What the power of an activation goes to: the nearest of what is offered within reach.
struct EnergyReach {
    double least;           ///< m
    std::size_t patch = 0;  ///< meaningful with a target
    double share = 1;       ///< of the power that gets there through blood
    EnergyTarget target = EnergyTarget::nothing;
    std::int32_t item = -1;  ///< the owner's number of it
    bool take(double distance, std::size_t to, EnergyTarget kind, std::int32_t number = -1) noexcept {
        if (!(distance < least)) return false;
        least = distance;
        patch = to;
        target = kind;
        item = number;
        return true;
    }
};

class OperativeField {
  public:
    OperativeField(const Scene& scene, const FieldSpec& spec, FieldModel model, std::size_t outlets);

    const FieldModel& model() const { return model_; }
    const HeatState& heat() const { return heat_; }
    const PoolState& pool() const { return pool_; }
    /// m, from the bed to a place, > 0 above it; 1 where it is far.
    double above_bed(const Vector3& place) const noexcept;
    double temperature(std::size_t patch) const { return model_.heat.body_temperature + heat_.rise[patch]; }
    double power(std::size_t patch) const { return inputs_.power[patch]; }
    bool divided(std::size_t nerve) const { return nerve_divided_[nerve] != 0; }
    FieldHand& hand(int number) { return hands_[static_cast<std::size_t>(number)]; }
    const FieldHand& hand(int number) const { return hands_[static_cast<std::size_t>(number)]; }
    /// The scene's instrument of a hand, of the kind that the hand has now; the hand has one.
    const InstrumentSpec& instrument(int number) const {
        const auto h = static_cast<std::size_t>(number);
        return instruments_[h][static_cast<std::size_t>(hands_[h].index)];
    }
    std::vector<FieldOutlet>& outlets() { return outlets_; }
    const std::vector<FieldOutlet>& outlets() const { return outlets_; }
    const EnergyToolModel& tool_model(const FieldHand& hand) const {
        return type_of(hand.kind()).energy == InstrumentEnergy::monopolar ? hook_ : shears_;
    }

    void begin_step() noexcept;
    /// A link that conducts no longer.
    void part_link(std::int32_t link) noexcept { heat_.parted[static_cast<std::size_t>(link)] = 1; }
    // A hand's step.
    /// Asks for the next instrument; not while its jaws hold something.
    void exchange(int number, const TickOutput* outputs, std::size_t count, bool holds, double dt) noexcept;
    /// Forgets what the hand did in the last step.
    void clear(FieldHand& hand) noexcept;
    /// Share of the ticks in which the pedal is down.
    static double pedal(int number, const TickOutput* outputs, std::size_t count) noexcept;
    /// Jaws of the instrument that the hand has; closed on nothing while it is exchanged.
    static JawAction step_jaws(FieldHand& hand, const ToolKinematics& tool) noexcept;
    /// On the nearest outlet within reach; true if there is one. `least` (m) is how near.
    bool fire_clip(FieldHand& hand, const ToolKinematics& tool, double& least) noexcept;
    bool clips_left() const { return clips_left_ > 0; }
    void suck(const ToolKinematics& tool, double dt) noexcept;
    void measure_nerves(FieldHand& hand, const ToolKinematics& tool) noexcept;
    /// Whether a hand cuts: scissors and hook with the primary button held, the hook under power too.
    bool is_blade(const FieldHand& hand, const ToolKinematics& tool, bool energised) const noexcept;
    /// The way of a blade since the last step; nerves that it crosses are divided.
    void divide_nerves(int number, const ToolKinematics& tool, bool energised) noexcept;

    EnergyReach reach_outlets(const FieldHand& hand, const ToolKinematics& tool) const noexcept;
    void reach_nerves_and_bed(const FieldHand& hand, const ToolKinematics& tool,
                              EnergyReach& reach) const noexcept;
    /// The power of an activation (W) to what it reaches; the hand's target is reported.
    void give(FieldHand& hand, const EnergyReach& reach, double watts) noexcept;
    void heat_patch(std::size_t patch, double watts) noexcept { inputs_.power[patch] += watts; }
    void spread(const FieldHand& hand, const ToolKinematics& tool, double duty) noexcept;
    /// What a hot blade heats; a cold one nothing.
    void touch(FieldHand& hand, std::size_t patch) noexcept;
    void touch_nerves_and_bed(FieldHand& hand, const ToolKinematics& tool) noexcept;

    // After the hands.
    HeatReport step_heat(double dt) noexcept;
    /// A vessel's wall at that temperature closes: share of it that is sealed, 0 .. 1.
    void seal(double& share, double degrees, double dt) const noexcept;
    void seal_outlets(double dt) noexcept;
    void bleed(double dt) noexcept;
    void end_step(double steam, double dt) noexcept;

    void size_view(FieldView& view) const;
    void fill_view(FieldView& view) const noexcept;
    /// Heat, blood, smoke, outlets, nerves, hands. owner(hash, hand): what the owner adds of a hand, behind
    /// its instrument.
    template <typename Owner>
    void list_state(StateList& list, Owner&& owner);
    std::size_t model_bytes() const;

  private:
    FieldSpec spec_;
    FieldModel model_;
    EnergyToolModel shears_ = harmonic_shears(), hook_ = monopolar_hook();
    SmokeModel smoke_model_;
    HeatState heat_;
    HeatInputs inputs_;
    HeatScratch scratch_;
    PoolState pool_;
    SmokeState smoke_;
    std::vector<FieldOutlet> outlets_;
    std::vector<std::uint8_t> nerve_divided_;
    std::array<FieldHand, hand_count> hands_;
    std::array<std::array<InstrumentSpec, 6>, hand_count>
        instruments_;  ///< the scene's, of each kind in turn
    bool suction_ = false;
    std::int32_t clips_left_ = 0;
};

template <typename Owner>
void OperativeField::list_state(StateList& list, Owner&& owner) {
    list.hashed(heat_.rise).hashed(heat_.dose);
    list.kept(heat_.water).kept(heat_.damage).kept(heat_.parted);
    list.kept(heat_.given).kept(heat_.perfused).kept(heat_.boiled);
    list.hashed(pool_.depth).kept(pool_.poured).kept(pool_.removed);
    list.hashed(outlets_, [this](StateHash& hash) {
        for (const FieldOutlet& outlet : outlets_) {
            hash.add(outlet.bleed.lost);
            hash.add(open_share(outlet.bleed));
        }
    });
    list.hashed(smoke_.mass);
    list.hashed(hands_, [this, &owner](StateHash& hash) {
        for (std::size_t number = 0; number < hands_.size(); ++number) {
            const FieldHand& hand = hands_[number];
            hash.add(static_cast<std::int64_t>(hand.index));
            owner(hash, number);
            hash.add(hand.exchange_left);
            hash.add(hand.blade.rise);
        }
    });
    list.kept(nerve_divided_).kept(clips_left_);
}

/// m from the blade (heel to tip) to a point.
double distance_to_blade(const FieldHand& hand, const ToolKinematics& tool, const Vector3& point) noexcept;

/// How energy reaches tissue next to the blade; shared by what owns a field.
namespace field_rules {
inline constexpr double touch_reach = 0.003;   // m, from the tip to what energy reaches without jaws
inline constexpr double contact_gap = 0.0005;  // m, blade to a patch that it touches
inline constexpr double clip_reach = 0.006;    // m
inline constexpr double spread_power = 1.2;    // W at the blade's surface: hot steam next to it; provisional
inline constexpr double spread_length = 0.0015;  // m, in which that falls to 1/e; provisional
inline constexpr double spread_reach = 0.008;    // m
inline constexpr double coagulation_start = 55,
                        coagulation_full =
                            90;  // degrees C, where a vessel's wall fuses, and at full pace; provisional
inline constexpr double blade_half = 0.0003;  // m, half of a cutting edge's width
}  // namespace field_rules

}  // namespace fulcrum
