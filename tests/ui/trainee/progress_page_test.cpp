// SPDX-License-Identifier: GPL-3.0-or-later
// The progress page with a history: the learning curve, and an educator who decides on a standing. With
// FULCRUM_PICTURES=FOLDER the pages are stored there.
#include "ui/trainee/progress_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <cmath>

#include "assessment/scoring/benchmark.h"

#include "database/records/certificates.h"
#include "database/records/curricula.h"
#include "database/records/people.h"
#include "database/records/recorder.h"
#include "database/records/standings.h"
#include "tests/support/support.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/files.h"
#include "tests/ui/four_people.h"
#include "tests/ui/hands.h"
#include "ui/charts/attempt_chart.h"
#include "ui/language/language.h"
#include "ui/shell/main_window.h"
#include "ui/theatre/scene_picture.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Role;

class ProgressWithHistory : public ::testing::Test {
  protected:
    ProgressWithHistory() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        sessions = make_four_people(*services.store());
    }
    ~ProgressWithHistory() override { apply_theme(*qApp, Theme::light); }

    /// A completed attempt whose left path is `path` mm long, with a limit of 900 mm. `version`: of the
    /// metric.
    void record(double path, const std::string& task = "A2", const std::string& variant = "standard",
                int version = 1) {
        const database::Session& tara = sessions.at(Role::trainee);
        database::AttemptMeta meta;
        meta.person_id = tara.person_id();
        meta.task_id = task;
        meta.mode = AttemptMode::assessed;
        meta.device_class = DeviceClass::mouse_keyboard;
        meta.device = "mouse and keyboard";
        meta.variant = variant;
        meta.fidelity = "standard";
        meta.scene = "a2_targets.json";
        meta.limits = "A2-operators@1";
        meta.program_version = "test";
        database::Recorder recorder(services.store()->path(), tara, meta);
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = 30;
        database::ScoreRow score;
        score.passed = path <= 900;
        score.points = path <= 900 ? 80 : 40;
        score.metrics.push_back({"path_len", version, "left", "", path, {}, "mm", Direction::lower, {}});
        score.gates.push_back({"path_len",
                               "left",
                               "",
                               GateKind::benchmark,
                               path,
                               "mm",
                               900.0,
                               "A2-operators@1",
                               0.5,
                               60.0,
                               path <= 900,
                               true,
                               {}});
        result.score = score;
        recorder.finish(result);
    }
    ProgressPage& open(Role role) {
        window = std::make_unique<MainWindow>(services);
        window->resize(1000, 720);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        window->context().set_session(sessions.at(role));
        click(*window, "rail_progress");
        wait_until_read(*window);
        return *static_cast<ProgressPage*>(window->current_page());
    }
    void keep(const QString& name) {
        QCoreApplication::processEvents();
        if (!qEnvironmentVariableIsSet("FULCRUM_PICTURES")) return;
        window->grab().save(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES")) + "/" + name + ".png");
    }

    FakeServices services;
    std::map<Role, database::Session> sessions;
    std::unique_ptr<MainWindow> window;
};

TEST_F(ProgressWithHistory, ShowsTheCurveItsPlateauAndTheLimit) {
    for (int i = 0; i < 14; ++i) record(700 + 800 * std::exp(-0.35 * i) + (i % 2 == 0 ? 25 : -25));
    open(Role::trainee);
    auto* metric = find<QComboBox>(*window, "progress_metric");
    const int index = metric->findData("path_len/left/");
    ASSERT_GE(index, 0);
    metric->setCurrentIndex(index);
    emit metric->activated(index);
    const QString words = find<QLabel>(*window, "learning_curve")->text();
    EXPECT_TRUE(words.startsWith("The curve levels off at 7")) << words.toStdString();
    EXPECT_TRUE(words.contains("It has met the limit of 900")) << words.toStdString();
    keep("progress-curve");
    window->set_theme(Theme::dark);
    keep("progress-curve-dark");
}

