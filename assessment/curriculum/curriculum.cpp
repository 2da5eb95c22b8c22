// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/curriculum.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <set>

#include "assessment/task/task.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {

extern const char* const curriculum_schema_text;  // assets/schemas/curriculum.schema.json, embedded

namespace {

using nlohmann::json;

std::string place(std::size_t task, const char* key) {
    return "/tasks/" + std::to_string(task) + "/" + key;
}

void read_stages(const JsonDocument& document, Curriculum& curriculum) {
    for (const json& node : document.root().at("stages")) {
        const CurriculumStage stage{node.at("id").get<std::string>(), node.at("title").get<std::string>()};
        curriculum.stages.push_back(stage);
    }
}

RatingRule read_ratings(const JsonDocument& document, std::size_t number, const json& node) {
    RatingRule rule;
    rule.form = node.at("form").get<std::string>();
    rule.raters = node.at("raters").get<int>();
    rule.lowest_mean = node.at("lowest_mean").get<double>();
    if (node.contains("items")) rule.items = node.at("items").get<std::vector<std::string>>();
    if (node.contains("every_item")) rule.every_item = node.at("every_item").get<bool>();
    if (node.contains("blind")) rule.blind = node.at("blind").get<bool>();
    const std::set<std::string> once(rule.items.begin(), rule.items.end());
    if (once.size() != rule.items.size())
        document.fail(place(number, "ratings/items"), QT_TRANSLATE_NOOP("errors", "an item is listed twice"),
                      QT_TRANSLATE_NOOP("errors", "list every item once"));
    return rule;
}

/// The one of these keys that the remedy has; fails where it has none, or several.
const char* only_key(const JsonDocument& document, const std::string& where, const json& node,
                     std::initializer_list<const char*> keys, const Sentence& hint) {
    const char* found = nullptr;
    for (const char* key : keys) {
        if (!node.contains(key)) continue;
        if (found != nullptr)
            document.fail(where, {QT_TRANSLATE_NOOP("errors", "has both %1 and %2"), found, key}, hint);
        found = key;
    }
    if (found == nullptr)
        document.fail(where, QT_TRANSLATE_NOOP("errors", "something is missing in the remedy"), hint);
    return found;
}

Remedy read_remedy(const JsonDocument& document, const std::string& where, const json& node) {
    Remedy remedy;
    remedy.metric = node.at("metric").get<std::string>();
    remedy.unit = node.at("unit").get<std::string>();
    const std::string side = only_key(document, where, node, {"above", "below"},
                                      QT_TRANSLATE_NOOP("errors", "give one bound, \"above\" or \"below\""));
    remedy.above = side == "above";
    remedy.bound = node.at(side).get<double>();
    const Sentence one_of = QT_TRANSLATE_NOOP(
        "errors",
        "say what to do: one of \"practise_from\", \"task\" (with \"variant\" or without), \"variant\", "
        "\"feedback\"");
    const bool of_task = node.contains("task");
    const std::string what =
        of_task ? only_key(document, where, node, {"task", "practise_from", "feedback"}, one_of)
                : only_key(document, where, node, {"practise_from", "variant", "feedback"}, one_of);
    if (node.contains("variant")) remedy.variant = node.at("variant").get<std::string>();
    if (what == "practise_from") {
        remedy.kind = RemedyKind::practise_from;
        remedy.goal = node.at(what).get<std::string>();
    } else if (what == "task") {
        remedy.kind = RemedyKind::other_task;
        remedy.task = node.at(what).get<std::string>();
    } else if (what == "variant") {
        remedy.kind = RemedyKind::other_variant;
    } else {
        remedy.kind = *feedback_named(node.at(what).get<std::string>());  // the schema names them
    }
    return remedy;
}

CurriculumTask read_task(const JsonDocument& document, std::size_t number, const json& node) {
    CurriculumTask task;
    task.task = node.at("task").get<std::string>();
    task.stage = node.at("stage").get<std::string>();
    task.after = node.at("after").get<std::vector<std::string>>();
    try {
        task.rule = parse_pass_rule(node.at("rule").get<std::string>());
    } catch (const InputError& error) {
        document.fail(place(number, "rule"), error.problem_sentence(), error.hint_sentence());
    }
    if (node.contains("variants")) task.variants = node.at("variants").get<int>();
    if (node.contains("ratings")) task.ratings = read_ratings(document, number, node.at("ratings"));
    if (node.contains("remedies"))
        for (const json& one : node.at("remedies"))
            task.remedies.push_back(read_remedy(
                document, place(number, "remedies/") + std::to_string(task.remedies.size()), one));
    for (const json& name : node.at("device_classes"))
        task.device_classes.push_back(find_row(device_classes, name.get<std::string>())->kind);
    return task;
}

/// Valid by the schema; nothing is said of how its parts fit together.
Curriculum read_curriculum(const JsonDocument& document) {
    document.check_schema(curriculum_schema_text);
    Curriculum curriculum;
    curriculum.id = document.root().at("id").get<std::string>();
    curriculum.version = document.root().at("version").get<int>();
    curriculum.title = document.root().at("title").get<std::string>();
    if (document.root().contains("based_on")) {
        const json& origin = document.root().at("based_on");
        curriculum.based_on =
            DraftOrigin{origin.at("version").get<int>(), origin.at("sha256").get<std::string>()};
    }
    read_stages(document, curriculum);
    std::size_t number = 0;
    for (const json& node : document.root().at("tasks"))
        curriculum.tasks.push_back(read_task(document, number++, node));
    return curriculum;
}

std::size_t rank_of(const Curriculum& curriculum, const std::string& stage) {
    std::size_t rank = 0;
    while (curriculum.stages[rank].id != stage) ++rank;
    return rank;
}

/// Whether `task` comes after itself. `seen`: the tasks on the way to it.
bool in_cycle(const Curriculum& curriculum, const std::string& task, const std::string& from,
              std::set<std::string>& seen) {
    const CurriculumTask* here = curriculum.find(from);
    return std::any_of(here->after.begin(), here->after.end(), [&](const std::string& before) {
        return before == task || (seen.insert(before).second && in_cycle(curriculum, task, before, seen));
    });
}

void check_prerequisites(const JsonDocument& document, const Curriculum& curriculum) {
    for (std::size_t i = 0; i < curriculum.tasks.size(); ++i) {
        const CurriculumTask& task = curriculum.tasks[i];
        for (const std::string& before : task.after) {
            const CurriculumTask* other = curriculum.find(before);
            if (other == nullptr)
                document.fail(place(i, "after"),
                              {QT_TRANSLATE_NOOP("errors", "%1 is not a task of this curriculum"), before},
                              QT_TRANSLATE_NOOP("errors", "add it to /tasks, or remove it here"));
            if (rank_of(curriculum, other->stage) > rank_of(curriculum, task.stage))
                document.fail(
                    place(i, "after"),
                    {QT_TRANSLATE_NOOP("errors", "%1 belongs to a later stage than %2"), before, task.task},
                    QT_TRANSLATE_NOOP("errors", "name tasks of the same or an earlier stage"));
        }
    }
    for (std::size_t i = 0; i < curriculum.tasks.size(); ++i) {
        std::set<std::string> seen;
        const std::string& task = curriculum.tasks[i].task;
        if (in_cycle(curriculum, task, task, seen))
            document.fail(
                place(i, "after"), {QT_TRANSLATE_NOOP("errors", "%1 would unlock only after itself"), task},
                {QT_TRANSLATE_NOOP("errors", "remove one of the prerequisites on the way back to %1"), task});
    }
}

}  // namespace

