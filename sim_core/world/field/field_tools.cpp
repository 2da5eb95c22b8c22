// SPDX-License-Identifier: Apache-2.0
// Instruments on a field: changed for another, activated, clips, suction, blades through nerves.
#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/world/field/operative_field.h"

namespace fulcrum {
namespace {

using namespace field_rules;

constexpr double suction_reach = 0.010;   // m around the mouth
constexpr double suction_height = 0.006;  // m above the blood's surface
constexpr double warm_blade =
    1e-3;  // K above the body's temperature, from where a blade heats what it touches
constexpr double bleeding_first = 0.002;  // m by which a bleeding point counts as nearer: it is aimed at

double distance_to_line(const Vector3& a, const Vector3& b, const std::vector<Vector3>& line) {
    double least = 1;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const SegmentPair pair = closest_points_of_segments(a, b, line[i], line[i + 1]);
        least = std::min(least, (pair.on_first - pair.on_second).norm());
    }
    return least;
}

Vector3 heel(const FieldHand& hand, const ToolKinematics& tool) {
    return tool.tip - hand.instrument->jaw_length * tool.axis;
}

}  // namespace

double distance_to_blade(const FieldHand& hand, const ToolKinematics& tool, const Vector3& point) noexcept {
    const SegmentPair pair = closest_points_of_segments(heel(hand, tool), tool.tip, point, point);
    return (pair.on_first - point).norm();
}

void OperativeField::exchange(int number, const TickOutput* outputs, std::size_t count, bool holds,
                              double dt) noexcept {
    FieldHand& hand = hands_[static_cast<std::size_t>(number)];
    hand.exchange_left = std::max(0.0, hand.exchange_left - dt);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint16_t buttons = outputs[i].contact[number].tool.buttons;
        const bool asked = (buttons & button_exchange) != 0 && (hand.buttons & button_exchange) == 0;
        hand.buttons = buttons;
        // What is held goes first; an exchange under way is not interrupted.
        if (!asked || hand.kind_count < 2 || holds || hand.exchange_left > 0) continue;
        hand.index = (hand.index + 1) % hand.kind_count;
        // At least a step: the old instrument is out before the new one is in, and its cut ends.
        hand.exchange_left = std::max(spec_.exchange_time, dt);
        hand.blade = BladeState();
        hand.jaws.block();
    }
}

void OperativeField::clear(FieldHand& hand) noexcept {
    hand.active = false;
    hand.target = EnergyTarget::nothing;
    hand.touched_count = 0;
    hand.nerve_distance = 1;
}

double OperativeField::pedal(int number, const TickOutput* outputs, std::size_t count) noexcept {
    std::size_t pressed = 0;
    for (std::size_t i = 0; i < count; ++i)
        pressed += (outputs[i].contact[number].tool.buttons & button_energy) != 0 ? 1 : 0;
    return static_cast<double>(pressed) / static_cast<double>(count);
}

JawAction OperativeField::step_jaws(FieldHand& hand, const ToolKinematics& tool) noexcept {
    ToolKinematics now = tool;
    now.inside = tool.inside && hand.usable();
    return hand.jaws.step(now, hand.instrument->jaw_opening);
}

bool OperativeField::fire_clip(FieldHand& hand, const ToolKinematics& tool, double& least) noexcept {
    least = clip_reach;
    hand.last_clip_outlet = -1;
    --clips_left_;
    ++hand.clips_fired;
    for (std::size_t i = 0; i < outlets_.size(); ++i) {
        const FieldOutlet& outlet = outlets_[i];
        if (!outlet.exposed) continue;  // whole: what a clip takes there is the band
        const double distance = distance_to_blade(hand, tool, outlet.position);
        if (!(distance < least)) continue;
        least = distance;
        hand.last_clip_outlet = static_cast<std::int32_t>(i);
    }
    hand.last_clip_distance = least;
    if (hand.last_clip_outlet < 0) return false;
    outlets_[static_cast<std::size_t>(hand.last_clip_outlet)].bleed.clipped = true;
    return true;
}

void OperativeField::suck(const ToolKinematics& tool, double dt) noexcept {
    suction_ = true;
    const FieldBed& bed = model_.bed;
    if (tool.tip.z() < bed.ground(tool.tip) + pool_.depth[bed.cell(tool.tip)] + suction_height) {
        fulcrum::suck(bed.pool, tool.tip.x() - bed.corner.x(), tool.tip.y() - bed.corner.y(), suction_reach,
                      spec_.suction_flow * dt, pool_);
    }
}

void OperativeField::measure_nerves(FieldHand& hand, const ToolKinematics& tool) noexcept {
    for (const FieldModel::Nerve& nerve : model_.nerves) {
        hand.nerve_distance =
            std::min(hand.nerve_distance, distance_to_line(heel(hand, tool), tool.tip, nerve.line) -
                                              hand.instrument->tip_radius - spec_.nerve_radius);
    }
}

