// SPDX-License-Identifier: GPL-3.0-or-later
// The briefing: a picture of the scene that is drawn once and kept; the limits as bars with the experts'
// range and the trainee's own last value; the list one click away.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QRadioButton>
#include <QScrollBar>

#include "assessment/metrics/registry.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/records/recorder.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/charts/limit_bar.h"
#include "ui/language/language.h"
#include "ui/shell/main_window.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/scene_picture.h"
#include "ui/trainee/judged_card.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Role;
using database::Session;

class Briefing : public ::testing::Test {
  protected:
    Briefing() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        const database::People people(*services.store());
        const Session alma =
            people.create_programme("Surgery", "alma", "Alma Admin", "correct horse").administrator;
        const auto made = people.create(alma, "tara", "Tara Trainee", {Role::trainee});
        tara = std::make_unique<Session>(people.change_password(
            people.sign_in("tara", made.one_time_password), made.one_time_password, "a long password"));
    }
    ~Briefing() override { apply_theme(*qApp, Theme::light); }
    void open(const char* task, QSize size = {1012, 726}) {
        if (!window) {
            window = std::make_unique<MainWindow>(services);
            window->resize(size);
            window->show();
            ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
            window->start();
            window->context().set_session(*tara);
        }
        emit window->context().briefing_wanted(QString::fromLatin1(task));
    }
    ScenePicture& picture() { return *find<ScenePicture>(*window, "scene_picture"); }
    void wait_for_picture() {
        ASSERT_TRUE(
            wait_for([&] { return !picture().picture().isNull() || !picture().trouble().isEmpty(); }));
        EXPECT_EQ(picture().trouble().toStdString(), "");
    }
    const TaskDefinition& task(const char* id) {
        for (const TaskDefinition& one : services.tasks())
            if (one.id == id) return one;
        throw std::runtime_error(id);
    }
    LimitBar* bar(const QString& name) {
        for (LimitBar* one : window->findChildren<LimitBar*>())
            if (one->isVisible() && one->data().name == name) return one;
        return nullptr;
    }
    /// An attempt of A2 by mouse with a time and a force.
    void record(double time_s, double force) {
        database::AttemptMeta meta;
        meta.person_id = tara->person_id();
        meta.task_id = "A2";
        meta.mode = AttemptMode::practice;
        meta.device_class = window_device;
        meta.device = "test";
        meta.variant = "standard";
        meta.fidelity = "standard";
        meta.scene = "a2_targets.json";
        meta.limits = "A2-operators@1";
        meta.program_version = "0.1.0-test";
        database::Recorder recorder(services.store()->path(), *tara, meta, {});
        TickSample sample;
        sample.tick = 1;
        recorder.append(RigSample());
        recorder.append(sample);
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = result.wall_s = time_s;
        result.state_hash = "00ff";
        database::ScoreRow score;
        score.program_version = "0.1.0-test";
        score.limits = "A2-operators@1";
        database::MetricRow row;
        row.id = "time";
        row.version = find_metric(row.id)->version;
        row.value = time_s;
        row.unit = "s";
        score.metrics.push_back(row);
        row.id = "f_max";
        row.version = find_metric(row.id)->version;
        row.hand = "left";
        row.value = force;
        row.unit = "N";
        score.metrics.push_back(row);
        score.passed = true;
        result.score = score;
        recorder.finish(result);
    }
    FakeServices services;
    std::unique_ptr<Session> tara;
    std::unique_ptr<MainWindow> window;
};

/// Pixels that are not nearly black.
double lit_share(const QImage& picture) {
    int lit = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) lit += qGray(picture.pixel(x, y)) > 24 ? 1 : 0;
    return static_cast<double>(lit) / (picture.width() * picture.height());
}

