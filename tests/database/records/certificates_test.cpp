// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates follow from the record: who gets one, what its code depends on, when it ends.
#include "database/records/certificates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <functional>

#include "assessment/assets/assets.h"
#include "database/records/curricula.h"
#include "database/records/person_merge.h"
#include "database/records/recorder.h"
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

TEST(Certificates, ADecisionOnAProficiencyInForceConfirmsItsCheckAndChangesNoCode) {
    const Programme programme;
    const Curriculum curriculum = whole();
    const auto made = [&] {
        return certificates(*programme.store, programme.session("ann"), programme.id("ann"), curriculum);
    };
    declare(programme, "ann", {"A1", "A2", "A3"});
    ASSERT_EQ(made().size(), 1U);
    const Certificate before = made()[0];
    declare(programme, "ann", {"A2"});  // by a slip: there is nothing to decide
    ASSERT_EQ(made().size(), 1U);
    EXPECT_EQ(made()[0].code, before.code);
    const auto of_a2 = [&] {
        const PersonRecord record =
            Standings(*programme.store).record(programme.session("ann"), programme.id("ann"), curriculum);
        for (const TaskStanding& one : standing_of(record, programme.store->now()))
            if (one.task == "A2") return one;
        return TaskStanding();
    };
    EXPECT_EQ(of_a2().standing, Standing::proficient);
    programme.clock.pass_s(15 * 86'400);
    EXPECT_EQ(of_a2().standing, Standing::due);
    declare(programme, "ann", {"A2"});
    EXPECT_EQ(of_a2().standing, Standing::maintained);
    EXPECT_EQ(of_a2().declared_at, before.tasks[1].declared_at);
    EXPECT_EQ(of_a2().next_check, before.tasks[1].declared_at + std::int64_t{30} * 86'400'000);
    ASSERT_EQ(made().size(), 1U);
    EXPECT_EQ(made()[0].code, before.code);
    EXPECT_EQ(made()[0].curriculum, before.curriculum);
    EXPECT_EQ(made()[0].completed_at, before.completed_at);
}

TEST(Certificates, OneWrittenWhenADecisionDeclaredAProficiencyOnceMoreIsStillFound) {
    const Curriculum curriculum = whole();
    const auto made = [&](const Programme& programme) {
        return certificates(*programme.store, programme.session("ann"), programme.id("ann"), curriculum)
            .at(0);
    };
    // Then the day of the newest decision was that of the declaration: as where it is the only one.
    const auto paper = [&](double again) {
        const Programme other;
        declare(other, "ann", {"A1"});
        other.clock.pass_s(60);
        declare(other, "ann", {"A3"});
        other.clock.pass_s(again);
        declare(other, "ann", {"A2"});
        return made(other);
    };
    const Certificate first = paper(0), second = paper(3600);
    const Programme programme;
    declare(programme, "ann", {"A1", "A2", "A3", "A2"});
    programme.clock.pass_s(3600 - 60);
    declare(programme, "ann", {"A2"});
    EXPECT_NE(made(programme).code, first.code);
    EXPECT_NE(made(programme).code, second.code);
    for (const Certificate& printed : {first, second}) {
        const auto found =
            find_certificate(*programme.store, programme.session("director"), printed.code, curriculum);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->person_id, programme.id("ann"));
        EXPECT_EQ(found->completed_at, printed.completed_at) << "as on the paper";
    }
    const Programme without;
    declare(without, "ann", {"A1", "A2", "A3"});
    EXPECT_FALSE(find_certificate(*without.store, without.session("director"), first.code, curriculum))
        << "nobody decided on that day";
}

TEST(Certificates, OfSomebodyWithDecisionsAloneStayWhenAVersionIsPublished) {
    const Programme programme;
    const Curriculum before = whole();
    Curriculum after = whole();
    after.older = {whole()};
    after.version = 1001;
    for (CurriculumTask& task : after.tasks)
        if (task.task == "B1") task.stage = "A";
    for (const char* task : {"A1", "A2", "A3"}) {
        programme.clock.pass_s(60);
        Standings(*programme.store)
            .decide(programme.session("educator"), programme.id("ann"), task,
                    StandingOverride::Kind::proficient, "examined in theatre", &before);
    }
    const auto made = [&](const Curriculum& newest) {
        return certificates(*programme.store, programme.session("ann"), programme.id("ann"), newest);
    };
    ASSERT_EQ(made(before).size(), 1U);
    ASSERT_EQ(made(after).size(), 1U);
    EXPECT_EQ(made(after)[0].curriculum, before.name());
    EXPECT_EQ(made(after)[0].code, made(before)[0].code);
    EXPECT_EQ(made(after)[0].completed_at, made(before)[0].completed_at);
    const auto followed =
        Curricula(*programme.store).followed(programme.session("ann"), programme.id("ann"), after);
    ASSERT_EQ(followed.size(), 2U) << "one decision settles it";
    EXPECT_EQ(followed[0].name, before.name());
    EXPECT_EQ(followed[1].name, before.name());
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
}

