// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt is held against limits of its own task, variant, device class, fidelity and tissue only; against
// any others it is not comparable and says why. Limits in force at the start of an attempt stay its limits.
#include <gtest/gtest.h>

#include <QByteArray>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/attempt_document.h"
#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "assessment/metrics/statement_words.h"
#include "assessment/scoring/taken_over.h"
#include "database/records/attempts.h"
#include "database/scoring/benchmark_files.h"
#include "database/scoring/limit_trial.h"
#include "database/scoring/loaded_task.h"
#include "database/scoring/rescoring.h"
#include "database/scoring/scoring.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"

namespace fulcrum::app::program_test {
namespace {

using nlohmann::json;

/// With a copy of the assets that a test may change.
class OwnLimits : public ::testing::Test {
  protected:
    OwnLimits() {
        std::filesystem::copy(fulcrum::test::source_path("assets"), assets_,
                              std::filesystem::copy_options::recursive);
        qputenv("FULCRUM_ASSETS", QByteArray::fromStdString(assets_.string()));
    }
    ~OwnLimits() override {
        if (before_.isNull()) {
            qunsetenv("FULCRUM_ASSETS");
        } else {
            qputenv("FULCRUM_ASSETS", before_);
        }
    }
    struct Outcome {
        int status;
        std::string errors;
        json document;
    };
    static Outcome run(std::vector<std::string> words) {
        std::ostringstream out, errors;
        std::streambuf* const before_out = std::cout.rdbuf(out.rdbuf());
        std::streambuf* const before_errors = std::cerr.rdbuf(errors.rdbuf());
        int status = 2;
        try {
            status = run_command(words);
        } catch (const InputError& error) {  // as the program does
            errors << error.what();
        }
        std::cout.rdbuf(before_out);
        std::cerr.rdbuf(before_errors);
        return {status, errors.str(), out.str().empty() ? json() : json::parse(out.str())};
    }
    json perform(std::vector<std::string> words) const {
        words.insert(words.begin(), "perform");
        words.insert(words.end(), {"--seed", "2001", "--db", store_, "--json"});
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        return outcome.document;
    }
    void change_set(const std::string& name, const std::function<void(json&)>& change) const {
        const std::filesystem::path file = assets_ / "benchmarks" / (name + ".json");
        json set = json::parse(std::ifstream(file));
        change(set);
        std::ofstream(file) << set.dump(1);
    }

