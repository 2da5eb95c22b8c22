// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/task.h"

#include <algorithm>

#include "sim_core/scene/json_document.h"

namespace fulcrum {

extern const char* const task_schema_text;  // assets/schemas/task.schema.json, embedded by the build

namespace {

using nlohmann::json;

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
        copy(root, "critical_errors", task_.critical_errors);
        copy(root, "device_classes", task_.device_classes);
        read_pathology(root);
        check_scene_name();
        check_metrics();
        read_goals(root.at("goals"));
        read_gates(root.at("gates"));
        return std::move(task_);
    }

  private:
    void check_scene_name() {
        const std::string ending = ".json";
        const std::string& name = task_.scene;
        if (name.find_first_of("/\\") != std::string::npos || name.size() <= ending.size() ||
            name.compare(name.size() - ending.size(), ending.size(), ending) != 0) {
            document_.fail("/scene", "\"" + name + "\" is not the name of a scene file",
                           "give a file name of assets/scenes, such as a2_targets.json");
        }
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
                document_.fail("/metrics/" + std::to_string(i),
                               "the metric \"" + task_.metrics[i] + "\" is given twice",
                               "remove one of the two");
            }
        }
    }

    void require(const json& node, const std::string& place, const char* key, const char* meaning) {
        if (!node.contains(key)) {
            document_.fail(place,
                           "a goal of kind " + node.at("kind").get<std::string>() + " needs \"" + key + "\"",
                           std::string("add it: ") + meaning);
        }
    }

    void read_goals(const json& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const json& node = list[i];
            const std::string place = "/goals/" + std::to_string(i);
            Goal goal;
            copy(node, "id", goal.id);
            copy(node, "text", goal.text);
            copy(node, "count", goal.count);
            copy(node, "hold_s", goal.hold_s);
            copy(node, "length_m", goal.length_m);
            copy(node, "from_m", goal.from_m);
            copy(node, "to_m", goal.to_m);
            copy(node, "minimum_step_m", goal.minimum_step_m);
            copy(node, "maximum_step_m", goal.maximum_step_m);
            copy(node, "height_m", goal.height_m);
            copy(node, "tolerance_m", goal.tolerance_m);
            copy(node, "corridor_m", goal.corridor_m);
            copy(node, "traction_low_n_m", goal.traction_low_n_m);
            copy(node, "traction_high_n_m", goal.traction_high_n_m);
            for (const Goal& other : task_.goals) {
                if (other.id == goal.id)
                    document_.fail(place + "/id", "the goal \"" + goal.id + "\" is given twice",
                                   "give every goal its own id");
            }
            const std::string kind = node.at("kind").get<std::string>();
            if (kind == "touch_targets") {
                goal.kind = GoalKind::touch_targets;
                require(node, place, "hand", "left or right");
                require(node, place, "count", "how many spheres");
                require(node, place, "hold_s", "seconds to hold each");
                goal.hand = node.at("hand").get<std::string>() == "left" ? Hand::left : Hand::right;
            } else if (kind == "run_bowel") {
                goal.kind = GoalKind::run_bowel;
                check_run(node, place, goal);
            } else if (kind == "take_tension") {
                goal.kind = GoalKind::take_tension;
                require(node, place, "hold_s", "seconds to keep the traction");
                check_traction(node, place, goal);
            } else if (kind == "divide_line") {
                goal.kind = GoalKind::divide_line;
                require(node, place, "length_m", "metres of the marked line");
                require(node, place, "tolerance_m", "metres from the line that are too far");
                require(node, place, "corridor_m", "metres from the line within which a cut divides it");
                if (goal.tolerance_m > goal.corridor_m) {
                    document_.fail(place + "/tolerance_m", "tolerance_m is above corridor_m",
                                   "give the smaller distance as tolerance_m");
                }
                check_traction(node, place, goal);
            } else if (kind == "divide_bands") {
                goal.kind = GoalKind::divide_bands;
                require(node, place, "count", "how many bands");
            } else if (kind == "stop_bleeding") {
                goal.kind = GoalKind::stop_bleeding;
                require(node, place, "count", "how many vessels");
                require(node, place, "hold_s", "seconds without bleeding");
            } else if (kind == "let_go") {
                goal.kind = GoalKind::let_go;
                require(node, place, "hold_s", "seconds without a hold");
            } else {
                goal.kind = GoalKind::lift_and_hold;
                check_lift(node, place, goal);
            }
            task_.goals.push_back(goal);
        }
    }

    void check_run(const json& node, const std::string& place, const Goal& goal) {
        require(node, place, "length_m", "metres of bowel to run");
        require(node, place, "from_m", "where to start");
        require(node, place, "to_m", "where the run leads");
        require(node, place, "minimum_step_m", "shortest step that counts");
        require(node, place, "maximum_step_m", "longest step that counts");
        if (goal.minimum_step_m >= goal.maximum_step_m) {
            document_.fail(place + "/minimum_step_m", "minimum_step_m is not below maximum_step_m",
                           "give the shortest step first");
        }
        const double room = goal.to_m > goal.from_m ? goal.to_m - goal.from_m : goal.from_m - goal.to_m;
        if (room + 1e-9 < goal.length_m) {
            document_.fail(place + "/length_m",
                           "there are only " + std::to_string(room) + " m between from_m and to_m",
                           "ask for less, or move from_m and to_m apart");
        }
    }

    void check_traction(const json& node, const std::string& place, const Goal& goal) {
        require(node, place, "traction_low_n_m", "the least traction across the line, N/m");
        require(node, place, "traction_high_n_m", "the most traction across the line, N/m");
        if (goal.traction_low_n_m >= goal.traction_high_n_m) {
            document_.fail(place + "/traction_low_n_m", "traction_low_n_m is not below traction_high_n_m",
                           "give the least traction first");
        }
    }

    void check_lift(const json& node, const std::string& place, const Goal& goal) {
        require(node, place, "hold_s", "seconds to hold");
        require(node, place, "from_m", "where the stretch begins");
        require(node, place, "to_m", "where the stretch ends");
        require(node, place, "height_m", "metres above the resting height");
        if (goal.from_m >= goal.to_m) {
            document_.fail(place + "/from_m", "the stretch to lift has no length", "give from_m below to_m");
        }
    }

    void read_gates(const json& list) {
        int benchmark_gates = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const json& node = list[i];
            const std::string place = "/gates/" + std::to_string(i);
            GateSpec gate;
            copy(node, "metric", gate.metric);
            copy(node, "hand", gate.hand);
            copy(node, "tissue", gate.tissue);
            copy(node, "kind", gate.kind);
            copy(node, "limit", gate.limit);
            copy(node, "limit_source", gate.limit_source);
            if (std::find(task_.metrics.begin(), task_.metrics.end(), gate.metric) == task_.metrics.end()) {
                document_.fail(place + "/metric",
                               "the gate's metric \"" + gate.metric + "\" is not among the task's metrics",
                               "add it to \"metrics\" or correct its id");
            }
            for (const GateSpec& other : task_.gates) {
                if (other.metric == gate.metric && other.hand == gate.hand && other.tissue == gate.tissue &&
                    other.kind == gate.kind) {
                    document_.fail(place, "the gate on \"" + gate.metric + "\" is given twice",
                                   "remove one, or give it another hand or tissue");
                }
            }
            const bool has_limit = node.contains("limit"), has_source = node.contains("limit_source");
            if (gate.kind == "absolute" && !(has_limit && has_source)) {
                document_.fail(place, "an absolute gate without limit and limit_source",
                               "add both: the figure and where it comes from");
            }
            if (gate.kind == "benchmark" && (has_limit || has_source)) {
                document_.fail(place + (has_limit ? "/limit" : "/limit_source"),
                               "a benchmark gate with a limit of its own",
                               "remove it (the benchmark set gives it) or make the gate absolute");
            }
            if (gate.kind == "benchmark" && ++benchmark_gates > most_benchmark_gates) {
                document_.fail(place,
                               "more than " + std::to_string(most_benchmark_gates) + " benchmark gates",
                               "show the metric without gating it, or make the gate absolute");
            }
            task_.gates.push_back(gate);
        }
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

}  // namespace fulcrum
