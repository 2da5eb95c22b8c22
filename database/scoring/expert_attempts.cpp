// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/expert_attempts.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "assessment/assets/assets.h"
#include "assessment/metrics/registry.h"
#include "assessment/scoring/taken_over.h"
#include "assessment/task/limit_source.h"
#include "database/records/people.h"
#include "database/rows/crypto.h"
#include "database/scoring/benchmark_files.h"
#include "database/scoring/scoring.h"
#include "database/store/accepted_assets.h"
#include "sim_core/numerics/output_file.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {
namespace {

constexpr int most_attempts_read = 200000;

bool is_for(const database::AttemptSummary& attempt, const TaskDefinition& task, const BenchmarkKey& key) {
    return attempt.meta.mode == AttemptMode::assessed && attempt.state == AttemptState::completed &&
           attempt.meta.task_version == task.version &&
           limits_class(attempt.meta.device_class) == key.device_class &&
           variant_family(task, attempt.meta.variant) == key.variant && attempt.meta.fidelity == key.fidelity;
}

database::AttemptFilter filter_for(const TaskDefinition& task) {
    database::AttemptFilter filter;
    filter.task_id = task.id;
    filter.include_voided = false;
    filter.limit = most_attempts_read;
    return filter;
}

/// All values of the task's gates are of the program's versions of their metrics.
bool is_up_to_date(const database::ScoreRow& score, const TaskDefinition& task) {
    return std::all_of(score.metrics.begin(), score.metrics.end(), [&](const database::MetricRow& row) {
        const bool gated = std::any_of(task.gates.begin(), task.gates.end(),
                                       [&](const GateSpec& gate) { return gate.metric == row.id; });
        return !gated || find_metric(row.id)->version == row.version;
    });
}

/// The score in force, or the newest of the others where that one has values of older versions: limits made
/// of such values would name a version that did not measure them. Nothing where all have.
std::optional<database::ScoreRow> score_for_limits(const database::Attempts& attempts,
                                                   const database::Session& session,
                                                   const std::string& attempt_id,
                                                   const TaskDefinition& task) {
    std::optional<database::ScoreRow> in_force = attempts.score(session, attempt_id);
    if (!in_force || is_up_to_date(*in_force, task)) return in_force;
    const std::vector<database::ScoreRow> scores = attempts.scores(session, attempt_id);
    const auto newest = std::find_if(scores.rbegin(), scores.rend(), [&](const database::ScoreRow& score) {
        return is_up_to_date(score, task);
    });
    return newest == scores.rend() ? std::nullopt : std::optional<database::ScoreRow>(*newest);
}

/// By an operator, or in the name of a person who does not exist.
bool is_simulated(const database::AttemptSummary& attempt) {
    return attempt.synthetic || !attempt.meta.operator_name.empty() ||
           attempt.meta.device_class == DeviceClass::synthetic;
}

BenchmarkAttempt counted_attempt(const std::string& person, const database::AttemptSummary& summary,
                                 const database::ScoreRow& score) {
    BenchmarkAttempt attempt;
    attempt.person = person;
    attempt.simulated = is_simulated(summary);
    for (const database::CriticalErrorRow& row : score.critical_errors)
        attempt.critical_errors.push_back(from_row(row));
    for (const database::MetricRow& row : score.metrics) attempt.metrics.push_back(from_row(row));
    return attempt;
}

}  // namespace

std::vector<ExpertCandidate> expert_candidates(const database::Store& store, const database::Session& session,
                                               const TaskDefinition& task, const BenchmarkKey& key) {
    std::map<std::string, ExpertCandidate> by_person;
    for (const database::Person& person : database::People(store).list(session))
        by_person[person.id] = {person.id, person.login, person.display_name, 0};
    database::AttemptFilter filter = filter_for(task);
    filter.include_synthetic = store.is_demo();
    for (const database::AttemptSummary& attempt : database::Attempts(store).list(session, filter)) {
        const auto person = by_person.find(attempt.meta.person_id);
        if (person != by_person.end() && is_for(attempt, task, key)) ++person->second.performed;
    }
    std::vector<ExpertCandidate> candidates;
    for (auto& [id, person] : by_person)
        if (person.performed > 0) candidates.push_back(std::move(person));
    std::sort(candidates.begin(), candidates.end(), [](const ExpertCandidate& a, const ExpertCandidate& b) {
        return std::tie(b.performed, a.name, a.login) < std::tie(a.performed, b.name, b.login);
    });
    return candidates;
}

