// SPDX-License-Identifier: GPL-3.0-or-later
// One programme with rows of every kind, asked at the station that recorded it (SQLite) and at the programme
// server (PostgreSQL, whose database sorts texts by the rules of a language): every read of this floor gives
// the same, field by field, to a trainee, an educator and the director, or is refused there on purpose.
#include "tests/database/sync/server_reads.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "assessment/assets/assets.h"
#include "assessment/pathology/pathology.h"
#include "database/records/person_merge.h"
#include "database/records/tissues.h"
#include "database/rows/crypto.h"
#include "database/rows/packed_bytes.h"
#include "database/sync/programme_server.h"
#include "database/sync/sync.h"
#include "tests/database/expert_values.h"
#include "tests/database/external_example.h"
#include "tests/database/postgresql_server.h"
#include "tests/database/station_keys.h"

namespace fulcrum::database::test::reads {
namespace {

class ServerReads : public ::testing::Test {
  protected:
    void SetUp() override {
        FULCRUM_NEEDS_POSTGRESQL();
        server = PostgresqlServer::of_this_process()->new_database_sorted_as("de");
        about.tasks = fulcrum::task_ids();
        about.curriculum = edited_curriculum();
        about.loaded = load_task_and_scene("A2");
        about.key = {"A2", "standard", DeviceClass::mouse_keyboard, "standard"};
        fill_people();
        fill_site();
        fill_attempts();
        fill_endings();
        fill_reviews();
        fill_decisions();
        exchange();
    }

    /// Whose newest version has no B3 and asks for ratings of A3, which the earlier ones do not.
    Curriculum edited_curriculum() const {
        Curriculum newest = load_versions(asset_path("curricula"), "rectal", fulcrum::task_ids());
        std::vector<CurriculumTask>& tasks = newest.tasks;
        tasks.erase(std::remove_if(tasks.begin(), tasks.end(),
                                   [](const CurriculumTask& task) { return task.task == "B3"; }),
                    tasks.end());
        for (CurriculumTask& task : tasks) {
            if (task.task == "C4") task.after = {"B1", "B2"};
            if (task.task == "A3") task.ratings.emplace().form = form.id;
        }
        return newest;
    }

    const Store& store() const { return *a.store; }
    const Session& educator() const { return a.session("educator"); }

    /// Names whose order depends on the rules by which texts are sorted.
    void fill_people() {
        const std::pair<const char*, const char*> more[] = {{"zoe", "Émile Zoé"}, {"lower", "abel"},
                                                            {"upper", "Abel"},    {"mark", "_mark"},
                                                            {"arger", "Ärger"},   {"twin", "Zora"}};
        const People people = a.people();
        for (const auto& [login, name] : more) {
            const People::Created made =
                people.create(a.session("administrator"), login, name, {Role::trainee});
            const Session first = people.sign_in(login, made.one_time_password);
            a.sessions.emplace(login, people.change_password(first, made.one_time_password, password));
        }
        const Session& director = a.session("director");
        people.set_members(
            director, a.cohort,
            {a.id("ann"), a.id("ben"), a.id("zoe"), a.id("lower"), a.id("upper"), a.id("mark")});
        const std::string other = people.create_cohort(director, "årgang 2");
        people.set_members(director, other, {a.id("arger"), a.id("eve"), a.id("twin")});
        people.set_educators(director, other, {a.id("other_educator")});
        about.cohorts = {a.cohort, other};
        about.trainee = a.id("ann");
        for (const auto& [login, session] : a.sessions) {
            if (session.is_station()) continue;
            about.people.push_back(session.person_id());
            about.logins.push_back(login);
        }
    }

    /// What the site has made its own. Whoever accepted the set teaches nobody whom the others see.
    void fill_site() {
        const std::string text = R"({"provisional": false})";
        about.files = {{"benchmarks/own.json", sha256_hex(text)}, {"benchmarks/other.json", sha256_hex("")}};
        AcceptedAssets(store()).accept(a.session("other_educator"), about.files[0], "our experts", text);
        Tissues(store()).set(educator(), "B2", 0, {{"areolar", {{"penetrate_n", 0.1}}}}, "measured here");
        ReportSchedule wish;
        wish.cohort_id = a.cohort;
        wish.format = "csv";
        wish.folder = "/srv/reports";
        Schedules(store()).add(a.session("director"), wish);
    }

