// SPDX-License-Identifier: GPL-3.0-or-later
// The access table cell by cell: the pure rule, then every store call in every role on every kind of person.
#include <functional>
#include <optional>

#include "assessment/assets/assets.h"
#include "database/records/error_reviews.h"
#include "database/records/external_attempts.h"
#include "database/records/goals.h"
#include "database/records/ratings.h"
#include "database/records/standings.h"
#include "database/records/tissues.h"
#include "database/rows/connection.h"
#include "database/store/accepted_assets.h"
#include "database/store/signing_keys.h"
#include "database/sync/person_data.h"
#include "database/sync/programme_server.h"
#include "database/sync/station_erasure.h"
#include "database/sync/sync.h"
#include "tests/database/access_expectation.h"
#include "tests/database/postgresql_server.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

TEST(AccessTable, EveryOperationOnceAndEveryCellAsWritten) {
    ASSERT_EQ(std::size(expected_table), static_cast<std::size_t>(operation_count));
    for (int i = 0; i < operation_count; ++i) {
        const auto operation = static_cast<Operation>(i);
        for (const Role role : all_roles) {
            EXPECT_EQ(scope_of(role, operation), expected_scope(operation, role))
                << operation_name(operation) << " " << role_name(role);
            for (int bits = 0; bits < 8; ++bits) {
                const Relation relation{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
                const bool own_forbidden = relation.own && expected_never_own(operation);
                EXPECT_EQ(permits(role, operation, relation),
                          !own_forbidden && covers(expected_scope(operation, role), relation))
                    << operation_name(operation) << " " << role_name(role) << " " << bits;
            }
        }
    }
}

TEST(AccessTable, AdministratorsSeeNoScoresTracesOrReviews) {
    for (const Operation operation :
         {Operation::read_attempt, Operation::read_trace, Operation::read_progress,
          Operation::read_cohort_table, Operation::read_comment, Operation::read_requests,
          Operation::export_person, Operation::export_cohort, Operation::perform_attempt}) {
        EXPECT_EQ(scope_of(Role::administrator, operation), Scope::none) << operation_name(operation);
    }
}

const ObserverForm& goals() {
    static const ObserverForm form = load_form(asset_path("forms/goals.json"));
    return form;
}

GoalWish weekly() {
    return {GoalOf::attempts, "", "", 3, 0};
}

/// One person, one finished attempt with a sent and an unsent comment, one interrupted attempt, one cohort.
struct Target {
    std::string name, person, attempt, interrupted, comment, cohort, goal = {};
    Relation relation_to(const Session& session, const Programme& programme) const {
        Relation relation;
        relation.own = person == session.person_id();
        relation.in_cohort = session.login() == "educator" && (name == "ann" || name == "teacher");
        relation.synthetic = name == "robot";
        static_cast<void>(programme);
        return relation;
    }
};

class EveryCell : public ::testing::Test {
  protected:
    void SetUp() override {
        const Session& director = programme.session("director");
        // An educator who trains as well and is a member of the cohort they teach: the case in which "never
        // one's own" matters.
        programme.people().set_roles(programme.session("administrator"), programme.id("educator"),
                                     {Role::trainee, Role::educator});
        programme.people().set_members(director, programme.cohort,
                                       {programme.id("ann"), programme.id("ben"), programme.id("educator")});
        other_cohort = programme.people().create_cohort(director, "Elsewhere");
        programme.people().set_members(director, other_cohort, {programme.id("eve")});
        programme.people().set_educators(director, other_cohort, {programme.id("other_educator")});
        const Session teacher_as_trainee =
            programme.people().act_as(programme.session("educator"), Role::trainee);
        const Person robot =
            programme.people().ensure_synthetic(programme.session("station"), "synthetic-robot", "Robot");

        targets.push_back(
            make_target("ann", programme.session("ann"), programme.id("ann"), programme.cohort, "educator"));
        targets.push_back(make_target("eve", programme.session("eve"), programme.id("eve"), other_cohort,
                                      "other_educator"));
        targets.push_back(make_target("teacher", teacher_as_trainee, programme.id("educator"),
                                      programme.cohort, "educator"));
        targets.push_back(make_target("robot", programme.session("station"), robot.id, "", ""));
        programme.open();
        ASSERT_EQ(programme.store->interrupted_at_open().size(), targets.size());
    }

    Target make_target(const std::string& name, const Session& performer, const std::string& person,
                       const std::string& cohort, const std::string& author) {
        Target target;
        target.name = name;
        target.person = person;
        target.cohort = cohort;
        AttemptMeta meta = example_meta(person);
        if (name == "robot") meta.device_class = DeviceClass::synthetic;
        {
            Recorder recorder(programme.path, performer, meta, programme.clock.options());
            Programme::append_second(recorder);
            recorder.append(Programme::slip());
            recorder.finish(example_result(true, 60));
            target.attempt = recorder.attempt_id();
        }
        {
            Recorder recorder(programme.path, performer, meta, programme.clock.options());
            Programme::append_second(recorder);
            target.interrupted = recorder.attempt_id();
        }
        if (name != "robot") target.goal = Goals(*programme.store).set(performer, weekly(), 20'000);
        if (!author.empty()) {
            target.comment = Reviews(*programme.store)
                                 .write(programme.session(author), target.attempt, 1.0, "Look here.", true);
        }
        return target;
    }

    /// The store's call for an operation on a target; nothing where the operation has no such target.
    std::function<void()> call(Operation operation, const Session& session, const Target& target) {
        const Store& store = *asked();
        const People people(store);
        const Attempts attempts(store);
        const Reviews reviews(store);
        const Reports reports(store);
        const Tissues tissues(store);
        using F = std::function<void()>;
        switch (operation) {
            case Operation::read_sign_in_list:
                return [=] { people.recent_sign_ins(session); };
            case Operation::list_people:
                return [=] { people.find(session, target.person); };
            case Operation::manage_people:
                return [=] { people.rename(session, target.person, "Renamed"); };
            case Operation::manage_roles:
                return target.name == "robot" ? F() : [=] {
                    people.set_roles(session, target.person, {Role::trainee});
                };
            case Operation::issue_one_time_password:
                return target.name == "robot" ? F() : [=] {
                    people.issue_one_time_password(session, target.person);
                };
            case Operation::change_password:
                return target.person != session.person_id() ? F() : [=] {
                    people.change_password(session, password, "another horse battery");
                };
            case Operation::create_synthetic:
                return target.name != "robot" ? F() : [=] {
                    people.ensure_synthetic(session, "synthetic-robot-2", "Robot 2");
                };
            case Operation::list_cohorts:
                return target.cohort.empty() ? F() : [=] {
                    if (!people.find_cohort(session, target.cohort))
                        throw AccessDenied("list_cohorts", "", DenialReason::outside_people);
                };
            case Operation::manage_cohorts:
                return target.cohort.empty() ? F() : [=] {
                    people.rename_cohort(session, target.cohort, "Renamed");
                };
            case Operation::perform_attempt:
                return [=] {
                    AttemptMeta meta = example_meta(target.person);
                    if (target.name == "robot") meta.device_class = DeviceClass::synthetic;
                    const Recorder recorder(asked()->path(), session, meta, programme.clock.options());
                };
            case Operation::read_attempt:
                return [=] {
                    attempts.read(session, target.attempt);
                    attempts.scores(session, target.attempt);
                };
            case Operation::read_trace:
                return [=] { attempts.read_trace(session, target.attempt); };
            case Operation::read_progress:
                return [=] { reports.person_progress(session, target.person, "A2"); };
            case Operation::read_cohort_table:
                return target.cohort.empty() ? F() : [=] { reports.cohort_table(session, target.cohort); };
            case Operation::score_interrupted:
                return [=] { attempts.add_score(session, target.interrupted, example_score(false, 0)); };
            case Operation::recompute_score:
                return [=] { attempts.add_score(session, target.attempt, example_score(false, 0)); };
            case Operation::comment:
                return [=] { reviews.write(session, target.attempt, 2.0, "And here.", true); };
            case Operation::review_error:
                return [=] {
                    ErrorReviews(*asked()).add(session, target.attempt, Programme::slip(),
                                               ErrorVerdict::struck, "the camera was in the way");
                };
            case Operation::read_comment:
                return [=] { reviews.comments(session, target.attempt); };
            case Operation::mark_comment_read:
                return target.comment.empty() ? F() : [=] { reviews.mark_read(session, target.comment); };
            case Operation::void_attempt:
                return [=] { attempts.void_attempt(session, target.attempt, "wrong person"); };
            case Operation::reassign_attempt:
                return
                    [=] { attempts.reassign(session, target.attempt, programme.id("ben"), "wrong person"); };
            case Operation::decide_standing:
                return [=] {
                    Standings(*asked()).decide(session, target.person, "B1", StandingOverride::Kind::unlocked,
                                               "moved here");
                };
            case Operation::request_correction:
                return [=] { attempts.request_correction(session, target.attempt, "this was not me"); };
            case Operation::read_requests:
                return [=] { attempts.correction_requests(session); };
            case Operation::export_person:
                return
                    [=] { reports.person_progress(session, target.person, "A2", ReportPurpose::exported); };
            case Operation::export_cohort:
                return target.cohort.empty() ? F() : [=] {
                    reports.cohort_table(session, target.cohort, {}, ReportPurpose::exported);
                };
            case Operation::view_audit:
                return [=] { Audit(*asked()).entries(session); };
            case Operation::check_store:
                return [=] { asked()->check(session); };
            case Operation::backup:
                return [=] {
                    asked()->backup(session,
                                    programme.folder.filePath(QString::number(++backups)).toStdString());
                };
            case Operation::erase_person:
                return [=] { erase_person(*asked(), session, target.person, "asked for it", true); };
            case Operation::export_all:
                return [=] { export_person_data(*asked(), session, target.person, {}, {}); };
            case Operation::rotate_key:
                return [=] { rotate_station_key(*asked(), session, "planned"); };
            case Operation::manage_settings:
                return [=] { people.set_sign_in_picker(session, false); };
            case Operation::read_tissues:
                return [=] { tissues.in_force(session, "B2"); };
            case Operation::set_tissues:
                return [=] {
                    tissues.set(session, "B2", 0, {{"areolar", {{"penetrate_n", 0.1}}}}, "measured here");
                };
            case Operation::accept_assets:
                return [=] {
                    AcceptedAssets(*asked()).accept(
                        session, {"benchmarks/A2.json", std::to_string(++backups)}, "our experts");
                };
            case Operation::rate:
                return [=] { Ratings(*asked()).begin(session, target.attempt, goals()); };
            case Operation::read_ratings:
                return [=] { Ratings(*asked()).of_attempt(session, target.attempt); };
            case Operation::release_ratings:
                return [=] { Ratings(*asked()).release(session, target.attempt); };
            case Operation::set_goal:
                // One's own is set; another's is refused when it is to be dropped. A robot has none.
                if (target.goal.empty()) return F();
                if (target.person == session.person_id())
                    return [=] { Goals(*asked()).set(session, weekly(), 20'000); };
                return [=] { Goals(*asked()).drop(session, target.goal); };
            case Operation::read_goals:
                return [=] { Goals(*asked()).of_person(session, target.person); };
            case Operation::import_attempt:
                return [=] {
                    ExternalAttempt box;
                    box.person_id = target.person;
                    box.exercise = "peg-transfer";
                    box.source = "box trainer";
                    box.performed = noon - 1000;
                    box.duration_s = 1;
                    box.trace = "t\ns\n0\n1\n";
                    ExternalAttempts(*asked()).add(session, box);
                };
        }
        return F();
    }

    /// Operations whose calls are about a whole store, a list that is filtered, or the caller.
    static bool about_nobody(Operation operation) {
        return operation == Operation::read_sign_in_list || operation == Operation::read_requests ||
               operation == Operation::view_audit || operation == Operation::check_store ||
               operation == Operation::backup || operation == Operation::manage_settings ||
               operation == Operation::create_synthetic || operation == Operation::read_tissues ||
               operation == Operation::set_tissues || operation == Operation::accept_assets ||
               operation == Operation::rotate_key;
    }

    /// The store whose answers are looked at.
    const Store* asked() const { return server_store ? &*server_store : programme.store.get(); }
    bool expects(Operation operation, const Session& session, const Target& target, Subject& subject) const;
    void expect_server_answers(const Session& session, Operation operation, const Target& target) const;

    Programme programme;
    std::optional<Store> server_store;
    std::string other_cohort;
    std::vector<Target> targets;
    int backups = 0;
};

bool EveryCell::expects(Operation operation, const Session& session, const Target& target,
                        Subject& subject) const {
    Relation relation = target.relation_to(session, programme);
    const bool about_cohort = operation == Operation::list_cohorts ||
                              operation == Operation::read_cohort_table ||
                              operation == Operation::manage_cohorts || operation == Operation::export_cohort;
    if (about_cohort) {
        relation.in_cohort = session.login() == "educator" && target.cohort == programme.cohort;
        relation.own =
            (session.login() == "ann" || session.login() == "educator") && target.cohort == programme.cohort;
    }
    const Scope scope = expected_scope(operation, session.role());
    const bool own_forbidden = relation.own && expected_never_own(operation);
    subject = about_nobody(operation) ? Subject::nothing()
              : about_cohort          ? Subject::cohort(target.cohort)
                                      : Subject::person(target.person);
    return about_nobody(operation) ? scope != Scope::none : covers(scope, relation) && !own_forbidden;
}

TEST_F(EveryCell, TheStoreAnswersAsTheTableSays) {
    std::vector<Session> sessions = {programme.session("ann"), programme.session("educator"),
                                     programme.session("director"), programme.session("administrator"),
                                     programme.session("station")};
    sessions[1] = programme.people().act_as(sessions[1], Role::educator);
    sessions.push_back(programme.people().act_as(sessions[1], Role::trainee));
    int allowed = 0, refused = 0;
    for (int i = 0; i < operation_count; ++i) {
        const auto operation = static_cast<Operation>(i);
        for (const Session& session : sessions) {
            for (const Target& target : targets) {
                const auto action = call(operation, session, target);
                if (!action) continue;
                const std::string cell = std::string(operation_name(operation)) + " as " +
                                         role_name(session.role()) + " (" + session.login() + ") on " +
                                         target.name;
                Subject subject;
                const bool expected = expects(operation, session, target, subject);
                EXPECT_EQ(programme.store->allowed(session, operation, subject), expected) << cell;

                const std::int64_t rows_before = Audit(*programme.store).count();
                // What a cell does is undone before the next; the recorder and the backup have connections of
                // their own.
                std::optional<Transaction> undone;
                if (operation != Operation::perform_attempt && operation != Operation::backup)
                    undone.emplace(programme.store->connection());
                if (expected) {
                    EXPECT_NO_THROW(action()) << cell;
                    ++allowed;
                } else {
                    EXPECT_THROW(action(), AccessDenied) << cell;
                    EXPECT_EQ(Audit(*programme.store).count(), rows_before) << cell;
                    ++refused;
                }
            }
        }
    }
    EXPECT_GT(allowed, 150);
    EXPECT_GT(refused, 250);
}

/// What is only done at a station, or with `fulcrum server`.
bool at_stations_only(Operation operation) {
    switch (operation) {
        case Operation::list_people:
        case Operation::list_cohorts:
        case Operation::read_attempt:
        case Operation::read_trace:
        case Operation::read_progress:
        case Operation::read_cohort_table:
        case Operation::read_comment:
        case Operation::read_requests:
        case Operation::export_person:
        case Operation::export_cohort:
        case Operation::read_tissues:
        case Operation::read_ratings:
        case Operation::read_goals:
            return false;
        default:
            return true;
    }
}

void EveryCell::expect_server_answers(const Session& session, Operation operation,
                                      const Target& target) const {
    const auto action = const_cast<EveryCell*>(this)->call(operation, session, target);
    if (!action) return;
    Subject subject;
    const bool at_station = expects(operation, session, target, subject);
    // Simulated people are not on a server.
    const bool expected =
        at_station && !at_stations_only(operation) && (target.name != "robot" || about_nobody(operation));
    const std::string cell = std::string(operation_name(operation)) + " as " + role_name(session.role()) +
                             " (" + session.login() + ") on " + target.name;
    EXPECT_EQ(server_store->allowed(session, operation, subject), expected) << cell;
    if (expected) {
        EXPECT_NO_THROW(action()) << cell;
        return;
    }
    // What the row policies hide is not there at all.
    try {
        action();
        EXPECT_EQ(operation, Operation::list_people) << cell;  // whom one may not see, it does not find
        EXPECT_FALSE(People(*server_store).find(session, target.person)) << cell;
    } catch (const AccessDenied&) {
    } catch (const StoreError& error) {
        EXPECT_EQ(error.kind(), StoreErrorKind::not_found) << cell << ": " << error.what();
    }
}

TEST_F(EveryCell, AProgrammeServerAnswersAsTheTableSaysAndWritesNothing) {
    FULCRUM_NEEDS_POSTGRESQL();
    PostgresqlServer& postgresql = *PostgresqlServer::of_this_process();
    const ServerAddress server = postgresql.new_database();
    sync_with_server(*programme.store, programme.session("administrator"), server);
    const auto rows = [&] {
        Connection connection(server);
        std::string all;
        for (const char* table : {"attempt", "score", "comment", "error_review", "attempt_void", "rating",
                                  "person", "cohort", "standing_override", "audit_entry"}) {
            Query count(connection, QString("SELECT COUNT(*) FROM %1").arg(table));
            all += count.next() ? count.text(0) + " " : "";
        }
        return all;
    };
    const std::string before = rows();
    int roles = 0;
    for (const char* login : {"ann", "educator", "director", "other_educator"}) {
        const ServerAccount account = grant_at_programme_server(server, login);
        server_store.emplace(Store::open(account.address, programme.clock.options()));
        ASSERT_TRUE(server_store->is_server());
        for (const Role role : account.roles) {
            ++roles;
            const Session session = People(*server_store).account_session(role);
            EXPECT_EQ(session.login(), login);
            for (int i = 0; i < operation_count; ++i)
                for (const Target& target : targets)
                    if (std::string(login) != "other_educator")
                        expect_server_answers(session, static_cast<Operation>(i), target);
            // Past the program: the connection itself takes no write.
            for (const char* sql : {"UPDATE score SET points = 100", "DELETE FROM attempt",
                                    "INSERT INTO erasure (person_id, time) VALUES ('x', 1)"})
                EXPECT_THROW(server_store->connection().execute(sql), StoreError) << sql;
        }
    }
    EXPECT_EQ(roles, 5) << "the educator trains as well";
    EXPECT_EQ(rows(), before);
    // An administrator looks after accounts and stations, which a server has none of.
    EXPECT_EQ(error_kind([&] { grant_at_programme_server(server, "administrator"); }),
              StoreErrorKind::bad_value);
}

TEST_F(EveryCell, ListsLeaveOutWhatTheRoleMayNotSee) {
    const Attempts attempts(*programme.store);
    const People people(*programme.store);
    EXPECT_EQ(attempts.list(programme.session("ann")).size(), 2U);
    EXPECT_EQ(attempts.list(people.act_as(programme.session("educator"), Role::educator)).size(), 4U);
    EXPECT_EQ(attempts.list(programme.session("other_educator")).size(), 2U);
    EXPECT_EQ(attempts.list(programme.session("director")).size(), 8U);
    EXPECT_EQ(attempts.list(programme.session("station")).size(), 2U);
    EXPECT_THROW(attempts.list(programme.session("administrator")), AccessDenied);
    EXPECT_EQ(people.list(programme.session("ann")).size(), 1U);
    EXPECT_EQ(people.list(people.act_as(programme.session("educator"), Role::educator)).size(), 3U);
    EXPECT_EQ(people.list(programme.session("administrator")).size(), 8U);
    EXPECT_EQ(people.list(programme.session("station")).size(), 1U);
    // A trainee learns which cohort they are in, not who else is.
    const auto cohorts = people.cohorts(programme.session("ann"));
    ASSERT_EQ(cohorts.size(), 1U);
    EXPECT_EQ(cohorts[0].members, std::vector<std::string>{programme.id("ann")});
}

TEST_F(EveryCell, AWithdrawnRoleOrAnInactivePersonEndsTheSession) {
    const Session& administrator = programme.session("administrator");
    const Attempts attempts(*programme.store);
    EXPECT_NO_THROW(attempts.read(programme.session("eve"), targets[1].attempt));
    programme.people().set_active(administrator, programme.id("eve"), false);
    EXPECT_THROW(attempts.read(programme.session("eve"), targets[1].attempt), AccessDenied);
    programme.people().set_active(administrator, programme.id("eve"), true);
    programme.people().set_roles(administrator, programme.id("eve"), {Role::educator});
    EXPECT_THROW(attempts.read(programme.session("eve"), targets[1].attempt), AccessDenied);
    EXPECT_THROW(attempts.list(programme.session("eve")), AccessDenied);
}

TEST_F(EveryCell, ASessionServesOnlyItsOwnStore) {
    Store other = Store::create(programme.folder.filePath("other.db").toStdString());
    EXPECT_THROW(People(other).list(programme.session("director")), AccessDenied);
    EXPECT_THROW(other.check(programme.session("station")), AccessDenied);
}

}  // namespace
}  // namespace fulcrum::database::test
