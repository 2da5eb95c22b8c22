// SPDX-License-Identifier: GPL-3.0-or-later
// Stations and a programme server for the tests of the exchange.
#pragma once

#include <QFile>
#include <QSqlRecord>
#include <algorithm>
#include <sstream>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "database/records/error_reviews.h"
#include "database/records/goals.h"
#include "database/records/ratings.h"
#include "database/rows/connection.h"
#include "database/sync/programme_server.h"
#include "database/sync/sync.h"
#include "database/sync/sync_tables.h"
#include "tests/database/postgresql_server.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {

/// A further station: begins without people.
class Station {
  public:
    explicit Station(const std::string& name = "b.db") {
        path = folder.filePath(QString::fromStdString(name)).toStdString();
        store = std::make_unique<Store>(Store::create(path, false, clock.options()));
    }
    Session sign_in(const std::string& login) const { return People(*store).sign_in(login, password); }
    std::string record(const std::string& login, double points) const {
        const Session session = sign_in(login);
        Recorder recorder(path, session, example_meta(session.person_id()), clock.options());
        Programme::append_second(recorder);
        recorder.finish(example_result(true, points));
        return recorder.attempt_id();
    }
    QTemporaryDir folder;
    std::string path;
    ManualClock clock;
    std::unique_ptr<Store> store;
};

