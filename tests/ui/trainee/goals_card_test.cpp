// SPDX-License-Identifier: GPL-3.0-or-later
// Personal goals with real events: a trainee sets one, sees how far it is, changes and drops it; the educator
// reads it, the director does not. With FULCRUM_PICTURES=FOLDER the pages are stored there.
#include "ui/trainee/goals_card.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QLabel>

#include "database/records/people.h"
#include "database/records/recorder.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/language/language.h"
#include "ui/shell/main_window.h"
#include "ui/style/palette.h"
#include "ui/trainee/goal_words.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Role;

class PersonalGoals : public ::testing::Test {
  protected:
    PersonalGoals() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        const database::People people(*services.store());
        const database::Session alma =
            people.create_programme("Surgery", "alma", "Alma Admin", "correct horse").administrator;
        for (const auto& [role, login, name] : {std::tuple{Role::trainee, "tara", "Tara Trainee"},
                                                std::tuple{Role::educator, "ed", "Ed Educator"},
                                                std::tuple{Role::director, "dora", "Dora Director"}}) {
            const auto made = people.create(alma, login, name, {role});
            const database::Session once = people.sign_in(login, made.one_time_password);
            sessions.emplace(role, people.change_password(once, made.one_time_password, "a long password"));
        }
        const database::Session& dora = sessions.at(Role::director);
        const std::string cohort = people.create_cohort(dora, "Spring");
        people.set_members(dora, cohort, {sessions.at(Role::trainee).person_id()});
        people.set_educators(dora, cohort, {sessions.at(Role::educator).person_id()});
        window.resize(1024, 740);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.start();
        act_as(Role::trainee);
    }
    ~PersonalGoals() override {
        use_language(Language::english);
        apply_theme(*qApp, Theme::light);
    }
    void act_as(Role role) {
        window.context().set_session(sessions.at(role));
        QCoreApplication::processEvents();
    }
    /// A completed attempt at A2 with this path of the left tip, mm; a shorter one of the right.
    void record(double path) {
        database::AttemptMeta meta;
        meta.person_id = sessions.at(Role::trainee).person_id();
        meta.task_id = "A2";
        meta.mode = AttemptMode::assessed;
        meta.device_class = DeviceClass::mouse_keyboard;
        meta.device = "mouse and keyboard";
        meta.variant = meta.fidelity = "standard";
        meta.scene = "a2_targets.json";
        meta.program_version = "test";
        database::Recorder recorder(services.store()->path(), sessions.at(Role::trainee), meta);
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = 30;
        database::ScoreRow score;
        score.passed = true;
        score.points = 70;
        score.metrics.push_back({"path_len", 1, "left", "", path, {}, "mm", Direction::lower, {}});
        score.metrics.push_back({"path_len", 1, "right", "", path / 2, {}, "mm", Direction::lower, {}});
        result.score = score;
        recorder.finish(result);
    }
    void choose_data(const char* combo, const QString& data) {
        auto* box = find<QComboBox>(window, combo);
        const int index = box->findData(data);
        ASSERT_GE(index, 0) << data.toStdString();
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
    void choose_kind(int index) {
        auto* box = find<QComboBox>(window, "goal_kind");
        box->setFocus();
        QTest::keyClick(box, index == 1 ? Qt::Key_Down : Qt::Key_Up);
        EXPECT_EQ(box->currentIndex(), index);
    }
    void enter_target(const QString& number) {
        auto* spin = find<QDoubleSpinBox>(window, "goal_target");
        spin->setFocus();
        spin->selectAll();
        QTest::keyClicks(spin, number);
    }
    QStringList shown(const char* name) {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCoreApplication::processEvents();
        QStringList words;
        for (const QLabel* label : window.findChildren<QLabel*>(QString::fromLatin1(name)))
            if (label->isVisible()) words << label->text().replace(QChar(0x202F), QLatin1Char(' '));
        return words;
    }
    void go_home() { act_as(Role::trainee); }
    void keep(const QString& name) {
        for (const Theme theme : {Theme::dark, Theme::light}) {
            window.set_theme(theme);
            keep_picture(window, name + (theme == Theme::dark ? "-dark" : "-light"));
        }
    }
    FakeServices services;
    MainWindow window{services};
    std::map<Role, database::Session> sessions;
};