TEST_F(Briefing, PictureOfTheSceneIsDrawnOnceAndKept) {
    open("A2");
    wait_for_picture();
    EXPECT_GT(lit_share(picture().picture()), 0.1) << "the scope sees something";
    EXPECT_EQ(services.worlds_built, 1);
    const QString file = ScenePicture::file_of(services, task("A2"));
    EXPECT_TRUE(QFileInfo::exists(file)) << file.toStdString();
    EXPECT_TRUE(picture().accessibleName().contains("A2"));
    click(*window, "rail_home");
    wait_until_read(*window);
    open("A2");
    wait_for_picture();
    EXPECT_EQ(services.worlds_built, 1) << "kept";
    // A file that is no picture is drawn again.
    QFile broken(file);
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("not a picture");
    broken.close();
    click(*window, "rail_home");
    wait_until_read(*window);
    open("A2");
    wait_for_picture();
    EXPECT_EQ(services.worlds_built, 2);
    // Another task has its own.
    EXPECT_NE(ScenePicture::file_of(services, task("B2")), file);
}

TEST_F(Briefing, ChoosesTheVariantPractisedLeastAndAnotherIsAChoiceAway) {
    open("B0");
    EXPECT_FALSE(sees(*window, "variants")) << "there is nothing to choose";
    open("A2");
    auto* variants = find<QComboBox>(*window, "variants");
    ASSERT_EQ(variants->count(), 3);
    EXPECT_EQ(variants->currentData().toString(), "standard");
    record(75, 3.1);
    click(*window, "rail_home");
    wait_until_read(*window);
    open("A2");
    EXPECT_EQ(variants->currentData().toString(), "deep");
    EXPECT_TRUE(variants->itemText(0).contains("attempts: 1")) << variants->itemText(0).toStdString();
    EXPECT_TRUE(find<QLabel>(*window, "variant_note")->text().contains("least"));
    wait_for_picture();
    EXPECT_TRUE(QFileInfo::exists(ScenePicture::file_of(services, task("A2"), "deep")));
    EXPECT_FALSE(QFileInfo::exists(ScenePicture::file_of(services, task("A2"), "trocars_right")));
    keep_body(*window, *window->current_page(), QStringLiteral("briefing-variant"));
    variants->setFocus();
    QTest::keyClick(variants, Qt::Key_Down);
    EXPECT_EQ(variants->currentData().toString(), "trocars_right");
    wait_for_picture();
    EXPECT_TRUE(QFileInfo::exists(ScenePicture::file_of(services, task("A2"), "trocars_right")));
    click(*window, "start_attempt");
    services.control.complete = true;
    ASSERT_TRUE(wait_for([&] { return !services.control.last_attempt_id.empty(); }));
    const auto practised = database::Attempts(*services.store()).practised(*tara, tara->person_id(), "A2");
    ASSERT_EQ(practised.count("trocars_right"), 1U);
    EXPECT_EQ(practised.at("trocars_right").attempts, 1);
    EXPECT_EQ(practised.count("deep"), 0U);
}

TEST_F(Briefing, OffersNoAssessedAttemptWithADeviceThatTheFollowedCurriculumDoesNotCount) {
    Curriculum haptic_only = services.curriculum();
    for (CurriculumTask& one : haptic_only.tasks)
        if (one.task == "A2") one.device_classes = {DeviceClass::haptic};
    services.set_curriculum(std::move(haptic_only));
    open("A2");
    EXPECT_FALSE(find<QRadioButton>(*window, "mode_assessed")->isEnabled());
    EXPECT_TRUE(find<QRadioButton>(*window, "mode_practice")->isChecked());
    const auto note = [&] { return find<QLabel>(*window, "mode_note")->text(); };
    EXPECT_TRUE(note().contains("counts it with: haptic")) << note().toStdString();
    // Not in the curriculum at all: it can be assessed, and the page says what that is worth.
    click(*window, "rail_home");
    wait_until_read(*window);
    open("B0");
    EXPECT_TRUE(find<QRadioButton>(*window, "mode_assessed")->isEnabled());
    EXPECT_TRUE(note().contains("not part of your curriculum")) << note().toStdString();
}