    using Change = std::function<void(AttemptMeta&, AttemptResult&)>;
    std::string record(const std::string& login, const Change& change = {}) {
        a.clock.pass_s(3600);
        AttemptMeta meta = example_meta(a.id(login));
        AttemptResult result = example_result(true, 70);
        if (change) change(meta, result);
        Recorder recorder(a.path, a.session(login), meta, a.clock.options());
        Programme::append_second(recorder, meta.origin ? meta.origin->tick + 1 : 0);
        if (!meta.origin) recorder.append(Programme::slip());
        recorder.finish(result);
        about.attempts.push_back(recorder.attempt_id());
        return recorder.attempt_id();
    }

    void fill_attempts() {
        const Curriculum& first = about.curriculum.older.back();
        of_ann = record("ann", [&](AttemptMeta& meta, AttemptResult&) {
            meta.curriculum = first.name();
            meta.assets = {{"curricula/" + first.file, sha256_hex(first.text)}, about.files[0]};
            meta.limits = "own@1";
        });
        // From which limits can be built, and that can be held against others.
        const BenchmarkSet set = load_benchmark(asset_path("benchmarks/A2-mouse-keyboard.json"));
        for (int i = 0; i < 5; ++i)
            record("ann", [&](AttemptMeta& meta, AttemptResult& result) {
                meta.task_version = about.loaded.task.version;
                meta.scene = about.loaded.scene_file;
                meta.scene_text = about.loaded.scene_text;
                write_expert_values(about.loaded.task, set, 0.1 * i, *result.score);
            });
        double points = 40;
        for (const char* login : {"zoe", "lower", "upper", "mark", "arger", "eve", "twin"})
            record(login, [&](AttemptMeta& meta, AttemptResult& result) {
                points += 3.25;
                result.score = example_score(points > 50, points);
                meta.started = noon + 1;  // all at one moment
                meta.utc_offset_min = -90;
            });
        record("ann", [&](AttemptMeta& meta, AttemptResult& result) {
            meta.mode = AttemptMode::practice;
            meta.variant = "long_jaws";
            meta.origin.emplace();
            meta.origin->source_id = of_ann;
            meta.origin->tick = 4200;
            meta.origin->goal = 1;
            meta.origin->build = "0.1.0 physics 2";
            meta.origin->state = pack_bytes({1, 2, 3, 0, 255});
            result.score.reset();
        });
        record("ann", [](AttemptMeta& meta, AttemptResult& result) {
            meta.task_id = "B1";
            meta.task_version = 2;
            meta.force_devices[0].emplace();
            result.score->critical_errors.push_back(
                {0.5, "perforation", "left", "colon", "It's \\ \"torn\"?"});
            const SpecimenPlan plan{
                4, 0.06, 0.02, 0.003, 0.006, 0.018, 0.002, 0.01, Tumour{1, Sector::mid, 0.008, 0.012}};
            result.score->pathology = pathology_json(pathology_report({}, plan));
            result.products.push_back({"damage", {0, 1, 254, 255}});
        });
    }

    /// Ends of every kind; what was voided, moved and imported.
    void fill_endings() {
        for (const AttemptState state : {AttemptState::abandoned, AttemptState::timed_out})
            record("ben", [&](AttemptMeta& meta, AttemptResult& result) {
                meta.task_id = "B1";
                result.state = state;
                result.score = example_score(false, 12);
            });
        for (int i = 0; i < 3; ++i)
            record("ben", [&](AttemptMeta& meta, AttemptResult& result) {
                meta.task_id = "A3";
                result.state = i == 1 ? AttemptState::failed_simulation : AttemptState::interrupted;
                result.score->passed.reset();
            });
        a.clock.pass_s(3600);
        about.attempts.push_back(a.record_broken("zoe"));
        a.open();
        a.attempts().void_attempt(educator(), record("ben"), "the camera was off");
        about.attempts.push_back(
            a.attempts().reassign(educator(), record("ben"), a.id("ann"), "Ann sat there"));
        about.attempts.push_back(ExternalAttempts(store()).add(educator(), box_attempt(a.id("ann"))));
    }

