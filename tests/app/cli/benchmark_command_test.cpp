// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum benchmark build from stored attempts and fulcrum assets accept of what it made: which provisional
// limits of the task the set takes over, and that simulated people make no limits of a site.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "assessment/scoring/taken_over.h"
#include "database/store/accepted_assets.h"
#include "database/store/audit.h"
#include "sim_core/numerics/input_error.h"
#include "tests/database/expert_values.h"
#include "tests/database/large_programme.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::benchmark_command_test {
namespace {

using nlohmann::json;

constexpr int surgeons = 10, attempts_of_surgeon = 6;

/// Ten surgeons, whose educator has the login ed.
class BenchmarkCommand : public ::testing::Test {
  protected:
    BenchmarkCommand() {
        const database::Store store = database::Store::create(store_);
        const BenchmarkSet delivered = load_benchmark(asset_path("benchmarks/A2.json"));
        const auto programme = database::test::make_large_programme(
            store, surgeons, attempts_of_surgeon, 1, 7, {"A2"},
            [&](database::ScoreRow& score, Random& random) {
                database::test::write_expert_values(task_, delivered, random.uniform(-0.7, 0.7), score);
            },
            task_.version);
        const database::People people(store);
        const database::Session administrator = people.sign_in("administrator", "correct horse battery");
        const auto made = people.create(administrator, "ed", "Ed Educator", {database::Role::educator});
        const database::Session ed = people.change_password(people.sign_in("ed", made.one_time_password),
                                                            made.one_time_password, "a long password");
        people.set_educators(programme.director, programme.cohort, {ed.person_id()});
        std::ofstream(password_) << "a long password\n";
    }
    std::string run(std::vector<std::string> words) const {
        words.insert(words.end(), {"--db", store_, "--as", "ed", "--password-file", password_});
        std::ostringstream output;
        struct Redirected {
            std::streambuf* before;
            ~Redirected() { std::cout.rdbuf(before); }
        };
        const Redirected redirected{std::cout.rdbuf(output.rdbuf())};
        EXPECT_EQ(run_command(words), 0);
        return output.str();
    }
    json run_json(std::vector<std::string> words) const {
        words.emplace_back("--json");
        return json::parse(run(std::move(words)));
    }
    static std::vector<std::string> build_words() {
        std::string logins;
        for (int i = 0; i < surgeons; ++i)
            logins += (i == 0 ? "trainee" : ",trainee") + std::to_string(1000 + i);
        return {"benchmark", "build", "A2", "--experts", logins};
    }
    std::vector<std::string> accept_words() const { return {"assets", "accept", set_, "--reason", "ours"}; }
    std::vector<std::string> build_to_file() const {
        std::vector<std::string> words = build_words();
        words.insert(words.end(), {"--output", set_});
        return words;
    }
    void change_set(const std::function<void(json&)>& change) const {
        json set = json::parse(std::ifstream(set_));
        change(set);
        std::ofstream(set_) << set.dump(2);
    }
    /// What is wrong with the file for `assets accept`; empty: it was accepted.
    std::string refused() const {
        try {
            run(accept_words());
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

    fulcrum::test::OwnFolder folder_;
    std::string store_ = (folder_ / "fulcrum.db").string(), password_ = (folder_ / "password.txt").string(),
                set_ = (folder_ / "ours.json").string();
    TaskDefinition task_ = load_task(task_file("A2"));
    std::vector<ProvisionalLimit> limits_ = limits_to_take_over(task_);
};

TEST_F(BenchmarkCommand, NamesTheLimitsOfTheTaskThatTheSetTakesOver) {
    ASSERT_EQ(limits_.size(), 4U);
    const std::string line = "takes over as limits of this site: " + provisional_words(limits_) + "\n";
    EXPECT_NE(line.find("f_max left at most 4.0 N; "), std::string::npos) << line;
    const std::string built = run(build_to_file());
    EXPECT_NE(built.find(line), std::string::npos) << built;
    const json document = run_json(build_words());
    EXPECT_EQ(document["takes_over"], taken_over_to_json(limits_));
    EXPECT_EQ(document["set"]["taken_over"], document["takes_over"]);
    EXPECT_EQ(document["set"]["provisional"], false);
    EXPECT_EQ(json::parse(std::ifstream(set_))["taken_over"], document["takes_over"]);

    const std::string accepted = run(accept_words());
    EXPECT_NE(accepted.find(line), std::string::npos) << accepted;
    EXPECT_EQ(accepted.find("still provisional"), std::string::npos) << accepted;
    const database::Store store = database::Store::open(store_);
    database::AuditFilter filter;
    filter.kind = "asset.accept";
    const std::vector<database::AuditEntry> entries = database::Audit(store).entries(
        database::People(store).sign_in("administrator", "correct horse battery"), filter);
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(json::parse(entries[0].payload)["takes_over"], provisional_words(limits_));
}

TEST_F(BenchmarkCommand, NamesWhatAnAcceptedSetLeavesProvisional) {
    run(build_to_file());
    change_set([](json& set) {
        set["taken_over"][0]["limit"] = 5;
        set["taken_over"].erase(3);
    });
    const json accepted = run_json(accept_words());
    EXPECT_EQ(accepted["file"], "benchmarks/A2.json");
    EXPECT_EQ(accepted["takes_over"], taken_over_to_json({limits_[1], limits_[2]}));
    ASSERT_EQ(accepted["left_provisional"].size(), 2U);
    EXPECT_EQ(accepted["left_provisional"][0]["metric"], limits_[0].metric);
    EXPECT_EQ(accepted["left_provisional"][0]["limit"], limits_[0].limit);
    EXPECT_EQ(accepted["left_provisional"][0]["taken_over"], 5.0);
    EXPECT_EQ(accepted["left_provisional"][1]["metric"], limits_[3].metric);
    EXPECT_TRUE(accepted["left_provisional"][1]["taken_over"].is_null());
    // One from before limits were taken over.
    change_set([](json& set) {
        set.erase("taken_over");
        set["version"] = 90;
    });
    const std::string older = run(accept_words());
    EXPECT_EQ(older.find("takes over"), std::string::npos) << older;
    for (const ProvisionalLimit& limit : limits_)
        EXPECT_NE(older.find("still provisional: " + provisional_words(limit) + "\n"), std::string::npos)
            << older;
}

TEST_F(BenchmarkCommand, DoesNotAcceptASetThatCannotBeRead) {
    run(build_to_file());
    change_set([](json& set) { set["taken_over"][0]["hand"] = nullptr; });
    const std::string fault = refused();
    EXPECT_NE(fault.find("(/taken_over/0/hand)"), std::string::npos) << fault;
    const database::Store store = database::Store::open(store_);
    EXPECT_TRUE(database::AcceptedAssets(store).list().empty());
}

TEST_F(BenchmarkCommand, MakesNoLimitsOfASiteFromSimulatedPeople) {
    {
        const database::Store store = database::Store::open(store_);
        store.connection().execute("UPDATE person SET kind = 'synthetic' WHERE login LIKE 'trainee%'");
    }
    const std::string built = run(build_to_file());
    EXPECT_NE(built.find("provisional: made of simulated attempts"), std::string::npos) << built;
    EXPECT_EQ(built.find("takes over as"), std::string::npos) << built;
    const json document = run_json(build_words());
    EXPECT_TRUE(document["takes_over"].empty());
    EXPECT_EQ(document["set"]["provisional"], true);
    EXPECT_FALSE(document["set"].contains("taken_over"));
    EXPECT_EQ(document["set"]["source"].get<std::string>().rfind("synthetic operators", 0), 0U);
    // Nor by an edit of the file.
    change_set([&](json& set) { set["taken_over"] = taken_over_to_json(limits_); });
    EXPECT_NE(refused().find("(/taken_over): a provisional set takes over no limits"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app::benchmark_command_test
