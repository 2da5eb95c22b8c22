// SPDX-License-Identifier: Apache-2.0
#include "assessment/metrics/invariance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "assessment/metrics/registry.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

using Columns = std::vector<double>*;
using Map = std::function<Vector3(const Vector3&)>;

void map_columns(Columns x, Columns y, Columns z, const Map& map) {
    for (std::size_t i = 0; i < x->size(); ++i) {
        const Vector3 mapped = map(Vector3((*x)[i], (*y)[i], (*z)[i]));
        (*x)[i] = mapped.x();
        (*y)[i] = mapped.y();
        (*z)[i] = mapped.z();
    }
}

/// `place` maps points, `direction` axes and forces, `moment` torques.
void map_frame(RecordedAttempt& attempt, const Map& place, const Map& direction, const Map& moment) {
    for (HandTrace& hand : attempt.trace.hand) {
        map_columns(&hand.px, &hand.py, &hand.pz, place);
        map_columns(&hand.ax, &hand.ay, &hand.az, direction);
        map_columns(&hand.fx, &hand.fy, &hand.fz, direction);
        map_columns(&hand.tx, &hand.ty, &hand.tz, moment);
    }
    map_columns(&attempt.trace.camera.px, &attempt.trace.camera.py, &attempt.trace.camera.pz, place);
    for (TargetSphere& target : attempt.context.targets) target.centre = place(target.centre);
}

template <typename T>
void keep_every_second(std::vector<T>& column) {
    for (std::size_t i = 0; 2 * i < column.size(); ++i) column[i] = column[2 * i];
    column.resize((column.size() + 1) / 2);
}

void halve_rate(Trace& trace) {
    keep_every_second(trace.t);
    for (HandTrace& hand : trace.hand) {
        for (Columns column :
             {&hand.px, &hand.py, &hand.pz, &hand.ax, &hand.ay, &hand.az, &hand.roll, &hand.fx, &hand.fy,
              &hand.fz, &hand.tx, &hand.ty, &hand.tz, &hand.jaw_force, &hand.jaw_area})
            keep_every_second(*column);
        for (auto* column : {&hand.tissue, &hand.patch}) keep_every_second(*column);
        for (auto* column : {&hand.inside, &hand.in_view, &hand.energy, &hand.cutting})
            keep_every_second(*column);
    }
    CameraTrace& camera = trace.camera;
    for (Columns column :
         {&camera.px, &camera.py, &camera.pz, &camera.qw, &camera.qx, &camera.qy, &camera.qz})
        keep_every_second(*column);
}

void add_noise(Trace& trace) {
    Random random(1, 0x6e6f6973);
    for (HandTrace& hand : trace.hand)
        for (Columns column : {&hand.px, &hand.py, &hand.pz})
            for (double& value : *column) value += 2e-6 * random.normal();
}

/// The orientation of the scope is part of the frame as well.
void turn_scope(CameraTrace& camera, const Quaternion& turn) {
    for (std::size_t i = 0; i < camera.qw.size(); ++i) {
        const Quaternion turned = turn * Quaternion(camera.qw[i], camera.qx[i], camera.qy[i], camera.qz[i]);
        camera.qw[i] = turned.w();
        camera.qx[i] = turned.x();
        camera.qy[i] = turned.y();
        camera.qz[i] = turned.z();
    }
}

/// Left to right, in the patient and in the image: the axis of a rotation is mirrored as a torque is.
void mirror_scope(CameraTrace& camera) {
    for (Columns column : {&camera.qy, &camera.qz})
        for (double& value : *column) value = -value;
}

void add_spike(Trace& trace) {
    for (HandTrace& hand : trace.hand)
        if (!hand.fx.empty()) hand.fx[hand.fx.size() / 2] += 20;
}

/// The metrics of the force vector on tissue.
std::vector<std::string> force_vector_metrics() {
    std::vector<std::string> ids;
    for (const Metric& metric : metric_registry()) {
        const std::vector<Channel>& channels = metric.descriptor.channels;
        if (std::find(channels.begin(), channels.end(), Channel::force) != channels.end())
            ids.push_back(metric.descriptor.id);
    }
    return ids;
}

}  // namespace

