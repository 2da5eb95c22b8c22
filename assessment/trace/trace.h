// SPDX-License-Identifier: Apache-2.0
// The time series of an attempt for the metrics: columns of SI doubles in the patient frame, whatever the
// source. An empty column means that the channel was not recorded; a metric that needs it is absent with this
// reason.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim_core/numerics/types.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum {

/// What was recorded of a hand, and the camera's pose. Metrics name the channels they need.
enum class Channel : std::uint8_t {
    position,
    axis,
    roll,
    force,
    jaw_force,
    jaw_area,
    tissue,
    patch,
    inside,
    in_view,
    energy,
    cutting,
    scope,  ///< CameraTrace, of no hand
};
/// The CSV columns of a channel without the hand's prefix, as a person would look for them ("px py pz").
const char* channel_columns(Channel channel);

/// One instrument; every column has as many entries as Trace::t, or none.
struct HandTrace {
    std::vector<double> px, py, pz;     ///< m, tip, patient frame
    std::vector<double> ax, ay, az;     ///< unit shaft axis, trocar to tip
    std::vector<double> roll;           ///< rad
    std::vector<double> fx, fy, fz;     ///< N, instrument on tissue, the model's force before any clamp
    std::vector<double> tx, ty, tz;     ///< N m, of that force about the trocar
    std::vector<double> jaw_force;      ///< N
    std::vector<double> jaw_area;       ///< m2
    std::vector<std::int16_t> tissue;   ///< index into Trace::tissues, -1 none
    std::vector<std::int16_t> patch;    ///< tissue patch, -1 none
    std::vector<std::uint8_t> inside;   ///< 1 inside the body; not recorded means always inside
    std::vector<std::uint8_t> in_view;  ///< 1 the tip is in the image
    std::vector<std::uint8_t> energy;   ///< 1 energy is on
    std::vector<std::uint8_t> cutting;  ///< 1 the blade is in the tissue; not recorded means never

    /// True where every column of the channel is recorded.
    bool has(Channel channel) const;
};

/// Scope tip (m) and orientation (camera to patient, camera looks along -z); empty when not recorded.
struct CameraTrace {
    std::vector<double> px, py, pz;
    std::vector<double> qw, qx, qy, qz;

    bool recorded() const { return !px.empty() && !qw.empty(); }
};

/// Seconds since the attempt began, begin <= end.
struct TimeInterval {
    double begin = 0;
    double end = 0;
};

/// Samples [first, last) that belong together: no gap above 0.1 s, no pause, no lost sample between them.
struct TraceBlock {
    std::size_t first = 0;
    std::size_t last = 0;
};

struct Trace {
    std::vector<double> t;  ///< s since the attempt began, strictly rising
    std::array<HandTrace, hand_count> hand;
    CameraTrace camera;
    std::vector<std::string> tissues;  ///< labels that HandTrace::tissue points into
    std::vector<TraceBlock>
        blocks;  ///< in order; samples in no block were taken during a pause or after the end
    std::vector<TimeInterval>
        pauses;                      ///< the attempt's pauses (by the trainee, or while the device was gone)
    double tick_period = 0.001;      ///< s, turns Event::tick into t
    double end = 0;                  ///< s, the end event's time, or the last sample's without one
    std::uint64_t samples_lost = 0;  ///< as the samples_lost events say
    std::vector<TimeInterval> gaps;  ///< between samples more than 0.1 s apart that no pause explains
    std::vector<std::string> ignored_columns;  ///< CSV columns that the format does not know

    double time_of(const Event& event) const { return event.tick * tick_period; }
    /// Samples a second inside blocks; 0 for fewer than two samples.
    double mean_rate() const;
};

/// Channels of a hand, a bit each.
using ChannelSet = std::uint32_t;
constexpr ChannelSet bit_of(Channel channel) {
    return ChannelSet{1} << static_cast<unsigned>(channel);
}
inline constexpr ChannelSet every_channel = bit_of(Channel::scope) - 1;

/// Which columns a trace gets: an hour with all of them takes 1.1 GB.
struct TraceContent {
    std::array<ChannelSet, hand_count> hand{every_channel, every_channel};
    bool torque = true;  ///< with the force of a hand
    bool scope = true;
};

/// Makes a trace of samples that come one after the other and need not be in memory together.
class TraceBuilder {
  public:
    /// `samples`: as many as will be added, or more. `tissues`: the scene's table.
    TraceBuilder(std::size_t samples, const std::vector<std::string>& tissues, int tick_rate,
                 const TraceContent& content);
    void add(const TickSample& sample);
    /// Once, at the end.
    Trace finish(const std::vector<Event>& events);

  private:
    Trace trace_;
    int tick_rate_;
    TraceContent content_;
};

/// From the record of an attempt. `tissues` is the scene's table; hands without an instrument get no
/// channels.
Trace trace_from_samples(const std::vector<TickSample>& samples, const std::vector<Event>& events,
                         const std::vector<std::string>& tissues, int tick_rate = 1000,
                         std::array<bool, hand_count> hands = {true, true});

/// Puts `labels` first in the trace's table of tissues, in their order, and keeps the labels that are not
/// among them behind; so that events of a scene with this table fit the trace.
void put_labels_first(Trace& trace, const std::vector<std::string>& labels);

/// Fills blocks, pauses, end and samples_lost from t and the events: split at gaps above 0.1 s, at pauses,
/// where samples were lost; what follows the end event belongs to no block.
void split_blocks(Trace& trace, const std::vector<Event>& events);

}  // namespace fulcrum
