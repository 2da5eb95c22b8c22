// SPDX-License-Identifier: Apache-2.0
// A task as data: what the trainee must do and the limits. JSON files in assets/tasks, schema
// assets/schemas/task.schema.json.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/pathology/pathology.h"
#include "assessment/task/attempt_words.h"
#include "assessment/task/goal_type.h"
#include "assessment/task/variant.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

struct Goal {
    std::string id;
    GoalKind kind = GoalKind::touch_targets;
    std::string text;             ///< one line for the HUD, imperative
    Hand hand = Hand::left;       ///< touch_targets, palpate; transfer_objects: lifts first
    int count = 0;                ///< touch_targets: spheres to hold; transfer_objects: rings
    double hold_s = 0;            ///< s, continuous
    double length_m = 0;          ///< run_bowel: arc length to cover; divide_line: of the marked line
    double from_m = 0, to_m = 0;  ///< arc lengths on the bowel: where to start (run), or the stretch to lift
    double minimum_step_m = 0, maximum_step_m = 0;  ///< run_bowel: hand-over-hand distance that counts
    double height_m = 0;                            ///< lift_and_hold, transfer_objects
    double tolerance_m = 0;  ///< divide_line: further from the line is too deep or too shallow
    double corridor_m = 0;   ///< divide_line: further from the line divides nothing of it
    double traction_low_n_m = 0, traction_high_n_m = 0;  ///< take_tension, divide_line: N/m across the line
    double centre_deg = 0;  ///< frame_targets, follow_tip: at most off the middle of the image
    double horizon_deg =
        0;                  ///< frame_targets, follow_tip: at most between the image's upright and the body's
    double size_share = 0;  ///< frame_targets, follow_tip: at most off the wanted size, 0 .. 1
};

/// A gate as the task names it; the limit of a benchmark gate comes from the benchmark set.
struct GateSpec {
    std::string metric;
    std::string hand;    ///< "left", "right" or ""
    std::string tissue;  ///< label or "" for all
    GateKind kind = GateKind::benchmark;
    double limit = 0;          ///< absolute gates
    std::string limit_source;  ///< absolute gates: where the limit comes from
    bool provisional = false;  ///< absolute gates: the limit is our own and waits for a published one
    bool exclusive = false;    ///< absolute gates: a value at the limit itself does not pass
    std::string advice = {};   ///< what to try where it is not met; "": the metric's own
    std::string safety = {};   ///< the harm it stops, for a gate that seldom fails anyone
};

struct TaskDefinition {
    std::string id;  ///< "A2"
    int version = 1;
    std::string title, stage, briefing, product;  ///< product: what the attempt leaves, one line
    std::vector<std::string> steps;               ///< briefing, one line each
    std::string scene;                            ///< file name in assets/scenes, of the standard variant
    std::vector<TaskVariant> variants;  ///< the standard one first; never empty in a task from a file
    double time_limit_s = 600;
    double warning_margin = 0;  ///< bandwidth feedback: 0 stage A, 0.10 B, 0.25 C; negative: never warn (D)
    std::vector<Goal> goals;    ///< phases, in order
    std::vector<std::string> metrics;  ///< metric ids shown
    /// Rows of these that describe and do not rate in this task, because they do not tell experts from
    /// novices: "idle" (both hands) or "idle.left".
    std::vector<std::string> context;
    std::vector<GateSpec> gates;
    std::vector<std::string> critical_errors;  ///< event names that fail the attempt
    std::vector<DeviceClass> device_classes;   ///< that can be assessed; any other practises
    bool hands_alike = false;      ///< both hands do the same work: benchmark gates have one limit for both
    bool pathology = false;        ///< a pathology report is made of the specimen
    std::optional<Tumour> tumour;  ///< of the report
};

/// Throws InputError with file, place and hint.
TaskDefinition load_task(const std::string& path);
TaskDefinition parse_task(const std::string& text, const std::string& file);

/// Whether attempts with this class of device can be assessed (limits_class()).
bool can_be_assessed(const TaskDefinition& task, DeviceClass device_class);
/// Throws InputError in a sentence for screens where they cannot.
void require_assessable(const TaskDefinition& task, DeviceClass device_class);

}  // namespace fulcrum
