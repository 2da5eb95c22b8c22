// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum benchmark build: builds a benchmark set from synthetic operators or from named experts' attempts.
#include <algorithm>
#include <atomic>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/commands.h"
#include "app/live/performance.h"
#include "assessment/assets/assets.h"
#include "assessment/scoring/benchmark_builder.h"
#include "database/records/attempts.h"
#include "sim_core/numerics/files.h"

namespace fulcrum::app {
namespace {

constexpr int individuals = 8, counted = 3, familiarisation = 3;
constexpr std::uint64_t first_seed = 1000;  // seeds 1000-1999 are reserved for benchmarks

struct Job {
    std::string preset;
    int individual = 0, attempt = 0;
    std::uint64_t seed = 0;
};

/// Runs the counted attempts of all individuals, one thread per core. Operators do not learn, so they need no
/// familiarisation; the set records 0.
std::vector<BenchmarkAttempt> run_operators(const LoadedTask& loaded, const std::string& preset,
                                            std::uint64_t seed_base) {
    std::vector<Job> jobs;
    for (int i = 0; i < individuals; ++i) {
        for (int a = 0; a < counted; ++a)
            jobs.push_back({preset, i, a, seed_base + static_cast<std::uint64_t>(i * counted + a)});
    }
    std::vector<BenchmarkAttempt> attempts(jobs.size());
    std::atomic<std::size_t> next{0};
    std::mutex output;
    std::exception_ptr trouble;
    const auto work = [&] {
        for (std::size_t k = next++; k < jobs.size(); k = next++) {
            try {
                PerformRequest request;
                request.loaded = loaded;
                request.operator_name = jobs[k].preset;
                request.seed = jobs[k].seed;
                request.individual =
                    seed_base + static_cast<std::uint64_t>(jobs[k].individual *
                                                           counted);  // one individual, many attempts
                const Performed performed = perform(request, nullptr, nullptr);
                attempts[k].person = preset + "-" + std::to_string(jobs[k].individual + 1);
                attempts[k].metrics = performed.scored.metrics;
                attempts[k].state = performed.scored.state;
                attempts[k].critical_errors = performed.scored.score.critical_errors;
                const std::lock_guard<std::mutex> lock(output);
                std::cerr << attempts[k].person << " seed " << jobs[k].seed << ": "
                          << row_of(attempt_states, performed.scored.state).name << " in "
                          << performed.scored.duration_s << " s\n";
            } catch (...) {
                const std::lock_guard<std::mutex> lock(output);
                trouble = std::current_exception();
                next = jobs.size();
            }
        }
    };
    std::vector<std::thread> threads;
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    for (unsigned i = 0; i < cores; ++i) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    if (trouble) std::rethrow_exception(trouble);
    return attempts;
}

/// Attempts whose cutting parameters equal those of `loaded`.
std::vector<BenchmarkAttempt> stored_attempts(const database::Store& store, const database::Session& session,
                                              const LoadedTask& loaded,
                                              const std::vector<std::string>& logins) {
    const database::Attempts attempts(store);
    const database::People people(store);
    std::vector<BenchmarkAttempt> result;
    for (const std::string& login : logins) {
        const auto person = people.find_login(session, login);
        if (!person)
            throw InputError("--experts", "", "no person '" + login + "'",
                             "name logins of this store, separated by commas");
        database::AttemptFilter filter;
        filter.person_id = person->id;
        filter.task_id = loaded.task.id;
        filter.include_voided = false;
        std::vector<database::AttemptSummary> list = attempts.list(session, filter);
        std::reverse(list.begin(), list.end());  // oldest first: the first attempts are familiarisation
        int seen = 0;
        for (const database::AttemptSummary& summary : list) {
            if (summary.meta.mode != AttemptMode::assessed || summary.state != AttemptState::completed ||
                ++seen <= familiarisation)
                continue;
            const auto score = attempts.score(session, summary.meta.id);
            if (!score) continue;
            if (!cutting_difference(cutting_values(load_recorded(attempts, session, summary).scene),
                                    cutting_values(loaded.scene))
                     .empty())
                continue;
            BenchmarkAttempt attempt;
            attempt.person = login;
            for (const database::MetricRow& row : score->metrics) {
                MetricResult metric;
                metric.id = row.id;
                metric.version = row.version;
                metric.hand = row.hand;
                metric.tissue = row.tissue;
                metric.value = row.value;
                metric.unit = row.unit;
                metric.direction = row.direction;
                metric.absent_because = row.absent_because;
                metric.absence = row.value ? Absence::none : Absence::not_measured;
                attempt.metrics.push_back(metric);
            }
            result.push_back(attempt);
        }
    }
    return result;
}

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    std::string part;
    for (const char c : list + ",") {
        if (c != ',') {
            part += c;
        } else if (!part.empty()) {
            parts.push_back(part);
            part.clear();
        }
    }
    return parts;
}

/// The task with the site's tissue values if a store is named, and the session.
struct Setting {
    LoadedTask loaded;
    std::optional<database::Store> store;
    std::optional<database::Session> session;
};

Setting setting_of(const Arguments& arguments) {
    Setting setting{load_task_and_scene(arguments.words()[0]), {}, {}};
    const bool experts = arguments.has("--experts");
    if (!experts && !arguments.has("--db")) return setting;
    setting.store = open_store(arguments, false);
    setting.session =
        experts ? person_session(arguments, *setting.store) : session_of(arguments, *setting.store);
    setting.loaded = load_site_task(*setting.store, *setting.session, setting.loaded.task.id);
    return setting;
}

BenchmarkRequest request_for(const Arguments& arguments, const Setting& setting) {
    const LoadedTask& loaded = setting.loaded;
    BenchmarkRequest request;
    request.cutting = cutting_values(loaded.scene);
    request.variant_family = loaded.scene.variant;
    request.fidelity = loaded.scene.fidelity.id;
    if (arguments.has("--operators")) {
        request.source = "synthetic operators, seeds 1000-1999";
        request.provisional = true;
        request.familiarisation = request.minimum_familiarisation = 0;
        request.experts = run_operators(loaded, "expert", first_seed);
        request.novices = run_operators(loaded, "novice", first_seed + 500);
    } else {
        request.source = "experts of this site";
        request.provisional = false;
        request.familiarisation = familiarisation;
        const std::vector<std::string> logins = split(*arguments.value("--experts"));
        if (logins.empty()) throw UsageError("--experts", "is empty", "give logins separated by commas");
        request.experts = stored_attempts(*setting.store, *setting.session, loaded, logins);
    }
    return request;
}

nlohmann::json json_of(const BenchmarkBuild& build, const std::string& task) {
    nlohmann::json trials = nlohmann::json::array();
    for (const BenchmarkTrial& trial : build.trials)
        trials.push_back({{"k", trial.k}, {"pass_share", trial.pass_share}});
    return {{"task", task},
            {"usable", build.set.has_value()},
            {"refusal", or_null(build.refusal)},
            {"trials", trials},
            {"log", build.log},
            {"set", build.set ? benchmark_to_json(*build.set) : nlohmann::json()}};
}

void print_summary(const BenchmarkBuild& build) {
    for (const std::string& line : build.log) std::cout << line << '\n';
    for (const BenchmarkTrial& trial : build.trials)
        std::cout << "k " << trial.k << ": " << 100 * trial.pass_share
                  << " % of the experts' own attempts pass\n";
    std::cout << (build.set ? "usable at k " + std::to_string(build.set->k) : "refused: " + build.refusal)
              << '\n';
}

int run_benchmark_build(const Arguments& arguments) {
    if (arguments.has("--operators") == arguments.has("--experts"))
        throw UsageError("benchmark build", "needs either --operators or --experts", "give one of them");
    const Setting setting = setting_of(arguments);
    const std::optional<std::string> output = arguments.value("--output");
    if (output) require_writable_file(*output);  // checked before minutes of work

    const BenchmarkBuild build = build_benchmark(setting.loaded.task, request_for(arguments, setting));
    if (build.set && output) write_whole_file(*output, benchmark_to_json(*build.set).dump(2) + "\n");
    if (arguments.has("--json")) {
        print_json(json_of(build, setting.loaded.task.id));
    } else {
        print_summary(build);
        if (build.set && !output) std::cout << benchmark_to_json(*build.set).dump(2) << '\n';
    }
    return build.set ? 0 : 1;
}

}  // namespace

Command benchmark_command() {
    return {"benchmark build",
            "TASK",
            1,
            1,
            "Builds a benchmark set and prints the share of its own experts' attempts that would pass.",
            joined({{"--operators", "", "Use synthetic operators; the set is provisional."},
                    {"--experts", "LOGIN,LOGIN,...", "Use the stored attempts of these people; needs --as."},
                    {"--output", "FILE", "Write the set to this file.", "", {}, "-o"}},
                   session_options()),
            run_benchmark_build};
}

}  // namespace fulcrum::app
