// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/bands_part.h"

#include <algorithm>
#include <cmath>

#include "sim_core/contact/series_stiffness.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double tear_delay = 0.010;  // s of tension above the tear force
constexpr double coagulation_start = 55,
                 coagulation_full =
                     90;            // degrees C, where a vessel's wall fuses, and at full pace; provisional
constexpr double least_seal = 0.5;  // of a vessel that is divided: less is an injury
constexpr double visible_flow = 1e-6 / 60;  // m3/s: 1 mL/min, from where an opening counts as bleeding

}  // namespace

ToolKind tool_kind(const std::string& word) noexcept {
    for (const ToolKind kind :
         {ToolKind::grasper, ToolKind::harmonic, ToolKind::hook, ToolKind::clip_applier, ToolKind::suction}) {
        if (word == tool_kind_name(kind)) return kind;
    }
    return ToolKind::probe;
}

const char* tool_kind_name(ToolKind kind) noexcept {
    switch (kind) {
        case ToolKind::grasper:
            return "grasper";
        case ToolKind::probe:
            return "probe";
        case ToolKind::harmonic:
            return "harmonic";
        case ToolKind::hook:
            return "hook";
        case ToolKind::clip_applier:
            return "clip_applier";
        case ToolKind::suction:
            return "suction";
    }
    return "probe";
}

BandsPart::BandsPart(const Scene& scene, std::uint64_t seed)
    : spec_(*scene.bands), layout_(place_bands(spec_, seed)), heat_(make_bands_heat(spec_, layout_)) {
    const double section = spec_.width * spec_.thickness, segment = spec_.length / strand_segments;
    strand_model_.rest_length = segment / (1 + spec_.pre_strain);
    strand_model_.stiffness = spec_.young_modulus * section / strand_model_.rest_length;
    strand_model_.node_mass = spec_.density * section * segment;
    strand_model_.gravity = scene.gravity;
    vessel_.radius = spec_.vessel_radius;
    vessel_.pressure = spec_.vessel_pressure;
    vessel_.feeding_length = spec_.feeding_length;
    vessel_.clotting_time = spec_.clotting_time;
    tissue_index_ = static_cast<std::int16_t>(scene.tissue_index(spec_.tissue));
    tissue_ = scene.tissues[static_cast<std::size_t>(tissue_index_)];

    for (const BandPlace& place : layout_.bands) strands_.push_back(make_strand_state(place.root, place.end));
    overload_time_.assign(strands_.size(), 0.0);
    torn_.assign(strands_.size(), 0);
    clip_nodes_.assign(strands_.size(), -1);
    parted_at_.assign(strands_.size(), -1);
    parted_tension_.assign(strands_.size(), 0.0);
    progress_.assign(strands_.size() * strand_segments, 0.0);
    sealed_.assign(strands_.size() * strand_segments, 0.0);
    for (std::size_t v = 0; v < layout_.vessel_bands.size(); ++v) {
        for (const bool trunk : {true, false}) {
            Outlet outlet;
            outlet.band = layout_.vessel_bands[v];
            outlet.vessel = static_cast<std::int32_t>(v);
            outlet.trunk = trunk;
            outlets_.push_back(outlet);
        }
    }
    heat_state_ = make_heat_state(heat_.model);
    heat_inputs_ = make_heat_inputs(heat_.model);
    heat_scratch_ = make_heat_scratch(heat_.model);
    pool_ = make_pool_state(layout_.bed.pool);
    clips_left_ = spec_.clips;
    for (const InstrumentSpec& spec : scene.instruments) {
        HandTool& hand = hands_[static_cast<int>(spec.hand)];
        hand.kinds[0] = tool_kind(spec.kind);
        hand.kind_count =
            std::clamp(static_cast<int>(spec.exchange.size()), 1, static_cast<int>(hand.kinds.size()));
        for (std::size_t i = 0; i < spec.exchange.size() && i < hand.kinds.size(); ++i)
            hand.kinds[i] = tool_kind(spec.exchange[i]);
    }
    // The specs of the scene that the world keeps live as long as this part does.
    for (const InstrumentSpec& spec : scene.instruments)
        hands_[static_cast<int>(spec.hand)].instrument = &spec;
}

