// SPDX-License-Identifier: GPL-3.0-or-later
// Pages about many people: the window answers while they read, and shows what was chosen last, where it was.
#include <QComboBox>
#include <QTableView>

#include "database/records/people.h"
#include "tests/ui/held_work.h"
#include "tests/ui/screens.h"
#include "ui/language/language.h"
#include "ui/shell/idle_watch.h"

namespace fulcrum::ui::window_test {
namespace {

class ReadingCohorts : public Screens {
  protected:
    ~ReadingCohorts() override { use_language(Language::english); }
    void open_as(Role role) {
        open(QSize(1280, 800));
        sign_in(role);
    }
    QString label(const char* name) { return find<QLabel>(*window, name)->text(); }
    /// Also where it is not visible.
    int people_in_grid() { return window->findChild<QTableView*>("cohort_grid")->model()->rowCount(); }
    void choose_cohort(const char* name) {
        auto* choice = find<QComboBox>(*window, "cohort_choice");
        choice->setCurrentIndex(choice->findText(name));
        emit choice->activated(choice->currentIndex());
    }
    database::People people() { return database::People(*services.store()); }  // the window opens another
};

TEST_F(ReadingCohorts, TheCohortThatWasChosenLastIsShown) {
    people().create_cohort(sessions.at(Role::director), "Autumn");
    open_as(Role::director);
    {
        HeldWork held;
        go_to_now("rail_cohort");
        choose_cohort("Autumn");
        EXPECT_EQ(label("cohort_summary"), "Reading the cohort …");
        choose_cohort("Spring");
        EXPECT_EQ(people_in_grid(), 0);
        EXPECT_TRUE(sees(*window, "export_cohort")) << "a report reads by itself";
        held.release();
        settle();
    }
    EXPECT_EQ(people_in_grid(), 1);
    EXPECT_TRUE(label("cohort_summary").startsWith("1 pe")) << label("cohort_summary").toStdString();
    HeldWork held;
    choose_cohort("Autumn");
    EXPECT_EQ(people_in_grid(), 0) << "nobody of the cohort before";
    held.release();
    settle();
    EXPECT_EQ(people_in_grid(), 0);
    EXPECT_NE(label("cohort_summary"), "Reading the cohort …");
}

TEST_F(ReadingCohorts, WhatIsShownStaysWithItsCurrentCellUntilItIsReadAgain) {
    open_as(Role::director);
    go_to("rail_cohort");
    auto* grid = find<QTableView>(*window, "cohort_grid");
    grid->setCurrentIndex(grid->model()->index(0, 2));
    go_to("rail_attempts");
    HeldWork held;
    go_to_now("rail_cohort");
    EXPECT_EQ(people_in_grid(), 1);
    EXPECT_EQ(label("cohort_summary"), "Reading the cohort …");
    grid->setFocus();
    held.release();
    settle();
    EXPECT_EQ(grid->currentIndex(), grid->model()->index(0, 2));
    EXPECT_EQ(window->focusWidget(), grid);
}

TEST_F(ReadingCohorts, EndsWithThePageAndTheSession) {
    open_as(Role::director);
    for (const char* page : {"rail_cohort", "rail_dashboard", "rail_rate", "rail_limits"}) {
        HeldWork held;
        go_to_now(page);
        go_to_now("rail_settings");
        EXPECT_TRUE(sees(*window, "settings_page")) << page;
        go_to_now(page);
        window->set_theme(Theme::dark);
        window->set_theme(Theme::light);
        window->context().sign_out();
        held.release();
        settle();
        EXPECT_TRUE(error_shown().isEmpty()) << page << error_shown().toStdString();
        sign_in(Role::director);
    }
    HeldWork held;
    go_to_now("rail_cohort");
    window->set_language(Language::german);
    held.release();
    settle();
    go_to("rail_cohort");
    EXPECT_EQ(people_in_grid(), 1) << "of the pages that were made again";
    window->set_language(Language::english);
}

TEST_F(ReadingCohorts, IsCompletedBehindTheLockWithoutTakingTheKeyboard) {
    open_as(Role::director);
    HeldWork held;
    go_to_now("rail_cohort");
    QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock");
    ASSERT_TRUE(sees(*window, "unlock_password"));
    QWidget* const used = window->focusWidget();
    held.release();
    settle();
    EXPECT_EQ(people_in_grid(), 1);
    EXPECT_EQ(window->focusWidget(), used);
    EXPECT_TRUE(sees(*window, "unlock_password"));
}

TEST_F(ReadingCohorts, APageSaysWhyItCouldNotBeRead) {
    open_as(Role::educator);
    go_to("rail_cohort");
    HeldWork held;
    go_to_now("rail_cohort");
    const database::Session& dora = sessions.at(Role::director);
    people().set_educators(dora, people().cohorts(dora).front().id, {});
    held.release();
    settle();
    EXPECT_TRUE(error_shown().startsWith("You may not")) << error_shown().toStdString();
    EXPECT_EQ(label("cohort_summary"), error_shown());
    EXPECT_EQ(people_in_grid(), 0) << "no longer theirs";
}

TEST_F(ReadingCohorts, ThePicturesOfACohortAppearWhenTheyAreRead) {
    open_as(Role::director);
    go_to("rail_settings");
    window->context().sign_out();
    settle();
    HeldWork held;
    window->context().set_session(sessions.at(Role::director));
    QCoreApplication::processEvents();
    ASSERT_EQ(window->current_page()->objectName(), "dashboard_page");
    EXPECT_EQ(label("dashboard_summary"), "Reading the cohort …");
    EXPECT_FALSE(sees(*window, "dashboard_plan_chart"));
    held.release();
    settle();
    EXPECT_TRUE(sees(*window, "dashboard_plan_chart"));
    EXPECT_TRUE(label("dashboard_summary").startsWith("1 pe")) << label("dashboard_summary").toStdString();
}

TEST_F(ReadingCohorts, AttemptsToRateAndUnderLimitsAreReadInTheBackground) {
    open(QSize(1280, 800));
    perform();
    sign_in(Role::educator);
    {
        HeldWork held;
        go_to_now("rail_rate");
        EXPECT_EQ(label("to_rate_count"), "Reading the attempts …");
        EXPECT_EQ(find<QTableWidget>(*window, "to_rate_table")->rowCount(), 0);
        held.release();
        settle();
    }
    EXPECT_EQ(find<QTableWidget>(*window, "to_rate_table")->rowCount(), 1);
    HeldWork held;
    go_to_now("rail_limits");
    EXPECT_EQ(label("limits_count"), "Reading the attempts …");
    EXPECT_EQ(find<QTableWidget>(*window, "limits_table")->rowCount(), 1) << "the set is known";
    EXPECT_EQ(window->findChild<QLabel*>("limits_mark")->text(), QString()) << "not of no attempts";
    held.release();
    settle();
    EXPECT_NE(label("limits_count"), "Reading the attempts …");
}

}  // namespace
}  // namespace fulcrum::ui::window_test
