// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/curriculum_draft.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr std::size_t longest_title = 120, longest_stage_title = 60, longest_stage_id = 8, most_stages = 12,
                      most_tasks = 60, most_remedies = 12;

bool is_blank(const std::string& text) {
    return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

/// Characters, not bytes.
std::size_t length_of(const std::string& utf8) {
    return static_cast<std::size_t>(std::count_if(
        utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Looks through a draft and collects what is wrong.
class DraftCheck {
  public:
    DraftCheck(const Curriculum& draft, const std::vector<InstalledTask>& tasks,
               const std::vector<ObserverForm>& forms)
        : draft_(draft), tasks_(tasks), forms_(forms) {}

    std::vector<CurriculumProblem> run() {
        check_title();
        check_stages();
        for (std::size_t i = 0; i < draft_.tasks.size(); ++i) {
            check_task(i);
            check_after(i);
            check_devices(i);
            check_rated(i);
            check_remedied(i);
        }
        return std::move(found_);
    }

  private:
    void add(CurriculumField field, std::size_t index, const Sentence& problem, const Sentence& hint,
             bool blocks = true) {
        found_.push_back({field, index, problem, hint, blocks});
    }
    const InstalledTask* installed(const std::string& id) const { return find_installed(tasks_, id); }
    /// Place of a stage in their order; their number where it is not there.
    std::size_t rank_of(const std::string& stage) const {
        return static_cast<std::size_t>(
            std::find_if(draft_.stages.begin(), draft_.stages.end(),
                         [&](const CurriculumStage& one) { return one.id == stage; }) -
            draft_.stages.begin());
    }

    void check_title() {
        if (is_blank(draft_.title) || length_of(draft_.title) > longest_title)
            add(CurriculumField::title, 0, QT_TRANSLATE_NOOP("errors", "the title is missing or too long"),
                QT_TRANSLATE_NOOP("errors", "give a title of 1 to 120 characters"));
        if (draft_.tasks.empty())
            add(CurriculumField::title, 0, QT_TRANSLATE_NOOP("errors", "the curriculum has no task"),
                QT_TRANSLATE_NOOP("errors", "add one"));
        if (draft_.stages.empty())
            add(CurriculumField::title, 0, QT_TRANSLATE_NOOP("errors", "the curriculum has no stage"),
                QT_TRANSLATE_NOOP("errors", "add one"));
        if (draft_.tasks.size() > most_tasks || draft_.stages.size() > most_stages)
            add(CurriculumField::title, 0, QT_TRANSLATE_NOOP("errors", "the curriculum is too large"),
                QT_TRANSLATE_NOOP("errors", "keep it to 12 stages and 60 tasks"));
    }

    void check_stages() {
        std::set<std::string> seen;
        for (std::size_t i = 0; i < draft_.stages.size(); ++i) {
            const CurriculumStage& stage = draft_.stages[i];
            if (is_blank(stage.id) || length_of(stage.id) > longest_stage_id)
                add(CurriculumField::stages, i,
                    QT_TRANSLATE_NOOP("errors", "the stage has no short name, or a long one"),
                    QT_TRANSLATE_NOOP("errors", "give a short name of 1 to 8 characters, such as A"));
            else if (!seen.insert(stage.id).second)
                add(CurriculumField::stages, i,
                    {QT_TRANSLATE_NOOP("errors", "stage %1 is listed twice"), stage.id},
                    QT_TRANSLATE_NOOP("errors", "give every stage its own id"));
            if (is_blank(stage.title) || length_of(stage.title) > longest_stage_title)
                add(CurriculumField::stages, i,
                    {QT_TRANSLATE_NOOP("errors", "the title of stage %1 is missing or too long"), stage.id},
                    QT_TRANSLATE_NOOP("errors", "give a title of 1 to 60 characters"));
            const bool used = std::any_of(draft_.tasks.begin(), draft_.tasks.end(),
                                          [&](const CurriculumTask& task) { return task.stage == stage.id; });
            if (!used)
                add(CurriculumField::stages, i,
                    {QT_TRANSLATE_NOOP("errors", "stage %1 has no task"), stage.id},
                    QT_TRANSLATE_NOOP("errors", "move a task to it, or remove it"), false);
        }
    }

    void check_task(std::size_t i) {
        const CurriculumTask& task = draft_.tasks[i];
        const InstalledTask* known = installed(task.task);
        if (known == nullptr)
            add(CurriculumField::task, i, {QT_TRANSLATE_NOOP("errors", "no task %1 is installed"), task.task},
                QT_TRANSLATE_NOOP("errors", "remove it, or have its file installed first"));
        for (std::size_t k = 0; k < i; ++k)
            if (draft_.tasks[k].task == task.task)
                add(CurriculumField::task, i, {QT_TRANSLATE_NOOP("errors", "%1 is listed twice"), task.task},
                    QT_TRANSLATE_NOOP("errors", "list every task once"));
        if (draft_.find_stage(task.stage) == nullptr)
            add(CurriculumField::stage, i, {QT_TRANSLATE_NOOP("errors", "there is no stage %1"), task.stage},
                QT_TRANSLATE_NOOP("errors", "choose one of the stages, or add it"));
        try {
            parse_pass_rule(pass_rule_text(task.rule));
        } catch (const InputError& error) {
            add(CurriculumField::rule, i, error.problem_sentence(), error.hint_sentence());
        }
        if (const auto never = why_never_met(task.rule, task.variants))
            add(CurriculumField::rule, i, never->problem, never->hint);
        const int variants = known == nullptr ? 0 : static_cast<int>(known->variants.size());
        if (known != nullptr && task.variants > variants)
            add(CurriculumField::variants, i,
                {QT_TRANSLATE_NOOP("errors", "asks for passes on %1 variants, but %2 has %3"), task.variants,
                 task.task, variants},
                QT_TRANSLATE_NOOP("errors", "ask for fewer, or the rule is never met"));
    }

    void check_after(std::size_t i) {
        const CurriculumTask& task = draft_.tasks[i];
        for (const std::string& before : task.after) {
            const CurriculumTask* other = draft_.find(before);
            if (other == nullptr)
                add(CurriculumField::after, i,
                    {QT_TRANSLATE_NOOP("errors", "%1 is not a task of this curriculum"), before},
                    QT_TRANSLATE_NOOP("errors", "add it, or take it out of the prerequisites"));
            else if (rank_of(other->stage) > rank_of(task.stage))
                add(CurriculumField::after, i,
                    {QT_TRANSLATE_NOOP("errors", "%1 belongs to a later stage than %2"), before, task.task},
                    QT_TRANSLATE_NOOP("errors", "name tasks of the same or an earlier stage"));
        }
        std::set<std::string> seen;
        if (comes_after_itself(task.task, task, seen))
            add(CurriculumField::after, i,
                {QT_TRANSLATE_NOOP("errors", "%1 would unlock only after itself"), task.task},
                {QT_TRANSLATE_NOOP("errors", "remove one of the prerequisites on the way back to %1"),
                 task.task});
    }

    bool comes_after_itself(const std::string& wanted, const CurriculumTask& from,
                            std::set<std::string>& seen) const {
        return std::any_of(from.after.begin(), from.after.end(), [&](const std::string& before) {
            if (before == wanted) return true;
            const CurriculumTask* next = draft_.find(before);
            return next != nullptr && seen.insert(before).second && comes_after_itself(wanted, *next, seen);
        });
    }

    void check_devices(std::size_t i) {
        const CurriculumTask& task = draft_.tasks[i];
        if (task.device_classes.empty()) {
            add(CurriculumField::devices, i, QT_TRANSLATE_NOOP("errors", "no class of devices is chosen"),
                QT_TRANSLATE_NOOP("errors", "choose at least one, or no attempt counts"));
            return;
        }
        const InstalledTask* known = installed(task.task);
        if (known == nullptr || !known->needs_limits) return;
        std::size_t without = 0;
        for (const DeviceClass used : task.device_classes) {
            const auto& with = known->with_limits;
            if (std::find(with.begin(), with.end(), used) != with.end()) continue;
            ++without;
            add(CurriculumField::devices, i,
                {QT_TRANSLATE_NOOP("errors", "%1 has no benchmark for the class of devices %2"), task.task,
                 std::string(row_of(device_classes, used).name)},
                QT_TRANSLATE_NOOP(
                    "errors",
                    "gates based on the experts' range are not judged with it until a set is installed"),
                false);
        }
        if (without == task.device_classes.size()) found_.back().blocks = true;
    }

    void check_rated(std::size_t i) {
        if (!draft_.tasks[i].ratings) return;
        Curriculum alone;
        alone.id = draft_.id;
        alone.tasks = {draft_.tasks[i]};
        try {
            check_ratings(alone, forms_);
        } catch (const InputError& error) {
            add(CurriculumField::ratings, i, error.problem_sentence(), error.hint_sentence());
        }
    }

    void check_remedied(std::size_t i) {
        const CurriculumTask& task = draft_.tasks[i];
        if (task.remedies.size() > most_remedies)
            add(CurriculumField::remedies, i, QT_TRANSLATE_NOOP("errors", "the task has too many remedies"),
                {QT_TRANSLATE_NOOP("errors", "keep %1 at most"), most_remedies});
        for (std::size_t k = 0; k < task.remedies.size(); ++k)
            if (const auto found = problem_of(task.remedies[k], task.task, tasks_))
                add(CurriculumField::remedies, i,
                    {QT_TRANSLATE_NOOP("errors", "remedy %1: %2"), k + 1, found->problem}, found->hint);
    }

    const Curriculum& draft_;
    const std::vector<InstalledTask>& tasks_;
    const std::vector<ObserverForm>& forms_;
    std::vector<CurriculumProblem> found_;
};

nlohmann::ordered_json ratings_json(const RatingRule& rule) {
    nlohmann::ordered_json node = {
        {"form", rule.form}, {"raters", rule.raters}, {"lowest_mean", rule.lowest_mean}};
    if (!rule.items.empty()) node["items"] = rule.items;
    if (rule.every_item) node["every_item"] = true;
    if (rule.blind) node["blind"] = true;
    return node;
}

nlohmann::ordered_json remedy_json(const Remedy& remedy) {
    nlohmann::ordered_json node = {
        {"metric", remedy.metric}, {remedy.above ? "above" : "below", remedy.bound}, {"unit", remedy.unit}};
    if (remedy.kind == RemedyKind::practise_from)
        node["practise_from"] = remedy.goal;
    else if (remedy.kind == RemedyKind::other_task)
        node["task"] = remedy.task;
    else if (remedy.kind != RemedyKind::other_variant)
        node["feedback"] = feedback_name(remedy.kind);
    if (!remedy.variant.empty()) node["variant"] = remedy.variant;
    return node;
}

}  // namespace

std::vector<CurriculumProblem> check_draft(const Curriculum& draft, const std::vector<InstalledTask>& tasks,
                                           const std::vector<ObserverForm>& forms) {
    return DraftCheck(draft, tasks, forms).run();
}

std::string curriculum_text(const Curriculum& draft) {
    nlohmann::ordered_json document = nlohmann::ordered_json::object();
    const auto before = nlohmann::ordered_json::parse(draft.text, nullptr, false);
    if (before.is_object() && before.contains("$comment")) document["$comment"] = before["$comment"];
    document["id"] = draft.id;
    document["version"] = draft.version;
    document["title"] = draft.title;
    if (draft.based_on)
        document["based_on"] = {{"version", draft.based_on->version}, {"sha256", draft.based_on->sha256}};
    document["stages"] = nlohmann::ordered_json::array();
    for (const CurriculumStage& stage : draft.stages)
        document["stages"].push_back({{"id", stage.id}, {"title", stage.title}});
    document["tasks"] = nlohmann::ordered_json::array();
    for (const CurriculumTask& task : draft.tasks) {
        nlohmann::ordered_json node = {{"task", task.task},
                                       {"stage", task.stage},
                                       {"after", task.after},
                                       {"rule", pass_rule_text(task.rule)}};
        if (task.variants > 1) node["variants"] = task.variants;
        if (task.ratings) node["ratings"] = ratings_json(*task.ratings);
        for (const Remedy& remedy : task.remedies) node["remedies"].push_back(remedy_json(remedy));
        node["device_classes"] = nlohmann::ordered_json::array();
        for (const DeviceClass used : task.device_classes)
            node["device_classes"].push_back(row_of(device_classes, used).name);
        document["tasks"].push_back(std::move(node));
    }
    return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

bool same_contents(const Curriculum& a, const Curriculum& b) {
    Curriculum other = b;
    other.version = a.version;
    other.based_on = a.based_on;
    return curriculum_text(a) == curriculum_text(other);
}

}  // namespace fulcrum
