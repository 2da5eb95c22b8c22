// SPDX-License-Identifier: Apache-2.0
// The state hash of one expert attempt on every task of assets/tasks, held against golden/TASK.json here. A
// change of structure must not change it. The files are written, never edited: a task without one fails until
// FULCRUM_WRITE_GOLDEN=new has written it; after a deliberate change of physics, of a scene or of an
// operator, FULCRUM_WRITE_GOLDEN=changed writes the new ones in the same commit, with the reason, and after
// one of physics physics_version is raised as well.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "sim_core/scene/json_document.h"
#include "sim_core/world/physics_version.h"
#include "tests/assessment/attempt/expert_record.h"

namespace fulcrum {
namespace {

std::string golden_folder() {
    return test::source_path("tests/assessment/attempt/golden");
}

struct GoldenHash {
    int physics = 0;
    std::string state_hash;
};

GoldenHash golden_hash(const std::string& path) {
    const auto file = nlohmann::json::parse(read_text_file(path, 1U << 16U));
    return {file.at("physics").get<int>(), file.at("state_hash").get<std::string>()};
}

void write_golden_hash(const std::string& path, const std::string& hash) {
    const nlohmann::json file = {{"$comment", "SPDX-License-Identifier: Apache-2.0"},
                                 {"physics", physics_version},
                                 {"state_hash", hash}};
    std::ofstream(path) << file.dump(1) << '\n';
}

class GoldenHashes : public ::testing::TestWithParam<std::string> {};

TEST_P(GoldenHashes, AreThoseOfTheFiles) {
    std::ostringstream hash;
    hash << std::hex << std::setw(16) << std::setfill('0')
         << test::expert_record(GetParam()).outcome.state_hash;
    const std::string path = golden_folder() + "/" + GetParam() + ".json";
    const char* const write = std::getenv("FULCRUM_WRITE_GOLDEN");
    const std::string wanted = write != nullptr ? write : "";
    if (wanted == "changed" || (wanted == "new" && !std::filesystem::exists(path)))
        write_golden_hash(path, hash.str());
    ASSERT_TRUE(std::filesystem::exists(path)) << "no hash of this task: FULCRUM_WRITE_GOLDEN=new "
                                                  "test_assessment --gtest_filter=Tasks/GoldenHashes.*";
    const GoldenHash golden = golden_hash(path);
    EXPECT_EQ(hash.str(), golden.state_hash);
    EXPECT_EQ(golden.physics, physics_version) << "a hash belongs to one version of physics";
}

INSTANTIATE_TEST_SUITE_P(Tasks, GoldenHashes, ::testing::ValuesIn(test::task_ids()),
                         [](const auto& instance) { return instance.param; });

TEST(GoldenFiles, AreOfTasksThatExist) {
    const std::vector<std::string> ids = test::task_ids();
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(golden_folder()))
        found.insert(entry.path().stem().string());
    for (const std::string& id : ids) found.erase(id);
    EXPECT_TRUE(found.empty()) << "remove golden/" << *found.begin() << ".json";
    EXPECT_GE(ids.size(), 8U);
}

}  // namespace
}  // namespace fulcrum