std::uint32_t BandsPart::step(const TickOutput* outputs, std::size_t count, double dt) noexcept {
    std::fill(heat_inputs_.power.begin(), heat_inputs_.power.end(), 0.0);
    std::fill(heat_inputs_.contact.begin(), heat_inputs_.contact.end(), 0.0);
    std::fill(heat_inputs_.contact_rise.begin(), heat_inputs_.contact_rise.end(), 0.0);
    suction_ = false;
    for (int number = 0; number < hand_count; ++number) {
        if (hands_[number].instrument != nullptr) step_tool(hands_[number], outputs, count, number, dt);
    }
    step_strands(dt);
    const HeatReport heat = step_heat(heat_.model, heat_inputs_, dt, heat_state_, heat_scratch_);
    for (HandTool& hand : hands_) {
        if (hand.instrument == nullptr || !gives_energy(hand.kind())) continue;
        const EnergyToolModel& model = hand.kind() == ToolKind::hook ? hook_ : shears_;
        double given = 0;
        for (int i = 0; i < hand.touched_count; ++i) {
            const auto patch = static_cast<std::size_t>(hand.touched[static_cast<std::size_t>(i)]);
            given += model.blade_contact * (hand.blade.rise - heat_state_.rise[patch]) * dt;
        }
        step_blade(model, hand.active, given, dt, hand.blade);
    }
    part_heated(dt);
    bleed(dt);
    step_smoke(smoke_model_, heat.steam, suction_, dt, smoke_);
    return 0;
}

void BandsPart::step_strands(double dt) noexcept {
    for (std::size_t b = 0; b < strands_.size(); ++b) {
        StrandHold holds[hand_count];
        for (int number = 0; number < hand_count; ++number) {
            if (hands_[number].band == static_cast<std::int32_t>(b)) holds[number] = hands_[number].hold;
        }
        step_strand(strand_model_, holds, dt, strands_[b]);
        double largest = 0;
        int weakest = -1;
        for (int s = 0; s < strand_segments; ++s) {
            const double tension = strand_tension(strand_model_, strands_[b], s);
            if (tension <= largest) continue;
            largest = tension;
            weakest = s;
        }
        overload_time_[b] = largest > spec_.tear_force ? overload_time_[b] + dt : 0.0;
        if (overload_time_[b] > tear_delay && weakest >= 0) part(b, weakest, true);
    }
}

// Heat divides what is held or touched, and closes the vessels it passes through.
void BandsPart::part_heated(double dt) noexcept {
    const auto hot = [](double degrees) {
        return std::clamp((degrees - coagulation_start) / (coagulation_full - coagulation_start), 0.0, 1.0);
    };
    const auto seal = [&](double& share, double degrees) {
        share = 1 - (1 - share) * math::exp(-hot(degrees) * dt / spec_.seal_time);
    };
    for (std::size_t i = 0; i < sealed_.size(); ++i) {
        if (heat_state_.rise[i] > coagulation_start - heat_.model.body_temperature)
            seal(sealed_[i], temperature(i));
    }
    for (Outlet& outlet : outlets_) {
        const double degrees = temperature(outlet_patch(outlet));
        if (outlet.opened || !outlet.trunk) seal(outlet.bleed.sealed, degrees);
    }
    for (const HandTool& hand : hands_) {
        if (hand.instrument == nullptr || !hand.active || hand.touched_band < 0 ||
            hand.target != EnergyTarget::band)
            continue;
        const EnergyToolModel& model = hand.kind() == ToolKind::hook ? hook_ : shears_;
        const auto b = static_cast<std::size_t>(hand.touched_band);
        for (int s = 0; s < strand_segments; ++s) {
            const std::size_t patch = segment_patch(b, s);
            if (heat_inputs_.power[patch] <= 0 || strands_[b].is_parted(s)) continue;
            progress_[patch] +=
                division_rate(model, temperature(patch), strand_tension(strand_model_, strands_[b], s)) * dt;
        }
        for (int s = 0; s < strand_segments; ++s) {
            if (progress_[segment_patch(b, s)] < 1 || strands_[b].is_parted(s)) continue;
            part(b, s, false);
            break;
        }
    }
}