TEST_F(ProgressWithHistory, VersionsOfAMetricAreNeverInOneCurve) {
    for (int i = 0; i < 8; ++i) record(1500 + 10 * (i % 3), "A2", "standard", 1);
    for (int i = 0; i < 8; ++i) record(700 + 10 * (i % 3), "A2", "standard", 2);
    open(Role::trainee);
    auto* metric = find<QComboBox>(*window, "progress_metric");
    const int newest = metric->findData("path_len/left/"), older = metric->findData("path_len/left/@1");
    ASSERT_GE(newest, 0);
    ASSERT_GT(older, newest) << "older versions come last";
    EXPECT_EQ(metric->itemText(older), metric->itemText(newest) + ", version 1");
    EXPECT_EQ(metric->count(), 3) << "points, and the two versions";
    for (const bool is_newest : {true, false}) {
        const int index = is_newest ? newest : older;
        metric->setCurrentIndex(index);
        emit metric->activated(index);
        const AttemptChartData& chart = find<AttemptChart>(*window, "attempt_chart")->shown();
        ASSERT_EQ(chart.series.size(), 1U);
        int values = 0;
        for (const AttemptPoint& point : chart.series[0].points) {
            if (!point.value) continue;
            ++values;
            EXPECT_EQ(*point.value < 900, is_newest) << *point.value;
        }
        EXPECT_EQ(values, 8);
        EXPECT_EQ(chart.series[0].curve.size(), 8U);
        EXPECT_FALSE(chart.band_low) << "the experts are measured by the metric as it is defined now";
    }
    EXPECT_EQ(find<QTableWidget>(*window, "progress_table")->rowCount(), 16);
}

TEST_F(ProgressWithHistory, TheExpertsAreThoseOfTheVariantThatTheCurveIsOf) {
    record(1200, "B1");
    record(850, "B1", "long_jaws");
    open(Role::trainee);
    ASSERT_EQ(find<QComboBox>(*window, "progress_task")->currentData().toString(), "B1");
    EXPECT_EQ(services.judged_variant, "long_jaws");
    auto* metric = find<QComboBox>(*window, "progress_metric");
    const auto choose = [&] {
        const int index = metric->findData("path_len/left/");
        ASSERT_GE(index, 0);
        metric->setCurrentIndex(index);
        emit metric->activated(index);
    };
    choose();
    EXPECT_TRUE(find<AttemptChart>(*window, "attempt_chart")->shown().band_low);
    // A variant that the task no longer has.
    record(830, "B1", "retired");
    services.judged_variant.reset();
    open(Role::trainee);
    metric = find<QComboBox>(*window, "progress_metric");
    choose();
    EXPECT_FALSE(services.judged_variant);
    EXPECT_FALSE(find<AttemptChart>(*window, "attempt_chart")->shown().band_low);
}

TEST_F(ProgressWithHistory, AMetricHasItsNameInTheReadersLanguage) {
    record(1000);
    use_language(Language::german);
    open(Role::trainee);
    auto* metric = find<QComboBox>(*window, "progress_metric");
    const int index = metric->findData("path_len/left/");
    EXPECT_EQ(metric->itemText(index).toStdString(), "Weglänge, linke Hand");
    metric->setCurrentIndex(index);
    emit metric->activated(index);
    const QString title = find<AttemptChart>(*window, "attempt_chart")->shown().y_title;
    EXPECT_TRUE(title.startsWith("Weglänge, linke Hand")) << title.toStdString();
    use_language(Language::english);
}

TEST_F(ProgressWithHistory, IsThePageOfTheTask) {
    for (int i = 0; i < 14; ++i) record(700 + 800 * std::exp(-0.35 * i) + (i % 2 == 0 ? 25 : -25));
    open(Role::trainee);
    EXPECT_TRUE(sees(*window, "task_header"));
    EXPECT_TRUE(sees(*window, "task_demonstration"));
    auto* picture = find<ScenePicture>(*window, "scene_picture");
    EXPECT_TRUE(wait_for([&] { return !picture->picture().isNull(); })) << picture->trouble().toStdString();
    EXPECT_FALSE(sees(*window, "explain_progress")) << "points are no metric";
    auto* metric = find<QComboBox>(*window, "progress_metric");
    const int index = metric->findData("path_len/left/");
    ASSERT_GE(index, 0);
    metric->setCurrentIndex(index);
    emit metric->activated(index);
    const AttemptChartData& chart = find<AttemptChart>(*window, "attempt_chart")->shown();
    const BenchmarkSet set = load_benchmark(fulcrum::test::source_path("assets/benchmarks/A2.json"));
    const BenchmarkLevel& level = *set.find("path_len", "left", "");
    ASSERT_TRUE(chart.band_low && chart.band_high);
    EXPECT_NEAR(*chart.band_low, std::exp(level.mean - level.deviation), 1e-6);
    EXPECT_NEAR(*chart.band_high, std::exp(level.mean + level.deviation), 1e-6);
    EXPECT_EQ(chart.limit, 900.0) << "the limit that scored the attempts";
    EXPECT_TRUE(chart.series.at(0).plateau_low && !chart.series.at(0).curve.empty());
    for (const Theme theme : {Theme::light, Theme::dark}) {
        window->set_theme(theme);
        for (const QSize size : {QSize(1012, 726), QSize(1268, 758), QSize(1908, 1038)}) {
            window->resize(size);
            QCoreApplication::processEvents();
            keep_body(
                *window, *window->current_page(),
                QStringLiteral("task-%1-%2").arg(size.width()).arg(theme == Theme::light ? "light" : "dark"));
        }
    }
    click(*window, "explain_progress");
    EXPECT_EQ(window->current_page()->objectName(), "metrics_page");
    click(*window, "rail_progress");
    wait_until_read(*window);
    click(*window, "task_briefing");
    EXPECT_EQ(window->current_page()->objectName(), "briefing_page");
    click(*window, "briefing_progress");
    EXPECT_EQ(window->current_page()->objectName(), "progress_page");
    EXPECT_EQ(find<QComboBox>(*window, "progress_task")->currentData().toString(), "A2");
    // Whoever looks at another person's progress performs nothing from there.
    open(Role::educator);
    EXPECT_TRUE(sees(*window, "task_header"));
    EXPECT_FALSE(sees(*window, "task_briefing"));
}

