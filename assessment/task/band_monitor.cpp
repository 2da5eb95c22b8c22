// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/band_monitor.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double millilitres = 1e6;         // per m3
constexpr double loss_step = 0.25;          // mL between two reports of the sum
constexpr double dose_pause = 0.5;          // s between two reports of the dose
constexpr double square_millimetres = 1e6;  // per m2
constexpr double least_dose = 0.01;         // min, smaller doses are not reported

void emit(EventSink& sink, std::uint32_t tick, EventKind kind, int hand, std::int8_t tissue,
          std::int32_t detail, double value) noexcept {
    Event event;
    event.tick = tick;
    event.kind = kind;
    event.hand = static_cast<std::uint8_t>(hand);
    event.tissue = tissue;
    event.detail = detail;
    event.value = static_cast<float>(value);
    sink.on_event(event);
}

constexpr int no_hand = 255;
constexpr std::size_t most_nerves = 2;

}  // namespace

BandMonitor::BandMonitor(const Scene& scene)
    : present_(scene.field() != nullptr), tick_period_(scene.tick_period()) {
    if (!present_) return;
    const FieldSpec& spec = *scene.field();
    const auto tissue = [&](const std::string& label) {
        return static_cast<std::int8_t>(scene.tissue_index(label));
    };
    safe_distance_ = spec.safe_distance;
    nerve_limit_ = spec.nerve_dose_limit;
    bed_tissue_ = tissue(spec.bed_tissue);
    nerve_tissue_ = tissue(spec.nerve_tissue);
    vessel_tissue_ = tissue(spec.vessel_tissue);
    if (scene.sheet) sheet_tissue_ = tissue(scene.sheet->tissue);
    if (scene.septa) {
        sheet_tissue_ = tissue(scene.septa->tissue);
        fat_tissue_ = tissue(scene.septa->fat_tissue);
    }
    std::size_t outlets = field_outlet_capacity;
    if (scene.bands) {
        band_tissue_ = tissue(scene.bands->tissue);
        band_parted_.assign(static_cast<std::size_t>(scene.bands->count), 0);
        pulled_by_.assign(band_parted_.size(), no_hand);
        outlets = 2 * static_cast<std::size_t>(scene.bands->vessels);
    }
    bleeding_.assign(outlets, 0);
    injured_ = bleeding_;
    nerve_heated_.assign(most_nerves, 0);
    nerve_divided_ = nerve_heated_;
    outlet_ml_.assign(bleeding_.size(), 0.0);
    clips_left_ = spec.clips;
}

std::int8_t BandMonitor::tissue_of(EnergyTarget target) const noexcept {
    switch (target) {
        case EnergyTarget::nothing:
            return -1;
        case EnergyTarget::band:
            return band_tissue_;
        case EnergyTarget::vessel:
            return vessel_tissue_;
        case EnergyTarget::bed:
            return bed_tissue_;
        case EnergyTarget::nerve:
            return nerve_tissue_;
        case EnergyTarget::sheet:
            return sheet_tissue_;
        case EnergyTarget::fat:
            return fat_tissue_;
    }
    return -1;
}

void BandMonitor::tick(const TickSample& sample) noexcept {
    if (!present_) return;
    for (std::size_t h = 0; h < hand_count; ++h) {
        const std::uint16_t flags = sample.hand[h].flags;
        if ((flags & hand_energy) != 0 && (flags & hand_in_view) == 0) spans_[h].seen_in_view = false;
    }
}

