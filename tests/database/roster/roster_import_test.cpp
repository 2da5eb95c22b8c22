// SPDX-License-Identifier: GPL-3.0-or-later
// A roster in the store: accounts by an administrator, cohorts by a director, repeated and cut off.
#include "database/roster/roster_import.h"

#include "tests/database/programme_fixture.h"

namespace fulcrum::database {
namespace {

using test::Programme;
using What = PersonImport::What;

Roster example_roster() {
    Roster roster;
    roster.people = {{"mia", "Mia Berg", {Role::trainee}, "l.csv:2"},
                     {"ANN", "Ann Renamed", {Role::trainee}, "l.csv:3"},
                     {"ben", "Ben Trainee", {Role::educator}, "l.csv:4"},
                     {"tea", "Tea Cher", {Role::educator}, "l.csv:5"}};
    roster.cohorts = {{"Year 1", {"mia", "ann"}, {"tea"}, "l.csv:2"},
                      {"Year 2", {"mia", "nobody"}, {"tea", "ann"}, "l.csv:3"}};
    return roster;
}

const auto go_on = [](std::size_t, std::size_t) { return true; };

std::vector<PersonImport> bring(const RosterImport& roster_import, const Roster& roster,
                                const std::function<bool(std::size_t, std::size_t)>& progress = go_on) {
    std::vector<PersonImport> steps = roster_import.plan_people(roster);
    roster_import.bring_people(steps, progress);
    return steps;
}

std::vector<What> what_of(const std::vector<PersonImport>& steps) {
    std::vector<What> what;
    for (const PersonImport& step : steps) what.push_back(step.what);
    return what;
}

TEST(RosterImport, MakesAccountsOnceAndChangesNobodysName) {
    const Programme programme;
    const Session& administrator = programme.session("administrator");
    const RosterImport roster_import(*programme.store, administrator);
    const auto rows = Audit(*programme.store).count();
    const std::vector<What> expected = {What::create, What::nothing, What::add_role, What::create};
    EXPECT_EQ(what_of(roster_import.plan_people(example_roster())), expected);
    EXPECT_EQ(Audit(*programme.store).count(), rows) << "a plan changes nothing";

    const std::vector<PersonImport> done = bring(roster_import, example_roster());
    EXPECT_EQ(what_of(done), expected);
    const People people = programme.people();
    const Session mia = people.sign_in("mia", done[0].one_time_password);
    EXPECT_TRUE(mia.must_change_password());
    EXPECT_EQ(mia.role(), Role::trainee);
    EXPECT_EQ(people.find_login(administrator, "ann")->display_name, "Ann Trainee");
    EXPECT_TRUE(done[1].one_time_password.empty()) << "a password that is in use stays";
    EXPECT_EQ(people.find_login(administrator, "ben")->roles,
              (std::vector<Role>{Role::trainee, Role::educator}));

    const std::vector<PersonImport> again = bring(roster_import, example_roster());
    EXPECT_EQ(what_of(again), std::vector<What>(4, What::nothing));
    EXPECT_TRUE(programme.store->check(administrator).ok);
}

TEST(RosterImport, CutOffInTheMiddleItIsBegunAgain) {
    const Programme programme;
    const RosterImport roster_import(*programme.store, programme.session("administrator"));
    bring(roster_import, example_roster(), [](std::size_t done, std::size_t) { return done < 1; });
    EXPECT_EQ(what_of(roster_import.plan_people(example_roster())),
              (std::vector<What>{What::nothing, What::nothing, What::add_role, What::create}));
    bring(roster_import, example_roster());
    EXPECT_EQ(what_of(roster_import.plan_people(example_roster())), std::vector<What>(4, What::nothing));
}

TEST(RosterImport, ADeactivatedPersonStaysSo) {
    const Programme programme;
    const Session& administrator = programme.session("administrator");
    programme.people().set_active(administrator, programme.id("ann"), false);
    const RosterImport roster_import(*programme.store, administrator);
    const std::vector<PersonImport> done = bring(roster_import, example_roster());
    EXPECT_EQ(done[1].what, What::refused);
    EXPECT_EQ(done[1].why, "is deactivated here");
    EXPECT_FALSE(programme.people().find_login(administrator, "ann")->active);
}

TEST(RosterImport, CohortsGainPeopleAndLoseNone) {
    const Programme programme;
    const Session& director = programme.session("director");
    bring(RosterImport(*programme.store, programme.session("administrator")), example_roster());
    const RosterImport roster_import(*programme.store, director);
    const std::vector<CohortImport> plan = roster_import.plan_cohorts(example_roster());
    ASSERT_EQ(plan.size(), 2U);
    EXPECT_FALSE(plan[0].create);
    EXPECT_EQ(plan[0].members, std::vector<std::string>{"mia"}) << "Ann is in it";
    EXPECT_TRUE(plan[1].create);
    EXPECT_EQ(plan[1].missing, (std::vector<std::string>{"nobody", "ann"})) << "Ann is no educator";
    EXPECT_EQ(programme.people().cohorts(director).size(), 1U) << "a plan changes nothing";

    roster_import.bring_cohorts(example_roster());
    const Cohort year1 = programme.people().find_cohort(director, "Year 1").value(),
                 year2 = programme.people().find_cohort(director, "Year 2").value();
    EXPECT_EQ(year1.members.size(), 3U) << "Ben stays";
    EXPECT_EQ(year1.educators.size(), 2U);
    EXPECT_EQ(year2.members.size(), 1U);
    EXPECT_EQ(year2.educators.size(), 1U);
    for (const CohortImport& step : roster_import.plan_cohorts(example_roster())) {
        EXPECT_FALSE(step.create);
        EXPECT_TRUE(step.members.empty());
        EXPECT_TRUE(step.educators.empty());
    }
}

TEST(RosterImport, OthersMayNot) {
    const Programme programme;
    const Roster roster = example_roster();
    for (const char* login : {"ann", "educator", "director", "station"}) {
        EXPECT_THROW(bring(RosterImport(*programme.store, programme.session(login)), roster), AccessDenied)
            << login;
    }
    for (const char* login : {"ann", "educator", "administrator", "station"}) {
        EXPECT_THROW(RosterImport(*programme.store, programme.session(login)).bring_cohorts(roster),
                     AccessDenied)
            << login;
    }
    EXPECT_EQ(programme.people().list(programme.session("administrator")).size(), 7U);
}

}  // namespace
}  // namespace fulcrum::database
