// SPDX-License-Identifier: GPL-3.0-or-later
// How long the grid and the reports of a large cohort take from the station's store and from the programme
// server, and how long the window takes to open the grid. With FULCRUM_REPORTS_PAGE=FOLDER the times are
// entered in a page there.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QPaintEvent>
#include <QTableView>
#include <QTimer>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/services/application.h"
#include "app/services/demo.h"
#include "tests/app/reports_large_page.h"
#include "tests/app/services/server_reports.h"
#include "tests/ui/hands.h"
#include "ui/dashboards/cohort_grid.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"

namespace fulcrum::app::program_test {
namespace {

/// Waits for the first picture of the cohort's grid that has a row for each of so many people.
class GridPicture : public QObject {
  public:
    explicit GridPicture(int people) : people_(people) { qApp->installEventFilter(this); }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Paint) return false;
        const auto* view = qobject_cast<const QTableView*>(watched->parent());
        if (view == nullptr || watched != view->viewport() ||
            view->objectName() != QLatin1String("cohort_grid") || view->model()->rowCount() != people_)
            return false;
        const QRect first_cell = view->visualRect(view->model()->index(0, 1));
        painted_ = painted_ || static_cast<QPaintEvent*>(event)->region().intersects(first_cell);
        return false;
    }
    /// Returns when it has been painted, and what was waiting at that moment is done.
    void wait() {
        QElapsedTimer waited;
        waited.start();
        QTimer wakes_up;  // the loop below, should nothing else happen
        wakes_up.start(1000);
        while (!painted_ && waited.elapsed() < 60000)
            QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
        EXPECT_TRUE(painted_) << "the grid was not painted with " << people_ << " people";
        QCoreApplication::processEvents();
    }

  private:
    int people_;
    bool painted_ = false;
};

