// SPDX-License-Identifier: Apache-2.0
// Shared by all metrics: the record resampled and filtered once, divided into blocks, with its pauses and
// movement segments. Kinematics: 1 kHz, 10 Hz low-pass, then 100 Hz. Forces: 1 kHz, 50 Hz low-pass. Filters
// and segments end at the border of a block.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/metrics/registry.h"
#include "assessment/trace/trace.h"

namespace fulcrum {

inline constexpr double force_rate = 1000.0;  ///< Hz
inline constexpr double motion_rate = 100.0;  ///< Hz
inline constexpr double contact_force = 0.1;  ///< N, smaller forces count as zero
inline constexpr double rest_speed = 0.005;   ///< m/s
inline constexpr double rest_time = 0.2;      ///< s, shortest pause

/// Samples [first, last) of a block's series.
struct Run {
    std::size_t first = 0, last = 0;
    std::size_t size() const { return last - first; }
};
/// Maximal runs of samples that fulfil `test(i)`.
template <typename Test>
std::vector<Run> runs_of(std::size_t size, Test test) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < size; ++i) {
        if (!test(i)) continue;
        if (runs.empty() || runs.back().last != i) runs.push_back({i, i});
        runs.back().last = i + 1;
    }
    return runs;
}

/// A trace block at 1 kHz: positions of its samples between those of the trace.
class UniformGrid {
  public:
    UniformGrid(const std::vector<double>& t, const TraceBlock& block);
    double begin() const { return begin_; }
    std::size_t size() const { return size_; }
    std::vector<double> interpolate(const std::vector<double>& column) const;
    /// Interpolates only between samples with the same label, else holds: a force on one tissue says nothing
    /// of the time on the next. Without labels as interpolate().
    std::vector<double> interpolate_within(const std::vector<double>& column,
                                           const std::vector<std::int16_t>& label) const;
    /// The value of the last sample at or before, for labels and flags.
    template <typename T>
    std::vector<T> hold(const std::vector<T>& column) const {
        std::vector<T> out(size_);
        for (std::size_t i = 0; i < size_; ++i) out[i] = column[index_.empty() ? first_ + i : index_[i]];
        return out;
    }

  private:
    double begin_ = 0;
    std::size_t first_ = 0, size_ = 0;
    std::vector<std::size_t>
        index_;  ///< sample at or before each grid point; empty where the trace is at 1 kHz itself
    std::vector<double> fraction_;
};

/// One hand's motion in one block at 100 Hz. `position` and `axis` begin and end with the rest that the
/// filter holds before the first and after the last sample (`held` columns at each side), so that no path is
/// lost if a block ends in motion. Between the held columns and the block the hand counts as moving straight:
/// the filter's ringing in the held time is not a movement. All other members cover the block only.
struct MotionBlock {
    static constexpr std::size_t held = 1;
    double begin = 0;                           ///< s
    Eigen::Matrix3Xd position, axis;            ///< m; unit; axis empty when not recorded
    std::vector<double> speed;                  ///< m/s, central differences
    std::vector<double> angular_speed;          ///< rad/s; empty when the axis is not recorded
    std::vector<std::uint8_t> active, in_view;  ///< in_view empty when not recorded
    std::vector<std::int16_t> tissue;           ///< index into Analysis::tissues(); empty when not recorded
    std::vector<std::uint8_t> pause;            ///< 1 within a pause

    std::size_t size() const { return speed.size(); }
    double time(std::size_t i) const { return begin + static_cast<double>(i) / motion_rate; }
    /// Nearest sample of a time within the block.
    std::size_t index(double t) const;
    Eigen::Vector3d point(std::size_t i) const { return position.col(static_cast<Eigen::Index>(i + held)); }
    Eigen::Vector3d direction(std::size_t i) const { return axis.col(static_cast<Eigen::Index>(i + held)); }
    TimeInterval interval(const Run& run) const { return {time(run.first), time(run.last - 1)}; }
};

/// A movement between two pauses: the samples between them, and those samples extended outwards while the
/// speed falls.
struct Segment {
    std::size_t block = 0;
    Run core, whole;
};
/// Pauses of a speed profile at 100 Hz: below 5 mm/s for 0.2 s; a rest cut short by an end of the profile
/// also counts.
std::vector<std::uint8_t> find_pauses(const std::vector<double>& speed);
/// Valid movement segments: 0.3 s to 10 s long, peak at least 20 mm/s, a pause on both sides.
std::vector<Segment> find_segments(const std::vector<double>& speed, const std::vector<std::uint8_t>& pause);

/// The contact-free movement of a profile, and the movements in it.
struct FreeMovement {
    std::vector<Segment> segments;
    std::size_t samples = 0;  ///< outside pauses, without contact, in runs of at least 0.3 s
};
/// Movements without contact: runs outside pauses and without `contact`, divided where the speed falls below
/// half of both the peak before and the peak after it. Valid: 0.3 s to 10 s long, peak at least 20 mm/s,
/// not cut off by an end of the profile. So neither stopping nor never stopping changes what is measured.
/// `contact`: 1 where a blade is in tissue or the jaws hold it; interruptions below 0.2 s count as contact.
FreeMovement find_free_movements(const std::vector<double>& speed, const std::vector<std::uint8_t>& pause,
                                 std::vector<std::uint8_t> contact);

