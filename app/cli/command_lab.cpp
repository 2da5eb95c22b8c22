// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum lab: the table of the laboratory's commands, so that help, completion and manual have them. Their
// code is in app/lab, in the program fulcrum-lab.
#include "app/cli/commands.h"

namespace fulcrum::app {
namespace {

Option page_option() {
    return {"--output", "FOLDER", "Write the page with its tables and charts into this folder.",
            "",         {},       "-o"};
}

Command demonstration_row() {
    return {"lab demonstration",
            "",
            0,
            0,
            "Simulates a programme, as Look around opens it: 24 trainees in 12 weeks, or as many as wanted.",
            {{"--output", "FILE", "The packed programme.", "demonstration.db.zst", {}, "-o"},
             {"--trainees", "N", "So many trainees: 1 to 200, the first 24 with names.", "24"},
             {"--weeks", "N", "The last N weeks of the plan only.", "12"},
             {"--attempts", "N",
              "So many attempts of each trainee (1 to 600), spread over the days on which the trainee is "
              "there.",
              "as each kind of trainee practises"},
             {"--seed", "N", "Other individuals and other attempts: 0 to 1000.", "0"},
             json_option()},
            {},
            false,
            "Takes 15 to 60 minutes on one core. An interrupt (Ctrl-C) stops it; the same command resumes "
            "with the "
            "day "
            "that was not finished, from the folder FILE.work. The programme that is delivered is "
            "assets/demonstration/programme.db.zst; build the program again after it was replaced."};
}

}  // namespace

std::vector<Command> laboratory_commands() {
    const std::vector<Option> page = {page_option(), json_option()};
    std::vector<Command> commands = {
        {"lab bench", "", 0, 0, "Times the reference workloads and compares them with their budgets.",
         joined({{"--only", "NAME", "Time this workload only."},
                 {"--sweep", "", "Time every model over a range of sizes instead."}},
                page)},
        {"lab cost", "", 0, 0, "Measures the time of each part of each scene.", page},
        {"lab clock", "", 0, 0, "Measures ticks and steps in real time, with a cutting and a blunt blade.",
         page},
        {"lab validate", "", 0, 0, "Compares every model with closed-form and reference solutions.", page},
        {"lab tradeoff", "", 0, 0, "Measures error against time for each level of each model.", page},
        {"lab fidelity",
         "",
         0,
         0,
         "Finds the cheapest fidelity of each task that leaves the score as it is.",
         joined({{"--seeds", "N", "Seeds for each task.", std::to_string(default_fidelity_seeds)},
                 {"--tasks", "TASK,TASK,...", "These tasks only.", "all"},
                 {"--data", "FILE",
                  "Write what briefings and help say: assets/fidelity_cost.json. With --tasks the others "
                  "stay in it."},
                 {"--from", "FILE", "Make the page again from a fidelity_score.json, without attempts."}},
                page),
         {},
         false,
         "Synthetic operators perform each task at every fidelity, and the input that they gave at standard "
         "is replayed at every fidelity. An interrupt (Ctrl-C) ends it with the seeds that are complete."},
        demonstration_row(),
        {"lab stability", "", 0, 0, "Maps the parameters for which each model stays bounded.", page},
        {"lab cut", "", 0, 0, "Measures the cutting of surfaces.", page},
        {"lab strokes", "[N]", 0, 1, "Cuts with N random strokes (100000) and checks every surface.", page},
        {"lab operators", "TASK", 1, 1,
         "Measures how well each metric separates synthetic experts from novices, and whom each gate fails.",
         joined({{"--seeds", "N", "Attempts of each preset: 6 to 1000 (20)."},
                 {"--replays", "N", "Attempts of each preset that are also replayed (1)."},
                 {"--retests", "N", "Individuals of each preset that make a second attempt (0)."}},
                page)},
        {"lab passes", "[TASK...]", 0, 20,
         "Counts which synthetic operators pass each task with each class of devices.",
         joined({{"--seeds", "N", "Attempts of each preset: 6 to 1000 (20)."},
                 {"--variants", "", "Each variant of each task instead."}},
                page)},
        {"lab invariance", "", 0, 0,
         "Measures what metrics make of the same attempts recorded otherwise: turned, later, at half the "
         "rate, with noise.",
         page},
        {"lab seek", "[TASK...]", 0, 20,
         "Measures seeks to random moments of a replay of every task, or of these, taking over from it, and "
         "the "
         "ghost.",
         joined({{"--seconds", "S", "Length of the attempt: 1 to 3600.", "600"},
                 {"--seeks", "N", "Seeks for each task: 1 to 100000.", "200"}},
                page)},
        {"lab hapticd", "", 0, 0,
         "Measures the delay and jitter that fulcrum-hapticd adds, idle and next to busy threads.",
         joined({{"--seconds", "S", "For each load: 1 to 3600.", "60"}}, page)},
        {"lab validity", "FOLDER", 1, 1,
         "Writes what each metric and gate is worth, from the results (JSON or pages) of lab operators and "
         "lab invariance in a folder.",
         page},
        {"lab run",
         "STUDY.json",
         1,
         1,
         "Runs one model on given input and prints its full result.",
         {json_option()}},
        {"lab experiment",
         "[FILE.json]",
         0,
         1,
         "Runs one experiment, or all of assets/experiments, and draws its pictures.",
         {page_option()},
         {},
         true}};
    for (Command& command : commands) command.program = "fulcrum-lab";
    return commands;
}

}  // namespace fulcrum::app
