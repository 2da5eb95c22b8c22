// SPDX-License-Identifier: GPL-3.0-or-later
// An external attempt on the screens: named and labelled as external in the list and in its debrief, with its
// metrics, without replay, verdict or score. FULCRUM_PICTURES=FOLDER stores the pages.
#include <QTableWidget>

#include "database/records/external_attempts.h"
#include "tests/ui/screens.h"

namespace fulcrum::ui::window_test {
namespace {

class ExternalAttemptPages : public Screens {
  protected:
    std::string import_for_the_trainee() {
        database::ExternalAttempt box;
        box.person_id = sessions.at(Role::trainee).person_id();
        box.exercise = "peg-transfer";
        box.source = "Box trainer of the skills laboratory";
        box.performed = services.store()->now() - 3'600'000;
        box.duration_s = 81.5;
        box.trace = "t,left.px\ns,m\n0,0.1\n81.5,0.2\n";
        box.program_version = "0.1.0";
        box.score.program_version = "0.1.0";
        box.score.not_scored_because = StatementId::recorded_elsewhere;
        box.score.metrics = {
            {"time", 1, "", "", 80.25, {}, "s", Direction::lower, {}},
            {"path_len", 1, "left", "", 2104.0, {}, "mm", Direction::lower, {}},
            {"f_max", 1, "left", "", {}, {StatementId::no_force, {}}, "N", Direction::lower, {}}};
        return database::ExternalAttempts(*services.store()).add(sessions.at(Role::educator), box);
    }
    QString words_of_page() const {
        QString words;
        for (const QLabel* label : window->current_page()->findChildren<QLabel*>())
            if (label->isVisible()) words += label->text() + QLatin1Char('\n');
        return words;
    }
};

TEST_F(ExternalAttemptPages, ListAndDebriefSayWhatItIs) {
    open({1024, 768});
    const std::string id = import_for_the_trainee();
    for (const Theme theme : {Theme::light, Theme::dark}) {
        window->set_theme(theme);
        for (const Role role : {Role::trainee, Role::educator}) {
            sign_in(role);
            go_to("rail_attempts");
            QString row;
            for (QTableWidget* table : window->current_page()->findChildren<QTableWidget*>())
                for (int column = 0; table->rowCount() == 1 && column < table->columnCount(); ++column)
                    row += table->item(0, column)->text() + QLatin1Char('|');
            EXPECT_TRUE(row.contains("External: peg-transfer")) << row.toStdString();
            EXPECT_TRUE(row.contains("external trace")) << row.toStdString();
            keep("external-list");
            emit window->context().debrief_wanted(text(id), -1);
            wait_for_debrief();
            EXPECT_EQ(error_shown(), "");
            const QString words = words_of_page();
            for (const char* part :
                 {"External: peg-transfer", "external trace", "Not scored", "recorded elsewhere",
                  "Box trainer of the skills laboratory", "does not count in the curriculum"})
                EXPECT_TRUE(words.contains(part)) << part << "\n" << words.toStdString();
            EXPECT_FALSE(words.contains("was not kept"));
            expect_fits("external-debrief");
            keep("external-debrief");
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
