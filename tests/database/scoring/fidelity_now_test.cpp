// SPDX-License-Identifier: GPL-3.0-or-later
// What fidelities cost in score counts as measured only with the simulation, metrics and limits in force.
#include "database/scoring/fidelity_now.h"

#include <gtest/gtest.h>

#include "assessment/metrics/registry.h"
#include "database/scoring/loaded_task.h"
#include "database/scoring/scoring.h"
#include "sim_core/world/physics_version.h"

namespace fulcrum {
namespace {

TaskFidelityCost measured_today() {
    const LoadedTask loaded = load_task_and_scene("A2");
    TaskFidelityCost cost;
    cost.physics = physics_version;
    cost.limits = limits_for(loaded.task, loaded.scene, DeviceClass::synthetic).name();
    cost.metrics = gated_metric_versions(loaded.task);
    return cost;
}

TEST(FidelityNow, IsWhatWasMeasuredWithTheSameSimulationMetricsAndLimits) {
    const TaskFidelityCost cost = measured_today();
    EXPECT_FALSE(cost.limits.empty());
    EXPECT_EQ(cost.metrics.at("f_max"), find_metric("f_max")->version);
    EXPECT_TRUE(measured_with_this_program(cost));
    EXPECT_TRUE(measured_as_now(cost, "A2"));
}

TEST(FidelityNow, IsNotWhatWasMeasuredOtherwise) {
    TaskFidelityCost cost = measured_today();
    cost.physics -= 1;
    EXPECT_FALSE(measured_as_now(cost, "A2"));
    EXPECT_FALSE(measured_with_this_program(cost));
    cost = measured_today();
    cost.metrics["f_max"] -= 1;
    EXPECT_FALSE(measured_as_now(cost, "A2"));
    EXPECT_FALSE(measured_with_this_program(cost));
    cost = measured_today();
    cost.metrics.clear();
    EXPECT_FALSE(measured_as_now(cost, "A2")) << "not recorded";
    cost = measured_today();
    cost.metrics.erase("f_max");
    EXPECT_FALSE(measured_as_now(cost, "A2")) << "a gate that came later";
    cost = measured_today();
    cost.limits = "A2-provisional@1";
    EXPECT_FALSE(measured_as_now(cost, "A2"));
    EXPECT_TRUE(measured_with_this_program(cost));
}

}  // namespace
}  // namespace fulcrum
