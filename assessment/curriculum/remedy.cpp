// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/remedy.h"

#include <algorithm>
#include <tuple>

#include "assessment/curriculum/curriculum.h"
#include "assessment/metrics/registry.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/nearest_name.h"

namespace fulcrum {
namespace {

bool is_among(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string list_of(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

/// "name … (did you mean B2?)" where a name is near; else the list of all.
Sentence hint_for(const std::string& name, const std::vector<std::string>& known) {
    const std::string near = nearest_name(name, known);
    if (!near.empty())
        return {QT_TRANSLATE_NOOP("errors", "did you mean %1? There are: %2"), near, list_of(known)};
    return {QT_TRANSLATE_NOOP("errors", "name one of these: %1"), list_of(known)};
}

RemedyProblem unknown_metric(const std::string& metric) {
    std::vector<std::string> known;
    for (const Metric& one : metric_registry()) known.push_back(one.descriptor.id);
    const std::string near = nearest_name(metric, known);
    Sentence hint =
        QT_TRANSLATE_NOOP("errors", "name the id of a metric that the task shows (docs/METRICS.md)");
    if (!near.empty())
        hint = {QT_TRANSLATE_NOOP("errors", "did you mean %1? docs/METRICS.md lists all metrics"), near};
    return {"metric", {QT_TRANSLATE_NOOP("errors", "there is no metric %1"), metric}, hint};
}

std::optional<RemedyProblem> wrong_target(const Remedy& remedy, const InstalledTask& own,
                                          const std::vector<InstalledTask>& tasks) {
    const InstalledTask* target = &own;
    if (remedy.kind == RemedyKind::practise_from) {
        if (!is_among(own.goals, remedy.goal))
            return RemedyProblem{"practise_from",
                                 {QT_TRANSLATE_NOOP("errors", "%1 has no goal %2"), own.id, remedy.goal},
                                 hint_for(remedy.goal, own.goals)};
        if (own.goals.front() == remedy.goal)
            return RemedyProblem{
                "practise_from",
                {QT_TRANSLATE_NOOP("errors", "%1 is the first goal of %2: from it on is the whole task"),
                 remedy.goal, own.id},
                QT_TRANSLATE_NOOP("errors", "name a later goal, or choose another remedy")};
    }
    if (remedy.kind == RemedyKind::other_task) {
        std::vector<std::string> others;
        for (const InstalledTask& one : tasks)
            if (one.id != own.id) others.push_back(one.id);
        if (remedy.task == own.id)
            return RemedyProblem{
                "task",
                {QT_TRANSLATE_NOOP("errors", "%1 is not a remedy for itself"), own.id},
                QT_TRANSLATE_NOOP("errors", "name another task, or only a variant of this one")};
        target = find_installed(tasks, remedy.task);
        if (target == nullptr)
            return RemedyProblem{"task",
                                 {QT_TRANSLATE_NOOP("errors", "no task %1 is installed"), remedy.task},
                                 hint_for(remedy.task, others)};
    }
    if (!remedy.variant.empty() && !is_among(target->variants, remedy.variant))
        return RemedyProblem{
            "variant",
            {QT_TRANSLATE_NOOP("errors", "%1 has no variant %2"), target->id, remedy.variant},
            hint_for(remedy.variant, target->variants)};
    if (remedy.kind == RemedyKind::ghost && !own.has_hands)
        return RemedyProblem{
            "feedback",
            {QT_TRANSLATE_NOOP("errors", "%1 has no ghost: it is for the scope alone"), own.id},
            QT_TRANSLATE_NOOP("errors", "write demonstration or replay")};
    return {};
}

}  // namespace

bool operator==(const Remedy& a, const Remedy& b) {
    const auto all = [](const Remedy& one) {
        return std::tie(one.metric, one.above, one.bound, one.unit, one.kind, one.goal, one.task,
                        one.variant);
    };
    return all(a) == all(b);
}

const char* feedback_name(RemedyKind kind) {
    switch (kind) {
        case RemedyKind::ghost:
            return "ghost";
        case RemedyKind::demonstration:
            return "demonstration";
        case RemedyKind::replay:
            return "replay";
        default:
            return "";
    }
}

std::optional<RemedyKind> feedback_named(const std::string& name) {
    for (const RemedyKind kind : {RemedyKind::ghost, RemedyKind::demonstration, RemedyKind::replay})
        if (name == feedback_name(kind)) return kind;
    return {};
}

std::optional<RemedyProblem> problem_of(const Remedy& remedy) {
    const MetricDescriptor* metric = find_metric(remedy.metric);
    if (metric == nullptr) return unknown_metric(remedy.metric);
    if (remedy.unit != metric->unit)
        return RemedyProblem{
            "unit",
            {QT_TRANSLATE_NOOP("errors", "%1 is not measured in '%2'"), remedy.metric, remedy.unit},
            {QT_TRANSLATE_NOOP("errors", "write its unit, \"%1\", and the bound in this unit"),
             metric->unit}};
    if (metric->direction == (remedy.above ? Direction::higher : Direction::lower))
        return RemedyProblem{
            remedy.above ? "above" : "below",
            {QT_TRANSLATE_NOOP("errors", "the bound of %1 is on the good side"), remedy.metric},
            remedy.above ? Sentence(QT_TRANSLATE_NOOP("errors", "a high value is good: write \"below\""))
                         : Sentence(QT_TRANSLATE_NOOP("errors", "a low value is good: write \"above\""))};
    return {};
}

std::optional<RemedyProblem> problem_of(const Remedy& remedy, const std::string& task,
                                        const std::vector<InstalledTask>& tasks) {
    if (auto problem = problem_of(remedy)) return problem;
    const InstalledTask* own = find_installed(tasks, task);
    if (own == nullptr) return {};  // said of the task itself
    if (!is_among(own->metrics, remedy.metric))
        return RemedyProblem{
            "metric",
            {QT_TRANSLATE_NOOP("errors", "%1 does not show the metric %2"), task, remedy.metric},
            hint_for(remedy.metric, own->metrics)};
    return wrong_target(remedy, *own, tasks);
}

void check_remedies(const Curriculum& curriculum, const std::vector<InstalledTask>& tasks) {
    for (std::size_t i = 0; i < curriculum.tasks.size(); ++i) {
        const CurriculumTask& task = curriculum.tasks[i];
        for (std::size_t k = 0; k < task.remedies.size(); ++k)
            if (const auto found = problem_of(task.remedies[k], task.task, tasks))
                throw InputError(
                    curriculum.file.empty() ? curriculum.name() : curriculum.file,
                    "/tasks/" + std::to_string(i) + "/remedies/" + std::to_string(k) + "/" + found->key,
                    found->problem, found->hint);
    }
    for (const Curriculum& one : curriculum.older) check_remedies(one, tasks);
}

}  // namespace fulcrum