bool OperativeField::is_blade(const FieldHand& hand, const ToolKinematics& tool,
                              bool energised) const noexcept {
    if (!tool.inside || !hand.usable()) return false;
    const bool primary = (tool.buttons & button_primary) != 0;
    // Shears part tissue by heat between their blades: what they do to a nerve is an injury by heat.
    const InstrumentBlade blade = type_of(hand.kind()).blade;
    return blade == InstrumentBlade::button
               ? primary
               : blade == InstrumentBlade::button_or_energy && (primary || energised);
}

void OperativeField::divide_nerves(int number, const ToolKinematics& tool, bool energised) noexcept {
    FieldHand& hand = hands_[static_cast<std::size_t>(number)];
    const Vector3 from = hand.cutting ? hand.last_tip : tool.tip;
    hand.cutting = is_blade(hand, tool, energised);
    hand.last_tip = tool.tip;
    if (!hand.cutting) return;
    for (std::size_t n = 0; n < model_.nerves.size(); ++n) {
        if (distance_to_line(from, tool.tip, model_.nerves[n].line) < spec_.nerve_radius + blade_half)
            nerve_divided_[n] = 1;
    }
}

EnergyReach OperativeField::reach_outlets(const FieldHand& hand, const ToolKinematics& tool) const noexcept {
    EnergyReach reach{touch_reach};
    const FieldBed& bed = model_.bed;
    for (const FieldOutlet& outlet : outlets_) {
        if (!outlet.exposed) continue;
        if (!reach.take(distance_to_blade(hand, tool, outlet.position) - bleeding_first, outlet.patch,
                        EnergyTarget::vessel))
            continue;
        reach.share = share_under_blood(bed.ground(outlet.position) + pool_.depth[bed.cell(outlet.position)] -
                                        outlet.position.z());
    }
    return reach;
}

void OperativeField::reach_nerves_and_bed(const FieldHand& hand, const ToolKinematics& tool,
                                          EnergyReach& reach) const noexcept {
    // Nerve and bed are reached where the blade lies on them.
    const double on = touch_reach - contact_gap;
    for (const FieldModel::Nerve& nerve : model_.nerves) {
        for (std::size_t i = 0; i < nerve.line.size(); ++i) {
            const double gap = distance_to_blade(hand, tool, nerve.line[i]) - spec_.nerve_radius -
                               hand.instrument->tip_radius;
            reach.take(on + gap, nerve.first + i, EnergyTarget::nerve);
        }
    }
    reach.take(on + above_bed(tool.tip) - hand.instrument->tip_radius,
               model_.first_bed + model_.bed.cell(tool.tip), EnergyTarget::bed);
}

void OperativeField::give(FieldHand& hand, const EnergyReach& reach, double watts) noexcept {
    hand.target = reach.target;
    if (reach.target == EnergyTarget::nothing) return;
    heat_patch(reach.patch, watts * (reach.target == EnergyTarget::vessel ? reach.share : 1.0));
}

void OperativeField::spread(const FieldHand& hand, const ToolKinematics& tool, double duty) noexcept {
    const double watts = spread_power * duty;
    for (const FieldModel::Nerve& nerve : model_.nerves) {
        for (std::size_t i = 0; i < nerve.line.size(); ++i) {
            const double away = std::max(0.0, distance_to_blade(hand, tool, nerve.line[i]) -
                                                  spec_.nerve_radius - hand.instrument->tip_radius);
            if (away < spread_reach) heat_patch(nerve.first + i, watts * math::exp(-away / spread_length));
        }
    }
    const double above = std::max(0.0, above_bed(tool.tip) - hand.instrument->tip_radius);
    if (above < spread_reach)
        heat_patch(model_.first_bed + model_.bed.cell(tool.tip), watts * math::exp(-above / spread_length));
}

void OperativeField::touch(FieldHand& hand, std::size_t patch) noexcept {
    if (hand.blade.rise < warm_blade || hand.touched_count >= static_cast<int>(hand.touched.size())) return;
    const double through = tool_model(hand).blade_contact;
    hand.touched[static_cast<std::size_t>(hand.touched_count++)] = static_cast<std::int32_t>(patch);
    double& contact = inputs_.contact[patch];
    double& rise = inputs_.contact_rise[patch];
    rise = (contact * rise + through * hand.blade.rise) / (contact + through);
    contact += through;
}

void OperativeField::touch_nerves_and_bed(FieldHand& hand, const ToolKinematics& tool) noexcept {
    const double reach = hand.instrument->tip_radius + contact_gap;
    for (const FieldModel::Nerve& nerve : model_.nerves) {
        for (std::size_t i = 0; i < nerve.line.size(); ++i) {
            if (distance_to_blade(hand, tool, nerve.line[i]) < reach + spec_.nerve_radius)
                touch(hand, nerve.first + i);
        }
    }
    if (above_bed(tool.tip) < reach) touch(hand, model_.first_bed + model_.bed.cell(tool.tip));
}

}  // namespace fulcrum
