// SPDX-License-Identifier: Apache-2.0
// The attempt of expert 2001 at a task, which several suites look at. ctest runs them in one process
// (tests/CMakeLists.txt), so that each attempt is made once.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "assessment/attempt/memory_sink.h"
#include "assessment/operators/operator.h"
#include "tests/support/support.h"

namespace fulcrum::test {

inline constexpr std::uint64_t expert_seed = 2001;

struct ExpertRecord {
    TaskDefinition task;
    Scene scene;
    std::vector<TargetSphere> targets;
    AttemptRecord record;
    RunOutcome outcome;
};

inline ExpertRecord make_expert_record(const std::string& id) {
    ExpertRecord made;
    made.task = load_task(source_path("assets/tasks/" + id + ".json"));
    made.scene = load_scene(source_path("assets/scenes/" + made.task.scene));
    AttemptEngine engine(made.scene, made.task, expert_seed);
    made.targets = engine.initial_snapshot().targets;
    const auto rig = make_operator(OperatorLevel::expert, made.task, made.scene, expert_seed);
    MemorySink sink;
    made.outcome = run_headless(engine, *rig, sink);
    made.record = std::move(sink.record);
    return made;
}

/// Made at the first call with this id.
inline const ExpertRecord& expert_record(const std::string& id) {
    static std::map<std::string, std::unique_ptr<const ExpertRecord>> made;
    std::unique_ptr<const ExpertRecord>& one = made[id];
    if (one == nullptr) one = std::make_unique<const ExpertRecord>(make_expert_record(id));
    return *one;
}

}  // namespace fulcrum::test
