// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/task.h"

#include <algorithm>
#include <utility>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_names.h"

namespace fulcrum {

extern const char* const task_schema_text;  // assets/schemas/task.schema.json, embedded by the build

namespace {

using nlohmann::json;

/// Numbers of a goal by their keys; which of them a goal must give, its type says.
constexpr std::pair<const char*, double Goal::*> goal_numbers[] = {
    {"hold_s", &Goal::hold_s},
    {"length_m", &Goal::length_m},
    {"from_m", &Goal::from_m},
    {"to_m", &Goal::to_m},
    {"minimum_step_m", &Goal::minimum_step_m},
    {"maximum_step_m", &Goal::maximum_step_m},
    {"height_m", &Goal::height_m},
    {"tolerance_m", &Goal::tolerance_m},
    {"corridor_m", &Goal::corridor_m},
    {"traction_low_n_m", &Goal::traction_low_n_m},
    {"traction_high_n_m", &Goal::traction_high_n_m},
    {"centre_deg", &Goal::centre_deg},
    {"horizon_deg", &Goal::horizon_deg},
    {"size_share", &Goal::size_share},
};

constexpr int most_benchmark_gates = 6;  // docs/METRICS.md, Gates

template <typename T>
void copy(const json& node, const char* key, T& value) {
    if (node.contains(key)) value = node.at(key).get<T>();
}

class TaskReader {
  public:
    explicit TaskReader(const JsonDocument& document) : document_(document) {}

    TaskDefinition read() {
        const json& root = document_.root();
        copy(root, "id", task_.id);
        copy(root, "version", task_.version);
        copy(root, "title", task_.title);
        copy(root, "stage", task_.stage);
        copy(root, "briefing", task_.briefing);
        copy(root, "product", task_.product);
        copy(root, "steps", task_.steps);
        copy(root, "scene", task_.scene);
        copy(root, "time_limit_s", task_.time_limit_s);
        copy(root, "warning_margin", task_.warning_margin);
        copy(root, "metrics", task_.metrics);
        copy(root, "context", task_.context);
        copy(root, "critical_errors", task_.critical_errors);
        copy(root, "hands_alike", task_.hands_alike);
        read_device_classes(root);
        read_pathology(root);
        check_scene_name("/scene", task_.scene);
        read_variants(root);
        check_metrics();
        read_goals(root.at("goals"));
        read_gates(root.at("gates"));
        return std::move(task_);
    }

  private:
    void check_scene_name(const std::string& place, const std::string& name) {
        const std::string ending = ".json";
        if (name.find_first_of("/\\") != std::string::npos || name.size() <= ending.size() ||
            name.compare(name.size() - ending.size(), ending.size(), ending) != 0) {
            document_.fail(
                place, {QT_TRANSLATE_NOOP("errors", "\"%1\" is not the name of a scene file"), name},
                QT_TRANSLATE_NOOP("errors", "give a file name of assets/scenes, such as a2_targets.json"));
        }
    }

    /// The standard one first; families name variants that are families of their own.
    void read_variants(const json& root) {
        if (!root.contains("variants")) {
            task_.variants = {{standard_variant, "Standard", task_.scene, standard_variant}};
            return;
        }
        std::size_t number = 0;
        for (const json& node : root.at("variants")) {
            const std::string place = "/variants/" + std::to_string(number++);
            TaskVariant variant;
            copy(node, "id", variant.id);
            copy(node, "title", variant.title);
            copy(node, "scene", variant.scene);
            variant.family = variant.id;
            copy(node, "family", variant.family);
            check_scene_name(place + "/scene", variant.scene);
            for (const TaskVariant& other : task_.variants)
                if (other.id == variant.id || other.scene == variant.scene)
                    document_.fail(
                        place,
                        {QT_TRANSLATE_NOOP("errors", "the variant \"%1\" or its scene is given twice"),
                         variant.id},
                        QT_TRANSLATE_NOOP("errors", "give every variant an id and a scene of its own"));
            task_.variants.push_back(std::move(variant));
        }
        const TaskVariant& first = task_.variants.front();
        if (first.id != standard_variant || first.scene != task_.scene || first.family != first.id)
            document_.fail("/variants/0", QT_TRANSLATE_NOOP("errors", "is not the standard variant"),
                           {QT_TRANSLATE_NOOP("errors", "list \"%1\" with the task's own scene first"),
                            standard_variant});
        for (std::size_t i = 0; i < task_.variants.size(); ++i) {
            const std::string& family = task_.variants[i].family;
            if (std::none_of(task_.variants.begin(), task_.variants.end(), [&](const TaskVariant& one) {
                    return one.id == family && one.family == family;
                }))
                document_.fail(
                    "/variants/" + std::to_string(i) + "/family",
                    {QT_TRANSLATE_NOOP("errors", "\"%1\" is not a variant with sets of its own"), family},
                    QT_TRANSLATE_NOOP(
                        "errors", "name a variant of this task that has no other family, or remove the key"));
        }
    }

