// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the curriculum: its tasks and rules, what another rule would do, and the file of a new version.
// With FULCRUM_PICTURES=FOLDER pictures are stored there.
#include "ui/dashboards/curriculum_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QSlider>
#include <QTableWidget>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "tests/database/large_programme.h"
#include "tests/support/processor_time.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/dashboards/pass_rule_chart.h"
#include "ui/dashboards/pass_rule_designer.h"
#include "ui/shell/main_window.h"

namespace fulcrum::ui::window_test {
namespace {

class CurriculumView : public ::testing::Test {
  protected:
    CurriculumView() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        const auto programme = database::test::make_large_programme(*services.store(), 3, 2, 1, 7);
        window.resize(1024, 740);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.start();
        window.context().set_session(programme.director);
        click(window, "rail_curriculum");
        tasks = find<QListWidget>(window, "curriculum_tasks");
        table = find<QTableWidget>(window, "rule_table");
        chart = window.findChild<PassRuleChart*>("pass_rule_chart");
    }
    ~CurriculumView() override { apply_theme(*qApp, Theme::light); }
    void keep(const QString& name) {
        QCoreApplication::processEvents();
        if (!qEnvironmentVariableIsSet("FULCRUM_PICTURES")) return;
        window.grab().save(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES")) + "/" + name + ".png");
    }
    void choose(const char* task) {
        for (int row = 0; row < tasks->count(); ++row) {
            if (tasks->item(row)->data(Qt::UserRole).toString() != task) continue;
            tasks->setFocus();
            while (tasks->currentRow() != row)
                QTest::keyClick(tasks, tasks->currentRow() < row ? Qt::Key_Down : Qt::Key_Up);
        }
    }
    void step(const char* slider, int times, Qt::Key key) {
        auto* dial = find<QSlider>(window, slider);
        dial->setFocus();
        for (int i = 0; i < times; ++i) QTest::keyClick(dial, key);
    }
    const PassRule& rule_of(const char* task) { return services.curriculum().find(task)->rule; }

    FakeServices services;
    MainWindow window{services};
    QListWidget* tasks = nullptr;
    QTableWidget* table = nullptr;
    PassRuleChart* chart = nullptr;
};

TEST_F(CurriculumView, ShowsWhatTheRuleInForceDoes) {
    ASSERT_EQ(tasks->count(), static_cast<int>(services.curriculum().tasks.size()));
    choose("A2");
    EXPECT_FALSE(chart->curves().changed);
    for (std::size_t k = 0; k < designer_trainees.size(); ++k) {
        const OperatingPoint point = operating_point(rule_of("A2"), designer_trainees[k], designer_attempts);
        EXPECT_EQ(chart->curves().tried[k].back(), point.declared);
        const QString half = table->item(static_cast<int>(k), 4)->text();
        if (point.median_attempts) {
            EXPECT_EQ(half, QString::number(*point.median_attempts));
        } else {
            EXPECT_EQ(half, "> 60");
        }
    }
    keep("curriculum-light");
    window.set_theme(Theme::dark);
    keep("curriculum-dark");
    EXPECT_FALSE(find<QAbstractButton>(window, "curriculum_save")->isEnabled()) << "nothing to write";
}

TEST_F(CurriculumView, ARuleThatIsTriedIsDrawnWithTheOneInForceAndTakenBack) {
    choose("A2");
    const PassRule before = rule_of("A2");
    auto* kind = find<QComboBox>(window, "rule_kind");
    kind->setFocus();
    QTest::keyClick(kind, Qt::Key_Home);
    EXPECT_TRUE(chart->curves().changed);
    step("rule_passes", 10, Qt::Key_Left);
    step("rule_passes", 1, Qt::Key_Right);
    // Two in a row: whoever passes every other attempt is nearly sure to be declared within 30.
    EXPECT_NEAR(chart->curves().tried[2][29], 0.9979, 1e-4);
    EXPECT_TRUE(table->item(2, 3)->text().startsWith("99.8 %")) << table->item(2, 3)->text().toStdString();
    EXPECT_EQ(chart->curves().in_force[2].back(), operating_point(before, 0.5, designer_attempts).declared);
    EXPECT_TRUE(tasks->currentItem()->text().contains("tried: 2 passes in a row"));
    keep("curriculum-tried-light");
    window.set_theme(Theme::dark);
    keep("curriculum-tried-dark");
    window.set_theme(Theme::light);
    window.resize(1280, 1000);
    keep("curriculum-tried-large");
    window.resize(1024, 740);

    choose("B1");
    EXPECT_FALSE(chart->curves().changed) << "another task has its own rule";
    choose("A2");
    EXPECT_TRUE(chart->curves().changed) << "what was tried is still there";
    click(window, "rule_restore");
    EXPECT_FALSE(chart->curves().changed);
    EXPECT_FALSE(tasks->currentItem()->text().contains("tried"));
}

TEST_F(CurriculumView, CurvesFollowASliderAtOnce) {
    choose("A2");
    auto* limit = find<QSlider>(window, "rule_limit");
    limit->setFocus();
    const test::ProcessorTime timer;
    step("rule_limit", 10, Qt::Key_Right);
    const double each = timer.milliseconds() / 10;
    RecordProperty("milliseconds_a_step", std::to_string(each));
    EXPECT_LT(each, 100);
    EXPECT_NEAR(window.findChild<PassRuleDesigner*>()->tried().h, rule_of("A2").h + 1, 1e-9);
}

TEST_F(CurriculumView, WritesTheFileOfANewVersion) {
    QTemporaryDir folder;
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    auto* path = find<QLineEdit>(window, "curriculum_path");
    EXPECT_TRUE(path->text().endsWith("rectal-3.json")) << path->text().toStdString();
    path->setText(folder.filePath("rectal-3.json"));
    click(window, "curriculum_save");
    ASSERT_TRUE(wait_for([&] { return QFileInfo::exists(folder.filePath("rectal-3.json")); }));
    const Curriculum written = load_curriculum(folder.filePath("rectal-3.json").toStdString(), task_ids());
    EXPECT_EQ(written.version, services.curriculum().version + 1);
    EXPECT_EQ(pass_rule_text(written.find("C4")->rule), "of:3,5");
    EXPECT_EQ(pass_rule_text(written.find("A2")->rule), pass_rule_text(rule_of("A2")));
    EXPECT_EQ(find<QAbstractButton>(window, "curriculum_save")->text(), "Replace");

    path->setText(folder.filePath("nowhere/rectal-3.json"));
    click(window, "curriculum_save");
    EXPECT_FALSE(QFileInfo::exists(folder.filePath("nowhere")));
    EXPECT_TRUE(find<QLabel>(window, "message_text")->text().contains("nowhere"))
        << find<QLabel>(window, "message_text")->text().toStdString();
}

}  // namespace
}  // namespace fulcrum::ui::window_test
