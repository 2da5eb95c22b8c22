// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates follow from the record: who gets one, what its code depends on, when it ends.
#include "database/records/certificates.h"

#include <gtest/gtest.h>

#include <cctype>

#include "assessment/assets/assets.h"
#include "database/records/standings.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database {
namespace {

using test::Programme;

Curriculum whole() {
    return load_curriculum(asset_path("curricula/rectal.json"), task_ids());
}

void declare(const Programme& programme, const char* person, std::initializer_list<const char*> tasks) {
    for (const char* task : tasks) {
        programme.clock.pass_s(60);
        Standings(*programme.store)
            .decide(programme.session("educator"), programme.id(person), task,
                    StandingOverride::Kind::proficient, "examined in theatre");
    }
}

TEST(Certificates, AStageWithoutOneProficiencyHasNone) {
    const Programme programme;
    const Curriculum curriculum = whole();
    const auto count = [&] {
        return certificates(*programme.store, programme.session("ann"), programme.id("ann"), curriculum)
            .size();
    };
    EXPECT_EQ(count(), 0U);
    declare(programme, "ann", {"A1", "A2"});
    EXPECT_EQ(count(), 0U) << "A3 is missing";
    declare(programme, "ann", {"A3"});
    ASSERT_EQ(count(), 1U);
    const Certificate one =
        certificates(*programme.store, programme.session("ann"), programme.id("ann"), curriculum)[0];
    EXPECT_EQ(one.stage, "A");
    EXPECT_EQ(one.curriculum, curriculum.name());
    ASSERT_EQ(one.tasks.size(), 3U);
    EXPECT_TRUE(one.tasks[0].by_override);
    EXPECT_EQ(one.completed_at, one.tasks[2].declared_at);
    EXPECT_EQ(one.code.size(), 19U);
}

TEST(Certificates, PassesByProvisionalLimitsMakeNone) {
    const Programme programme;
    const Curriculum curriculum = whole();
    declare(programme, "ann", {"A1", "A3"});
    // The rule is met many times over, but the limits come from synthetic operators.
    for (int i = 0; i < 40; ++i) {
        programme.clock.pass_s(12 * 3600);
        programme.record("ann");
    }
    const PersonRecord record =
        Standings(*programme.store).record(programme.session("ann"), programme.id("ann"), curriculum);
    for (const TaskStanding& one : standing_of(record, programme.store->now())) {
        if (one.task != "A2") continue;
        EXPECT_TRUE(one.met_provisionally);
        EXPECT_EQ(one.declared_at, 0);
    }
    EXPECT_TRUE(
        certificates(*programme.store, programme.session("ann"), programme.id("ann"), curriculum).empty());
}

TEST(Certificates, CodesAreFoundAgainHoweverTheyAreTypedAndNoOtherCodeIs) {
    const Programme programme;
    const Curriculum curriculum = whole();
    declare(programme, "ann", {"A1", "A2", "A3"});
    declare(programme, "ben", {"A1", "A2", "A3"});
    const Session& director = programme.session("director");
    const Certificate ann = certificates(*programme.store, director, programme.id("ann"), curriculum).at(0);
    const Certificate ben = certificates(*programme.store, director, programme.id("ben"), curriculum).at(0);
    EXPECT_NE(ann.code, ben.code);
    std::string typed;
    for (const char c : ann.code) typed += c == '-' ? ' ' : static_cast<char>(std::tolower(c));
    const auto found = find_certificate(*programme.store, director, typed, curriculum);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->person_id, programme.id("ann"));
    std::string changed = ann.code;
    changed[0] = changed[0] == 'A' ? 'B' : 'A';
    for (const std::string& wrong :
         {changed, std::string(), std::string("-"), ann.code + "A", std::string("'; --")})
        EXPECT_FALSE(find_certificate(*programme.store, director, wrong, curriculum)) << wrong;
    // Whoever may not read the progress does not find the certificate either.
    EXPECT_FALSE(find_certificate(*programme.store, programme.session("ben"), ann.code, curriculum));
    EXPECT_THROW(certificates(*programme.store, programme.session("ben"), programme.id("ann"), curriculum),
                 AccessDenied);
}

TEST(Certificates, ALaterDeclarationOfOneTaskChangesTheCode) {
    const Curriculum curriculum = whole();
    const auto code = [&](double late) {
        const Programme programme;
        declare(programme, "ann", {"A1", "A2"});
        programme.clock.pass_s(late);
        declare(programme, "ann", {"A3"});
        return certificates(*programme.store, programme.session("ann"), programme.id("ann"), curriculum)
            .at(0)
            .code;
    };
    EXPECT_NE(code(0), code(1));
}

}  // namespace
}  // namespace fulcrum::database