TEST_F(PersonalGoals, AttemptsAWeekAreSetSeenChangedAndDropped) {
    EXPECT_FALSE(sees(window, "goal_words"));
    EXPECT_FALSE(sees(window, "goal_save"));
    click(window, "set_goal");
    EXPECT_FALSE(sees(window, "goal_metric"));
    EXPECT_FALSE(sees(window, "goal_due"));
    enter_target("4");
    keep("goal-editor");
    click(window, "goal_save");
    EXPECT_EQ(shown("goal_words"), QStringList("4 attempts a week"));
    ASSERT_EQ(shown("goal_state").size(), 1);
    EXPECT_TRUE(shown("goal_state")[0].startsWith("0 of 4 this week."));
    for (int i = 0; i < 2; ++i) record(1000);
    go_home();
    EXPECT_TRUE(shown("goal_state")[0].startsWith("2 of 4 this week."));
    EXPECT_EQ(find<QWidget>(window, "goal_ring")->accessibleName(), "50 % of the goal");
    click(window, "goal_change");
    EXPECT_EQ(find<QDoubleSpinBox>(window, "goal_target")->value(), 4);
    enter_target("2");
    click(window, "goal_save");
    EXPECT_EQ(shown("goal_words"), QStringList("2 attempts a week"));
    EXPECT_EQ(shown("goal_state"), QStringList("2 of 2 this week. Reached."));
    click(window, "goal_drop");
    EXPECT_TRUE(shown("goal_words").isEmpty());
    EXPECT_TRUE(sees(window, "set_goal"));
}

TEST_F(PersonalGoals, AMetricBelowAValueByADayIsReachedByThatAttempt) {
    record(1000);
    go_home();
    click(window, "set_goal");
    choose_kind(1);
    choose_data("goal_task", "A2");
    choose_data("goal_metric", "path_len");
    EXPECT_EQ(shown("goal_latest"),
              QStringList("Your latest value: 1000 mm. Of both hands the worse one counts."));
    EXPECT_TRUE(find<QDoubleSpinBox>(window, "goal_target")->suffix().contains("mm"));
    auto* due = find<QDateEdit>(window, "goal_due");
    EXPECT_EQ(due->date(), QDate::currentDate().addDays(28));
    enter_target("800");
    keep("goal-editor-metric");
    click(window, "goal_save");
    ASSERT_EQ(shown("goal_words").size(), 1);
    EXPECT_TRUE(shown("goal_words")[0].contains("at most 800 mm by "))
        << shown("goal_words")[0].toStdString();
    EXPECT_EQ(shown("goal_state"), QStringList("No completed attempt since then. 29 days left."));
    QTest::qWait(5);
    record(900);
    go_home();
    EXPECT_EQ(shown("goal_state"), QStringList("Best so far 900 mm, before 1000 mm. 29 days left."));
    EXPECT_EQ(find<QWidget>(window, "goal_ring")->accessibleName(), "50 % of the goal");
    click(window, "set_goal");
    enter_target("5");
    click(window, "goal_save");
    keep("goals");
    record(780);
    go_home();
    EXPECT_TRUE(shown("goal_state").contains("Reached: 780 mm."));
    keep("goals-reached");
    // The educator reads them, with nothing to change; the director sees none.
    act_as(Role::educator);
    emit window.context().progress_wanted(QString::fromStdString(sessions.at(Role::trainee).person_id()),
                                          QStringLiteral("A2"));
    EXPECT_EQ(shown("goal_words").size(), 2);
    for (const char* part : {"set_goal", "goal_change", "goal_drop"})
        EXPECT_FALSE(sees(window, part)) << part;
    keep("goals-educator");
    act_as(Role::director);
    emit window.context().progress_wanted(QString::fromStdString(sessions.at(Role::trainee).person_id()),
                                          QStringLiteral("A2"));
    EXPECT_TRUE(shown("goal_words").isEmpty());
}

TEST_F(PersonalGoals, ThereIsRoomForAFewAndTheEditorCanBeLeft) {
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(sees(window, "set_goal")) << i;
        click(window, "set_goal");
        EXPECT_FALSE(sees(window, "set_goal")) << "while one is being set";
        if (i == 0) {
            click(window, "goal_cancel");
            EXPECT_TRUE(shown("goal_words").isEmpty());
            click(window, "set_goal");
        }
        click(window, "goal_save");
    }
    EXPECT_EQ(shown("goal_words").size(), 5);
    EXPECT_FALSE(sees(window, "set_goal"));
    use_language(Language::german);
    go_home();
    EXPECT_EQ(shown("goal_words")[0], QString::fromUtf8("3 Versuche pro Woche"));
    // Two windows: what one dropped the other can no longer change.
    const database::Goals goals(*services.store());
    const database::Session& tara = sessions.at(Role::trainee);
    for (const database::PersonalGoal& one : goals.of_person(tara, tara.person_id()))
        goals.drop(tara, one.id);
    click(window, "goal_drop");
    EXPECT_TRUE(shown("goal_words").isEmpty()) << "said, and the list is read again";
    EXPECT_TRUE(sees(window, "message_text"));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
