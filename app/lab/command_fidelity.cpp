// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum lab fidelity: what each fidelity costs in processor time and in score.
#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/lab/fidelity_page.h"
#include "app/lab/pages.h"
#include "assessment/assets/assets.h"
#include "sim_core/numerics/files.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::app {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

/// The first interrupt ends the study with the seeds that are complete, the second one the program.
void note_interrupt(int number) {
    interrupted = true;
    std::signal(number, SIG_DFL);
}

std::vector<std::string> tasks_of(const Arguments& arguments) {
    const std::vector<std::string> known = task_ids();
    if (!arguments.has("--tasks")) return known;
    std::vector<std::string> tasks;
    std::string id;
    for (const char c : *arguments.value("--tasks") + ",") {
        if (c != ',') {
            id += c;
            continue;
        }
        task_file(id);  // throws for an unknown one
        if (std::find(tasks.begin(), tasks.end(), id) != tasks.end())
            throw UsageError("--tasks", "names " + id + " twice", "name each task once");
        tasks.push_back(id);
        id.clear();
    }
    return tasks;
}

FidelityStudy stored_study(const std::string& path) {
    constexpr std::size_t largest = std::size_t{1} << 28U;
    const std::string text = read_text_file(path, largest);
    nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
    return fidelity_study_of(document, path);
}

FidelityStudy new_study(const Arguments& arguments) {
    FidelityStudyRequest request;
    request.tasks = tasks_of(arguments);
    request.seeds = static_cast<int>(arguments.integer("--seeds", default_fidelity_seeds, 2, 100000));
    request.commit = lab::build_info().commit;
    request.keep_going = [] { return !interrupted; };
    request.on_attempt = [](const std::string& line) { std::cerr << line << '\n'; };
    const auto before = std::signal(SIGINT, note_interrupt),
               terminated = std::signal(SIGTERM, note_interrupt);
    FidelityStudy study = run_fidelity_study(request);
    std::signal(SIGINT, before);
    std::signal(SIGTERM, terminated);
    return study;
}

/// What `--tasks` leaves in the file as it is: the other tasks, with what each was measured with. Throws
/// InputError for a file of another kind.
FidelityCosts costs_to_keep(const Arguments& arguments, const std::string& file) {
    if (!arguments.has("--tasks") || !std::filesystem::exists(file)) return {};
    return parse_fidelity_costs(read_text_file(file, JsonLimits().bytes), file);
}

}  // namespace

int run_fidelity(const Arguments& arguments) {
    for (const char* option : {"--seeds", "--tasks"}) arguments.exclude("--from", option);
    const std::optional<std::string> data = arguments.value("--data");
    if (data) require_writable_file(*data);
    FidelityCosts costs = data ? costs_to_keep(arguments, *data) : FidelityCosts();
    make_output(arguments);
    const auto from = arguments.value("--from");
    const FidelityStudy study = from ? stored_study(*from) : new_study(arguments);
    const std::vector<TaskAnswer> answers = fidelity_answers(study);
    if (answers.empty())
        throw InputError(from.value_or("lab fidelity"), "", "no task has 2 complete seeds",
                         "let the command run longer");
    if (data) {
        for (const auto& [task, cost] : costs_of(answers, study).tasks) costs.tasks[task] = cost;
        write_whole_file(*data, fidelity_costs_to_json(costs).dump(1) + "\n");
    }
    const lab::ResultPage page = fidelity_page(study, answers);
    deliver(arguments, page, page.document());
    if (interrupted) std::cerr << "stopped: the page has the seeds that were complete\n";
    return interrupted ? 1 : 0;
}

}  // namespace fulcrum::app
