// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/prodding_rig.h"

#include "sim_core/devices/device_page.h"
#include "tests/app/hand_wishes.h"

namespace fulcrum::app::program_test {

void ProddingRig::take(const Plan& plan, std::uint32_t tick, const DeviceSample& now) {
    if (plan_ == nullptr || plan_->hand != plan.hand) {
        const Vector3 handle = handle_of(now);
        const double insertion = plan.trocar.shaft_length - handle.norm();
        tip_ = plan.trocar.position + plan.trocar.rotation * (-insertion * handle.normalized());
        last_ = now;
    }
    plan_ = &plan;
    leg_ = in_leg_ = 0;
    from_ = tip_;
    begun_.store(tick);
}

void ProddingRig::read(std::uint32_t tick, RigSample& sample) {
    rig_->read(tick, sample);
    if (tick < times_.size()) times_[tick] = monotonic_ns();
    const Plan* const newest = newest_.load(std::memory_order_acquire);
    if (newest == nullptr) return;
    if (newest != plan_) take(*newest, tick, sample.hand[newest->hand]);
    bool energy = false;
    if (leg_ < plan_->legs.size()) {
        const Leg& leg = plan_->legs[leg_];
        energy = leg.energy;
        tip_ = from_ + (static_cast<double>(++in_leg_) / leg.ticks) * (leg.to - from_);
        if (in_leg_ >= leg.ticks) {
            from_ = leg.to;
            in_leg_ = 0;
            ++leg_;
        }
        if (leg_ == plan_->legs.size()) {
            ended_.store(tick);
            finished_.store(true, std::memory_order_release);
        }
    }
    DeviceReading reading;
    reading.handle = handle_for_tip(plan_->trocar, tip_);
    reading.jaw = plan_->jaw;
    reading.buttons = energy ? button_energy : button_none;
    last_ = sample.hand[plan_->hand] = quantise(reading, last_);
}

}  // namespace fulcrum::app::program_test
