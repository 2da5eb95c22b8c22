// SPDX-License-Identifier: GPL-3.0-or-later
// Which files an assessed attempt accepts: those that the program was built with, and those that an educator
// has accepted.
#include "database/store/accepted_assets.h"

#include <fstream>
#include <sstream>

#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/support.h"

namespace fulcrum::database::test {
namespace {

std::string digest_of_file(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(fulcrum::test::source_path("assets/" + name), std::ios::binary).rdbuf();
    return sha256_hex(text.str());
}

TEST(AcceptedAssets, TheProgramKnowsEveryFileThatItIsDeliveredWith) {
    std::size_t files = 0;
    for (const char* folder : {"scenes", "tasks", "benchmarks", "curricula", "demonstration"}) {
        for (const auto& entry :
             std::filesystem::directory_iterator(fulcrum::test::source_path(std::string("assets/") + folder)))
            files += entry.path().extension() != ".md" ? 1 : 0;
    }
    EXPECT_EQ(delivered_assets().size(), files);
    EXPECT_GT(files, 10U);
    for (const AssetFile& file : delivered_assets()) EXPECT_EQ(file.digest, digest_of_file(file.name));
    EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(AcceptedAssets, OthersMakePracticeUntilAnEducatorAcceptsThem) {
    Programme programme;
    const AcceptedAssets assets(*programme.store);
    const AssetFile delivered = delivered_assets().back();  // a task
    const AssetFile own{"benchmarks/A2.json", sha256_hex("limits of our experts")};
    EXPECT_TRUE(assets.unknown({delivered}).empty());
    ASSERT_EQ(assets.unknown({delivered, own}).size(), 1U);

    AttemptMeta meta = example_meta(programme.id("ann"));
    meta.assets = {delivered, own};
    try {
        Recorder(programme.path, programme.session("ann"), meta, programme.clock.options());
        FAIL() << "an assessed attempt took limits that nobody accepted";
    } catch (const StoreError& error) {
        EXPECT_EQ(error.kind(), StoreErrorKind::bad_value);
        EXPECT_NE(error.problem().find(own.digest), std::string::npos);
        EXPECT_NE(error.problem().find("practice only"), std::string::npos);
    }
    AttemptMeta practice = meta;
    practice.mode = AttemptMode::practice;
    Recorder(programme.path, programme.session("ann"), practice, programme.clock.options())
        .finish(example_result(true, 70));

    EXPECT_THROW(assets.accept(programme.session("ann"), own, "I like it"), AccessDenied);
    EXPECT_THROW(assets.accept(programme.session("administrator"), own, "so"), AccessDenied);
    EXPECT_EQ(error_kind([&] { assets.accept(programme.session("educator"), own, " "); }),
              StoreErrorKind::bad_value);
    assets.accept(programme.session("educator"), own, "built from our experts' attempts");
    EXPECT_EQ(error_kind([&] { assets.accept(programme.session("educator"), own, "again"); }),
              StoreErrorKind::conflict);
    EXPECT_EQ(error_kind([&] { assets.accept(programme.session("educator"), delivered, "again"); }),
              StoreErrorKind::conflict);
    ASSERT_EQ(assets.list().size(), 1U);
    EXPECT_EQ(assets.list()[0].person_name, "Edu Cator");
    EXPECT_EQ(Audit(*programme.store).entries(programme.session("administrator")).front().operation,
              "asset.accept");

    Recorder recorder(programme.path, programme.session("ann"), meta, programme.clock.options());
    recorder.finish(example_result(true, 70));
    const auto stored = programme.attempts().assets(programme.session("ann"), recorder.attempt_id());
    ASSERT_EQ(stored.size(), 2U);
    EXPECT_EQ(stored[0].digest, own.digest);
    const AttemptReport report =
        Reports(*programme.store).attempt_report(programme.session("ann"), recorder.attempt_id());
    EXPECT_EQ(report.benchmark_sets,
              std::vector<std::string>{"A2-operators@1 sha256:" + own.digest.substr(0, 16)});
    EXPECT_TRUE(programme.store->check(programme.session("station")).ok);
    programme.store->connection().execute("DELETE FROM asset_acceptance");
    EXPECT_FALSE(programme.store->check(programme.session("station")).ok);
}

TEST(AcceptedAssetsText, IsAddedToAFileThatWasAcceptedWithoutIt) {
    Programme programme;
    const AcceptedAssets assets(*programme.store);
    const Session& educator = programme.session("educator");
    const std::string text = "limits of our experts";
    const AssetFile set{"benchmarks/A2.json", sha256_hex(text)},
        scene{"scenes/own.json", sha256_hex("scene")};
    EXPECT_TRUE(assets.is_to_accept(set));
    assets.accept(educator, set, "before texts were kept");
    EXPECT_TRUE(assets.texts().empty());
    EXPECT_TRUE(assets.is_to_accept(set));
    EXPECT_EQ(error_kind([&] { assets.accept(educator, set, "again"); }), StoreErrorKind::conflict);
    assets.accept(educator, set, "again, with what it says", text);
    ASSERT_EQ(assets.texts().size(), 1U);
    EXPECT_EQ(assets.texts()[0].text, text);
    ASSERT_EQ(assets.list().size(), 1U);
    EXPECT_EQ(assets.list()[0].reason, "before texts were kept");
    EXPECT_FALSE(assets.is_to_accept(set));
    EXPECT_EQ(error_kind([&] { assets.accept(educator, set, "again", text); }), StoreErrorKind::conflict);
    // Accepted under the name of another folder: its text can be added under the other name.
    const std::string other = "other limits";
    assets.accept(educator, {"ann/A3.json", sha256_hex(other)}, "from a folder of hers", other);
    EXPECT_EQ(assets.texts().size(), 1U);
    EXPECT_TRUE(assets.is_to_accept({"benchmarks/A3.json", sha256_hex(other)}));
    assets.accept(educator, {"benchmarks/A3.json", sha256_hex(other)}, "for all stations", other);
    EXPECT_EQ(assets.texts().size(), 2U);
    EXPECT_FALSE(assets.is_to_accept({"benchmarks/A3.json", sha256_hex(other)}));
    // Of other files no text is kept.
    assets.accept(educator, scene, "our scene", "scene");
    EXPECT_FALSE(assets.is_to_accept(scene));
    EXPECT_EQ(error_kind([&] { assets.accept(educator, scene, "again", "scene"); }),
              StoreErrorKind::conflict);
    EXPECT_EQ(assets.texts().size(), 2U);
    EXPECT_TRUE(programme.store->check(programme.session("station")).ok);
}

}  // namespace
}  // namespace fulcrum::database::test
