// SPDX-License-Identifier: GPL-3.0-or-later
// Curricula and benchmark sets that an educator puts in force at one station come into force at the others.
#include "database/scoring/asset_placing.h"

#include <filesystem>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum_draft.h"
#include "assessment/scoring/benchmark_builder.h"
#include "database/records/curricula.h"
#include "database/records/curriculum_publishing.h"
#include "database/rows/crypto.h"
#include "database/scoring/benchmark_files.h"
#include "database/scoring/expert_attempts.h"
#include "database/sync/enrolment.h"
#include "database/sync/server_enrolment.h"
#include "database/sync/server_link.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"
#include "tests/support/own_folder.h"

namespace fulcrum::database::test {
namespace {

namespace fs = std::filesystem;

/// A copy of the assets folder's curricula and benchmark sets.
struct AssetFolder {
    AssetFolder() {
        for (const char* name : {"curricula", "benchmarks"})
            fs::copy(asset_path(name), folder / name, fs::copy_options::recursive);
        std::vector<InstalledTask> tasks;
        for (const std::string& id : task_ids()) tasks.push_back(installed_task(load_task(task_file(id))));
        place = {folder.path().string(), tasks, load_forms(asset_path("forms"))};
    }
    Curriculum curriculum() const {
        return load_versions((folder / "curricula").string(), "rectal", task_ids());
    }
    std::string next_curriculum(const std::string& title) const {
        Curriculum draft = curriculum();
        draft.version = draft.next_own_version();
        draft.title = title;
        return curriculum_text(draft);
    }
    void publish_curriculum(const Store& store, const Session& educator, const std::string& title) const {
        database::publish_curriculum(store, educator,
                                     {(folder / "curricula").string(), place.tasks, place.forms},
                                     curriculum(), next_curriculum(title), "better");
    }
    BenchmarkSet set() const { return load_benchmark((folder / "benchmarks" / "A2.json").string()); }
    /// The set in force with another source, as the next version.
    void publish_set(const Store& store, const Session& educator, const std::string& source) const {
        BenchmarkSet next = set();
        ++next.version;
        next.source = source;
        publish_benchmark(store, educator, (folder / "benchmarks").string(), next, "our own experts");
    }
    std::vector<PlacedAsset> take(const Store& store) const { return place_accepted_assets(store, place); }
    fulcrum::test::OwnFolder folder;
    AssetPlace place;
};

void expect_placed(const std::vector<PlacedAsset>& placed, std::size_t count) {
    EXPECT_EQ(placed.size(), count);
    for (const PlacedAsset& one : placed)
        EXPECT_FALSE(one.refused) << one.file.name << ": " << one.refused->words();
}

class AssetPlacing : public Sync {
  protected:
    /// The second station has what the first sent.
    void join() {
        sync(a);
        sync(b);
    }
    /// An attempt that names the folder's curriculum and its file, as the program stores it.
    static void record(const std::string& path, const ManualClock& clock, const Session& trainee,
                       const AssetFolder& at) {
        const Curriculum curriculum = at.curriculum();
        AttemptMeta meta = example_meta(trainee.person_id());
        meta.curriculum = curriculum.name();
        meta.assets.push_back({"curricula/" + curriculum.file, sha256_hex(curriculum.text)});
        Recorder recorder(path, trainee, meta, clock.options());
        Programme::append_second(recorder);
        recorder.finish(example_result(true, 70));
    }
    Station b;
    AssetFolder at_a, at_b;
    std::string refusal(const AssetFile& file, const std::string& text) {
        AcceptedAssets(*a.store).accept(a.session("educator"), file, "looks right", text);
        for (const PlacedAsset& one : at_b.take(*a.store))
            if (one.file.digest == file.digest && one.refused) return one.refused->words();
        return "";
    }
};

TEST_F(AssetPlacing, BringsACurriculumAndASetToTheOtherStation) {
    at_a.publish_curriculum(*a.store, a.session("educator"), "Two more days");
    at_a.publish_set(*a.store, a.session("educator"), "experts of ward 3");
    EXPECT_TRUE(at_a.take(*a.store).empty()) << "both are in place where they were published";
    join();
    const int before = at_b.set().version;
    expect_placed(at_b.take(*b.store), 2);
    EXPECT_EQ(at_b.curriculum().title, "Two more days");
    EXPECT_EQ(at_b.curriculum().version, at_a.curriculum().version);
    EXPECT_EQ(at_b.set().source, "experts of ward 3");
    EXPECT_EQ(version_in_file(
                  (at_b.folder / "benchmarks" / "superseded" / ("A2@" + std::to_string(before) + ".json"))
                      .string()),
              before)
        << "what was replaced is kept";
    EXPECT_TRUE(at_b.take(*b.store).empty()) << "nothing is done twice";
    // Assessed attempts accept both files.
    const AcceptedAssets accepted(*b.store);
    for (const char* name : {"curricula/rectal-1001.json", "benchmarks/A2.json"}) {
        const std::string text = read_text_file((at_b.folder / name).string(), JsonLimits().bytes);
        EXPECT_TRUE(accepted.unknown({{name, sha256_hex(text)}}).empty()) << name;
    }
    expect_sound(*b.store);
    expect_sound(server);
}

TEST_F(AssetPlacing, OfTwoSetsOfOneVersionTheOneAcceptedFirstCountsEverywhere) {
    join();
    at_a.publish_set(*a.store, a.session("educator"), "ward 3");
    b.clock.pass_s(60);
    a.clock.pass_s(120);
    at_b.publish_set(*b.store, b.sign_in("educator"), "ward 5");
    sync(a);
    sync(b);
    sync(a);
    at_a.take(*a.store);
    at_b.take(*b.store);
    EXPECT_EQ(at_a.set().source, "ward 3");
    EXPECT_EQ(at_b.set().source, "ward 3");
    EXPECT_TRUE(at_a.take(*a.store).empty());
    EXPECT_TRUE(at_b.take(*b.store).empty());
}

TEST_F(AssetPlacing, OfTwoCurriculaOfOneVersionNoneIsReplacedAndTheReasonIsPrinted) {
    join();
    at_a.publish_curriculum(*a.store, a.session("educator"), "First");
    b.clock.pass_s(60);
    at_b.publish_curriculum(*b.store, b.sign_in("educator"), "Second");
    sync(a);
    sync(b);
    const std::vector<PlacedAsset> placed = at_b.take(*b.store);
    ASSERT_EQ(placed.size(), 1U);
    ASSERT_TRUE(placed[0].refused);
    EXPECT_NE(placed[0].refused->words().find("publishes the next version"), std::string::npos);
    EXPECT_EQ(at_b.curriculum().title, "Second") << "people may follow it already";
    EXPECT_TRUE(at_a.take(*a.store).empty());
    AssetFolder neither;
    expect_placed(neither.take(*b.store), 1);
    EXPECT_EQ(neither.curriculum().title, "First");
}

TEST_F(AssetPlacing, OfTwoCurriculaOfOneVersionEachIsFollowedWhereItWasPublished) {
    join();
    at_a.publish_curriculum(*a.store, a.session("educator"), "First");
    b.clock.pass_s(60);
    at_b.publish_curriculum(*b.store, b.sign_in("educator"), "Second");
    record(a.path, a.clock, a.session("ann"), at_a);
    sync(a);
    sync(b);
    const Curricula here(*a.store), there(*b.store);
    EXPECT_NO_THROW(here.check(at_a.curriculum()));
    EXPECT_NO_THROW(there.check(at_b.curriculum())) << "nobody has begun with it";
    record(b.path, b.clock, b.sign_in("ben"), at_b);
    sync(b);
    sync(a);
    EXPECT_NO_THROW(here.check(at_a.curriculum()));
    EXPECT_NO_THROW(there.check(at_b.curriculum()));
    // Edited by hand it is refused as ever, also where an educator accepts the change.
    Curriculum edited = at_b.curriculum();
    edited.text += " ";
    EXPECT_THROW(here.check(edited), InputError);
    EXPECT_THROW(there.check(edited), InputError);
    AcceptedAssets(*b.store).accept(b.sign_in("educator"),
                                    {"curricula/" + edited.file, sha256_hex(edited.text)}, "looks right");
    EXPECT_THROW(there.check(edited), InputError);
}

TEST_F(AssetPlacing, PutsNothingInPlaceThatIsNotWhatWasAccepted) {
    const std::string good = at_a.next_curriculum("Good");
    // Contents that are not those of the digest; a name that such a file does not have; one that leaves the
    // folder; no curriculum at all.
    EXPECT_NE(refusal({"curricula/rectal-1001.json", sha256_hex("other")}, good).find("not those"),
              std::string::npos);
    EXPECT_NE(refusal({"curricula/rectal-7.json", sha256_hex(good)}, good).find("rectal-1001.json"),
              std::string::npos);
    const std::string set = benchmark_text(at_a.set());
    EXPECT_NE(refusal({"benchmarks/../tasks/A2.json", sha256_hex(set + "\n")}, set + "\n").find("A2.json"),
              std::string::npos);
    EXPECT_NE(refusal({"curricula/x.json", sha256_hex("{}")}, "{}"), "");
    EXPECT_EQ(at_b.curriculum().title, at_a.curriculum().title);
    EXPECT_FALSE(fs::exists(at_b.folder / "tasks"));
}

TEST_F(AssetPlacing, ANewerSetOfTheProgramStaysAndAFolderThatCannotBeWrittenIsNamed) {
    at_a.publish_set(*a.store, a.session("educator"), "ward 3");
    BenchmarkSet newer = at_b.set();
    newer.version += 5;
    const std::string path = (at_b.folder / "benchmarks" / "A2.json").string();
    std::ofstream(path) << benchmark_text(newer);
    EXPECT_TRUE(at_b.take(*a.store).empty());
    EXPECT_EQ(at_b.set().version, newer.version);
    AssetFolder none;
    fs::remove_all(none.folder / "benchmarks");
    const std::vector<PlacedAsset> placed = none.take(*a.store);
    ASSERT_EQ(placed.size(), 1U);
    ASSERT_TRUE(placed[0].refused);
    EXPECT_NE(placed[0].refused->words().find("cannot be written"), std::string::npos);
    // Something else has the name: named as well, whoever runs the program.
    fs::create_directories(none.folder / "benchmarks" / "A2.json");
    ASSERT_EQ(none.take(*a.store).size(), 1U);
    EXPECT_TRUE(none.take(*a.store)[0].refused);
}

TEST_F(AssetPlacing, OfOneVersionAnAcceptedSetCountsBeforeThatOfANewerProgram) {
    const fs::path path = at_b.folder / "benchmarks" / "A2.json";
    const auto put = [&](const BenchmarkSet& set) { std::ofstream(path) << benchmark_text(set); };
    BenchmarkSet of_program = at_b.set();
    ++of_program.version;
    BenchmarkSet earlier = of_program;
    earlier.source = "ward 1";
    // Its contents are not kept.
    AcceptedAssets(*a.store).accept(a.session("educator"),
                                    {"benchmarks/A2.json", sha256_hex(benchmark_text(earlier))}, "ours");
    a.clock.pass_s(60);
    at_a.publish_set(*a.store, a.session("educator"), "ward 3");
    ASSERT_EQ(at_a.set().version, of_program.version);

    put(of_program);
    expect_placed(at_b.take(*a.store), 1);
    EXPECT_EQ(at_b.set().source, "ward 3");
    const std::string kept = "A2@" + std::to_string(of_program.version) + ".json";
    EXPECT_EQ(load_benchmark((path.parent_path() / "superseded" / kept).string()).source, of_program.source);
    EXPECT_TRUE(at_b.take(*a.store).empty());
    // An update writes its own there again.
    put(of_program);
    expect_placed(at_b.take(*a.store), 1);
    EXPECT_EQ(at_b.set().source, "ward 3");
    put(earlier);
    EXPECT_TRUE(at_b.take(*a.store).empty());
    EXPECT_EQ(at_b.set().source, "ward 1") << "it was accepted first";
}

TEST_F(AssetPlacing, ASetThatWasAcceptedUnderTheNameOfAnotherFolderIsPutUnderItsOwn) {
    BenchmarkSet next = at_a.set();
    ++next.version;
    next.source = "ward 3";
    const std::string text = benchmark_text(next), digest = sha256_hex(text);
    const AcceptedAssets accepted(*a.store);
    accepted.accept(a.session("educator"), {"ann/A2.json", digest}, "ours", text);
    EXPECT_TRUE(accepted.texts().empty());
    EXPECT_TRUE(at_b.take(*a.store).empty());
    accepted.accept(a.session("educator"), {"benchmarks/A2.json", digest}, "for all stations", text);
    join();
    const std::vector<PlacedAsset> placed = at_b.take(*b.store);
    expect_placed(placed, 1);
    ASSERT_EQ(placed.size(), 1U);
    EXPECT_EQ(placed[0].file.name, "benchmarks/A2.json");
    EXPECT_EQ(at_b.set().source, "ward 3");
    EXPECT_TRUE(at_b.take(*b.store).empty());
    expect_sound(*b.store);
    expect_sound(server);
}

TEST(PassedOnName, FollowsFromTheContents) {
    const AssetFolder folder;
    EXPECT_EQ(passed_on_name(benchmark_text(folder.set())), "benchmarks/A2.json");
    const auto named = [](const char* file) {
        return passed_on_name(read_text_file(asset_path(file), JsonLimits().bytes));
    };
    EXPECT_EQ(named("benchmarks/B1-long_jaws-tracked.json"), "benchmarks/B1-long_jaws-tracked.json");
    EXPECT_EQ(passed_on_name(folder.next_curriculum("Next")), "curricula/rectal-1001.json");
    EXPECT_EQ(named("tasks/A2.json"), "");
    EXPECT_EQ(named("scenes/a2_targets.json"), "");
    for (const char* text : {"", "[]", "{}", "{\"levels\": 1}", "{\"stages\": [], \"id\": 3}"})
        EXPECT_EQ(passed_on_name(text), "") << text;
}

TEST_F(AssetPlacing, AStationOfSomeCohortsReceivesButSendsNone) {
    const KeysOfOneTest keys;
    enrol_station(*a.store, a.session("administrator"), server,
                  make_enrolment_token(server, "lab", {}, usual_token_h).text);
    at_a.publish_set(*a.store, a.session("educator"), "ward 3");
    const auto sync_a = [&] {
        return sync_with_server(*a.store, a.session("administrator"), server_of(*a.store));
    };
    sync_a();
    enrol_station(*b.store, b.store->station_session(), server,
                  make_enrolment_token(server, "lab", {"Year 1"}, usual_token_h).text);
    sync_with_server(*b.store, b.store->station_session(), server_of(*b.store));
    expect_placed(at_b.take(*b.store), 1);
    EXPECT_EQ(at_b.set().source, "ward 3");

    at_b.publish_set(*b.store, b.sign_in("educator"), "a stolen station");
    const SyncResult result = sync_with_server(*b.store, b.sign_in("administrator"), server_of(*b.store));
    EXPECT_TRUE(result.complete);
    ASSERT_EQ(result.conflicts.size(), 1U);
    EXPECT_NE(result.conflicts[0].words().find("are not sent"), std::string::npos);
    // By hand, with the station's own account, the server refuses it as well.
    const ServerLink link = *ServerLink::of(b.store->station_id());
    Connection account(link.address, false, link.password);
    const std::string digest = AcceptedAssets(*b.store).list().front().file.digest;
    EXPECT_ANY_THROW(
        Query(account, "INSERT INTO asset_text (digest, text) VALUES (?, 'x')").bind(digest).run());
    sync_a();
    EXPECT_TRUE(at_a.take(*a.store).empty());
    EXPECT_EQ(at_a.set().source, "ward 3");
}

TEST_F(AssetPlacing, WhatAStationOfSomeCohortsPublishedIsPassedOnByOneOfTheWholeProgramme) {
    const KeysOfOneTest keys;
    const auto token = [&](const std::vector<std::string>& cohorts) {
        return make_enrolment_token(server, "lab", cohorts, usual_token_h).text;
    };
    const auto sync_linked = [](const Store& store, const Session& session) {
        return sync_with_server(store, session, server_of(store));
    };
    enrol_station(*a.store, a.session("administrator"), server, token({}));
    sync_linked(*a.store, a.session("administrator"));
    enrol_station(*b.store, b.store->station_session(), server, token({"Year 1"}));
    sync_linked(*b.store, b.store->station_session());
    at_b.publish_set(*b.store, b.sign_in("educator"), "ward 5");
    EXPECT_EQ(sync_linked(*b.store, b.sign_in("administrator")).conflicts.size(), 1U) << "it stays there";
    sync_linked(*a.store, a.session("administrator"));
    EXPECT_EQ(AcceptedAssets(*a.store).list().size(), 1U);
    EXPECT_TRUE(AcceptedAssets(*a.store).texts().empty()) << "accepted, and nobody knows what it says";

    at_a.publish_set(*a.store, a.session("educator"), "ward 5");
    ASSERT_EQ(AcceptedAssets(*a.store).texts().size(), 1U);
    EXPECT_EQ(at_a.set().source, "ward 5");
    sync_linked(*a.store, a.session("administrator"));
    Station c("c.db");
    const AssetFolder at_c;
    enrol_station(*c.store, c.store->station_session(), server, token({}));
    sync_linked(*c.store, c.store->station_session());
    expect_placed(at_c.take(*c.store), 1);
    EXPECT_EQ(at_c.set().source, "ward 5");
    EXPECT_TRUE(sync_linked(*b.store, b.sign_in("administrator")).conflicts.empty());
    for (const Store* store : {a.store.get(), b.store.get(), c.store.get()}) expect_sound(*store);
    expect_sound(server);
}

TEST(AssetText, IsNeverChangedOrDeletedAndDbCheckFindsBoth) {
    for (const char* sql : {"UPDATE asset_text SET text = 'x'", "DELETE FROM asset_text"}) {
        Programme programme;
        const std::string text = R"({"version": 7})";
        AcceptedAssets(*programme.store)
            .accept(programme.session("educator"), {"benchmarks/A2.json", sha256_hex(text)}, "ours", text);
        EXPECT_EQ(AcceptedAssets(*programme.store).texts().size(), 1U);
        EXPECT_ANY_THROW(programme.store->connection().execute(sql));
        EXPECT_TRUE(programme.store->check(programme.session("station")).ok);
        programme.store->connection().execute("DROP TRIGGER asset_text_is_fixed");
        programme.store->connection().execute("DROP TRIGGER asset_text_is_kept");
        programme.store->connection().execute(sql);
        const CheckReport report = programme.store->check(programme.session("station"));
        std::string problems;
        for (const CheckItem& item : report.items)
            for (const Sentence& problem : item.problems) problems += problem.words() + '\n';
        EXPECT_NE(problems.find("content of accepted file"), std::string::npos) << problems;
    }
}

}  // namespace
}  // namespace fulcrum::database::test
