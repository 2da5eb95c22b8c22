// SPDX-License-Identifier: Apache-2.0
// The provisional absolute limits of a task, and the set of a site that takes them over. A set that is made
// of people's attempts lists those that its experts met, as they were; from when it is in force they are
// limits of the site. A limit that is not listed, or that the task has changed since, stays provisional.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "assessment/task/task.h"

namespace fulcrum {

class JsonDocument;
struct BenchmarkSet;

/// An absolute limit that was provisional in its task.
struct ProvisionalLimit {
    std::string metric, hand, tissue;  ///< as in GateSpec
    int metric_version = 1;            ///< of the values that it limits
    double limit = 0;                  ///< in the metric's unit
    bool exclusive = false;            ///< a value at the limit itself does not pass
};

/// What a set of a site takes over that is built now: one for each absolute gate whose limit is provisional,
/// in the task's order.
std::vector<ProvisionalLimit> limits_to_take_over(const TaskDefinition& task);
/// Whether the set judges by the gate's limit as one of its site: it took over this limit of this version of
/// the metric, and is not provisional itself. False for a gate whose limit is not provisional.
bool takes_over(const BenchmarkSet& set, const GateSpec& gate);

/// A limit that is provisional also with a set.
struct LeftProvisional {
    ProvisionalLimit now;
    std::optional<ProvisionalLimit> taken_over;  ///< what the set took over; the task has changed it since
};
/// The provisional limits of a task with a set, in the task's order.
struct TakenOver {
    std::vector<ProvisionalLimit> by_site;
    std::vector<LeftProvisional> left;
};
TakenOver taken_over(const TaskDefinition& task, const BenchmarkSet& set);

/// The source of a limit that the set took over: "…, taken over by experts of this site, set 4".
std::string taken_over_source(const std::string& words, const BenchmarkSet& set);
/// "f_max left at most 4.0 N".
std::string provisional_words(const ProvisionalLimit& limit);
/// The same of several, for the audit log and the command line; empty: of none.
std::string provisional_words(const std::vector<ProvisionalLimit>& limits);

/// `taken_over` of a set's file.
nlohmann::json taken_over_to_json(const std::vector<ProvisionalLimit>& limits);
/// Empty where the document has none. Throws InputError with place and hint: metric unknown, wrong hand or
/// tissue, twice, in a set that is provisional. A limit of another version of its metric is none of these.
std::vector<ProvisionalLimit> taken_over_from_json(const JsonDocument& document);

}  // namespace fulcrum
