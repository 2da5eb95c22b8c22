// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves the program gives the same result when it comes back: attempts are exported as trace and
// events, and read again by the command line. FULCRUM_REREAD_ATTEMPTS: how many (7, one of each task; 200 is
// the full test).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/services/program.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

constexpr const char* reread_tasks[] = {"A1", "A2", "A3", "B1", "B2", "B3", "C4"};
constexpr const char* reread_operators[] = {"expert", "novice", "intermediate"};

class Reread : public ::testing::Test {
  protected:
    std::string run(const std::vector<std::string>& words) const {
        std::ostringstream text;
        int status = -1;
        {
            struct Redirected {
                explicit Redirected(std::ostream& to) : before(std::cout.rdbuf(to.rdbuf())) {}
                ~Redirected() { std::cout.rdbuf(before); }
                std::streambuf* before;
            } redirected(text);
            status = run_command(words);
        }
        EXPECT_EQ(status, 0) << words[0];
        return text.str();
    }
    nlohmann::json run_json(std::vector<std::string> words) const {
        words.emplace_back("--json");
        return nlohmann::json::parse(run(words), nullptr, false);
    }
    static void expect_same(const nlohmann::json& before, const nlohmann::json& after,
                            const std::string& what) {
        ASSERT_EQ(before.is_number(), after.is_number()) << what;
        if (!before.is_number()) {
            EXPECT_EQ(before, after) << what;
            return;
        }
        const double value = before.get<double>();
        EXPECT_NEAR(after.get<double>(), value, 1e-9 * std::max(1.0, std::abs(value))) << what;
    }
    void expect_same_score(const nlohmann::json& stored, const nlohmann::json& read,
                           const std::string& what) {
        for (const char* key : {"metrics", "gates"}) {
            ASSERT_EQ(stored[key].size(), read[key].size()) << what << key;
            for (std::size_t i = 0; i < stored[key].size(); ++i) {
                const nlohmann::json &a = stored[key][i], &b = read[key][i];
                for (const char* part : {"id", "metric", "hand", "tissue", "absent_code", "passed", "limit"})
                    if (a.contains(part)) expect_same(a[part], b[part], what + key + a.dump());
                expect_same(a["value"], b["value"], what + key + a.dump());
            }
        }
        for (const char* key : {"passed", "pathology", "critical_errors"})
            EXPECT_EQ(stored[key], read[key]) << what << key;
        expect_same(stored["points"], read["points"], what + "points");
    }

    fulcrum::test::OwnFolder folder_;
};

TEST_F(Reread, OfExportedAttemptsGivesEveryMetricGateAndVerdictAgain) {
    const char* asked = std::getenv("FULCRUM_REREAD_ATTEMPTS");
    const int attempts = asked != nullptr ? std::max(1, std::atoi(asked)) : 7;
    const std::string store = (folder_ / "store.db").string();
    run({"db", "create", "--db", store});
    int passed = 0;
    std::map<std::string, int> by_task;
    for (int i = 0; i < attempts && !HasFailure(); ++i) {
        const auto number = static_cast<std::size_t>(i);
        const std::string task = reread_tasks[number % std::size(reread_tasks)],
                          preset = reread_operators[number / std::size(reread_tasks) % 3];
        const std::string out = (folder_ / ("out" + std::to_string(i))).string();
        const nlohmann::json stored = run_json(
            {"perform", task, "--operator", preset, "--seed", std::to_string(8000 + i), "--db", store});
        ASSERT_TRUE(stored.is_object());
        run({"report", "--attempt", stored["attempt"].get<std::string>(), "--format", "trace", "-o", out,
             "--db", store});
        const nlohmann::json read =
            run_json({"metrics", out + "/trace.csv", "--events", out + "/events.csv", "--task", task});
        ASSERT_TRUE(read.is_object());
        expect_same_score(stored, read, task + ' ' + preset + ' ' + std::to_string(8000 + i) + ' ');
        passed += stored["passed"] == true ? 1 : 0;
        ++by_task[task];
        if (!HasFailure())
            std::cout << i + 1 << ": " << task << ' ' << preset << " reads the same" << std::endl;
        std::filesystem::remove_all(out);
    }
    RecordProperty("attempts", attempts);
    std::cout << attempts << " attempts read again, " << passed << " of them passed";
    for (const auto& [task, count] : by_task) std::cout << ", " << task << ": " << count;
    std::cout << '\n';
    if (attempts >= static_cast<int>(std::size(reread_tasks))) {
        EXPECT_EQ(by_task.size(), std::size(reread_tasks)) << "every task takes its turn";
    }
}

}  // namespace
}  // namespace fulcrum::app