void BandsPart::part(std::size_t band, int segment, bool torn) noexcept {
    StrandState& strand = strands_[band];
    if (strand.is_parted(segment)) return;
    double tension = 0;
    for (int s = 0; s < strand_segments; ++s)
        tension = std::max(tension, strand_tension(strand_model_, strand, s));
    strand.parted |= 1U << static_cast<unsigned>(segment);
    for (const int s : {segment - 1, segment}) {
        if (s < 0 || s + 1 >= strand_segments) continue;
        const auto link = static_cast<std::size_t>(
            heat_.segment_links[band * (strand_segments - 1) + static_cast<std::size_t>(s)]);
        heat_state_.parted[link] = 1;
    }
    overload_time_[band] = 0;
    if (parted_at_[band] >= 0) return;  // a second cut of what is divided already
    parted_at_[band] = segment;
    parted_tension_[band] = tension;
    torn_[band] = torn ? 1 : 0;
    for (Outlet& outlet : outlets_) {
        if (outlet.band != static_cast<std::int32_t>(band)) continue;
        const double before = outlet.bleed.sealed;  // heat that came before closes what would tear
        if (outlet.trunk) {
            open_vessel(1.0, outlet.bleed);
            outlet.bleed.sealed = sealed_[segment_patch(band, segment)];
            outlet.bleed.clipped = clip_nodes_[band] >= 0 && clip_nodes_[band] <= segment;
            outlet.injured = !outlet.bleed.clipped && (torn || outlet.bleed.sealed < least_seal);
        } else {
            const double recoil = std::clamp(tension / spec_.recoil_tension, 0.0, 1.0);
            open_vessel(spec_.least_recoil + (1 - spec_.least_recoil) * recoil, outlet.bleed);
            outlet.bleed.sealed = before;
        }
        outlet.opened = true;
    }
}

void BandsPart::bleed(double dt) noexcept {
    for (Outlet& outlet : outlets_) {
        if (!outlet.opened) continue;
        const double lost = step_bleed(vessel_, dt, outlet.bleed);
        const Vector3 place = outlet_position(outlet);
        pour(layout_.bed.pool, layout_.bed.column(place), layout_.bed.row(place), lost, pool_);
    }
    step_pool(layout_.bed.pool, dt, pool_);
}

Vector3 BandsPart::outlet_position(const Outlet& outlet) const noexcept {
    const auto b = static_cast<std::size_t>(outlet.band);
    if (!outlet.trunk) return layout_.bands[b].vessel_root;
    const int at = parted_at_[b] >= 0 ? parted_at_[b] : strand_segments / 2;
    return strands_[b].position[static_cast<std::size_t>(at)];
}

std::size_t BandsPart::outlet_patch(const Outlet& outlet) const noexcept {
    if (!outlet.trunk) return heat_.roots + static_cast<std::size_t>(outlet.vessel);
    const auto b = static_cast<std::size_t>(outlet.band);
    return segment_patch(b, std::max(0, parted_at_[b] - 1));
}

