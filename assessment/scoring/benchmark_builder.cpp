// SPDX-License-Identifier: Apache-2.0
#include "assessment/scoring/benchmark_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "assessment/learning/statistics.h"
#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "assessment/scoring/own_limits.h"
#include "assessment/scoring/taken_over.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum {

namespace {

constexpr int fewest_experts_left = 6;
constexpr int first_k = 10, last_k = 30;  // tenths

std::string level_name(const BenchmarkLevel& level) {
    std::string name = level.metric;
    if (!level.hand.empty()) name += " " + level.hand;
    if (!level.tissue.empty()) name += " " + level.tissue;
    return name;
}

/// The values of an attempt that a gate's level is made of: those of both hands where they are alike.
std::vector<double> values_in(const BenchmarkAttempt& attempt, const TaskDefinition& task,
                              const GateSpec& gate, const MetricDescriptor& descriptor) {
    std::vector<std::string> hands = {gate.hand};
    if (task.hands_alike && !gate.hand.empty()) hands = {"left", "right"};
    std::vector<double> values;
    for (const std::string& hand : hands) {
        const MetricResult* result = find_result(attempt.metrics, gate.metric, hand, gate.tissue);
        if (result == nullptr || !result->value) continue;
        if (const std::optional<double> scaled = on_scale(descriptor, *result->value))
            values.push_back(*scaled);
    }
    return values;
}

/// The values of one gate by person, in the order in which they first appear; completed attempts only.
/// `without` leaves one out.
std::vector<ExpertValues> values_by_person(const std::vector<BenchmarkAttempt>& attempts,
                                           const TaskDefinition& task, const GateSpec& gate,
                                           const MetricDescriptor& descriptor, const std::string& without) {
    std::vector<ExpertValues> people;
    for (const BenchmarkAttempt& attempt : attempts) {
        if (attempt.person == without || attempt.state != AttemptState::completed) continue;
        const std::vector<double> values = values_in(attempt, task, gate, descriptor);
        if (values.empty()) continue;
        auto person = std::find_if(people.begin(), people.end(),
                                   [&](const ExpertValues& known) { return known.expert == attempt.person; });
        if (person == people.end()) person = people.insert(people.end(), {attempt.person, {}});
        person->values.insert(person->values.end(), values.begin(), values.end());
    }
    return people;
}

/// Counts, shares, grades, and metrics that vary by less than their precision have no z.
bool takes_z(const MetricDescriptor& d, const ExpertBenchmark& benchmark) {
    if (d.aggregation == Aggregation::count || d.aggregation == Aggregation::share ||
        d.aggregation == Aggregation::grade)
        return false;
    const double in_unit =
        d.scale == Scale::ln ? std::exp(benchmark.mean) * benchmark.deviation : benchmark.deviation;
    return in_unit >= d.precision;
}

/// The worst value of the experts who count, in the metric's unit.
double worst_value(const MetricDescriptor& d, const std::vector<ExpertValues>& experts,
                   const ExpertBenchmark& benchmark) {
    const double sign = d.direction == Direction::higher ? -1.0 : 1.0;
    std::optional<double> worst;
    for (const ExpertValues& expert : experts) {
        const bool left_out =
            std::any_of(benchmark.left_out.begin(), benchmark.left_out.end(),
                        [&](const LeftOutExpert& out) { return out.expert == expert.expert; });
        if (left_out) continue;
        for (const double value : expert.values)
            if (!worst || sign * value > sign * *worst) worst = value;
    }
    return d.scale == Scale::ln ? std::exp(*worst) : *worst;
}

struct Levels {
    std::vector<BenchmarkLevel> levels;
    Sentence refusal;
};

/// The levels of all benchmark gates, from all experts but one (`without` empty: from all); with `narrowed`
/// also of the absolute gates whose metric has a spread, of those that enough experts have a value of.
Levels make_levels(const TaskDefinition& task, const BenchmarkRequest& request, const std::string& without,
                   bool narrowed = false) {
    Levels out;
    const int fewest = without.empty() ? fewest_experts_left : fewest_experts_left - 1;
    for (const GateSpec& gate : task.gates) {
        const bool narrows = gate.kind == GateKind::absolute;
        if (narrows && !narrowed) continue;
        const MetricDescriptor& d = *find_metric(gate.metric);
        const std::vector<ExpertValues> experts = values_by_person(request.experts, task, gate, d, without);
        if (narrows && static_cast<int>(experts.size()) <= fewest) continue;
        BenchmarkLevel level;
        level.metric = gate.metric;
        level.hand = gate.hand;
        level.tissue = gate.tissue;
        level.metric_version = d.version;
        level.unit = d.unit;
        level.scale = d.scale;
        std::optional<ExpertBenchmark> benchmark = expert_benchmark(experts, fewest, request.outliers);
        if (!benchmark) {
            out.refusal = {
                QT_TRANSLATE_NOOP("errors",
                                  "%1: fewer than %2 experts are left with a value after the outlier rule"),
                level_name(level), fewest};
            return out;
        }
        benchmark->deviation = std::max(benchmark->deviation, d.least_deviation);
        level.mean = benchmark->mean;
        level.deviation = benchmark->deviation;
        level.experts = benchmark->experts;
        for (const LeftOutExpert& expert : benchmark->left_out) level.left_out.push_back(expert.expert);
        const bool z = takes_z(d, *benchmark);
        if (narrows && !z) continue;
        if (!z) {
            level.absolute_limit = worst_value(d, experts, *benchmark);
        } else {
            std::vector<double> means;
            for (const ExpertValues& novice : values_by_person(request.novices, task, gate, d, {}))
                means.push_back(mean_of(novice.values));
            if (!means.empty()) level.z_novice = z_of(d, level, mean_of(means));
        }
        out.levels.push_back(std::move(level));
    }
    return out;
}

/// Attempts by person, in order of appearance.
std::vector<BenchmarkPerson> people_of(const std::vector<BenchmarkAttempt>& attempts, int familiarisation) {
    std::vector<BenchmarkPerson> people;
    for (const BenchmarkAttempt& attempt : attempts) {
        auto person = std::find_if(people.begin(), people.end(), [&](const BenchmarkPerson& known) {
            return known.name == attempt.person;
        });
        if (person == people.end())
            person = people.insert(people.end(), {attempt.person, 0, familiarisation});
        ++person->attempts;
    }
    return people;
}

Sentence too_few(const BenchmarkRequest& request, const std::vector<BenchmarkPerson>& experts) {
    if (static_cast<int>(experts.size()) < request.minimum_experts)
        return {QT_TRANSLATE_NOOP("errors", "%1 experts where %2 are needed"), experts.size(),
                request.minimum_experts};
    for (const BenchmarkPerson& expert : experts)
        if (expert.attempts < request.minimum_attempts)
            return {QT_TRANSLATE_NOOP("errors", "%1 has %2 counted attempts where %3 are needed"),
                    expert.name, expert.attempts, request.minimum_attempts};
    if (request.familiarisation < request.minimum_familiarisation)
        return {QT_TRANSLATE_NOOP("errors",
                                  "fewer than %1 familiarisation attempts came before the counted ones"),
                request.minimum_familiarisation};
    return {};
}

/// Why limits are not made of these: people and synthetic operators among them. Empty: they are alike.
Sentence partly_simulated(const std::vector<BenchmarkAttempt>& attempts) {
    const BenchmarkAttempt *person = nullptr, *simulated = nullptr;
    for (const BenchmarkAttempt& attempt : attempts) (attempt.simulated ? simulated : person) = &attempt;
    if (person == nullptr || simulated == nullptr) return {};
    return {QT_TRANSLATE_NOOP("errors", "the attempts of %1 are simulated, those of %2 are not"),
            simulated->person, person->person};
}

Score score_of(const TaskDefinition& task, const BenchmarkAttempt& attempt, const BenchmarkSet& set) {
    ScoreInput input{task, attempt.metrics, &set, attempt.state};
    input.critical_errors = attempt.critical_errors;
    return score_attempt(input);
}

bool same_gate(const BenchmarkLevel& a, const BenchmarkLevel& b) {
    return a.metric == b.metric && a.hand == b.hand && a.tissue == b.tissue;
}

/// An attempt as limits_between() needs it. A value without z (a force of 0, a worst counted value) is judged
/// apart from k.
JudgedAttempt judged_without_levels(const TaskDefinition& task, const BenchmarkAttempt& attempt,
                                    BenchmarkSet set) {
    JudgedAttempt judged;
    set.k = no_limit;
    for (BenchmarkLevel& level : set.levels) {
        level.k.reset();
        const MetricDescriptor& d = *find_metric(level.metric);
        const MetricResult* result = find_result(attempt.metrics, level.metric, level.hand, level.tissue);
        std::optional<double> scaled;
        if (result != nullptr && result->value && !level.absolute_limit) scaled = on_scale(d, *result->value);
        judged.z.push_back(scaled ? z_of(d, level, *scaled) : -no_limit);
    }
    judged.otherwise = score_of(task, attempt, set).passed == true;
    return judged;
}

int number_of(const std::string& person, const std::vector<BenchmarkPerson>& people) {
    const auto place = std::find_if(people.begin(), people.end(),
                                    [&](const BenchmarkPerson& known) { return known.name == person; });
    return static_cast<int>(place - people.begin());
}

/// By metric, hand and event (BenchmarkFailure).
using Failures = std::map<std::array<std::string, 3>, int>;

/// Scores every expert attempt against the set made without its expert.
class LeaveOneOut {
  public:
    LeaveOneOut(const TaskDefinition& task, const BenchmarkRequest& request, const BenchmarkSet& full,
                bool narrowed = false)
        : task_(task), request_(request), full_(full) {
        for (const BenchmarkPerson& expert : full.experts) {
            Levels levels = make_levels(task, request, expert.name, narrowed);
            if (!levels.refusal.empty())
                refusal_ = {QT_TRANSLATE_NOOP("errors", "without %1: %2"), expert.name, levels.refusal};
            levels_[expert.name] = std::move(levels.levels);
        }
    }
    const Sentence& refusal() const { return refusal_; }

