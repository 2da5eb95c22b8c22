// SPDX-License-Identifier: GPL-3.0-or-later
// Every cell of the access table in the window, with the program's own services: what is denied is not shown,
// and is refused if it is requested anyway; what is allowed is shown and works.
#include <QCheckBox>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <algorithm>

#include "database/store/audit.h"
#include "tests/app/services/places.h"
#include "tests/app/services/window_access.h"
#include "ui/dashboards/cohort_page.h"
#include "ui/review/debrief_page.h"
#include "ui/style/text.h"
#include "ui/theatre/theatre_page.h"
#include "ui/trainee/progress_page.h"

namespace fulcrum::app::program_test {

void WindowAccess::expect_debrief(const Target& target, const std::string& cell) {
    if (sees(*window, "close_message")) click(*window, "close_message");
    emit window->context().debrief_wanted(QString::fromStdString(target.attempt), -1);
    auto* debrief = static_cast<DebriefPage*>(window->current_page());
    if (!allowed(Operation::read_attempt, target)) {
        EXPECT_TRUE(refused()) << cell;
        QTest::qWait(20);
        EXPECT_FALSE(debrief->has_charts()) << cell;
        EXPECT_FALSE(sees(*window, "verdict")) << cell;
        return;
    }
    ASSERT_TRUE(wait_for([&] { return debrief->has_charts(); })) << cell;
    ASSERT_TRUE(wait_for([&] { return debrief->is_ready(); })) << cell;
    EXPECT_TRUE(allowed(Operation::read_trace, target)) << cell;
    EXPECT_EQ(debrief->model()->trace->tick_count(), 1000U) << cell;
    EXPECT_EQ(sees(*window, "comment_words"),
              allowed(Operation::read_comment, target) && !target.comment.empty())
        << cell;
    EXPECT_EQ(sees(*window, "comment_text"), allowed(Operation::comment, target)) << cell;
    EXPECT_EQ(sees(*window, "review_error_reason"), allowed(Operation::review_error, target)) << cell;
    const bool rated = target.attempt == programme.ann.attempt;
    EXPECT_EQ(sees(*window, "rating_shown"), rated && allowed(Operation::read_ratings, target)) << cell;
    EXPECT_EQ(sees(*window, "rating_begin"), allowed(Operation::rate, target)) << cell;
    EXPECT_EQ(sees(*window, "ratings_release"), rated && allowed(Operation::release_ratings, target)) << cell;
    choose_tab(*window, "debrief_tabs", "Corrections");
    EXPECT_EQ(sees(*window, "void_attempt"), allowed(Operation::void_attempt, target)) << cell;
    EXPECT_EQ(sees(*window, "reassign_attempt"), allowed(Operation::reassign_attempt, target)) << cell;
    EXPECT_EQ(sees(*window, "request_correction"), allowed(Operation::request_correction, target)) << cell;
    if (allowed(Operation::comment, target)) {
        const auto before =
            Reviews(*services->store()).comments(window->context().session(), target.attempt).size();
        QTest::keyClicks(find<QPlainTextEdit>(*window, "comment_text"), "And here.");
        click(*window, "comment_send");
        EXPECT_EQ(Reviews(*services->store()).comments(window->context().session(), target.attempt).size(),
                  before + 1)
            << cell;
    }
    if (!target.comment.empty()) {
        for (const Comment& comment :
             Reviews(*services->store()).comments(window->context().session(), target.attempt)) {
            if (comment.id != target.comment) continue;
            EXPECT_EQ(comment.read != 0, allowed(Operation::mark_comment_read, target))
                << cell << ": opening it";
        }
    }
}

TEST_F(WindowAccess, DebriefsOpenAndOfferWhatTheTableSays) {
    // First the roles whose visit does not mark anything as read.
    for (const Role asked : {Role::administrator, Role::director, Role::educator, Role::trainee}) {
        act_as(programme.asker(asked));
        for (const Target* target : {&programme.ann, &programme.eve, &programme.own}) {
            expect_debrief(*target, std::string(role_name(asked)) + " on " + target->login);
        }
    }
    act_as(*programme.teacher);
    expect_debrief(programme.eve, "the teacher as a trainee on eve");
}

TEST_F(WindowAccess, VoidReassignAndRequestWorkWhereTheyAreOffered) {
    act_as(programme.asker(Role::trainee));
    emit window->context().debrief_wanted(QString::fromStdString(programme.ann.attempt), -1);
    choose_tab(*window, "debrief_tabs", "Corrections");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "request_correction"); }));
    type(*window, "action_reason", "mine, but wrong");
    click(*window, "request_correction");
    EXPECT_EQ(Attempts(*services->store()).correction_requests(window->context().session()).size(), 2U);
    act_as(programme.asker(Role::educator));
    emit window->context().debrief_wanted(QString::fromStdString(programme.ann.attempt), -1);
    choose_tab(*window, "debrief_tabs", "Corrections");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "reassign_attempt"); }));
    type(*window, "action_reason", "Ben did it");
    click(*window, "reassign_attempt");
    auto* right = find<QComboBox>(*window, "reassign_person");
    EXPECT_TRUE(offers(right, programme.id("ben")));
    EXPECT_FALSE(offers(right, programme.id("eve"))) << "of another cohort";
    EXPECT_FALSE(offers(right, programme.id("educator"))) << "never one's own";
    right->setCurrentIndex(right->findData(QString::fromStdString(programme.id("ben"))));
    click(*window, "reassign_confirm");
    ASSERT_TRUE(wait_for(
        [&] { return sees(*window, "verdict") && find<QLabel>(*window, "verdict")->text() == "Voided"; }));
    EXPECT_FALSE(sees(*window, "void_attempt")) << "an attempt is voided only once";
}

