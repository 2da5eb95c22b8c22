// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum metrics, fulcrum check: read files that people and other programs write.
#include <array>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/attempt_document.h"
#include "app/cli/commands.h"
#include "app/cli/installed_curriculum.h"
#include "app/live/performance.h"
#include "assessment/assets/assets.h"
#include "assessment/curriculum/rating_rule.h"
#include "assessment/forms/observer_form.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/scoring/benchmark.h"
#include "assessment/scoring/score.h"
#include "assessment/trace/trace_csv.h"
#include "assessment/trace/trace_mapping.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::app {

namespace {

constexpr std::size_t standard_input_limit = std::size_t{1} << 30U;  // bytes

/// All of standard input, for a file named "-".
std::string read_standard_input() {
    std::string text;
    std::array<char, 65536> part{};
    while (std::cin.read(part.data(), part.size()) || std::cin.gcount() > 0) {
        text.append(part.data(), static_cast<std::size_t>(std::cin.gcount()));
        if (text.size() > standard_input_limit)
            throw InputError(QT_TRANSLATE_NOOP("errors", "standard input"), "",
                             QT_TRANSLATE_NOOP("errors", "is larger than 1 GiB"),
                             QT_TRANSLATE_NOOP("errors", "give a smaller input"));
    }
    return text;
}

/// The trace named on the command line; `left_out`: samples without a value, of a mapped one.
Trace read_trace(const Arguments& arguments, std::size_t& left_out) {
    const std::string& path = arguments.words()[0];
    if (const auto file = arguments.value("--mapping")) {
        const TraceMapping mapping = load_trace_mapping(*file);
        MappedTrace mapped = path == "-" ? read_mapped_trace(std::cin, "standard input", mapping)
                                         : read_mapped_trace(path, mapping);
        left_out = mapped.left_out;
        return std::move(mapped.trace);
    }
    return path == "-" ? read_trace_csv(std::cin, "standard input") : read_trace_csv(path);
}

/// What was not read, not joined, or replaced in the trace, on standard error.
void print_notes(const nlohmann::json& document) {
    for (const auto& column : document["ignored_columns"])
        print_note({QT_TRANSLATE_NOOP("commands", "note: the column %1 is not known and was not read"),
                    column.get<std::string>()});
    for (const auto& gap : document["gaps"]) print_gap(gap[0].dump(), gap[1].dump());
    if (document["samples_left_out"] != 0)
        print_note({QT_TRANSLATE_NOOP("commands", "note: %1 samples have a missing value and were left out"),
                    document["samples_left_out"].dump()});
    if (document["replaced_force_samples"] != 0)
        print_note({QT_TRANSLATE_NOOP("commands", "note: %1 force samples were spikes and were replaced"),
                    document["replaced_force_samples"].dump()});
}

/// The verdict from a trace with its events.
nlohmann::json verdict(const Arguments& arguments) {
    if (!arguments.has("--task"))
        throw UsageError("--events", QT_TRANSLATE_NOOP("errors", "needs the task that was performed"),
                         QT_TRANSLATE_NOOP("errors", "name it: --task TASK"));
    const LoadedTask loaded =
        load_task_and_scene(TaskRequest{*arguments.value("--task"), arguments.value_or("--variant", ""),
                                        arguments.value_or("--fidelity", "")});
    std::size_t left_out = 0;  // none of a trace without a mapping
    return score_of_trace(read_trace(arguments, left_out), *arguments.value("--events"), loaded,
                          find_row(device_classes, arguments.value_or("--device-class", "haptic"))->kind);
}

void print_verdict(const nlohmann::json& document) {
    const nlohmann::json& passed = document["passed"];
    std::cout << (passed.is_null()     ? "not scored: " + document["not_scored_because"].get<std::string>()
                  : passed.get<bool>() ? std::string("passed")
                                       : std::string("failed"));
    if (!document["points"].is_null()) std::cout << ", points " << document["points"].dump();
    std::cout << '\n';
    for (const auto& gate : document["gates"])
        std::cout << "gate " << gate["metric"].get<std::string>() << ": " << gate["value"].dump() << " limit "
                  << gate["limit"].dump() << " passed " << gate["passed"].dump() << '\n';
    if (!document["pathology"].is_null())
        std::cout << "pathology: grade " << document["pathology"]["tme_grade"].dump() << ' '
                  << document["pathology"]["grade_reasons"].dump() << '\n';
}

int run_metrics(const Arguments& arguments) {
    if (arguments.has("--events")) {
        if (arguments.has("--mapping"))
            throw UsageError("--mapping", QT_TRANSLATE_NOOP("errors", "cannot be used with --events"),
                             QT_TRANSLATE_NOOP("errors", "a verdict needs a trace in the documented format"));
        const nlohmann::json document = verdict(arguments);
        if (arguments.has("--json")) {
            print_json(document);
        } else {
            print_verdict(document);
        }
        return 0;
    }
    for (const char* option : {"--device-class", "--fidelity", "--variant"})
        if (arguments.has(option))
            throw UsageError(option, QT_TRANSLATE_NOOP("errors", "has no meaning without --events"),
                             QT_TRANSLATE_NOOP("errors", "name the events: --events EVENTS.csv"));
    std::optional<MetricContext> context;
    if (const auto task = arguments.value("--task")) {
        const LoadedTask loaded = load_task_and_scene(*task);
        context = make_metric_context(loaded.scene, loaded.task, {});
        context->events_recorded = false;
    }
    std::size_t left_out = 0;
    const Trace trace = read_trace(arguments, left_out);
    nlohmann::json document = metrics_of_trace(trace, arguments.words()[0], context);
    document["samples_left_out"] = left_out;
    if (arguments.has("--json")) {
        print_json(document);
        return 0;
    }
    print_notes(document);
    for (const auto& row : document["metrics"]) {
        const std::string hand = row["hand"].is_null() ? "" : row["hand"].get<std::string>();
        const std::string tissue = row["tissue"].is_null() ? "" : row["tissue"].get<std::string>();
        std::cout << row["id"].get<std::string>() << ' ' << hand << ' ' << tissue << ": ";
        if (row["value"].is_null()) {
            std::cout << "absent, " << row["absent_because"].get<std::string>() << '\n';
        } else {
            std::cout << row["value"].dump() << ' ' << row["unit"].get<std::string>() << '\n';
        }
    }
    return 0;
}

/// Checks a file; returns its kind, determined from its content.
std::string check_curriculum(const std::string& text, const std::string& file) {
    Curriculum curriculum = parse_curriculum(text, file, task_ids());
    curriculum.file = file;
    check_rules(curriculum);
    check_ratings(curriculum, load_forms(asset_path("forms")));
    check_remedies(curriculum, all_installed_tasks());
    std::size_t remedies = 0;
    for (const CurriculumTask& task : curriculum.tasks) remedies += task.remedies.size();
    return "curriculum " + curriculum.name() +
           (remedies == 0 ? "" : ", remedies: " + std::to_string(remedies));
}

std::string check_text(const std::string& text, const std::string& file) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos || (text[first] != '{' && text[first] != '[')) {
        std::istringstream stream(text);
        return "trace, " + std::to_string(read_trace_csv(stream, file).t.size()) + " samples";
    }
    const nlohmann::json document = JsonDocument::parse(text, file).root();
    if (!document.is_object())
        throw InputError(file, "/", QT_TRANSLATE_NOOP("errors", "is not a JSON object"),
                         QT_TRANSLATE_NOOP("errors", "give a scene, task or benchmark file"));
    if (document.contains("goals") || document.contains("briefing")) {
        const TaskDefinition task = parse_task(text, file);
        check_gates(task, file);
        return "task " + task.id;
    }
    if (document.contains("levels") || document.contains("experts"))
        return "benchmark set of task " + parse_benchmark(text, file).task;
    if (document.contains("stages")) return check_curriculum(text, file);
    if (document.contains("columns")) return "mapping of traces, " + parse_trace_mapping(text, file).title;
    if (document.contains("items")) return "observer form " + parse_form(text, file).name();
    return "scene " + parse_scene(text, file).id;
}

