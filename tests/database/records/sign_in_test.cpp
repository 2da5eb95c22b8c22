// SPDX-License-Identifier: GPL-3.0-or-later
// Create programme, sign-in and its waiting, one-time passwords, recovery, the picker.
#include <sodium.h>

#include <atomic>
#include <thread>

#include "assessment/assets/assets.h"
#include "database/records/ratings.h"
#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "tests/database/cut_off_process.h"
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

TEST(SignIn, WaitDoublesFromFiveToThirtySecondsAndEndsAtFiveMinutesPerLoginAndIsStored) {
    const TemporaryFoldersInMemory in_memory;
    Programme programme;
    double expected = 5;
    for (int wrong = 1; wrong <= tries_before_longest_wait + 2; ++wrong) {
        if (wrong > tries_before_longest_wait) expected = 300;
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
        expected = std::min(30.0, expected * 2);
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
    programme.clock.set_forward_s(-100000);
    EXPECT_LE(programme.people().sign_in_wait_s("ann"), 5);
}

TEST(SignIn, AClockSetForwardDoesNotSkipTheWaitNorDoesARestart) {
    Programme programme;
    refusal([&] { programme.people().sign_in("ann", "wrong password"); });
    programme.clock.set_forward_s(48 * 3600);
    refusal([&] { programme.people().sign_in("ben", "wrong password"); });  // tidies away what is old
    EXPECT_EQ(refusal([&] { programme.people().sign_in("ann", password); }), SignInRefused::Reason::wait);
    programme.clock.restart();
    programme.clock.set_forward_s(3600);
    EXPECT_EQ(refusal([&] { programme.people().sign_in("ann", password); }), SignInRefused::Reason::wait);
    programme.clock.pass_s(5);
    EXPECT_NO_THROW(programme.people().sign_in("ann", password));
}

TEST(SignIn, OfManyGuessesAtTheSameTimeOneIsLookedAt) {
    Programme programme;
    constexpr int guesses = 40;
    StoreOptions options = programme.clock.options();
    options.busy_timeout_ms = 60000;
    std::atomic<int> looked_at{0}, had_to_wait{0}, ready{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < guesses; ++i) {
        threads.emplace_back([&, i] {
            const Store store = Store::open(programme.path, options);
            for (++ready; ready < guesses;) std::this_thread::yield();
            try {
                People(store).sign_in("ann", i % 2 == 0 ? "wrong password" : "another guess");
            } catch (const SignInRefused& refused) {
                ++(refused.reason() == SignInRefused::Reason::wait ? had_to_wait : looked_at);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(looked_at, 1);
    EXPECT_EQ(had_to_wait, guesses - 1);
}

TEST(SignIn, AnUnknownLoginCostsTheSameWorkFromTheFirstTryOn) {
    EXPECT_EQ(crypto_pwhash_str_needs_rehash(nobodys_verifier, crypto_pwhash_OPSLIMIT_INTERACTIVE,
                                             crypto_pwhash_MEMLIMIT_INTERACTIVE),
              0)
        << "it can be read, and has the cost of a real one";
    Programme programme;
    programme.people().sign_in("ann", password);
    const auto made = password_hashes_made();
    refusal([&] { programme.people().sign_in("nobody", "wrong password"); });
    EXPECT_EQ(password_hashes_made(), made) << "no hash is made where a known login has one to compare with";
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
    programme.clock.set_forward_s(-24 * 3600);
    EXPECT_EQ(refusal([&] { programme.people().sign_in("ben", late); }), SignInRefused::Reason::expired)
        << "a clock that is set back does not revive it";
}

TEST(OneTimePassword, IsNotRevivedByAClockSetBackAfterARestart) {
    Programme programme;
    const Session& administrator = programme.session("administrator");
    const std::string code = programme.people().issue_one_time_password(administrator, programme.id("ann"));
    programme.clock.pass_s(25 * 3600);
    programme.people().sign_in("ben", password);  // the audit log has seen the day after
    programme.clock.restart();
    programme.clock.set_forward_s(-24 * 3600);
    EXPECT_EQ(refusal([&] { programme.people().sign_in("ann", code); }), SignInRefused::Reason::expired);
    const std::string next = programme.people().issue_one_time_password(administrator, programme.id("ann"));
    EXPECT_NO_THROW(programme.people().sign_in("ann", next)) << "issued by the clock as it is now";
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
    const Person robot = programme.people().ensure_synthetic(station, "synthetic-expert-1", "Expert 1");
    EXPECT_EQ(programme.people().ensure_synthetic(station, "synthetic-expert-1", "Expert 1").id, robot.id);
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

TEST(Accounts, NamesHoldNoControlNorDirectionCharacters) {
    Programme programme;
    const Session& administrator = programme.session("administrator");
    for (const char* name : {"Ann\nAdmin", "Ann\x07",
                             "Ann \xE2\x80\xAE"
                             "nimda",
                             "\xE2\x81\xA6"
                             "Ann",
                             "Ann\xE2\x80\xA8", "Ann\xFF"}) {
        EXPECT_EQ(error_kind([&] { programme.people().rename(administrator, programme.id("ann"), name); }),
                  StoreErrorKind::bad_value)
            << name;
    }
    EXPECT_EQ(error_kind([&] { programme.people().create_cohort(programme.session("director"), "Year\t1"); }),
              StoreErrorKind::bad_value);
    // Joiners are letters' business in several scripts.
    EXPECT_NO_THROW(
        programme.people().rename(administrator, programme.id("ann"), "Zo\xC3\xAB \xE2\x80\x8C M"));
}

TEST(Accounts, AnAccountGetsAnotherLogin) {
    Programme programme;
    const Session& administrator = programme.session("administrator");
    const People people = programme.people();
    const std::string ann = programme.id("ann");
    const Session before = people.sign_in("ann", password);
    const Person robot = people.ensure_synthetic(programme.session("station"), "synthetic-robot", "Robot");
    const auto refusal_of = [&](const std::string& person, const std::string& login) {
        return error_kind([&] { people.set_login(administrator, person, login); });
    };
    EXPECT_EQ(refusal_of(ann, "BEN"), StoreErrorKind::conflict) << "somebody has it";
    EXPECT_EQ(refusal_of(ann, "a b"), StoreErrorKind::bad_value);
    EXPECT_EQ(refusal_of(ann, "synthetic-ann"), StoreErrorKind::bad_value);
    EXPECT_EQ(refusal_of(ann, "erased-" + programme.id("ben")), StoreErrorKind::bad_value);
    EXPECT_EQ(refusal_of(robot.id, "robot"), StoreErrorKind::bad_value);
    EXPECT_THROW(people.set_login(programme.session("director"), ann, "ann.b"), AccessDenied);
    const std::int64_t rows = Audit(*programme.store).count();
    people.set_login(administrator, ann, "ann");
    EXPECT_EQ(Audit(*programme.store).count(), rows) << "it is hers already";

    people.set_login(administrator, ann, "ann.b");
    const AuditEntry deed = Audit(*programme.store).entries(administrator)[0];
    EXPECT_EQ(deed.operation, "person.set_login");
    EXPECT_EQ(deed.payload, R"({"after":"ann.b","before":"ann"})");
    EXPECT_EQ(refusal([&] { people.sign_in("ann", password); }), SignInRefused::Reason::wrong);
    EXPECT_EQ(people.sign_in("Ann.B", password).person_id(), ann);
    // Who was signed in stays so, and is known by the new login.
    EXPECT_EQ(people.login_now(before), "ann.b");
    EXPECT_EQ(people.change_password(before, password, "another horse battery").login(), "ann.b");
    EXPECT_TRUE(Audit(*programme.store).verify().empty());
    people.set_login(administrator, ann, "Ann.B");
    EXPECT_EQ(people.find(administrator, ann)->login, "Ann.B");
}

TEST(Accounts, NobodyCanKeepALoginFromAPersonWithoutSigningIn) {
    Programme programme;
    const Session& administrator = programme.session("administrator");
    const Session& station = programme.session("station");
    const auto refused = [&](const char* login) {
        try {
            programme.people().ensure_synthetic(station, login, "Fake");
        } catch (const StoreError& error) {
            std::string words = error.what();
            return words.replace(words.find(login), std::string(login).size(), "LOGIN");
        }
        return std::string("made");
    };
    EXPECT_EQ(refused("ann"), refused("nobody")) << "the answer does not say whether a login is somebody's";
    EXPECT_NE(refused("ann"), "made");
    for (const char* reserved : {"synthetic-ann", "External-Ann"}) {
        EXPECT_EQ(
            error_kind([&] { programme.people().create(administrator, reserved, "Ann", {Role::trainee}); }),
            StoreErrorKind::bad_value);
    }

    // Before there is a programme the station may use any login, but a person takes precedence.
    const QTemporaryDir folder;
    const Store store = Store::create(folder.filePath("new.db").toStdString());
    const People people(store);
    const Person taken = people.ensure_synthetic(store.station_session(), "ada", "Not Ada");
    const CreatedProgramme made = people.create_programme("P", "ada", "Ada", password);
    EXPECT_EQ(made.administrator.login(), "ada");
    EXPECT_EQ(people.find(store.station_session(), taken.id)->login.rfind("synthetic-", 0), 0U);
    EXPECT_TRUE(store.check(store.station_session()).ok);
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
    for (const Operation operation :
         {Operation::rate, Operation::release_ratings, Operation::set_goal, Operation::import_attempt})
        EXPECT_FALSE(store.allowed(as_educator, operation, Subject::person(trainee.id)))
            << operation_name(operation);
    EXPECT_THROW(Ratings(store).begin(as_educator, attempt, load_form(asset_path("forms/goals.json"))),
                 AccessDenied);
    EXPECT_THROW(Ratings(store).release(as_educator, attempt), AccessDenied);
    EXPECT_EQ(Ratings(store).to_rate(as_educator).size(), 1U) << "what there would be to rate is shown";
    EXPECT_THROW(Ratings(store).to_rate(people.demo_session("demo-trainee", Role::trainee)), AccessDenied);
    EXPECT_EQ(error_kind([&] { people.create_demo_cohort(station, "More", {}, {}); }),
              StoreErrorKind::sealed_demo);
    const Session as_trainee = people.demo_session("demo-trainee", Role::trainee);
    EXPECT_FALSE(store.allowed(as_trainee, Operation::set_goal, Subject::person(trainee.id)));
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
