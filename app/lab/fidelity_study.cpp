// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/fidelity_study.h"

#include <atomic>
#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/live/performance.h"
#include "app/live/trace_rig.h"
#include "assessment/metrics/registry.h"
#include "database/scoring/fidelity_now.h"
#include "sim_core/lab/chart.h"
#include "sim_core/lab/processor_time.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/world/physics_version.h"

namespace fulcrum::app {
namespace {

constexpr std::uint64_t first_seed = 3000;  // outside the benchmarks' own and those of the operators' pages

/// An operator whose handles are moved by the smallest step that a device reports.
class DisturbedRig : public ObservingRig {
  public:
    explicit DisturbedRig(std::unique_ptr<ObservingRig> rig) : rig_(std::move(rig)) {}
    void read(std::uint32_t tick, RigSample& sample) override {
        rig_->read(tick, sample);
        for (DeviceSample& hand : sample.hand) hand.handle[0] += 1;
    }
    void write_force(Hand hand, const Vector3& force) override { rig_->write_force(hand, force); }
    bool has_force(Hand hand) const override { return rig_->has_force(hand); }
    double damping(Hand hand) const override { return rig_->damping(hand); }
    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        rig_->observe(world, display);
    }

  private:
    std::unique_ptr<ObservingRig> rig_;
};

/// A recorded input after whose end the hands keep still for five seconds, so that what is held a moment
/// longer at another fidelity still counts. Then the attempt is abandoned.
class PatientRig : public Rig {
  public:
    PatientRig(const std::vector<RigSample>& inputs, int tick_rate)
        : trace_(inputs), last_(static_cast<std::uint32_t>(inputs.size())), patience_(5 * tick_rate) {}
    void read(std::uint32_t tick, RigSample& sample) override {
        const bool waits = tick > last_ && tick - last_ <= static_cast<std::uint32_t>(patience_);
        trace_.read(waits ? last_ : tick, sample);
        sample.tick = tick;
    }
    void write_force(Hand /*hand*/, const Vector3& /*force*/) override {}
    bool has_force(Hand /*hand*/) const override { return false; }
    double damping(Hand /*hand*/) const override { return -1; }

  private:
    TraceRig trace_;
    std::uint32_t last_;
    int patience_;
};

/// One attempt with its record.
struct Ran {
    ObservedAttempt observed;
    AttemptRecord record;
    std::uint64_t state_hash = 0;
    std::vector<StudiedGate> gates;
    bool stopped = false;
};

void note_values(const ScoredAttempt& scored, Ran& ran) {
    for (const MetricResult& row : scored.metrics) {
        if (!row.value || !std::isfinite(*row.value)) continue;
        const MetricDescriptor* metric = find_metric(row.id);
        const bool size = metric != nullptr && metric->absolute_value;
        ran.observed.values[metric_key(row.id, row.hand, row.tissue)] =
            size ? std::fabs(*row.value) : *row.value;
    }
    if (scored.score.points) ran.observed.values["points"] = *scored.score.points;
    for (const GateResult& gate : scored.score.gates)
        ran.gates.push_back({gate.metric, gate.hand, gate.tissue, gate.limit.value_or(0)});
}

/// The set of the scene's own fidelity, for every fidelity.
Limits limits_of(const std::string& task) {
    const LoadedTask own = load_task_and_scene(task);
    const Limits limits = limits_for(own.task, own.scene, DeviceClass::synthetic);
    return limits.set ? Limits(*limits.set) : limits;
}

/// `input`: null for an operator. Every fidelity is judged by the same limits.
Ran run_one(const std::string& task, std::uint64_t seed, Pairing pairing, FidelityLevel level,
            const AttemptRecord* input, const std::function<bool()>& keep_going) {
    const LoadedTask loaded = load_task_and_scene(task, row_of(fidelity_levels, level).name);
    Ran ran;
    ran.observed.task = task;
    ran.observed.seed = seed;
    ran.observed.operator_level = operator_levels[(seed - first_seed) % std::size(operator_levels)].kind;
    ran.observed.pairing = pairing;
    ran.observed.fidelity = level;
    AttemptEngine engine(loaded.scene, loaded.task, seed);
    const std::vector<TargetSphere>& targets = engine.initial_snapshot().targets;
    std::unique_ptr<Rig> rig;
    if (input != nullptr) {
        rig = std::make_unique<PatientRig>(input->inputs, loaded.scene.tick_rate);
    } else {
        auto performer = make_operator(ran.observed.operator_level, loaded.task, loaded.scene, seed);
        if (pairing == Pairing::repeated) performer = std::make_unique<DisturbedRig>(std::move(performer));
        rig = std::move(performer);
    }
    MemorySink sink;
    const double begin = lab::processor_time_us();
    const RunOutcome outcome =
        run_headless(engine, *rig, sink, [&](double) { return !keep_going || keep_going(); });
    ran.observed.processor_s = 1e-6 * (lab::processor_time_us() - begin);
    ran.observed.simulated_s = outcome.ticks * loaded.scene.tick_period();
    ran.state_hash = outcome.state_hash;
    ran.stopped = outcome.cancelled;
    ran.record = std::move(sink.record);
    if (ran.stopped) return ran;
    const ScoredAttempt scored = score_record(loaded.scene, loaded.task, targets, ran.record.samples,
                                              ran.record.events, limits_of(task));
    ran.observed.passed = scored.score.passed;
    note_values(scored, ran);
    return ran;
}

std::string verdict_of(const std::optional<bool>& passed) {
    return !passed ? "not scored" : *passed ? "passed" : "failed";
}

/// What one seed gives at one task.
struct Seed {
    std::vector<ObservedAttempt> attempts;
    std::vector<StudiedGate> gates;
    bool complete = false;
};

class StudyRun {
  public:
    explicit StudyRun(const FidelityStudyRequest& request)
        : request_(request), seeds_(request.tasks.size() * static_cast<std::size_t>(request.seeds)) {}