    fulcrum::test::OwnFolder folder_;
    std::filesystem::path assets_ = folder_ / "assets";
    std::string store_ = (folder_ / "fulcrum.db").string();
    QByteArray before_ = qgetenv("FULCRUM_ASSETS");
};

TEST_F(OwnLimits, AreFoundByTaskVariantDeviceClassAndFidelity) {
    const LoadedTask a2 = load_task_and_scene("A2");
    const Limits haptic = limits_for(a2.task, a2.scene, DeviceClass::haptic);
    ASSERT_NE(haptic.comparable(), nullptr);
    EXPECT_EQ(haptic.name(), "A2-provisional@" + std::to_string(haptic.set->version));
    for (const DeviceClass free_hand : {DeviceClass::synthetic, DeviceClass::external})
        EXPECT_EQ(limits_for(a2.task, a2.scene, free_hand).name(), haptic.name());

    const Limits controller = limits_for(a2.task, a2.scene, DeviceClass::controller);
    EXPECT_EQ(controller.comparable(), nullptr);
    EXPECT_EQ(controller.name(), "");
    EXPECT_EQ(words_of(controller.not_comparable),
              "not comparable: there are no limits for this device class (game controller)");

    const LoadedTask fast = load_task_and_scene("A2", "fast");
    EXPECT_EQ(words_of(limits_for(fast.task, fast.scene, DeviceClass::haptic).not_comparable),
              "not comparable: the limits are for fidelity standard, the attempt used fast");

    LoadedTask slim = load_task_and_scene(TaskRequest{"B1", "slim", {}});
    EXPECT_EQ(limits_for(slim.task, slim.scene, DeviceClass::haptic).name().substr(0, 14), "B1-provisional")
        << "its family is standard";
    for (TaskVariant& variant : slim.task.variants) variant.family = variant.id;
    EXPECT_EQ(words_of(limits_for(slim.task, slim.scene, DeviceClass::haptic).not_comparable),
              "not comparable: the limits are for variant standard, the attempt used slim");
    const LoadedTask long_jaws = load_task_and_scene(TaskRequest{"B1", "long_jaws", {}});
    for (const DeviceClass own : {DeviceClass::haptic, DeviceClass::tracked})
        EXPECT_EQ(limits_for(long_jaws.task, long_jaws.scene, own).name().substr(0, 12), "B1-long_jaws")
            << "long jaws press harder than the standard ones";

    const LoadedTask b0 = load_task_and_scene("B0");
    EXPECT_TRUE(limits_for(b0.task, b0.scene, DeviceClass::controller).not_comparable.empty())
        << "it has no gates based on a set";

    change_set("A2", [](json& set) { set["device_class"] = "controller"; });
    EXPECT_THROW(limits_for(a2.task, a2.scene, DeviceClass::haptic), InputError)
        << "the file's name promises another set";
    std::filesystem::rename(assets_ / "benchmarks/A2.json", assets_ / "benchmarks/A2-controller.json");
    EXPECT_EQ(limits_for(a2.task, a2.scene, DeviceClass::controller).name(),
              "A2-controller" + haptic.name().substr(2));
}

TEST_F(OwnLimits, OfAFamilyJudgeAttemptsAtEachOfItsVariants) {
    const json standard = perform({"A2", "--practice"}), deep = perform({"A2", "--variant", "deep"});
    EXPECT_EQ(standard["variant"], "standard");
    EXPECT_EQ(deep["variant"], "deep");
    EXPECT_NE(deep["state_hash"], standard["state_hash"]);
    EXPECT_EQ(deep["passed"], true) << deep["advice"];
    EXPECT_EQ(deep["gates"][0]["limit"], standard["gates"][0]["limit"]);
    const database::Store store = database::Store::open(store_);
    const database::Attempts attempts(store);
    const database::AttemptSummary stored =
        attempts.read(store.station_session(), deep["attempt"].get<std::string>());
    EXPECT_EQ(stored.meta.variant, "deep");
    EXPECT_EQ(stored.meta.scene, "a2_targets_deep.json");
    EXPECT_TRUE(attempts.stale_scores(store.station_session(), scoring_in_force()).empty())
        << "the set of its family is in force";
    const auto practised = attempts.practised(store.station_session(), stored.meta.person_id, "A2");
    ASSERT_EQ(practised.size(), 2U);
    EXPECT_EQ(practised.at("standard").attempts, 1);
    EXPECT_EQ(practised.at("standard").passes, 0) << "practice";
    EXPECT_EQ(practised.at("deep").passes, 1);

    const Outcome unknown = run({"perform", "A2", "--variant", "none", "--db", store_});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_NE(unknown.errors.find("has no variant \"none\""), std::string::npos) << unknown.errors;
    std::filesystem::copy_file(assets_ / "scenes/a2_targets.json", assets_ / "scenes/a2_targets_deep.json",
                               std::filesystem::copy_options::overwrite_existing);
    const Outcome mixed_up = run({"perform", "A2", "--variant", "deep", "--db", store_});
    EXPECT_EQ(mixed_up.status, 2);
    EXPECT_NE(mixed_up.errors.find("is \"standard\", but task A2 lists it as \"deep\""), std::string::npos)
        << mixed_up.errors;
}

TEST_F(OwnLimits, OfTheStandardFidelityDoNotJudgeTheFastOne) {
    const json attempt = perform({"A2", "--fidelity", "fast"});
    EXPECT_TRUE(attempt["passed"].is_null());
    EXPECT_TRUE(attempt["points"].is_null());
    EXPECT_EQ(attempt["not_scored_because"],
              "not comparable: the limits are for fidelity standard, the attempt used fast");
    for (const json& gate : attempt["gates"]) {
        const bool absolute = gate["kind"] == "absolute";
        EXPECT_EQ(gate["passed"].is_null(), !absolute) << gate;
        EXPECT_EQ(gate["absent_because"].is_null(), absolute) << gate;
    }
}

TEST_F(OwnLimits, PracticeIsAllThatOtherDevicesAreFor) {
    const Outcome outcome = run({"perform", "B1", "--device-class", "controller", "--db", store_});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.errors.find("attempts with game controller are not assessed, they are practice only"),
              std::string::npos)
        << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(store_)) << "said before anything begins";
    const TaskDefinition b1 = load_task(task_file("B1"));
    EXPECT_FALSE(can_be_assessed(b1, DeviceClass::mouse_keyboard));
    EXPECT_TRUE(can_be_assessed(b1, DeviceClass::haptic));
    EXPECT_TRUE(can_be_assessed(b1, DeviceClass::synthetic));
}