void BandMonitor::step(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept {
    clipped_ = {};
    if (!present_ || world.field.empty()) return;
    const FieldView& view = world.field[0];
    for (int hand = 0; hand < hand_count; ++hand) step_hand(hand, view, tick, sink);
    step_bands(world.bands, tick, sink);
    watch_traction(world);
    step_outlets(view, tick, sink);
    if (view.lateral_dose > dose_) {
        dose_ = view.lateral_dose;
        dose_tissue_ = view.worst_nerve_dose >= view.lateral_dose ? nerve_tissue_
                       : view.worst_bed_dose >= view.lateral_dose ? bed_tissue_
                       : fat_tissue_ >= 0                         ? fat_tissue_
                                                                  : sheet_tissue_;
    }
    if ((tick - told_dose_tick_) * tick_period_ >= dose_pause) tell_dose(tick, sink);
    area_ = std::max(area_, view.lateral_area);
    if ((tick - told_area_tick_) * tick_period_ >= dose_pause) tell_area(tick, sink);
    step_nerves(view, tick, sink);
}

void BandMonitor::step_bands(const BandsView& view, std::uint32_t tick, EventSink& sink) noexcept {
    for (std::size_t b = 0; b < band_parted_.size() && b < view.bands.size(); ++b) {
        const BandView& band = view.bands[b];
        if (!band.divided() || band_parted_[b] != 0) continue;
        band_parted_[b] = 1;
        const auto number = static_cast<std::int32_t>(b);
        const auto tension = static_cast<double>(band.parted_tension);
        if (band.torn) {
            ++torn_;
            emit(sink, tick, EventKind::tear, pulled_by_[b], band_tissue_, number, tension);
        } else {
            ++divided_;
            emit(sink, tick, EventKind::band_divided, no_hand, band_tissue_, number, tension);
        }
    }
}

void BandMonitor::watch_traction(const WorldSnapshot& world) noexcept {
    // A band gives way a moment after the pull that was too much: the last hand on it stays noted.
    for (std::size_t b = 0; b < pulled_by_.size(); ++b) {
        double most = -1;
        for (int hand = 0; hand < hand_count; ++hand) {
            const GraspState& grasp = world.grasps[hand];
            if (!grasp.held || grasp.body != HeldBody::band || grasp.patch != static_cast<std::int32_t>(b))
                continue;
            if (grasp.reaction.norm() <= most) continue;
            most = grasp.reaction.norm();
            pulled_by_[b] = static_cast<std::uint8_t>(hand);
        }
    }
}

void BandMonitor::step_nerves(const FieldView& view, std::uint32_t tick, EventSink& sink) noexcept {
    for (std::size_t n = 0; n < most_nerves && n < view.nerves.size(); ++n) {
        const NerveView& nerve = view.nerves[n];
        float worst = 0;
        for (const float dose : nerve.dose) worst = std::max(worst, dose);
        const auto number = static_cast<std::int32_t>(n);
        if (nerve_heated_[n] == 0 && static_cast<double>(worst) > nerve_limit_) {
            nerve_heated_[n] = 1;
            emit(sink, tick, EventKind::nerve_injury, no_hand, nerve_tissue_,
                 detail_of(NerveInjury{number, InjuryCause::heat}), static_cast<double>(worst));
        }
        if (nerve_divided_[n] == 0 && nerve.divided) {
            nerve_divided_[n] = 1;
            emit(sink, tick, EventKind::nerve_injury, no_hand, nerve_tissue_,
                 detail_of(NerveInjury{number, InjuryCause::blade}), static_cast<double>(worst));
        }
    }
}

void BandMonitor::step_hand(int hand, const FieldView& view, std::uint32_t tick, EventSink& sink) noexcept {
    const auto h = static_cast<std::size_t>(hand);
    const HandToolView& tool = view.tools[hand];
    Span& span = spans_[h];
    clips_left_ = tool.clips_left;
    if (tool.index != tool_index_[h]) {
        tool_index_[h] = tool.index;
        emit(sink, tick, EventKind::tool_exchanged, hand, -1, tool.index, 0);
    }
    if (tool.clips_fired > clips_fired_[h]) {
        clipped_[h] = true;
        emit(sink, tick, EventKind::clip_applied, hand, vessel_tissue_, tool.last_clip_outlet,
             static_cast<double>(tool.last_clip_distance));
    }
    clips_fired_[h] = tool.clips_fired;

    const bool powered = tool.active && gives_energy(tool.kind);
    // What the jaws hold has parted on both sides: an activation that was on target ends with that, and what
    // the pedal gives to nothing afterwards makes it neither longer nor unsafe.
    const bool idle = powered && tool.target == EnergyTarget::nothing && tool.band >= 0;
    span.spent = idle && (span.spent || (span.on && span.held.on_target));
    const bool on = powered && !span.spent;
    if (on) {
        const bool target = tool.target == EnergyTarget::band || tool.target == EnergyTarget::vessel ||
                            tool.target == EnergyTarget::sheet;
        const auto distance = static_cast<double>(tool.nerve_distance);
        const Activation now{span.seen_in_view, target, distance >= safe_distance_};
        const std::int8_t tissue = tissue_of(tool.target);
        if (!span.on) {
            span.on = true;
            span.held = now;
            span.least_distance = distance;
            span.tissue = tissue;
            emit(sink, tick, EventKind::activation_begin, hand, tissue, detail_of(now), distance);
        } else {
            span.held.in_view = span.held.in_view && now.in_view;
            span.held.on_target = span.held.on_target && now.on_target;
            span.held.clear = span.held.clear && now.clear;
            span.least_distance = std::min(span.least_distance, distance);
            if (span.tissue < 0) span.tissue = tissue;
        }
    } else if (span.on) {
        const bool spent = span.spent;
        end_activation(hand, tick, sink);
        span.spent = spent;
    }
    if (!on) span.seen_in_view = true;
}

void BandMonitor::end_activation(int hand, std::uint32_t tick, EventSink& sink) noexcept {
    Span& span = spans_[static_cast<std::size_t>(hand)];
    emit(sink, tick, EventKind::activation_end, hand, span.tissue, detail_of(span.held), span.least_distance);
    span = Span();
}

void BandMonitor::step_outlets(const FieldView& view, std::uint32_t tick, EventSink& sink) noexcept {
    dry_ = 0;
    lost_ml_ = view.lost * millilitres;
    for (std::size_t i = 0; i < bleeding_.size() && i < view.outlets.size(); ++i) {
        const OutletView& outlet = view.outlets[i];
        const auto number = static_cast<std::int32_t>(i);
        const bool bleeds = outlet.flow > 0;
        outlet_ml_[i] = outlet.lost * millilitres;
        if (bleeds && bleeding_[i] == 0)
            emit(sink, tick, EventKind::bleed_begin, no_hand, vessel_tissue_, number,
                 outlet.flow * millilitres * 60);
        if (!bleeds && bleeding_[i] != 0)
            emit(sink, tick, EventKind::bleed_end, no_hand, vessel_tissue_, number, outlet_ml_[i]);
        bleeding_[i] = bleeds ? 1 : 0;
        if (outlet.injured && injured_[i] == 0) {
            injured_[i] = 1;
            emit(sink, tick, EventKind::vessel_injury, no_hand, vessel_tissue_, number, 0);
        }
    }
    for (std::size_t v = 0;
         !band_parted_.empty() && 2 * v + 1 < bleeding_.size() && 2 * v + 1 < view.outlets.size(); ++v) {
        const bool open = view.outlets[2 * v].opened;
        dry_ += open && bleeding_[2 * v] == 0 && bleeding_[2 * v + 1] == 0 ? 1 : 0;
    }
    if (lost_ml_ >= told_ml_ + loss_step) tell_loss(tick, sink);
}

void BandMonitor::tell_loss(std::uint32_t tick, EventSink& sink) noexcept {
    if (!(lost_ml_ > told_ml_)) return;
    told_ml_ = lost_ml_;
    emit(sink, tick, EventKind::blood_loss, no_hand, vessel_tissue_, 0, lost_ml_);
}

void BandMonitor::tell_dose(std::uint32_t tick, EventSink& sink) noexcept {
    if (!(dose_ > told_dose_) || dose_ < least_dose) return;
    told_dose_ = dose_;
    told_dose_tick_ = tick;
    emit(sink, tick, EventKind::heat_dose, no_hand, dose_tissue_, 0, dose_);
}

void BandMonitor::tell_area(std::uint32_t tick, EventSink& sink) noexcept {
    if (!(area_ > told_area_)) return;
    told_area_ = area_;
    told_area_tick_ = tick;
    emit(sink, tick, EventKind::heat_area, no_hand, bed_tissue_, 0, area_ * square_millimetres);
}

void BandMonitor::finish(std::uint32_t tick, EventSink& sink) noexcept {
    if (!present_) return;
    for (int hand = 0; hand < hand_count; ++hand) {
        if (spans_[static_cast<std::size_t>(hand)].on) end_activation(hand, tick, sink);
    }
    for (std::size_t i = 0; i < bleeding_.size(); ++i) {
        if (bleeding_[i] != 0)
            emit(sink, tick, EventKind::bleed_end, no_hand, vessel_tissue_, static_cast<std::int32_t>(i),
                 outlet_ml_[i]);
        bleeding_[i] = 0;
    }
    tell_loss(tick, sink);
    tell_dose(tick, sink);
    tell_area(tick, sink);
}

}  // namespace fulcrum