    void work() {
        for (std::size_t k = next_++; k < seeds_.size() && going(); k = next_++) {
            try {
                perform(k);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(mutex_);
                trouble_ = std::current_exception();
                next_ = seeds_.size();
            }
        }
    }
    std::vector<Seed>& seeds() {
        if (trouble_) std::rethrow_exception(trouble_);
        return seeds_;
    }

  private:
    bool going() const { return !request_.keep_going || request_.keep_going(); }

    bool note(Seed& seed, const Ran& ran) {
        if (ran.stopped) return false;
        const ObservedAttempt& one = ran.observed;
        seed.attempts.push_back(one);
        const std::lock_guard<std::mutex> lock(mutex_);
        ++done_;
        if (request_.on_attempt)
            request_.on_attempt(std::to_string(done_) + " of " + std::to_string(6 * seeds_.size()) + ": " +
                                one.task + " seed " + std::to_string(one.seed) + " " +
                                row_of(operator_levels, one.operator_level).name + ", " +
                                row_of(pairings, one.pairing).name + " at " +
                                row_of(fidelity_levels, one.fidelity).name + ": " + verdict_of(one.passed) +
                                ", " + lab::short_number(one.simulated_s, 4) + " s simulated in " +
                                lab::short_number(one.processor_s, 3) + " s");
        return true;
    }

    void perform(std::size_t k) {
        const std::string& task = request_.tasks[k % request_.tasks.size()];
        const std::uint64_t number = first_seed + k / request_.tasks.size();
        Seed& seed = seeds_[k];
        const Ran standard =
            run_one(task, number, Pairing::performed, FidelityLevel::standard, nullptr, request_.keep_going);
        seed.gates = standard.gates;
        if (!note(seed, standard)) return;
        // A replay at the fidelity of the recording gives the recording again; checked once for each task.
        ObservedAttempt same = standard.observed;
        same.pairing = Pairing::replayed;
        if (k < request_.tasks.size()) {
            const Ran replay = run_one(task, number, Pairing::replayed, FidelityLevel::standard,
                                       &standard.record, request_.keep_going);
            if (!replay.stopped && replay.state_hash != standard.state_hash)
                throw InputError(task, "", "a replay at the same fidelity has another state",
                                 "compare with fulcrum replay --verify");
        }
        seed.attempts.push_back(same);
        for (const FidelityLevel level : {FidelityLevel::fast, FidelityLevel::fine}) {
            if (!note(seed, run_one(task, number, Pairing::performed, level, nullptr, request_.keep_going)) ||
                !note(seed,
                      run_one(task, number, Pairing::replayed, level, &standard.record, request_.keep_going)))
                return;
        }
        seed.complete = note(seed, run_one(task, number, Pairing::repeated, FidelityLevel::standard, nullptr,
                                           request_.keep_going));
    }

    const FidelityStudyRequest& request_;
    std::vector<Seed> seeds_;
    std::atomic<std::size_t> next_{0};
    std::size_t done_ = 0;
    std::mutex mutex_;
    std::exception_ptr trouble_;
};

}  // namespace

std::string metric_key(const std::string& id, const std::string& hand, const std::string& tissue) {
    return id + (hand.empty() ? "" : " " + hand) + (tissue.empty() ? "" : " " + tissue);
}

