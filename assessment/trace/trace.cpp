// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/trace.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

constexpr double gap_limit_s = 0.1;

// Division, not multiplication by the unit: it gives the double nearest to the decimal that the count stands
// for.
double length_of(std::int32_t count) {
    return count / 1e7;
}
double axis_of(std::int32_t count) {
    return count / 1e8;
}
double angle_of(std::int32_t count) {
    return count / 1e6;
}
double force_of(std::int32_t count) {
    return count / 1e3;
}
double torque_of(std::int32_t count) {
    return count / 1e5;
}
double area_of(std::int32_t count) {
    return count / 1e9;
}
static_assert(sample_length_unit == 1e-7 && sample_axis_unit == 1e-8 && sample_angle_unit == 1e-6 &&
              sample_force_unit == 1e-3 && sample_area_unit == 1e-9 && sample_torque_unit == 1e-5);

/// Calls visit(column, value of a sample of the hand) for each column of these channels.
template <typename Visit>
void each_column(HandTrace& hand, ChannelSet channels, bool torque, Visit visit) {
    const auto wants = [channels](Channel channel) { return (channels & bit_of(channel)) != 0; };
    const auto vector3 = [&](std::vector<double>& x, std::vector<double>& y, std::vector<double>& z,
                             const std::int32_t(HandSample::*field)[3], double (*convert)(std::int32_t)) {
        visit(x, [=](const HandSample& s) { return convert((s.*field)[0]); });
        visit(y, [=](const HandSample& s) { return convert((s.*field)[1]); });
        visit(z, [=](const HandSample& s) { return convert((s.*field)[2]); });
    };
    if (wants(Channel::position)) vector3(hand.px, hand.py, hand.pz, &HandSample::tip, length_of);
    if (wants(Channel::axis)) vector3(hand.ax, hand.ay, hand.az, &HandSample::axis, axis_of);
    if (wants(Channel::force)) vector3(hand.fx, hand.fy, hand.fz, &HandSample::force, force_of);
    if (wants(Channel::force) && torque) vector3(hand.tx, hand.ty, hand.tz, &HandSample::torque, torque_of);
    if (wants(Channel::roll)) visit(hand.roll, [](const HandSample& s) { return angle_of(s.roll); });
    if (wants(Channel::jaw_force))
        visit(hand.jaw_force, [](const HandSample& s) { return force_of(s.jaw_force); });
    if (wants(Channel::jaw_area))
        visit(hand.jaw_area, [](const HandSample& s) { return area_of(s.jaw_area); });
    if (wants(Channel::tissue)) visit(hand.tissue, [](const HandSample& s) { return s.tissue; });
    if (wants(Channel::patch)) visit(hand.patch, [](const HandSample& s) { return s.patch; });
    const auto flag = [&](Channel channel, std::vector<std::uint8_t>& column, HandFlag mask) {
        if (!wants(channel)) return;
        visit(column, [mask](const HandSample& s) {
            return static_cast<std::uint8_t>((s.flags & mask) != 0 ? 1 : 0);
        });
    };
    flag(Channel::inside, hand.inside, hand_inside);
    flag(Channel::in_view, hand.in_view, hand_in_view);
    flag(Channel::energy, hand.energy, hand_energy);
    flag(Channel::cutting, hand.cutting, hand_cutting);
}

/// The same of the scope.
template <typename Visit>
void each_column(CameraTrace& camera, Visit visit) {
    visit(camera.px, [](const CameraSample& s) { return length_of(s.tip[0]); });
    visit(camera.py, [](const CameraSample& s) { return length_of(s.tip[1]); });
    visit(camera.pz, [](const CameraSample& s) { return length_of(s.tip[2]); });
    visit(camera.qw, [](const CameraSample& s) { return axis_of(s.orientation[0]); });
    visit(camera.qx, [](const CameraSample& s) { return axis_of(s.orientation[1]); });
    visit(camera.qy, [](const CameraSample& s) { return axis_of(s.orientation[2]); });
    visit(camera.qz, [](const CameraSample& s) { return axis_of(s.orientation[3]); });
}

