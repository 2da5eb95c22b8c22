// SPDX-License-Identifier: GPL-3.0-or-later
// The attempts of synthetic operators that a benchmark set is built from, and the file that keeps them, so
// that a build that was cut off continues, and a changed rule for limits costs no new attempts.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/operators/operator_level.h"
#include "assessment/scoring/benchmark_builder.h"
#include "database/scoring/loaded_task.h"

namespace fulcrum::app {

/// One attempt to perform.
struct OperatorJob {
    OperatorLevel level = OperatorLevel::expert;
    int individual = 0;            ///< of the level, from 0
    std::uint64_t seed = 0;        ///< of the attempt
    std::uint64_t drawn_from = 0;  ///< seed of the individual

    std::string person() const;  ///< "expert-1"
};
/// The counted attempts of all individuals of a level, in order. Seeds 1000 to 1999 are reserved for them.
std::vector<OperatorJob> operator_jobs(OperatorLevel level);
/// Of all levels.
std::size_t count_of_operator_jobs();

/// What the outcome of an attempt depends on, by the keys of `made_with` in the file (docs/FORMATS.md).
using AttemptsOrigin = std::map<std::string, std::string>;
AttemptsOrigin attempts_origin(const LoadedTask& loaded, DeviceClass device_class);

/// The rows that build_benchmark() reads: those of the task's gates, without evidence.
std::vector<MetricResult> rows_of_gates(const TaskDefinition& task, const std::vector<MetricResult>& metrics);

class KeptAttempts {
  public:
    /// With the attempts that the file has; without it there are none yet. `other_program`: attempts that
    /// another build of the program made are taken too; see require_same(). Throws InputError: the file
    /// cannot be read or written, is not one of attempts, or was made with something else. It is not changed
    /// then.
    KeptAttempts(std::string path, AttemptsOrigin origin, bool other_program = false);

    const std::string& path() const { return path_; }
    std::size_t size() const { return attempts_.size(); }
    /// Null where it is not there.
    const BenchmarkAttempt* find(const OperatorJob& job) const;
    /// Writes the whole file again (files.h). Throws InputError.
    void add(const OperatorJob& job, const BenchmarkAttempt& attempt);

    using Perform = std::function<BenchmarkAttempt(const OperatorJob&)>;
    /// Where another build made them: performs the first of each level again. Throws InputError if one
    /// differs.
    void require_same(const Perform& perform) const;

  private:
    /// The JSON pointer of what cannot be read; empty optional: all is read.
    std::optional<std::string> read(const nlohmann::json& root, AttemptsOrigin& made_with);
    std::string path_;
    AttemptsOrigin origin_;
    bool of_other_program_ = false;
    std::map<std::pair<OperatorLevel, std::uint64_t>, BenchmarkAttempt> attempts_;
};

/// All attempts of a level, on one thread per core; `perform` is called on any of them. Those that `kept` has
/// are not performed, the others are added to it as soon as they are over. Throws what `perform` throws.
std::vector<BenchmarkAttempt> operator_attempts(OperatorLevel level, const KeptAttempts::Perform& perform,
                                                KeptAttempts* kept);

}  // namespace fulcrum::app
