// SPDX-License-Identifier: GPL-3.0-or-later
// Stations and a programme server for the tests of the exchange.
#pragma once

#include <QFile>
#include <QSqlRecord>
#include <algorithm>

#include "assessment/assets/assets.h"
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