    /// Share of attempts that pass all gates at this k; counts into `failures` which gates were not met.
    double pass_share(double k, Failures& failures) const {
        BenchmarkSet set = full_;
        set.k = k;
        return pass_share(set, failures);
    }
    /// The same with the set's k of each level.
    double pass_share(const BenchmarkSet& limits, Failures& failures) const {
        int passed = 0;
        for (const BenchmarkAttempt& attempt : request_.experts) {
            const Score score = score_of(task_, attempt, without_its_expert(limits, attempt));
            passed += score.passed == true ? 1 : 0;
            for (const CriticalError& error : attempt.critical_errors) ++failures[{"", "", error.event}];
            for (const GateResult& gate : score.gates)
                if (gate.passed != true) ++failures[{gate.metric, gate.hand, ""}];
        }
        return static_cast<double>(passed) / static_cast<double>(request_.experts.size());
    }
    std::vector<JudgedAttempt> judged() const {
        std::vector<JudgedAttempt> all;
        for (const BenchmarkAttempt& attempt : request_.experts) {
            all.push_back(judged_without_levels(task_, attempt, without_its_expert(full_, attempt)));
            all.back().person = number_of(attempt.person, full_.experts);
        }
        return all;
    }

  private:
    /// The set made without the attempt's expert: the levels of `limits`, with their k.
    BenchmarkSet without_its_expert(const BenchmarkSet& limits, const BenchmarkAttempt& attempt) const {
        BenchmarkSet set = limits;
        for (BenchmarkLevel& level : set.levels) {
            for (const BenchmarkLevel& other : levels_.at(attempt.person)) {
                if (!same_gate(other, level)) continue;
                const std::optional<double> k = level.k;
                level = other;
                level.k = k;
            }
        }
        return set;
    }

