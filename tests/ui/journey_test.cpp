// SPDX-License-Identifier: GPL-3.0-or-later
// The main workflow through the window, with real key and mouse events: programme, people, attempts
// (completed, abandoned, device lost), debrief, replay, comment, void, cohort table, exports.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTableWidget>
#include <nlohmann/json.hpp>

#include "assessment/assets/fidelity_cost.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/scoring/fidelity_now.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/files.h"
#include "tests/ui/hands.h"
#include "ui/charts/time_chart.h"
#include "ui/dashboards/cohort_page.h"
#include "ui/reports/report_export.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui::window_test {
namespace {

class Journey : public ::testing::Test {
  protected:
    Journey() : window(services) {
        window.resize(1280, 800);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.activateWindow();
        window.start();
    }
    QString page() const { return window.current_page()->objectName(); }
    void expect_page(const char* name) {
        EXPECT_TRUE(wait_for([&] { return page() == QLatin1String(name); })) << page().toStdString();
    }
    void create_programme() {
        click(window, "create_programme");
        type_programme(window);
        keep_picture(window, "02-create-programme");
        click(window, "create_confirm");
        ASSERT_TRUE(wait_for([&] { return sees(window, "recovery_code"); }));
        EXPECT_GE(find<QLabel>(window, "recovery_code")->text().size(), 16);
        keep_picture(window, "03-recovery-code");
        EXPECT_FALSE(find<QAbstractButton>(window, "code_continue")->isEnabled());
        check(window, "code_noted");
        click(window, "code_continue");
        expect_page("people_page");
    }
    /// Returns the one-time password.
    QString add_person(const QString& name, const QString& login, const char* role) {
        type(window, "new_person_name", name);
        type(window, "new_person_login", login);
        for (const char* one : {"trainee", "educator", "director", "administrator"}) {
            const QByteArray box = QByteArray("new_role_") + one;
            check(window, box.constData(), QLatin1String(one) == QLatin1String(role));
        }
        click(window, "add_person");
        return find<QLabel>(window, "one_time_password")->property("password").toString();
    }
    void switch_user() {
        click(window, "switch_user");
        expect_page("sign_in_page");
    }
    void sign_in(const QString& login, const QString& password) {
        type(window, "login", login);
        type(window, "password", password);
        QTest::keyClick(find<QLineEdit>(window, "password"), Qt::Key_Return);
        ASSERT_TRUE(wait_for([&] { return window.context().signed_in(); }));
    }
    void first_sign_in(const QString& login, const QString& once, const QString& password) {
        sign_in(login, once);
        expect_page("password_page");
        type(window, "old_password", once);
        type(window, "new_password", password);
        type(window, "new_password_again", password);
        click(window, "password_change");
        ASSERT_TRUE(wait_for([&] { return !window.context().session().must_change_password(); }));
    }
    void start_attempt(const char* task, bool assessed) {
        click(window, qPrintable(QStringLiteral("briefing_") + QLatin1String(task)));
        expect_page("briefing_page");
        check(window, assessed ? "mode_assessed" : "mode_practice");
        keep_picture(window, QStringLiteral("06-briefing-") + QLatin1String(task));
        // Measured values of the assets, or that there are none for this version.
        const QString fidelity = shown("fidelity_note");
        EXPECT_TRUE(fidelity.contains(fidelity_cost(task) ? "compared with the level \"fine\""
                                                          : "has not been measured"))
            << plain(fidelity);
        const auto cost = fidelity_cost(task);
        EXPECT_EQ(fidelity.contains("Measured with an earlier version"),
                  cost && !measured_as_now(*cost, task))
            << plain(fidelity);
        EXPECT_TRUE(find<QAbstractButton>(window, "start_attempt")->text().startsWith("Start as "));
        click(window, "start_attempt");
        expect_page("theatre_page");
        services.control.ticks_per_update = 40;
        ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }));
    }
    TheatrePage& theatre() { return *static_cast<TheatrePage*>(window.current_page()); }
    void move_hands() {
        TheatreView* view = theatre().view();
        const QPoint middle = view->rect().center();
        for (int i = 0; i <= 12; ++i) {
            QTest::mouseMove(view, middle + QPoint(6 * i, -4 * i));
            QTest::qWait(20);
        }
        QTest::keyPress(view, Qt::Key_D);
        QTest::qWait(200);
        QTest::keyRelease(view, Qt::Key_D);
        ASSERT_TRUE(wait_for([&] { return theatre().session()->display().moving_seen; }));
    }
    DebriefPage& wait_for_debrief() {
        expect_page("debrief_page");
        auto* debrief = static_cast<DebriefPage*>(window.current_page());
        EXPECT_TRUE(wait_for([&] { return debrief->is_ready(); }));
        return *debrief;
    }
    QString shown(const char* name) { return find<QLabel>(window, name)->text(); }

    FakeServices services;
    MainWindow window;
};

