// SPDX-License-Identifier: GPL-3.0-or-later
// One cohort in a station's own store and, after a sync, at the programme server: its director writes the
// same reports from both.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/installed_curriculum.h"
#include "assessment/assets/assets.h"
#include "database/rows/connection.h"
#include "database/store/store_owner.h"
#include "database/sync/programme_server.h"
#include "database/sync/sync.h"
#include "tests/app/access_programme.h"
#include "tests/database/large_programme.h"
#include "tests/database/postgresql_server.h"
#include "ui/reports/report.h"

namespace fulcrum::app::program_test {

class ServerReports : public ::testing::Test {
  protected:
    void SetUp() override {
        FULCRUM_NEEDS_POSTGRESQL();
        open(12, 26, 3);
    }
    void open(int trainees, int attempts, int metrics) {
        path = folder.filePath("station.db").toStdString();
        station.emplace(Store::create(path, false, clock.options()));
        for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
        std::vector<std::string> ids;
        for (const TaskDefinition& task : tasks) ids.push_back(task.id);
        made.emplace(database::test::make_large_programme(*station, trainees, attempts, metrics, 7, ids));
        Connection& connection = station->connection();
        const std::string by = made->director.person_id(), time = std::to_string(station->now());
        // Voided, decided, commented, moved: by whom, is shown.
        for (const std::string& sql :
             {"INSERT INTO attempt_void VALUES ('trainee-1001-3', '" + by + "', " + time + ", 'camera off')",
              "INSERT INTO standing_override VALUES ('o1', 'trainee-1002', '" + ids[2] + "', 'unlocked', '" +
                  by + "', " + time + ", 'moved here')",
              "INSERT INTO comment VALUES ('c1', 'trainee-1000-0', '" + by + "', 1.5, 'Left hand.', " + time +
                  ", " + time + ", 0)",
              std::string("INSERT INTO attempt_asset VALUES ('trainee-1000-0', 'benchmarks/A2.json', "
                          "'0123456789abcdef0123')")})
            connection.execute(QString::fromStdString(sql));
        database::test::PostgresqlServer& postgresql = *database::test::PostgresqlServer::of_this_process();
        address = postgresql.new_database();
        const Session administrator =
            People(*station).sign_in("administrator", database::test::password, Role::administrator);
        sync_with_server(*station, administrator, address);
        server.emplace(Store::open(grant_at_programme_server(address, "director").address, clock.options()));
        director.emplace(People(*server).account_session());
        curriculum = installed_curriculum();
    }

    /// The server's tables belong to a service account, and reports say so; a test that runs as the superuser
    /// gives the station's file to one as well.
    bool give_store_to_service_account() const {
        constexpr uid_t account = 1;
        for (const std::string& one : {folder.path().toStdString(), path})
            if (::chown(one.c_str(), account, account) != 0) return false;
        return database::owned_by_service_account(*station);
    }

    /// Writes the report from both; returns the files of each.
    std::vector<std::string> both(ui::ReportRequest request, const std::string& name) {
        request.curriculum = &curriculum;
        request.home_page = "https://hospital.example/people";
        std::vector<std::string> files;
        for (const bool at_station : {true, false}) {
            request.path =
                folder.filePath(QString::fromStdString((at_station ? "station-" : "server-") + name))
                    .toStdString();
            const auto written =
                ui::write_report(at_station ? *station : *server, at_station ? made->director : *director,
                                 request, tasks, "0.1.0");
            EXPECT_FALSE(written.empty()) << name;
            files.push_back(request.path);
        }
        return files;
    }

    QTemporaryDir folder;
    std::string path;
    database::test::ManualClock clock;
    std::optional<Store> station, server;
    std::optional<database::test::LargeProgramme> made;
    std::optional<Session> director;
    database::ServerAddress address;
    std::vector<TaskDefinition> tasks;
    Curriculum curriculum;
};

}  // namespace fulcrum::app::program_test
