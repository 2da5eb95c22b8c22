// SPDX-License-Identifier: Apache-2.0
// State hashes of one expert attempt on every task with a benchmark. A change of structure must not change
// them. After a deliberate change of physics, of a scene or of an operator, write the new value in the same
// commit and give the reason.
#include <gtest/gtest.h>

#include <filesystem>
#include <iomanip>
#include <map>
#include <sstream>

#include "assessment/attempt/memory_sink.h"
#include "assessment/operators/operator.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

const std::map<std::string, std::string> golden = {{"A2", "116eac90bab280e8"},
                                                   {"B1", "734b2a808b8ab128"},
                                                   {"B2", "b108425d570b5f9c"},
                                                   {"B3", "4ea9c997ce67ab8f"},
                                                   {"C4", "dd9e4690b503dacc"}};

void expect_golden(const std::string& id) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/" + id + ".json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    AttemptEngine engine(scene, task, 2001);
    const auto rig = make_operator("expert", task, scene, 2001);
    MemorySink sink;
    const RunOutcome outcome = run_headless(engine, *rig, sink);
    std::ostringstream hash;
    hash << std::hex << std::setw(16) << std::setfill('0') << outcome.state_hash;
    EXPECT_EQ(hash.str(), golden.at(id)) << id;
}

TEST(GoldenHashes, A2) {
    expect_golden("A2");
}
TEST(GoldenHashes, B1) {
    expect_golden("B1");
}
TEST(GoldenHashes, B2) {
    expect_golden("B2");
}
TEST(GoldenHashes, B3) {
    expect_golden("B3");
}
TEST(GoldenHashes, C4) {
    expect_golden("C4");
}

TEST(GoldenHashes, CoverEveryTaskWithABenchmark) {
    for (const auto& entry : std::filesystem::directory_iterator(test::source_path("assets/benchmarks")))
        EXPECT_EQ(golden.count(entry.path().stem().string()), 1U) << entry.path();
}

}  // namespace
}  // namespace fulcrum
