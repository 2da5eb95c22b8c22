// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum perform: performs, stores and scores one attempt without a window.
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/attempt_document.h"
#include "app/cli/commands.h"
#include "app/cli/installed_curriculum.h"
#include "app/live/frame_follower.h"
#include "app/live/frame_keeping.h"
#include "app/live/interrupted.h"
#include "app/live/live_attempt.h"
#include "app/live/performance.h"
#include "app/live/trace_input.h"
#include "app/live/trace_rig.h"
#include "assessment/assets/assets.h"
#include "assessment/assets/fidelity_cost.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/statement_words.h"
#include "assessment/operators/device_model.h"
#include "database/records/assessed_attempts.h"
#include "database/records/curricula.h"
#include "database/records/recorder.h"
#include "database/scoring/fidelity_now.h"
#include "database/store/accepted_assets.h"
#include "sim_core/scene/fidelity.h"

namespace fulcrum::app {
namespace {

struct Result {
    ScoredAttempt scored;
    std::uint64_t state_hash = 0;
    double wall_s = 0;
    std::uint64_t events = 0;
    std::uint32_t missed = 0;
    std::optional<LoopStatistics> statistics;
};

/// The person to whom the attempt belongs: synthetic or external, never real.
database::Person subject(const Arguments& arguments, const database::Store& store,
                         const database::Session& session, std::optional<OperatorLevel> level,
                         std::uint64_t seed) {
    const database::People people(store);
    if (const auto login = arguments.value("--person")) {
        return people.ensure_synthetic(
            session, *login, *login,
            level ? database::PersonKind::synthetic : database::PersonKind::external);
    }
    if (!level)
        return people.ensure_synthetic(session, "external-trace", "External trace",
                                       database::PersonKind::external);
    const std::string name = row_of(operator_levels, *level).name;
    const std::string login = "synthetic-" + name + "-" + std::to_string(seed);
    return people.ensure_synthetic(session, login, "Synthetic " + name + " " + std::to_string(seed),
                                   database::PersonKind::synthetic);
}

nlohmann::json to_json(const database::AttemptMeta& meta, const std::string& attempt,
                       const database::Person& person, const Result& result) {
    nlohmann::json document = attempt_document(meta, attempt, result.scored);
    document.update({{"person", person.login},
                     {"person_id", person.id},
                     {"synthetic", person.kind != database::PersonKind::real},
                     {"wall_s", result.wall_s},
                     {"events", result.events},
                     {"missed_ticks", result.missed},
                     {"state_hash", hex(result.state_hash)},
                     {"loop", result.statistics ? statistics_json(*result.statistics) : nlohmann::json()}});
    return document;
}

Result perform_on_the_clock(const LoadedTask& loaded, std::shared_ptr<Rig> rig, const database::Store& store,
                            const database::Session& session, const database::AttemptMeta& meta,
                            const Limits& limits, std::string& attempt_id) {
    LiveRequest request{loaded,         meta.seed,    meta.mode == AttemptMode::assessed,
                        std::move(rig), store.path(), session,
                        meta,           limits};
    const auto follower = std::make_shared<FrameFollower>();
    request.follower = follower;
    LiveAttempt attempt(std::move(request));
    attempt.start();
    attempt.wait();
    attempt.rethrow();
    follower->finish_here();
    Result result;
    result.scored = *attempt.scored();
    result.state_hash = attempt.state_hash();
    result.statistics = attempt.statistics();
    result.wall_s = attempt.outcome()->duration_s;
    result.missed = attempt.outcome()->missed_ticks;
    attempt_id = attempt.outcome()->attempt_id;
    return result;
}

void keep_frames(const FrameKeeping& keeping, const FrameStore& frames, const AttemptRecord& record) {
    if (record.inputs.empty()) return;
    FrameFileWriter writer(keeping, frames.frames(), record.inputs.back().tick);
    while (writer.write_more()) {
    }
}

void print_summary(const nlohmann::json& document) {
    const auto text = [](const nlohmann::json& value) {
        return value.is_null()     ? std::string("-")
               : value.is_string() ? value.get<std::string>()
                                   : value.dump();
    };
    std::cout << text(document["task"]) << " by " << text(document["person"]) << ": "
              << text(document["state"]) << " after " << text(document["duration_s"]) << " s, passed "
              << text(document["passed"]) << ", points " << text(document["points"]) << "\n  attempt "
              << text(document["attempt"]) << "  state_hash " << text(document["state_hash"]) << "\n  "
              << text(document["advice"]) << '\n';
    if (!document["not_scored_because"].is_null())
        std::cout << "  not scored: " << text(document["not_scored_because"]) << '\n';
    for (const auto& gate : document["gates"]) {
        std::cout << "  gate " << text(gate["metric"]) << ' ' << text(gate["hand"]) << ' '
                  << text(gate["tissue"]) << ": " << text(gate["value"]) << " limit " << text(gate["limit"])
                  << ' ' << text(gate["unit"]) << " passed " << text(gate["passed"])
                  << (gate["provisional"] == true ? " (provisional)" : "") << '\n';
    }
}

}  // namespace

std::vector<std::string> fidelity_names() {
    std::vector<std::string> names;
    for (const NameRow<FidelityLevel>& level : fidelity_levels) names.push_back(level.name);
    return names;
}

std::vector<std::string> device_class_names() {
    std::vector<std::string> names;
    for (const NameRow<DeviceClass>& row : device_classes) names.push_back(row.name);
    return names;
}

namespace {

/// With which device the attempt is made: as named, else an operator without a device or a trace file.
DeviceClass class_of(const Arguments& arguments, std::optional<OperatorLevel> level) {
    if (const auto name = arguments.value("--device-class")) return find_row(device_classes, *name)->kind;
    return level ? DeviceClass::synthetic : DeviceClass::external;
}

/// Three significant digits, with the decimal sign of the reader's language.
Sentence three_digits(double value, bool with_sign) {
    std::ostringstream stream;
    stream << std::setprecision(3) << (with_sign ? std::showpos : std::noshowpos) << value;
    const std::string text = stream.str();
    const std::size_t point = text.find('.');
    if (point == std::string::npos) return text;
    return {QT_TRANSLATE_NOOP("commands", "%1.%2"), text.substr(0, point), text.substr(point + 1)};
}

/// "standard 46.2 ms of processor time for one second, ..."
Sentence cost_text(const FidelityCost& cost) {
    const Sentence time = three_digits(cost.processor_ms, false);
    if (cost.fidelity == finest_fidelity())
        return {QT_TRANSLATE_NOOP("commands", "%1 %2 ms of processor time for one second, the reference"),
                cost.fidelity, time};
    if (cost.metric.empty() && cost.verdicts == 0)
        return {QT_TRANSLATE_NOOP("commands", "%1 %2 ms of processor time for one second, the same score"),
                cost.fidelity, time};
    if (cost.metric.empty())
        return {QT_TRANSLATE_NOOP("commands",
                                  "%1 %2 ms of processor time for one second, another verdict for %3 of %4"),
                cost.fidelity, time, cost.verdicts, cost.attempts};
    return {
        QT_TRANSLATE_NOOP("commands",
                          "%1 %2 ms of processor time for one second, %3 %4 %, another verdict for %5 of %6"),
        cost.fidelity,
        time,
        cost.metric + (cost.hand.empty() ? "" : " " + cost.hand),
        three_digits(cost.shift_percent, true),
        cost.verdicts,
        cost.attempts};
}

std::string cost_text(const std::string& task, const std::string& fidelity) {
    if (const auto costs = fidelity_cost(task)) {
        for (const FidelityCost& cost : costs->levels)
            if (cost.fidelity == fidelity)
                return cost_text(cost).words() + " (against " + finest_fidelity() +
                       (measured_as_now(*costs, task) ? ")\n" : "; measured with an earlier version)\n");
    }
    return fidelity + ": what it costs in score is not measured for this version\n";
}

/// For --help: what each fidelity costs at each task.
Sentence costs_text() {
    std::optional<FidelityCosts> costs;
    try {
        costs = fidelity_costs();
    } catch (const InputError&) {  // no assets: the commands that need them report it
    }
    if (!costs)
        return QT_TRANSLATE_NOOP("commands",
                                 "What a fidelity costs in score is not measured for this version.");
    Sentence text(
        QT_TRANSLATE_NOOP("commands",
                          "Fidelities with another score than %1, measured with synthetic operators "
                          "(fulcrum lab fidelity): the assessed metric that differs most, and "
                          "verdicts that differ."),
        finest_fidelity());
    std::string earlier;  // tasks
    for (const auto& [task, measured] : costs->tasks) {
        if (!measured_with_this_program(measured)) earlier += (earlier.empty() ? "" : ", ") + task;
        for (const FidelityCost& cost : measured.levels) {
            if (cost.metric.empty() && cost.verdicts == 0) continue;
            const Sentence verdicts(QT_TRANSLATE_NOOP("commands", "%1 at %2: another verdict for %3 of %4"),
                                    task, cost.fidelity, cost.verdicts, cost.attempts);
            text = cost.metric.empty() ? Sentence("%1 %2.", text, verdicts)
                                       : Sentence("%1 %2, %3 %4 %.", text, verdicts,
                                                  cost.metric + (cost.hand.empty() ? "" : " " + cost.hand),
                                                  three_digits(cost.shift_percent, true));
        }
    }
    if (!earlier.empty())
        text =
            Sentence("%1 %2", text,
                     Sentence(QT_TRANSLATE_NOOP("commands",
                                                "Measured with an earlier version of the simulation or the "
                                                "metrics: %1."),
                              earlier));
    return {"%1 %2", text,
            QT_TRANSLATE_NOOP("commands", "Every other fidelity gives the same score as the finest one.")};
}

int run_perform(const Arguments& arguments) {
    arguments.exclude("--operator", "--input");
    const std::string fidelity = arguments.value_or("--fidelity", "");
    const Curriculum curriculum = installed_curriculum();
    const TaskRequest wanted{arguments.words()[0], arguments.value_or("--variant", ""), fidelity};
    LoadedTask loaded = load_task_and_scene(wanted);  // errors are reported before a store is created
    const auto seed = static_cast<std::uint64_t>(arguments.integer("--seed", 1, 0, 4000LL * 1'000'000));
    std::optional<OperatorLevel> level;  // none: a trace
    if (!arguments.has("--input")) level = operator_level(arguments.value_or("--operator", "expert"));
    const DeviceClass device_class = class_of(arguments, level);
    if (!arguments.has("--practice")) require_assessable(loaded.task, device_class);
    AttemptRecord input;
    std::shared_ptr<Rig> rig;
    if (arguments.has("--input")) {
        input.inputs = inputs_from_csv(*arguments.value("--input"), loaded.scene);
        rig = std::make_shared<TraceRig>(input.inputs);
    } else {
        // An unknown name is refused before anything is stored.
        rig = through_device(make_operator(*level, loaded.task, loaded.scene, seed), device_class,
                             loaded.scene, seed);
    }
    const database::Store store = open_store(arguments, true);
    const database::Session session = store.station_session();
    score_interrupted(store.path(), session);  // attempts of a run that was killed
    loaded = load_site_task(store, session, wanted);
    if (level)
        rig = through_device(make_operator(*level, loaded.task, loaded.scene, seed), device_class,
                             loaded.scene, seed);
    const database::Person person = subject(arguments, store, session, level, seed);

    const Limits limits = limits_for(loaded.task, loaded.scene, device_class);
    database::AttemptMeta meta = attempt_meta(
        loaded, seed, arguments.has("--practice") ? AttemptMode::practice : AttemptMode::assessed,
        device_class, level ? "synthetic operator" : "trace file", limits);
    const std::vector<database::AssetFile> unknown = database::AcceptedAssets(store).unknown(meta.assets);
    if (meta.mode == AttemptMode::assessed && !unknown.empty()) {
        meta.mode = AttemptMode::practice;
        std::cerr << "fulcrum: " << line_of(database::practice_only_words(unknown)) << '\n';
    }
    if (meta.mode == AttemptMode::assessed)
        database::require_assessed(store, session, person.id, curriculum, loaded.task, device_class);
    meta.person_id = person.id;
    meta.curriculum = database::Curricula(store).in_force(session, person.id, curriculum).name();
    if (level) meta.operator_name = row_of(operator_levels, *level).name;

    Result result;
    std::string attempt_id;
    if (arguments.has("--realtime")) {
        result = perform_on_the_clock(loaded, rig, store, session, meta, limits, attempt_id);
    } else {
        database::Recorder recorder(store.path(), session, meta);
        attempt_id = recorder.attempt_id();
        PerformRequest request;
        request.loaded = loaded;
        request.operator_level = level;
        request.input_trace = level ? nullptr : &input;
        request.seed = seed;
        request.device_class = device_class;
        FrameStore frames;
        request.frames = &frames;
        const Performed performed = perform(request, &recorder, limits);
        keep_frames(frame_keeping(store.path(), session, attempt_id), frames, performed.record);
        result.scored = performed.scored;
        result.state_hash = performed.outcome.state_hash;
        result.wall_s = performed.wall_s;
        result.events = performed.record.events.size();
    }
    const nlohmann::json document = to_json(meta, attempt_id, person, result);
    if (arguments.has("--json")) {
        print_json(document);
    } else {
        print_summary(document);
        if (arguments.has("--fidelity")) std::cout << "  fidelity " << cost_text(loaded.task.id, fidelity);
    }
    return 0;
}

}  // namespace

Command perform_command() {
    return {
        "perform",
        "TASK",
        1,
        1,
        QT_TRANSLATE_NOOP("commands", "Runs one attempt without a window, stores it and scores it."),
        {{"--operator",
          "NAME",
          QT_TRANSLATE_NOOP("commands", "The synthetic operator that performs."),
          "expert",
          {"novice", "intermediate", "expert"}},
         {"--input", "TRACE.csv",
          QT_TRANSLATE_NOOP("commands", "Perform the movements of a trace instead of those of an operator.")},
         seed_option(),
         variant_option(),
         {"--person", "LOGIN",
          QT_TRANSLATE_NOOP(
              "commands",
              "The synthetic or external person to whom the attempt belongs; created if missing."),
          QT_TRANSLATE_NOOP("commands", "one person for each operator and seed")},
         {"--device-class", "CLASS",
          QT_TRANSLATE_NOOP("commands",
                            "The device that a trace was made with, or that an operator is to work through. "
                            "A class that the task does not name is practice only."),
          QT_TRANSLATE_NOOP("commands", "synthetic for an operator, external for a trace"),
          device_class_names()},
         {"--practice", "",
          QT_TRANSLATE_NOOP("commands", "Perform in practice mode: measured, but not assessed.")},
         {"--fidelity", "LEVEL", QT_TRANSLATE_NOOP("commands", "The level of detail of the models."),
          QT_TRANSLATE_NOOP("commands", "the scene's own"), fidelity_names()},
         {"--realtime", "",
          QT_TRANSLATE_NOOP(
              "commands", "Run in real time with the threads of the window instead of as fast as possible.")},
         store_option(),
         json_option()},
        run_perform,
        false,
        costs_text()};
}

}  // namespace fulcrum::app