FidelityStudy run_fidelity_study(const FidelityStudyRequest& request) {
    FidelityStudy study;
    study.physics = physics_version;
    study.commit = request.commit;
    for (const std::string& id : request.tasks) {
        const LoadedTask loaded = load_task_and_scene(id);
        study.tasks.push_back({id,
                               limits_of(id).name(),
                               loaded.scene.fidelity.id,
                               loaded.task.version,
                               {},
                               gated_metric_versions(loaded.task)});
    }
    StudyRun run(request);
    std::vector<std::thread> threads;
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    for (unsigned i = 0; i < cores; ++i) threads.emplace_back([&run] { run.work(); });
    for (std::thread& thread : threads) thread.join();
    std::vector<Seed>& seeds = run.seeds();
    for (std::size_t k = 0; k < seeds.size(); ++k) {
        if (!seeds[k].complete) continue;
        study.tasks[k % request.tasks.size()].gates = seeds[k].gates;
        for (ObservedAttempt& attempt : seeds[k].attempts) study.attempts.push_back(std::move(attempt));
    }
    return study;
}

nlohmann::json to_json(const FidelityStudy& study) {
    nlohmann::json tasks = nlohmann::json::array(), attempts = nlohmann::json::array();
    for (const StudiedTask& task : study.tasks) {
        nlohmann::json gates = nlohmann::json::array();
        for (const StudiedGate& gate : task.gates)
            gates.push_back({{"metric", gate.metric},
                             {"hand", gate.hand},
                             {"tissue", gate.tissue},
                             {"limit", gate.limit}});
        tasks.push_back({{"task", task.id},
                         {"version", task.version},
                         {"limits", task.limits},
                         {"fidelity", task.fidelity},
                         {"gates", gates},
                         {"metrics", task.metrics}});
    }
    for (const ObservedAttempt& one : study.attempts)
        attempts.push_back({{"task", one.task},
                            {"operator", row_of(operator_levels, one.operator_level).name},
                            {"seed", one.seed},
                            {"pairing", row_of(pairings, one.pairing).name},
                            {"fidelity", row_of(fidelity_levels, one.fidelity).name},
                            {"passed", one.passed ? nlohmann::json(*one.passed) : nlohmann::json()},
                            {"simulated_s", one.simulated_s},
                            {"processor_s", one.processor_s},
                            {"values", one.values}});
    return {{"physics", study.physics}, {"commit", study.commit}, {"tasks", tasks}, {"attempts", attempts}};
}

namespace {

ObservedAttempt attempt_of(const nlohmann::json& row) {
    ObservedAttempt one;
    one.task = row.at("task").get<std::string>();
    one.operator_level = operator_level(row.at("operator").get<std::string>());
    one.seed = row.at("seed").get<std::uint64_t>();
    const auto* pairing = find_row(pairings, row.at("pairing").get<std::string>());
    if (pairing == nullptr) throw std::out_of_range("unknown pairing");
    one.pairing = pairing->kind;
    const auto* level = find_row(fidelity_levels, row.at("fidelity").get<std::string>());
    if (level == nullptr) throw std::out_of_range("unknown fidelity");
    one.fidelity = level->kind;
    if (!row.at("passed").is_null()) one.passed = row.at("passed").get<bool>();
    one.simulated_s = row.at("simulated_s").get<double>();
    one.processor_s = row.at("processor_s").get<double>();
    one.values = row.at("values").get<std::map<std::string, double>>();
    return one;
}

}  // namespace

FidelityStudy fidelity_study_of(const nlohmann::json& document, const std::string& file) {
    try {
        FidelityStudy study;
        study.physics = document.at("physics").get<int>();
        study.commit = document.at("commit").get<std::string>();
        for (const auto& row : document.at("tasks")) {
            StudiedTask task;
            task.id = row.at("task").get<std::string>();
            task.version = row.at("version").get<int>();
            task.limits = row.at("limits").get<std::string>();
            task.fidelity = row.at("fidelity").get<std::string>();
            for (const auto& gate : row.at("gates"))
                task.gates.push_back({gate.at("metric").get<std::string>(),
                                      gate.at("hand").get<std::string>(),
                                      gate.at("tissue").get<std::string>(), gate.at("limit").get<double>()});
            if (row.contains("metrics")) task.metrics = row.at("metrics").get<std::map<std::string, int>>();
            study.tasks.push_back(std::move(task));
        }
        for (const auto& row : document.at("attempts")) study.attempts.push_back(attempt_of(row));
        return study;
    } catch (const std::exception& error) {
        throw InputError(file, "", std::string("is not a record of this study (") + error.what() + ")",
                         "give the fidelity_score.json that fulcrum lab fidelity wrote");
    }
}

}  // namespace fulcrum::app