TEST(Certificates, AMergeEndsNoneOfEitherAccount) {
    const Programme programme;
    Curriculum newest = whole();
    newest.older = {whole()};
    newest.version = 4;
    const Session& director = programme.session("director");
    programme.people().set_members(director, programme.cohort, {programme.id("ann"), programme.id("eve")});
    const auto begin_with = [&](const char* login, const char* version) {
        programme.clock.pass_s(3600);
        AttemptMeta meta = test::example_meta(programme.id(login), "B1");
        meta.curriculum = version;
        Recorder recorder(programme.path, programme.session(login), meta, programme.clock.options());
        Programme::append_second(recorder);
        recorder.finish(test::example_result(false, 0));
    };
    const auto code = [&](const char* login) {
        return certificates(*programme.store, director, programme.id(login), newest).at(0).code;
    };
    begin_with("eve", "rectal@3");
    declare(programme, "eve", {"A1", "A2", "A3"});
    begin_with("ann", "rectal@4");
    declare(programme, "ann", {"A1", "A2", "A3"});
    const std::string of_eve = code("eve"), of_ann = code("ann");
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("eve"), programme.id("ann"), "entered twice");
    EXPECT_EQ(Curricula(*programme.store).in_force(director, programme.id("ann"), newest).name(), "rectal@4");
    for (const std::string& old : {of_eve, of_ann}) {
        const auto found = find_certificate(*programme.store, director, old, newest);
        ASSERT_TRUE(found) << old;
        EXPECT_EQ(found->person_id, programme.id("ann"));
        EXPECT_EQ(found->follows, "rectal@4");
    }
    EXPECT_TRUE(find_certificate(*programme.store, director, code("ann"), newest));
}

/// A person who follows version 3, and a version 4 to be moved to.
struct MovedPerson {
    explicit MovedPerson(const std::function<void(Curriculum&)>& change) : newest(whole()) {
        newest.older = {whole()};
        newest.version = 4;
        change(newest);
        move("rectal@3");
    }
    void move(const char* to) {
        programme.clock.pass_s(60);
        Curricula(*programme.store)
            .move(programme.session("educator"), {programme.id("ann")}, newest, to, "another course");
    }
    std::vector<Certificate> made() const {
        return certificates(*programme.store, programme.session("ann"), programme.id("ann"), newest);
    }
    Programme programme;
    Curriculum newest;
};
CurriculumTask& task_in(Curriculum& curriculum, const char* id) {
    return *std::find_if(curriculum.tasks.begin(), curriculum.tasks.end(),
                         [&](const CurriculumTask& one) { return one.task == id; });
}

TEST(Certificates, AMoveMakesNoCertificateOfARuleThatWasNotMet) {
    MovedPerson ann([](Curriculum& next) {
        for (const char* task : {"A1", "A2", "A3"}) task_in(next, task).rule = parse_pass_rule("row:20");
    });
    declare(ann.programme, "ann", {"A1", "A2", "A3"});
    ASSERT_EQ(ann.made().size(), 1U);
    const Certificate before = ann.made()[0];
    EXPECT_EQ(before.curriculum, "rectal@3");
    EXPECT_EQ(before.follows, "rectal@3");
    ann.move("rectal@4");
    ASSERT_EQ(ann.made().size(), 1U);
    EXPECT_EQ(ann.made()[0].curriculum, "rectal@3") << "earned under it";
    EXPECT_EQ(ann.made()[0].follows, "rectal@4");
    EXPECT_EQ(ann.made()[0].code, before.code) << "the one on paper is valid";
    EXPECT_TRUE(
        find_certificate(*ann.programme.store, ann.programme.session("director"), before.code, ann.newest));
    ann.move("rectal@3");
    EXPECT_EQ(ann.made().size(), 1U);
}

TEST(Certificates, AMoveToAVersionThatAsksForMoreTakesNoneAway) {
    MovedPerson ann([](Curriculum& next) { task_in(next, "B1").stage = "A"; });
    declare(ann.programme, "ann", {"A1", "A2", "A3"});
    ann.move("rectal@4");
    ASSERT_EQ(ann.made().size(), 1U);
    const Certificate first = ann.made()[0];
    EXPECT_EQ(first.curriculum, "rectal@3");
    declare(ann.programme, "ann", {"B1"});
    const std::vector<Certificate> both = ann.made();
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[0].code, first.code);
    EXPECT_EQ(both[1].curriculum, "rectal@4");
    EXPECT_EQ(both[1].stage, "A");
    ASSERT_EQ(both[1].tasks.size(), 4U);
    EXPECT_EQ(both[1].tasks[0].curriculum, "rectal@3") << "declared before the move";
    EXPECT_EQ(both[1].tasks[3].curriculum, "rectal@4");
    EXPECT_EQ(both[1].completed_at, both[1].tasks[3].declared_at);
}

TEST(Certificates, AStageThatAMoveCompletesIsOfTheNewVersionAndItsTasksOfTheOld) {
    MovedPerson ann([](Curriculum& next) {
        next.tasks.erase(next.tasks.begin() + (&task_in(next, "A3") - next.tasks.data()));
    });
    declare(ann.programme, "ann", {"A1", "A2"});
    EXPECT_TRUE(ann.made().empty());
    ann.move("rectal@4");
    ASSERT_EQ(ann.made().size(), 1U);
    const Certificate made = ann.made()[0];
    EXPECT_EQ(made.curriculum, "rectal@4");
    EXPECT_EQ(made.completed_at, ann.programme.store->now());
    for (const CertificateTask& task : made.tasks) EXPECT_EQ(task.curriculum, "rectal@3");
    // A task that the person's version no longer has keeps its proficiency for the certificates before.
    MovedPerson ben([](Curriculum& next) {
        next.tasks.erase(next.tasks.begin() + (&task_in(next, "A3") - next.tasks.data()));
    });
    declare(ben.programme, "ann", {"A1", "A2", "A3"});
    ben.move("rectal@4");
    ASSERT_EQ(ben.made().size(), 1U);
    EXPECT_EQ(ben.made()[0].curriculum, "rectal@3");
    EXPECT_EQ(ben.made()[0].tasks.size(), 3U);
}

}  // namespace
}  // namespace fulcrum::database
