// SPDX-License-Identifier: GPL-3.0-or-later
// A new version of the curriculum: who may, one at a time, all or nothing.
#include "database/records/curriculum_publishing.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum_draft.h"
#include "database/rows/crypto.h"
#include "database/store/accepted_assets.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/own_folder.h"

namespace fulcrum::database {
namespace {

using test::error_kind;
using test::Programme;
namespace fs = std::filesystem;

class CurriculumPublished : public ::testing::Test {
  protected:
    CurriculumPublished() {
        for (const auto& file : fs::directory_iterator(asset_path("curricula")))
            fs::copy_file(file.path(), folder / file.path().filename());
        std::vector<InstalledTask> tasks;
        for (const std::string& id : task_ids()) tasks.push_back(installed_task(load_task(task_file(id))));
        place = {folder.path().string(), tasks, load_forms(asset_path("forms"))};
    }
    /// The next version with another title.
    std::string next(const std::string& title, int by = 1) {
        Curriculum draft = load_versions(place.folder, "rectal", task_ids());
        draft.version = draft.next_own_version() + by - 1;
        draft.title = title;
        return curriculum_text(draft);
    }
    std::string publish(const char* login, const std::string& text, const std::string& reason = "better") {
        return publish_curriculum(*programme.store, programme.session(login), place, newest(), text, reason);
    }
    Curriculum newest() { return load_versions(place.folder, "rectal", task_ids()); }

    Programme programme;
    fulcrum::test::OwnFolder folder;
    CurriculumPublishing place;
};

TEST_F(CurriculumPublished, IsTheEducatorsAuditedAndInForce) {
    for (const char* login : {"ann", "director", "administrator"})
        EXPECT_THROW(publish(login, next("No")), AccessDenied) << login;
    EXPECT_EQ(error_kind([&] { publish("educator", next("No"), " "); }), StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { publish("educator", next("No", 2)); }), StoreErrorKind::conflict);
    EXPECT_THROW(publish("educator", "{}"), InputError);
    Curriculum never = newest();
    never.version = never.next_own_version();
    never.tasks[0].rule = parse_pass_rule("row:1");
    EXPECT_THROW(publish("educator", curriculum_text(never)), InputError) << "nobody can meet the rule";
    EXPECT_EQ(newest().version, 3) << "nothing was written";
    EXPECT_TRUE(AcceptedAssets(*programme.store).list().empty());
    const std::string path = publish("educator", next("New title"), "A clearer title");
    EXPECT_EQ(fs::path(path).filename(), "rectal-1001.json");
    EXPECT_EQ(newest().title, "New title");
    ASSERT_EQ(newest().older.size(), 3U);
    const auto accepted = AcceptedAssets(*programme.store).list();
    ASSERT_EQ(accepted.size(), 1U);
    EXPECT_EQ(accepted[0].reason, "A clearer title");
    EXPECT_EQ(Audit(*programme.store).entries(programme.session("administrator")).front().operation,
              "asset.accept");
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
    publish("educator", next("Again"));
    EXPECT_EQ(newest().version, 1002);
}

TEST_F(CurriculumPublished, OfTwoAtOnceExactlyOne) {
    const std::string texts[] = {next("First"), next("Second")};
    const Curriculum follows = newest();
    std::atomic<int> done{0}, refused{0};
    std::vector<std::thread> both;
    for (const std::string& text : texts)
        both.emplace_back([&] {
            const Store own = Store::open(programme.store->path());
            try {
                publish_curriculum(own, programme.session("educator"), place, follows, text, "two at once");
                ++done;
            } catch (const StoreError& error) {
                EXPECT_EQ(error.kind(), StoreErrorKind::conflict) << error.what();
                ++refused;
            }
        });
    for (std::thread& one : both) one.join();
    EXPECT_EQ(done, 1);
    EXPECT_EQ(refused, 1);
    EXPECT_EQ(newest().version, 1001);
    const std::vector<AcceptedText> accepted = AcceptedAssets(*programme.store).texts();
    ASSERT_EQ(accepted.size(), 1U) << "the other stations get the one that is in force here";
    EXPECT_EQ(accepted[0].text, newest().text);
}

TEST_F(CurriculumPublished, OnlyAfterTheVersionThatItsAuthorSawInForce) {
    const Curriculum seen = newest();
    const std::string text = next("Mine");
    // An update of the program brings version 4 while the page is open: the number of a site's own stays.
    Curriculum delivered = seen;
    delivered.version = 4;
    delivered.title = "Delivered";
    write_output_file((folder / "rectal-4.json").string(), curriculum_text(delivered));
    const auto publish_after = [&](const Curriculum& follows) {
        return error_kind([&] {
            publish_curriculum(*programme.store, programme.session("educator"), place, follows, text, "why");
        });
    };
    EXPECT_EQ(publish_after(seen), StoreErrorKind::conflict);
    Curriculum edited = newest();
    edited.text += " ";
    EXPECT_EQ(publish_after(edited), StoreErrorKind::conflict);
    EXPECT_TRUE(AcceptedAssets(*programme.store).list().empty());
    EXPECT_EQ(newest().title, "Delivered");
    publish("educator", next("Mine"));
    EXPECT_EQ(newest().title, "Mine");
}

TEST_F(CurriculumPublished, ANumberThatAnotherStationHasUsedIsNotUsedAgain) {
    const std::string theirs = next("Theirs"), ours = next("Ours");
    // It came with an exchange and is not in the folder yet.
    AcceptedAssets(*programme.store)
        .accept(programme.session("educator"), {"curricula/rectal-1001.json", sha256_hex(theirs)}, "theirs",
                theirs);
    EXPECT_EQ(error_kind([&] { publish("educator", ours); }), StoreErrorKind::conflict);
    EXPECT_EQ(AcceptedAssets(*programme.store).list().size(), 1U);
    EXPECT_EQ(newest().version, 3) << "nothing was written";
    write_output_file((folder / "rectal-1001.json").string(), theirs);
    // A file that only has a large number in its name is not in the way.
    Curriculum odd = newest();
    odd.version = 5;
    odd.title = "Odd";
    AcceptedAssets(*programme.store)
        .accept(programme.session("educator"),
                {"curricula/rectal-2026.json", sha256_hex(curriculum_text(odd))}, "of the year 2026",
                curriculum_text(odd));
    publish("educator", next("Ours"));
    EXPECT_EQ(newest().version, 1002);
}

TEST_F(CurriculumPublished, ATryThatWasCutOffCanBeRepeated) {
    const std::string text = next("Cut off");
    // Accepted, but killed before the file had its name.
    AcceptedAssets(*programme.store)
        .accept(programme.session("educator"), {"curricula/rectal-1001.json", sha256_hex(text)}, "first try");
    publish("educator", text);
    EXPECT_EQ(newest().title, "Cut off");
    EXPECT_EQ(AcceptedAssets(*programme.store).texts().size(), 1U) << "for the other stations";
}

TEST_F(CurriculumPublished, AFolderThatCannotBeWrittenIsReportedAndNothingIsAccepted) {
    place.folder = asset_path("curricula");
    const std::string text = next("Nowhere");
    const Curriculum follows = newest();
    place.folder = (folder / "gone").string();
    EXPECT_ANY_THROW(
        publish_curriculum(*programme.store, programme.session("educator"), place, follows, text, "nowhere"));
    EXPECT_TRUE(AcceptedAssets(*programme.store).list().empty());
}

}  // namespace
}  // namespace fulcrum::database
