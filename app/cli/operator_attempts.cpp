// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/operator_attempts.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/live/performance.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/registry.h"
#include "database/rows/crypto.h"
#include "sim_core/numerics/files.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::app {
namespace {

using nlohmann::json;

// Of experts many, because the share of their attempts that pass decides k; of novices only the mean counts.
// Of intermediates the share that passes counts, so there are many, with one attempt each.
struct Group {
    int individuals = 0, counted = 0;
    std::uint64_t first_seed = 0;
};
constexpr Group groups[] = {{32, 3, 1000}, {60, 1, 1200}, {8, 3, 1500}};  // by OperatorLevel

constexpr char format_name[] = "fulcrum operator attempts 1";
constexpr JsonLimits file_limits{std::size_t{64} << 20U, 32};
constexpr char program_key[] = "program_sha256";
const char* const remove_it = QT_TRANSLATE_NOOP(
    "errors", "name another file, or remove this one so that all attempts are performed again");

json attempt_to_json(OperatorLevel level, std::uint64_t seed, const BenchmarkAttempt& attempt) {
    return {{"level", row_of(operator_levels, level).name},
            {"person", attempt.person},
            {"seed", seed},
            {"state", row_of(attempt_states, attempt.state).name},
            {"critical_errors", critical_errors_to_json(attempt.critical_errors)},
            {"metrics", metrics_to_json(attempt.metrics)}};
}

/// A file that is not JSON, or cut off, is refused with what to do about it.
JsonDocument load_file(const std::string& path) {
    require_regular_file(path);
    try {
        return JsonDocument::load(path, file_limits);
    } catch (const InputError& error) {
        throw InputError(path, error.place(), error.problem_sentence(), remove_it);
    }
}

std::string text_or_none(const json& value) {
    return value.is_null() ? std::string() : value.get<std::string>();
}

/// Nothing where a word, or the version of a metric, is not one of this program. Throws json::exception,
/// InputError.
std::optional<BenchmarkAttempt> attempt_from_json(const json& row, const std::string& file) {
    BenchmarkAttempt attempt;
    attempt.person = row.at("person").get<std::string>();
    const auto* state = find_row(attempt_states, row.at("state").get<std::string>());
    if (state == nullptr) return std::nullopt;
    attempt.state = state->kind;
    for (const json& error : row.at("critical_errors"))
        attempt.critical_errors.push_back({error.at("event").get<std::string>(),
                                           text_or_none(error.at("hand")), text_or_none(error.at("tissue")),
                                           error.at("time_s").get<double>()});
    attempt.metrics = metrics_from_json(row.at("metrics"), file);
    for (const MetricResult& result : attempt.metrics) {
        const MetricDescriptor* descriptor = find_metric(result.id);
        if (descriptor == nullptr || descriptor->version != result.version) return std::nullopt;
    }
    return attempt;
}

/// "scene_sha256 1f2e3d4c5b6a (now 0a1b2c3d4e5f), …"; empty where both are the same.
std::string differences(const AttemptsOrigin& there, const AttemptsOrigin& here) {
    const auto value = [](const AttemptsOrigin& origin, const std::string& key) {
        const auto found = origin.find(key);
        return found == origin.end() ? std::string("-") : found->second.substr(0, 40);
    };
    AttemptsOrigin keys = here;
    keys.insert(there.begin(), there.end());
    std::string text;
    for (const auto& [key, ignored] : keys) {
        if (value(there, key) == value(here, key)) continue;
        text +=
            (text.empty() ? "" : ", ") + key + " " + value(there, key) + " (now " + value(here, key) + ")";
    }
    return text;
}

}  // namespace

std::string OperatorJob::person() const {
    return row_of(operator_levels, level).name + std::string("-") + std::to_string(individual + 1);
}

std::vector<OperatorJob> operator_jobs(OperatorLevel level) {
    const Group& group = groups[static_cast<std::size_t>(level)];
    std::vector<OperatorJob> jobs;
    for (int i = 0; i < group.individuals; ++i) {
        const std::uint64_t first = group.first_seed + static_cast<std::uint64_t>(i * group.counted);
        for (int a = 0; a < group.counted; ++a)
            jobs.push_back({level, i, first + static_cast<std::uint64_t>(a), first});
    }
    return jobs;
}

std::size_t count_of_operator_jobs() {
    std::size_t count = 0;
    for (const auto& row : operator_levels) count += operator_jobs(row.kind).size();
    return count;
}

AttemptsOrigin attempts_origin(const LoadedTask& loaded, DeviceClass device_class) {
    return {{"task", loaded.task.id},
            {"task_sha256", loaded.assets.front().digest},
            {"scene", loaded.scene_file},
            {"scene_sha256", database::sha256_hex(loaded.scene_text)},
            {"fidelity", loaded.scene.fidelity.id},
            {"device_class", row_of(device_classes, device_class).name},
            {"program", state_build()},
            {program_key, database::program_digest()}};
}

std::vector<MetricResult> rows_of_gates(const TaskDefinition& task,
                                        const std::vector<MetricResult>& metrics) {
    std::vector<MetricResult> rows;
    for (const MetricResult& result : metrics) {
        if (std::none_of(task.gates.begin(), task.gates.end(),
                         [&](const GateSpec& gate) { return gate.metric == result.id; }))
            continue;
        rows.push_back(result);
        rows.back().evidence.clear();
    }
    return rows;
}

