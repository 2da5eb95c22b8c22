// SPDX-License-Identifier: Apache-2.0
// Instruments on bands: changed for another, closed on a band, activated, clips, suction.
#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/world/bands_part.h"

namespace fulcrum {
namespace {

constexpr double closed_below = 0.35, open_above = 0.45;  // of the widest opening, as on the bowel
constexpr double least_grip = 0.2;                        // N
constexpr double grasp_reach = 0.006;                     // m from the middle of the jaws to the band
constexpr double clip_reach = 0.006;                      // m
constexpr double correction_time = 0.06;                  // s
constexpr double fastest_hold = 2.0;                      // m/s
constexpr double slip_delay = 0.02;                       // s
constexpr double pinch_share = 2.0;                       // of the tissue's contact stiffness
constexpr double touch_reach = 0.003;     // m, from the tip to what energy reaches without jaws
constexpr double contact_gap = 0.0005;    // m, blade to a patch that it touches
constexpr double spread_power = 1.2;      // W at the blade's surface: hot steam beside it; provisional
constexpr double spread_length = 0.0015;  // m, in which that falls to 1/e; provisional
constexpr double spread_reach = 0.008;    // m
constexpr double suction_reach = 0.010;   // m around the mouth
constexpr double suction_height = 0.006;  // m above the blood's surface

double distance_to_line(const Vector3& a, const Vector3& b, const std::vector<Vector3>& line) {
    double least = 1;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const SegmentPair pair = closest_points_of_segments(a, b, line[i], line[i + 1]);
        least = std::min(least, (pair.on_first - pair.on_second).norm());
    }
    return least;
}

double distance_to_blade(const Vector3& a, const Vector3& b, const Vector3& point) {
    const SegmentPair pair = closest_points_of_segments(a, b, point, point);
    return (pair.on_first - point).norm();
}

}  // namespace

void BandsPart::step_tool(HandTool& hand, const TickOutput* outputs, std::size_t count, int number,
                          double dt) noexcept {
    const ToolKinematics& tool = outputs[count - 1].contact[number].tool;
    exchange(hand, outputs, count, number, dt);
    hand.active = false;
    hand.target = EnergyTarget::nothing;
    hand.touched_band = -1;
    hand.touched_count = 0;
    hand.nerve_distance = 1;
    if (!tool.present || !tool.tip.allFinite()) return;
    step_jaws(hand, tool, dt);
    const ToolKind kind = hand.kind();
    if (!tool.inside || !hand.usable()) return;
    std::size_t pressed = 0;
    for (std::size_t i = 0; i < count; ++i)
        pressed += (outputs[i].contact[number].tool.buttons & button_energy) != 0 ? 1 : 0;
    if (gives_energy(kind)) {
        const Vector3 heel = tool.tip - hand.instrument->jaw_length * tool.axis;
        hand.nerve_distance = distance_to_line(heel, tool.tip, layout_.nerve) - hand.instrument->tip_radius -
                              spec_.nerve_radius;
        touch_with_blade(hand, tool);
        if (pressed > 0) apply_energy(hand, tool, static_cast<double>(pressed) / static_cast<double>(count));
    } else if (kind == ToolKind::suction && pressed > 0) {
        hand.active = true;
        suction_ = true;
        const std::size_t under = layout_.bed.cell(tool.tip);
        if (tool.tip.z() < layout_.bed.pool.ground[under] + pool_.depth[under] + suction_height) {
            suck(layout_.bed.pool, tool.tip.x() - layout_.bed.corner.x(),
                 tool.tip.y() - layout_.bed.corner.y(), suction_reach, spec_.suction_flow * dt, pool_);
        }
    }
}

void BandsPart::exchange(HandTool& hand, const TickOutput* outputs, std::size_t count, int number,
                         double dt) noexcept {
    hand.exchange_left = std::max(0.0, hand.exchange_left - dt);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint16_t buttons = outputs[i].contact[number].tool.buttons;
        const bool asked = (buttons & button_exchange) != 0 && (hand.buttons & button_exchange) == 0;
        hand.buttons = buttons;
        // What is held goes first; an exchange under way is not interrupted.
        if (!asked || hand.kind_count < 2 || hand.band >= 0 || hand.exchange_left > 0) continue;
        hand.index = (hand.index + 1) % hand.kind_count;
        hand.exchange_left = spec_.exchange_time;
        hand.blade = BladeState();
        hand.ready = false;
    }
}

