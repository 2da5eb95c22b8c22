// SPDX-License-Identifier: GPL-3.0-or-later
// A site's tissue values: versions with who, when and why, audited; and the scene that an attempt keeps.
#include "database/records/tissues.h"

#include <limits>

#include "database/rows/connection.h"
#include "tests/database/access_expectation.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database {
namespace {

using test::error_kind;
using test::Programme;

const TissueValues tough{{"areolar", {{"penetrate_n", 0.12}, {"static_friction_n", 0.06}}}};

TEST(Tissues, VersionsAreAddedWithAuthorAndReasonAndAudited) {
    const Programme programme;
    const Tissues tissues(*programme.store);
    const Session& educator = programme.session("educator");
    EXPECT_EQ(tissues.in_force(educator, "B2").version, 0);
    EXPECT_TRUE(tissues.in_force(educator, "B2").values.empty());
    EXPECT_EQ(tissues.set(educator, "B2", 0, tough, "stiffer, as in our patients"), 1);
    programme.clock.pass_s(60);
    EXPECT_EQ(tissues.set(programme.session("other_educator"), "B2", 1, {}, "back"), 2);
    const std::vector<TissueSetting> history = tissues.history(programme.session("director"), "B2");
    ASSERT_EQ(history.size(), 2U);
    EXPECT_EQ(history[0].version, 2);
    EXPECT_TRUE(history[0].values.empty());
    EXPECT_EQ(history[1].values, tough);
    EXPECT_EQ(history[1].reason, "stiffer, as in our patients");
    EXPECT_EQ(history[1].author_name, "Edu Cator");
    EXPECT_EQ(history[0].time - history[1].time, 60000);
    EXPECT_EQ(tissues.in_force(programme.session("ann"), "B3").version, 0) << "of another task";

    AuditFilter filter;
    filter.kind = "tissue.set";
    const std::vector<AuditEntry> entries =
        Audit(*programme.store).entries(programme.session("administrator"), filter);
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[1].object_id, "B2");
    EXPECT_EQ(entries[1].role, "educator");
    EXPECT_NE(entries[1].payload.find("\"penetrate_n\":0.12"), std::string::npos) << entries[1].payload;
    EXPECT_NE(entries[1].payload.find("stiffer"), std::string::npos);
    EXPECT_TRUE(Audit(*programme.store).verify().empty());
}

TEST(Tissues, WhatIsWrongIsRefusedAndNothingIsWritten) {
    const Programme programme;
    const Tissues tissues(*programme.store);
    const Session& educator = programme.session("educator");
    EXPECT_EQ(error_kind([&] { tissues.set(educator, "B2", 0, tough, " \n"); }), StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { tissues.set(educator, "B2", 0, {}, "no change"); }),
              StoreErrorKind::bad_value);
    const TissueValues broken{{"areolar", {{"penetrate_n", std::numeric_limits<double>::quiet_NaN()}}}};
    EXPECT_EQ(error_kind([&] { tissues.set(educator, "B2", 0, broken, "x"); }), StoreErrorKind::bad_value);
    EXPECT_EQ(tissues.set(educator, "B2", 0, tough, "first"), 1);
    EXPECT_EQ(error_kind([&] { tissues.set(educator, "B2", 0, {}, "too late"); }), StoreErrorKind::conflict);
    EXPECT_EQ(tissues.history(educator, "B2").size(), 1U);
    Connection& connection = programme.store->connection();
    EXPECT_THROW(connection.execute("UPDATE tissue_value SET value = 9"), StoreError);
    EXPECT_THROW(connection.execute("UPDATE tissue_setting SET reason = 'other'"), StoreError);
}

TEST(Tissues, EveryRoleReadsAndSetsAsTheTableSays) {
    const Programme programme;
    const Tissues tissues(*programme.store);
    int version = 0;
    for (const auto& [login, role] : {std::pair{"ann", Role::trainee},
                                      {"educator", Role::educator},
                                      {"director", Role::director},
                                      {"administrator", Role::administrator},
                                      {"station", Role::station}}) {
        const Session& session = programme.session(login);
        if (test::expected_scope(Operation::read_tissues, role) != Scope::none) {
            EXPECT_EQ(tissues.in_force(session, "B2").version, version) << login;
        } else {
            EXPECT_THROW(tissues.in_force(session, "B2"), AccessDenied) << login;
            EXPECT_THROW(tissues.history(session, "B2"), AccessDenied) << login;
        }
        if (test::expected_scope(Operation::set_tissues, role) != Scope::none) {
            version = tissues.set(session, "B2", version, tough, "test");
        } else {
            EXPECT_THROW(tissues.set(session, "B2", version, {}, "test"), AccessDenied) << login;
        }
    }
    EXPECT_EQ(version, 1);
}

TEST(Tissues, AnAttemptKeepsTheSceneThatItWasPerformedIn) {
    const Programme programme;
    const Session& ann = programme.session("ann");
    std::vector<std::string> ids;
    for (const char* scene : {"{\"id\": \"one\"}", "{\"id\": \"one\"}", "{\"id\": \"other\"}", ""}) {
        AttemptMeta meta = test::example_meta(programme.id("ann"));
        meta.scene_text = scene;
        Recorder recorder(programme.path, ann, meta, programme.clock.options());
        Programme::append_second(recorder);
        recorder.finish(test::example_result(true, 50));
        ids.push_back(recorder.attempt_id());
    }
    const Attempts attempts = programme.attempts();
    EXPECT_EQ(attempts.scene_text(ann, ids[0]), "{\"id\": \"one\"}");
    EXPECT_EQ(attempts.scene_text(ann, ids[2]), "{\"id\": \"other\"}");
    EXPECT_EQ(attempts.scene_text(ann, ids[3]), "") << "as from before scenes were kept";
    EXPECT_EQ(attempts.read(ann, ids[0]).meta.scene_digest, attempts.read(ann, ids[1]).meta.scene_digest);
    EXPECT_NE(attempts.read(ann, ids[0]).meta.scene_digest, attempts.read(ann, ids[2]).meta.scene_digest);
    EXPECT_THROW(attempts.scene_text(programme.session("eve"), ids[0]), AccessDenied);
    Query kept(programme.store->connection(), "SELECT COUNT(*) FROM scene_text");
    ASSERT_TRUE(kept.next());
    EXPECT_EQ(kept.integer(0), 2) << "a scene is kept once";

    const std::string copy =
        attempts.reassign(programme.session("educator"), ids[2], programme.id("ben"), "wrong person");
    EXPECT_EQ(attempts.scene_text(programme.session("ben"), copy), "{\"id\": \"other\"}");

    Connection& connection = programme.store->connection();
    EXPECT_THROW(connection.execute("UPDATE scene_text SET text = '{}'"), StoreError);
    EXPECT_TRUE(programme.store->check(programme.session("administrator")).ok);
    connection.execute("DELETE FROM scene_text WHERE text LIKE '%other%'");
    EXPECT_EQ(error_kind([&] { attempts.scene_text(programme.session("ben"), copy); }),
              StoreErrorKind::corrupt);
    EXPECT_FALSE(programme.store->check(programme.session("administrator")).ok);
}

}  // namespace
}  // namespace fulcrum::database