double time_of_tick(const TickSample& sample, int tick_rate) {
    return static_cast<double>(sample.tick) / tick_rate;
}

bool ends_attempt(EventKind kind) {
    return kind == EventKind::completed || kind == EventKind::abandoned || kind == EventKind::timed_out ||
           kind == EventKind::interrupted;
}

}  // namespace

const char* channel_columns(Channel channel) {
    switch (channel) {
        case Channel::position:
            return "px py pz";
        case Channel::axis:
            return "ax ay az";
        case Channel::roll:
            return "roll";
        case Channel::force:
            return "fx fy fz";
        case Channel::jaw_force:
            return "jaw";
        case Channel::jaw_area:
            return "jaw_area";
        case Channel::tissue:
            return "tissue";
        case Channel::patch:
            return "patch";
        case Channel::inside:
            return "inside";
        case Channel::in_view:
            return "in_view";
        case Channel::energy:
            return "energy";
        case Channel::cutting:
            return "cutting";
        case Channel::scope:
            return "camera.px camera.py camera.pz camera.qw camera.qx camera.qy camera.qz";
    }
    return "";
}

bool HandTrace::has(Channel channel) const {
    switch (channel) {
        case Channel::position:
            return !px.empty() && !py.empty() && !pz.empty();
        case Channel::axis:
            return !ax.empty() && !ay.empty() && !az.empty();
        case Channel::roll:
            return !roll.empty();
        case Channel::force:
            return !fx.empty() && !fy.empty() && !fz.empty();
        case Channel::jaw_force:
            return !jaw_force.empty();
        case Channel::jaw_area:
            return !jaw_area.empty();
        case Channel::tissue:
            return !tissue.empty();
        case Channel::patch:
            return !patch.empty();
        case Channel::inside:
            return !inside.empty();
        case Channel::in_view:
            return !in_view.empty();
        case Channel::energy:
            return !energy.empty();
        case Channel::cutting:
            return !cutting.empty();
        case Channel::scope:
            return false;
    }
    return false;
}

double Trace::mean_rate() const {
    double steps = 0, duration = 0;
    for (const TraceBlock& block : blocks) {
        if (block.last - block.first < 2) continue;
        steps += static_cast<double>(block.last - block.first - 1);
        duration += t[block.last - 1] - t[block.first];
    }
    // A trace so slow that every sample is a block of its own still has a rate.
    if (duration <= 0 && t.size() >= 2) {
        steps = static_cast<double>(t.size() - 1);
        duration = t.back() - t.front();
    }
    return duration > 0 ? steps / duration : 0;
}

TraceBuilder::TraceBuilder(std::size_t samples, const std::vector<std::string>& tissues, int tick_rate,
                           const TraceContent& content)
    : tick_rate_(tick_rate), content_(content) {
    trace_.tick_period = 1.0 / tick_rate;
    trace_.tissues = tissues;
    trace_.t.reserve(samples);
    const auto reserve = [samples](auto& column, auto) { column.reserve(samples); };
    for (std::size_t h = 0; h < trace_.hand.size(); ++h)
        each_column(trace_.hand[h], content.hand[h], content.torque, reserve);
    if (content.scope) each_column(trace_.camera, reserve);
}

void TraceBuilder::add(const TickSample& sample) {
    trace_.t.push_back(time_of_tick(sample, tick_rate_));
    for (std::size_t h = 0; h < trace_.hand.size(); ++h)
        each_column(trace_.hand[h], content_.hand[h], content_.torque,
                    [&](auto& column, auto get) { column.push_back(get(sample.hand[h])); });
    if (content_.scope)
        each_column(trace_.camera, [&](auto& column, auto get) { column.push_back(get(sample.camera)); });
}

Trace TraceBuilder::finish(const std::vector<Event>& events) {
    split_blocks(trace_, events);
    return std::move(trace_);
}