    void read_device_classes(const json& root) {
        if (!root.contains("device_classes")) return;
        const json& list = root.at("device_classes");
        for (std::size_t i = 0; i < list.size(); ++i)
            task_.device_classes.push_back(
                named(document_, list[i], "/device_classes/" + std::to_string(i), device_classes));
    }

    void read_pathology(const json& root) {
        task_.pathology = root.contains("pathology");
        if (!task_.pathology || !root.at("pathology").contains("tumour")) return;
        const json& node = root.at("pathology").at("tumour");
        Tumour tumour;
        copy(node, "level", tumour.level);
        copy(node, "depth_m", tumour.depth);
        copy(node, "length_m", tumour.length);
        const auto sector = node.at("sector").get<std::string>();
        for (const Sector known : {Sector::right, Sector::mid, Sector::left})
            if (sector == sector_name(known)) tumour.sector = known;
        task_.tumour = tumour;
    }

    void check_metrics() {
        for (std::size_t i = 0; i < task_.metrics.size(); ++i) {
            const auto end = task_.metrics.begin() + static_cast<std::ptrdiff_t>(i);
            if (std::find(task_.metrics.begin(), end, task_.metrics[i]) != end) {
                document_.fail(
                    "/metrics/" + std::to_string(i),
                    {QT_TRANSLATE_NOOP("errors", "the metric \"%1\" is given twice"), task_.metrics[i]},
                    QT_TRANSLATE_NOOP("errors", "remove one of the two"));
            }
        }
        for (std::size_t i = 0; i < task_.context.size(); ++i) {
            const std::string id = task_.context[i].substr(0, task_.context[i].find('.'));
            if (std::find(task_.metrics.begin(), task_.metrics.end(), id) == task_.metrics.end())
                document_.fail(
                    "/context/" + std::to_string(i),
                    {QT_TRANSLATE_NOOP("errors", "\"%1\" is not among the metrics"), id},
                    QT_TRANSLATE_NOOP("errors", "name a metric of this task, alone or with .left or .right"));
        }
    }

    void read_goals(const json& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const json& node = list[i];
            const std::string place = "/goals/" + std::to_string(i);
            const Goal goal = read_goal(node, place);
            for (const Goal& other : task_.goals) {
                if (other.id == goal.id)
                    document_.fail(place + "/id",
                                   {QT_TRANSLATE_NOOP("errors", "the goal \"%1\" is given twice"), goal.id},
                                   QT_TRANSLATE_NOOP("errors", "give every goal its own id"));
            }
            check_goal(node, place, goal);
            task_.goals.push_back(goal);
        }
    }

    Goal read_goal(const json& node, const std::string& place) {
        Goal goal;
        goal.kind = named(document_, node.at("kind"), place + "/kind", goal_types);
        copy(node, "id", goal.id);
        copy(node, "text", goal.text);
        copy_named(document_, node, place, "hand", hand_names, goal.hand);
        copy(node, "count", goal.count);
        for (const auto& [key, value] : goal_numbers) copy(node, key, goal.*value);
        return goal;
    }

    void check_goal(const json& node, const std::string& place, const Goal& goal) {
        const GoalType& type = type_of(goal.kind);
        for (const GoalKey& key : type.keys) {
            if (key.name == nullptr || node.contains(key.name)) continue;
            document_.fail(
                place, {QT_TRANSLATE_NOOP("errors", "a goal of kind %1 needs \"%2\""), type.name, key.name},
                {QT_TRANSLATE_NOOP("errors", "add it: %1"), key.meaning});
        }
        if (type.check == nullptr) return;
        if (const std::optional<GoalFault> fault = type.check(goal))
            document_.fail(place + "/" + fault->key, fault->problem, fault->hint);
    }