const Curriculum* Curriculum::version_named(const std::string& wanted) const {
    if (wanted == name()) return this;
    const auto found =
        std::find_if(older.begin(), older.end(), [&](const Curriculum& one) { return one.name() == wanted; });
    return found == older.end() ? nullptr : &*found;
}

const CurriculumTask* Curriculum::find(const std::string& task) const {
    const auto found =
        std::find_if(tasks.begin(), tasks.end(), [&](const CurriculumTask& one) { return one.task == task; });
    return found == tasks.end() ? nullptr : &*found;
}

const CurriculumStage* Curriculum::find_stage(const std::string& stage) const {
    const auto found = std::find_if(stages.begin(), stages.end(),
                                    [&](const CurriculumStage& one) { return one.id == stage; });
    return found == stages.end() ? nullptr : &*found;
}

bool counts(const CurriculumTask& task, DeviceClass used) {
    const std::vector<DeviceClass>& classes = task.device_classes;
    return std::find(classes.begin(), classes.end(), curriculum_class(used)) != classes.end();
}

void require_counts(const Curriculum& curriculum, const TaskDefinition& task, DeviceClass used) {
    require_assessable(task, used);
    const CurriculumTask* found = curriculum.find(task.id);
    if (found == nullptr || counts(*found, used)) return;
    std::string named;
    for (const DeviceClass one : found->device_classes)
        named += (named.empty() ? "" : ", ") + std::string(row_of(device_classes, one).title);
    throw InputError({QT_TRANSLATE_NOOP("errors", "task %1"), task.id}, "/device_classes",
                     {QT_TRANSLATE_NOOP("errors",
                                        "the curriculum %1 does not count attempts with %2, they are "
                                        "practice only"),
                      curriculum.name(), row_of(device_classes, used).title},
                     {QT_TRANSLATE_NOOP("errors", "practise, or use one of: %1"), named});
}