TEST_F(ProgressWithHistory, ACompletedStageHasACertificateWithACheckCode) {
    record(1200);
    open(Role::trainee);
    EXPECT_FALSE(sees(*window, "save_certificate"));
    for (const char* task : {"A1", "A2", "A3"})
        database::Standings(*services.store())
            .decide(sessions.at(Role::educator), sessions.at(Role::trainee).person_id(), task,
                    StandingOverride::Kind::proficient, "examined in theatre");
    open(Role::trainee);
    QTemporaryDir folder;
    type(*window, "export_path", folder.filePath("progress.pdf"));
    click(*window, "rail_home");
    click(*window, "rail_progress");
    wait_until_read(*window);
    const QString words = find<QLabel>(*window, "certificate_words")->text();
    const QString code = words.section("Check code ", 1).left(19);
    click(*window, "save_certificate");
    const QString message = find<QLabel>(*window, "message_text")->text();
    ASSERT_TRUE(message.startsWith("Wrote ")) << message.toStdString();
    const QString path = message.mid(6);
    const std::string paper = pdf_text(path);
    for (const std::string& part : {std::string("Tara Trainee"), std::string("stage A, Instruments"),
                                    code.toStdString(), std::string("by decision of an educator")})
        EXPECT_NE(paper.find(part), std::string::npos) << part << paper;
    EXPECT_TRUE(database::find_certificate(*services.store(), sessions.at(Role::director), code.toStdString(),
                                           services.curriculum()));
    // A second one does not replace the first.
    click(*window, "save_certificate");
    EXPECT_NE(find<QLabel>(*window, "message_text")->text().mid(6), path);
    QFile::remove(find<QLabel>(*window, "message_text")->text().mid(6));
    QFile::remove(path);
}

TEST_F(ProgressWithHistory, ACertificateSaysOfWhichVersionItIsAfterAMove) {
    record(1200);
    const std::string tara = sessions.at(Role::trainee).person_id();
    for (const char* task : {"A1", "A2", "A3"})
        database::Standings(*services.store())
            .decide(sessions.at(Role::educator), tara, task, StandingOverride::Kind::proficient,
                    "examined in theatre");
    open(Role::trainee);
    const QString code =
        find<QLabel>(*window, "certificate_words")->text().section("Check code ", 1).left(19);
    database::Curricula(*services.store())
        .move(sessions.at(Role::educator), {tara}, services.curriculum(), "rectal@3", "new rules");
    open(Role::trainee);
    QTemporaryDir folder;
    type(*window, "export_path", folder.filePath("progress.pdf"));
    click(*window, "rail_home");
    click(*window, "rail_progress");
    wait_until_read(*window);
    const QString words = find<QLabel>(*window, "certificate_words")->text();
    EXPECT_TRUE(words.contains("under rectal@1, before the move to rectal@3. Check code " + code))
        << words.toStdString();
    click(*window, "save_certificate");
    const std::string paper = pdf_text(find<QLabel>(*window, "message_text")->text().mid(6));
    EXPECT_NE(paper.find("Completed under rectal@1"), std::string::npos) << paper;
}

