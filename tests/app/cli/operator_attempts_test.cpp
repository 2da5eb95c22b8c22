// SPDX-License-Identifier: GPL-3.0-or-later
// The attempts of operators that a benchmark set is built from are kept in a file: a build that was cut off
// continues to the same set, and a file that was made with something else is refused and left alone.
#include "app/cli/operator_attempts.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

#include "app/cli/arguments.h"
#include "app/services/program.h"
#include "database/rows/crypto.h"
#include "database/scoring/expert_attempts.h"
#include "tests/assessment/scoring/fixtures.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::operator_attempts_test {
namespace {

using nlohmann::json;

/// Drawn from the seed, without a simulation. One has a row without value, one a critical error.
BenchmarkAttempt drawn(const OperatorJob& job) {
    std::mt19937 random(static_cast<unsigned>(job.seed));
    std::normal_distribution<double> normal;
    const double slower = job.level == OperatorLevel::expert   ? 0
                          : job.level == OperatorLevel::novice ? 1
                                                               : 0.3;
    const double time = std::exp(4.0 + slower + 0.15 * normal(random));
    const double sparc = -1.5 - 0.2 * slower + 0.06 * normal(random);
    std::vector<MetricResult> metrics = fulcrum::test::figures(time, sparc, 1.0 / 3.0, 0);
    if (job.seed == 1203) metrics[2] = fulcrum::test::missing("f_max", "left", Absence::not_done);
    BenchmarkAttempt attempt;
    attempt.person = job.person();
    attempt.metrics = rows_of_gates(fulcrum::test::small_task(), metrics);
    if (job.seed == 1204) attempt.critical_errors.push_back({"perforation", "left", "", 3.25});
    if (job.seed == 1205) attempt.state = AttemptState::timed_out;
    return attempt;
}

AttemptsOrigin small_origin() {
    return {{"task", "T1"},           {"task_sha256", "01"},    {"scene", "t1.json"},
            {"scene_sha256", "02"},   {"fidelity", "standard"}, {"device_class", "haptic"},
            {"program", "1 physics"}, {"program_sha256", "03"}};
}

std::string set_of(const KeptAttempts::Perform& perform, KeptAttempts* kept) {
    BenchmarkRequest request;
    request.source = "synthetic operators";
    request.outliers = false;
    request.familiarisation = request.minimum_familiarisation = 0;
    request.experts = operator_attempts(OperatorLevel::expert, perform, kept);
    request.intermediates = operator_attempts(OperatorLevel::intermediate, perform, kept);
    request.novices = operator_attempts(OperatorLevel::novice, perform, kept);
    const BenchmarkBuild build = build_benchmark(fulcrum::test::small_task(), request);
    EXPECT_TRUE(build.set) << build.refusal.words();
    return build.set ? benchmark_text(*build.set) : std::string();
}

class KeptOperatorAttempts : public ::testing::Test {
  protected:
    std::string content() const {
        std::ifstream in(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }
    void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }
    /// A file with the first attempt of each level.
    void make_file() const {
        KeptAttempts kept(path_, small_origin());
        for (const auto& row : operator_levels) {
            const OperatorJob job = operator_jobs(row.kind).front();
            kept.add(job, drawn(job));
        }
    }
    /// What is wrong with the file, which is left as it is; empty: nothing.
    std::string complaint(const AttemptsOrigin& origin, bool other_program = false) const {
        const std::string before = content();
        std::string said;
        try {
            const KeptAttempts kept(path_, origin, other_program);
        } catch (const InputError& error) {
            said = error.what();
        }
        EXPECT_EQ(content(), before);
        return said;
    }

