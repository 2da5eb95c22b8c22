// SPDX-License-Identifier: Apache-2.0
// Says while an attempt runs how soon its record must be in the store, so that a crash a moment later does
// not take back what fails it: a limit that a force, a pressure or a count breaks for good, a critical error.
// Coarser than the metrics, which decide at the end: it may ask too early, seldom too late. Allocates nothing
// after construction, never throws.
#pragma once

#include <cstdint>
#include <vector>

#include "assessment/scoring/judged_limits.h"
#include "sim_core/scene/scene.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum {

class LimitWatch {
  public:
    /// `limits`: of the task's gates, see judged_limits().
    LimitWatch(const TaskDefinition& task, const Scene& scene, const std::vector<JudgedLimit>& limits);

    /// What goes into the record, in order.
    void see(const TickSample& sample) noexcept;
    void see(const Event& event) noexcept;
    /// Whether to write now, with the last write so many ticks ago. At once: the first time that a limit is
    /// exceeded, once it is exceeded for long enough to stay broken whatever follows, and for each event that
    /// counts towards a limit or ends the attempt. Everything else that asks for a write (the same limit
    /// again, an event that fails nobody by itself) waits until a fifth of a second has passed.
    bool due(std::uint32_t ticks_since_write) const noexcept;
    /// All that was seen is in the store. A limit that this leaves broken asks no more.
    void written() noexcept;

  private:
    enum class Need : std::uint8_t { none, soon, now };
    enum class Load : std::uint8_t { tip, jaws, pressure, jaws_over_time };
    /// A limit of what a sample has. N, Pa, N s.
    struct Row {
        Load load = Load::tip;
        int hand = 0, tissue = -1;  ///< -1: all
        double limit = 0;
        double product = 0;       ///< of the grasp so far
        std::uint32_t clear = 0;  ///< ticks in a row clearly above the limit
        bool met = false;         ///< exceeded at least once
        bool lasting = false;     ///< exceeded for long enough
        bool stored = false;      ///< and in the store
    };
    /// A limit of what events count or report.
    struct EventRow {
        EventKind kind = EventKind::perforation;
        int hand = -1;          ///< -1: both
        int tissue = -1;        ///< -1: all
        bool reported = false;  ///< the event's value is the total so far; else each counts one
        double limit = 0, so_far = 0;
    };

    void add(const JudgedLimit& limit, int hand, int tissue);
    double value_of(Row& row, const HandSample& sample) const noexcept;
    void ask(Need need) noexcept { need_ = need > need_ ? need : need_; }

    std::vector<Row> rows_;
    std::vector<EventRow> events_;
    double tick_period_ = 1e-3;
    std::uint32_t lasting_ticks_ = 25, soon_ticks_ = 200;
    Need need_ = Need::none;
};

}  // namespace fulcrum