const std::vector<AllowedChange>& allowed_changes() {
    constexpr double rounding = 1e-6, any = std::numeric_limits<double>::infinity();
    constexpr const char* same =
        "nothing but rounding: the value does not depend on where or when it was recorded";
    static const std::vector<AllowedChange> rows = {
        {TraceChange::turned, force_vector_metrics(), 0.01,
         "spikes are looked for in each axis of the force, and in a turned frame other samples are replaced"},
        {TraceChange::turned,
         {"horizon_err"},
         any,
         "the horizon is measured against the patient's z, which does not turn with the frame"},
        {TraceChange::turned, {}, rounding, same},
        {TraceChange::mirrored, {}, rounding, same},
        {TraceChange::moved, {}, rounding, same},
        {TraceChange::later,
         {"scope_ldlj", "horizon_err", "centre_err", "size_err"},
         1e-3,
         "of samples between two times: rounding of a time can leave out the sample at its end"},
        {TraceChange::later, {}, rounding, same},
        {TraceChange::half_rate,
         {"f_max", "dfdt_max"},
         0.2,
         "a peak of a few milliseconds has half the samples, and one that is a single sample is replaced as "
         "a spike"},
        {TraceChange::half_rate,
         {"contacts"},
         0.34,
         "a count: a touch of one sample can fall between two, and one touch of three is a third"},
        {TraceChange::half_rate, {}, 0.05, "filters and integrals of coarser samples"},
        {TraceChange::noise, {}, 0.02, "the filter of the motion metrics lets a part of the noise through"},
        {TraceChange::spike, force_vector_metrics(), 1e-3,
         "the spike is replaced by what its neighbours suggest"},
        {TraceChange::spike, {}, 0, "the metric does not use the force on tissue"}};
    return rows;
}

const AllowedChange& allowed_change(TraceChange change, const std::string& metric) {
    const AllowedChange* others = nullptr;
    for (const AllowedChange& row : allowed_changes()) {
        if (row.change != change) continue;
        if (std::find(row.metrics.begin(), row.metrics.end(), metric) != row.metrics.end()) return row;
        if (row.metrics.empty()) others = &row;
    }
    return *others;
}

RecordedAttempt changed(RecordedAttempt attempt, TraceChange change) {
    const Map same = [](const Vector3& v) { return v; };
    switch (change) {
        case TraceChange::turned: {
            const Matrix3 turn =
                Eigen::AngleAxisd(40.0 / 180 * std::acos(-1.0), Vector3(1, 2, -1).normalized())
                    .toRotationMatrix();
            const Map map = [turn](const Vector3& v) { return Vector3(turn * v); };
            map_frame(attempt, map, map, map);
            turn_scope(attempt.trace.camera, Quaternion(turn));
            break;
        }
        case TraceChange::mirrored: {
            const Map map = [](const Vector3& v) { return Vector3(-v.x(), v.y(), v.z()); };
            // A torque turns the other way in a mirror.
            map_frame(attempt, map, map, [](const Vector3& v) { return Vector3(v.x(), -v.y(), -v.z()); });
            for (HandTrace& hand : attempt.trace.hand)
                for (double& roll : hand.roll) roll = -roll;
            mirror_scope(attempt.trace.camera);
            break;
        }
        case TraceChange::moved:
            map_frame(
                attempt, [](const Vector3& v) { return Vector3(v + Vector3(0.03, -0.04, 0)); }, same, same);
            break;
        case TraceChange::later: {
            const auto ticks = static_cast<std::uint32_t>(std::lround(0.25 / attempt.trace.tick_period));
            for (double& time : attempt.trace.t) time += ticks * attempt.trace.tick_period;
            for (Event& event : attempt.events) event.tick += ticks;
            break;
        }
        case TraceChange::half_rate:
            halve_rate(attempt.trace);
            break;
        case TraceChange::noise:
            add_noise(attempt.trace);
            break;
        case TraceChange::spike:
            add_spike(attempt.trace);
            break;
    }
    split_blocks(attempt.trace, attempt.events);
    return attempt;
}

std::vector<MetricChange> compare_changes(const RecordedAttempt& attempt) {
    std::vector<MetricChange> changes;
    for (const MetricResult& result : compute_metrics(attempt.trace, attempt.events, attempt.context))
        if (result.value) changes.push_back({result.id, result.hand, result.tissue, *result.value, {}});
    for (const NameRow<TraceChange>& row : trace_changes) {
        const RecordedAttempt other = changed(attempt, row.kind);
        const std::vector<MetricResult> results = compute_metrics(other.trace, other.events, other.context);
        for (MetricChange& change : changes) {
            const MetricResult* result = find_result(results, change.id, change.hand, change.tissue);
            const double least = find_metric(change.id)->precision;
            change.relative.push_back(result != nullptr && result->value
                                          ? std::abs(*result->value - change.value) /
                                                std::max(std::abs(change.value), least)
                                          : std::numeric_limits<double>::infinity());
        }
    }
    return changes;
}

}  // namespace fulcrum