    void read_gates(const json& list) {
        int benchmark_gates = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::string place = "/gates/" + std::to_string(i);
            const GateSpec gate = read_gate(list[i], place);
            if (gate.kind == GateKind::benchmark && ++benchmark_gates > most_benchmark_gates) {
                document_.fail(
                    place,
                    {QT_TRANSLATE_NOOP("errors", "more than %1 benchmark gates"), most_benchmark_gates},
                    QT_TRANSLATE_NOOP("errors",
                                      "show the metric without gating it, or make the gate absolute"));
            }
            task_.gates.push_back(gate);
        }
    }

    GateSpec read_gate(const json& node, const std::string& place) {
        GateSpec gate;
        gate.kind = named(document_, node.at("kind"), place + "/kind", gate_kinds);
        copy(node, "metric", gate.metric);
        copy(node, "hand", gate.hand);
        copy(node, "tissue", gate.tissue);
        copy(node, "limit", gate.limit);
        copy(node, "limit_source", gate.limit_source);
        copy(node, "provisional", gate.provisional);
        copy(node, "exclusive", gate.exclusive);
        copy(node, "advice", gate.advice);
        copy(node, "safety", gate.safety);
        if (std::find(task_.metrics.begin(), task_.metrics.end(), gate.metric) == task_.metrics.end()) {
            document_.fail(
                place + "/metric",
                {QT_TRANSLATE_NOOP("errors", "the gate's metric \"%1\" is not among the task's metrics"),
                 gate.metric},
                QT_TRANSLATE_NOOP("errors", "add it to \"metrics\" or correct its id"));
        }
        for (const GateSpec& other : task_.gates) {
            if (other.metric == gate.metric && other.hand == gate.hand && other.tissue == gate.tissue &&
                other.kind == gate.kind) {
                document_.fail(
                    place, {QT_TRANSLATE_NOOP("errors", "the gate on \"%1\" is given twice"), gate.metric},
                    QT_TRANSLATE_NOOP("errors", "remove one, or give it another hand or tissue"));
            }
        }
        if (gate.kind == GateKind::absolute) {
            if (!node.contains("limit") || !node.contains("limit_source"))
                document_.fail(place,
                               QT_TRANSLATE_NOOP("errors", "an absolute gate without limit and limit_source"),
                               QT_TRANSLATE_NOOP("errors", "add both: the value and where it comes from"));
            return gate;
        }
        for (const char* key : {"limit", "limit_source", "provisional", "exclusive"}) {
            if (node.contains(key))
                document_.fail(
                    place + "/" + key,
                    QT_TRANSLATE_NOOP("errors", "a benchmark gate with a limit of its own"),
                    QT_TRANSLATE_NOOP("errors",
                                      "remove it (the benchmark set gives it) or make the gate absolute"));
        }
        return gate;
    }

    const JsonDocument& document_;
    TaskDefinition task_;
};

}  // namespace

TaskDefinition parse_task(const std::string& text, const std::string& file) {
    const JsonDocument document = JsonDocument::parse(text, file);
    document.check_schema(task_schema_text);
    return TaskReader(document).read();
}

TaskDefinition load_task(const std::string& path) {
    return parse_task(read_text_file(path, JsonLimits().bytes), path);
}

bool can_be_assessed(const TaskDefinition& task, DeviceClass device_class) {
    const DeviceClass counted = limits_class(device_class);
    return std::find(task.device_classes.begin(), task.device_classes.end(), counted) !=
           task.device_classes.end();
}

void require_assessable(const TaskDefinition& task, DeviceClass device_class) {
    if (can_be_assessed(task, device_class)) return;
    std::string named;
    for (const DeviceClass one : task.device_classes)
        named += (named.empty() ? "" : ", ") + std::string(row_of(device_classes, one).title);
    throw InputError(
        {QT_TRANSLATE_NOOP("errors", "task %1"), task.id}, "/device_classes",
        {QT_TRANSLATE_NOOP("errors", "attempts with %1 are not assessed, they are practice only"),
         row_of(device_classes, device_class).title},
        {QT_TRANSLATE_NOOP("errors", "practise, or use one of: %1"), named});
}

}  // namespace fulcrum