TEST_F(OwnLimits, StayThoseOfTheStartWhenTheSetIsReplaced) {
    const json first = perform({"A2"});
    ASSERT_EQ(first["passed"], true) << first["advice"];
    const LoadedTask a2 = load_task_and_scene("A2");
    const std::string old_name = limits_for(a2.task, a2.scene, DeviceClass::synthetic).name();
    change_set("A2", [](json& set) {
        set["version"] = set["version"].get<int>() + 1;
        for (json& level : set["levels"])
            if (level["metric"] == "time") level["mean"] = level["mean"].get<double>() - 2;
    });
    const std::string new_name = limits_for(a2.task, a2.scene, DeviceClass::synthetic).name();
    EXPECT_NE(new_name, old_name);
    const json second = perform({"A2"});
    EXPECT_EQ(second["passed"], false);
    EXPECT_EQ(second["state_hash"], first["state_hash"]);

    const database::Store store = database::Store::open(store_);
    const database::Session station = store.station_session();
    const database::Attempts attempts(store);
    const auto in_force = [&](const json& attempt) {
        return *attempts.score(station, attempt["attempt"].get<std::string>());
    };
    EXPECT_EQ(in_force(first).passed, true);
    EXPECT_EQ(in_force(first).limits, old_name);
    EXPECT_EQ(in_force(second).limits, new_name);
    // The export has the score in force.
    const std::string exported = (folder_ / "exported").string();
    export_trace(store, station, first["attempt"].get<std::string>(), exported);
    const json document = json::parse(std::ifstream(exported + "/attempt.json"));
    EXPECT_EQ(document["passed"], true);
    EXPECT_EQ(document["points"], first["points"]);
    EXPECT_TRUE(document["continues"].is_null());
    EXPECT_EQ(document["state"], "completed");
    EXPECT_TRUE(document.at("voided").is_null());
    ASSERT_EQ(document["gates"].size(), first["gates"].size());
    for (std::size_t i = 0; i < first["gates"].size(); ++i)
        for (const char* key : {"metric", "hand", "value", "limit", "points", "passed"})
            EXPECT_EQ(document["gates"][i][key], first["gates"][i][key]) << i << key;
    ASSERT_EQ(document["metrics"].size(), first["metrics"].size());
    for (std::size_t i = 0; i < first["metrics"].size(); ++i)
        for (const char* key :
             {"id", "version", "hand", "tissue", "value", "absent_code", "absence", "count"})
            EXPECT_EQ(document["metrics"][i].value(key, json()), first["metrics"][i].value(key, json()))
                << i << key;
    // What was interrupted is scored later, and not by limits that came after its start.
    EXPECT_EQ(limits_at_start(a2.task, a2.scene, DeviceClass::synthetic, new_name).name(), new_name);
    const Limits replaced = limits_at_start(a2.task, a2.scene, DeviceClass::synthetic, old_name);
    EXPECT_EQ(replaced.comparable(), nullptr);
    EXPECT_EQ(replaced.not_comparable, Statement(StatementId::limits_replaced));
}

