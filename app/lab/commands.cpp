// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/commands.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/lab/demonstration.h"
#include "app/lab/experiment.h"
#include "app/lab/hapticd.h"
#include "app/lab/invariance.h"
#include "app/lab/learning_studies.h"
#include "app/lab/measure.h"
#include "app/lab/operators.h"
#include "app/lab/pages.h"
#include "app/lab/seek.h"
#include "app/lab/validity.h"
#include "assessment/assets/assets.h"
#include "assessment/metrics/version.h"
#include "sim_core/lab/cut_figures.h"
#include "sim_core/lab/cut_strokes.h"
#include "sim_core/lab/size_sweep.h"
#include "sim_core/lab/stability.h"
#include "sim_core/lab/studies.h"
#include "sim_core/lab/tradeoff.h"
#include "sim_core/lab/validation.h"

namespace fulcrum::app {

int deliver(const Arguments& arguments, const lab::ResultPage& page, nlohmann::json document) {
    const lab::Machine machine = lab::this_machine(lab::build_info());
    if (const auto folder = arguments.value("--output")) {
        for (const std::string& path : page.write(*folder, machine)) std::cerr << "wrote " << path << '\n';
    }
    if (arguments.has("--json")) {
        document["machine"] = lab::to_json(machine);
        print_json(document);
    } else if (!arguments.has("--output")) {
        std::cout << page.text(machine);
    }
    return 0;
}

void make_output(const Arguments& arguments) {
    if (arguments.has("--output")) arguments.folder("--output", "");
}

namespace {

int size_sweep(const Arguments& arguments) {
    arguments.exclude("--only", "--sweep");
    make_output(arguments);
    std::vector<lab::SizeSweep> sweeps;
    for (const lab::SweepCase& sweep : lab::size_sweeps()) {
        std::cerr << sweep.model << '\n';
        sweeps.push_back(lab::time_sweep(sweep));
    }
    return deliver(arguments, lab::size_sweep_page(sweeps), lab::to_json(sweeps));
}

int bench(const Arguments& arguments) {
    if (arguments.has("--sweep")) return size_sweep(arguments);
    arguments.exclude("--only", "--output");  // a page contains every workload
    make_output(arguments);
    const Measured measured = measure_workloads(arguments.value("--only"));
    return deliver(arguments, measured.page, measured.document);
}

int cost(const Arguments& arguments) {
    make_output(arguments);
    const Measured measured = measure_costs();
    return deliver(arguments, measured.page, measured.document);
}

int clock(const Arguments& arguments) {
    make_output(arguments);
    const Measured measured = measure_cut_clock();
    return deliver(arguments, measured.page, measured.document);
}

int validate(const Arguments& arguments) {
    make_output(arguments);
    const std::vector<lab::ValidationCase> cases = lab::validation_cases();
    deliver(arguments, lab::validation_page(cases), lab::to_json(cases));
    return std::all_of(cases.begin(), cases.end(), [](const lab::ValidationCase& c) { return c.passed; }) ? 0
                                                                                                          : 1;
}

int stability(const Arguments& arguments) {
    make_output(arguments);
    const std::vector<lab::StabilityMap> maps = lab::stability_maps();
    return deliver(arguments, lab::stability_page(maps), lab::to_json(maps));
}

int tradeoff(const Arguments& arguments) {
    make_output(arguments);
    const std::vector<lab::TradeoffStudy> studies = lab::tradeoff_studies();
    return deliver(arguments, lab::tradeoff_page(studies), lab::to_json(studies));
}

int cut(const Arguments& arguments) {
    make_output(arguments);
    const lab::ResultPage page = lab::cut_figures_page();
    return deliver(arguments, page, page.document());
}

int strokes(const Arguments& arguments) {
    int count = 100000;
    if (!arguments.words().empty()) {
        const std::string& word = arguments.words()[0];
        const auto number = parse_integer(word, 1, 10000000);
        if (!number)
            throw UsageError("lab strokes", "'" + word + "' is not a number of strokes",
                             "give a whole number from 1 to 10000000");
        count = static_cast<int>(*number);
    }
    make_output(arguments);
    const lab::ResultPage page = lab::cut_strokes_page(count);
    return deliver(arguments, page, page.document());
}

int operators(const Arguments& arguments) {
    const auto seeds = static_cast<int>(arguments.integer("--seeds", 20, 6, 1000));
    const auto replays = static_cast<int>(arguments.integer("--replays", 1, 0, 1000));
    const auto retests = static_cast<int>(arguments.integer("--retests", 0, 0, 1000));
    make_output(arguments);
    const Measured measured = measure_operators(arguments.words()[0], seeds, replays, retests);
    deliver(arguments, measured.page, measured.document);
    return measured.document["identical"] == measured.document["replayed"] ? 0 : 1;
}

int passes(const Arguments& arguments) {
    const auto seeds = static_cast<int>(arguments.integer("--seeds", 20, 6, 1000));
    make_output(arguments);
    const std::vector<std::string> tasks = arguments.words().empty() ? task_ids() : arguments.words();
    const Measured measured =
        arguments.has("--variants") ? measure_variant_passes(tasks, seeds) : measure_passes(tasks, seeds);
    return deliver(arguments, measured.page, measured.document);
}

int invariance(const Arguments& arguments) {
    make_output(arguments);
    const Measured measured = measure_invariance();
    return deliver(arguments, measured.page, measured.document);
}

int hapticd(const Arguments& arguments) {
    make_output(arguments);
    const auto seconds = static_cast<double>(arguments.integer("--seconds", 60, 1, 3600));
    const Measured measured = measure_hapticd(seconds);
    return deliver(arguments, measured.page, measured.document);
}

int seek(const Arguments& arguments) {
    const auto seconds = static_cast<double>(arguments.integer("--seconds", 600, 1, 3600));
    const int seeks = static_cast<int>(arguments.integer("--seeks", 200, 1, 100000));
    make_output(arguments);
    std::vector<std::string> tasks;
    if (arguments.words().empty()) {
        tasks = task_ids();
    } else {
        tasks = arguments.words();
        for (const std::string& task : tasks) task_file(task);  // throws where it is none
    }
    const Measured measured = measure_seeks(tasks, seconds, seeks);
    return deliver(arguments, measured.page, measured.document);
}

int validity(const Arguments& arguments) {
    make_output(arguments);
    const Measured measured = validity_page(arguments.words()[0]);
    return deliver(arguments, measured.page, measured.document);
}

int run_study(const Arguments& arguments) {
    print_json(lab::run_study(arguments.words()[0], learning_studies()));
    return 0;
}

/// The code of each command of laboratory_commands().
const std::map<std::string, std::function<int(const Arguments&)>>& code() {
    static const std::map<std::string, std::function<int(const Arguments&)>> code = {
        {"lab bench", bench},
        {"lab cost", cost},
        {"lab clock", clock},
        {"lab validate", validate},
        {"lab tradeoff", tradeoff},
        {"lab stability", stability},
        {"lab cut", cut},
        {"lab strokes", strokes},
        {"lab experiment", run_experiments},
        {"lab operators", operators},
        {"lab passes", passes},
        {"lab invariance", invariance},
        {"lab seek", seek},
        {"lab hapticd", hapticd},
        {"lab validity", validity},
        {"lab fidelity", run_fidelity},
        {"lab demonstration", run_demonstration},
        {"lab run", run_study}};
    return code;
}

}  // namespace

CommandTable laboratory_table() {
    std::vector<Command> commands = laboratory_commands();
    for (Command& command : commands) {
        const auto found = code().find(command.name);
        if (found == code().end())
            throw std::logic_error("app/lab/commands.cpp: no code for the command " + command.name);
        command.run = found->second;
        command.program.clear();
    }
    return CommandTable(std::move(commands), program_version);
}

}  // namespace fulcrum::app