TEST_F(ProgressWithHistory, ANameWithASlashIsNotAFolderForTheCertificate) {
    const database::Session& tara = sessions.at(Role::trainee);
    database::People(*services.store())
        .rename(sessions.at(Role::administrator), tara.person_id(), "Tara A/B Trainee");
    record(1200);
    for (const char* task : {"A1", "A2", "A3"})
        database::Standings(*services.store())
            .decide(sessions.at(Role::educator), tara.person_id(), task, StandingOverride::Kind::proficient,
                    "examined in theatre");
    open(Role::trainee);
    QTemporaryDir folder;
    type(*window, "export_path", folder.filePath("progress.pdf"));
    click(*window, "rail_home");
    click(*window, "rail_progress");
    wait_until_read(*window);
    click(*window, "save_certificate");
    const QString path = folder.filePath("Certificate A Tara A B Trainee.pdf");
    ASSERT_TRUE(QFileInfo::exists(path)) << find<QLabel>(*window, "message_text")->text().toStdString();
    EXPECT_NE(pdf_text(path).find("Tara A/B Trainee"), std::string::npos) << "the whole name on the paper";
}

TEST_F(ProgressWithHistory, AnEducatorUnlocksATaskWithAReason) {
    record(1200);
    open(Role::educator);
    auto* task = find<QComboBox>(*window, "progress_task");
    task->setCurrentIndex(task->findData("B1"));
    emit task->activated(task->currentIndex());
    EXPECT_EQ(find<QLabel>(*window, "standing_text")->text(), "Locked until proficient in A2");
    EXPECT_EQ(find<QComboBox>(*window, "decision_kind")->count(), 2);
    click(*window, "decide_standing");
    EXPECT_EQ(find<QLabel>(*window, "standing_text")->text(), "Locked until proficient in A2")
        << "nothing is decided without a reason";
    QTest::keyClicks(find<QLineEdit>(*window, "decision_reason"), "course elsewhere");
    click(*window, "decide_standing");
    EXPECT_EQ(find<QLabel>(*window, "standing_text")->text(), "Open");
    EXPECT_EQ(find<QComboBox>(*window, "decision_kind")->count(), 1) << "there is nothing left to unlock";
    keep("progress-decided");
    QTest::keyClicks(find<QLineEdit>(*window, "decision_reason"), "examined in theatre");
    click(*window, "decide_standing");
    EXPECT_TRUE(find<QLabel>(*window, "standing_text")->text().startsWith("Proficient since"));
    EXPECT_FALSE(sees(*window, "decide_standing")) << "no check is due";
    const auto rows = database::Standings(*services.store())
                          .overrides(sessions.at(Role::trainee), sessions.at(Role::trainee).person_id());
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[1].reason, "course elsewhere");
    // The trainee sees the standing and the reason, and can decide nothing.
    open(Role::trainee);
    task = find<QComboBox>(*window, "progress_task");
    task->setCurrentIndex(task->findData("B1"));
    emit task->activated(task->currentIndex());
    EXPECT_TRUE(find<QLabel>(*window, "standing_text")->text().startsWith("Proficient since"));
    EXPECT_FALSE(sees(*window, "decide_standing"));
    keep("progress-decided-trainee");
}

TEST_F(ProgressWithHistory, ADecisionThatChangedNothingSaysSo) {
    record(1200);
    // As an older version of the program wrote them: it asked nothing.
    for (const char* reason : {"examined in theatre", "examined once more"})
        database::Standings(*services.store())
            .decide(sessions.at(Role::educator), sessions.at(Role::trainee).person_id(), "A2",
                    StandingOverride::Kind::proficient, reason);
    open(Role::trainee);
    find<QLabel>(*window, "decision_words");
    QStringList lines;
    for (const QLabel* label : window->findChildren<QLabel*>("decision_words"))
        if (label->isVisible()) lines << label->text();
    ASSERT_EQ(lines.size(), 2);
    EXPECT_EQ(lines.filter("Declared proficient by").size(), 2) << lines.join('\n').toStdString();
    EXPECT_EQ(lines.filter("Check confirmed").size(), 0);
    EXPECT_EQ(lines.filter("changed nothing: proficient already, and no check was due").size(), 1);
}

