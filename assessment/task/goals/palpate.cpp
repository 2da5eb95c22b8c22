// SPDX-License-Identifier: Apache-2.0
// palpate: the closed instrument rests on a stretch of bowel and stays in contact with it.
#include <algorithm>
#include <limits>

#include "assessment/task/goal_tracker.h"

namespace fulcrum {
namespace {

constexpr double longest_gap_s = 0.2;  // contact that a hand's own tremor breaks for so long continues

class PalpationTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    bool tick(const TickSample& sample, const WorldSnapshot& world, GoalEvents& events) noexcept override {
        const HandSample& hand = sample.hand[static_cast<std::size_t>(goal_.hand)];
        const bool rests = (hand.flags & hand_inside) != 0 && (hand.flags & hand_grasping) == 0 &&
                           hand.tissue == watch_.bowel_tissue && on_stretch(hand, world);
        away_ticks_ = rests ? 0 : away_ticks_ + 1;
        contact_ = away_ticks_ * watch_.tick_period <= longest_gap_s && (rests || hold_ticks_ > 0);
        const int before = whole_seconds();
        const bool met = hold(contact_, 1);
        if (whole_seconds() > before) events.progress(whole_seconds());
        return met;
    }

    bool at_target(Hand hand) const noexcept override { return contact_ && goal_.hand == hand; }

    void show(TaskDisplay& display) const noexcept override {
        display.goal_progress = display.hold_progress = held_share();
    }

    void transfer(StateArchive& archive) override {
        GoalTracker::transfer(archive);
        archive(away_ticks_, contact_);
    }

  private:
    int whole_seconds() const noexcept { return static_cast<int>(held_s() + 1e-9); }

    /// The point of the centre line nearest to the tip lies between from_m and to_m.
    bool on_stretch(const HandSample& hand, const WorldSnapshot& world) const noexcept {
        const Vector3 tip = sample_length_unit * Vector3(hand.tip[0], hand.tip[1], hand.tip[2]);
        const std::size_t count = std::min(world.bowel.nodes.size(), world.bowel.node_arc_lengths.size());
        double nearest = std::numeric_limits<double>::max(), place = -1;
        for (std::size_t i = 0; i < count; ++i) {
            const double away = (world.bowel.nodes[i] - tip).squaredNorm();
            if (away >= nearest) continue;
            nearest = away;
            place = world.bowel.node_arc_lengths[i];
        }
        return place >= goal_.from_m && place <= goal_.to_m;
    }

    std::uint32_t away_ticks_ = 0;
    bool contact_ = false;
};

}  // namespace

namespace goals {

std::unique_ptr<GoalTracker> track_palpation(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<PalpationTracker>(goal, watch);
}

}  // namespace goals
}  // namespace fulcrum