TEST_F(WindowAccess, ListsShowThePeopleAndCohortsThatTheTableAllows) {
    for (const Role asked : people_roles) {
        act_as(programme.asker(asked));
        const std::string who = role_name(asked);
        EXPECT_EQ(sees(*window, "rail_people"), allowed_at_all(Operation::manage_people)) << who;
        EXPECT_EQ(sees(*window, "rail_audit"), allowed_at_all(Operation::view_audit)) << who;
        EXPECT_EQ(sees(*window, "rail_station"), allowed_at_all(Operation::backup)) << who;
        EXPECT_EQ(sees(*window, "rail_assign"), allowed_at_all(Operation::manage_cohorts)) << who;
        EXPECT_EQ(sees(*window, "rail_cohort"), allowed_at_all(Operation::read_cohort_table)) << who;
        EXPECT_EQ(sees(*window, "rail_attempts"), allowed_at_all(Operation::read_attempt)) << who;
        EXPECT_EQ(sees(*window, "rail_rate"), allowed_at_all(Operation::rate)) << who;
        EXPECT_EQ(sees(*window, "rail_progress"), allowed_at_all(Operation::read_progress)) << who;
        EXPECT_EQ(sees(*window, "rail_home"), allowed_at_all(Operation::perform_attempt)) << who;
        EXPECT_EQ(sees(*window, "rail_password"), allowed_at_all(Operation::change_password)) << who;
        if (sees(*window, "rail_attempts")) {
            click(*window, "rail_attempts");
            settle();
            auto* table = find<QTableWidget>(*window, "attempts_table");
            int expected_rows = 0, expected_requests = 0;
            for (const Target* target :
                 {&programme.ann, &programme.eve, &programme.own, &programme.synthetic}) {
                expected_rows += allowed(Operation::read_attempt, *target) ? 1 : 0;
                if (!target->comment.empty())
                    expected_requests += allowed(Operation::read_requests, *target) ? 1 : 0;
            }
            EXPECT_EQ(table->rowCount(), expected_rows) << who;
            int requests = 0;
            for (QWidget* line : window->findChildren<QWidget*>("correction_request"))
                requests += line->isVisible() ? 1 : 0;
            EXPECT_EQ(requests, expected_requests) << who;
            EXPECT_EQ(sees(*window, "filter_person"), asked != Role::trainee) << who;
            if (asked != Role::trainee) {
                auto* people = find<QComboBox>(*window, "filter_person");
                auto* cohorts = find<QComboBox>(*window, "filter_cohort");
                for (const Target* target : {&programme.ann, &programme.eve}) {
                    EXPECT_EQ(offers(people, target->person), allowed(Operation::list_people, *target))
                        << who << target->login;
                    EXPECT_EQ(offers(cohorts, target->cohort_id),
                              cohort_allowed(Operation::list_cohorts, *target))
                        << who;
                }
            }
        }
        if (sees(*window, "rail_cohort")) {
            auto* shown = page<CohortPage>("rail_cohort");
            auto* choice = find<QComboBox>(*window, "cohort_choice");
            for (const Target* target : {&programme.ann, &programme.eve}) {
                const std::string cell = who + " on " + target->cohort;
                const bool readable = cohort_allowed(Operation::read_cohort_table, *target);
                ASSERT_EQ(offers(choice, target->cohort_id), readable) << cell;
                if (!readable) continue;
                choice->setCurrentIndex(choice->findData(QString::fromStdString(target->cohort_id)));
                emit choice->activated(choice->currentIndex());
                wait_until_read(*window);
                find<QTabWidget>(*window, "cohort_views")->setCurrentIndex(4);
                EXPECT_GT(find<QTableWidget>(*window, "cohort_table")->rowCount(), 0) << cell;
                const bool exports = cohort_allowed(Operation::export_cohort, *target);
                EXPECT_EQ(sees(*window, "export_cohort"), exports) << cell;
                const QString path = programme.folder.filePath("cohort.json");
                shown->export_to(path, ReportFormat::json);
                ASSERT_TRUE(wait_for([&] { return exports ? QFile::exists(path) : refused(); })) << cell;
                EXPECT_EQ(QFile::remove(path), exports) << cell;
                ASSERT_TRUE(wait_for([&] { return !sees(*window, "cancel_job"); }));
                if (sees(*window, "close_message")) click(*window, "close_message");
            }
        }
    }
}

