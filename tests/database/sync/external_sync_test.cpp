// SPDX-License-Identifier: GPL-3.0-or-later
// Imported traces and the programme server: they reach the other station as any attempt, the server shows
// them to those who may see them, an erasure takes them everywhere, and nothing is imported through the
// server.
#include "tests/database/external_example.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class SyncExternal : public Sync {
  protected:
    std::string import_box(const std::string& login, const std::string& digest = "aa") const {
        ExternalAttempt attempt = box_attempt(a.id(login));
        attempt.files[0].digest = digest;
        return ExternalAttempts(*a.store).add(a.session("educator"), attempt);
    }
    Store open_as(const std::string& login) const {
        return Store::open(grant_at_programme_server(server, login).address, a.clock.options());
    }
    static int rows(Connection& connection, const std::string& sql) {
        Query query(connection, QString::fromStdString(sql));
        return query.next() ? static_cast<int>(query.integer(0)) : -1;
    }
};

TEST_F(SyncExternal, ReachTheOtherStationAndAreSeenByThoseWhoMay) {
    const std::string id = import_box("ann");
    sync(a);
    const Station b;
    sync(b);
    sync(a);
    EXPECT_EQ(rows_at(*a.store), rows_at(*b.store));
    EXPECT_EQ(rows_at(*a.store), rows_on(server, false));
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);
    for (const char* login : {"ann", "educator"}) {
        const Session there = b.sign_in(login);
        const AttemptSummary stored = Attempts(*b.store).read(there, id);
        EXPECT_EQ(stored.meta.task_id, "external-peg-transfer");
        EXPECT_EQ(stored.meta.device_class, DeviceClass::external);
        EXPECT_EQ(stored.not_scored_because.id(), StatementId::recorded_elsewhere);
        EXPECT_EQ(Attempts(*b.store).score(there, id)->metrics.at(0).value, 100.0);
        EXPECT_EQ(error_kind([&] { ExternalAttempts(*b.store).trace(there, id); }), StoreErrorKind::not_found)
            << "as every trace it stays where it was stored";
    }
    // The same file at the other station: it is known there too.
    ExternalAttempt again = box_attempt(a.id("ann"));
    EXPECT_EQ(error_kind([&] { ExternalAttempts(*b.store).add(b.sign_in("educator"), again); }),
              StoreErrorKind::conflict);

    // At the server: to the person, to the educator of the cohort, to the director, and past the program.
    for (const char* login : {"ann", "educator", "director"}) {
        const Store store = open_as(login);
        EXPECT_EQ(ExternalAttempts(store).trace(People(store).account_session(), id), box_trace) << login;
        EXPECT_EQ(rows(store.connection(), "SELECT COUNT(*) FROM attempt_product"), 1) << login;
    }
    for (const char* login : {"ben", "other_educator"}) {
        const Store store = open_as(login);
        EXPECT_THROW(ExternalAttempts(store).trace(People(store).account_session(), id), std::runtime_error)
            << login;
        for (const char* table : {"attempt", "attempt_asset", "attempt_product", "score", "metric"})
            EXPECT_EQ(rows(store.connection(), std::string("SELECT COUNT(*) FROM ") + table), 0)
                << login << ": " << table;
    }
}

TEST_F(SyncExternal, AreReassignedOnlyWhereTheirTraceIs) {
    const std::string id = import_box("ann");
    sync(a);
    const Station b;
    sync(b);
    const Session there = b.sign_in("educator");
    EXPECT_EQ(error_kind([&] { Attempts(*b.store).reassign(there, id, a.id("ben"), "Ben's box"); }),
              StoreErrorKind::not_found)
        << "the copy would have a trace nowhere";
    EXPECT_EQ(Attempts(*b.store).read(there, id).state, AttemptState::completed) << "nothing was voided";
    const std::string copy = Attempts(*a.store).reassign(a.session("educator"), id, a.id("ben"), "Ben's box");
    EXPECT_EQ(ExternalAttempts(*a.store).trace(a.session("educator"), copy), box_trace);
    sync(a);
    sync(b);
    EXPECT_EQ(Attempts(*b.store).read(there, id).state, AttemptState::voided);
    const Store at_server = open_as("ben");
    EXPECT_EQ(ExternalAttempts(at_server).trace(People(at_server).account_session(), copy), box_trace);
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);
}

TEST_F(SyncExternal, AreNotImportedThroughTheServer) {
    sync(a);
    const Store store = open_as("educator");
    const Session educator = People(store).account_session();
    EXPECT_THROW(ExternalAttempts(store).add(educator, box_attempt(a.id("ann"))), std::runtime_error);
    Connection owner(server);
    for (const char* table : {"attempt", "attempt_product", "score"})
        EXPECT_EQ(rows(owner, std::string("SELECT COUNT(*) FROM ") + table), 0) << table;
    expect_sound(server);
}

TEST_F(SyncExternal, AreErasedWithThePersonEverywhere) {
    const std::string of_ann = import_box("ann"), of_ben = import_box("ben", "cc");
    sync(a);
    const Station b;
    sync(b);
    const std::string again = import_box("ann", "dd");  // not sent before the erasure
    EXPECT_FALSE(erase_at_programme_server(server, a.id("ann"), false).empty());
    expect_sound(server);
    EXPECT_EQ(sync(a).erased, 1);
    EXPECT_EQ(sync(b).erased, 1);
    Connection owner(server);
    for (Connection* connection : {&owner, &a.store->connection(), &b.store->connection()}) {
        for (const std::string& id : {of_ann, again}) {
            for (const char* table : {"attempt_product", "attempt_asset", "score"})
                EXPECT_EQ(rows(*connection, std::string("SELECT COUNT(*) FROM ") + table +
                                                " WHERE attempt_id = '" + id + "'"),
                          0)
                    << table;
            EXPECT_EQ(rows(*connection, "SELECT COUNT(*) FROM attempt WHERE id = '" + id + "'"), 0);
            EXPECT_EQ(rows(*connection,
                           "SELECT COUNT(*) FROM audit_payload p JOIN audit_entry e ON e.station_id = "
                           "p.station_id AND e.sequence = p.sequence WHERE e.object_id = '" +
                               id + "'"),
                      0)
                << "what the audit log said of it";
        }
        EXPECT_EQ(rows(*connection, "SELECT COUNT(*) FROM attempt WHERE id = '" + of_ben + "'"), 1);
    }
    EXPECT_EQ(ExternalAttempts(*a.store).trace(a.session("educator"), of_ben), box_trace);
    EXPECT_EQ(rows_at(*a.store), rows_at(*b.store));
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);
}

}  // namespace
}  // namespace fulcrum::database::test
