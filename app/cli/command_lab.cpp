// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum lab: the laboratory. Every value is measured when asked for; --output writes the pages of
// docs/results.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/laboratory.h"
#include "app/lab/measure.h"
#include "sim_core/lab/cut_figures.h"
#include "sim_core/lab/cut_strokes.h"
#include "sim_core/lab/size_sweep.h"
#include "sim_core/lab/stability.h"
#include "sim_core/lab/studies.h"
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
    const std::vector<lab::ScoreSensitivity> sensitivity = measure_score_sensitivity();
    return deliver(arguments, lab::tradeoff_page(studies, sensitivity), lab::to_json(studies, sensitivity));
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

int run_study(const Arguments& arguments) {
    print_json(lab::run_study(arguments.words()[0]));
    return 0;
}

}  // namespace

Option page_option() {
    return {"--output", "FOLDER", "Write the page with its tables and charts into this folder.",
            "",         {},       "-o"};
}

std::vector<Command> laboratory_commands() {
    const std::vector<Option> page = {page_option(), json_option()};
    return {{"lab bench", "", 0, 0, "Times the reference workloads and compares them with their budgets.",
             joined({{"--only", "NAME", "Time this workload only."},
                     {"--sweep", "", "Time every model over a range of sizes instead."}},
                    page),
             bench},
            {"lab cost", "", 0, 0, "Measures the time of each part of each scene.", page, cost},
            {"lab clock", "", 0, 0,
             "Measures ticks and steps in real time, with a cutting and a blunt blade.", page, clock},
            {"lab validate", "", 0, 0, "Compares every model with closed-form and reference solutions.", page,
             validate},
            {"lab tradeoff", "", 0, 0,
             "Measures error against time for each level of each model, and the effect on scores.", page,
             tradeoff},
            {"lab stability", "", 0, 0, "Maps the parameters for which each model stays bounded.", page,
             stability},
            {"lab cut", "", 0, 0, "Measures the cutting of surfaces.", page, cut},
            {"lab strokes", "[N]", 0, 1, "Cuts with N random strokes (100000) and checks every surface.",
             page, strokes},
            {"lab run",
             "STUDY.json",
             1,
             1,
             "Runs one model on given input and prints its full result.",
             {json_option()},
             run_study}};
}

}  // namespace fulcrum::app
