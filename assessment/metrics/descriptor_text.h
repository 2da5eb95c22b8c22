// SPDX-License-Identifier: Apache-2.0
// Shorthand for the families' descriptor lists.
#pragma once

#include <string>
#include <utility>

#include "assessment/metrics/metric.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum {

inline constexpr const char* motion_filter =
    "linear to 1 kHz, Butterworth 2nd order forward and backward 10 Hz, ends held 0.3 s, 100 Hz";
inline constexpr const char* force_filter =
    "spikes replaced from 500 Hz on (median of 5 samples, 10 times their spread), linear to 1 kHz within a "
    "tissue label, Butterworth 2nd order forward and backward 50 Hz, ends held 0.3 s";
/// 2: spikes are replaced, and the jaw force is not interpolated from one tissue label to the next.
inline constexpr int force_filter_version = 2;
inline constexpr const char* no_filter = "none";

/// What a metric is called and how its value is written.
struct Naming {
    std::string id, name, unit;
    double precision;
};
/// What the trainee reads.
struct Wording {
    std::string explanation, fault, remedy;
};

inline MetricDescriptor describe(Naming naming, Direction direction, Scale scale, Aggregation aggregation,
                                 EvidenceGrade grade, std::string source, Wording wording) {
    MetricDescriptor d;
    d.id = std::move(naming.id);
    d.name = std::move(naming.name);
    d.unit = std::move(naming.unit);
    d.precision = naming.precision;
    d.direction = direction;
    d.scale = scale;
    d.aggregation = aggregation;
    d.grade = grade;
    d.source = std::move(source);
    d.version = 1;
    d.explanation = std::move(wording.explanation);
    d.advice_fault = std::move(wording.fault);
    d.advice_remedy = std::move(wording.remedy);
    return d;
}

}  // namespace fulcrum