void WindowAccess::expect_progress(const Target& target, const std::string& cell, const QString& folder) {
    if (sees(*window, "close_message")) click(*window, "close_message");
    emit window->context().progress_wanted(QString::fromStdString(target.person), "A2");
    wait_until_read(*window);
    auto* shown = static_cast<ProgressPage*>(window->current_page());
    const bool readable = allowed(Operation::read_progress, target);
    auto* person = shown->findChild<QComboBox*>("progress_person");
    EXPECT_EQ(offers(person, target.person), readable) << cell;
    EXPECT_EQ(person->currentData().toString().toStdString() == target.person, readable) << cell;
    if (!readable) return;
    EXPECT_EQ(find<QTableWidget>(*window, "progress_table")->rowCount(), 1) << cell;
    // Trainees have theirs on the home page.
    EXPECT_EQ(sees(*window, "goal_words"), role() != Role::trainee && allowed(Operation::read_goals, target))
        << cell;
    const bool exports = allowed(Operation::export_person, target);
    EXPECT_EQ(sees(*window, "export_person"), exports) << cell;
    const QString path = folder + "/person.json";
    shown->export_to(path, ReportFormat::json);
    ASSERT_TRUE(wait_for([&] { return exports ? QFile::exists(path) : refused(); })) << cell;
    EXPECT_EQ(QFile::remove(path), exports) << cell;
    ASSERT_TRUE(wait_for([&] { return !sees(*window, "cancel_job"); }));
}

