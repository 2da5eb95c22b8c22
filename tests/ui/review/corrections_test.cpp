// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections through the window with real events: an attempt of the wrong person, a gate without a limit in
// any benchmark, reports written in the background.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <memory>

#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/records/recorder.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/main_window.h"
#include "ui/trainee/progress_page.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Role;
using database::Session;

class Corrections : public ::testing::Test {
  protected:
    Corrections() {
        services.open_store(false);
        const database::People people(*services.store());
        const Session administrator =
            people.create_programme("Surgery", "alma", "Alma Admin", password).administrator;
        const auto add = [&](const char* login, const char* name, Role role) {
            const auto created = people.create(administrator, login, name, {role});
            return people.change_password(people.sign_in(login, created.one_time_password),
                                          created.one_time_password, password);
        };
        director = std::make_unique<Session>(add("dora", "Dora Director", Role::director));
        educator = std::make_unique<Session>(add("ed", "Ed Educator", Role::educator));
        tara = std::make_unique<Session>(add("tara", "Tara Trainee", Role::trainee));
        theo = std::make_unique<Session>(add("theo", "Theo Trainee", Role::trainee));
        const std::string cohort = people.create_cohort(*director, "Spring");
        people.set_members(*director, cohort, {tara->person_id(), theo->person_id()});
        people.set_educators(*director, cohort, {educator->person_id()});
        window = std::make_unique<MainWindow>(services);
        window->resize(1280, 800);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
    }
    /// A finished attempt of one second.
    std::string record(const Session& person) {
        database::AttemptMeta meta;
        meta.person_id = person.person_id();
        meta.task_id = "A2";
        meta.mode = AttemptMode::assessed;
        meta.device_class = DeviceClass::mouse_keyboard;
        meta.device = "mouse and keyboard";
        meta.variant = meta.fidelity = "standard";
        meta.scene = "a2_targets.json";
        meta.program_version = "0.1.0";
        database::Recorder recorder(services.store()->path(), person, meta);
        for (std::uint32_t tick = 1; tick <= 1000; ++tick) {
            RigSample input;
            input.tick = tick;
            recorder.append(input);
            TickSample sample;
            sample.tick = tick;
            recorder.append(sample);
        }
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = result.wall_s = 1;
        result.score.emplace();
        result.score->program_version = "0.1.0";
        result.score->not_scored_because = StatementId::no_benchmark;
        database::GateRow gate;
        gate.metric = "path_len";
        gate.hand = "left";
        gate.kind = GateKind::benchmark;
        gate.value = 812.5;
        gate.unit = "mm";
        gate.not_passed_because = StatementId::no_benchmark_level;
        result.score->gates.push_back(gate);
        recorder.finish(result);
        return recorder.attempt_id();
    }
    void act_as(const Session& session) { window->context().set_session(session); }
    DebriefPage& open_debrief(const std::string& id) {
        emit window->context().debrief_wanted(QString::fromStdString(id), -1);
        return ready_debrief();
    }
    DebriefPage& ready_debrief() {
        auto* debrief = static_cast<DebriefPage*>(window->current_page());
        EXPECT_EQ(debrief->objectName(), "debrief_page");
        EXPECT_TRUE(wait_for([&] { return debrief->is_ready(); }));
        return *debrief;
    }
    QString shown(const char* name) { return find<QLabel>(*window, name)->text(); }

    static constexpr const char* password = "correct horse battery";
    FakeServices services;
    std::unique_ptr<Session> director, educator, tara, theo;
    std::unique_ptr<MainWindow> window;
};