TEST_F(Journey, FromTheFirstStartToTheDirectorsReport) {
    expect_page("first_start_page");
    keep_picture(window, "01-first-start");
    create_programme();
    const QString tara_once = add_person("Tara Trainee", "tara", "trainee");
    const QString ed_once = add_person("Ed Educator", "ed", "educator");
    const QString dora_once = add_person("Dora Director", "dora", "director");
    EXPECT_EQ(find<QTableWidget>(window, "people_table")->rowCount(), 4);
    keep_picture(window, "04-people");
    switch_user();

    // A cohort first: the director makes it and names its educator.
    first_sign_in("dora", dora_once, "dora's password");
    click(window, "rail_assign");
    type(window, "new_cohort_name", "Spring");
    click(window, "add_cohort");
    check_item(*find<QListWidget>(window, "cohort_members"), 0);
    check_item(*find<QListWidget>(window, "cohort_educators"), 0);
    keep_picture(window, "12-assign-cohorts");
    click(window, "save_cohort");
    switch_user();

    // The trainee: one attempt completed with too much force, one abandoned, one with the device gone for a
    // while.
    first_sign_in("tara", tara_once, "tara's password");
    expect_page("home_page");
    keep_picture(window, "05-home");
    start_attempt("A2", true);
    move_hands();
    services.control.press_hard = true;
    ASSERT_TRUE(wait_for([&] { return theatre().session()->display().warning[0]; }));
    QTest::qWait(200);
    services.control.press_hard = false;
    keep_picture(window, "07-theatre");
    QTest::keyClick(theatre().view(), Qt::Key_F1);
    keep_picture(window, "07-theatre-help");
    QTest::keyClick(theatre().view(), Qt::Key_F1);
    QTest::keyClick(theatre().view(), Qt::Key_Escape);
    ASSERT_TRUE(wait_for([&] { return sees(window, "panel_resume"); }));
    EXPECT_EQ(theatre().session()->phase(), AttemptPhase::paused);
    keep_picture(window, "07-theatre-paused");
    click(window, "panel_resume");
    EXPECT_EQ(theatre().session()->phase(), AttemptPhase::running);
    QTest::qWait(300);
    services.control.complete = true;
    DebriefPage& debrief = wait_for_debrief();
    const std::string first_attempt = services.control.last_attempt_id;
    EXPECT_TRUE(shown("verdict").contains("Failed"));
    EXPECT_TRUE(shown("advice").contains(QRegularExpression("\\b9\\.\\d+ N")))
        << shown("advice").toStdString();
    const QString debrief_about = shown("debrief_about");
    EXPECT_TRUE(shown("debrief_notes").contains("not felt"));
    EXPECT_TRUE(shown("debrief_notes").contains("provisional"));
    keep_picture(window, "08-debrief");
    keep_body(window, debrief, "08-debrief-whole");

    // A click on the penalty moves replay and chart to its time.
    auto* events = find<QListWidget>(window, "event_list");
    QListWidgetItem* penalty = nullptr;
    for (int row = 0; row < events->count(); ++row) {
        if (events->item(row)->text().contains("Too much force")) penalty = events->item(row);
    }
    ASSERT_NE(penalty, nullptr);
    events->scrollToItem(penalty);
    QTest::mouseClick(events->viewport(), Qt::LeftButton, {}, events->visualItemRect(penalty).center());
    EXPECT_DOUBLE_EQ(debrief.moment(), penalty->data(Qt::UserRole).toDouble());
    EXPECT_GT(debrief.moment(), 0.0);
    const double before = debrief.moment();
    click(window, "replay_forward");
    EXPECT_NEAR(debrief.moment(), before + 0.02, 1e-9);
    find<QComboBox>(window, "replay_speed")->setCurrentIndex(0);
    click(window, "replay_play");
    EXPECT_TRUE(wait_for([&] { return debrief.moment() > before + 0.03; }));
    click(window, "replay_play");

    click(window, "rail_home");
    wait_until_read(window);
    start_attempt("A2", true);
    move_hands();
    click(window, "theatre_abandon");
    keep_picture(window, "07-theatre-abandon");
    click(window, "panel_abandon");
    wait_for_debrief();
    EXPECT_TRUE(shown("verdict").contains("Failed"));

    click(window, "rail_home");
    wait_until_read(window);
    start_attempt("B1", false);
    services.control.drop_device = true;
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::device_lost; }));
    ASSERT_TRUE(wait_for([&] { return sees(window, "panel_resume"); }));
    keep_picture(window, "07-theatre-device-lost");
    services.control.drop_device = false;
    click(window, "panel_resume");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }));
    services.control.complete = true;
    wait_for_debrief();
    click(window, "rail_progress");
    wait_until_read(window);
    auto* chosen = find<QComboBox>(window, "progress_task");
    EXPECT_EQ(chosen->currentData().toString(), "B1");  // the newest attempt's
    chosen->setCurrentIndex(chosen->findData("A2"));
    emit chosen->activated(chosen->currentIndex());
    wait_until_read(window);
    keep_picture(window, "09-progress");
    EXPECT_EQ(find<QTableWidget>(window, "progress_table")->rowCount(), 2);
    switch_user();

    // The educator comments at a moment and voids the abandoned attempt.
    first_sign_in("ed", ed_once, "eduard's word");
    expect_page("cohort_page");
    click(window, "rail_attempts");
    expect_page("attempts_page");
    auto* attempts = find<QTableWidget>(window, "attempts_table");
    ASSERT_EQ(attempts->rowCount(), 3);
    keep_picture(window, "10-educator-attempts");
    choose_row(*attempts, 2);  // the oldest
    click(window, "open_attempt");
    DebriefPage& review = wait_for_debrief();
    events = find<QListWidget>(window, "event_list");
    events->setCurrentRow(events->count() - 1);
    QTest::keyClick(events, Qt::Key_Return);
    const double moment = review.moment();
    QTest::keyClicks(find<QPlainTextEdit>(window, "comment_text"), "Slow down before you touch.");
    click(window, "comment_send");
    keep_picture(window, "11-educator-comment");
    click(window, "rail_attempts");
    attempts = find<QTableWidget>(window, "attempts_table");
    int abandoned = -1;
    for (int row = 0; row < attempts->rowCount(); ++row) {
        if (attempts->item(row, 5)->text() == "abandoned") abandoned = row;
    }
    ASSERT_GE(abandoned, 0);
    choose_row(*attempts, abandoned);
    click(window, "open_attempt");
    wait_for_debrief();
    choose_tab(window, "debrief_tabs", "Corrections");
    click(window, "void_attempt");
    EXPECT_TRUE(shown("message_text").contains("reason"));
    type(window, "action_reason", "started by mistake");
    click(window, "void_attempt");
    click(window, "void_attempt_sure");
    ASSERT_TRUE(wait_for([&] { return sees(window, "verdict") && shown("verdict") == "Voided"; }));
    EXPECT_TRUE(shown("debrief_notes").contains("started by mistake"));
    switch_user();

    // The trainee reads the comment at its time in the replay.
    sign_in("tara", "tara's password");
    expect_page("home_page");
    keep_picture(window, "13-home-with-comment");
    click(window, "unread_comment");
    DebriefPage& read = wait_for_debrief();
    EXPECT_NEAR(read.moment(), moment, 1e-9);
    EXPECT_EQ(shown("comment_words"), "Slow down before you touch.");
    click(window, "rail_home");
    wait_until_read(window);
    EXPECT_FALSE(sees(window, "unread_comment"));
    switch_user();

    // The director's table, and the same values in every export.
    sign_in("dora", "dora's password");
    expect_page("dashboard_page");
    keep_picture(window, "14-dashboard");
    click(window, "rail_cohort");
    wait_until_read(window);
    expect_page("cohort_page");
    keep_picture(window, "14-cohort-grid");
    find<QTabWidget>(window, "cohort_views")->setCurrentIndex(4);
    auto* table = find<QTableWidget>(window, "cohort_table");
    ASSERT_EQ(table->rowCount(), 1);
    keep_picture(window, "14-cohort");
    std::size_t a2 = 0;
    while (services.tasks().at(a2).id != "A2") ++a2;
    // One line in the table, the words in its tooltip.
    const QString mark = table->item(0, static_cast<int>(a2) + 1)->text();
    const QString cell = table->item(0, static_cast<int>(a2) + 1)->toolTip();
    EXPECT_TRUE(cell.contains("attempted · attempts 1")) << cell.toStdString();
    auto* cohort_page = static_cast<CohortPage*>(window.current_page());
    QTemporaryDir folder;
    for (const char* name : {"cohort.pdf", "cohort.csv", "cohort.xlsx", "cohort.json"}) {
        QSignalSpy done(cohort_page, &CohortPage::exported);
        cohort_page->export_to(folder.filePath(name), report_format_of(name));
        ASSERT_TRUE(wait_for([&] { return done.count() == 1; })) << name;
    }
    const nlohmann::json json = nlohmann::json::parse(read_text(folder.filePath("cohort.json")));
    ASSERT_EQ(json["rows"].size(), services.tasks().size());
    const nlohmann::json& row = json["rows"][a2];
    EXPECT_EQ(row["task"], "A2");
    EXPECT_EQ(row["attempts"], 1);
    EXPECT_EQ(row["state"], "attempted");
    const double best = row["best_points"].get<double>();
    EXPECT_TRUE(cell.contains("best " + figure(best))) << cell.toStdString();
    EXPECT_EQ(mark, QString::fromUtf8("○ %1 · 1").arg(points_figure(best)));
    EXPECT_TRUE(debrief_about.contains(" · " + points_text(best))) << debrief_about.toStdString();
    const std::string csv = read_text(folder.filePath("cohort.csv"));
    EXPECT_NE(csv.find(",attempted,0,1,0,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("," + csv_number(best) + ","), std::string::npos);
    EXPECT_TRUE(QFile::exists(folder.filePath("cohort.csv.dictionary.csv")));
    const std::string pdf = pdf_text(folder.filePath("cohort.pdf"));
    EXPECT_NE(pdf.find("Spring"), std::string::npos);
    EXPECT_NE(pdf.find("best " + figure(best).toStdString()), std::string::npos) << pdf;
    EXPECT_NE(pdf.find("attempts 1"), std::string::npos) << pdf;
    EXPECT_NE(pdf.find("A2-operators@1"), std::string::npos);
    const QByteArray pictures = qgetenv("FULCRUM_PICTURES");
    if (!pictures.isEmpty()) {
        QFile::remove(QString::fromLocal8Bit(pictures) + "/cohort.pdf");
        QFile::copy(folder.filePath("cohort.pdf"), QString::fromLocal8Bit(pictures) + "/cohort.pdf");
    }
    EXPECT_EQ(database::Attempts(*services.store()).read(window.context().session(), first_attempt).state,
              AttemptState::completed);
}

TEST_F(Journey, RefusesAWrongPasswordWithoutDetails) {
    create_programme();
    switch_user();
    type(window, "login", "alma");
    type(window, "password", "not the password");
    click(window, "sign_in");
    ASSERT_TRUE(wait_for([&] { return !shown("sign_in_problem").isEmpty(); }));
    const QString for_known = shown("sign_in_problem");
    EXPECT_FALSE(window.context().signed_in());
    type(window, "login", "nobody");
    type(window, "password", "not the password");
    ASSERT_TRUE(wait_for([&] { return find<QAbstractButton>(window, "sign_in")->isEnabled(); }));
    click(window, "sign_in");
    ASSERT_TRUE(wait_for([&] { return find<QAbstractButton>(window, "sign_in")->isEnabled(); }));
    EXPECT_EQ(shown("sign_in_problem"), for_known);
    keep_picture(window, "20-sign-in-refused");
}

TEST_F(Journey, NeverOffersToCreateAProgrammeTwice) {
    create_programme();
    switch_user();
    window.start();
    expect_page("sign_in_page");
    EXPECT_FALSE(sees(window, "create_programme"));
}

TEST_F(Journey, LooksAroundInTheDemonstration) {
    click(window, "look_around");
    expect_page("sign_in_page");
    ASSERT_TRUE(wait_for([&] { return sees(window, "pick_demo_person"); }));
    keep_picture(window, "21-demo-people");
    for (QAbstractButton* pick : window.findChildren<QAbstractButton*>("pick_demo_person")) {
        if (pick->isVisible() && pick->text().startsWith("Nova")) {
            QTest::mouseClick(pick, Qt::LeftButton);
            break;
        }
    }
    expect_page("home_page");
    click(window, "briefing_A2");
    expect_page("briefing_page");
    EXPECT_FALSE(find<QRadioButton>(window, "mode_assessed")->isEnabled());
    click(window, "start_attempt");
    expect_page("theatre_page");
    EXPECT_FALSE(theatre().session()->assessed());
}

TEST_F(Journey, WritesItsThemeDarkAndLight) {
    create_programme();
    click(window, "theme");
    EXPECT_EQ(current_theme(), Theme::dark);
    keep_picture(window, "22-people-dark");
    click(window, "theme");
    EXPECT_EQ(current_theme(), Theme::light);
}

TEST(Lock, HidesTheContentPausesTheAttemptAndClosesItLater) {
    FakeServices services;
    MainWindow window(services, nullptr, 3000, 6000);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    services.open_store(false);
    const database::People people(*services.store());
    const auto created = people.create_programme("Surgery", "alma", "Alma", "correct horse");
    const auto tara = people.create(created.administrator, "tara", "Tara", {database::Role::trainee});
    const database::Session once = people.sign_in("tara", tara.one_time_password);
    const database::Session session = people.change_password(once, tara.one_time_password, "tara's password");
    window.start();
    window.context().set_session(session);
    emit window.context().attempt_wanted("A2", true, 0, false);
    auto* theatre = static_cast<TheatrePage*>(window.current_page());
    ASSERT_EQ(theatre->objectName(), "theatre_page");
    services.control.ticks_per_update = 10;
    ASSERT_TRUE(wait_for([&] { return theatre->session()->phase() == AttemptPhase::running; }));
    window.context().note_input();  // from here on the hands rest
    ASSERT_TRUE(wait_for([&] { return sees(window, "lock_page"); }));
    EXPECT_FALSE(theatre->isVisible());
    ASSERT_NE(theatre->session(), nullptr);
    EXPECT_EQ(theatre->session()->phase(), AttemptPhase::paused);
    keep_picture(window, "23-locked");
    ASSERT_TRUE(wait_for([&] { return !theatre->is_running(); }));
    database::AttemptFilter filter;
    const auto stored = database::Attempts(*services.store()).list(session, filter);
    ASSERT_EQ(stored.size(), 1U);
    EXPECT_EQ(stored[0].state, AttemptState::interrupted);
    type(window, "unlock_password", "tara's password");
    click(window, "unlock");
    EXPECT_TRUE(wait_for([&] { return !sees(window, "lock_page"); }));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