/// The rows of the exchanged tables, sorted; traces only where wanted.
inline std::vector<std::string> rows_in(Connection& connection, bool with_traces) {
    std::vector<std::string> rows;
    const auto add = [&](const char* table, const std::string& where) {
        Query all(connection, QString("SELECT * FROM %1 WHERE %2").arg(table, QString::fromStdString(where)));
        while (all.next()) {
            std::string row = table;
            for (const QVariant& value : all.row())
                row += value.isNull() ? "|-"
                                      : "|" + (value.type() == QVariant::ByteArray
                                                   ? value.toByteArray().toHex().toStdString()
                                                   : value.toString().toStdString());
            rows.push_back(std::move(row));
        }
    };
    for (const SyncTable& table : sync_tables()) {
        add(table.table, table.where);
        for (const ChildTable& child : table.children)
            if (with_traces || !child.up_only)
                add(child.table, std::string(child.key) + " IN (SELECT " + table.key[0] + " FROM " +
                                     table.table + " WHERE " + table.where + ")");
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

inline std::vector<std::string> rows_on(const ServerAddress& address, bool with_traces = true) {
    Connection server(address);
    return rows_in(server, with_traces);
}

inline std::vector<std::string> rows_at(const Store& store, bool with_traces = false) {
    return rows_in(store.connection(), with_traces);
}

inline void expect_sound(const Store& store) {
    const CheckReport report = store.check(store.station_session());
    for (const CheckItem& item : report.items)
        for (const Sentence& problem : item.problems) ADD_FAILURE() << item.name << ": " << problem.words();
}

inline void expect_sound(const ServerAddress& address) {
    const ServerCheck check = check_programme_server(address);
    EXPECT_GT(check.audit_rows, 0);
    EXPECT_EQ(check.signatures, check.audit_rows);
    for (const Sentence& problem : check.problems) ADD_FAILURE() << problem.words();
}

/// All that is said of where a person stands: every task with each of its fields, its latest attempts, the
/// days of practice and the concerns.
inline std::string words_of(const PersonStandings& person) {
    std::ostringstream words;
    words.precision(17);
    words << person.login << ' ' << person.name << ' ' << person.curriculum << ' ' << person.last_attempt
          << '\n';
    for (const PersonTask& task : person.tasks) {
        const TaskStanding& at = task.standing;
        words << at.task << ' ' << row_of(standing_names, at.standing).name << at.provisional
              << at.met_provisionally << at.one_more_day << at.one_more_pass << at.never_met << at.rated_low
              << at.stalled << at.by_override << at.overdue << ' ' << at.more_variants << ' '
              << at.rated_attempt << ' ' << at.rated_time << ' ' << at.raters << '/' << at.raters_needed
              << ' ' << at.attempts << ' ' << at.passes << ' ' << at.progress << ' ' << at.declared_at << ' '
              << at.next_check << ' ' << at.last_attempt;
        for (const std::string& one : at.waits_for) words << " waits for " << one;
        words << ' ' << (task.device_class ? static_cast<int>(*task.device_class) : -1) << ' '
              << task.first_attempt << ' ' << task.first_pass;
        for (const RecentAttempt& one : task.recent)
            words << " (" << one.attempt_id << ' ' << one.started << one.passed << one.provisional << ' '
                  << one.points.value_or(-1) << ')';
        words << '\n';
    }
    for (const PracticeDay& day : person.days) words << "day " << day.day << ' ' << day.attempts << '\n';
    for (const Concern& one : person.concerns)
        words << "concern " << static_cast<int>(one.kind) << ' ' << one.task << ' ' << one.since << ' '
              << one.attempts << ' ' << one.plateau << ' ' << one.low << ' ' << one.high << '\n';
    return words.str();
}

/// Where each real person stands, by what the store answers to `session`.
inline std::map<std::string, std::string> standings_in(const Store& store, const Session& session,
                                                       const Curriculum& curriculum) {
    std::map<std::string, std::string> all;
    for (const Person& person : People(store).list(session))
        if (person.kind == PersonKind::real)
            all[person.login] =
                words_of(Reports(store).standings(session, person.id, curriculum, ReportPurpose::screen));
    return all;
}

class Sync : public ::testing::Test {
  protected:
    void SetUp() override {
        FULCRUM_NEEDS_POSTGRESQL();
        server = PostgresqlServer::of_this_process()->new_database();
    }
    SyncResult sync(const Programme& station) const {
        return sync_with_server(*station.store, station.session("administrator"), server);
    }
    SyncResult sync(const Station& station) const {
        const bool first = !station.store->has_administrator();
        return sync_with_server(*station.store,
                                first ? station.store->station_session() : station.sign_in("administrator"),
                                server);
    }
    /// Everybody stands at both stations where they stand on the server. Returns where.
    std::map<std::string, std::string> expect_the_same_standings(const Station& b) const {
        const Curriculum curriculum = load_curriculum(asset_path("curricula/rectal.json"), task_ids());
        const auto here = standings_in(*a.store, a.session("director"), curriculum);
        EXPECT_EQ(here, standings_in(*b.store, b.sign_in("director"), curriculum));
        const Store central =
            Store::open(grant_at_programme_server(server, "director").address, a.clock.options());
        EXPECT_EQ(here, standings_in(central, People(central).account_session(), curriculum));
        EXPECT_EQ(here.count("ann") + here.count("ben"), 2U);
        return here;
    }
    /// Everything that can be exchanged: a void, a comment, an error that was struck, a rating that was
    /// released, a decision, a request.
    std::string fill(const Programme& programme) const {
        const std::string attempt = programme.record("ann", true, 81, "A2", {Programme::slip()});
        const std::string wrong = programme.record("ben", false, 12);
        programme.record_broken("ann");
        const Session& educator = programme.session("educator");
        const Reviews reviews(*programme.store);
        reviews.write(educator, attempt, 0.5, "Watch the left hand.", true);
        ErrorReviews(*programme.store)
            .add(educator, attempt, Programme::slip(), ErrorVerdict::struck, "the tissue was torn before");
        programme.attempts().void_attempt(educator, wrong, "the camera was off");
        const ObserverForm form = load_forms(asset_path("forms")).front();
        const Ratings ratings(*programme.store);
        const std::string rating = ratings.begin(educator, attempt, form);
        ratings.answer(educator, rating, FormAnswers(form.items.size(), form.items[0].highest),
                       std::vector<bool>(form.items.size(), true), "");
        ratings.hand_in(educator, rating);
        ratings.release(educator, attempt);
        const Goals goals(*programme.store);
        const std::string goal =
            goals.set(programme.session("ann"), {GoalOf::attempts, "A2", "", 3, 0}, 20'000);
        goals.change(programme.session("ann"), goal, {GoalOf::metric, "A2", "path_len", 812.5, 20'010},
                     20'000);
        return attempt;
    }
    ServerAddress server;
    Programme a;
};

}  // namespace fulcrum::database::test
