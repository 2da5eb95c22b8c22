// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/specimen_plan.h"

#include <algorithm>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {

std::optional<SpecimenPlan> make_specimen_plan(const Scene& scene, const TaskDefinition& task) {
    if (!task.pathology) return std::nullopt;
    const auto refuse = [&](const char* place, const Sentence& wrong, const Sentence& hint) {
        throw InputError(task.id, place, wrong, hint);
    };
    if (!scene.septa)
        refuse("/pathology",
               {QT_TRANSLATE_NOOP("errors", "the scene \"%1\" has no septa to make a specimen of"), scene.id},
               QT_TRANSLATE_NOOP("errors", "add \"septa\" to the scene or remove \"pathology\""));
    const auto line = std::find_if(task.goals.begin(), task.goals.end(),
                                   [](const Goal& goal) { return goal.kind == GoalKind::divide_line; });
    if (line == task.goals.end())
        refuse("/pathology", QT_TRANSLATE_NOOP("errors", "the task divides no line"),
               QT_TRANSLATE_NOOP("errors", "add a goal of kind divide_line or remove it"));
    const SeptaSpec& septa = *scene.septa;
    if (task.tumour) {
        if (task.tumour->level >= septa.count)
            refuse("/pathology/tumour/level",
                   {QT_TRANSLATE_NOOP("errors", "the scene has only %1 septa, counted from 0"), septa.count},
                   QT_TRANSLATE_NOOP("errors", "give a lower level"));
        if (task.tumour->depth >= septa.fat_height - septa.areolar_height)
            refuse("/pathology/tumour/depth_m",
                   QT_TRANSLATE_NOOP("errors", "the tumour grows through the whole mesorectum"),
                   QT_TRANSLATE_NOOP("errors", "keep depth_m below the height of the fat"));
    }
    SpecimenPlan plan;
    plan.levels = septa.count;
    plan.line = septa.width;
    plan.asked = line->length_m;
    plan.spacing = septa.spacing;
    plan.plane = septa.plane_height;
    plan.areolar = septa.areolar_height;
    plan.fat = septa.fat_height;
    plan.tolerance = line->tolerance_m;
    plan.corridor = line->corridor_m;
    plan.tumour = task.tumour;
    return plan;
}

double marked_line(const Scene& scene) {
    if (scene.sheet) return scene.sheet->line_length;
    return scene.septa ? scene.septa->count * scene.septa->width : 0;
}

}  // namespace fulcrum
