// SPDX-License-Identifier: Apache-2.0
// Events of one hand on tissue: forces above limits, pressure, perforation, wall contact, grasps and their
// ends.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "assessment/task/monitor.h"

namespace fulcrum {

/// A tissue's limits as an attempt's monitor needs them, forces in mN as samples carry them. 0: none.
struct TissueWatch {
    double force_limit = 0;        ///< mN
    double perforation_limit = 0;  ///< mN, drawn for this attempt
    double pressure_limit = 0;     ///< Pa
    bool wall = false;             ///< contact is worth an event
};

/// The change of a hand's grasp in a step.
enum class HoldChange : std::uint8_t { none, grasped, released, slipped };

/// One hand. Fixed size, allocates nothing, never throws.
class HandMonitor {
  public:
    void configure(Hand hand, const Scene& scene, const std::vector<TissueWatch>* tissues,
                   double warning_margin);
    /// One tick: forces, pressure, perforation, wall contact.
    void tick(const TickSample& sample, EventSink& sink) noexcept;
    /// Where the tip is in this tick, 0.1 um: for speed() alone. tick() does this too.
    void move(const std::int32_t (&tip)[3], bool inside) noexcept;
    /// After the step: the hold as the world left it. `tick` stamps the events; `clock`: ticks of the attempt
    /// so far, pauses excluded.
    HoldChange hold(const GraspState& grasp, std::uint32_t tick, std::uint32_t clock,
                    EventSink& sink) noexcept;
    /// Speed of the tip over the last 20 ms inside the body, m/s; 0 outside or before 20 ms have passed.
    double speed() const noexcept { return speed_; }
    /// What this hand let go of last, to tell a regrasp by either hand.
    struct Released {
        HeldBody body = HeldBody::none;
        std::int32_t patch = -1;
        Vector3 rest = Vector3::Zero();  ///< m, of a sheet: the place at rest
        std::uint32_t clock = 0;         ///< ticks of the attempt until then, pauses excluded
        bool valid = false;
    };
    const Released& released() const noexcept { return released_; }
    /// Whether a grasp of this hand takes what was released there: the same patch; of a sheet, which has
    /// none, a place of the same septum nearer than this hand's jaws are long. What has neither (a membrane)
    /// is never the same.
    bool takes_again(const Released& place, const GraspState& grasp) const noexcept;
    void forget_released() noexcept { released_.valid = false; }

    /// Since the last begin_step(): for the display.
    void begin_step() noexcept { step_force_ = 0; }
    double step_force() const noexcept { return step_force_; }    ///< N
    double force_limit() const noexcept { return limit_shown_; }  ///< N, 0 none
    bool warning() const noexcept { return warning_; }

    /// All that changes.
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(tips_, samples_, speed_, step_force_, limit_shown_, warning_, was_inside_, over_, perforated_,
              pressed_, on_wall_, held_, faulty_, over_tissue_, away_ticks_, over_peak_, over_limit_,
              last_grasp_, released_);
    }

  private:
    void emit(EventSink& sink, std::uint32_t tick, EventKind kind, int tissue, std::int32_t detail,
              double value) const noexcept;

    static constexpr int speed_span = 20;  // samples at 1 kHz; see move()
    const std::vector<TissueWatch>* tissues_ = nullptr;
    Hand hand_ = Hand::left;
    double tick_rate_ = 1000, warning_margin_ = 0;
    double jaw_length_ = 0;    // m
    double septum_width_ = 0;  // m, 0 without septa
    std::array<std::array<std::int32_t, 3>, 128> tips_{};
    int span_ = speed_span;
    std::uint64_t samples_ = 0;
    double speed_ = 0, step_force_ = 0, limit_shown_ = 0;
    bool warning_ = false, was_inside_ = false;
    bool over_ = false, perforated_ = false, pressed_ = false, on_wall_ = false, held_ = false,
         faulty_ = false;
    int over_tissue_ = -1;
    std::uint32_t away_ticks_ = 0;
    double over_peak_ = 0, over_limit_ = 0;
    GraspState last_grasp_;
    Released released_;
};

}  // namespace fulcrum
