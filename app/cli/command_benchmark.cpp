// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum benchmark build: builds a benchmark set from synthetic operators or from named experts' attempts.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/commands.h"
#include "app/cli/operator_attempts.h"
#include "app/live/performance.h"
#include "assessment/assets/assets.h"
#include "assessment/operators/device_model.h"
#include "assessment/scoring/benchmark_builder.h"
#include "assessment/scoring/judged_limits.h"
#include "assessment/scoring/taken_over.h"
#include "assessment/task/limit_source.h"
#include "database/records/people.h"
#include "database/scoring/expert_attempts.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/number_text.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::app {
namespace {

/// Performs one attempt of an operator and prints how it ended. Operators do not learn, so they need no
/// familiarisation; the set records 0.
BenchmarkAttempt performed(const LoadedTask& loaded, DeviceClass device_class, const OperatorJob& job) {
    PerformRequest request;
    request.loaded = loaded;
    request.operator_level = job.level;
    request.seed = job.seed;
    request.device_class = device_class;
    request.individual = job.drawn_from;  // one individual, many attempts
    const ScoredAttempt scored = perform(request, nullptr, {}).scored;
    std::ostringstream line;
    line << job.person() << " seed " << job.seed << ": " << row_of(attempt_states, scored.state).name
         << " in " << scored.duration_s << " s\n";
    std::cerr << line.str();
    return {job.person(), rows_of_gates(loaded.task, scored.metrics), scored.state,
            scored.score.critical_errors};
}

/// The people with these logins.
std::vector<ExpertCandidate> experts_named(const database::Store& store, const database::Session& session,
                                           const std::vector<std::string>& logins) {
    const database::People people(store);
    std::vector<ExpertCandidate> experts;
    for (const std::string& login : logins) {
        const auto person = people.find_login(session, login);
        if (!person)
            throw InputError("--experts", "", {QT_TRANSLATE_NOOP("errors", "no person '%1'"), login},
                             QT_TRANSLATE_NOOP("errors", "name logins of this store, separated by commas"));
        experts.push_back({person->id, login, person->display_name, 0});
    }
    return experts;
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
    const TaskRequest wanted{arguments.words()[0], arguments.value_or("--variant", ""), {}};
    Setting setting{load_task_and_scene(wanted), {}, {}};
    const std::string family = variant_family(setting.loaded.task, setting.loaded.scene.variant);
    if (family != setting.loaded.scene.variant)
        throw UsageError(
            "--variant",
            {QT_TRANSLATE_NOOP("errors", "is %1, whose attempts are compared with the sets of %2"),
             setting.loaded.scene.variant, family},
            {QT_TRANSLATE_NOOP("errors", "name %1, or remove its family from the task"), family});
    const bool experts = arguments.has("--experts");
    if (!experts && !arguments.has("--db")) return setting;
    setting.store = open_store(arguments, false);
    setting.session =
        experts ? person_session(arguments, *setting.store) : session_of(arguments, *setting.store);
    setting.loaded = load_site_task(*setting.store, *setting.session, wanted);
    return setting;
}

/// The experts, as screens name them.
std::string source_of(DeviceClass device_class) {
    std::string source = simulated_experts;
    if (device_class != DeviceClass::haptic)
        source += std::string(" through a model of ") + row_of(device_classes, device_class).title;
    return source + ", seeds 1000-1999";
}

/// The file that --attempts names; absent without it.
std::optional<KeptAttempts> kept_attempts(const Arguments& arguments, const LoadedTask& loaded,
                                          DeviceClass device_class,
                                          const std::optional<std::string>& output) {
    const std::optional<std::string> path = arguments.value("--attempts");
    if (!path) return std::nullopt;
    std::error_code error;
    if (output && (*output == *path || std::filesystem::equivalent(*output, *path, error)))
        throw UsageError("--attempts", QT_TRANSLATE_NOOP("errors", "is the file that the set is written to"),
                         QT_TRANSLATE_NOOP("errors", "name two files"));
    KeptAttempts kept(*path, attempts_origin(loaded, device_class), arguments.has("--other-program"));
    std::cerr << kept.size() << " of " << count_of_operator_jobs() << " attempts are in " << *path << '\n';
    return kept;
}

BenchmarkRequest request_for(const Arguments& arguments, const Setting& setting, DeviceClass device_class,
                             const std::optional<std::string>& output) {
    const LoadedTask& loaded = setting.loaded;
    const BenchmarkKey key{loaded.task.id, variant_family(loaded.task, loaded.scene.variant), device_class,
                           loaded.scene.fidelity.id};
    const int version =
        next_benchmark_version(key, output ? std::vector<std::string>{*output} : std::vector<std::string>());
    if (!arguments.has("--operators")) {
        const std::vector<std::string> logins = split(*arguments.value("--experts"));
        if (logins.empty())
            throw UsageError("--experts", QT_TRANSLATE_NOOP("errors", "is empty"),
                             QT_TRANSLATE_NOOP("errors", "give logins separated by commas"));
        return expert_request(loaded, device_class, version,
                              *expert_attempts(*setting.store, *setting.session, loaded, device_class,
                                               experts_named(*setting.store, *setting.session, logins)));
    }
    std::optional<KeptAttempts> kept = kept_attempts(arguments, loaded, device_class, output);
    const KeptAttempts::Perform one = [&](const OperatorJob& job) {
        return performed(loaded, device_class, job);
    };
    if (kept) kept->require_same(one);
    const auto of = [&](OperatorLevel level) {
        return operator_attempts(level, one, kept ? &*kept : nullptr);
    };
    BenchmarkRequest request = expert_request(loaded, device_class, version, of(OperatorLevel::expert));
    request.source = source_of(device_class);
    request.outliers = false;
    request.familiarisation = request.minimum_familiarisation = 0;
    request.intermediates = of(OperatorLevel::intermediate);
    request.novices = of(OperatorLevel::novice);
    return request;
}

/// What the set judges by: the gates on the experts' range, and the absolute ones that it narrows.
std::vector<JudgedLimit> limits_of(const TaskDefinition& task, const BenchmarkSet& set) {
    std::vector<JudgedLimit> limits = judged_limits(task, &set);
    limits.erase(std::remove_if(limits.begin(), limits.end(),
                                [](const JudgedLimit& limit) { return !limit.of_set || !limit.limit; }),
                 limits.end());
    return limits;
}

nlohmann::json limits_json(const TaskDefinition& task, const BenchmarkSet& set) {
    nlohmann::json rows = nlohmann::json::array();
    for (const JudgedLimit& limit : limits_of(task, set)) {
        const BenchmarkLevel& level = *set.find(limit.metric, limit.hand, limit.tissue);
        rows.push_back({{"metric", limit.metric},
                        {"hand", or_null(limit.hand)},
                        {"tissue", or_null(limit.tissue)},
                        {"limit", *limit.limit},
                        {"unit", limit.unit},
                        {"better", limit.higher_is_better ? "higher" : "lower"},
                        {"k", level.absolute_limit ? nlohmann::json() : nlohmann::json(set.k_of(level))},
                        {"limit_of_task", or_null(limit.task_limit)}});
    }
    return rows;
}

nlohmann::json json_of(const BenchmarkBuild& build, const TaskDefinition& task) {
    nlohmann::json trials = nlohmann::json::array();
    for (const BenchmarkTrial& trial : build.trials)
        trials.push_back({{"k", trial.k}, {"pass_share", trial.pass_share}});
    return {{"task", task.id},
            {"usable", build.set.has_value()},
            {"refusal", or_null(build.refusal.words())},
            {"trials", trials},
            {"log", build.log},
            {"limits", build.set ? limits_json(task, *build.set) : nlohmann::json()},
            {"takes_over", build.set ? taken_over_to_json(build.set->taken_over) : nlohmann::json()},
            {"set", build.set ? benchmark_to_json(*build.set) : nlohmann::json()}};
}

void print_limits(const TaskDefinition& task, const BenchmarkSet& set) {
    for (const JudgedLimit& limit : limits_of(task, set)) {
        std::cout << limit.metric;
        for (const std::string& part : {limit.hand, limit.tissue})
            if (!part.empty()) std::cout << ' ' << part;
        std::cout << (limit.higher_is_better ? ": at least " : ": at most ") << decimal_text(*limit.limit, 4)
                  << ' ' << limit.unit;
        if (limit.task_limit && *limit.task_limit != *limit.limit)
            std::cout << ", narrower than the task's " << decimal_text(*limit.task_limit, 4) << ' '
                      << limit.unit;
        std::cout << '\n';
    }
}

/// What becomes of the task's provisional limits when the set is put in force.
void print_taken_over(const BenchmarkSet& set) {
    if (set.provisional) {
        std::cout << "provisional: made of simulated attempts; it takes over no limits of the task\n";
    } else if (!set.taken_over.empty()) {
        std::cout << "takes over as limits of this site: " << provisional_words(set.taken_over) << '\n';
    }
}

void print_summary(const TaskDefinition& task, const BenchmarkBuild& build) {
    for (const std::string& line : build.log) std::cout << line << '\n';
    for (const BenchmarkTrial& trial : build.trials)
        std::cout << "k " << trial.k << ": " << 100 * trial.pass_share
                  << " % of the experts' own attempts pass\n";
    if (build.set) {
        print_limits(task, *build.set);
        print_taken_over(*build.set);
    }
    std::cout << (build.set ? "usable at k " + std::to_string(build.set->k)
                            : "refused: " + build.refusal.words())
              << '\n';
}

/// Builds one set and writes it to `output`; true if it is usable.
bool build_one(const Arguments& arguments, const Setting& setting, DeviceClass device_class,
               const std::optional<std::string>& output) {
    if (output) require_writable_file(*output);  // checked before minutes of work
    const BenchmarkBuild build =
        build_benchmark(setting.loaded.task, request_for(arguments, setting, device_class, output));
    if (build.set && output) write_whole_file(*output, benchmark_text(*build.set));
    if (arguments.has("--json")) {
        print_json(json_of(build, setting.loaded.task));
    } else {
        print_summary(setting.loaded.task, build);
        if (build.set && output && !build.set->provisional)
            std::cout << "assessed attempts use it once an educator has accepted it: fulcrum assets accept "
                      << *output << " --reason TEXT --as LOGIN\n";
        if (build.set && !output) std::cout << benchmark_to_json(*build.set).dump(2) << '\n';
    }
    return build.set.has_value();
}

/// The sets of one variant family: for the haptic class and each other class that the task names and that has
/// a model.
bool build_family(const Arguments& arguments, const std::string& task, const std::string& variant,
                  const std::string& folder) {
    const Setting setting{load_task_and_scene(TaskRequest{task, variant, {}}), {}, {}};
    bool usable = true;
    for (const NameRow<DeviceClass>& row : device_classes) {
        if (limits_class(row.kind) != row.kind || !has_device_model(row.kind) ||
            !can_be_assessed(setting.loaded.task, row.kind))
            continue;
        const std::string name = benchmark_name({task, variant, row.kind, setting.loaded.scene.fidelity.id});
        std::cout << name << '\n';
        usable = build_one(arguments, setting, row.kind,
                           (std::filesystem::path(folder) / (name + ".json")).string()) &&
                 usable;
    }
    return usable;
}

/// The sets that this program ships: of every task with benchmark gates and each of its variant families.
int build_all(const Arguments& arguments) {
    const std::string folder = arguments.folder("--output", asset_path("benchmarks"));
    bool usable = true;
    for (const std::string& task : task_ids()) {
        const TaskDefinition definition = load_task(task_file(task));
        const std::vector<GateSpec>& gates = definition.gates;
        if (std::none_of(gates.begin(), gates.end(),
                         [](const GateSpec& gate) { return gate.kind == GateKind::benchmark; }))
            continue;
        for (const TaskVariant& variant : definition.variants)
            if (variant.family == variant.id)
                usable = build_family(arguments, task, variant.id, folder) && usable;
    }
    return usable ? 0 : 1;
}

int run_benchmark_build(const Arguments& arguments) {
    if (arguments.has("--operators") == arguments.has("--experts"))
        throw UsageError("benchmark build",
                         QT_TRANSLATE_NOOP("errors", "needs either --operators or --experts"),
                         QT_TRANSLATE_NOOP("errors", "give one of them"));
    arguments.exclude("--attempts", "--experts");
    if (arguments.has("--other-program") && !arguments.has("--attempts"))
        throw UsageError("--other-program", QT_TRANSLATE_NOOP("errors", "needs --attempts"),
                         QT_TRANSLATE_NOOP("errors", "name the file of attempts"));
    if (arguments.has("--all")) {
        for (const char* other : {"--experts", "--device-class", "--variant", "--db", "--json", "--attempts"})
            arguments.exclude("--all", other);
        if (!arguments.words().empty())
            throw UsageError(arguments.words()[0],
                             QT_TRANSLATE_NOOP("errors", "--all builds the sets of all tasks"),
                             QT_TRANSLATE_NOOP("errors", "remove one of them"));
        return build_all(arguments);
    }
    if (arguments.words().empty())
        throw UsageError("benchmark build", QT_TRANSLATE_NOOP("errors", "names no task"),
                         QT_TRANSLATE_NOOP("errors", "give a task, or --all"));
    const Setting setting = setting_of(arguments);
    const DeviceClass device_class =
        find_row(device_classes, arguments.value_or("--device-class", "haptic"))->kind;
    return build_one(arguments, setting, device_class, arguments.value("--output")) ? 0 : 1;
}

}  // namespace