TEST_F(ProgressWithHistory, ADecisionThatAnotherMadeFirstIsRefusedAndTheCardShowsTheStanding) {
    record(1200);
    open(Role::educator);
    auto* task = find<QComboBox>(*window, "progress_task");
    task->setCurrentIndex(task->findData("B1"));
    emit task->activated(task->currentIndex());
    database::Standings(*services.store())
        .decide(sessions.at(Role::educator), sessions.at(Role::trainee).person_id(), "B1",
                StandingOverride::Kind::unlocked, "at another station");
    ASSERT_EQ(find<QComboBox>(*window, "decision_kind")->currentText(), "Unlock");
    QTest::keyClicks(find<QLineEdit>(*window, "decision_reason"), "course elsewhere");
    click(*window, "decide_standing");
    EXPECT_TRUE(find<QLabel>(*window, "message_text")->text().contains("B1 is not locked"))
        << find<QLabel>(*window, "message_text")->text().toStdString();
    EXPECT_EQ(find<QLabel>(*window, "standing_text")->text(), "Open");
    EXPECT_EQ(database::Standings(*services.store())
                  .overrides(sessions.at(Role::educator), sessions.at(Role::trainee).person_id())
                  .size(),
              1U);
}

TEST_F(ProgressWithHistory, TheCurriculumsCardShowsWhatADecisionSettles) {
    open(Role::educator);  // Tara has no attempt: a decision keeps the version
    auto* task = find<QComboBox>(*window, "progress_task");
    task->setCurrentIndex(task->findData("B1"));
    emit task->activated(task->currentIndex());
    const auto lines = [&] {
        find<QLabel>(*window, "curriculum_name");  // its labels are shown by an event to come
        QStringList words;
        for (const QLabel* label : find<QWidget>(*window, "curriculum_card")->findChildren<QLabel*>())
            if (label->isVisible()) words << label->text();
        return words.join('\n');
    };
    EXPECT_FALSE(lines().contains("by a decision of Ed Educator")) << lines().toStdString();
    auto* versions = find<QComboBox>(*window, "curriculum_versions");
    versions->setCurrentIndex(versions->count() - 1);
    const QString chosen = versions->currentText();
    QTest::keyClicks(find<QLineEdit>(*window, "curriculum_reason"), "autumn course");
    QTest::keyClicks(find<QLineEdit>(*window, "decision_reason"), "course elsewhere");
    click(*window, "decide_standing");
    EXPECT_TRUE(lines().contains("by a decision of Ed Educator")) << lines().toStdString();
    EXPECT_EQ(find<QLineEdit>(*window, "curriculum_reason")->text(), "autumn course");
    EXPECT_EQ(find<QComboBox>(*window, "curriculum_versions")->currentText(), chosen);
}

TEST_F(ProgressWithHistory, AnEducatorMovesAPersonToTheNewerCurriculumAfterALook) {
    record(1200);  // does not name a version: the first one
    open(Role::educator);
    EXPECT_TRUE(find<QLabel>(*window, "curriculum_name")->text().contains("version 1"));
    EXPECT_EQ(find<QComboBox>(*window, "curriculum_versions")->currentData().toString(), "rectal@3");
    click(*window, "curriculum_preview");
    EXPECT_TRUE(find<QLabel>(*window, "curriculum_changes")->text().contains("No standing changes"));
    click(*window, "curriculum_move");
    EXPECT_TRUE(find<QLabel>(*window, "curriculum_name")->text().contains("version 1")) << "without a reason";
    QTest::keyClicks(find<QLineEdit>(*window, "curriculum_reason"), "autumn course");
    keep("progress-curriculum");
    click(*window, "curriculum_move");
    EXPECT_TRUE(find<QLabel>(*window, "curriculum_name")->text().contains("version 3"));
    apply_theme(*qApp, Theme::dark);
    keep("progress-curriculum-moved");
    apply_theme(*qApp, Theme::light);
    open(Role::trainee);
    EXPECT_TRUE(find<QLabel>(*window, "curriculum_name")->text().contains("version 3"));
    EXPECT_FALSE(sees(*window, "curriculum_move"));
    keep("progress-curriculum-trainee");
}

TEST_F(ProgressWithHistory, TheTaskShowsItsVariantsAndLeadsToTheBriefingOfOne) {
    record(850);
    open(Role::trainee);
    const QList<QPushButton*> variants = window->findChildren<QPushButton*>("task_variant");
    ASSERT_EQ(variants.size(), 3);
    EXPECT_EQ(variants[0]->text(), "Standard: 1 of 1 attempts passed");
    EXPECT_EQ(variants[2]->text(), "Trocars further right: not practised yet");
    keep("progress-variants");
    QTest::mouseClick(variants[2], Qt::LeftButton);
    EXPECT_EQ(window->current_page()->objectName(), "briefing_page");
    EXPECT_EQ(find<QComboBox>(*window, "variants")->currentData().toString(), "trocars_right");
}

}  // namespace
}  // namespace fulcrum::ui::window_test