TEST_F(Briefing, OffersItToAnyoneWhoMayBuildLimitsAndSaysWhatItIsFor) {
    Curriculum haptic_only = services.curriculum();
    for (CurriculumTask& one : haptic_only.tasks)
        if (one.task == "A2") one.device_classes = {DeviceClass::haptic};
    services.set_curriculum(std::move(haptic_only));
    {
        const database::People people(*services.store());
        people.set_roles(people.sign_in("alma", "correct horse"), tara->person_id(),
                         {Role::trainee, Role::educator});
        *tara = people.act_as(*tara, Role::trainee);
    }
    open("A2");
    EXPECT_TRUE(find<QRadioButton>(*window, "mode_assessed")->isEnabled());
    const QString note = find<QLabel>(*window, "mode_note")->text();
    EXPECT_TRUE(note.contains("for a benchmark set, not for your standing")) << note.toStdString();
}

TEST_F(Briefing, AsksTheDeviceForTheVariantOfThisTask) {
    services.in_use.kind = "touch";
    services.in_use.title = "3D Systems Touch";
    services.in_use.device_class = DeviceClass::haptic;
    services.in_use.drives[0] = services.in_use.drives[1] = true;
    record(75, 3.1);
    open("A2");
    ASSERT_EQ(find<QComboBox>(*window, "variants")->currentData().toString(), "deep");
    EXPECT_TRUE(find<QLabel>(*window, "mode_note")->text().contains("3D Systems Touch"));
    // A1 has no variant of this name, and only a scope, which this device does not move.
    click(*window, "rail_home");
    wait_until_read(*window);
    open("A1");
    EXPECT_FALSE(sees(*window, "message_text"));
    const QString note = find<QLabel>(*window, "mode_note")->text();
    EXPECT_TRUE(note.contains("You hold the scope with mouse and keyboard")) << note.toStdString();
}

TEST_F(Briefing, NamesTheDeviceInTheReadersLanguage) {
    services.in_use.kind = "controller";
    services.in_use.title = "game controller";
    services.in_use.device_class = DeviceClass::controller;
    use_language(Language::german);
    open("A2");
    const QString note = find<QLabel>(*window, "mode_note")->text();
    use_language(Language::english);
    EXPECT_TRUE(note.startsWith("Sie arbeiten mit: Gamecontroller.")) << note.toStdString();
}

TEST_F(Briefing, AVariantWithAcceptedFilesCountsWhereThePreselectedOneDoesNot) {
    services.unknown.push_back({"scenes/a2_targets_deep.json", std::string(64, '0')});
    services.unknown_variant = "deep";
    record(75, 3.1);
    open("A2");
    auto* variants = find<QComboBox>(*window, "variants");
    ASSERT_EQ(variants->currentData().toString(), "deep");
    auto* assessed = find<QRadioButton>(*window, "mode_assessed");
    EXPECT_FALSE(assessed->isEnabled());
    EXPECT_TRUE(find<QLabel>(*window, "mode_note")->text().contains("a2_targets_deep.json"));
    variants->setFocus();
    QTest::keyClick(variants, Qt::Key_Up);
    ASSERT_EQ(variants->currentData().toString(), "standard");
    EXPECT_TRUE(assessed->isEnabled());
    EXPECT_FALSE(find<QLabel>(*window, "mode_note")->text().contains("a2_targets_deep.json"));
    EXPECT_FALSE(find<QLabel>(*window, "variant_note")->text().contains("Chosen because"));
    assessed->click();
    QTest::keyClick(variants, Qt::Key_Down);
    ASSERT_EQ(variants->currentData().toString(), "deep");
    EXPECT_FALSE(assessed->isEnabled());
    EXPECT_TRUE(find<QRadioButton>(*window, "mode_practice")->isChecked());
}

TEST_F(Briefing, AnotherTaskWhileThePictureIsDrawnShowsTheOtherTask) {
    open("B2");
    open("A2");
    wait_for_picture();
    EXPECT_TRUE(picture().accessibleName().contains("A2"));
    EXPECT_TRUE(QFileInfo::exists(ScenePicture::file_of(services, task("A2"))));
    EXPECT_FALSE(QFileInfo::exists(ScenePicture::file_of(services, task("B2"))));
}