TEST_F(WindowAccess, ProgressAndItsReportAreOfferedAsTheTableSays) {
    for (const Role asked : people_roles) {
        act_as(programme.asker(asked));
        for (const Target* target : {&programme.ann, &programme.eve}) {
            expect_progress(*target, std::string(role_name(asked)) + " on " + target->login,
                            programme.folder.path());
        }
    }
}

TEST_F(WindowAccess, WhereARoleIsRefusedTheTopBarKeepsTheOneInUse) {
    act_as(programme.asker(Role::educator));
    auto* roles = find<QComboBox>(*window, "acting_role");
    const int trainee = roles->findData(static_cast<int>(Role::trainee));
    ASSERT_GE(trainee, 0);
    People(*services->store())
        .set_roles(programme.asker(Role::administrator), programme.id("educator"), {Role::educator});
    roles->setCurrentIndex(trainee);
    emit roles->activated(trainee);
    click(*window, "question_yes");
    EXPECT_TRUE(refused()) << complaint().toStdString();
    EXPECT_EQ(role(), Role::educator);
    EXPECT_EQ(roles->currentData().toInt(), static_cast<int>(Role::educator));
}

TEST_F(WindowAccess, AdministratorsManageAccountsAndDirectorsManageCohorts) {
    act_as(programme.asker(Role::administrator));
    click(*window, "rail_people");
    auto* people = find<QTableWidget>(*window, "people_table");
    ASSERT_EQ(people->rowCount(), 8) << "everyone, including the synthetic person";
    int row = -1;
    for (int i = 0; i < people->rowCount(); ++i) {
        if (people->item(i, 1)->text() == "eve") row = i;
    }
    ASSERT_GE(row, 0);
    people->selectRow(row);
    type(*window, "person_name", "Eve Renamed");
    type(*window, "person_login", "eve.b");
    find<QCheckBox>(*window, "role_educator")->setChecked(true);
    click(*window, "save_person");
    const auto eve =
        People(*services->store()).find(programme.asker(Role::administrator), programme.id("eve"));
    ASSERT_TRUE(eve);
    EXPECT_EQ(eve->display_name, "Eve Renamed");
    EXPECT_EQ(eve->login, "eve.b");
    EXPECT_EQ(eve->roles, (std::vector<Role>{Role::trainee, Role::educator}));
    click(*window, "issue_password");
    EXPECT_FALSE(find<QLabel>(*window, "one_time_password")->property("password").toString().isEmpty());
    click(*window, "sign_in_picker");
    EXPECT_FALSE(People(*services->store()).sign_in_picker());

    act_as(programme.asker(Role::director));
    click(*window, "rail_assign");
    type(*window, "cohort_name", "Elsewhere, renamed");
    click(*window, "save_cohort");
    EXPECT_TRUE(
        People(*services->store()).find_cohort(programme.asker(Role::director), "Elsewhere, renamed"));
}

TEST_F(WindowAccess, CohortIsSavedWithWhatAnExchangeBroughtSinceThePageWasOpened) {
    const Session& director = programme.session("director");
    const People people(*services->store());
    const std::string& cohort = programme.eve.cohort_id;
    const auto saved = [&] {
        click(*window, "save_cohort");
        Cohort now = people.find_cohort(director, cohort).value();
        std::sort(now.members.begin(), now.members.end());
        std::sort(now.educators.begin(), now.educators.end());
        return now;
    };
    const auto ids = [&](std::vector<std::string> logins) {
        for (std::string& one : logins) one = programme.id(one);
        std::sort(logins.begin(), logins.end());
        return logins;
    };
    const auto tick = [&](const char* list, const std::string& login, Qt::CheckState state) {
        auto* all = find<QListWidget>(*window, list);
        for (int row = 0; row < all->count(); ++row)
            if (plain(all->item(row)->data(Qt::UserRole).toString()) == programme.id(login))
                all->item(row)->setCheckState(state);
    };
    act_as(director);
    click(*window, "rail_assign");
    ASSERT_EQ(find<QLineEdit>(*window, "cohort_name")->text(), "Elsewhere");
    people.set_members(director, cohort, ids({"eve", "ben"}));
    tick("cohort_educators", "educator", Qt::Checked);
    Cohort now = saved();
    EXPECT_EQ(now.members, ids({"eve", "ben"})) << "Ben came while the page was open";
    EXPECT_EQ(now.educators, ids({"educator", "other_educator"}));
    people.set_members(director, cohort, ids({"eve", "ben", "ann"}));
    tick("cohort_members", "eve", Qt::Unchecked);
    now = saved();
    EXPECT_EQ(now.members, ids({"ben", "ann"}));
    EXPECT_EQ(now.educators, ids({"educator", "other_educator"}));
    const auto rows = Audit(*services->store()).count();
    EXPECT_EQ(saved().members, ids({"ben", "ann"}));
    EXPECT_EQ(Audit(*services->store()).count(), rows) << "nothing was changed";
}

