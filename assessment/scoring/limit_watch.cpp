// SPDX-License-Identifier: Apache-2.0
#include "assessment/scoring/limit_watch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {
namespace {

/// The metrics' low-pass at 50 Hz has forgotten what was before: its largest value is then above the limit.
constexpr double lasting_s = 0.025;
constexpr double clearly = 1.02;  // times the limit
constexpr double soon_s = 0.2;
constexpr double pressing_n = 0.1;  // as the metrics' grasp

/// Events that the metric of the same name counts.
constexpr std::array counted_kinds = {
    EventKind::perforation,  EventKind::tear,         EventKind::drop,          EventKind::vessel_injury,
    EventKind::nerve_injury, EventKind::lens_contact, EventKind::tool_collision};

int tissue_index(const Scene& scene, const std::string& label) {
    for (std::size_t i = 0; i < scene.tissues.size(); ++i)
        if (scene.tissues[i].label == label) return static_cast<int>(i);
    return -1;
}

/// Wanted where nobody counts it: the attempt ends with it, or the person looks for it in the debrief.
bool is_worth_keeping(EventKind kind) {
    return kind == EventKind::over_force_begin || kind == EventKind::jaw_pressure ||
           std::find(counted_kinds.begin(), counted_kinds.end(), kind) != counted_kinds.end();
}

}  // namespace

LimitWatch::LimitWatch(const TaskDefinition& task, const Scene& scene, const std::vector<JudgedLimit>& limits)
    : tick_period_(scene.tick_period()),
      lasting_ticks_(static_cast<std::uint32_t>(std::lround(lasting_s / tick_period_))),
      soon_ticks_(static_cast<std::uint32_t>(std::lround(soon_s / tick_period_))) {
    for (const EventKind kind : counted_kinds) {
        const auto& critical = task.critical_errors;
        if (std::find(critical.begin(), critical.end(), event_name(kind)) != critical.end())
            events_.push_back({kind, -1, -1, false, 0, 0});
    }
    for (const JudgedLimit& limit : limits) {
        const int tissue = limit.tissue.empty() ? -1 : tissue_index(scene, limit.tissue);
        if (!limit.limit || limit.higher_is_better || (tissue < 0 && !limit.tissue.empty())) continue;
        if (limit.hand != "right") add(limit, static_cast<int>(Hand::left), tissue);
        if (limit.hand != "left") add(limit, static_cast<int>(Hand::right), tissue);
    }
}

void LimitWatch::add(const JudgedLimit& limit, int hand, int tissue) {
    const auto row = [&](Load load, double unit) {
        Row one;
        one.load = load;
        one.hand = hand;
        one.tissue = tissue;
        one.limit = unit * *limit.limit;
        rows_.push_back(one);
    };
    if (limit.metric == "f_max") return row(Load::tip, 1);
    if (limit.metric == "grasp_max") return row(Load::jaws, 1);
    if (limit.metric == "grasp_kpa") return row(Load::pressure, 1e3);
    if (limit.metric == "grasp_ftp") return row(Load::jaws_over_time, 1);
    // Without a hand, one row is for both.
    if (limit.hand.empty() && hand != static_cast<int>(Hand::left)) return;
    const int of_hand = limit.hand.empty() ? -1 : hand;
    if (limit.metric == "lateral_heat")
        events_.push_back({EventKind::heat_area, -1, -1, true, *limit.limit, 0});
    if (limit.metric == "bleed_ml") events_.push_back({EventKind::blood_loss, -1, -1, true, *limit.limit, 0});
    for (const EventKind kind : counted_kinds)
        if (limit.metric == event_name(kind))
            events_.push_back({kind, of_hand, tissue, false, *limit.limit, 0});
}

double LimitWatch::value_of(Row& row, const HandSample& sample) const noexcept {
    if (row.tissue >= 0 && sample.tissue != row.tissue) return row.product = 0;
    if (row.load == Load::tip) {
        const double x = sample.force[0], y = sample.force[1], z = sample.force[2];
        return std::sqrt(x * x + y * y + z * z) * sample_force_unit;
    }
    const double jaws = sample.jaw_force * sample_force_unit;
    if (jaws <= pressing_n || sample.tissue < 0) return row.product = 0;
    if (row.load == Load::jaws) return jaws;
    if (row.load == Load::jaws_over_time) return row.product += jaws * tick_period_;
    return sample.jaw_area > 0 ? jaws / (sample.jaw_area * sample_area_unit) : 0;
}

void LimitWatch::see(const TickSample& sample) noexcept {
    for (Row& row : rows_) {
        if (row.stored) continue;
        const double value = value_of(row, sample.hand[row.hand]);
        if (value <= row.limit) {
            row.clear = 0;
            continue;
        }
        ask(row.met ? Need::soon : Need::now);
        row.met = true;
        // A product of force and time stays above its limit; it is not filtered.
        const bool is_clear = value > clearly * row.limit || row.load == Load::jaws_over_time;
        row.clear = is_clear ? row.clear + 1 : 0;
        if (row.clear < lasting_ticks_ || row.lasting) continue;
        row.lasting = true;
        ask(Need::now);
    }
}

void LimitWatch::see(const Event& event) noexcept {
    if (event.kind == EventKind::device_lost || event.kind == EventKind::simulator_fault) ask(Need::now);
    if (is_worth_keeping(event.kind)) ask(Need::soon);
    for (EventRow& row : events_) {
        if (row.kind != event.kind || row.so_far > row.limit) continue;
        if ((row.hand >= 0 && event.hand != row.hand) || (row.tissue >= 0 && event.tissue != row.tissue))
            continue;
        row.so_far = row.reported ? static_cast<double>(event.value) : row.so_far + 1;
        if (!row.reported || row.so_far > row.limit) ask(Need::now);
    }
}

bool LimitWatch::due(std::uint32_t ticks_since_write) const noexcept {
    return need_ == Need::now || (need_ == Need::soon && ticks_since_write >= soon_ticks_);
}

void LimitWatch::written() noexcept {
    need_ = Need::none;
    for (Row& row : rows_) row.stored = row.lasting;
}

}  // namespace fulcrum
