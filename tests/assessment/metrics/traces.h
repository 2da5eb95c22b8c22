// SPDX-License-Identifier: Apache-2.0
// Traces with closed forms, for the tests of metrics.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/trace/trace.h"

namespace fulcrum::test {

inline constexpr double pi = 3.14159265358979323846;

/// Minimum-jerk course from 0 to 1 over 0 <= t <= duration, held before and after.
inline double minimum_jerk(double t, double duration) {
    const double s = t <= 0 ? 0 : t >= duration ? 1 : t / duration;
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

/// An empty trace of `duration` s at `rate`; both ends included.
inline Trace make_trace(double duration, double rate = 1000.0) {
    Trace trace;
    const auto n = static_cast<std::size_t>(std::lround(duration * rate)) + 1;
    for (std::size_t i = 0; i < n; ++i) trace.t.push_back(static_cast<double>(i) / rate);
    split_blocks(trace, {});
    return trace;
}

inline void set_position(Trace& trace, Hand hand, const std::function<Vector3(double)>& p) {
    HandTrace& h = trace.hand[static_cast<std::size_t>(hand)];
    h.px.clear(), h.py.clear(), h.pz.clear();
    for (const double t : trace.t) {
        const Vector3 x = p(t);
        h.px.push_back(x.x()), h.py.push_back(x.y()), h.pz.push_back(x.z());
    }
}

inline void set_axis(Trace& trace, Hand hand, const std::function<Vector3(double)>& a) {
    HandTrace& h = trace.hand[static_cast<std::size_t>(hand)];
    h.ax.clear(), h.ay.clear(), h.az.clear();
    for (const double t : trace.t) {
        const Vector3 x = a(t).normalized();
        h.ax.push_back(x.x()), h.ay.push_back(x.y()), h.az.push_back(x.z());
    }
}

inline void set_force(Trace& trace, Hand hand, const std::function<Vector3(double)>& f) {
    HandTrace& h = trace.hand[static_cast<std::size_t>(hand)];
    h.fx.clear(), h.fy.clear(), h.fz.clear();
    for (const double t : trace.t) {
        const Vector3 x = f(t);
        h.fx.push_back(x.x()), h.fy.push_back(x.y()), h.fz.push_back(x.z());
    }
}

inline void set_tissue(Trace& trace, Hand hand, const std::function<int(double)>& label) {
    HandTrace& h = trace.hand[static_cast<std::size_t>(hand)];
    h.tissue.clear();
    for (const double t : trace.t) h.tissue.push_back(static_cast<std::int16_t>(label(t)));
}

/// `count` minimum-jerk reaches of `length` m along x, `duration` s each, to and fro, `rest` s of rest around
/// each.
inline std::function<Vector3(double)> reaches(int count, double length, double duration, double rest) {
    return [=](double t) {
        double x = 0;
        for (int i = 0; i < count; ++i) {
            const double part = minimum_jerk(t - rest - i * (duration + rest), duration);
            x += (i % 2 == 0 ? 1 : -1) * part * length;
        }
        return Vector3(x, 0, 0);
    };
}

inline Event make_event(double t, EventKind kind, int hand = 255, int detail = 0, int tissue = -1) {
    Event event;
    event.tick = static_cast<std::uint32_t>(std::lround(t * 1000.0));
    event.kind = kind;
    event.hand = static_cast<std::uint8_t>(hand);
    event.detail = detail;
    event.tissue = static_cast<std::int8_t>(tissue);
    return event;
}

/// The one row of a metric; a missing row fails the test at the caller through .value() of an empty result.
inline MetricResult measure(const Trace& trace, const std::string& id, const std::string& hand,
                            const std::vector<Event>& events = {}, MetricContext context = {},
                            const std::string& tissue = "") {
    context.metrics = {id};
    const std::vector<MetricResult> results = compute_metrics(trace, events, context);
    const MetricResult* result = find_result(results, id, hand, tissue);
    return result == nullptr ? MetricResult{} : *result;
}

}  // namespace fulcrum::test