void BandsPart::step_jaws(HandTool& hand, const ToolKinematics& tool, double dt) noexcept {
    const ToolKind kind = hand.kind();
    const bool holds = kind == ToolKind::grasper || kind == ToolKind::harmonic;
    const double opening = tool.jaw_angle / std::max(1e-9, hand.instrument->jaw_opening);
    const bool closed = opening < closed_below && tool.grip > least_grip;
    if (opening > open_above) hand.ready = true;
    if (hand.band >= 0) {
        const StrandState& strand = strands_[static_cast<std::size_t>(hand.band)];
        const double capacity = 2.0 * tissue_.friction * tool.grip;
        hand.slip_time = hold_force(hand.hold, strand).norm() > capacity ? hand.slip_time + dt : 0.0;
        hand.slipped = hand.slip_time > slip_delay;
        if (opening > open_above || tool.grip <= 0.5 * least_grip || hand.slipped || !tool.inside) {
            hand.band = -1;
            hand.hold.node = -1;
        }
    } else if (closed && hand.ready && tool.inside && hand.usable() &&
               (holds || kind == ToolKind::clip_applier)) {
        hand.ready = false;
        if (kind == ToolKind::clip_applier) {
            fire_clip(hand, tool);
            return;
        }
        const Vector3 jaws = tool.tip - 0.5 * hand.instrument->jaw_length * tool.axis;
        double least = grasp_reach;
        for (std::size_t b = 0; b < strands_.size(); ++b) {
            double distance = 0;
            const int node = nearest_node(strands_[b], jaws, distance);
            if (node < 0 || !(distance < least)) continue;
            least = distance;
            hand.band = static_cast<std::int32_t>(b);
            hand.hold.node = std::clamp(node, 1, strand_nodes - 2);
        }
        if (hand.band < 0) return;
        const Vector3 point =
            strands_[static_cast<std::size_t>(hand.band)].position[static_cast<std::size_t>(hand.hold.node)];
        hand.hold.target = point;
        hand.hold.stiffness = pinch_share * tissue_.stiffness;
        hand.correction = point - jaws;
        hand.target_velocity.setZero();
        hand.hold_offset = Vector3(0, 0, -0.5 * hand.instrument->jaw_length);
        hand.slip_time = 0;
        hand.slipped = false;
    }
    if (hand.band < 0) return;
    hand.correction *= std::max(0.0, 1.0 - dt / correction_time);
    Vector3 motion = tool.tip + tool.rotation * hand.hold_offset + hand.correction - hand.hold.target;
    const double longest = fastest_hold * dt;
    if (motion.norm() > longest) motion *= longest / motion.norm();
    hand.hold.target += motion;
    hand.target_velocity = motion / dt;
}

void BandsPart::fire_clip(HandTool& hand, const ToolKinematics& tool) noexcept {
    if (clips_left_ <= 0) return;
    --clips_left_;
    ++hand.clips_fired;
    hand.last_clip_outlet = -1;
    const Vector3 heel = tool.tip - hand.instrument->jaw_length * tool.axis;
    double least = clip_reach;
    for (std::size_t i = 0; i < outlets_.size(); ++i) {
        const Outlet& outlet = outlets_[i];
        if (outlet.trunk && !outlet.opened) continue;  // whole: what a clip takes there is the band
        const double distance = distance_to_blade(heel, tool.tip, outlet_position(outlet));
        if (!(distance < least)) continue;
        least = distance;
        hand.last_clip_outlet = static_cast<std::int32_t>(i);
    }
    hand.last_clip_distance = least;
    if (hand.last_clip_outlet >= 0) {
        outlets_[static_cast<std::size_t>(hand.last_clip_outlet)].bleed.clipped = true;
        return;
    }
    for (std::size_t b = 0; b < strands_.size(); ++b) {
        double distance = 0;
        const int node =
            nearest_node(strands_[b], tool.tip - 0.5 * hand.instrument->jaw_length * tool.axis, distance);
        if (node < 0 || !(distance < least)) continue;
        least = distance;
        clip_nodes_[b] = node;
    }
    hand.last_clip_distance = least;
}