    void rate(const std::string& login, const std::string& attempt) const {
        FormAnswers answers;
        for (const FormItem& item : form.items) answers.push_back(item.highest);
        const Ratings ratings(store());
        const Session& rater = a.session(login);
        const std::string rating = ratings.begin(rater, attempt, form);
        ratings.answer(rater, rating, answers, std::vector<bool>(form.items.size(), true), "Steady.");
        ratings.hand_in(rater, rating);
    }

    void fill_reviews() {
        a.clock.pass_s(60);
        const Reviews reviews(store());
        reviews.write(educator(), of_ann, 0.75, "Später: % _ ' \\ ?", true);
        reviews.write(educator(), of_ann, 0.25, "Watch the left hand.", true);
        const ErrorReviews errors(store());
        errors.add(educator(), of_ann, Programme::slip(), ErrorVerdict::struck, "the tissue was torn before");
        errors.add(educator(), of_ann, Programme::slip(), ErrorVerdict::confirmed, "on second thoughts");
        a.attempts().add_score(educator(), of_ann, example_score(false, 55.5));
        rate("educator", of_ann);
        rate("director", of_ann);
        a.clock.pass_s(60);
        Ratings(store()).release(educator(), of_ann);
        rate("director", about.attempts[1]);  // is not released
        a.attempts().request_correction(a.session("ann"), of_ann, "this was not me");
    }

    void fill_decisions() {
        const auto decide = [&](const char* login, const char* task, StandingOverride::Kind kind) {
            a.clock.pass_s(60);
            Standings(store()).decide(educator(), a.id(login), task, kind, "examined in theatre");
        };
        for (const char* task : {"A1", "A2", "A3"}) decide("ann", task, StandingOverride::Kind::proficient);
        decide("ben", "B1", StandingOverride::Kind::unlocked);
        a.clock.pass_s(60);
        Curricula(store()).move(educator(), {a.id("ann")}, about.curriculum, about.curriculum.name(),
                                "a new course");
        const Goals goals(store());
        const Session& ann = a.session("ann");
        const std::int64_t today = day_at(store().now(), 0);
        goals.set(ann, {GoalOf::attempts, "A2", "", 3, 0}, today);
        goals.set(ann, {GoalOf::metric, "A2", "path_len", 812.5, today + 10}, today);
        goals.drop(ann, goals.set(ann, {GoalOf::attempts, "", "", 5, 0}, today));
        PersonMerge(store()).merge(a.session("administrator"), a.id("twin"), a.id("upper"), "entered twice");
        for (const Certificate& one : certificates(store(), ann, a.id("ann"), about.curriculum))
            about.codes.push_back(one.code);
        about.codes.push_back("0000-0000-0000-0000");
    }

    /// With an erasure, which only the server begins from then on.
    void exchange() {
        const auto once = [&] {
            const SyncResult result = sync_with_server(store(), a.session("administrator"), server);
            EXPECT_TRUE(result.complete);
            for (const Sentence& conflict : result.conflicts) ADD_FAILURE() << conflict.words();
        };
        once();
        erase_at_programme_server(server, a.id("eve"), false);
        once();
    }

    /// The station's store as whoever only reads it has it: a read that writes would fail.
    Store station() const {
        StoreOptions options = a.clock.options();
        options.read_only = true;
        return Store::open(a.path, options);
    }
    Store opened_as(const std::string& login) const {
        return Store::open(grant_at_programme_server(server, login).address, a.clock.options());
    }

    void expect_the_same_answers() const;
    void expect_refusals() const;

