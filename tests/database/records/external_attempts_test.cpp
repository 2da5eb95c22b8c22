// SPDX-License-Identifier: GPL-3.0-or-later
// Imported traces: stored with their class, audited, never judged, never part of a standing, and refused
// where they do not belong.
#include "database/records/external_attempts.h"

#include <gtest/gtest.h>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "database/records/curricula.h"
#include "database/records/person_merge.h"
#include "database/records/standings.h"
#include "database/rows/connection.h"
#include "database/store/store_restore.h"
#include "tests/database/external_example.h"

namespace fulcrum::database::test {
namespace {

class External : public ::testing::Test {
  protected:
    ExternalAttempts imports() const { return ExternalAttempts(*programme.store); }
    std::string add(const ExternalAttempt& attempt, const char* login = "educator") const {
        return imports().add(programme.session(login), attempt);
    }
    StoreErrorKind refused(const ExternalAttempt& attempt) const {
        return error_kind([&] { add(attempt); });
    }
    static StoreErrorKind error_kind(const std::function<void()>& action) {
        try {
            action();
        } catch (const StoreError& error) {
            EXPECT_FALSE(error.hint().empty());
            return error.kind();
        }
        ADD_FAILURE() << "was stored";
        return StoreErrorKind::corrupt;
    }
    void expect_sound() const {
        for (const CheckItem& item : programme.store->check(programme.session("station")).items)
            EXPECT_TRUE(item.ok) << item.name << ": "
                                 << (item.problems.empty() ? "" : item.problems[0].words());
    }
    Programme programme;
};

TEST_F(External, IsStoredWithItsClassItsTraceAndNoVerdict) {
    const std::string id = add(box_attempt(programme.id("ann")));
    const Session& ann = programme.session("ann");
    const AttemptSummary stored = programme.attempts().read(ann, id);
    EXPECT_EQ(stored.meta.task_id, "external-peg-transfer");
    EXPECT_EQ(stored.meta.device_class, DeviceClass::external);
    EXPECT_EQ(stored.meta.device, "box trainer");
    EXPECT_EQ(stored.meta.mode, AttemptMode::practice);
    EXPECT_EQ(stored.meta.started, noon - 3600 * 1000);
    EXPECT_EQ(stored.state, AttemptState::completed);
    EXPECT_FALSE(stored.passed);
    EXPECT_FALSE(stored.points);
    EXPECT_FALSE(stored.counting);
    EXPECT_EQ(stored.not_scored_because.id(), StatementId::recorded_elsewhere);
    EXPECT_EQ(programme.attempts().score(ann, id)->metrics.at(0).value, 100.0);
    EXPECT_EQ(imports().trace(ann, id), box_trace);
    EXPECT_EQ(programme.attempts().assets(ann, id).size(), 2U);
    EXPECT_EQ(error_kind([&] { programme.attempts().read_trace(ann, id); }), StoreErrorKind::not_found);
    EXPECT_EQ(error_kind([&] { imports().trace(ann, programme.record("ann")); }), StoreErrorKind::not_found);
    Query audited(programme.store->connection(), "SELECT COUNT(*) FROM audit_entry WHERE operation = ?");
    audited.bind("attempt.import");
    ASSERT_TRUE(audited.next());
    EXPECT_EQ(audited.integer(0), 1);
    expect_sound();
    // It is in the person's report under its class, and not among the scores to be made again.
    const PersonProgress progress =
        Reports(*programme.store)
            .person_progress(programme.session("educator"), programme.id("ann"), "external-peg-transfer");
    ASSERT_EQ(progress.series.size(), 1U);
    EXPECT_EQ(progress.series[0].device_class, DeviceClass::external);
    const PersonData data =
        Reports(*programme.store).person_data(programme.session("director"), programme.id("ann"), {{"A2"}});
    ASSERT_EQ(data.progress.size(), 2U);
    EXPECT_EQ(data.progress[1].task_id, "external-peg-transfer");
    EXPECT_FALSE(data.progress[1].series.at(0).points.at(0).counting);
    ASSERT_EQ(data.rows.size(), 2U);
    EXPECT_EQ(data.rows[1].not_counting, 1);
    EXPECT_EQ(data.rows[1].attempts, 0);
    ScoringInForce now;
    now.limits = [](const AttemptMeta&) { return std::string("other@9"); };
    for (const StaleScore& stale : programme.attempts().stale_scores(programme.session("educator"), now))
        EXPECT_NE(stale.attempt_id, id);
}

TEST_F(External, ChangesNoStandingAndNoCurriculum) {
    const Curriculum curriculum = load_curriculum(asset_path("curricula/rectal.json"), task_ids());
    const Session& educator = programme.session("educator");
    const std::string& eve = programme.id("ben");
    const std::string before = Curricula(*programme.store).in_force(educator, eve, curriculum).name();
    add(box_attempt(eve));
    const PersonRecord record = Standings(*programme.store).record(educator, eve, curriculum);
    EXPECT_TRUE(record.attempts.empty());
    for (const TaskStanding& one : standing_of(record, noon)) EXPECT_EQ(one.attempts, 0) << one.task;
    EXPECT_EQ(Curricula(*programme.store).in_force(educator, eve, curriculum).name(), before)
        << "the first attempt at a task of ours says which version is followed";
    for (const auto& [name, people] : Curricula(*programme.store).people(curriculum))
        EXPECT_NE(name, "") << people;
}

TEST_F(External, IsVoidedReassignedAndImportedAgain) {
    const Session& educator = programme.session("educator");
    const std::string id = add(box_attempt(programme.id("ann")));
    EXPECT_EQ(refused(box_attempt(programme.id("ann"))), StoreErrorKind::conflict) << "the same file twice";
    const std::string copy = programme.attempts().reassign(educator, id, programme.id("ben"), "Ben's box");
    EXPECT_EQ(imports().trace(programme.session("ben"), copy), box_trace);
    EXPECT_EQ(programme.attempts().read(educator, copy).meta.device_class, DeviceClass::external);
    add(box_attempt(programme.id("ann")));
    expect_sound();
}

TEST_F(External, OfADoubledAccountIsThePersonsAndNotImportedTwice) {
    programme.people().set_members(programme.session("director"), programme.cohort,
                                   {programme.id("ann"), programme.id("ben"), programme.id("eve")});
    const std::string of_eve = add(box_attempt(programme.id("eve")));
    const PersonMerge merge(*programme.store);
    const Session& administrator = programme.session("administrator");
    merge.merge(administrator, programme.id("eve"), programme.id("ann"), "the same person");
    const Session& ann = programme.session("ann");
    EXPECT_EQ(programme.attempts().read(ann, of_eve).meta.person_id, programme.id("ann"));
    EXPECT_EQ(imports().trace(ann, of_eve), box_trace);
    EXPECT_EQ(refused(box_attempt(programme.id("ann"))), StoreErrorKind::conflict) << "it is hers already";
    expect_sound();
    merge.undo(administrator, programme.id("eve"), "another person after all");
    add(box_attempt(programme.id("ann")));
    expect_sound();
}

TEST_F(External, IsInABackupAndInTheStoreThatIsRestoredFromIt) {
    const std::string id = add(box_attempt(programme.id("ann")));
    const std::string backup = programme.folder.filePath("backup.db").toStdString();
    programme.store->backup(programme.session("administrator"), backup);
    ExternalAttempt later = box_attempt(programme.id("ben"));
    later.files[0].digest = "cc";
    const std::string lost = add(later);
    programme.store.reset();
    restore_store(
        backup, programme.path,
        [](const Store& copy) { return People(copy).sign_in("administrator", password); },
        programme.clock.options());
    programme.open();
    EXPECT_EQ(imports().trace(programme.session("ann"), id), box_trace);
    EXPECT_EQ(programme.attempts().score(programme.session("ann"), id)->metrics.at(0).value, 100.0);
    EXPECT_EQ(error_kind([&] { imports().trace(programme.session("ben"), lost); }),
              StoreErrorKind::not_found);
    expect_sound();
    add(later);  // what came after the backup can be imported again
    expect_sound();
}

TEST_F(External, WrongValuesAndPeopleAreRefusedAndLeaveNothing) {
    const ExternalAttempt sound = box_attempt(programme.id("ann"));
    ExternalAttempt wrong = sound;
    for (const char* name : {"", "peg transfer", "a/b", "ä"}) {
        wrong.exercise = name;
        EXPECT_EQ(refused(wrong), StoreErrorKind::bad_value) << name;
    }
    wrong = sound;
    wrong.performed = noon + 1;
    EXPECT_EQ(refused(wrong), StoreErrorKind::bad_value) << "from the future";
    wrong = sound;
    wrong.source.clear();
    EXPECT_EQ(refused(wrong), StoreErrorKind::bad_value);
    wrong = sound;
    wrong.trace.clear();
    EXPECT_EQ(refused(wrong), StoreErrorKind::bad_value);
    wrong = sound;
    wrong.score.passed = true;
    EXPECT_EQ(refused(wrong), StoreErrorKind::bad_value) << "nothing judges it";
    wrong = sound;
    wrong.score.metrics[0].value = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refused(wrong), StoreErrorKind::bad_value);
    EXPECT_THROW(add(sound, "ann"), AccessDenied) << "nobody imports for themselves";
    EXPECT_THROW(add(sound, "director"), AccessDenied);
    EXPECT_THROW(add(sound, "station"), AccessDenied) << "a real person's attempt needs an educator";
    EXPECT_THROW(add(box_attempt(programme.id("eve"))), AccessDenied) << "of another cohort";
    AttemptFilter filter;
    filter.task_id = "external-peg-transfer";
    EXPECT_TRUE(programme.attempts().list(programme.session("director"), filter).empty());
}

}  // namespace
}  // namespace fulcrum::database::test