KeptAttempts::KeptAttempts(std::string path, AttemptsOrigin origin, bool other_program)
    : path_(std::move(path)), origin_(std::move(origin)) {
    std::error_code error;
    if (std::filesystem::exists(path_, error)) {
        const JsonDocument document = load_file(path_);
        AttemptsOrigin made_with;
        if (const std::optional<std::string> place = read(document.root(), made_with))
            document.fail(*place, QT_TRANSLATE_NOOP("errors", "is not what benchmark build wrote"),
                          remove_it);
        const std::string all = differences(made_with, origin_);
        made_with[program_key] = origin_[program_key];
        const bool only_program = differences(made_with, origin_).empty();
        of_other_program_ = !all.empty();
        if (of_other_program_ && !(other_program && only_program))
            throw InputError(
                path_, "", {QT_TRANSLATE_NOOP("errors", "its attempts were not made with the same: %1"), all},
                only_program
                    ? QT_TRANSLATE_NOOP("errors",
                                        "add --other-program if only the rule for limits has changed "
                                        "since, or name another file")
                    : remove_it);
    }
    require_writable_file(path_);
}

std::optional<std::string> KeptAttempts::read(const json& root, AttemptsOrigin& made_with) {
    std::string place;
    try {
        if (root.at("format") != format_name) return "/format";
        place = "/made_with";
        made_with = root.at("made_with").get<AttemptsOrigin>();
        place = "/attempts";
        const json& rows = root.at("attempts");
        if (!rows.is_array()) return place;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            place = "/attempts/" + std::to_string(i);
            const json& row = rows[i];
            const auto* level = find_row(operator_levels, row.at("level").get<std::string>());
            std::optional<BenchmarkAttempt> attempt = attempt_from_json(row, path_);
            if (level == nullptr || !attempt ||
                !attempts_.try_emplace({level->kind, row.at("seed").get<std::uint64_t>()}, *attempt).second)
                return place;
        }
    } catch (const json::exception&) {
        return place;
    } catch (const InputError&) {
        return place;
    }
    return std::nullopt;
}

const BenchmarkAttempt* KeptAttempts::find(const OperatorJob& job) const {
    const auto found = attempts_.find({job.level, job.seed});
    return found == attempts_.end() ? nullptr : &found->second;
}

void KeptAttempts::add(const OperatorJob& job, const BenchmarkAttempt& attempt) {
    attempts_[{job.level, job.seed}] = attempt;
    json rows = json::array();
    for (const auto& [key, kept] : attempts_) rows.push_back(attempt_to_json(key.first, key.second, kept));
    const json document = {{"format", format_name}, {"made_with", origin_}, {"attempts", std::move(rows)}};
    write_whole_file(path_, document.dump(1) + "\n");
}

void KeptAttempts::require_same(const Perform& perform) const {
    if (!of_other_program_) return;
    for (const auto& row : operator_levels) {
        const std::vector<OperatorJob> jobs = operator_jobs(row.kind);
        const auto job = std::find_if(jobs.begin(), jobs.end(),
                                      [&](const OperatorJob& one) { return find(one) != nullptr; });
        if (job == jobs.end()) continue;
        const BenchmarkAttempt& kept = *find(*job);
        BenchmarkAttempt again = perform(*job);
        again.person = kept.person;
        if (attempt_to_json(job->level, job->seed, again) != attempt_to_json(job->level, job->seed, kept))
            throw InputError(path_, "",
                             {QT_TRANSLATE_NOOP("errors", "this program performs %1, seed %2, differently"),
                              kept.person, job->seed},
                             remove_it);
    }
}

std::vector<BenchmarkAttempt> operator_attempts(OperatorLevel level, const KeptAttempts::Perform& perform,
                                                KeptAttempts* kept) {
    const std::vector<OperatorJob> jobs = operator_jobs(level);
    std::vector<BenchmarkAttempt> attempts(jobs.size());
    std::vector<std::size_t> missing;
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        const BenchmarkAttempt* found = kept == nullptr ? nullptr : kept->find(jobs[k]);
        if (found != nullptr) {
            attempts[k] = *found;
            attempts[k].person = jobs[k].person();
        } else {
            missing.push_back(k);
        }
    }
    std::atomic<std::size_t> next{0};
    std::mutex one_at_a_time;
    std::exception_ptr trouble;
    const auto work = [&] {
        for (std::size_t n = next++; n < missing.size(); n = next++) {
            const std::size_t k = missing[n];
            try {
                BenchmarkAttempt attempt = perform(jobs[k]);
                attempt.person = jobs[k].person();
                const std::lock_guard<std::mutex> lock(one_at_a_time);
                if (kept != nullptr) kept->add(jobs[k], attempt);
                attempts[k] = std::move(attempt);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(one_at_a_time);
                trouble = std::current_exception();
                next = missing.size();
            }
        }
    };
    std::vector<std::thread> threads;
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    for (unsigned i = 0; i < cores; ++i) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    if (trouble) std::rethrow_exception(trouble);
    for (BenchmarkAttempt& attempt : attempts) attempt.simulated = true;
    return attempts;
}

}  // namespace fulcrum::app