TEST_F(OwnLimits, OfASiteThatTookTheTasksOverAreFirmUntilTheTaskChangesThem) {
    const TaskDefinition task = load_task((assets_ / "tasks/A2.json").string());
    const auto judged = [&] {
        const json attempt = perform({"A2"});
        EXPECT_EQ(attempt["passed"], true) << attempt["advice"];
        std::vector<std::string> provisional;
        for (const json& gate : attempt["gates"])
            if (gate["provisional"] == true)
                provisional.push_back(gate["metric"].get<std::string>() + " " +
                                      gate["hand"].get<std::string>());
        const database::Store store = database::Store::open(store_);
        EXPECT_EQ(database::Attempts(store)
                      .read(store.station_session(), attempt["attempt"].get<std::string>())
                      .provisional,
                  !provisional.empty());
        return provisional;
    };
    change_set("A2", [](json& set) { set["provisional"] = false; });
    EXPECT_EQ(judged(),
              (std::vector<std::string>{"f_max left", "f_max right", "off_screen left", "off_screen right"}));
    change_set("A2", [&](json& set) {
        set["version"] = set["version"].get<int>() + 1;
        set["taken_over"] = taken_over_to_json(limits_to_take_over(task));
    });
    EXPECT_EQ(judged(), std::vector<std::string>());
    json newer = json::parse(std::ifstream(assets_ / "tasks/A2.json"));
    for (json& gate : newer["gates"])
        if (gate["metric"] == "off_screen") gate["limit"] = 31;
    std::ofstream(assets_ / "tasks/A2.json") << newer.dump(1);
    EXPECT_EQ(judged(), (std::vector<std::string>{"off_screen left", "off_screen right"}));
}

