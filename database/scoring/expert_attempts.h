// SPDX-License-Identifier: GPL-3.0-or-later
// From the stored attempts of named experts to a benchmark set that is in force: who has attempts for it, the
// attempts that count, and the set's file. The command line and the window use the same.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "assessment/scoring/benchmark_builder.h"
#include "database/records/attempts.h"
#include "database/scoring/loaded_task.h"

namespace fulcrum {

/// So many attempts of a person come before those that count.
inline constexpr int familiarisation_attempts = 3;

/// Somebody who may be named as an expert.
struct ExpertCandidate {
    std::string person_id, login, name;
    int performed = 0;  ///< assessed and completed, for the key; the familiarisation is among them
    int counted() const {
        return performed > familiarisation_attempts ? performed - familiarisation_attempts : 0;
    }
};
/// Real people (in a demonstration programme: its people) with such an attempt that the session may read,
/// those with most first. Throws AccessDenied, StoreError.
std::vector<ExpertCandidate> expert_candidates(const database::Store& store, const database::Session& session,
                                               const TaskDefinition& task, const BenchmarkKey& key);

/// Called with the share that is done; false: stop.
using ShareDone = std::function<bool(double)>;

/// The counted attempts of these people: with this class of device, in the scene of `loaded` (its variant
/// family, fidelity and cutting parameters) and with a score of the metrics' present versions. Nothing when
/// stopped. Throws AccessDenied, StoreError.
std::optional<std::vector<BenchmarkAttempt>> expert_attempts(
    const database::Store& store, const database::Session& session, const LoadedTask& loaded,
    DeviceClass device_class, const std::vector<ExpertCandidate>& experts, const ShareDone& progress = {});

/// What build_benchmark() makes a set of them of: a provisional one where they are simulated, which takes
/// over nothing. `version`: next_benchmark_version().
BenchmarkRequest expert_request(const LoadedTask& loaded, DeviceClass device_class, int version,
                                std::vector<BenchmarkAttempt> attempts);

/// One more than that of the set in force for the key, and than that in each of `files` (paths; those that do
/// not exist count as none).
int next_benchmark_version(const BenchmarkKey& key, const std::vector<std::string>& files = {});

/// The set as its file has it.
std::string benchmark_text(const BenchmarkSet& set);

/// Puts the set in force at this station, and at the others with the next exchange (asset_placing.h): its
/// file takes the place of the one in `folder` (assets/benchmarks), which is kept in the folder "superseded"
/// there, and is accepted for assessed attempts. Attempts that have begun keep their limits. Returns the
/// file's path. Operation::accept_assets; audited as asset.accept, with the limits of the task that the set
/// takes over. Throws AccessDenied, StoreError bad_value (no reason), conflict (another set was put in force
/// since this one was built), read_only (the folder cannot be written).
std::string publish_benchmark(const database::Store& store, const database::Session& educator,
                              const std::string& folder, const BenchmarkSet& set, const std::string& reason);

}  // namespace fulcrum
