// SPDX-License-Identifier: GPL-3.0-or-later
// The raw values behind the page of fidelity and score: the same operators at every fidelity, and the same
// recorded input at every fidelity.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "assessment/operators/operator_level.h"
#include "sim_core/scene/fidelity.h"

namespace fulcrum::app {

/// How two attempts of a pair belong together.
enum class Pairing : std::uint8_t {
    performed,  ///< the same operator with the same seed performs the task; it reacts to what it sees and
                ///< feels
    replayed,   ///< the input that the operator gave at `standard`, without reaction; then the hands keep
                ///< still for 5 s
    repeated    ///< performed again at `standard`, the handles moved by 0.1 um: the part of chance
};
inline constexpr NameRow<Pairing> pairings[] = {{Pairing::performed, "performed", ""},
                                                {Pairing::replayed, "replayed", ""},
                                                {Pairing::repeated, "repeated", ""}};
static_assert(in_order(pairings));

struct ObservedAttempt {
    std::string task;
    OperatorLevel operator_level = OperatorLevel::expert;
    std::uint64_t seed = 0;
    Pairing pairing = Pairing::performed;
    FidelityLevel fidelity = FidelityLevel::standard;
    std::optional<bool> passed;  ///< empty: not scored
    double simulated_s = 0;
    double processor_s = 0;                ///< of the simulation with its operator, without scoring
    std::map<std::string, double> values;  ///< by metric_key(); absent ones are not there; "points" as well
};
/// "f_max left"; with a tissue "f_max left wall".
std::string metric_key(const std::string& id, const std::string& hand, const std::string& tissue);

struct StudiedGate {
    std::string metric, hand, tissue;
    double limit = 0;  ///< 0 where there is none
    std::string key() const { return metric_key(metric, hand, tissue); }
};
struct StudiedTask {
    std::string id, limits, fidelity;  ///< the limits' name and the fidelity of the task's scene
    int version = 1;
    std::vector<StudiedGate> gates;
    std::map<std::string, int> metrics = {};  ///< version of each gated metric; empty: not recorded
};
struct FidelityStudy {
    int physics = 0;
    std::string commit;  ///< of the program that ran the attempts
    std::vector<StudiedTask> tasks;
    std::vector<ObservedAttempt> attempts;  ///< by seed, then by task
};
nlohmann::json to_json(const FidelityStudy& study);
/// Throws InputError for a document that to_json() did not write.
FidelityStudy fidelity_study_of(const nlohmann::json& document, const std::string& file);

struct FidelityStudyRequest {
    std::vector<std::string> tasks;
    int seeds = 2;
    std::string commit;
    std::function<bool()> keep_going;                    ///< from any thread, about once per simulated second
    std::function<void(const std::string&)> on_attempt;  ///< one line an attempt, one call at a time
};
/// One thread per core. Seed i is performed by an expert, an intermediate, a novice in turn. The result
/// depends on the request only, processor times aside; where it is stopped, it has the seeds that were
/// complete. Throws InputError.
FidelityStudy run_fidelity_study(const FidelityStudyRequest& request);

}  // namespace fulcrum::app
