// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/limit_trial.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "assessment/assets/assets.h"
#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "database/scoring/loaded_task.h"
#include "database/scoring/scoring.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

const database::GateRow* find_gate(const TriedAttempt& attempt, const GateSpec& spec) {
    for (const database::GateRow& gate : attempt.gates)
        if (gate.metric == spec.metric && gate.hand == spec.hand && gate.tissue == spec.tissue) return &gate;
    return nullptr;
}

std::optional<bool> judge(const GateSpec& spec, const database::GateRow& gate, const BenchmarkSet* set) {
    MetricResult result;
    result.id = spec.metric;
    result.version = find_metric(spec.metric)->version;
    result.hand = spec.hand;
    result.tissue = spec.tissue;
    result.value = gate.value;
    result.unit = gate.unit;
    return judge_gate(spec, {result}, set).passed;
}

/// The stored value of a gate against a level of the set, as scoring judges it. A set that narrowed an
/// absolute limit when the attempt was stored does not count: the value is judged by the task's limit and
/// this set. A set from other tissue has no level for the attempt.
std::optional<bool> judge_again(const GateSpec& spec, const database::GateRow& gate,
                                const TriedAttempt& attempt, const BenchmarkSet& set) {
    const BenchmarkLevel* level =
        in_tissue_of(set, attempt) ? set.find(spec.metric, spec.hand, spec.tissue) : nullptr;
    if (spec.kind == GateKind::absolute) {
        if (!gate.value) return gate.passed;
        const std::optional<bool> met = judge(spec, gate, nullptr);
        if (met == false || level == nullptr) return met;
    }
    const auto version = attempt.metric_versions.find(spec.metric);
    if (level == nullptr || version == attempt.metric_versions.end() ||
        version->second != level->metric_version)
        return std::nullopt;
    if (!gate.value) return gate.passed;  // not done is failed, not measured is not judged: under any limits
    return judge(spec, gate, &set);
}

/// The tissues of attempts and of their scene files; of equal scenes one is read.
class TissueReader {
  public:
    TissueReader(const database::Attempts& attempts, const database::Session& session,
                 const TaskDefinition& task)
        : attempts_(attempts), session_(session), task_(task) {}

    /// False where its scene is damaged or one that this program cannot read: in which tissue it was
    /// performed is not known.
    bool read(const database::AttemptSummary& summary, TriedAttempt& one) {
        try {
            read_scene(summary, one);
        } catch (const InputError&) {
            return false;
        } catch (const database::StoreError& error) {
            if (error.kind() != database::StoreErrorKind::corrupt) throw;
            return false;
        }
        return true;
    }

  private:
    void read_scene(const database::AttemptSummary& summary, TriedAttempt& one) {
        const std::string& variant = summary.meta.variant;
        auto file = files_.find(variant);
        if (file == files_.end()) file = files_.emplace(variant, cutting_of_file(task_, variant)).first;
        one.scene_cutting = file->second;
        if (one.scene_cutting.empty()) return;  // nothing is cut by force here
        const std::string text = attempts_.scene_text(session_, summary.meta.id);
        const std::pair key(variant, text);
        auto record = records_.find(key);
        // An older program kept no scene: it had no values of a site either.
        if (record == records_.end())
            record = records_
                         .emplace(key, text.empty() ? one.scene_cutting
                                                    : cutting_values(load_recorded(text, summary).scene))
                         .first;
        one.cutting = record->second;
    }

    const database::Attempts& attempts_;
    const database::Session& session_;
    const TaskDefinition& task_;
    std::map<std::string, CuttingValues> files_;                            ///< by variant
    std::map<std::pair<std::string, std::string>, CuttingValues> records_;  ///< by variant and scene
};

}  // namespace

std::vector<BenchmarkSet> sets_in_force(const std::string& task_id) {
    std::vector<BenchmarkSet> sets;
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(asset_path("benchmarks"))) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".json" && (name == task_id || name.rfind(task_id + "-", 0) == 0))
            files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    for (const std::string& file : files) {
        try {
            BenchmarkSet set = load_benchmark(file);
            if (set.task == task_id) sets.push_back(std::move(set));
        } catch (const OutdatedSet&) {
            continue;  // nothing can be judged by it
        }
    }
    return sets;
}

std::vector<TriedAttempt> tried_attempts(const database::Store& store, const database::Session& session,
                                         const TaskDefinition& task, const BenchmarkKey& key) {
    const database::Attempts attempts(store);
    database::AttemptFilter filter;
    filter.include_synthetic = store.is_demo();
    filter.task_id = task.id;
    filter.include_voided = false;
    filter.limit = 4 * most_tried_attempts;  // practice and other devices are among them
    TissueReader tissue(attempts, session, task);
    std::vector<TriedAttempt> tried;
    for (const database::AttemptSummary& summary : attempts.list(session, filter)) {
        if (static_cast<int>(tried.size()) == most_tried_attempts) break;
        if (!summary.counting || summary.meta.task_version != task.version ||
            limits_class(summary.meta.device_class) != key.device_class ||
            variant_family(task, summary.meta.variant) != key.variant ||
            summary.meta.fidelity != key.fidelity)
            continue;
        const std::optional<database::ScoreRow> score = attempts.score(session, summary.meta.id);
        if (!score) continue;
        TriedAttempt one;
        one.attempt_id = summary.meta.id;
        one.person_id = summary.meta.person_id;
        one.person_name = summary.person_name;
        one.gates = score->gates;
        for (const database::MetricRow& row : score->metrics) one.metric_versions[row.id] = row.version;
        one.critical = !score->critical_errors.empty();
        one.completed = summary.recorded_state == AttemptState::completed;
        one.passed = score->passed;
        if (tissue.read(summary, one)) tried.push_back(std::move(one));
    }
    return tried;
}

bool in_tissue_of(const BenchmarkSet& set, const TriedAttempt& attempt) {
    return cutting_difference(attempt.cutting, set.cutting.empty() ? attempt.scene_cutting : set.cutting)
        .empty();
}

std::optional<bool> passes_under(const TaskDefinition& task, const TriedAttempt& attempt,
                                 const BenchmarkSet& set) {
    if (attempt.critical || !attempt.completed) return false;
    bool judged = true;
    for (const GateSpec& spec : task.gates) {
        const database::GateRow* gate = find_gate(attempt, spec);
        std::optional<bool> passed;
        if (gate != nullptr) passed = judge_again(spec, *gate, attempt, set);
        if (passed == false) return false;
        judged = judged && passed.has_value();
    }
    return judged ? std::optional<bool>(true) : std::nullopt;
}

TrialCount count_passes(const TaskDefinition& task, const std::vector<TriedAttempt>& attempts,
                        const BenchmarkSet& set) {
    TrialCount count;
    std::set<std::string> people, passed;
    for (const TriedAttempt& attempt : attempts) {
        const std::optional<bool> verdict = passes_under(task, attempt, set);
        ++count.attempts;
        count.passed += verdict == true ? 1 : 0;
        count.not_judged += verdict.has_value() ? 0 : 1;
        people.insert(attempt.person_id);
        if (verdict == true) passed.insert(attempt.person_id);
    }
    count.people = static_cast<int>(people.size());
    count.people_passed = static_cast<int>(passed.size());
    return count;
}

}  // namespace fulcrum
