// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/bands/bands_part.h"

#include <algorithm>
#include <cmath>

#include "sim_core/contact/series_stiffness.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double tear_delay = 0.010;  // s of tension above the tear force
constexpr double least_seal = 0.5;    // of a vessel that is divided: less is an injury

}  // namespace

BandsPart::BandsPart(const Scene& scene, std::uint64_t seed)
    : spec_(*scene.bands),
      layout_(place_bands(spec_, seed)),
      bed_(bed_mesh(spec_), FreeSide::front),
      field_(scene, spec_, make_bands_field(spec_, layout_, patches_), 2 * layout_.vessel_bands.size()) {
    const double section = spec_.width * spec_.thickness, segment = spec_.length / strand_segments;
    strand_model_.rest_length = segment / (1 + spec_.pre_strain);
    strand_model_.stiffness = spec_.young_modulus * section / strand_model_.rest_length;
    strand_model_.node_mass = spec_.density * section * segment;
    strand_model_.gravity = scene.gravity;
    tissue_index_ = static_cast<std::int16_t>(scene.tissue_index(spec_.tissue));
    tissue_ = scene.tissues[static_cast<std::size_t>(tissue_index_)];

    for (const BandPlace& place : layout_.bands) strands_.push_back(make_strand_state(place.root, place.end));
    overload_time_.assign(strands_.size(), 0.0);
    torn_.assign(strands_.size(), 0);
    clips_.assign(strands_.size(), 0);
    parted_at_.assign(strands_.size(), -1);
    parted_tension_.assign(strands_.size(), 0.0);
    progress_.assign(strands_.size() * strand_segments, 0.0);
    sealed_.assign(strands_.size() * strand_segments, 0.0);
    place_outlets();
}

void BandsPart::apply(const StepInput& input) noexcept {
    field_.begin_step();
    for (int number = 0; number < hand_count; ++number) {
        if (field_.hand(number).instrument != nullptr) step_tool(number, input);
    }
}

std::uint32_t BandsPart::solve(const StepInput& input) noexcept {
    const double dt = input.dt;
    step_strands(dt);
    place_outlets();
    const HeatReport heat = field_.step_heat(dt);
    part_heated(dt);
    place_outlets();
    field_.bleed(dt);
    field_.end_step(heat.steam, dt);
    return 0;
}

