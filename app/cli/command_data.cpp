// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum metrics, check: files.
#include <filesystem>
#include <iostream>

#include "app/assets.h"
#include "app/cli/commands.h"
#include "app/live/performance.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/scoring/benchmark.h"
#include "assessment/scoring/score.h"
#include "assessment/trace/trace_csv.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::app {

int command_metrics(const std::vector<std::string>& words) {
    OptionSpec spec;
    spec.usage = "usage: fulcrum metrics TRACE.csv [--task TASK] [--json]";
    spec.with_value = {"--task"};
    spec.flags = {"--json"};
    spec.minimum_words = spec.maximum_words = 1;
    const Arguments arguments(words, spec);
    std::optional<MetricContext> context;
    if (const auto task = arguments.value("--task")) {
        const LoadedTask loaded = load_task_and_scene(*task);
        context = make_metric_context(loaded.scene, loaded.task, {});
        context->events_recorded = false;
    }
    const nlohmann::json document = metrics_of_csv(arguments.words()[0], context);
    if (arguments.has("--json")) {
        print_json(document);
        return 0;
    }
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

namespace {

/// What a file is, by its content; checks it and says so.
std::string check_file(const std::string& path) {
    if (std::filesystem::path(path).extension() == ".csv") {
        const Trace trace = read_trace_csv(path);
        return "trace, " + std::to_string(trace.t.size()) + " samples";
    }
    const nlohmann::json document = JsonDocument::load(path).root();
    if (!document.is_object())
        throw InputError(path, "/", "holds no JSON object", "give a scene, task or benchmark file");
    if (document.contains("goals") || document.contains("briefing")) {
        const TaskDefinition task = load_task(path);
        check_gates(task, path);
        return "task " + task.id;
    }
    if (document.contains("levels") || document.contains("experts"))
        return "benchmark set of task " + load_benchmark(path).task;
    return "scene " + load_scene(path).id;
}

}  // namespace

int command_check(const std::vector<std::string>& words) {
    OptionSpec spec;
    spec.usage = "usage: fulcrum check FILE... [--json]";
    spec.flags = {"--json"};
    spec.minimum_words = 1;
    spec.maximum_words = 10000;
    const Arguments arguments(words, spec);
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
            std::cerr << "fulcrum: " << error.what() << '\n';
        }
    }
    if (arguments.has("--json")) print_json({{"ok", ok}, {"files", files}});
    return ok ? 0 : 2;
}

}  // namespace fulcrum::app
