// SPDX-License-Identifier: GPL-3.0-or-later
// The same report, byte by byte, from the station's own store and from the programme server after a sync:
// every format, of a person, a cohort and an attempt. The same grid and the same figures of the cohort's
// dashboard.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>

#include "app/cli/installed_curriculum.h"
#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "database/records/ratings.h"
#include "database/rows/connection.h"
#include "database/store/store_owner.h"
#include "database/sync/programme_server.h"
#include "database/sync/sync.h"
#include "tests/app/access_programme.h"
#include "tests/database/large_programme.h"
#include "tests/database/postgresql_server.h"
#include "tests/ui/reports/pdf_pages.h"
#include "ui/reports/report.h"

namespace fulcrum::app::program_test {
namespace {

using database::test::PostgresqlServer;

std::string file_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A workbook's sheets; its files also have the time at which they were written.
std::string sheets_of(const std::string& path) {
    QProcess unzip;
    unzip.start("unzip", {"-p", QString::fromStdString(path), "xl/*.xml"});
    EXPECT_TRUE(unzip.waitForFinished(20000)) << "unzip is needed";
    return unzip.readAllStandardOutput().toStdString();
}

int from_environment(const char* name, int otherwise) {
    return qEnvironmentVariableIsSet(name) ? qEnvironmentVariableIntValue(name) : otherwise;
}

class ServerReports : public ::testing::Test {
  protected:
    void SetUp() override {
        FULCRUM_NEEDS_POSTGRESQL();
        open(12, 26);
    }
    void open(int trainees, int attempts) {
        path = folder.filePath("station.db").toStdString();
        station.emplace(Store::create(path, false, clock.options()));
        for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
        std::vector<std::string> ids;
        for (const TaskDefinition& task : tasks) ids.push_back(task.id);
        made.emplace(database::test::make_large_programme(*station, trainees, attempts, 3, 7, ids));
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
        PostgresqlServer& postgresql = *PostgresqlServer::of_this_process();
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

TEST_F(ServerReports, AreTheSameFromEitherStoreInEveryFormat) {
    if (!give_store_to_service_account()) GTEST_SKIP() << "this account cannot give a file to another one";
    struct Row {
        const char* of;
        ui::ReportFormat format;
        std::size_t least;
    };
    for (const Row& row :
         {Row{"person", ui::ReportFormat::csv, 2000}, Row{"person", ui::ReportFormat::json, 20000},
          Row{"person", ui::ReportFormat::xlsx, 2000}, Row{"person", ui::ReportFormat::xapi, 5000},
          Row{"person", ui::ReportFormat::pdf, 500}, Row{"cohort", ui::ReportFormat::csv, 2000},
          Row{"cohort", ui::ReportFormat::json, 20000}, Row{"cohort", ui::ReportFormat::xlsx, 2000},
          Row{"cohort", ui::ReportFormat::xapi, 50000}, Row{"cohort", ui::ReportFormat::pdf, 2000},
          Row{"attempt", ui::ReportFormat::csv, 100}, Row{"attempt", ui::ReportFormat::json, 500},
          Row{"attempt", ui::ReportFormat::pdf, 200}}) {
        ui::ReportRequest request;
        request.format = row.format;
        const std::string of = row.of;
        if (of == "person") request.person_id = "trainee-1001";
        if (of == "cohort") request.cohort_id = made->cohort;
        if (of == "attempt") request.attempt_id = "trainee-1000-0";
        const std::string name = of + "." + row_of(ui::report_formats, row.format).name;
        const std::vector<std::string> files = both(request, name);
        std::string here, there;
        if (row.format == ui::ReportFormat::pdf) {
            here = ui::pages_of(files[0]).join('\f').toStdString();
            there = ui::pages_of(files[1]).join('\f').toStdString();
        } else if (row.format == ui::ReportFormat::xlsx) {
            here = sheets_of(files[0]);
            there = sheets_of(files[1]);
        } else {
            here = file_text(files[0]);
            there = file_text(files[1]);
        }
        EXPECT_GE(here.size(), row.least) << name;
        EXPECT_TRUE(here == there) << name << " differs; the files are in " << folder.path().toStdString();
        if (here != there) {
            folder.setAutoRemove(false);
            const auto at = static_cast<std::size_t>(
                std::mismatch(here.begin(), here.end(), there.begin(), there.end()).first - here.begin());
            const std::size_t from = at > 80 ? at - 80 : 0;
            ADD_FAILURE() << here.substr(from, 200) << "\n---\n" << there.substr(from, 200);
        }
    }
}

TEST_F(ServerReports, GridFiguresAndDashboardAreTheSame) {
    database::CohortTableOptions options;
    for (const TaskDefinition& task : tasks) options.tasks.push_back(task.id);
    options.curriculum = &curriculum;
    const auto here = database::Reports(*station).cohort_table(made->director, made->cohort, options);
    const auto there = database::Reports(*server).cohort_table(*director, made->cohort, options);
    ASSERT_EQ(here.rows.size(), there.rows.size());
    ASSERT_GE(here.rows.size(), 12 * tasks.size());
    ASSERT_EQ(here.standings.size(), 12U);
    ASSERT_EQ(there.standings.size(), 12U);
    for (std::size_t i = 0; i < here.standings.size(); ++i) {
        const database::PersonStandings &a = here.standings[i], &b = there.standings[i];
        EXPECT_EQ(a.person_id, b.person_id);
        EXPECT_EQ(a.curriculum, b.curriculum);
        ASSERT_EQ(a.days.size(), b.days.size());
        ASSERT_EQ(a.concerns.size(), b.concerns.size());
        ASSERT_EQ(a.tasks.size(), b.tasks.size());
        for (std::size_t t = 0; t < a.tasks.size(); ++t) {
            EXPECT_EQ(a.tasks[t].standing.standing, b.tasks[t].standing.standing);
            EXPECT_EQ(a.tasks[t].first_pass, b.tasks[t].first_pass);
            ASSERT_EQ(a.tasks[t].recent.size(), b.tasks[t].recent.size());
            for (std::size_t r = 0; r < a.tasks[t].recent.size(); ++r)
                EXPECT_EQ(a.tasks[t].recent[r].points, b.tasks[t].recent[r].points);
        }
    }
    // Pass rates with their intervals; time to proficiency by Kaplan-Meier.
    const auto shown = database::overview_of(here.standings, here.as_of),
               asked = database::overview_of(there.standings, there.as_of);
    ASSERT_EQ(shown.size(), asked.size());
    int passed = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].people, asked[i].people);
        EXPECT_EQ(shown[i].passed, asked[i].passed);
        EXPECT_EQ(shown[i].share.low, asked[i].share.low);
        EXPECT_EQ(shown[i].share.high, asked[i].share.high);
        EXPECT_EQ(shown[i].days_to_pass.median, asked[i].days_to_pass.median);
        EXPECT_EQ(shown[i].days_to_proficiency.median, asked[i].days_to_proficiency.median);
        passed += shown[i].passed;
    }
    EXPECT_GT(passed, 0);
    EXPECT_EQ(here.benchmark_sets, there.benchmark_sets);
    EXPECT_EQ(here.metric_versions, there.metric_versions);
    EXPECT_EQ(here.audit_head, there.audit_head);
}

/// Prints how long each takes from either store, and fails where that is over budget; with
/// FULCRUM_REPORT_TRAINEES=200 FULCRUM_REPORT_ATTEMPTS=300 the values of docs/FORMATS.md (Sync), by the
/// clock.
class ServerReportsLarge : public ServerReports {
  protected:
    void SetUp() override {
        FULCRUM_NEEDS_POSTGRESQL();
        trainees = from_environment("FULCRUM_REPORT_TRAINEES", 60);
        attempts = from_environment("FULCRUM_REPORT_ATTEMPTS", 50);
        open(trainees, attempts);
        // As the server does by itself after a while.
        PostgresqlServer::of_this_process()->execute(address, "ANALYZE");
    }
    /// By the clock and, of this process, of its processor.
    struct Times {
        double wall = 0, own = 0;
    };
    static Times seconds(const std::function<void()>& work) {
        QElapsedTimer timer;
        timer.start();
        const std::clock_t start = std::clock();
        work();
        return {static_cast<double>(timer.nsecsElapsed()) * 1e-9,
                static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
    }
    static void print(const std::string& what, const Times& at_station, const Times& at_server) {
        std::printf("%s: station %.2f s (%.2f s of processor), server %.2f s (%.2f s)\n", what.c_str(),
                    at_station.wall, at_station.own, at_server.wall, at_server.own);
    }
    /// Seconds: of 200 trainees with 300 attempts each, and of any programme, however small, on top of its
    /// share.
    struct Budget {
        double full, every;
    };
    static constexpr Budget grid_budget{1, 0.2}, report_budget{5, 1.5};
    /// Whoever sets the size measures by the clock, on a machine with nothing else running; else the
    /// processor time of this process counts, which a busy machine changes little.
    void expect_within(const Budget& budget, const std::string& what, const Times& took) const {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        const double share = trainees * attempts / (200.0 * 300.0);
        const bool by_the_clock = qEnvironmentVariableIsSet("FULCRUM_REPORT_TRAINEES");
        EXPECT_LE(by_the_clock ? took.wall : took.own, budget.full * share + (share < 1 ? budget.every : 0))
            << what << ", " << trainees << " trainees with " << attempts << " attempts each";
#else
        (void)budget, (void)what, (void)took;
#endif
    }
    int trainees = 0, attempts = 0;
};

TEST_F(ServerReportsLarge, TakeAboutAsLongFromEitherStore) {
    database::CohortTableOptions options;
    for (const TaskDefinition& task : tasks) options.tasks.push_back(task.id);
    options.curriculum = &curriculum;
    const auto grid = [&](const Store& store, const Session& session) {
        const database::CohortTable table =
            database::Reports(store).cohort_table(session, made->cohort, options);
        const auto overview = database::overview_of(table.standings, table.as_of);
        EXPECT_EQ(overview.size(), curriculum.tasks.size());
        return table.rows.size();
    };
    std::size_t here = 0, there = 0;
    const Times at_station = seconds([&] { here = grid(*station, made->director); }),
                at_server = seconds([&] { there = grid(*server, *director); });
    EXPECT_EQ(here, there);
    print("grid and dashboard", at_station, at_server);
    expect_within(grid_budget, "grid and dashboard at the station", at_station);
    expect_within(grid_budget, "grid and dashboard from the server", at_server);
    for (const ui::ReportFormatRow& format : ui::report_formats) {
        Times time[2];
        for (const bool of_server : {false, true}) {
            ui::ReportRequest request;
            request.cohort_id = made->cohort;
            request.format = format.kind;
            request.curriculum = &curriculum;
            request.home_page = "https://hospital.example/people";
            request.path = folder.filePath(QString("large.%1").arg(format.name)).toStdString();
            time[of_server ? 1 : 0] = seconds([&] {
                EXPECT_FALSE(ui::write_report(of_server ? *server : *station,
                                              of_server ? *director : made->director, request, tasks, "0.1.0")
                                 .empty());
            });
        }
        const std::string what = std::string("cohort report, ") + format.name;
        print(what, time[0], time[1]);
        expect_within(report_budget, what + " at the station", time[0]);
        expect_within(report_budget, what + " from the server", time[1]);
    }
    // An educator's account: the row policies ask for each row whose it is.
    Connection owner(address);
    owner.execute("INSERT INTO person_role VALUES ('" + QString::fromStdString(made->director.person_id()) +
                  "', 'educator'); INSERT INTO cohort_educator SELECT id, '" +
                  QString::fromStdString(made->director.person_id()) + "' FROM cohort");
    const Store taught = Store::open(grant_at_programme_server(address, "director").address, clock.options());
    const Session educator = People(taught).account_session(Role::educator);
    owner.execute("DELETE FROM person_role WHERE role = 'director'");
    const Times as_educator = seconds([&] { EXPECT_EQ(grid(taught, educator), here); });
    std::printf("grid and dashboard of an educator: server %.2f s (%.2f s)\n", as_educator.wall,
                as_educator.own);
    expect_within(grid_budget, "grid and dashboard of an educator", as_educator);
}

TEST_F(ServerReports, TheCommandTakesTheServersAddress) {
    const std::string own = address.text(), file = folder.filePath("command.json").toStdString();
    const std::string account = server->path();
    EXPECT_EQ(
        run_command({"report", "--cohort", "Everyone", "--format", "json", "-o", file, "--db", account}), 0);
    EXPECT_NE(file_text(file).find("Trainee 1011"), std::string::npos);
    EXPECT_EQ(run_command({"report", "--person", "trainee1003", "--format", "csv", "-o", file, "--db",
                           account, "--as", "Director", "--role", "director"}),
              0);
    EXPECT_NE(file_text(file).find("trainee1003"), std::string::npos);
    const auto refused = [&](std::vector<std::string> words) {
        try {
            run_command(words);
        } catch (const std::exception& error) {
            return std::string(error.what());
        }
        return std::string("nothing was refused");
    };
    const std::vector<std::string> report = {"report", "--person", "trainee1003", "-o", file};
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> words = report;
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    EXPECT_NE(refused(with({"--db", account, "--as", "trainee1003"})).find("belongs to director"),
              std::string::npos);
    EXPECT_NE(refused(with({"--db", account, "--password-file", file})).find(".pgpass"), std::string::npos);
    EXPECT_NE(refused(with({"--db", own})).find("server grant"), std::string::npos) << "the owner is nobody";
    // An attempt is performed at a station, and a server's care is not that of a file.
    EXPECT_NE(refused({"perform", "A2", "--operator", "expert", "--db", account}).find("at a station"),
              std::string::npos);
    EXPECT_NE(refused({"db", "check", "--db", account}).find("not allowed"), std::string::npos);
    EXPECT_NE(refused({"db", "create", "--db", account}).find("not a file"), std::string::npos);
    EXPECT_NE(refused({"db", "migrate", "--db", account}).find("not a file"), std::string::npos);
    EXPECT_NE(refused({"db", "restore", path, "--db", account, "--as", "administrator"}).find("not a file"),
              std::string::npos);
    EXPECT_NE(refused({"db", "backup", file + ".copy", "--db", account}).find("not allowed"),
              std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app::program_test
