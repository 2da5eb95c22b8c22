// SPDX-License-Identifier: GPL-3.0-or-later
// The programme server on the page Station, and the recording of another station in a review.
#include <QFile>
#include <QFileInfo>
#include <QFrame>
#include <QPushButton>

#include "database/rows/connection.h"
#include "database/store/station_key.h"
#include "database/sync/enrolment.h"
#include "database/sync/server_enrolment.h"
#include "database/sync/server_link.h"
#include "database/sync/sync.h"
#include "tests/app/services/window_access.h"
#include "tests/database/postgresql_server.h"
#include "tests/database/station_keys.h"
#include "ui/review/debrief_page.h"

namespace fulcrum::app::program_test {
namespace {

using database::test::PostgresqlServer;

void use_station_page(MainWindow& window, const QString& server, const QString& token) {
    const auto complaint = [&] { return find<QLabel>(window, "message_text")->text(); };
    const auto result = [&] {
        return sees(window, "server_result") ? find<QLabel>(window, "server_result")->text() : QString();
    };
    click(window, "rail_station");
    EXPECT_TRUE(find<QLabel>(window, "server_place")->text().contains("Enrolled at postgresql://station_"));
    EXPECT_FALSE(sees(window, "enrol_station"));
    click(window, "exchange_now");
    ASSERT_TRUE(wait_for([&] { return result().contains("agree"); }));
    bring(*find<QPushButton>(window, "exchange_now"));
    keep_picture(window, "station-server");
    click(window, "enrol_again");
    type(window, "server_address", server);
    EXPECT_FALSE(find<QPushButton>(window, "enrol_station")->isEnabled()) << "without a token";
    QString mistyped = token;
    mistyped[3] = mistyped[3] == 'A' ? 'B' : 'A';
    type(window, "server_token", mistyped);
    bring(*find<QPushButton>(window, "enrol_station"));
    keep_picture(window, "station-server-form");
    click(window, "enrol_station");
    ASSERT_TRUE(wait_for([&] { return sees(window, "message_text") && complaint().contains("mistyped"); }));
    click(window, "close_message");
    click(window, "enrol_again");
    type(window, "server_token", token);
    click(window, "enrol_station");
    ASSERT_TRUE(wait_for([&] { return result().contains("agree"); })) << result().toStdString();
    EXPECT_TRUE(sees(window, "enrol_again"));
}

/// Enrolled again after its file was lost, and stopped while the first exchange waits for the server: the
/// station is enrolled, and the page says so and offers the exchange.
void stop_first_exchange(MainWindow& window, const ServerAddress& server, const std::string& station_id,
                         const QString& token) {
    const auto result = [&] {
        return sees(window, "server_result") ? find<QLabel>(window, "server_result")->text() : QString();
    };
    const QFileInfo key(QString::fromStdString(StationKey::path_of(station_id)));
    ASSERT_TRUE(QFile::remove(key.path() + "/" + key.completeBaseName() + ".server"));
    click(window, "rail_station");
    EXPECT_FALSE(sees(window, "exchange_now"));
    type(window, "server_address", QString::fromStdString(server.text()));
    type(window, "server_token", token);
    Connection other(server), watch(server);
    const auto count = [&](const char* sql) {
        Query row(watch, sql);
        return row.next() ? row.integer(0) : -1;
    };
    Transaction lock(other);
    other.execute("LOCK TABLE person IN ACCESS EXCLUSIVE MODE");
    click(window, "enrol_station");
    ASSERT_TRUE(wait_for([&] { return count("SELECT COUNT(*) FROM pg_locks WHERE NOT granted") > 0; }));
    EXPECT_TRUE(wait_for([&] { return sees(window, "exchange_now"); }, 5000));
    EXPECT_FALSE(find<QPushButton>(window, "exchange_now")->isEnabled()) << "the first one is running";
    click(window, "cancel_job");
    EXPECT_TRUE(find<QPushButton>(window, "exchange_now")->isEnabled());
    EXPECT_FALSE(sees(window, "enrol_station"));
    EXPECT_TRUE(find<QLabel>(window, "server_place")->text().contains("Enrolled at postgresql://station_"));
    EXPECT_TRUE(result().contains("Stopped before the end")) << result().toStdString();
    lock.commit();
    ASSERT_TRUE(wait_for([&] {
        return count(
                   "SELECT COUNT(*) FROM pg_stat_activity WHERE datname = current_database() AND usename <> "
                   "'owner'") == 0;
    }));
    click(window, "exchange_now");
    ASSERT_TRUE(wait_for([&] { return result().contains("agree"); })) << result().toStdString();
}

/// A further station, from its first screen over the page Station to the recording of an attempt of the other
/// one. One test: each of its parts needs a server.
TEST(RemoteRecording, AFurtherStationJoinsExchangesAndFetchesTheRecordingOfAReview) {
    FULCRUM_NEEDS_POSTGRESQL();
    const database::test::KeysOfOneTest keys;
    const AccessProgramme programme;
    const ServerAddress server = PostgresqlServer::of_this_process()->new_database();
    const auto token = [&] { return make_enrolment_token(server, "", {}, 1).text; };
    const QTemporaryDir folder;
    const auto services = make_services(folder.path().toStdString());
    MainWindow window(*services);
    window.resize(1280, 800);
    window.show();
    window.start();
    keep_picture(window, "first-start-join");
    click(window, "join_programme");
    type(window, "join_address", QString::fromStdString(server.text()));
    type(window, "join_token", QString::fromStdString(token()));
    keep_picture(window, "join-form");
    click(window, "join_confirm");
    // The server has no programme yet. The same token completes it after the first station has synced.
    ASSERT_TRUE(wait_for([&] { return !find<QLabel>(window, "join_problem")->text().isEmpty(); }));
    EXPECT_TRUE(find<QLabel>(window, "join_problem")->text().contains("has a programme"));
    const Session& administrator = programme.session("administrator");
    Attempts(*programme.store)
        .add_score(*programme.educator, programme.ann.attempt, database::test::example_score(false, 40));
    enrol_station(*programme.store, administrator, server, token());
    EXPECT_TRUE(sync_with_server(*programme.store, administrator, server_of(*programme.store)).complete);
    click(window, "join_confirm");
    ASSERT_TRUE(wait_for([&] { return window.current_page()->objectName() == "sign_in_page"; }));
    const Store joined = Store::open(folder.filePath("fulcrum.db").toStdString());
    EXPECT_EQ(joined.programme_name(), "Test programme");
    EXPECT_EQ(enrolled_stations(server).size(), 2U);

    window.context().set_session(
        People(joined).sign_in("administrator", database::test::password, Role::administrator));
    use_station_page(window, QString::fromStdString(server.text()), QString::fromStdString(token()));
    EXPECT_EQ(enrolled_stations(server).size(), 3U) << "with the one that was replaced";
    stop_first_exchange(window, server, joined.station_id(), QString::fromStdString(token()));

    const ServerLink link = *ServerLink::of(joined.station_id());
    ServerLink unreachable = link;
    unreachable.address.host = "/nowhere";
    unreachable.finish(joined.station_id(), "none");
    window.context().set_session(
        People(joined).sign_in("educator", database::test::password, Role::educator));
    emit window.context().debrief_wanted(QString::fromStdString(programme.ann.attempt), -1);
    auto* debrief = static_cast<DebriefPage*>(window.current_page());
    ASSERT_TRUE(wait_for([&] { return sees(window, "fetch_recording"); }));
    EXPECT_TRUE(sees(window, "verdict")) << "the result is here";
    EXPECT_TRUE(debrief->model()->recomputed) << "and so is the score that was recomputed";
    EXPECT_TRUE(find<QLabel>(window, "debrief_notes")->text().contains("Recomputed on"));
    const QString words = find<QFrame>(window, "no_trace")->findChild<QLabel*>()->text();
    EXPECT_TRUE(words.contains("cannot be reached now")) << words.toStdString();
    bring(*find<QPushButton>(window, "fetch_recording"));
    keep_picture(window, "debrief-recording-elsewhere");
    link.finish(joined.station_id(), "none");
    click(window, "fetch_recording");
    ASSERT_TRUE(wait_for([&] { return debrief->has_charts() && debrief->is_ready(); }));
    EXPECT_EQ(debrief->model()->trace->tick_count(), 1000U);
    EXPECT_FALSE(sees(window, "fetch_recording"));
    EXPECT_TRUE(joined.check(joined.station_session()).ok);
    window.context().sign_out();
}

}  // namespace
}  // namespace fulcrum::app::program_test