TEST_F(WindowAccess, RoleThatWasWithdrawnSinceThePageWasOpenedStaysWithdrawn) {
    const Session& administrator = programme.session("administrator");
    const People people(*services->store());
    act_as(administrator);
    click(*window, "rail_people");
    auto* table = find<QTableWidget>(*window, "people_table");
    for (int row = 0; row < table->rowCount(); ++row)
        if (table->item(row, 1)->text() == "educator") table->selectRow(row);
    EXPECT_TRUE(find<QCheckBox>(*window, "role_trainee")->isChecked());
    people.set_roles(administrator, programme.id("educator"), {Role::educator});
    find<QCheckBox>(*window, "role_director")->setChecked(true);
    click(*window, "save_person");
    EXPECT_EQ(people.find(administrator, programme.id("educator")).value().roles,
              (std::vector<Role>{Role::educator, Role::director}));
    EXPECT_FALSE(find<QCheckBox>(*window, "role_trainee")->isChecked()) << "the page shows what is stored";
}

/// The names of all widgets visible on the pages of a role, including a debrief if the role may open one.
void WindowAccess::look_everywhere(std::set<std::string>& seen) {
    const auto look = [&] {
        wait_until_read(*window);
        for (QWidget* widget : window->findChildren<QWidget*>()) {
            if (widget->isVisible() && !widget->objectName().isEmpty())
                seen.insert(widget->objectName().toStdString());
        }
    };
    look();
    for (const char* rail :
         {"rail_home", "rail_people", "rail_station", "rail_audit", "rail_assign", "rail_cohort",
          "rail_attempts", "rail_rate", "rail_progress", "rail_tissues", "rail_benchmark", "rail_data"}) {
        if (!sees(*window, rail)) continue;
        click(*window, rail);
        if (auto* people = window->current_page()->findChild<QTableWidget*>("people_table"))
            people->selectRow(0);
        if (auto* cohorts = window->current_page()->findChild<QListWidget*>("cohort_list"))
            cohorts->setCurrentRow(0);
        if (auto* person = window->current_page()->findChild<QComboBox*>("data_person")) {
            person->setCurrentIndex(1);
            EXPECT_TRUE(wait_for([&] { return sees(*window, "data_rows"); }, 60000));
        }
        if (std::string(rail) == "rail_attempts" && allowed_at_all(Operation::recompute_score)) {
            EXPECT_TRUE(wait_for([&] { return sees(*window, "recompute_scores"); }, 60000));
        }
        if (std::string(rail) == "rail_home" && allowed_at_all(Operation::score_interrupted)) {
            EXPECT_TRUE(wait_for([&] { return sees(*window, "interrupted_attempt"); }, 60000));
        }
        look();
    }
    emit window->context().debrief_wanted(QString::fromStdString(programme.ann.attempt), -1);
    auto* debrief = static_cast<DebriefPage*>(window->current_page());
    if (allowed(Operation::read_attempt, programme.ann)) {
        EXPECT_TRUE(wait_for([&] { return debrief->is_ready(); }, 60000));
    }
    look();
    if (sees(*window, "debrief_tabs")) {
        choose_tab(*window, "debrief_tabs", "Corrections");
        look();
    }
    window->context().sign_out();
    look();
}