/// FULCRUM_REPORT_TRAINEES=200 FULCRUM_REPORT_ATTEMPTS=300 is the size that the limits are meant for; where
/// the size is set, the clock counts.
class ServerReportsLarge : public ServerReports {
  protected:
    void SetUp() override {
        FULCRUM_NEEDS_POSTGRESQL();
        open_large(60, 50, 3);
    }
    void TearDown() override { enter_reports(rows); }
    /// Of these sizes unless the environment names others.
    void open_large(int usual_trainees, int usual_attempts, int metrics_each) {
        trainees = size_from("FULCRUM_REPORT_TRAINEES", usual_trainees);
        attempts = size_from("FULCRUM_REPORT_ATTEMPTS", usual_attempts);
        metrics = metrics_each;
        open(trainees, attempts, metrics);
        // As the server does by itself after a while.
        database::test::PostgresqlServer::of_this_process()->execute(address, "ANALYZE");
    }
    static int size_from(const char* name, int usual) {
        return qEnvironmentVariableIsSet(name) ? qEnvironmentVariableIntValue(name) : usual;
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
    /// Seconds: of 200 trainees with 300 attempts each, and of any programme, however small, on top of its
    /// share.
    struct Budget {
        double full, every;
    };
    static constexpr Budget grid_budget{1, 0.2}, report_budget{5, 1.5};
    /// Making and painting a page takes its time without any attempt.
    static constexpr Budget window_budget{1, 0.5};
    static bool by_the_clock() { return qEnvironmentVariableIsSet("FULCRUM_REPORT_TRAINEES"); }
    double limit_of(const Budget& budget) const {
        const double share = trainees * attempts / (200.0 * 300.0);
        return budget.full * share + (share < 1 ? budget.every : 0);
    }
    /// Whoever sets the size measures by the clock, on a machine with nothing else running; else the
    /// processor time of this process counts, which a busy machine changes little.
    void expect_within(const Budget& budget, const std::string& what, const Times& took) const {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        EXPECT_LE(by_the_clock() ? took.wall : took.own, limit_of(budget))
            << what << ", " << trainees << " trainees with " << attempts << " attempts each";
#else
        (void)budget, (void)what, (void)took;
#endif
    }
    /// Prints the times, keeps them for the page, and fails where one is over its budget.
    void note(const std::string& what, const std::optional<Budget>& budget,
              const std::optional<Times>& at_station, const std::optional<Times>& at_server) {
        ReportsRow row;
        row.what = what;
        row.trainees = trainees;
        row.attempts = attempts;
        row.metrics = metrics;
        if (budget && by_the_clock()) row.limit_s = limit_of(*budget);
        std::printf("%s:", what.c_str());
        if (at_station) {
            row.station_s = at_station->wall;
            std::printf(" station %.2f s (%.2f s of processor)", at_station->wall, at_station->own);
            if (budget) expect_within(*budget, what + " at the station", *at_station);
        }
        if (at_server) {
            row.server_s = at_server->wall;
            std::printf(" server %.2f s (%.2f s of processor)", at_server->wall, at_server->own);
            if (budget) expect_within(*budget, what + " from the server", *at_server);
        }
        std::printf("\n");
        rows.push_back(std::move(row));
    }

    database::CohortTableOptions grid_options(const Curriculum& of) const {
        database::CohortTableOptions options;
        for (const TaskDefinition& task : tasks) options.tasks.push_back(task.id);
        options.curriculum = &of;
        return options;
    }
    /// How many rows it has.
    std::size_t query_grid(const Store& store, const Session& session) const {
        const database::CohortTable table =
            database::Reports(store).cohort_table(session, made->cohort, grid_options(curriculum));
        const auto overview = database::overview_of(table.standings, table.as_of);
        EXPECT_EQ(overview.size(), curriculum.tasks.size());
        return table.rows.size();
    }
    /// The program's window on this store: from a director's click on *Cohorts* to the picture of the grid.
    /// `session`: who signs in at a station; a server's address has signed in whose account it names.
    Times open_grid(const std::string& store, const std::optional<Session>& session) const {
        const auto services = make_services(folder.path().toStdString(), store);
        ui::MainWindow window(*services);
        window.resize(1280, 800);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.start();
        if (session) window.context().set_session(*session);
        if (!window.context().signed_in()) {
            ADD_FAILURE() << "nobody is signed in at " << store;
            return {};
        }
        ui::window_test::wait_until_read(window);  // the dashboard, where a director begins
        GridPicture picture(trainees);
        const Times took = seconds([&] {
            ui::window_test::click(window, "rail_cohort");
            picture.wait();
        });
        expect_values_of_query(window);
        return took;
    }
    /// Each cell of the grid, as it is read aloud.
    void expect_values_of_query(ui::MainWindow& window) const {
        ui::window_test::wait_until_read(window);
        const auto* grid = ui::window_test::find<QTableView>(window, "cohort_grid");
        ASSERT_NE(grid, nullptr);
        ui::Context& context = window.context();
        const Curriculum& shown = context.services().curriculum();
        const database::CohortTable table =
            database::Reports(context.store())
                .cohort_table(context.session(), made->cohort, grid_options(shown));
        std::map<std::string, const database::PersonStandings*> wanted;
        for (const database::PersonStandings& person : table.standings) wanted[person.person_id] = &person;
        const QAbstractItemModel& cells = *grid->model();
        ASSERT_EQ(wanted.size(), static_cast<std::size_t>(trainees));
        ASSERT_EQ(cells.rowCount(), trainees);
        for (int row = 0; row < cells.rowCount(); ++row) {
            const auto found = wanted.find(ui::plain(cells.index(row, 0).data(Qt::UserRole).toString()));
            ASSERT_NE(found, wanted.end()) << row;
            const database::PersonStandings& person = *found->second;
            ASSERT_EQ(cells.columnCount(), static_cast<int>(person.tasks.size()) + 2);
            int column = 0;
            for (const database::PersonTask& task : person.tasks)
                ASSERT_EQ(cells.index(row, ++column).data(Qt::AccessibleTextRole).toString(),
                          ui::grid_cell_text(ui::account_text(person.name, person.active),
                                             context.task_title(task.standing.task), task));
            wanted.erase(found);
        }
    }
    /// Returns how long its file is, in bytes.
    std::uintmax_t write_cohort(bool of_server, const ui::ReportFormatRow& format) const {
        ui::ReportRequest request;
        request.cohort_id = made->cohort;
        request.format = format.kind;
        request.curriculum = &curriculum;
        request.home_page = "https://hospital.example/people";
        request.path = folder.filePath(QString("large.%1").arg(format.name)).toStdString();
        const std::vector<std::string> files = ui::write_report(
            of_server ? *server : *station, of_server ? *director : made->director, request, tasks, "0.1.0");
        return files.empty() ? 0 : std::filesystem::file_size(files.front());
    }
    /// Returns the length of the shorter of both files.
    std::uintmax_t measure_cohort(const ui::ReportFormatRow& format, const std::optional<Budget>& budget) {
        std::uintmax_t here = 0, there = 0;
        const Times at_station = seconds([&] { here = write_cohort(false, format); }),
                    at_server = seconds([&] { there = write_cohort(true, format); });
        note(title_of(format.kind), budget, at_station, at_server);
        return std::min(here, there);
    }
    static const char* title_of(ui::ReportFormat format) {
        switch (format) {
            case ui::ReportFormat::pdf:
                return "report as PDF";
            case ui::ReportFormat::csv:
                return "report as CSV";
            case ui::ReportFormat::xlsx:
                return "report as XLSX";
            case ui::ReportFormat::json:
                return "report as JSON";
            case ui::ReportFormat::xapi:
                return "statements for a record store (xAPI)";
        }
        return "";
    }

    int trainees = 0, attempts = 0, metrics = 0;
    std::vector<ReportsRow> rows;
};

TEST_F(ServerReportsLarge, TakeAboutAsLongFromEitherStore) {
    std::size_t here = 0, there = 0;
    const Times at_station = seconds([&] { here = query_grid(*station, made->director); }),
                at_server = seconds([&] { there = query_grid(*server, *director); });
    EXPECT_EQ(here, there);
    note("grid and dashboard", grid_budget, at_station, at_server);
    const Times opened_at_station = open_grid(path, made->director),
                opened_at_server = open_grid(server->path(), std::nullopt);
    note("grid in the window", window_budget, opened_at_station, opened_at_server);
    for (const ui::ReportFormatRow& format : ui::report_formats)
        EXPECT_GT(measure_cohort(format, report_budget), 0U) << format.name;
    // An educator's account: the row policies ask for each row whose it is.
    Connection owner(address);
    owner.execute("INSERT INTO person_role VALUES ('" + QString::fromStdString(made->director.person_id()) +
                  "', 'educator'); INSERT INTO cohort_educator SELECT id, '" +
                  QString::fromStdString(made->director.person_id()) + "' FROM cohort");
    const Store taught = Store::open(grant_at_programme_server(address, "director").address, clock.options());
    const Session educator = People(taught).account_session(Role::educator);
    owner.execute("DELETE FROM person_role WHERE role = 'director'");
    const Times as_educator = seconds([&] { EXPECT_EQ(query_grid(taught, educator), here); });
    note("grid and dashboard of an educator's account", grid_budget, std::nullopt, as_educator);
}

/// Each attempt has as many metrics as one of the delivered demonstration on average.
class ServerReportsLargeMetrics : public ServerReportsLarge {
  protected:
    void SetUp() override {
        FULCRUM_NEEDS_POSTGRESQL();
        open_large(6, 10, metrics_of_demonstration());
    }
    int metrics_of_demonstration() const {
        const std::string demo = folder.filePath("demo.db").toStdString();
        EXPECT_TRUE(unpack_demo(demo, {}));
        const Store store = Store::open(demo);
        Query average(store.connection(),
                      "SELECT (SELECT COUNT(*) FROM metric m JOIN score s ON s.id = m.score_id WHERE "
                      "s.in_force = 1), (SELECT COUNT(*) FROM score WHERE in_force = 1)");
        if (!average.next() || average.integer(1) == 0) {
            ADD_FAILURE() << "the demonstration has no scores";
            return 1;
        }
        return static_cast<int>((average.integer(0) + average.integer(1) / 2) / average.integer(1));
    }
};

TEST_F(ServerReportsLargeMetrics, AreInTheStatementsOfEitherStore) {
    EXPECT_GT(metrics, 100);
    // A metric takes over 100 bytes; one attempt is void, and its statement has none.
    const auto least =
        static_cast<std::uintmax_t>(100 * metrics) * static_cast<std::uintmax_t>(trainees * attempts - 1);
    EXPECT_GT(measure_cohort(row_of(ui::report_formats, ui::ReportFormat::xapi), std::nullopt), least);
}

}  // namespace
}  // namespace fulcrum::app::program_test