Trace trace_from_samples(const std::vector<TickSample>& samples, const std::vector<Event>& events,
                         const std::vector<std::string>& tissues, int tick_rate,
                         std::array<bool, hand_count> hands) {
    // Column by column, which is faster where all samples are in memory.
    Trace trace;
    trace.tick_period = 1.0 / tick_rate;
    trace.tissues = tissues;
    const auto fill = [&](auto& column, auto get) {
        column.resize(samples.size());
        std::transform(samples.begin(), samples.end(), column.begin(), get);
    };
    fill(trace.t, [&](const TickSample& s) { return time_of_tick(s, tick_rate); });
    for (std::size_t h = 0; h < hands.size(); ++h)
        each_column(trace.hand[h], hands[h] ? every_channel : 0, true, [&](auto& column, auto get) {
            fill(column, [&](const TickSample& s) { return get(s.hand[h]); });
        });
    each_column(trace.camera, [&](auto& column, auto get) {
        fill(column, [&](const TickSample& s) { return get(s.camera); });
    });
    split_blocks(trace, events);
    return trace;
}

void put_labels_first(Trace& trace, const std::vector<std::string>& labels) {
    std::vector<std::string> table = labels;
    std::vector<std::int16_t> place;  // of each label of the trace in the new table
    for (const std::string& label : trace.tissues) {
        const auto found = std::find(table.begin(), table.end(), label);
        place.push_back(static_cast<std::int16_t>(found - table.begin()));
        if (found == table.end()) table.push_back(label);
    }
    for (HandTrace& hand : trace.hand)
        for (std::int16_t& tissue : hand.tissue)
            if (tissue >= 0) tissue = place[static_cast<std::size_t>(tissue)];
    trace.tissues = std::move(table);
}

void split_blocks(Trace& trace, const std::vector<Event>& events) {
    trace.blocks.clear();
    trace.pauses.clear();
    trace.gaps.clear();
    trace.samples_lost = 0;
    trace.end = trace.t.empty() ? 0.0 : trace.t.back();
    std::vector<double> cuts;  // where samples were lost
    bool paused = false, device_gone = false, ended = false;
    double pause_begin = 0;
    for (const Event& event : events) {
        const double t = trace.time_of(event);
        const bool was_stopped = paused || device_gone;
        if (event.kind == EventKind::pause) paused = true;
        if (event.kind == EventKind::resume) paused = false;
        if (event.kind == EventKind::device_lost) device_gone = true;
        if (event.kind == EventKind::device_back) device_gone = false;
        const bool is_stopped = paused || device_gone;
        if (is_stopped && !was_stopped) pause_begin = t;
        if (was_stopped && !is_stopped) trace.pauses.push_back({pause_begin, std::max(pause_begin, t)});
        if (event.kind == EventKind::samples_lost) {
            trace.samples_lost += static_cast<std::uint64_t>(std::max(0, event.detail));
            cuts.push_back(t);
        }
        if (ends_attempt(event.kind) && !ended) {
            ended = true;
            trace.end = t;
        }
    }
    const bool endless = paused || device_gone;  // never resumed
    if (endless) trace.pauses.push_back({pause_begin, std::max(pause_begin, trace.end)});

    // Where samples are taken at a lower rate than ten a second, every one of them stands alone.
    std::sort(cuts.begin(), cuts.end());
    std::size_t pause = 0, cut = 0;
    bool open = false;
    const double slack = 1e-9;
    for (std::size_t i = 0; i < trace.t.size(); ++i) {
        const double t = trace.t[i];
        if (t > trace.end + slack) break;
        const bool gap = i > 0 && t - trace.t[i - 1] > gap_limit_s + slack;
        bool split = gap, after_pause = false;
        while (cut < cuts.size() && cuts[cut] <= t + slack) {
            split = true;
            ++cut;
        }
        while (pause + (endless ? 1 : 0) < trace.pauses.size() && trace.pauses[pause].end <= t + slack) {
            split = after_pause = true;
            ++pause;
        }
        if (pause < trace.pauses.size() && trace.pauses[pause].begin < t - slack) {
            open = false;
            continue;
        }
        if (open && gap && !after_pause) trace.gaps.push_back({trace.t[i - 1], t});
        if (!open || split) trace.blocks.push_back({i, i});
        open = true;
        trace.blocks.back().last = i + 1;
    }
}

}  // namespace fulcrum