void BandsPart::fill_local_model(Hand number, LocalModel& model) const noexcept {
    const HandTool& hand = hands_[static_cast<int>(number)];
    model.energises = hand.usable() && gives_energy(hand.kind());
    if (hand.band < 0) return;
    const StrandState& strand = strands_[static_cast<std::size_t>(hand.band)];
    model.mode = LocalMode::grasp;
    model.grasp = GraspModel();
    model.grasp.point = hand.hold.target - hand.correction;
    model.grasp.velocity = hand.target_velocity;
    model.grasp.reaction = hold_force(hand.hold, strand);
    model.grasp.hold_offset = hand.hold_offset;
    // The chain on either side, in series with the pinched tissue.
    double chains = 0;
    for (const int direction : {-1, 1}) {
        int length = 0;
        for (int s = direction < 0 ? hand.hold.node - 1 : hand.hold.node; s >= 0 && s < strand_segments;
             s += direction) {
            if (strand.is_parted(s)) {
                length = 0;
                break;
            }
            ++length;
        }
        if (length > 0) chains += strand_model_.stiffness / length;
    }
    model.grasp.stiffness = stiffness_in_series(chains * Matrix3::Identity(), hand.hold.stiffness);
    model.grasp.damping = tissue_.damping;
    model.grasp.friction = tissue_.friction;
    model.grasp.area = spec_.width * std::min(hand.instrument->jaw_length, 0.004);
    model.grasp.tissue = tissue_index_;
    model.grasp.tissue_patch = static_cast<std::int16_t>(hand.band);
}

void BandsPart::size_snapshot(WorldSnapshot& snapshot) const {
    snapshot.bands.resize(1);
    BandsView& view = snapshot.bands[0];
    view.bands.resize(strands_.size());
    view.outlets.resize(outlets_.size());
    view.nerves.resize(1);
    view.nerves[0].line = layout_.nerve;
    view.nerves[0].dose.assign(layout_.nerve.size(), 0.0F);
    view.nerve_radius = spec_.nerve_radius;
    view.columns = layout_.bed.pool.columns;
    view.rows = layout_.bed.pool.rows;
    view.cell = layout_.bed.pool.cell;
    view.corner = layout_.bed.corner;
    for (const double height : layout_.bed.pool.ground) view.ground.push_back(static_cast<float>(height));
    view.blood.assign(view.ground.size(), 0.0F);
    view.bed_dose.assign(view.ground.size(), 0.0F);
}