void BandsPart::apply_energy(HandTool& hand, const ToolKinematics& tool, double duty) noexcept {
    hand.active = true;
    const EnergyToolModel& model = hand.kind() == ToolKind::hook ? hook_ : shears_;
    const double power = model.tissue_power * duty;
    const Vector3 heel = tool.tip - hand.instrument->jaw_length * tool.axis;
    const auto heat = [&](std::size_t patch, double watts) { heat_inputs_.power[patch] += watts; };
    if (hand.band >= 0) {
        // What the jaws hold: the two segments at the held node that are whole.
        const auto b = static_cast<std::size_t>(hand.band);
        const int node = hand.hold.node;
        int whole = 0;
        for (const int s : {node - 1, node}) whole += strands_[b].is_parted(s) ? 0 : 1;
        for (const int s : {node - 1, node}) {
            if (whole > 0 && !strands_[b].is_parted(s)) heat(segment_patch(b, s), power / whole);
        }
        hand.target = EnergyTarget::band;
        hand.touched_band = whole > 0 ? hand.band : -1;
    } else {
        double least = touch_reach;
        std::size_t reached = 0;
        const auto take = [&](double distance, std::size_t patch, EnergyTarget target, std::int32_t band) {
            if (!(distance < least)) return;
            least = distance;
            reached = patch;
            hand.target = target;
            hand.touched_band = band;
        };
        double share = 1;
        for (const Outlet& outlet : outlets_) {
            if (outlet.trunk && !outlet.opened) continue;
            const Vector3 place = outlet_position(outlet);
            // A bleeding point is what the hand aims at: it counts as nearer than what lies around it.
            take(distance_to_blade(heel, tool.tip, place) - 0.002, outlet_patch(outlet), EnergyTarget::vessel,
                 -1);
            if (hand.target != EnergyTarget::vessel || reached != outlet_patch(outlet)) continue;
            const std::size_t under = layout_.bed.cell(place);
            share = share_under_blood(layout_.bed.pool.ground[under] + pool_.depth[under] - place.z());
        }
        if (!model.needs_jaws) {
            for (std::size_t b = 0; b < strands_.size(); ++b) {
                double distance = 0;
                const int node = nearest_node(strands_[b], tool.tip, distance);
                if (node < 0) continue;
                const int s = strands_[b].is_parted(std::min(node, strand_segments - 1))
                                  ? node - 1
                                  : std::min(node, strand_segments - 1);
                if (s >= 0)
                    take(distance - hand.instrument->tip_radius, segment_patch(b, s), EnergyTarget::band,
                         static_cast<std::int32_t>(b));
            }
        }
        // Nerve and bed are reached where the blade lies on them.
        const double on = touch_reach - contact_gap;
        for (std::size_t i = 0; i < layout_.nerve.size(); ++i) {
            const double gap = distance_to_blade(heel, tool.tip, layout_.nerve[i]) - spec_.nerve_radius -
                               hand.instrument->tip_radius;
            take(on + gap, heat_.nerve + i, EnergyTarget::nerve, -1);
        }
        const std::size_t under = layout_.bed.cell(tool.tip);
        take(on + tool.tip.z() - layout_.bed.pool.ground[under] - hand.instrument->tip_radius,
             heat_.bed + under, EnergyTarget::bed, -1);
        if (hand.target != EnergyTarget::nothing)
            heat(reached, power * (hand.target == EnergyTarget::vessel ? share : 1.0));
    }
    // Steam and hot liquid beside the blade.
    const double spread = spread_power * duty;
    for (std::size_t i = 0; i < layout_.nerve.size(); ++i) {
        const double away = std::max(0.0, distance_to_blade(heel, tool.tip, layout_.nerve[i]) -
                                              spec_.nerve_radius - hand.instrument->tip_radius);
        if (away < spread_reach) heat(heat_.nerve + i, spread * math::exp(-away / spread_length));
    }
    const std::size_t under = layout_.bed.cell(tool.tip);
    const double above =
        std::max(0.0, tool.tip.z() - layout_.bed.pool.ground[under] - hand.instrument->tip_radius);
    if (above < spread_reach) heat(heat_.bed + under, spread * math::exp(-above / spread_length));
}

void BandsPart::touch_with_blade(HandTool& hand, const ToolKinematics& tool) noexcept {
    const EnergyToolModel& model = hand.kind() == ToolKind::hook ? hook_ : shears_;
    if (hand.blade.rise < 1e-3) return;
    const Vector3 heel = tool.tip - hand.instrument->jaw_length * tool.axis;
    const auto touch = [&](std::size_t patch) {
        if (hand.touched_count >= static_cast<int>(hand.touched.size())) return;
        hand.touched[static_cast<std::size_t>(hand.touched_count++)] = static_cast<std::int32_t>(patch);
        double& contact = heat_inputs_.contact[patch];
        double& rise = heat_inputs_.contact_rise[patch];
        rise = (contact * rise + model.blade_contact * hand.blade.rise) / (contact + model.blade_contact);
        contact += model.blade_contact;
    };
    if (hand.band >= 0) {
        for (const int s : {hand.hold.node - 1, hand.hold.node})
            touch(segment_patch(static_cast<std::size_t>(hand.band), s));
    }
    const double reach = hand.instrument->tip_radius + contact_gap;
    for (std::size_t i = 0; i < layout_.nerve.size(); ++i) {
        if (distance_to_blade(heel, tool.tip, layout_.nerve[i]) < reach + spec_.nerve_radius)
            touch(heat_.nerve + i);
    }
    const std::size_t under = layout_.bed.cell(tool.tip);
    if (tool.tip.z() - layout_.bed.pool.ground[under] < reach) touch(heat_.bed + under);
}

}  // namespace fulcrum