TEST(LastValues, OfAnOlderVersionOfAMetricAreLeftOut) {
    database::PersonProgress progress;
    database::ProgressSeries series;
    series.device_class = DeviceClass::haptic;
    database::ProgressPoint point;
    for (const char* id : {"time", "f_max"}) {
        database::MetricRow row;
        row.id = id;
        row.version = find_metric(id)->version;
        row.value = 1;
        point.metrics.push_back(row);
    }
    series.points.push_back(point);
    progress.series.push_back(series);
    EXPECT_EQ(last_values(progress, DeviceClass::haptic).size(), 2U);
    EXPECT_TRUE(last_values(progress, DeviceClass::controller).empty());
    progress.series[0].points[0].metrics[0].version -= 1;
    const std::vector<database::MetricRow> left = last_values(progress, DeviceClass::haptic);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].id, "f_max");
}

TEST_F(Briefing, LimitsAreBarsWithTheExpertsRangeAndTheTraineesLastValue) {
    record(140, 5.5);
    record(75, 3.1);
    open("A2");
    wait_until_read(*window);
    ASSERT_TRUE(wait_for([&] { return bar(metric_text("time")) != nullptr; }));
    LimitBar* time = bar(metric_text("time"));
    const LimitBarData& data = time->data();
    EXPECT_EQ(data.last, 75.0) << "the last attempt, not the one before";
    ASSERT_TRUE(data.limit && data.experts_low && data.experts_high);
    EXPECT_LT(*data.experts_low, *data.experts_high);
    EXPECT_LT(*data.experts_high, *data.limit);
    EXPECT_TRUE(time->accessibleName().contains("your last value 75 s"))
        << time->accessibleName().toStdString();
    EXPECT_TRUE(time->accessibleName().contains("at most"));
    EXPECT_LT(time->x_of(*data.experts_low), time->x_of(*data.limit));
    EXPECT_EQ(window->findChildren<LimitBar*>().size(), 9) << "every gate";
    EXPECT_FALSE(sees(*window, "judged_list"));
    click(*window, "judged_list_toggle");
    EXPECT_TRUE(sees(*window, "judged_list"));
    EXPECT_FALSE(sees(*window, "judged_bars"));
    click(*window, "explain_gate");
    EXPECT_EQ(window->current_page()->objectName(), "metrics_page");
}

TEST_F(Briefing, SpansOfBarsCoverEveryValue) {
    LimitBarData data;
    const auto covers = [&](double value) {
        const LimitBarSpan span = limit_bar_span(data);
        return span.low < span.high && span.low <= value && value <= span.high;
    };
    EXPECT_TRUE(covers(0)) << "nothing is known";
    data.limit = 0;
    EXPECT_TRUE(covers(0));
    data.last = 7;
    EXPECT_TRUE(covers(7));
    data.limit = -1.6;  // smoothness is negative
    data.last = -2.4;
    EXPECT_TRUE(covers(-2.4) && covers(-1.6) && covers(0));
    data.last = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(covers(-1.6));
    LimitBar bar(data);
    bar.resize(200, 60);
    EXPECT_GE(bar.x_of(-1e9), 0);
    EXPECT_LE(bar.x_of(1e9), 200);
}

TEST_F(Briefing, FitsAndIsPicturedInBothThemes) {
    record(75, 3.1);
    for (const QSize size : {QSize(1012, 726), QSize(1268, 758), QSize(1908, 1038)}) {
        for (const Theme theme : {Theme::light, Theme::dark}) {
            window.reset();
            apply_theme(*qApp, theme);
            for (const char* id : {"A2", "C4"}) {
                open(id, size);
                wait_for_picture();
                auto* body = window->current_page()->findChild<QWidget*>("page_body");
                auto* area = qobject_cast<QScrollArea*>(body->parentWidget()->parentWidget());
                EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0) << size.width();
                keep_body(*window, *window->current_page(),
                          QStringLiteral("briefing-%1-%2-%3")
                              .arg(QLatin1String(id))
                              .arg(size.width())
                              .arg(theme == Theme::light ? "light" : "dark"));
            }
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