TEST_F(Corrections, TraineeRequestsAndEducatorReassignsToTheRightPerson) {
    const std::string id = record(*tara);
    act_as(*tara);
    open_debrief(id);
    choose_tab(*window, "debrief_tabs", "Corrections");
    EXPECT_FALSE(sees(*window, "void_attempt"));
    EXPECT_FALSE(sees(*window, "reassign_attempt"));
    type(*window, "action_reason", "Theo did this one");
    click(*window, "request_correction");

    act_as(*educator);
    click(*window, "rail_attempts");
    click(*window, "correction_request");
    ready_debrief();
    choose_tab(*window, "debrief_tabs", "Corrections");
    EXPECT_FALSE(sees(*window, "request_correction"));
    EXPECT_FALSE(sees(*window, "reassign_person"));
    click(*window, "reassign_attempt");
    auto* people = find<QComboBox>(*window, "reassign_person");
    ASSERT_EQ(people->count(), 1) << "only the cohort's other trainee";
    EXPECT_EQ(people->currentText(), "Theo Trainee");
    click(*window, "reassign_confirm");
    EXPECT_TRUE(shown("message_text").contains("reason"));
    type(*window, "action_reason", "signed in as Tara");
    keep_picture(*window, "30-reassign");
    click(*window, "reassign_confirm");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "verdict") && shown("verdict") == "Voided"; }));
    EXPECT_TRUE(shown("debrief_notes").contains("signed in as Tara"));
    EXPECT_TRUE(shown("debrief_notes").contains("copy"));

    const database::Attempts attempts(*services.store());
    const database::AttemptSummary voided = attempts.read(*educator, id);
    EXPECT_EQ(voided.state, AttemptState::voided);
    const auto theirs = attempts.list(*theo);
    ASSERT_EQ(theirs.size(), 1U);
    EXPECT_EQ(theirs[0].meta.id, voided.reassigned_to);
    EXPECT_EQ(theirs[0].reassigned_from, id);
    EXPECT_EQ(attempts.read_trace(*theo, theirs[0].meta.id).samples.size(), 1000U);
    ASSERT_EQ(attempts.correction_requests(*educator).size(), 1U);
    EXPECT_TRUE(attempts.correction_requests(*educator)[0].settled);

    act_as(*theo);
    open_debrief(theirs[0].meta.id);
    EXPECT_TRUE(shown("debrief_notes").contains("Reassigned"));
}

TEST_F(Corrections, VoidingAsksFirst) {
    ASSERT_TRUE(become_active(*window));
    const std::string id = record(*tara);
    act_as(*educator);
    open_debrief(id);
    choose_tab(*window, "debrief_tabs", "Corrections");
    const auto state = [&] { return database::Attempts(*services.store()).read(*educator, id).state; };
    click(*window, "void_attempt");
    EXPECT_TRUE(shown("message_text").contains("reason"));
    EXPECT_FALSE(sees(*window, "void_attempt_sure")) << "there is nothing to confirm yet";
    type(*window, "action_reason", "the camera was off");
    click(*window, "void_attempt");
    ASSERT_EQ(state(), AttemptState::completed) << "one press voids nothing";
    ASSERT_TRUE(sees(*window, "void_attempt_sure"));
    auto* first = find<QPushButton>(*window, "void_attempt");
    auto* sure = find<QPushButton>(*window, "void_attempt_sure");
    EXPECT_FALSE(QRect(first->mapTo(window.get(), QPoint()), first->size())
                     .intersects(QRect(sure->mapTo(window.get(), QPoint()), sure->size())));
    first->setFocus();
    QTest::keyClick(first, Qt::Key_Escape);
    EXPECT_FALSE(sees(*window, "void_attempt_sure"));
    EXPECT_EQ(state(), AttemptState::completed);
    click(*window, "void_attempt");
    click(*window, "void_attempt_sure");
    ready_debrief();
    EXPECT_EQ(state(), AttemptState::voided);
}

TEST_F(Corrections, GateWithoutALimitIsNotAssessed) {
    const std::string id = record(*tara);
    act_as(*tara);
    open_debrief(id);
    auto* gates = find<QTableWidget>(*window, "gates_table");
    ASSERT_EQ(gates->rowCount(), 1);
    EXPECT_EQ(gates->item(0, 3)->text(), "none");
    EXPECT_EQ(gates->item(0, 5)->text(), "– not assessed");
    EXPECT_FALSE(database::Attempts(*services.store()).score(*tara, id)->gates[0].limit);
}

TEST_F(Corrections, APersonsReportIsWrittenInTheBackgroundAndCanBeStopped) {
    record(*tara);
    act_as(*tara);
    click(*window, "rail_progress");
    wait_until_read(*window);
    auto* page = static_cast<ProgressPage*>(window->current_page());
    QTemporaryDir folder;
    const QString path = folder.filePath("tara.pdf");
    QSignalSpy done(page, &ProgressPage::exported);
    page->export_to(path, ReportFormat::pdf);
    EXPECT_EQ(done.count(), 0) << "nothing is written before the call returns";
    EXPECT_TRUE(sees(*window, "cancel_job"));
    ASSERT_TRUE(wait_for([&] { return done.count() == 1; }));
    EXPECT_TRUE(QFile::exists(path));
    EXPECT_FALSE(sees(*window, "cancel_job"));

    const QString stopped = folder.filePath("stopped.pdf");
    page->export_to(stopped, ReportFormat::pdf);
    click(*window, "cancel_job");
    EXPECT_FALSE(sees(*window, "cancel_job"));
    QThreadPool::globalInstance()->waitForDone();
    QCoreApplication::processEvents();
    EXPECT_EQ(done.count(), 1) << "a stopped report is not announced";
}

}  // namespace
}  // namespace fulcrum::ui::window_test