Command benchmark_command() {
    return {
        "benchmark build",
        "[TASK]",
        0,
        1,
        QT_TRANSLATE_NOOP(
            "commands",
            "Builds a benchmark set and prints the share of its own experts' attempts that would pass."),
        joined({{"--operators", "",
                 QT_TRANSLATE_NOOP("commands", "Use synthetic operators; the set is provisional.")},
                {"--experts", "LOGIN,LOGIN,...",
                 QT_TRANSLATE_NOOP("commands",
                                   "Use the stored attempts of these people; needs --as. The set takes over "
                                   "the task's provisional limits; one of simulated people is provisional.")},
                {"--device-class",
                 "CLASS",
                 QT_TRANSLATE_NOOP(
                     "commands",
                     "The class of devices that the set is for; operators work through a model of it."),
                 "haptic",
                 {"haptic", "tracked", "controller", "mouse-keyboard"}},
                variant_option(),
                {"--all", "",
                 QT_TRANSLATE_NOOP("commands",
                                   "Build the sets of all tasks and device classes, from operators.")},
                {"--attempts", "FILE",
                 QT_TRANSLATE_NOOP("commands",
                                   "Keep the operators' attempts in this file, each as soon as it is over, "
                                   "and perform only those that it does not have.")},
                {"--other-program", "",
                 QT_TRANSLATE_NOOP("commands",
                                   "Use attempts in the file that another build of the program made; the "
                                   "first of each level is performed again and has to be the same.")},
                {"--output",
                 "FILE",
                 QT_TRANSLATE_NOOP("commands",
                                   "Write the set to this file; with --all, the sets to this folder. The "
                                   "version of a set is one more than that of the one it replaces."),
                 "",
                 {},
                 "-o"}},
               session_options()),
        run_benchmark_build};
}

}  // namespace fulcrum::app