void check_rules(const Curriculum& curriculum) {
    for (std::size_t i = 0; i < curriculum.tasks.size(); ++i)
        if (const auto found = why_never_met(curriculum.tasks[i].rule, curriculum.tasks[i].variants))
            throw InputError(curriculum.file.empty() ? curriculum.name() : curriculum.file, place(i, "rule"),
                             found->problem, found->hint);
}

Curriculum parse_draft(const std::string& text, const std::string& file) {
    Curriculum draft = read_curriculum(JsonDocument::parse(text, file));
    draft.text = text;
    return draft;
}

Curriculum parse_curriculum(const std::string& text, const std::string& file,
                            const std::vector<std::string>& tasks) {
    const JsonDocument document = JsonDocument::parse(text, file);
    const Curriculum said = read_curriculum(document);
    Curriculum curriculum = said;
    curriculum.tasks.clear();
    curriculum.stages.clear();
    for (const CurriculumStage& stage : said.stages) {
        if (curriculum.find_stage(stage.id) != nullptr)
            document.fail("/stages", {QT_TRANSLATE_NOOP("errors", "stage %1 is listed twice"), stage.id},
                          QT_TRANSLATE_NOOP("errors", "give every stage its own id"));
        curriculum.stages.push_back(stage);
    }
    std::size_t number = 0;
    for (const CurriculumTask& task : said.tasks) {
        if (std::find(tasks.begin(), tasks.end(), task.task) == tasks.end())
            document.fail(place(number, "task"),
                          {QT_TRANSLATE_NOOP("errors", "no task %1 is installed"), task.task},
                          QT_TRANSLATE_NOOP("errors", "name a file of assets/tasks"));
        if (curriculum.find(task.task) != nullptr)
            document.fail(place(number, "task"),
                          {QT_TRANSLATE_NOOP("errors", "%1 is listed twice"), task.task},
                          QT_TRANSLATE_NOOP("errors", "list every task once"));
        if (curriculum.find_stage(task.stage) == nullptr)
            document.fail(place(number, "stage"),
                          {QT_TRANSLATE_NOOP("errors", "there is no stage %1"), task.stage},
                          QT_TRANSLATE_NOOP("errors", "name one of /stages, or add it there"));
        for (std::size_t i = 0; i < task.remedies.size(); ++i)
            if (const auto found = problem_of(task.remedies[i]))
                document.fail(place(number, "remedies/") + std::to_string(i) + "/" + found->key,
                              found->problem, found->hint);
        curriculum.tasks.push_back(task);
        ++number;
    }
    check_prerequisites(document, curriculum);
    return curriculum;
}

Curriculum load_curriculum(const std::string& path, const std::vector<std::string>& tasks) {
    const std::string text = read_text_file(path, JsonLimits().bytes);
    Curriculum curriculum = parse_curriculum(text, path, tasks);
    curriculum.file = std::filesystem::path(path).filename().string();
    curriculum.text = text;
    return curriculum;
}

Curriculum load_versions(const std::string& folder, const std::string& id,
                         const std::vector<std::string>& tasks) {
    std::vector<Curriculum> versions;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".json") continue;
        Curriculum one = load_curriculum(entry.path().string(), tasks);
        if (one.id == id) versions.push_back(std::move(one));
    }
    std::sort(versions.begin(), versions.end(),
              [](const Curriculum& a, const Curriculum& b) { return a.version > b.version; });
    if (versions.empty())
        throw InputError(folder, "", {QT_TRANSLATE_NOOP("errors", "contains no curriculum %1"), id},
                         QT_TRANSLATE_NOOP("errors", "install the program's assets again"));
    for (std::size_t i = 1; i < versions.size(); ++i)
        if (versions[i].version == versions[i - 1].version)
            throw InputError(
                folder + "/" + versions[i].file, "/version",
                {QT_TRANSLATE_NOOP("errors", "the file %1 has the same version"), versions[i - 1].file},
                QT_TRANSLATE_NOOP("errors",
                                  "a version in use is never edited: raise the version of the changed file"));
    Curriculum newest = std::move(versions.front());
    newest.older.assign(std::make_move_iterator(versions.begin() + 1),
                        std::make_move_iterator(versions.end()));
    return newest;
}

}  // namespace fulcrum