std::string check_file(const std::string& path) {
    if (path == "-") return check_text(read_standard_input(), "standard input");
    if (std::filesystem::path(path).extension() == ".csv") {
        const Trace trace = read_trace_csv(path);
        return "trace, " + std::to_string(trace.t.size()) + " samples";
    }
    const nlohmann::json document = JsonDocument::load(path).root();
    if (!document.is_object())
        throw InputError(path, "/", QT_TRANSLATE_NOOP("errors", "is not a JSON object"),
                         QT_TRANSLATE_NOOP("errors", "give a scene, task or benchmark file"));
    if (document.contains("goals") || document.contains("briefing")) {
        const TaskDefinition task = load_task(path);
        check_gates(task, path);
        return "task " + task.id;
    }
    if (document.contains("levels") || document.contains("experts"))
        return "benchmark set of task " + load_benchmark(path).task;
    if (document.contains("stages")) return check_curriculum(read_text_file(path, JsonLimits().bytes), path);
    if (document.contains("columns")) return "mapping of traces, " + load_trace_mapping(path).title;
    if (document.contains("items")) return "observer form " + load_form(path).name();
    return "scene " + load_scene(path).id;
}

int run_check(const Arguments& arguments) {
    nlohmann::json files = nlohmann::json::array();
    bool ok = true;
    for (const std::string& path : arguments.words()) {
        try {
            const std::string kind = check_file(path);
            files.push_back({{"file", path}, {"ok", true}, {"is", kind}, {"problem", nullptr}});
            if (!arguments.has("--json")) std::cout << path << ": " << kind << ", valid\n";
        } catch (const InputError& error) {
            ok = false;
            files.push_back({{"file", path}, {"ok", false}, {"is", nullptr}, {"problem", error.what()}});
            std::cerr << "fulcrum: " << line_of(error) << '\n';
        }
    }
    if (arguments.has("--json")) print_json({{"ok", ok}, {"files", files}});
    return ok ? 0 : 2;
}

}  // namespace