void BandsPart::step_strands(double dt) noexcept {
    for (std::size_t b = 0; b < strands_.size(); ++b) {
        StrandHold holds[hand_count];
        for (int number = 0; number < hand_count; ++number) {
            const Grip& grip = grips_[static_cast<std::size_t>(number)];
            if (grip.band == static_cast<std::int32_t>(b)) holds[number] = grip.hold;
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
    const double warm = field_rules::coagulation_start - field_.model().heat.body_temperature;
    for (std::size_t i = 0; i < sealed_.size(); ++i) {
        if (field_.heat().rise[i] > warm) field_.seal(sealed_[i], field_.temperature(i), dt);
    }
    field_.seal_outlets(dt);
    for (std::size_t b = 0; b < strands_.size(); ++b) divide_heated(b, dt);
}

bool BandsPart::energises(int number, std::size_t band) const noexcept {
    const FieldHand& hand = field_.hand(number);
    return hand.instrument != nullptr && hand.active && hand.target == EnergyTarget::band &&
           grips_[static_cast<std::size_t>(number)].touched == static_cast<std::int32_t>(band);
}

// A hand divides only the segments that its own power goes to. Where that of both goes to one, its
// temperature has both powers already: the instrument that divides faster counts, not the sum.
void BandsPart::divide_heated(std::size_t band, double dt) noexcept {
    bool energised = false;
    for (int number = 0; number < hand_count; ++number) energised = energised || energises(number, band);
    if (!energised) return;
    for (int s = 0; s < strand_segments; ++s) {
        if (strands_[band].is_parted(s)) continue;
        const std::size_t patch = segment_patch(band, s);
        double rate = 0;
        for (int number = 0; number < hand_count; ++number) {
            const Grip& grip = grips_[static_cast<std::size_t>(number)];
            if (!energises(number, band) || (grip.heated >> static_cast<unsigned>(s) & 1U) == 0) continue;
            rate = std::max(rate,
                            division_rate(field_.tool_model(field_.hand(number)), field_.temperature(patch),
                                          strand_tension(strand_model_, strands_[band], s)));
        }
        progress_[patch] += rate * dt;
    }
    for (int s = 0; s < strand_segments; ++s) {
        if (progress_[segment_patch(band, s)] < 1 || strands_[band].is_parted(s)) continue;
        part(band, s, false);
        break;
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
        field_.part_link(patches_.segment_links[band * (strand_segments - 1) + static_cast<std::size_t>(s)]);
    }
    overload_time_[band] = 0;
    const bool first = parted_at_[band] < 0;
    if (!first && segment > parted_at_[band]) return;  // of a piece that came off
    parted_at_[band] = segment;
    open_trunk(band, segment, torn);
    if (!first) return;  // the branch tore at the first cut
    parted_tension_[band] = tension;
    torn_[band] = torn ? 1 : 0;
    open_branch(band, tension);
}

void BandsPart::open_trunk(std::size_t band, int segment, bool torn) noexcept {
    const std::int32_t number = trunk_of(band);
    if (number < 0) return;
    FieldOutlet& trunk = field_.outlets()[static_cast<std::size_t>(number)];
    open_vessel(1.0, trunk.bleed);
    trunk.bleed.sealed = sealed_[segment_patch(band, segment)];
    const std::uint32_t up_to_the_cut = (2U << static_cast<unsigned>(segment)) - 1;  // nodes
    trunk.bleed.clipped = (clips_[band] & up_to_the_cut) != 0;
    const bool closed = trunk.bleed.clipped || (!torn && trunk.bleed.sealed >= least_seal);
    trunk.injured = trunk.injured || !closed;
    trunk.opened = true;
}

void BandsPart::open_branch(std::size_t band, double tension) noexcept {
    const std::int32_t trunk = trunk_of(band);
    if (trunk < 0) return;
    FieldOutlet& branch = field_.outlets()[static_cast<std::size_t>(trunk) + 1];
    const double before = branch.bleed.sealed;  // heat that came before closes what would tear
    const double recoil = std::clamp(tension / spec_.recoil_tension, 0.0, 1.0);
    open_vessel(spec_.least_recoil + (1 - spec_.least_recoil) * recoil, branch.bleed);
    branch.bleed.sealed = before;
    branch.opened = true;
}

void BandsPart::place_outlets() noexcept {
    for (std::size_t i = 0; i < field_.outlets().size(); ++i) {
        FieldOutlet& outlet = field_.outlets()[i];
        const std::size_t b = outlet_band(i);
        if (is_trunk(i)) {
            const int at = parted_at_[b] >= 0 ? parted_at_[b] : strand_segments / 2;
            outlet.position = strands_[b].position[static_cast<std::size_t>(at)];
            outlet.patch = segment_patch(b, std::max(0, parted_at_[b] - 1));
            outlet.exposed = outlet.opened;  // whole: what reaches it there reaches the band
        } else {
            outlet.position = layout_.bands[b].vessel_root;
            outlet.patch = patches_.roots + i / 2;
            outlet.exposed = true;
        }
    }
}

void BandsPart::publish_model(int number, const TickOutput& /*last*/, LocalModel& model) noexcept {
    const FieldHand& hand = field_.hand(number);
    const Grip& grip = grips_[static_cast<std::size_t>(number)];
    model.energises = hand.usable() && gives_energy(hand.kind());
    if (grip.band < 0) return;
    const StrandState& strand = strands_[static_cast<std::size_t>(grip.band)];
    model.mode = LocalMode::grasp;
    model.grasp = GraspModel();
    hand.jaws.fill(model.grasp);
    model.grasp.reaction = hold_force(grip.hold, strand);
    // The chain on either side, in series with the pinched tissue.
    double chains = 0;
    for (const int direction : {-1, 1}) {
        int length = 0;
        for (int s = direction < 0 ? grip.hold.node - 1 : grip.hold.node; s >= 0 && s < strand_segments;
             s += direction) {
            if (strand.is_parted(s)) {
                length = 0;
                break;
            }
            ++length;
        }
        if (length > 0) chains += strand_model_.stiffness / length;
    }
    model.grasp.stiffness = stiffness_in_series(chains * Matrix3::Identity(), grip.hold.stiffness);
    model.grasp.damping = tissue_.damping;
    model.grasp.friction = tissue_.friction;
    model.grasp.tissue = tissue_index_;
    model.grasp.tissue_patch = static_cast<std::int16_t>(grip.band);
}

void BandsPart::size_snapshot(WorldSnapshot& snapshot) const {
    snapshot.bands.bands.resize(strands_.size());
    snapshot.field.resize(1);
    FieldView& view = snapshot.field[0];
    field_.size_view(view);
    for (std::size_t i = 0; i < view.outlets.size(); ++i)
        view.outlets[i].band = static_cast<std::int32_t>(outlet_band(i));
}

void BandsPart::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    for (std::size_t b = 0; b < strands_.size(); ++b) {
        BandView& band = snapshot.bands.bands[b];
        band.position = strands_[b].position;
        band.parted = strands_[b].parted;
        band.torn = torn_[b] != 0;
        band.vessel = layout_.bands[b].vessel;
        band.clips = clips_[b];
        double tension = 0;
        for (int s = 0; s < strand_segments; ++s) {
            const auto k = static_cast<std::size_t>(s);
            const std::size_t patch = segment_patch(b, s);
            band.heat[k] = static_cast<float>(field_.temperature(patch));
            const double water = field_.model().heat.patches[patch].water;
            band.char_share[k] =
                water > 0 ? static_cast<float>(1 - field_.heat().water[patch] / water) : 0.0F;
            band.coagulated[k] = static_cast<float>(coagulated_share(field_.heat().damage[patch]));
            tension = std::max(tension, strand_tension(strand_model_, strands_[b], s));
        }
        band.tension = static_cast<float>(tension);
        band.parted_tension = static_cast<float>(parted_tension_[b]);
    }
    FieldView& view = snapshot.field[0];
    field_.fill_view(view);
    for (int number = 0; number < hand_count; ++number) {
        const Grip& grip = grips_[static_cast<std::size_t>(number)];
        view.tools[number].band = grip.band >= 0 ? grip.band : grip.touched;
    }
}

GraspState BandsPart::grasp(int number) const noexcept {
    const Grip& grip = grips_[static_cast<std::size_t>(number)];
    const StrandState& strand = strands_[static_cast<std::size_t>(grip.band)];
    GraspState grasp;
    grasp.body = HeldBody::band;
    grasp.tissue = static_cast<std::int8_t>(tissue_index_);
    grasp.arc_length = grip.hold.node * spec_.length / strand_segments;
    grasp.point = strand.position[static_cast<std::size_t>(grip.hold.node)];
    grasp.patch = grip.band;
    grasp.reaction = hold_force(grip.hold, strand);
    return grasp;
}

void BandsPart::list_state(StateList& list) {
    list.hashed(strands_, [this](StateHash& hash) {
        for (const StrandState& strand : strands_) {
            for (const Vector3& position : strand.position) hash.add(position);
            hash.add(static_cast<std::int64_t>(strand.parted));
        }
    });
    field_.list_state(list, [this](StateHash& hash, std::size_t hand) {
        hash.add(static_cast<std::int64_t>(grips_[hand].band));
    });
    list.kept(grips_).kept(overload_time_).kept(torn_).kept(clips_);
    list.kept(progress_).kept(sealed_).kept(parted_tension_).kept(parted_at_);
}

void BandsPart::add_costs(double us, std::vector<PartCost>& costs) const {
    costs.push_back({"cavity", 0, bed_.bytes()});
    costs.push_back(
        {"bands", us,
         sizeof(*this) + strands_.size() * sizeof(BandPlace) + field_.model_bytes() + state_bytes()});
}

std::unique_ptr<Part> build_bands_part(const Scene& scene, std::uint64_t seed, const PartList& /*parts*/) {
    return scene.bands ? std::make_unique<BandsPart>(scene, seed) : nullptr;
}

}  // namespace fulcrum
