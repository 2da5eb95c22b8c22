// SPDX-License-Identifier: Apache-2.0
// Instruments on bands: closed on one, activated on it, a clip around it.
#include <algorithm>
#include <cmath>

#include "sim_core/world/parts/bands/bands_part.h"

namespace fulcrum {
namespace {

constexpr double band_in_jaws = 0.004;  // m along the jaws that a band lies across

}  // namespace

void BandsPart::exchange(int number, const StepInput& input, HeldTool& held) noexcept {
    field_.exchange(number, input.outputs, input.count, holds(number), input.dt);
    held.instrument = &field_.instrument(number);
    held.tool.inside = held.tool.inside && field_.hand(number).usable();
}

BandsPart::Reach BandsPart::nearest(const Vector3& place) const noexcept {
    Reach reach;
    double least = Jaws::reach;
    for (std::size_t b = 0; b < strands_.size(); ++b) {
        double distance = 0;
        const int node = nearest_node(strands_[b], place, distance);
        if (node < 0 || !(distance < least)) continue;
        least = distance;
        reach = {static_cast<std::int32_t>(b), std::clamp(node, 1, strand_nodes - 2), distance};
    }
    return reach;
}

double BandsPart::offer(int number, const HeldTool& held) const noexcept {
    if (!type_of(held.instrument->kind).grasps_strands ||
        !field_.hand(number).jaws.closing(held.tool, held.instrument->jaw_opening))
        return no_offer;
    return nearest(held.tool.tip - 0.5 * held.instrument->jaw_length * held.tool.axis).distance;
}

void BandsPart::step_tool(int number, const StepInput& input) noexcept {
    FieldHand& hand = field_.hand(number);
    Grip& grip = grips_[static_cast<std::size_t>(number)];
    const ToolKinematics& tool = input.last().contact[number].tool;
    field_.clear(hand);
    grip.touched = -1;
    grip.heated = 0;
    if (!tool.tip.allFinite()) {
        hand.cutting = false;
        return;
    }
    if (!tool.present) {  // it stays where it was with what it holds, and a blade's path continues from there
        OperativeField::step_jaws(hand, tool);
        return;
    }
    step_jaws(number, tool, input.taker[number] == this, input.dt);
    const double pedal = OperativeField::pedal(number, input.outputs, input.count);
    field_.divide_nerves(number, tool, pedal > 0);
    if (!tool.inside || !hand.usable()) return;
    if (gives_energy(hand.kind())) {
        field_.measure_nerves(hand, tool);
        touch_with_blade(number, tool);
        if (pedal > 0) apply_energy(number, tool, pedal);
    } else if (type_of(hand.kind()).suction && pedal > 0) {
        hand.active = true;
        field_.suck(tool, input.dt);
    }
}

void BandsPart::step_jaws(int number, const ToolKinematics& tool, bool takes, double dt) noexcept {
    FieldHand& hand = field_.hand(number);
    Grip& grip = grips_[static_cast<std::size_t>(number)];
    switch (OperativeField::step_jaws(hand, tool)) {
        case JawAction::none:
            return;
        case JawAction::let_go:
            grip.band = -1;
            grip.hold.node = -1;
            return;
        case JawAction::close:
            if (type_of(hand.kind()).clips)
                fire_clip(number, tool);
            else if (takes)
                take_band(number, tool);
            if (grip.band < 0) return;
            break;  // it follows the jaws from this step on
        case JawAction::hold:
            break;
    }
    const Vector3& tissue =
        strands_[static_cast<std::size_t>(grip.band)].position[static_cast<std::size_t>(grip.hold.node)];
    hand.jaws.carry(tool, {tissue_.stiffness, tissue_.friction}, &tissue, hand.instrument->jaw_length, dt);
    grip.hold.target = hand.jaws.point(0).target;
    grip.hold.stiffness = hand.jaws.stiffness();
    grip.hold.most = hand.jaws.most();
}

void BandsPart::take_band(int number, const ToolKinematics& tool) noexcept {
    FieldHand& hand = field_.hand(number);
    Grip& grip = grips_[static_cast<std::size_t>(number)];
    const Vector3 jaws = tool.tip - 0.5 * hand.instrument->jaw_length * tool.axis;
    const Reach reach = nearest(jaws);
    if (reach.band < 0) return;
    grip.band = reach.band;
    grip.hold.node = reach.node;
    const Vector3 point =
        strands_[static_cast<std::size_t>(grip.band)].position[static_cast<std::size_t>(grip.hold.node)];
    hand.jaws.clear_points();
    hand.jaws.add_point(Vector3(0, 0, -0.5 * hand.instrument->jaw_length), jaws, point);
    hand.jaws.take(tool, {tissue_.stiffness, tissue_.friction},
                   spec_.width * std::min(hand.instrument->jaw_length, band_in_jaws));
}

void BandsPart::fire_clip(int number, const ToolKinematics& tool) noexcept {
    FieldHand& hand = field_.hand(number);
    double least = 0;
    if (!field_.clips_left()) return;
    if (field_.fire_clip(hand, tool, least)) {
        // The open end of a band is the node of its cut.
        const auto outlet = static_cast<std::size_t>(hand.last_clip_outlet);
        const std::size_t end = outlet_band(outlet);
        if (is_trunk(outlet)) clips_[end] |= 1U << static_cast<unsigned>(parted_at_[end]);
        return;
    }
    const Vector3 jaws = tool.tip - 0.5 * hand.instrument->jaw_length * tool.axis;
    std::size_t band = 0;
    int place = -1;
    for (std::size_t b = 0; b < strands_.size(); ++b) {
        double distance = 0;
        const int node = nearest_node(strands_[b], jaws, distance);
        if (node < 0 || !(distance < least)) continue;
        least = distance;
        band = b;
        place = node;
    }
    hand.last_clip_distance = least;
    if (place < 0) return;
    clips_[band] |= 1U << static_cast<unsigned>(place);
    // On the stump of a band that is divided already it closes the vessel behind it.
    const std::int32_t trunk = trunk_of(band);
    if (trunk < 0 || place > parted_at_[band]) return;
    field_.outlets()[static_cast<std::size_t>(trunk)].bleed.clipped = true;
    hand.last_clip_outlet = trunk;
}

void BandsPart::apply_energy(int number, const ToolKinematics& tool, double duty) noexcept {
    FieldHand& hand = field_.hand(number);
    Grip& grip = grips_[static_cast<std::size_t>(number)];
    hand.active = true;
    const EnergyToolModel& model = field_.tool_model(hand);
    const double power = model.tissue_power * duty;
    if (grip.band >= 0) {
        // What the jaws hold: the two segments at the held node that are whole.
        const auto b = static_cast<std::size_t>(grip.band);
        const int node = grip.hold.node;
        int whole = 0;
        for (const int s : {node - 1, node}) whole += strands_[b].is_parted(s) ? 0 : 1;
        for (const int s : {node - 1, node}) {
            if (whole == 0 || strands_[b].is_parted(s)) continue;
            field_.heat_patch(segment_patch(b, s), power / whole);
            grip.heated |= 1U << static_cast<unsigned>(s);
        }
        hand.target = whole > 0 ? EnergyTarget::band : EnergyTarget::nothing;
        grip.touched = whole > 0 ? grip.band : -1;
    } else {
        EnergyReach reach = field_.reach_outlets(hand, tool);
        for (std::size_t b = 0; b < strands_.size() && !model.needs_jaws; ++b) {
            double distance = 0;
            const int node = nearest_node(strands_[b], tool.tip, distance);
            if (node < 0) continue;
            const int s = strands_[b].is_parted(std::min(node, strand_segments - 1))
                              ? node - 1
                              : std::min(node, strand_segments - 1);
            if (s >= 0)
                reach.take(distance - hand.instrument->tip_radius, segment_patch(b, s), EnergyTarget::band,
                           static_cast<std::int32_t>(b));
        }
        field_.reach_nerves_and_bed(hand, tool, reach);
        field_.give(hand, reach, power);
        grip.touched = reach.item;
        if (grip.touched >= 0) {
            const std::size_t first = segment_patch(static_cast<std::size_t>(grip.touched), 0);
            grip.heated = 1U << static_cast<unsigned>(reach.patch - first);
        }
    }
    field_.spread(hand, tool, duty);
}

void BandsPart::touch_with_blade(int number, const ToolKinematics& tool) noexcept {
    FieldHand& hand = field_.hand(number);
    const Grip& grip = grips_[static_cast<std::size_t>(number)];
    if (grip.band >= 0) {
        for (const int s : {grip.hold.node - 1, grip.hold.node})
            field_.touch(hand, segment_patch(static_cast<std::size_t>(grip.band), s));
    }
    field_.touch_nerves_and_bed(hand, tool);
}

}  // namespace fulcrum