void BandsPart::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    BandsView& view = snapshot.bands[0];
    for (std::size_t b = 0; b < strands_.size(); ++b) {
        BandView& band = view.bands[b];
        band.position = strands_[b].position;
        band.parted = strands_[b].parted;
        band.torn = torn_[b] != 0;
        band.vessel = layout_.bands[b].vessel;
        band.clip_node = clip_nodes_[b];
        double tension = 0;
        for (int s = 0; s < strand_segments; ++s) {
            const auto k = static_cast<std::size_t>(s);
            const std::size_t patch = segment_patch(b, s);
            band.heat[k] = static_cast<float>(temperature(patch));
            const double water = heat_.model.patches[patch].water;
            band.char_share[k] = water > 0 ? static_cast<float>(1 - heat_state_.water[patch] / water) : 0.0F;
            band.coagulated[k] = static_cast<float>(coagulated_share(heat_state_.damage[patch]));
            tension = std::max(tension, strand_tension(strand_model_, strands_[b], s));
        }
        band.tension = static_cast<float>(tension);
        band.parted_tension = static_cast<float>(parted_tension_[b]);
    }
    view.lost = 0;
    for (std::size_t i = 0; i < outlets_.size(); ++i) {
        const Outlet& outlet = outlets_[i];
        OutletView& seen = view.outlets[i];
        seen.position = outlet_position(outlet);
        seen.band = outlet.band;
        const double flow = outlet.opened ? bleed_flow(vessel_, outlet.bleed) : 0.0;
        seen.flow = flow >= visible_flow ? flow : 0.0;
        seen.lost = outlet.bleed.lost;
        const std::size_t under = layout_.bed.cell(seen.position);
        seen.blood_depth = static_cast<float>(
            std::max(0.0, layout_.bed.pool.ground[under] + pool_.depth[under] - seen.position.z()));
        seen.opened = outlet.opened;
        seen.clipped = outlet.bleed.clipped;
        seen.injured = outlet.injured;
        view.lost += outlet.bleed.lost;
    }
    view.removed = pool_.removed;
    for (int number = 0; number < hand_count; ++number) {
        const HandTool& hand = hands_[number];
        HandToolView& seen = view.tools[number];
        seen.kind = hand.kind();
        seen.index = hand.index;
        seen.exchange_left = static_cast<float>(hand.exchange_left);
        seen.active = hand.active;
        seen.target = hand.target;
        seen.nerve_distance = static_cast<float>(hand.nerve_distance);
        seen.band = hand.band >= 0 ? hand.band : hand.touched_band;
        seen.blade = static_cast<float>(heat_.model.body_temperature + hand.blade.rise);
        seen.clips_left = clips_left_;
        seen.clips_fired = hand.clips_fired;
        seen.last_clip_outlet = hand.last_clip_outlet;
        seen.last_clip_distance = static_cast<float>(hand.last_clip_distance);
        GraspState& grasp = snapshot.grasps[number];
        grasp.held = hand.band >= 0;
        grasp.slipped = hand.slipped;
        if (hand.band < 0) continue;
        const StrandState& strand = strands_[static_cast<std::size_t>(hand.band)];
        grasp.arc_length = hand.hold.node * spec_.length / strand_segments;
        grasp.point = strand.position[static_cast<std::size_t>(hand.hold.node)];
        grasp.patch = hand.band;
        grasp.reaction = hold_force(hand.hold, strand);
    }
    double worst = 0, lateral = 0;
    for (std::size_t i = 0; i < layout_.nerve.size(); ++i) {
        const double dose = heat_state_.dose[heat_.nerve + i];
        view.nerves[0].dose[i] = static_cast<float>(dose);
        worst = std::max(worst, dose);
    }
    for (std::size_t i = 0; i < view.blood.size(); ++i) {
        view.blood[i] = static_cast<float>(pool_.depth[i]);
        const double dose = heat_state_.dose[heat_.bed + i];
        view.bed_dose[i] = static_cast<float>(dose);
        lateral = std::max(lateral, dose);
    }
    view.worst_nerve_dose = worst;
    view.worst_bed_dose = lateral;
    view.lateral_dose = std::max(worst, lateral);
    view.smoke = 1 - transmission(smoke_model_, smoke_);
    view.heat_given = heat_state_.given;
}

void BandsPart::hash(StateHash& hash) const noexcept {
    for (const StrandState& strand : strands_) {
        for (const Vector3& position : strand.position) hash.add(position);
        hash.add(static_cast<std::int64_t>(strand.parted));
    }
    for (const double rise : heat_state_.rise) hash.add(rise);
    for (const double dose : heat_state_.dose) hash.add(dose);
    for (const double depth : pool_.depth) hash.add(depth);
    for (const Outlet& outlet : outlets_) {
        hash.add(outlet.bleed.lost);
        hash.add(open_share(outlet.bleed));
    }
    hash.add(smoke_.mass);
    for (const HandTool& hand : hands_) {
        hash.add(static_cast<std::int64_t>(hand.index));
        hash.add(static_cast<std::int64_t>(hand.band));
        hash.add(hand.exchange_left);
        hash.add(hand.blade.rise);
    }
}

std::size_t BandsPart::bytes() const {
    const std::size_t patches = heat_.model.patches.size();
    return sizeof(*this) + strands_.size() * (sizeof(StrandState) + sizeof(BandPlace)) +
           outlets_.size() * sizeof(Outlet) + patches * (sizeof(HeatPatch) + 14 * sizeof(double)) +
           heat_.model.links.size() * (sizeof(HeatLink) + 1) + pool_.depth.size() * 2 * sizeof(double);
}

}  // namespace fulcrum