    fulcrum::test::OwnFolder folder_;
    std::string path_ = (folder_ / "attempts.json").string();
};

TEST_F(KeptOperatorAttempts, ContinueABuildThatWasCutOffToTheSameSet) {
    const std::string whole = set_of(drawn, nullptr);
    const int all = static_cast<int>(count_of_operator_jobs());
    EXPECT_EQ(all, 180);
    std::atomic<int> performed{0};
    {
        KeptAttempts kept(path_, small_origin());
        EXPECT_EQ(kept.size(), 0U);
        const auto cut_off = [&](const OperatorJob& job) {
            if (++performed > 40) throw std::runtime_error("cut off");
            return drawn(job);
        };
        EXPECT_THROW(operator_attempts(OperatorLevel::expert, cut_off, &kept), std::runtime_error);
    }
    performed = 0;
    const auto counted = [&](const OperatorJob& job) {
        ++performed;
        return drawn(job);
    };
    {
        KeptAttempts kept(path_, small_origin());
        EXPECT_EQ(kept.size(), 40U);
        EXPECT_EQ(set_of(counted, &kept), whole);
        EXPECT_EQ(performed.load(), all - 40);
        EXPECT_EQ(kept.size(), count_of_operator_jobs());
    }
    performed = 0;
    const std::string before = content();
    KeptAttempts kept(path_, small_origin());
    EXPECT_EQ(set_of(counted, &kept), whole) << "all from the file";
    EXPECT_EQ(performed.load(), 0);
    EXPECT_EQ(content(), before);
}

TEST_F(KeptOperatorAttempts, OfSomethingElseAreRefusedAndLeftAlone) {
    make_file();
    EXPECT_EQ(complaint(small_origin()), "");
    for (const auto& [key, value] : small_origin()) {
        AttemptsOrigin other = small_origin();
        other[key] = "else";
        const std::string said = complaint(other);
        EXPECT_NE(said.find(key + " " + value + " (now else)"), std::string::npos) << said;
        EXPECT_EQ(said.find("--other-program") != std::string::npos, key == "program_sha256") << said;
        EXPECT_EQ(complaint(other, true).empty(), key == "program_sha256") << key;
    }
}

TEST_F(KeptOperatorAttempts, OfAnotherBuildAreUsedWhereItPerformsTheSame) {
    make_file();
    AttemptsOrigin rebuilt = small_origin();
    rebuilt["program_sha256"] = "04";
    const std::string before = content();
    KeptAttempts kept(path_, rebuilt, true);
    int performed = 0;
    kept.require_same([&](const OperatorJob& job) {
        ++performed;
        return drawn(job);
    });
    EXPECT_EQ(performed, 3) << "one of each level";
    EXPECT_THROW(kept.require_same([](const OperatorJob& job) {
        BenchmarkAttempt attempt = drawn(job);
        if (job.level == OperatorLevel::novice) *attempt.metrics[0].value += 1e-9;
        return attempt;
    }),
                 InputError);
    EXPECT_EQ(content(), before);
    const KeptAttempts same(path_, small_origin());
    same.require_same([](const OperatorJob&) -> BenchmarkAttempt { throw std::logic_error("not needed"); });
}

TEST_F(KeptOperatorAttempts, OfADamagedFileAreRefusedWithWhatToDo) {
    make_file();
    const std::string good = content();
    const json file = json::parse(good);
    const auto changed = [&](const char* patch) { return file.patch(json::parse(patch)).dump(); };
    const std::pair<const char*, std::string> cases[] = {
        {"cut off", good.substr(0, good.size() / 2)},
        {"empty", ""},
        {"another file", R"({"version": 1})"},
        {"a list", "[]"},
        {"no origin", changed(R"([{"op": "remove", "path": "/made_with"}])")},
        {"no list", changed(R"([{"op": "replace", "path": "/attempts", "value": {}}])")},
        {"level", changed(R"([{"op": "replace", "path": "/attempts/0/level", "value": "master"}])")},
        {"state", changed(R"([{"op": "replace", "path": "/attempts/1/state", "value": "done"}])")},
        {"seed", changed(R"([{"op": "replace", "path": "/attempts/1/seed", "value": "x"}])")},
        {"twice", changed(R"([{"op": "copy", "from": "/attempts/0", "path": "/attempts/1"}])")},
        {"no metrics", changed(R"([{"op": "remove", "path": "/attempts/2/metrics"}])")},
        {"version", changed(R"([{"op": "replace", "path": "/attempts/2/metrics/0/version", "value": 99}])")},
    };
    for (const auto& [name, text] : cases) {
        write(text);
        const std::string said = complaint(small_origin());
        EXPECT_NE(said.find(path_), std::string::npos) << name << ": " << said;
        EXPECT_NE(said.find("; name another file, or remove this one"), std::string::npos)
            << name << ": " << said;
    }
    write(cases[6].second);
    const std::string said = complaint(small_origin());
    EXPECT_NE(said.find("/attempts/0"), std::string::npos) << said;
    EXPECT_THROW(KeptAttempts(folder_.path().string(), small_origin()), InputError);
    EXPECT_THROW(KeptAttempts((folder_ / "none/attempts.json").string(), small_origin()), InputError);
}

TEST_F(KeptOperatorAttempts, AreRefusedBeforeAnythingIsPerformed) {
    const LoadedTask loaded = load_task_and_scene("A1");
    AttemptsOrigin origin = attempts_origin(loaded, DeviceClass::haptic);
    EXPECT_EQ(origin.at("program_sha256").size(), 64U);
    EXPECT_EQ(origin.at("program_sha256"), database::program_digest());
    EXPECT_NE(origin, attempts_origin(loaded, DeviceClass::tracked));
    origin["scene_sha256"] = "another";
    const OperatorJob job = operator_jobs(OperatorLevel::expert).front();
    KeptAttempts(path_, origin).add(job, drawn(job));
    const std::string before = content();
    const auto refused = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"benchmark", "build", "A1"});
        try {
            run_command(words);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(refused({"--operators", "--attempts", path_}).find("scene_sha256 another"), std::string::npos);
    EXPECT_NE(refused({"--experts", "a", "--attempts", path_}).find("--experts"), std::string::npos);
    EXPECT_NE(refused({"--operators", "--other-program"}).find("needs --attempts"), std::string::npos);
    EXPECT_EQ(content(), before);
    const std::string both = (folder_ / "both.json").string();
    EXPECT_NE(refused({"--operators", "--attempts", both, "-o", both}).find("name two files"),
              std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app::operator_attempts_test