TEST_F(WindowAccess, EveryCellOfEveryOperationIsOfferedOrNotAsTheTableSays) {
    // The trainee first: an interrupted attempt is shown to the person at whose sign-in it is scored.
    People(*services->store()).sign_in("ann", database::test::password);
    record_interrupted();
    int offered = 0, withheld = 0;
    for (const Role role :
         {Role::trainee, Role::educator, Role::director, Role::administrator, Role::station}) {
        std::set<std::string> seen;
        if (role == Role::station) {
            window->start();
            settle();
            for (QWidget* widget : window->findChildren<QWidget*>()) {
                if (widget->isVisible()) seen.insert(widget->objectName().toStdString());
            }
        } else {
            act_as(programme.asker(role));
            look_everywhere(seen);
        }
        for (int i = 0; i < operation_count; ++i) {
            const auto operation = static_cast<Operation>(i);
            const std::vector<const char*> places = window_places(operation);
            if (places.empty()) continue;
            const bool shown = std::any_of(places.begin(), places.end(),
                                           [&](const char* name) { return seen.count(name) > 0; });
            const std::string cell = std::string(operation_name(operation)) + " as " + role_name(role);
            if (expected_scope(operation, role) == Scope::none) {
                EXPECT_FALSE(shown) << cell;
                ++withheld;
            } else if (window_leaves_out(operation, role) != nullptr) {
                EXPECT_FALSE(shown) << cell << ": remove it from window_leaves_out()";
            } else {
                EXPECT_TRUE(shown) << cell;
                ++offered;
            }
        }
    }
    EXPECT_GE(offered, 40);
    EXPECT_GE(withheld, 60);
}

TEST(AccessPlaces, EveryOperationIsInTheWindowOrOnTheCommandLine) {
    for (int i = 0; i < operation_count; ++i) {
        const auto operation = static_cast<Operation>(i);
        EXPECT_FALSE(window_places(operation).empty() && commands_of(operation).empty())
            << operation_name(operation);
    }
}

TEST_F(WindowAccess, EducatorsRecomputeTheScoresOfTheirCohorts) {
    const Attempts attempts(*services->store());
    const Session& director = programme.asker(Role::director);
    const std::string evaluated = programme.ann.attempt;
    act_as(programme.asker(Role::educator));
    click(*window, "rail_attempts");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "recompute_scores"); }, 60000));
    EXPECT_TRUE(find<QLabel>(*window, "stale_scores")->text().startsWith("2 scores"))
        << "Ann's and their own";
    EXPECT_TRUE(find<QLabel>(*window, "stale_names")->text().contains("Ann Trainee: A2"))
        << find<QLabel>(*window, "stale_names")->text().toStdString();
    keep_picture(*window, "recompute");
    click(*window, "recompute_scores");
    ASSERT_TRUE(wait_for([&] { return attempts.scores(director, evaluated).size() == 2; }, 60000));
    ASSERT_TRUE(wait_for([&] { return !sees(*window, "recompute_scores"); }, 60000));
    EXPECT_EQ(attempts.scores(director, programme.own.attempt).size(), 2U);
    EXPECT_EQ(attempts.scores(director, programme.eve.attempt).size(), 1U) << "of another cohort";
    EXPECT_EQ(attempts.scores(director, evaluated).front().points, 60) << "the score in force is unchanged";
    emit window->context().debrief_wanted(QString::fromStdString(evaluated), -1);
    ASSERT_TRUE(wait_for([&] { return sees(*window, "debrief_notes"); }));
    EXPECT_TRUE(find<QLabel>(*window, "debrief_notes")->text().contains("Recomputed"));
}

}  // namespace fulcrum::app::program_test
