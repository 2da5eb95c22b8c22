// SPDX-License-Identifier: GPL-3.0-or-later
// Create programme, sign-in and its waiting, one-time passwords, recovery, the picker.
#include "database/rows/connection.h"
#include "tests/database/password_cost.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

SignInRefused::Reason refusal(const std::function<void()>& call, double* wait_s = nullptr) {
    try {
        call();
    } catch (const SignInRefused& refused) {
        if (wait_s != nullptr) *wait_s = refused.wait_s();
        return refused.reason();
    }
    ADD_FAILURE() << "not refused";
    return SignInRefused::Reason::wrong;
}

TEST(CreateProgramme, OnceAndNeverAgain) {
    Programme programme;
    EXPECT_TRUE(programme.store->has_administrator());
    EXPECT_EQ(programme.store->programme_name(), "Test programme");
    EXPECT_EQ(
        error_kind([&] { programme.people().create_programme("Again", "mallory", "Mallory", password); }),
        StoreErrorKind::conflict);
    EXPECT_FALSE(programme.people().find_login(programme.session("administrator"), "mallory"));
}

TEST(CreateProgramme, RefusesBadInputAndLeavesNothing) {
    const QTemporaryDir folder;
    const Store store = Store::create(folder.filePath("new.db").toStdString());
    const People people(store);
    EXPECT_EQ(error_kind([&] { people.create_programme("P", "ada", "Ada", "123456789"); }),
              StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { people.create_programme(" ", "ada", "Ada", password); }),
              StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { people.create_programme("P", "a b", "Ada", password); }),
              StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { people.create_programme("P", "station", "Ada", password); }),
              StoreErrorKind::bad_value);
    EXPECT_FALSE(store.has_administrator());
    EXPECT_NO_THROW(people.create_programme("P", "ada", "Ada", "1234567890"));
    Query stored(store.connection(), "SELECT verifier FROM credential");
    ASSERT_TRUE(stored.next());
    EXPECT_EQ(stored.text(0).rfind("$argon2id$", 0), 0U);
    EXPECT_EQ(asked_password_cost().operations, 2U);
    EXPECT_EQ(asked_password_cost().memory, 64U << 20U);
}

TEST(SignIn, RightPasswordWhateverTheLettersCaseOfTheLogin) {
    Programme programme;
    const Session session = programme.people().sign_in("ANN", password);
    EXPECT_EQ(session.person_id(), programme.id("ann"));
    EXPECT_EQ(session.role(), Role::trainee);
    EXPECT_EQ(session.display_name(), "Ann Trainee");
    EXPECT_FALSE(session.must_change_password());
    EXPECT_EQ(refusal([&] { programme.people().sign_in("ann", password, Role::director); }),
              SignInRefused::Reason::role_not_held);
    EXPECT_THROW(programme.people().act_as(session, Role::administrator), AccessDenied);
}

TEST(SignIn, WaitDoublesFromFiveSecondsToFiveMinutesPerLoginAndIsStored) {
    Programme programme;
    double expected = 5;
    for (int wrong = 1; wrong <= 8; ++wrong) {
        double wait = 0;
        ASSERT_EQ(refusal([&] { programme.people().sign_in("ann", "wrong password"); }, &wait),
                  SignInRefused::Reason::wrong);
        EXPECT_DOUBLE_EQ(wait, expected) << wrong;
        programme.open();  // stored: a new start changes nothing
        programme.clock.pass_s(expected - 0.5);
        // Even the right password is not looked at before the time.
        ASSERT_EQ(refusal([&] { programme.people().sign_in("ann", password); }, &wait),
                  SignInRefused::Reason::wait);
        EXPECT_DOUBLE_EQ(wait, 0.5);
        programme.clock.pass_s(0.5);
        expected = std::min(300.0, expected * 2);
    }
    // No one else is kept out.
    EXPECT_NO_THROW(programme.people().sign_in("ben", password));
    EXPECT_EQ(programme.people().sign_in_wait_s("ann"), 0);
    EXPECT_NO_THROW(programme.people().sign_in("ann", password));
    double wait = 0;
    refusal([&] { programme.people().sign_in("ann", "wrong password"); }, &wait);
    EXPECT_DOUBLE_EQ(wait, 5);
}