    Programme a;
    KeysOfOneTest own_keys;  // the erasure is noted next to them
    ServerAddress server;
    const ObserverForm form = load_forms(asset_path("forms")).front();
    Subjects about;
    std::string of_ann;
};

template <typename Row>
std::string answer_of(const Row& row, const Asked& asked) {
    try {
        return row.ask(asked);
    } catch (const AccessDenied&) {
        return hidden;
    } catch (const std::exception& error) {
        ADD_FAILURE() << row.name << " as " << asked.session.login() << " at "
                      << (asked.store.is_server() ? "the server" : "the station") << ": " << error.what();
        return hidden;
    }
}

/// More than that nothing may be seen, or that there is nothing.
bool says_something(std::string answer) {
    const std::string none = hidden;
    for (std::size_t at = answer.find(none); at != std::string::npos; at = answer.find(none, at))
        answer.erase(at, none.size());
    return std::any_of(answer.begin(), answer.end(),
                       [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; });
}

/// What is around the first difference.
std::string difference(const std::string& here, const std::string& there) {
    std::size_t at = 0;
    while (at < here.size() && at < there.size() && here[at] == there[at]) ++at;
    const std::size_t from = at > 200 ? at - 200 : 0;
    return "\nstation: ..." + here.substr(from, 400) + "\nserver:  ..." +
           (from < there.size() ? there.substr(from, 400) : std::string());
}

void ServerReads::expect_the_same_answers() const {
    const Store here = station();
    std::set<std::string> said_by;
    for (const char* login : {"director", "educator", "ann"}) {
        const Store there = opened_as(login);
        const Session account = People(there).account_session();
        for (const Read& row : answered) {
            const std::string at_station = answer_of(row, {here, a.session(login), about}),
                              at_server = answer_of(row, {there, account, about});
            EXPECT_TRUE(at_station == at_server)
                << row.name << " as " << login << difference(at_station, at_server);
            if (says_something(at_station)) said_by.insert(row.name);
        }
    }
    for (const Read& row : answered)
        EXPECT_EQ(said_by.count(row.name), 1U) << row.name
                                               << " had nothing to say: the programme of this "
                                                  "test has no rows for it";
}

void ServerReads::expect_refusals() const {
    const Store here = station();
    std::set<std::string> asked_by;
    for (const char* login : {"director", "educator", "ann"}) {
        const Store there = opened_as(login);
        const Session account = People(there).account_session();
        for (const Refused& row : refused) {
            try {
                row.ask({here, a.session(login), about});
            } catch (const AccessDenied&) {
                continue;  // not in this role
            }
            asked_by.insert(row.name);
            try {
                row.ask({there, account, about});
                ADD_FAILURE() << row.name << " as " << login << " was answered; " << row.why;
            } catch (const AccessDenied& error) {
                EXPECT_EQ(error.why(), DenialReason::server_only_read) << row.name << " as " << login;
            }
        }
        // Values of tissues are the site's own, so the server has none.
        EXPECT_EQ(Tissues(here).in_force(a.session(login), "B2").version, 1) << login;
        EXPECT_EQ(Tissues(there).in_force(account, "B2").version, 0) << login;
        EXPECT_TRUE(Tissues(there).history(account, "B2").empty()) << login;
        EXPECT_EQ(Audit(there).signer_of(of_ann), "") << login;
    }
    for (const Refused& row : refused) EXPECT_EQ(asked_by.count(row.name), 1U) << row.name;
    // Whoever looks after accounts and stations, and reads the audit log, has no account at a server.
    EXPECT_EQ(error_kind([&] { grant_at_programme_server(server, "administrator"); }),
              StoreErrorKind::bad_value);
}

// One test: the programme is made and exchanged once.
TEST_F(ServerReads, GiveTheSameFromBothEnginesOrSayWhereElseTheyAreAnswered) {
    ASSERT_GE(about.codes.size(), 2U) << "a certificate, and a code of none";
    expect_the_same_answers();
    expect_refusals();
}

}  // namespace
}  // namespace fulcrum::database::test::reads
