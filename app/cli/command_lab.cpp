// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum lab: the laboratory. Every figure is measured when asked for; --output writes the pages of
// docs/results.
#include <algorithm>
#include <charconv>
#include <iostream>

#include "app/cli/commands.h"
#include "app/lab/experiment.h"
#include "app/lab/measure.h"
#include "sim_core/lab/cut_figures.h"
#include "sim_core/lab/cut_strokes.h"
#include "sim_core/lab/size_sweep.h"
#include "sim_core/lab/stability.h"
#include "sim_core/lab/studies.h"
#include "sim_core/lab/validation.h"

namespace fulcrum::app {
namespace {

/// Prints the document, or writes the page; says on standard error where.
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

/// Called before the work, and after all that may be wrong with the command: a wrong one leaves no folder.
void make_output(const Arguments& arguments) {
    if (arguments.has("--output")) arguments.folder("--output", "");
}

int size_sweep(const Arguments& arguments) {
    if (arguments.has("--only"))
        throw UsageError("command line: --only: --sweep runs every model; leave --only or --sweep out");
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
    if (arguments.has("--only") && arguments.has("--output"))
        throw UsageError("command line: --only: a page holds every workload; leave --only or --output out");
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
    const std::vector<lab::ScoreSensitivity> sensitivity = measure_score_sensitivity();
    return deliver(arguments, lab::tradeoff_page(studies, sensitivity), lab::to_json(studies, sensitivity));
}

int cut(const Arguments& arguments) {
    make_output(arguments);
    const lab::ResultPage page = lab::cut_figures_page();
    return deliver(arguments, page, page.document());
}

/// As many as are named, or what the page of docs/results has.
int strokes(const Arguments& arguments) {
    int count = 100000;
    if (arguments.words().size() > 1) {
        const std::string& word = arguments.words()[1];
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
        if (error != std::errc() || end != word.data() + word.size() || count < 1 || count > 10000000)
            throw UsageError("command line: lab strokes: " + word + ": give a number from 1 to 10000000");
    }
    make_output(arguments);
    const lab::ResultPage page = lab::cut_strokes_page(count);
    return deliver(arguments, page, page.document());
}

/// One file, or every one of assets/experiments.
int experiment(const Arguments& arguments) {
    const auto folder = arguments.value("--output");
    if (!folder)
        throw UsageError("command line: lab experiment: --output: name the folder for pictures and pages; " +
                         arguments.usage());
    if (arguments.has("--json"))
        throw UsageError(
            "command line: --json: lab experiment writes its JSON beside the picture; leave it out");
    const std::vector<std::string> files =
        arguments.words().size() > 1 ? std::vector<std::string>{arguments.words()[1]} : experiment_files();
    make_output(arguments);
    for (const std::string& file : files) deliver(arguments, experiment_page(file), {});
    return 0;
}

}  // namespace

int command_lab(const std::vector<std::string>& words) {
    OptionSpec spec;
    spec.usage =
        "usage: fulcrum lab bench [--only NAME | --sweep] | cost | clock | validate | tradeoff | stability | "
        "cut | "
        "strokes [N] | experiment "
        "[FILE.json] | run STUDY.json "
        "[--json] "
        "[--output "
        "FOLDER]";
    spec.with_value = {"--only", "--output"};
    spec.flags = {"--json", "--sweep"};
    spec.minimum_words = 1;
    spec.maximum_words = 2;
    const Arguments arguments(words, spec);
    const std::string& action = arguments.words()[0];
    if (arguments.has("--sweep") && action != "bench")
        throw UsageError("command line: --sweep: only with lab bench; " + spec.usage);
    if (action == "run") {
        if (arguments.words().size() != 2)
            throw UsageError("command line: lab run: name a study file; " + spec.usage);
        if (arguments.has("--output"))
            throw UsageError("command line: --output: lab run prints its result; redirect it");
        print_json(lab::run_study(arguments.words()[1]));
        return 0;
    }
    if (action == "experiment") return experiment(arguments);
    if (action == "strokes") return strokes(arguments);
    if (arguments.words().size() != 1)
        throw UsageError("command line: " + arguments.words()[1] + ": not expected; " + spec.usage);
    if (action == "bench") return bench(arguments);
    if (action == "cost") return cost(arguments);
    if (action == "clock") return clock(arguments);
    if (action == "validate") return validate(arguments);
    if (action == "cut") return cut(arguments);
    if (action == "tradeoff") return tradeoff(arguments);
    if (action == "stability") return stability(arguments);
    throw UsageError("command line: lab " + action + ": no such action; " + spec.usage);
}

}  // namespace fulcrum::app