TEST_F(OwnLimits, ATaskWithFewerTargetsIsPractisedAndTheCommandSaysWhy) {
    json task = json::parse(std::ifstream(assets_ / "tasks/A2.json"));
    for (json& goal : task["goals"]) goal["count"] = 4;
    std::ofstream(assets_ / "tasks/A2.json") << task.dump(1);
    const Outcome outcome = run({"perform", "A2", "--seed", "2001", "--db", store_, "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.document["mode"], "practice");
    const std::string said =
        "practice only: these files are neither part of this program nor accepted by "
        "the programme: tasks/A2.json (sha256 ";
    EXPECT_NE(outcome.errors.find(said), std::string::npos) << outcome.errors;
}

TEST_F(OwnLimits, ThatWereReplacedAreKnownAsProvisionalFromTheirKeptCopy) {
    const json first = perform({"A2"});
    const LoadedTask a2 = load_task_and_scene("A2");
    const Limits begun = limits_for(a2.task, a2.scene, DeviceClass::synthetic);
    ASSERT_TRUE(begun.set && begun.set->provisional);
    const database::Store store = database::Store::open(store_);
    const database::Session station = store.station_session();
    const database::Attempts attempts(store);
    const std::string id = first["attempt"].get<std::string>();
    const std::vector<database::AssetFile> assets = attempts.assets(station, id);
    const auto replaced_limits = [&] {
        return limits_at_start(a2.task, a2.scene, DeviceClass::synthetic, begun.name(), assets);
    };
    EXPECT_FALSE(replaced_limits().replaced_provisional) << "they are still in force";
    keep_superseded((assets_ / "benchmarks/A2.json").string(), begun.set->version);
    change_set("A2", [](json& set) {
        set["version"] = set["version"].get<int>() + 1;
        set["provisional"] = false;
    });
    const Limits replaced = replaced_limits();
    EXPECT_EQ(replaced.not_comparable, Statement(StatementId::limits_replaced));
    EXPECT_TRUE(replaced.replaced_provisional);
    const ScoredAttempt scored = score_stored(attempts, station, attempts.read(station, id), a2, replaced);
    int marked = 0;
    for (const GateResult& gate : scored.score.gates) {
        if (gate.kind != GateKind::benchmark) continue;
        ++marked;
        EXPECT_TRUE(gate.provisional) << gate.metric;
        EXPECT_FALSE(gate.limit.has_value()) << gate.metric;
    }
    EXPECT_GT(marked, 0);
    EXPECT_FALSE(scored.score.passed.has_value()) << "it is not held against other limits";
    std::filesystem::remove_all(assets_ / "benchmarks/superseded");
    EXPECT_FALSE(replaced_limits().replaced_provisional) << "nobody knows";
}

TEST_F(OwnLimits, ThatHaveToBeBuiltAgainJudgeNothingAndStopNothing) {
    const json first = perform({"A2"});
    ASSERT_EQ(first["passed"], true) << first["advice"];
    const LoadedTask a2 = load_task_and_scene("A2");
    const std::string old_name = limits_for(a2.task, a2.scene, DeviceClass::synthetic).name();
    const std::size_t sets = sets_in_force("A2").size();
    std::string metric;
    change_set("A2", [&](json& set) {  // as after an update that changes one of its metrics
        json& level = set["levels"][0];
        metric = level["metric"].get<std::string>();
        level["metric_version"] = level["metric_version"].get<int>() + 1;
    });
    const Limits limits = limits_for(a2.task, a2.scene, DeviceClass::synthetic);
    EXPECT_EQ(limits.comparable(), nullptr);
    EXPECT_EQ(limits.name(), "");
    EXPECT_EQ(limits.not_comparable, Statement(StatementId::limits_outdated, {{"metric", metric}}));
    EXPECT_EQ(limits_at_start(a2.task, a2.scene, DeviceClass::synthetic, old_name).not_comparable,
              limits.not_comparable);
    EXPECT_EQ(sets_in_force("A2").size(), sets - 1) << "the others are listed";
    EXPECT_THROW(load_benchmark((assets_ / "benchmarks/A2.json").string()), OutdatedSet);

    const json second = perform({"A2"});
    EXPECT_TRUE(second["passed"].is_null());
    EXPECT_EQ(second["not_scored_because"], words_of(limits.not_comparable));
    const database::Store store = database::Store::open(store_);
    const std::vector<database::StaleScore> stale =
        database::Attempts(store).stale_scores(store.station_session(), scoring_in_force());
    ASSERT_EQ(stale.size(), 1U);
    EXPECT_EQ(stale.front().attempt_id, first["attempt"].get<std::string>());
}

TEST_F(OwnLimits, OfTheNamedDeviceAndFidelityJudgeATraceFile) {
    const json attempt = perform({"A2"});
    {
        const database::Store store = database::Store::open(store_);
        export_trace(store, store.station_session(), attempt["attempt"].get<std::string>(),
                     (folder_ / "trace").string());
    }
    const auto verdict = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"metrics",  (folder_ / "trace/trace.csv").string(),
                                          "--events", (folder_ / "trace/events.csv").string(),
                                          "--task",   "A2",
                                          "--json"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        return outcome.document;
    };
    for (const std::vector<std::string>& same : std::vector<std::vector<std::string>>{
             {}, {"--device-class", "haptic"}, {"--device-class", "synthetic", "--fidelity", "standard"}}) {
        const json document = verdict(same);
        EXPECT_EQ(document["passed"], attempt["passed"]);
        EXPECT_EQ(document["fidelity"], "standard");
    }
    const json controller = verdict({"--device-class", "controller"});
    EXPECT_TRUE(controller["passed"].is_null());
    EXPECT_EQ(controller["device_class"], "controller");
    EXPECT_EQ(controller["not_scored_because"],
              "not comparable: there are no limits for this device class (game controller)");
    EXPECT_TRUE(verdict({"--fidelity", "fast"})["passed"].is_null());
}

}  // namespace
}  // namespace fulcrum::app::program_test