    const TaskDefinition& task_;
    const BenchmarkRequest& request_;
    const BenchmarkSet& full_;
    std::map<std::string, std::vector<BenchmarkLevel>> levels_;
    Sentence refusal_;
};

/// Whose share is nearest to the aim; of several the middle one. Shares rise with k, so those are neighbours.
const BenchmarkTrial& nearest_trial(const std::vector<BenchmarkTrial>& trials, double aim) {
    std::vector<const BenchmarkTrial*> nearest;
    double least = 2;
    for (const BenchmarkTrial& trial : trials) {
        const double distance = std::abs(trial.pass_share - aim);
        if (distance < least - 1e-9) {
            nearest.clear();
            least = distance;
        }
        if (distance <= least + 1e-9) nearest.push_back(&trial);
    }
    return *nearest[(nearest.size() - 1) / 2];
}

/// Levels with the same number keep one k: those of both hands where they are alike.
std::vector<int> gates_of(const TaskDefinition& task, const BenchmarkSet& set) {
    std::vector<int> gates;
    for (std::size_t i = 0; i < set.levels.size(); ++i) {
        int gate = static_cast<int>(i);
        for (std::size_t j = 0; task.hands_alike && j < i && gate == static_cast<int>(i); ++j)
            if (set.levels[j].metric == set.levels[i].metric && set.levels[j].tissue == set.levels[i].tissue)
                gate = gates[j];
        gates.push_back(gate);
    }
    return gates;
}

int passing(const TaskDefinition& task, const std::vector<BenchmarkAttempt>& attempts,
            const BenchmarkSet& set) {
    return static_cast<int>(std::count_if(
        attempts.begin(), attempts.end(),
        [&](const BenchmarkAttempt& attempt) { return score_of(task, attempt, set).passed == true; }));
}

std::string percent(double share) {
    return decimal_text(100.0 * share, 1) + " %";
}

bool of_benchmark_gate(const TaskDefinition& task, const BenchmarkLevel& level) {
    return std::any_of(task.gates.begin(), task.gates.end(), [&](const GateSpec& gate) {
        return gate.kind == GateKind::benchmark && gate.metric == level.metric && gate.hand == level.hand &&
               gate.tissue == level.tissue;
    });
}

/// Gives each gate a k of its own, absolute gates too where that brings both shares nearer to their middles.
/// Returns what is to be expected of fresh attempts; where that is not sure, `set` stays as it is.
HeldOutLimits set_own_limits(const TaskDefinition& task, const BenchmarkRequest& request, BenchmarkSet& set) {
    BenchmarkSet wide = set;
    wide.levels = make_levels(task, request, {}, true).levels;
    const LeaveOneOut leave_one_out(task, request, wide, true);
    std::vector<double> start;
    for (const BenchmarkLevel& level : wide.levels)
        start.push_back(of_benchmark_gate(task, level) ? set.k : no_limit);
    std::vector<JudgedAttempt> intermediates;
    for (const BenchmarkAttempt& attempt : request.intermediates) {
        intermediates.push_back(judged_without_levels(task, attempt, wide));
        intermediates.back().person = number_of(attempt.person, set.intermediates);
    }
    HeldOutLimits chosen =
        limits_for_fresh(leave_one_out.judged(), intermediates, gates_of(task, wide), start);
    if (!chosen.sure()) return chosen;
    set.levels.clear();
    for (std::size_t i = 0; i < chosen.k.size(); ++i) {
        if (chosen.k[i] == no_limit) continue;
        BenchmarkLevel level = wide.levels[i];
        if (!level.absolute_limit && std::abs(chosen.k[i] - set.k) > 1e-9) level.k = chosen.k[i];
        set.levels.push_back(std::move(level));
    }
    return chosen;
}

/// With intermediates: how many pass, and a k for each gate where that is not surely within its band.
void heed_intermediates(const TaskDefinition& task, const BenchmarkRequest& request, BenchmarkSet& set,
                        std::vector<std::string>& log) {
    if (request.intermediates.empty()) return;
    const int all = static_cast<int>(request.intermediates.size());
    const auto share = [&](int passed) { return static_cast<double>(passed) / all; };
    set.intermediates = people_of(request.intermediates, request.familiarisation);
    const int passed = passing(task, request.intermediates, set);
    set.intermediate_pass_share = share(passed);
    log.push_back("k " + decimal_text(set.k, 1) + ": " + percent(share(passed)) +
                  " of intermediates' attempts pass");
    if (intermediates_surely_within(passed, all)) return;
    const HeldOutLimits chosen = set_own_limits(task, request, set);
    const std::string of_left_out = percent(chosen.held_out.intermediates) + ", of experts' " +
                                    percent(chosen.held_out.experts) + " (" + percent(chosen.experts_low) +
                                    " to " + percent(chosen.experts_high) + " with " +
                                    std::to_string(chosen.people) + " people)";
    if (!chosen.sure()) {
        log.push_back(
            "limits of each gate's own are not used: of intermediates left out when they are chosen " +
            of_left_out + " pass, where at least " + percent(least_held_out) + " of experts' have to");
        return;
    }
    for (const BenchmarkLevel& level : set.levels)
        if (level.k) log.push_back(level_name(level) + ": k " + decimal_text(*level.k, 1) + " of its own");
    set.intermediate_pass_share = chosen.held_out.intermediates;
    log.push_back("with these: " + percent(share(passing(task, request.intermediates, set))) +
                  " of intermediates' attempts pass; of those left out when limits are chosen " +
                  of_left_out);
}

void log_levels(const BenchmarkSet& set, std::vector<std::string>& log) {
    for (const BenchmarkLevel& level : set.levels) {
        for (const std::string& expert : level.left_out)
            log.push_back(level_name(level) + ": " + expert +
                          " left out, mean beyond 1.96 SD of the experts' means");
        if (level.absolute_limit)
            log.push_back(level_name(level) + ": takes no z, absolute limit " +
                          decimal_text(*level.absolute_limit, 4) + " " + level.unit +
                          ", the worst counted expert value");
    }
}

}  // namespace

