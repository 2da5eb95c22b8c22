// SPDX-License-Identifier: Apache-2.0
// State hashes of one expert attempt on every task of assets/tasks; a task without a value here fails. A
// change of structure must not change them. After a deliberate change of physics, of a scene or of an
// operator, write the new value in the same commit and give the reason; after one of physics, raise
// physics_version as well.
#include <gtest/gtest.h>

#include <iomanip>
#include <map>
#include <sstream>

#include "sim_core/world/physics_version.h"
#include "tests/assessment/attempt/expert_record.h"

namespace fulcrum {
namespace {

const std::map<std::string, std::string> golden = {{"A1", "b54d11a511c0bd9f"}, {"A2", "116eac90bab280e8"},
                                                   {"A3", "76a7a131cef974b2"}, {"B0", "dc9f0a8affa9f7b3"},
                                                   {"B1", "320a99d03f8803f2"}, {"B2", "52ddf1b63b70e891"},
                                                   {"B3", "8757db99a19e94ab"}, {"C4", "70d3a8d489bc669c"}};

static_assert(physics_version == 4, "the table belongs to one version of physics: change both or neither");

void expect_golden(const std::string& id) {
    std::ostringstream hash;
    hash << std::hex << std::setw(16) << std::setfill('0') << test::expert_record(id).outcome.state_hash;
    const auto found = golden.find(id);
    EXPECT_EQ(hash.str(), found == golden.end() ? "no value in the table" : found->second) << id;
}

class GoldenHashes : public ::testing::TestWithParam<std::string> {};

TEST_P(GoldenHashes, AreThoseOfTheTable) {
    expect_golden(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Tasks, GoldenHashes, ::testing::ValuesIn(test::task_ids()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace fulcrum
