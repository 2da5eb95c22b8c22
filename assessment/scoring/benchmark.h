// SPDX-License-Identifier: Apache-2.0
// A benchmark set: the proficiency levels of one task, scene variant, device class and fidelity from named
// expert attempts, with their provenance.
// File format: assets/schemas/benchmark.schema.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/scoring/taken_over.h"
#include "assessment/task/attempt_words.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/cutting_values.h"

namespace fulcrum {

/// The level of one metric. Either a z level (deviation > 0) or an absolute limit (counts, shares, deviation
/// below precision).
struct BenchmarkLevel {
    std::string metric, hand, tissue;  ///< as in MetricResult
    int metric_version = 1;
    std::string unit;
    Scale scale = Scale::raw;
    double mean = 0, deviation = 0;        ///< on the scale
    std::optional<double> z_novice;        ///< the novices' mean as z; none without a novice set
    std::optional<double> absolute_limit;  ///< in `unit`: the worst counted expert value
    std::optional<double> k;               ///< of this gate; none: that of the set
    int experts = 0;                       ///< counted in this metric
    std::vector<std::string> left_out;     ///< experts left out of this metric by the outlier rule
};

/// The people from whose attempts a set was made.
struct BenchmarkPerson {
    std::string name;
    int attempts = 0;         ///< counted
    int familiarisation = 0;  ///< discarded before them
};

/// What a set is for. An attempt is held against a set of its own key only.
struct BenchmarkKey {
    std::string task, variant;
    DeviceClass device_class = DeviceClass::haptic;
    std::string fidelity;
};
/// "B1-standard-haptic-standard" with its usual parts (standard, haptic, standard) left out: "B1",
/// "A2-mouse-keyboard", "B1-long_jaws-fast". The name of the set's file and, with a version, of the limits of
/// an attempt.
std::string benchmark_name(const BenchmarkKey& key);

struct BenchmarkSet {
    int version = 1;  ///< rises each time the set is built again
    std::string task;
    int task_version = 1;
    std::string variant_family;
    DeviceClass device_class = DeviceClass::haptic;
    std::string fidelity;
    std::string source;  ///< for screens: "synthetic operators" (limit_source.h), "experts of …"
    std::string note;    ///< why it was made, by whoever put it in force; may be empty
    bool provisional = true;
    double k = 2;  ///< benchmark gates pass at z <= k, apart from levels with a k of their own
    double p0 = 0.1;
    double expert_pass_share = 0;  ///< of their counted attempts, each scored with its expert left out
    std::optional<double> intermediate_pass_share;  ///< none without intermediates
    std::vector<BenchmarkPerson> experts, intermediates, novices;
    std::vector<BenchmarkLevel> levels;
    std::vector<ProvisionalLimit> taken_over;  ///< limits of the task that are the site's with this set
    /// Cutting parameters with which the set was made; empty: those of the scene file. The set does not score
    /// attempts with other values.
    CuttingValues cutting;

    BenchmarkKey key() const { return {task, variant_family, device_class, fidelity}; }
    /// Null when the set has no level for it.
    const BenchmarkLevel* find(const std::string& metric, const std::string& hand,
                               const std::string& tissue) const;
    double k_of(const BenchmarkLevel& level) const { return level.k.value_or(k); }
};

/// A set that was sound for another version of the program: the definition of one of its metrics is another
/// one here. Building the set again helps, nothing else.
class OutdatedSet : public InputError {
  public:
    OutdatedSet(const InputError& error, std::string metric)
        : InputError(error), metric_(std::move(metric)) {}
    const std::string& metric() const noexcept { return metric_; }

  private:
    std::string metric_;
};

nlohmann::json benchmark_to_json(const BenchmarkSet& set);
/// Checked against the schema; throws InputError with file, JSON pointer and hint, OutdatedSet for one that
/// this program cannot use any more.
BenchmarkSet parse_benchmark(const std::string& text, const std::string& file);
BenchmarkSet load_benchmark(const std::string& path);

}  // namespace fulcrum