BenchmarkBuild build_benchmark(const TaskDefinition& task, const BenchmarkRequest& request) {
    check_gates(task, "task " + task.id);
    BenchmarkBuild build;
    BenchmarkSet set;
    set.version = request.version;
    set.task = task.id;
    set.task_version = task.version;
    set.variant_family = request.variant_family;
    set.device_class = request.device_class;
    set.fidelity = request.fidelity;
    set.source = request.source;
    set.cutting = request.cutting;
    const auto simulated = std::count_if(request.experts.begin(), request.experts.end(),
                                         [](const BenchmarkAttempt& one) { return one.simulated; });
    set.provisional = request.provisional || simulated > 0;
    if (!set.provisional) set.taken_over = limits_to_take_over(task);
    set.p0 = request.p0;
    set.experts = people_of(request.experts, request.familiarisation);
    set.novices = people_of(request.novices, request.familiarisation);
    build.refusal = too_few(request, set.experts);
    if (build.refusal.empty()) build.refusal = partly_simulated(request.experts);
    if (!build.refusal.empty()) return build;
    Levels levels = make_levels(task, request, {});
    build.refusal = levels.refusal;
    if (!build.refusal.empty()) return build;
    set.levels = std::move(levels.levels);
    log_levels(set, build.log);

    const LeaveOneOut leave_one_out(task, request, set);
    build.refusal = leave_one_out.refusal();
    if (!build.refusal.empty()) return build;
    for (int tenths = first_k; tenths <= last_k; ++tenths) {
        Failures failures;
        build.trials.push_back({tenths / 10.0, leave_one_out.pass_share(tenths / 10.0, failures)});
    }
    const BenchmarkTrial& chosen = nearest_trial(build.trials, 1.0 - request.p0);
    set.k = chosen.k;
    heed_intermediates(task, request, set, build.log);
    Failures failures;
    set.expert_pass_share = LeaveOneOut(task, request, set, true).pass_share(set, failures);
    for (const auto& [what, count] : failures) {
        const auto& [metric, hand, event] = what;
        build.failures.push_back({metric, hand, event, count});
        const std::string gate =
            !event.empty() ? "critical error " + event : metric + (hand.empty() ? "" : " " + hand);
        build.log.push_back("k " + decimal_text(set.k, 1) + ": " + gate + " not met by " +
                            std::to_string(count) + " expert attempts with their expert left out");
    }
    if (set.expert_pass_share < 1.0 - request.most_failing - 1e-12) {
        build.refusal = {
            QT_TRANSLATE_NOOP("errors",
                              "only %1 % of the experts' own attempts pass all gates at k = %2, the best of "
                              "all, where %3 % are needed"),
            decimal_text(100.0 * set.expert_pass_share, 1), decimal_text(set.k, 1),
            decimal_text(100.0 * (1.0 - request.most_failing), 1)};
        return build;
    }
    build.set = std::move(set);
    return build;
}

}  // namespace fulcrum
