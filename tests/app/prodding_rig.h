// SPDX-License-Identifier: GPL-3.0-or-later
// A hand whose tip a test sends along straight lines, in place of the device of the hands. It notes when each
// tick was read: what happens in that tick happens from then on.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/instrument/mouse_mapping.h"

namespace fulcrum::app::program_test {

class ProddingRig : public Rig {
  public:
    /// A straight line of the tip, patient frame, in so many ticks.
    struct Leg {
        Vector3 to = Vector3::Zero();
        std::uint32_t ticks = 1;
        bool energy = false;  ///< its pedal is pressed
    };

    explicit ProddingRig(std::shared_ptr<Rig> rig) : rig_(std::move(rig)), times_(most_ticks, 0) {}

    /// Thread of the test, while finished(): from where the tip is now.
    void send(const InstrumentSpec& spec, std::vector<Leg> legs) {
        auto plan = std::make_unique<Plan>();
        plan->trocar = make_trocar(spec.trocar);
        plan->hand = static_cast<int>(spec.hand);
        plan->jaw = spec.jaw_opening * open_jaw_share;
        plan->legs = std::move(legs);
        finished_.store(false);
        newest_.store(plan.get(), std::memory_order_release);
        plans_.push_back(std::move(plan));  // the other thread may still read the one before
    }
    bool finished() const { return finished_.load(std::memory_order_acquire); }
    /// Of the newest plan, once finished(): its first tick and its last.
    std::uint32_t begun() const { return begun_.load(); }
    std::uint32_t ended() const { return ended_.load(); }
    /// ns of CLOCK_MONOTONIC; after the attempt.
    std::int64_t time_of(std::uint32_t tick) const { return tick < times_.size() ? times_[tick] : 0; }

    void read(std::uint32_t tick, RigSample& sample) override;
    void write_force(Hand hand, const Vector3& force) override { rig_->write_force(hand, force); }
    bool has_force(Hand hand) const override { return rig_->has_force(hand); }
    double damping(Hand hand) const override { return rig_->damping(hand); }
    std::optional<ForceOutput> force_output(Hand hand) const override { return rig_->force_output(hand); }
    std::optional<RigUse> use() const override { return rig_->use(); }

  private:
    static constexpr std::size_t most_ticks = 600000;
    struct Plan {
        Trocar trocar;
        int hand = 0;
        double jaw = 0;
        std::vector<Leg> legs;
    };
    void take(const Plan& plan, std::uint32_t tick, const DeviceSample& now);

    std::shared_ptr<Rig> rig_;
    std::vector<std::unique_ptr<Plan>> plans_;  // of the test's thread
    std::atomic<const Plan*> newest_{nullptr};
    std::atomic<bool> finished_{true};
    std::atomic<std::uint32_t> begun_{0}, ended_{0};
    // Of the haptic thread.
    std::vector<std::int64_t> times_;
    const Plan* plan_ = nullptr;
    std::size_t leg_ = 0;
    std::uint32_t in_leg_ = 0;
    Vector3 from_ = Vector3::Zero(), tip_ = Vector3::Zero();
    DeviceSample last_;
};

}  // namespace fulcrum::app::program_test