TEST(SignIn, UnknownLoginsAnswerLikeKnownOnes) {
    Programme programme;
    std::string known, unknown;
    try {
        programme.people().sign_in("ann", "wrong password");
    } catch (const SignInRefused& refused) {
        known = refused.what();
    }
    try {
        programme.people().sign_in("nobody", "wrong password");
    } catch (const SignInRefused& refused) {
        unknown = refused.what();
    }
    EXPECT_FALSE(known.empty());
    EXPECT_EQ(known, unknown);
    EXPECT_DOUBLE_EQ(programme.people().sign_in_wait_s("nobody"), 5);
}

TEST(SignIn, AClockSetBackDoesNotLengthenTheWait) {
    Programme programme;
    refusal([&] { programme.people().sign_in("ann", "wrong password"); });
    programme.clock.pass_s(-100000);
    EXPECT_LE(programme.people().sign_in_wait_s("ann"), 5);
}

TEST(OneTimePassword, ServesADayAndForcesAChange) {
    Programme programme;
    const Session& administrator = programme.session("administrator");
    const std::string code = programme.people().issue_one_time_password(administrator, programme.id("ann"));
    EXPECT_EQ(refusal([&] { programme.people().sign_in("ann", password); }), SignInRefused::Reason::wrong);
    programme.clock.pass_s(5);
    const Session session = programme.people().sign_in("ann", code);
    EXPECT_TRUE(session.must_change_password());
    EXPECT_THROW(programme.attempts().list(session), AccessDenied);
    EXPECT_EQ(error_kind([&] { programme.people().change_password(session, code, "short"); }),
              StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] { programme.people().change_password(session, code, code); }),
              StoreErrorKind::bad_value);
    const Session changed = programme.people().change_password(session, code, "a brand new password");
    EXPECT_FALSE(changed.must_change_password());
    EXPECT_NO_THROW(programme.attempts().list(changed));

    const std::string late = programme.people().issue_one_time_password(administrator, programme.id("ben"));
    programme.clock.pass_s(24 * 3600 + 1);
    EXPECT_EQ(refusal([&] { programme.people().sign_in("ben", late); }), SignInRefused::Reason::expired);
}

TEST(Recovery, ServesTheLastAdministratorOnce) {
    Programme programme;
    const std::string typed =
        "  " + QString::fromStdString(programme.recovery_code).toLower().remove('-').toStdString();
    EXPECT_EQ(refusal([&] {
                  programme.people().recover_administrator("administrator", "AAAA-BBBB",
                                                           "a brand new password");
              }),
              SignInRefused::Reason::wrong);
    programme.clock.pass_s(5);
    EXPECT_EQ(refusal([&] {
                  programme.people().recover_administrator("ann", programme.recovery_code,
                                                           "a brand new password");
              }),
              SignInRefused::Reason::wrong);
    const std::string next =
        programme.people().recover_administrator("administrator", typed, "a brand new password");
    EXPECT_NO_THROW(programme.people().sign_in("administrator", "a brand new password"));
    EXPECT_EQ(refusal([&] {
                  programme.people().recover_administrator("administrator", programme.recovery_code,
                                                           "yet another password");
              }),
              SignInRefused::Reason::wrong);
    programme.clock.pass_s(5);
    // With a second administrator the code cannot be used: they can help each other.
    programme.people().set_roles(programme.session("administrator"), programme.id("director"),
                                 {Role::director, Role::administrator});
    EXPECT_EQ(refusal([&] {
                  programme.people().recover_administrator("administrator", next, "yet another password");
              }),
              SignInRefused::Reason::wrong);
}

TEST(Accounts, TheLastAdministratorStays) {
    Programme programme;
    const Session& administrator = programme.session("administrator");
    const std::string& id = programme.id("administrator");
    EXPECT_EQ(error_kind([&] { programme.people().set_active(administrator, id, false); }),
              StoreErrorKind::conflict);
    EXPECT_EQ(error_kind([&] { programme.people().set_roles(administrator, id, {Role::trainee}); }),
              StoreErrorKind::conflict);
    programme.people().set_roles(administrator, programme.id("director"), {Role::administrator});
    EXPECT_NO_THROW(programme.people().set_roles(administrator, id, {Role::trainee}));
}