/// One hand's forces in one block at 1 kHz.
struct ForceBlock {
    double begin = 0;
    Eigen::Matrix3Xd force;        ///< N, filtered; no columns when not recorded
    std::vector<double> norm;      ///< N, of the filtered force
    std::vector<double> jaw;       ///< N, filtered; empty when not recorded
    std::vector<double> pressure;  ///< Pa, jaw force over area, filtered; empty when not recorded
    std::vector<std::uint8_t>
        grasp;  ///< 1 where the jaws press on tissue; empty when the jaw force is not recorded
    std::vector<std::int16_t> tissue, patch;

    double time(std::size_t i) const { return begin + static_cast<double>(i) / force_rate; }
    TimeInterval interval(const Run& run) const { return {time(run.first), time(run.last - 1)}; }
    bool on(std::size_t i, int label) const { return label < 0 || (!tissue.empty() && tissue[i] == label); }
};

/// A hand's force and jaw columns (no others) with spikes replaced in the samples as they were taken, before
/// anything spreads them; adds how many to `replaced`. Below 500 Hz nothing is replaced: there a spike looks
/// like a short force.
HandTrace despiked_forces(const Trace& trace, std::size_t h, std::size_t& replaced);

struct HandAnalysis {
    std::vector<MotionBlock> motion;
    std::vector<Segment> segments;        ///< between pauses, whatever the hand touches
    std::vector<Segment> free_segments;   ///< contact-free movements, see find_free_movements()
    std::size_t moving_samples = 0;       ///< at 100 Hz, outside pauses
    std::size_t free_moving_samples = 0;  ///< FreeMovement::samples
    std::optional<double> noise_at_rest;  ///< m, the device's: SD over pauses of position minus its 50 Hz
                                          ///< low-pass, worst component
    std::vector<ForceBlock> force;
    std::vector<std::uint8_t> touched;  ///< by tissue: 1 where the hand was in contact with it
};

class Analysis {
  public:
    Analysis(const Trace& trace, const std::vector<Event>& events, const MetricContext& context);

    const Trace& trace() const { return trace_; }
    const std::vector<Event>& events() const { return events_; }
    const MetricContext& context() const { return context_; }
    /// The scope's lens as a hand's tip: `motion` and what follows of it. Built when first asked for, so one
    /// thread at a time; empty where the scope was not recorded.
    const HandAnalysis& scope() const;
    const HandAnalysis& hand(int h) const { return hands_[static_cast<std::size_t>(h)]; }
    /// The labels of the trace, then those that are only in the context.
    const std::vector<std::string>& tissues() const { return tissues_; }
    /// Force limit of a tissue, N.
    std::optional<double> force_limit(int tissue) const;
    bool any_force_limit() const;
    double mean_rate() const { return mean_rate_; }
    /// The 1 kHz grids of the blocks, as hand(h).motion and hand(h).force count them.
    const std::vector<UniformGrid>& grids() const { return grids_; }
    /// Index of the motion block that covers a time.
    std::optional<std::size_t> block_at(int h, double t) const;
    /// Start of the hand's first active movement: speed above 5 mm/s for 0.2 s inside the body.
    std::optional<double> first_movement(int h) const;

  private:
    HandAnalysis motion_of(const HandTrace& hand) const;
    void build_force(std::size_t h);
    void add_forces(std::size_t h);
    void add_jaw(std::size_t h);

    const Trace& trace_;
    const std::vector<Event>& events_;
    const MetricContext& context_;
    std::vector<std::string> tissues_;
    std::vector<UniformGrid> grids_;
    std::array<HandAnalysis, hand_count> hands_;
    mutable std::optional<HandAnalysis> scope_;
    double mean_rate_ = 0;
};

/// The first movement as the monitor saw it, s; before everything where it saw none.
double begin_of(const Analysis& analysis);
/// Seconds of [begin, end] outside the attempt's pauses.
double running_time(const Trace& trace, double begin, double end);

/// Largest number of intervals in the evidence of a row; the worst are kept.
inline constexpr std::size_t evidence_limit = 20;
/// An interval with a score; the evidence of a row is sorted by falling score.
struct ScoredInterval {
    double score = 0;
    TimeInterval interval;
};
std::vector<TimeInterval> worst_first(std::vector<ScoredInterval> intervals);
/// Appends the 5 s of a block in which `amount`, one value for each sample, has its largest sum.
void worst_window(const MotionBlock& block, const std::vector<double>& amount,
                  std::vector<ScoredInterval>& out);

/// Events of a kind that the row's hand and tissue select, with half a second to either side of each as
/// evidence.
Figure count_events(const Analysis& analysis, const Selection& row, EventKind kind);
/// The same as a metric's own function.
template <EventKind kind>
Figure counted(const Analysis& analysis, const Selection& row) {
    return count_events(analysis, row, kind);
}

}  // namespace fulcrum
