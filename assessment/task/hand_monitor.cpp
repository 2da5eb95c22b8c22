// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/hand_monitor.h"

#include <algorithm>
#include <cmath>

#include "sim_core/scene/perforation.h"

namespace fulcrum {
namespace {

constexpr double release_share =
    0.9;  // an over-force ends below this share of the limit, so that noise does not split it
constexpr double rearm_s = 0.5;  // s without contact until the next perforation can be counted

}  // namespace

void HandMonitor::configure(Hand hand, const Scene& scene, const std::vector<TissueWatch>* tissues,
                            double warning_margin) {
    hand_ = hand;
    tissues_ = tissues;
    tick_rate_ = scene.tick_rate;
    warning_margin_ = warning_margin;
    const InstrumentSpec* instrument = scene.instrument(hand);
    jaw_length_ = instrument != nullptr ? instrument->jaw_length : 0;
    septum_width_ = scene.septa ? scene.septa->width : 0;
    // 20 ms of ticks at any rate: quantisation (0.1 um) and one tick's noise then stay far below the 5 mm/s
    // that count as moving.
    span_ = std::clamp(scene.tick_rate / 50, 1, static_cast<int>(tips_.size()) - 1);
}

void HandMonitor::emit(EventSink& sink, std::uint32_t tick, EventKind kind, int tissue, std::int32_t detail,
                       double value) const noexcept {
    Event event;
    event.tick = tick;
    event.kind = kind;
    event.hand = static_cast<std::uint8_t>(hand_);
    event.tissue = static_cast<std::int8_t>(tissue);
    event.detail = detail;
    event.value = static_cast<float>(value);
    sink.on_event(event);
}

void HandMonitor::move(const std::int32_t (&tip)[3], bool inside) noexcept {
    if (!inside || !was_inside_) samples_ = 0;
    was_inside_ = inside;
    auto& slot = tips_[samples_ % tips_.size()];
    std::copy(std::begin(tip), std::end(tip), slot.begin());
    speed_ = 0;
    if (inside && samples_ >= static_cast<std::uint64_t>(span_)) {
        const auto& before = tips_[(samples_ - static_cast<std::uint64_t>(span_)) % tips_.size()];
        double squares = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double step = static_cast<double>(slot[i]) - before[i];
            squares += step * step;
        }
        speed_ = std::sqrt(squares) * sample_length_unit * tick_rate_ / span_;
    }
    ++samples_;
}

void HandMonitor::tick(const TickSample& tick_sample, EventSink& sink) noexcept {
    const HandSample& sample = tick_sample.hand[static_cast<int>(hand_)];
    const std::uint32_t tick = tick_sample.tick;
    move(sample.tip, (sample.flags & hand_inside) != 0);

    const bool faulty = (sample.flags & hand_faulty) != 0;
    if (faulty && !faulty_) emit(sink, tick, EventKind::device_fault, -1, 0, 0);
    faulty_ = faulty;

    const bool known = sample.tissue >= 0 && static_cast<std::size_t>(sample.tissue) < tissues_->size();
    const TissueWatch none;
    const TissueWatch& watch = known ? (*tissues_)[static_cast<std::size_t>(sample.tissue)] : none;
    const double fx = sample.force[0], fy = sample.force[1], fz = sample.force[2];
    const double force = std::sqrt(fx * fx + fy * fy + fz * fz);  // mN
    step_force_ = std::max(step_force_, force * sample_force_unit);
    limit_shown_ = watch.force_limit * sample_force_unit;
    warning_ =
        warning_margin_ >= 0 && watch.force_limit > 0 && force > watch.force_limit * (1 + warning_margin_);

    if (over_ && (sample.tissue != over_tissue_ || force < release_share * over_limit_)) {
        emit(sink, tick, EventKind::over_force_end, over_tissue_, static_cast<std::int32_t>(over_limit_),
             over_peak_ * sample_force_unit);
        over_ = false;
    }
    if (!over_ && watch.force_limit > 0 && force > watch.force_limit) {
        over_ = true;
        over_tissue_ = sample.tissue;
        over_limit_ = watch.force_limit;
        over_peak_ = force;
        emit(sink, tick, EventKind::over_force_begin, over_tissue_, static_cast<std::int32_t>(over_limit_),
             force * sample_force_unit);
    }
    if (over_) over_peak_ = std::max(over_peak_, force);

    const bool grasping = (sample.flags & hand_grasping) != 0;
    // One hole is one event: another can follow only after the tip has been away for a while.
    away_ticks_ = known ? 0 : away_ticks_ + 1;
    if (away_ticks_ > rearm_s * tick_rate_) perforated_ = false;
    const double area = sample.jaw_area * sample_area_unit;
    // The published forces were measured by pinching the wall between two hemispheres. Jaws perforate by the
    // same pressure, a tip that is pushed in by the force itself; traction slips instead.
    const double through = grasping ? pinch_force(sample.jaw_force, area) : force;  // mN
    if (!perforated_ && watch.perforation_limit > 0 && through > watch.perforation_limit) {
        perforated_ = true;
        emit(sink, tick, EventKind::perforation, sample.tissue, sample.patch, through * sample_force_unit);
    }

    const double pressure = grasping && area > 0 ? sample.jaw_force * sample_force_unit / area : 0;  // Pa
    if (pressed_ && (watch.pressure_limit <= 0 || pressure < release_share * watch.pressure_limit))
        pressed_ = false;
    if (!pressed_ && watch.pressure_limit > 0 && pressure > watch.pressure_limit) {
        pressed_ = true;
        emit(sink, tick, EventKind::jaw_pressure, sample.tissue, sample.patch, pressure * 1e-3);
    }

    if (watch.wall && !on_wall_)
        emit(sink, tick, EventKind::wall_contact, sample.tissue, 0, force * sample_force_unit);
    on_wall_ = watch.wall;
}

HoldChange HandMonitor::hold(const GraspState& grasp, std::uint32_t tick, std::uint32_t clock,
                             EventSink& sink) noexcept {
    HoldChange change = HoldChange::none;
    if (grasp.held && !held_) {
        held_ = true;
        emit(sink, tick, EventKind::grasp, grasp.tissue, grasp.patch, grasp.arc_length);
        change = HoldChange::grasped;
    } else if (!grasp.held && held_) {
        held_ = false;
        if (grasp.slipped) {
            emit(sink, tick, EventKind::slip, last_grasp_.tissue, last_grasp_.patch, last_grasp_.arc_length);
            change = HoldChange::slipped;
        } else {
            emit(sink, tick, EventKind::release, last_grasp_.tissue, last_grasp_.patch,
                 last_grasp_.arc_length);
            released_ = {last_grasp_.body, last_grasp_.patch, last_grasp_.offset, clock, true};
            change = HoldChange::released;
        }
    }
    last_grasp_ = grasp;
    return change;
}

bool HandMonitor::takes_again(const Released& place, const GraspState& grasp) const noexcept {
    if (!place.valid || place.body != grasp.body || place.patch != grasp.patch) return false;
    if (grasp.patch >= 0) return true;
    // Septa are end to end at rest: near across a rim are two of them.
    if (septum_width_ > 0 &&
        std::floor(place.rest.x() / septum_width_) != std::floor(grasp.offset.x() / septum_width_))
        return false;
    return grasp.body == HeldBody::sheet && (grasp.offset - place.rest).norm() < jaw_length_;
}

}  // namespace fulcrum