TEST(Accounts, LoginsAreUniqueAndSyntheticOnesAreNotPeople) {
    Programme programme;
    const Session& administrator = programme.session("administrator");
    EXPECT_EQ(
        error_kind([&] { programme.people().create(administrator, "Ann", "Another", {Role::trainee}); }),
        StoreErrorKind::conflict);
    const Session& station = programme.session("station");
    EXPECT_EQ(error_kind([&] { programme.people().ensure_synthetic(station, "ann", "Fake"); }),
              StoreErrorKind::conflict);
    const Person robot = programme.people().ensure_synthetic(station, "operator-expert-1", "Expert 1");
    EXPECT_EQ(programme.people().ensure_synthetic(station, "operator-expert-1", "Expert 1").id, robot.id);
    EXPECT_EQ(robot.kind, PersonKind::synthetic);
    EXPECT_EQ(error_kind([&] { programme.people().set_roles(administrator, robot.id, {Role::director}); }),
              StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] {
                  programme.people().set_members(programme.session("director"), programme.cohort, {robot.id});
              }),
              StoreErrorKind::bad_value);
    EXPECT_EQ(error_kind([&] {
                  programme.people().set_educators(programme.session("director"), programme.cohort,
                                                   {programme.id("ann")});
              }),
              StoreErrorKind::bad_value);
}

TEST(Picker, ListsThirtyDaysAndCanBeTurnedOff) {
    Programme programme;
    const Session& station = programme.session("station");
    programme.clock.pass_s(31 * 24 * 3600);
    EXPECT_TRUE(programme.people().recent_sign_ins(station).empty());
    programme.people().sign_in("ben", password);
    programme.clock.pass_s(60);
    programme.people().sign_in("ann", password);
    const auto recent = programme.people().recent_sign_ins(station);
    ASSERT_EQ(recent.size(), 2U);
    EXPECT_EQ(recent[0].login, "ann");
    EXPECT_EQ(recent[1].display_name, "Ben Trainee");
    programme.people().set_sign_in_picker(programme.session("administrator"), false);
    EXPECT_TRUE(programme.people().recent_sign_ins(station).empty());
}

TEST(Demo, PeopleActWithoutPasswordsAndASealedDemoTakesPracticeOnly) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("demo.db").toStdString();
    Store store = Store::create(path, true);
    const Session station = store.station_session();
    const People people(store);
    const Person trainee = people.ensure_synthetic(station, "demo-trainee", "Demo Trainee");
    const Person educator = people.ensure_synthetic(station, "demo-educator", "Demo Educator");
    people.set_demo_roles(station, trainee.id, {Role::trainee});
    people.set_demo_roles(station, educator.id, {Role::educator, Role::director});
    const std::string cohort = people.create_demo_cohort(station, "Demo cohort", {trainee.id}, {educator.id});
    AttemptMeta meta = example_meta(trainee.id);
    meta.device_class = DeviceClass::synthetic;
    std::string attempt;
    {
        Recorder recorder(path, station, meta);
        Programme::append_second(recorder);
        recorder.finish(example_result(true, 80));
        attempt = recorder.attempt_id();
    }
    store.seal_demo(station);

    const Session as_educator = people.demo_session("demo-educator", Role::educator);
    EXPECT_EQ(Attempts(store).read(as_educator, attempt).points, 80);
    const CohortTable table = Reports(store).cohort_table(as_educator, cohort);
    ASSERT_EQ(table.rows.size(), 1U);
    EXPECT_EQ(table.rows[0].attempts, 1);
    EXPECT_THROW(Attempts(store).void_attempt(as_educator, attempt, "no"), AccessDenied);
    EXPECT_FALSE(store.allowed(as_educator, Operation::comment, Subject::person(trainee.id)));
    EXPECT_EQ(error_kind([&] { people.create_demo_cohort(station, "More", {}, {}); }),
              StoreErrorKind::sealed_demo);
    const Session as_trainee = people.demo_session("demo-trainee", Role::trainee);
    EXPECT_EQ(error_kind([&] { const Recorder recorder(path, as_trainee, example_meta(trainee.id)); }),
              StoreErrorKind::sealed_demo);
    meta = example_meta(trainee.id);
    meta.mode = AttemptMode::practice;
    EXPECT_NO_THROW(Recorder(path, as_trainee, meta).finish(example_result(false, 10)));
    EXPECT_THROW(people.demo_session("demo-trainee", Role::director), AccessDenied);
    EXPECT_EQ(error_kind([&] { people.create_programme("P", "ada", "Ada", password); }),
              StoreErrorKind::sealed_demo);

    Programme programme;
    EXPECT_THROW(programme.people().demo_session("ann", Role::trainee), AccessDenied);
}

}  // namespace
}  // namespace fulcrum::database::test
