// SPDX-License-Identifier: GPL-3.0-or-later
// The director's pictures of a cohort with many people: the plan, tables, who is behind a part, by mouse and
// by keys; themes, no cohort, no rights. With FULCRUM_PICTURES=FOLDER they are stored there.
#include "ui/dashboards/dashboard_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QSettings>
#include <QSpinBox>
#include <QTableWidget>
#include <nlohmann/json.hpp>

#include "tests/ui/fake_services.h"
#include "tests/ui/files.h"
#include "tests/ui/hands.h"
#include "tests/ui/large_store.h"
#include "ui/charts/chart_frame.h"
#include "ui/charts/figure_chart.h"
#include "ui/shell/main_window.h"

namespace fulcrum::ui::window_test {
namespace {

constexpr int dashboard_people = large_store_people;

class DashboardViews : public ::testing::Test {
  protected:
    DashboardViews() {
        QSettings().remove("dashboard/plan_weeks");
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
    }
    ~DashboardViews() override {
        QSettings().remove("dashboard/plan_weeks");
        apply_theme(*qApp, Theme::light);
    }
    void fill() { director = open_large_store(services); }
    void open() {
        window = std::make_unique<MainWindow>(services);
        window->resize(1280, 900);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        window->context().set_session(*director);
        click(*window, "rail_dashboard");
        wait_until_read(*window);
        ASSERT_EQ(window->current_page()->objectName(), "dashboard_page");
    }
    FigureChart* chart(const char* name) {
        auto* found = find<FigureChart>(*window, name);
        if (found != nullptr) {
            bring(*found);
            QCoreApplication::processEvents();
        }
        return found;
    }
    void keep(const QString& name) {
        QCoreApplication::processEvents();
        if (!qEnvironmentVariableIsSet("FULCRUM_PICTURES")) return;
        window->resize(1280, 1500);
        QCoreApplication::processEvents();
        window->grab().save(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES")) + "/" + name + ".png");
    }
    void press(const char* name) {
        bring(*find<QAbstractButton>(*window, name));
        click(*window, name);
    }

    FakeServices services;
    std::optional<database::Session> director;
    std::unique_ptr<MainWindow> window;
};

TEST_F(DashboardViews, EveryPictureHasItsTableAndCountsEveryone) {
    fill();
    open();
    const std::pair<const char*, int> tables[] = {
        {"plan", dashboard_people},
        {"pass_rates", static_cast<int>(services.curriculum().tasks.size())},
        {"volume", database::dashboard_weeks},
        {"stages", 2 * static_cast<int>(services.curriculum().stages.size())}};
    for (const auto& [part, rows] : tables) {
        const QByteArray name = QByteArray("dashboard_") + part;
        ASSERT_NE(chart(name + "_chart"), nullptr);
        EXPECT_FALSE(chart(name + "_chart")->accessibleName().isEmpty());
        EXPECT_FALSE(chart(name + "_chart")->accessibleDescription().isEmpty());
        press(name + "_as_table");
        EXPECT_EQ(find<QTableWidget>(*window, name + "_table")->rowCount(), rows) << part;
    }
    const ChartTable volume = window->findChild<ChartFrame*>("dashboard_volume")->shown_table();
    long long attempts = 0;
    for (const ChartRow& row : volume.rows) attempts += std::stoll(row.cells[1].copied);
    EXPECT_EQ(attempts, dashboard_people * 18) << "all within twelve weeks";
}

TEST_F(DashboardViews, PlanIsChosenRememberedAndMarksWhoIsBehind) {
    fill();
    open();
    const auto behind = [&] {
        int marked = 0;
        for (const FigureDot& dot : std::get<DotFigure>(chart("dashboard_plan_chart")->figure()).dots)
            marked += dot.marked ? 1 : 0;
        return marked;
    };
    auto* plan = find<QSpinBox>(*window, "dashboard_plan");
    EXPECT_EQ(plan->value(), database::usual_plan_weeks);
    plan->setValue(database::longest_plan_weeks);
    EXPECT_EQ(behind(), 0) << "nothing is asked for yet";
    plan->setFocus();
    plan->selectAll();
    QTest::keyClicks(plan, "1");
    QTest::keyClick(plan, Qt::Key_Return);
    EXPECT_GT(behind(), 0);
    window->context().sign_out();
    window->context().set_session(*director);
    click(*window, "rail_dashboard");
    wait_until_read(*window);
    EXPECT_EQ(find<QSpinBox>(*window, "dashboard_plan")->value(), 1);
    // All began on the same day: their dots are next to each other, and a person is a click on one away.
    auto* dots = chart("dashboard_plan_chart");
    const std::vector<FigureDot>& all = std::get<DotFigure>(dots->figure()).dots;
    const QString key = all.back().key;
    ASSERT_TRUE(wait_for([&] { return !dots->place_of(key).isEmpty(); }));
    for (std::size_t a = 0; a < all.size(); ++a) {
        const QPointF here = dots->place_of(all[a].key).center();
        EXPECT_TRUE(QRectF(dots->rect()).contains(here)) << a;
        for (std::size_t b = 0; b < a; ++b) {
            const QPointF off = here - dots->place_of(all[b].key).center();
            EXPECT_GT(std::hypot(off.x(), off.y()), 8) << a << " and " << b;
        }
    }
    QTest::mouseClick(dots, Qt::LeftButton, {}, dots->place_of(key).center().toPoint());
    EXPECT_EQ(window->current_page()->objectName(), "progress_page");
}

TEST_F(DashboardViews, APartListsWhoIsBehindItAndAPersonOpens) {
    fill();
    open();
    auto* volume = chart("dashboard_volume_chart");
    const auto& columns = std::get<ColumnFigure>(volume->figure()).columns;
    std::size_t busy = 0;
    for (std::size_t c = 0; c < columns.size(); ++c)
        if (columns[c].count > columns[busy].count) busy = c;
    const int attempts = columns[busy].count;
    const QString key = columns[busy].key;
    ASSERT_TRUE(wait_for([&] { return !volume->place_of(key).isEmpty(); }));
    QTest::mouseClick(volume, Qt::LeftButton, {}, volume->place_of(key).center().toPoint());
    auto* people = find<QTableWidget>(*window, "dashboard_volume_table");
    ASSERT_NE(people, nullptr);
    int counted = 0;
    for (int row = 0; row < people->rowCount(); ++row) counted += people->item(row, 1)->text().toInt();
    EXPECT_EQ(counted, attempts);
    EXPECT_EQ(people->currentRow(), 0);
    const QString name = people->item(0, 0)->text();
    QTest::keyClick(people, Qt::Key_Return);
    ASSERT_EQ(window->current_page()->objectName(), "progress_page");
    EXPECT_TRUE(find<QComboBox>(*window, "progress_person")->currentText().contains(name))
        << name.toStdString();
    click(*window, "rail_dashboard");
    wait_until_read(*window);
    EXPECT_TRUE(sees(*window, "dashboard_volume_chart")) << "the picture is back";
    // By keys: the first task that nobody has failed to pass leads nowhere, and says so.
    auto* rates = chart("dashboard_pass_rates_chart");
    rates->setFocus();
    QTest::keyClick(rates, Qt::Key_Up);
    QTest::keyClick(rates, Qt::Key_Return);
    EXPECT_TRUE(find<QLabel>(*window, "message_text")->text().contains("nobody"));
}

TEST_F(DashboardViews, FollowsTheThemeAndExportsTheSameValues) {
    fill();
    open();
    auto* stages = chart("dashboard_stages_chart");
    const auto ground = [&] { return stages->grab().toImage().pixelColor(2, 2).lightness(); };
    EXPECT_GT(ground(), 200);
    keep("dashboard-light");
    window->set_theme(Theme::dark);
    EXPECT_LT(ground(), 100) << "while it is shown";
    keep("dashboard-dark");
    window->set_theme(Theme::light);
    QTemporaryDir folder;
    auto* page = static_cast<DashboardPage*>(window->current_page());
    QSignalSpy done(page, &DashboardPage::exported);
    find<QSpinBox>(*window, "dashboard_plan")->setValue(8);
    page->export_to(folder.filePath("c.json"), ReportFormat::json);
    ASSERT_TRUE(wait_for([&] { return done.count() == 1; }));
    const nlohmann::json json = nlohmann::json::parse(read_text(folder.filePath("c.json")));
    const nlohmann::json& dashboard = json["dashboard"];
    EXPECT_EQ(dashboard["plan_weeks"], 8);
    const auto frame = [&](const char* name) { return window->findChild<ChartFrame*>(name)->shown_table(); };
    const ChartTable plan = frame("dashboard_plan"), volume = frame("dashboard_volume"),
                     steps = frame("dashboard_stages");
    ASSERT_EQ(dashboard["plan"].size(), plan.rows.size());
    for (std::size_t i = 0; i < plan.rows.size(); ++i) {
        EXPECT_EQ(dashboard["plan"][i]["tasks_done"], std::stoi(plan.rows[i].cells[2].copied));
        EXPECT_DOUBLE_EQ(dashboard["plan"][i]["weeks"], std::stod(plan.rows[i].cells[1].copied));
    }
    ASSERT_EQ(dashboard["weeks"].size(), volume.rows.size());
    for (std::size_t i = 0; i < volume.rows.size(); ++i) {
        EXPECT_EQ(dashboard["weeks"][i]["monday"], volume.rows[i].cells[0].copied);
        EXPECT_EQ(dashboard["weeks"][i]["attempts"], std::stoi(volume.rows[i].cells[1].copied));
    }
    ASSERT_EQ(dashboard["stages"].size(), steps.rows.size());
    for (std::size_t i = 0; i < steps.rows.size(); ++i)
        EXPECT_EQ(dashboard["stages"][i]["people"], std::stoi(steps.rows[i].cells[1].copied));
}

TEST_F(DashboardViews, SaysThatThereIsNoCohort) {
    const database::People people(*services.store());
    const database::Session administrator =
        people.create_programme("Department", "alma", "Alma", "correct horse battery").administrator;
    const auto created = people.create(administrator, "dora", "Dora", {database::Role::director});
    director = people.change_password(people.sign_in("dora", created.one_time_password),
                                      created.one_time_password, "dora's password");
    open();
    EXPECT_TRUE(find<QLabel>(*window, "dashboard_summary")->text().startsWith("There is no cohort yet."));
    EXPECT_FALSE(sees(*window, "dashboard_plan_chart"));
    EXPECT_FALSE(sees(*window, "export_dashboard"));
    // A cohort without people.
    database::People(*services.store()).create_cohort(*director, "Nobody");
    click(*window, "rail_dashboard");
    wait_until_read(*window);
    EXPECT_EQ(find<FigureChart>(*window, "dashboard_plan_chart")->accessibleDescription(),
              "Nobody has practised yet.");
    for (const char* part : {"plan", "pass_rates", "times", "volume", "checks", "stages"}) {
        auto* empty = chart(QByteArray("dashboard_") + part + "_chart");
        QTest::mouseClick(empty, Qt::LeftButton);
        press(QByteArray("dashboard_") + part + "_as_table");
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
