// SPDX-License-Identifier: GPL-3.0-or-later
// The page of limits: sets next to each other, who would pass under each, the pass mark, wrong files. With
// FULCRUM_PICTURES=FOLDER pictures are stored there.
#include "ui/dashboards/limits_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "assessment/scoring/taken_over.h"
#include "sim_core/numerics/output_file.h"
#include "tests/database/large_programme.h"
#include "tests/support/processor_time.h"
#include "tests/support/support.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/dashboards/limit_rows.h"
#include "ui/dashboards/limits_chart.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {
namespace {

/// Writes the gates of A2 with values that are `skill` expert deviations worse than the experts' mean.
void write_gates(const TaskDefinition& task, const BenchmarkSet& set, double skill, database::ScoreRow& score,
                 Random& random) {
    score.gates.clear();
    score.metrics.clear();
    for (const GateSpec& spec : task.gates) {
        database::GateRow gate;
        gate.metric = spec.metric;
        gate.hand = spec.hand;
        gate.tissue = spec.tissue;
        gate.kind = spec.kind;
        gate.passed = true;
        if (spec.kind == GateKind::benchmark) {
            const BenchmarkLevel& level = *set.find(spec.metric, spec.hand, spec.tissue);
            gate.value = limit_of(*find_metric(spec.metric), level, skill + random.uniform(-0.8, 0.8));
            gate.unit = level.unit;
            database::MetricRow metric;
            metric.id = spec.metric;
            metric.version = level.metric_version;
            metric.hand = spec.hand;
            metric.tissue = spec.tissue;
            metric.value = gate.value;
            metric.unit = level.unit;
            score.metrics.push_back(metric);
        }
        score.gates.push_back(gate);
    }
}

/// Attempts from about the experts' mean to far worse; or from `best` to `worst`, in expert deviations.
class LimitsView : public ::testing::Test {
  protected:
    explicit LimitsView(double best = 0, double worst = 3) {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
        const auto programme = database::test::make_large_programme(
            *services.store(), 30, 4, 1, 7, {"A2"},
            [&](database::ScoreRow& score, Random& random) {
                write_gates(task, set, random.uniform(best, worst), score, random);
            },
            task.version);
        window.resize(1024, 740);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.start();
        window.context().set_session(programme.director);
        click(window, "rail_limits");
        wait_until_read(window);
        tasks = find<QComboBox>(window, "limits_task");
        table = find<QTableWidget>(window, "limits_table");
        chart = dynamic_cast<LimitsChart*>(window.findChild<QWidget*>("limits_chart"));
        tasks->setFocus();
        while (tasks->currentData().toString() != "A2") QTest::keyClick(tasks, Qt::Key_Down);
        wait_until_read(window);
    }
    ~LimitsView() override { apply_theme(*qApp, Theme::light); }
    void keep(const QString& name) {
        QCoreApplication::processEvents();
        if (!qEnvironmentVariableIsSet("FULCRUM_PICTURES")) return;
        window.grab().save(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES")) + "/" + name + ".png");
    }
    void compare(const QString& file) {
        auto* path = find<QLineEdit>(window, "limits_file");
        path->setFocus();
        path->clear();
        QTest::keyClicks(path, file);
        QTest::keyClick(path, Qt::Key_Return);
    }
    std::string write(const BenchmarkSet& other, const char* name) {
        const std::string file = folder.filePath(name).toStdString();
        write_output_file(file, benchmark_to_json(other).dump(2));
        return file;
    }
    int passes(int row) { return table->item(row, 4)->text().section(' ', 0, 0).toInt(); }

    QTemporaryDir folder;
    BenchmarkSet set = load_benchmark(test::source_path("assets/benchmarks/A2.json"));
    FakeServices services;
    MainWindow window{services};
    QComboBox* tasks = nullptr;
    QTableWidget* table = nullptr;
    LimitsChart* chart = nullptr;
};

TEST_F(LimitsView, ShowsWhoWouldPassUnderEachSet) {
    ASSERT_EQ(table->rowCount(), 1);
    ASSERT_FALSE(chart->gates().empty());
    for (const GateLimits& gate : chart->gates()) {
        EXPECT_EQ(gate.values.size(), 120U) << gate.name.toStdString();
        ASSERT_EQ(gate.limits.size(), 1U);
        EXPECT_TRUE(gate.limits[0].has_value());
    }
    BenchmarkSet wide = set, narrow = set;
    wide.k = 3;
    wide.version = 90;
    narrow.k = 1;
    narrow.version = 91;
    compare(QString::fromStdString(write(wide, "wide.json")));
    const test::ProcessorTime timer;
    compare(QString::fromStdString(write(narrow, "narrow.json")));
    EXPECT_LT(timer.milliseconds(), 1000);
    ASSERT_EQ(table->rowCount(), 3);
    EXPECT_GT(passes(1), passes(0));
    EXPECT_LT(passes(2), passes(0));
    EXPECT_EQ(chart->gates().front().limits.size(), 3U);
    EXPECT_TRUE(table->item(2, 0)->text().startsWith("C"));
    keep("limits-light");
    window.set_theme(Theme::dark);
    keep("limits-dark");
    window.set_theme(Theme::light);
    window.resize(1920, 1080);
    keep("limits-wide");
}

TEST_F(LimitsView, ShowsAnAbsoluteLimitThatASetNarrows) {
    const std::size_t before = chart->gates().size();
    BenchmarkSet narrow = set;
    BenchmarkLevel force = set.levels.front();
    force.metric = "f_max";
    force.hand = "left";
    force.tissue.clear();
    force.metric_version = find_metric("f_max")->version;
    force.unit = "N";
    force.scale = Scale::ln;
    force.mean = std::log(1.0);
    force.deviation = 0.1;
    force.k = 2;
    narrow.levels.push_back(force);
    compare(QString::fromStdString(write(narrow, "narrow-force.json")));
    ASSERT_EQ(chart->gates().size(), before + 1);
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    const auto gate = std::find_if(task.gates.begin(), task.gates.end(), [](const GateSpec& spec) {
        return spec.metric == "f_max" && spec.hand == "left";
    });
    ASSERT_NE(gate, task.gates.end());
    const auto shown = std::find_if(chart->gates().begin(), chart->gates().end(),
                                    [](const GateLimits& one) { return one.unit == "N"; });
    ASSERT_NE(shown, chart->gates().end());
    EXPECT_EQ(shown->limits[0], gate->limit) << "that of the task";
    EXPECT_NEAR(shown->limits[1].value_or(0), std::exp(0.2), 1e-9);
    EXPECT_TRUE(shown->name.contains(figure_with_unit(gate->limit, "N"))) << shown->name.toStdString();
    keep("limits-narrowed-light");
    window.set_theme(Theme::dark);
    keep("limits-narrowed-dark");
}

TEST_F(LimitsView, NamesTheLimitsOfTheTaskThatASetOfTheSiteTakesOver) {
    EXPECT_FALSE(sees(window, "limits_of_site")) << "the set in force is provisional";
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    BenchmarkSet site = set;
    site.provisional = false;
    site.version = 90;
    compare(QString::fromStdString(write(site, "older.json")));
    const auto shown = [&] { return find<QLabel>(window, "limits_of_site")->text(); };
    EXPECT_TRUE(shown().startsWith("B · Provisional limits of the task that version 90 of the set does not"))
        << shown().toStdString();
    site.version = 91;
    site.taken_over = limits_to_take_over(task);
    compare(QString::fromStdString(write(site, "site.json")));
    const QStringList lines = shown().split('\n');
    ASSERT_EQ(lines.size(), 2);
    EXPECT_TRUE(lines[1].startsWith("C · Limits of the task that this set takes over"))
        << lines[1].toStdString();
    EXPECT_TRUE(lines[1].contains(taken_over_words(task, site)));
    EXPECT_EQ(taken_over_words(task, site).count(';'), 3) << taken_over_words(task, site).toStdString();
    keep("limits-of-site");
}

TEST_F(LimitsView, NamesThePassMarkBetweenExpertsAndAttempts) {
    const QString mark = find<QLabel>(window, "limits_mark")->text();
    EXPECT_TRUE(mark.startsWith("Pass mark")) << mark.toStdString();
    EXPECT_TRUE(window.findChild<QWidget*>("groups_chart")->isVisibleTo(&window));
    auto* metrics = find<QComboBox>(window, "limits_metric");
    EXPECT_GT(metrics->count(), 2);
    metrics->setFocus();
    QTest::keyClick(metrics, Qt::Key_Down);
    EXPECT_NE(find<QLabel>(window, "limits_mark")->text(), mark);
}

class LimitsOfBetterAttempts : public LimitsView {
  protected:
    LimitsOfBetterAttempts() : LimitsView(-2, -1) {}
};

TEST_F(LimitsOfBetterAttempts, HaveNoPassMarkBetweenGroups) {
    auto* metrics = find<QComboBox>(window, "limits_metric");
    metrics->setFocus();
    bool lower = false, higher = false;
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    for (int row = 0; row < metrics->count(); ++row) {
        ASSERT_EQ(metrics->currentIndex(), row);
        const auto gate = static_cast<std::size_t>(metrics->currentData().toInt());
        if (find_metric(task.gates[gate].metric)->direction == Direction::higher)
            higher = true;
        else
            lower = true;
        const QString mark = find<QLabel>(window, "limits_mark")->text();
        EXPECT_TRUE(mark.startsWith("No pass mark: the attempts here are better")) << mark.toStdString();
        EXPECT_TRUE(window.findChild<QWidget*>("groups_chart")->isVisibleTo(&window));
        QTest::keyClick(metrics, Qt::Key_Down);
    }
    EXPECT_TRUE(lower) << "such as time";
    EXPECT_TRUE(higher) << "such as smoothness";
}

TEST_F(LimitsView, RefusesAFileThatIsNotASetOfTheSameKind) {
    BenchmarkSet other = set;
    other.device_class = DeviceClass::tracked;
    QSignalSpy said(&window.context(), &Context::message);
    compare(QString::fromStdString(write(other, "other.json")));
    ASSERT_EQ(said.count(), 1);
    EXPECT_TRUE(said[0][1].toBool());
    EXPECT_TRUE(said[0][0].toString().contains("A2-tracked")) << said[0][0].toString().toStdString();
    compare(folder.filePath("missing.json"));
    ASSERT_EQ(said.count(), 2);
    EXPECT_TRUE(said[1][0].toString().contains("missing.json"));
    write_output_file(folder.filePath("broken.json").toStdString(), "{");
    compare(folder.filePath("broken.json"));
    ASSERT_EQ(said.count(), 3);
    EXPECT_EQ(table->rowCount(), 1);
}

TEST_F(LimitsView, ATaskWithoutAttemptsSaysSo) {
    tasks->setFocus();
    while (tasks->currentData().toString() != "B3") QTest::keyClick(tasks, Qt::Key_Down);
    wait_until_read(window);
    EXPECT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->item(0, 4)->text(), "–");
    EXPECT_TRUE(find<QLabel>(window, "limits_mark")->text().contains("at least 8"));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