Command metrics_command() {
    return {
        "metrics",
        "TRACE.csv",
        1,
        1,
        QT_TRANSLATE_NOOP("commands",
                          "Computes the metrics of a trace in the CSV format of docs/FORMATS.md; - reads "
                          "standard input. With its events it also gives gates, pathology and verdict."),
        {{"--mapping", "MAPPING.json",
          QT_TRANSLATE_NOOP("commands",
                            "The trace is of another program: which of its columns is which, and in which "
                            "unit. Examples are in assets/mappings.")},
         {"--task", "TASK",
          QT_TRANSLATE_NOOP(
              "commands", "The task that the trace belongs to; metrics that depend on its targets need it.")},
         {"--events", "EVENTS.csv", QT_TRANSLATE_NOOP("commands", "The attempt's events.")},
         {"--device-class", "CLASS",
          QT_TRANSLATE_NOOP("commands", "The class of the device; its limits are used."), "haptic",
          device_class_names()},
         variant_option(),
         {"--fidelity", "LEVEL",
          QT_TRANSLATE_NOOP("commands", "The fidelity of the simulation; its limits are used."),
          QT_TRANSLATE_NOOP("commands", "the scene's own"), fidelity_names()},
         json_option()},
        run_metrics};
}

Command check_command() {
    return {"check",
            "FILE...",
            1,
            10000,
            QT_TRANSLATE_NOOP("commands",
                              "Checks scenes, tasks, curricula, benchmark sets, observer forms, mappings and "
                              "traces; - reads standard input."),
            {json_option()},
            run_check};
}

}  // namespace fulcrum::app