std::optional<std::vector<BenchmarkAttempt>> expert_attempts(
    const database::Store& store, const database::Session& session, const LoadedTask& loaded,
    DeviceClass device_class, const std::vector<ExpertCandidate>& experts, const ShareDone& progress) {
    const database::Attempts attempts(store);
    const BenchmarkKey key{loaded.task.id, variant_family(loaded.task, loaded.scene.variant), device_class,
                           loaded.scene.fidelity.id};
    std::vector<BenchmarkAttempt> result;
    for (std::size_t i = 0; i < experts.size(); ++i) {
        database::AttemptFilter filter = filter_for(loaded.task);
        filter.person_id = experts[i].person_id;
        std::vector<database::AttemptSummary> list = attempts.list(session, filter);
        std::reverse(list.begin(), list.end());  // oldest first: the first attempts are familiarisation
        int seen = 0;
        for (const database::AttemptSummary& summary : list) {
            if (progress && !progress(static_cast<double>(i) / static_cast<double>(experts.size())))
                return std::nullopt;
            if (!is_for(summary, loaded.task, key) || ++seen <= familiarisation_attempts) continue;
            const auto score = score_for_limits(attempts, session, summary.meta.id, loaded.task);
            if (!score) continue;
            if (cutting_difference(cutting_values(load_recorded(attempts, session, summary).scene),
                                   cutting_values(loaded.scene))
                    .empty())
                result.push_back(counted_attempt(experts[i].login, summary, *score));
        }
    }
    return result;
}

BenchmarkRequest expert_request(const LoadedTask& loaded, DeviceClass device_class, int version,
                                std::vector<BenchmarkAttempt> attempts) {
    BenchmarkRequest request;
    request.device_class = device_class;
    request.cutting = cutting_values(loaded.scene);
    request.variant_family = variant_family(loaded.task, loaded.scene.variant);
    request.fidelity = loaded.scene.fidelity.id;
    request.version = version;
    request.provisional = std::any_of(attempts.begin(), attempts.end(),
                                      [](const BenchmarkAttempt& one) { return one.simulated; });
    request.source = request.provisional ? std::string(simulated_experts) + ", stored attempts"
                                         : std::string("experts of this site");
    request.familiarisation = familiarisation_attempts;
    request.experts = std::move(attempts);
    return request;
}

int next_benchmark_version(const BenchmarkKey& key, const std::vector<std::string>& files) {
    int version = version_in_file(asset_path("benchmarks/" + benchmark_name(key) + ".json"));
    for (const std::string& file : files) version = std::max(version, version_in_file(file));
    return version + 1;
}

std::string benchmark_text(const BenchmarkSet& set) {
    return benchmark_to_json(set).dump(2) + "\n";
}

std::string publish_benchmark(const database::Store& store, const database::Session& educator,
                              const std::string& folder, const BenchmarkSet& set, const std::string& reason) {
    using database::StoreError;
    using database::StoreErrorKind;
    store.require(educator, database::Operation::accept_assets);
    const std::string name = benchmark_name(set.key()) + ".json", text = benchmark_text(set);
    const std::string path = (std::filesystem::path(folder) / name).string();
    try {
        // The file first, under another name: a folder that cannot be written is found before anything else.
        OutputFile file(path);
        file.write(text);
        const int before = version_in_file(path);
        if (set.version != before + 1)
            throw StoreError(
                StoreErrorKind::conflict,
                {QT_TRANSLATE_NOOP("errors",
                                   "version %1 of %2 is in force, so that version %3 cannot follow it"),
                 before, name, set.version},
                QT_TRANSLATE_NOOP("errors", "build the set again"));
        const database::AssetFile asset{"benchmarks/" + name, database::sha256_hex(text)};
        const database::AcceptedAssets accepted(store);
        // Already so where an earlier try was cut off after it: without the file it had no effect.
        if (accepted.is_to_accept(asset))
            accepted.accept(educator, asset, reason, text, provisional_words(set.taken_over));
        keep_superseded(path, before);
        file.commit();
    } catch (const std::system_error& error) {
        throw StoreError(
            error.code().value() == ENOSPC ? StoreErrorKind::disk_full : StoreErrorKind::read_only,
            {QT_TRANSLATE_NOOP("errors", "%1: cannot be written (%2)"), path, error.code().message()},
            QT_TRANSLATE_NOOP(
                "errors",
                "save the set; the administrator puts the file there, and an educator accepts it with "
                "`fulcrum assets accept`"));
    }
    return path;
}

}  // namespace fulcrum
