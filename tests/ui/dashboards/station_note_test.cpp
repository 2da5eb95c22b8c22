// SPDX-License-Identifier: GPL-3.0-or-later
// A station of some cohorts: pages about cohorts say that it is not the whole programme, in both languages,
// and at the largest text. With FULCRUM_PICTURES=FOLDER pictures are stored there, also of joining.
#include <gtest/gtest.h>

#include <QLineEdit>

#include "database/records/people.h"
#include "database/store/station_key.h"
#include "database/sync/server_link.h"
#include "tests/database/station_keys.h"
#include "tests/ui/screens.h"

namespace fulcrum::ui::window_test {
namespace {

class StationNotes : public Screens {
  protected:
    ~StationNotes() override {
        window.reset();
        apply_text_size(*qApp, 100);
        use_language(Language::english);
    }
    /// As an enrolment leaves it.
    void link_to(const std::vector<std::string>& cohorts) {
        database::ServerLink link;
        link.address = database::ServerAddress::parse("postgresql://station_1@server/fulcrum");
        link.server_id = "server";
        link.password = "secret";
        link.cohorts = cohorts;
        link.finish(services.store()->station_id(), "1");
    }
    std::string cohort(const char* name) {
        return database::People(*services.store()).create_cohort(sessions.at(Role::director), name);
    }
    const QLabel& note() const { return *window->current_page()->findChild<QLabel*>("station_note"); }
    const database::test::KeysOfOneTest keys;
    static constexpr const char* about_cohorts[] = {"rail_cohort", "rail_attempts", "rail_limits",
                                                    "rail_assign", "rail_schedules"};
};

TEST_F(StationNotes, NameTheCohortsToADirectorAndFitInBothLanguagesAndLargeText) {
    link_to({cohort("Year 2"), cohort("Year 1")});
    open({1012, 726});
    sign_in(Role::director);
    for (const auto& [language, percent, theme, words] :
         {std::tuple{Language::english, 100, Theme::light,
                     "This station holds 2 of the programme's cohorts: Year 1, Year 2. "},
          std::tuple{Language::german, 100, Theme::dark,
                     "Diese Station hat 2 der Gruppen des Programms: Year 1, Year 2. "},
          std::tuple{Language::english, 200, Theme::dark, "This station holds 2 of"},
          std::tuple{Language::german, 200, Theme::light, "Diese Station hat 2 der"}}) {
        window->set_theme(theme);
        window->set_language(language);
        window->set_text_size(percent);
        settle();
        for (const char* page : about_cohorts) {
            go_to(page);
            const QLabel& shown = note();
            EXPECT_TRUE(shown.isVisible()) << page;
            EXPECT_TRUE(shown.text().startsWith(QString::fromUtf8(words))) << shown.text().toStdString();
            EXPECT_GE(shown.height(), shown.heightForWidth(shown.width())) << page << ' ' << percent;
            expect_fits(QString::fromLatin1(page));
            keep(QStringLiteral("station-note-") + page);
        }
    }
}

TEST_F(StationNotes, AreForWhomTheyConcernAndOnlyWhereTheyAreTrue) {
    open({1012, 726});
    sign_in(Role::director);
    go_to("rail_cohort");
    EXPECT_FALSE(note().isVisible()) << "not enrolled";
    link_to({});
    go_to("rail_attempts");
    EXPECT_FALSE(note().isVisible()) << "has everybody";
    link_to({cohort("Year 1"), "one-that-has-not-come"});
    go_to("rail_cohort");
    EXPECT_TRUE(note().isVisible());
    sign_in(Role::educator);
    go_to("rail_cohort");
    EXPECT_TRUE(note().text().startsWith("This station holds only some")) << note().text().toStdString();
    EXPECT_FALSE(note().text().contains("Year 1")) << "not one of this educator's";
    sign_in(Role::trainee);
    go_to("rail_attempts");
    EXPECT_FALSE(note().isVisible());
}

TEST_F(StationNotes, AreShortWhereThereAreManyCohorts) {
    std::vector<std::string> many;
    for (int i = 1; i <= 9; ++i) many.push_back(cohort(("Year " + std::to_string(i)).c_str()));
    link_to(many);
    open({1012, 726});
    sign_in(Role::director);
    go_to("rail_cohort");
    EXPECT_TRUE(note().text().contains("holds 9 of")) << note().text().toStdString();
    EXPECT_TRUE(note().text().contains("Year 5, ….")) << note().text().toStdString();
    EXPECT_FALSE(note().text().contains("Year 6"));
}

TEST_F(StationNotes, JoiningAProgrammeFitsInBothThemesAndAtTheLargestText) {
    FakeServices empty;
    for (const auto& [theme, percent] :
         {std::pair{Theme::light, 100}, std::pair{Theme::dark, 100}, std::pair{Theme::dark, 200}}) {
        window = std::make_unique<MainWindow>(empty);
        size_ = QSize(1012, 726);
        window->resize(size_);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        window->set_theme(theme);
        window->set_text_size(percent);
        settle();
        keep("first-start");
        click(*window, "join_programme");
        settle();
        keep("join-empty");
        find<QLineEdit>(*window, "join_address")->setText("not an address");
        find<QLineEdit>(*window, "join_token")->setText("AAAAA-BBBBB");
        click(*window, "join_confirm");
        settle();
        EXPECT_FALSE(find<QLabel>(*window, "join_problem")->text().isEmpty());
        expect_fits("join");
        keep("join-refused");
        window.reset();
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
