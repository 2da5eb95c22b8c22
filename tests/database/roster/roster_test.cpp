// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of people from other systems: OneRoster folders, simple lists, and what is wrong with them.
#include "database/roster/roster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "database/roster/csv_rows.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"

namespace fulcrum::database {
namespace {

/// A folder with these files.
class RosterFiles {
  public:
    using Files = std::map<std::string, std::string>;
    explicit RosterFiles(const Files& files) {
        for (const auto& [name, text] : files) std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    std::string path(const char* name = "") const {
        return *name == '\0' ? folder_.path().string() : (folder_ / name).string();
    }

  private:
    fulcrum::test::OwnFolder folder_;
};

const std::map<std::string, std::string> school = {
    {"users.csv",
     "\xEF\xBB\xBFsourcedId,status,enabledUser,username,givenName,familyName\r\n"
     "u1,,true,mia,Mia,\"O\"\"Brien, Jr.\"\r\n"
     "u2,active,true,Noah,Noah,Berg\r\n"
     "u3,,true,tea.cher,Tea,Cher\r\n"
     "u4,,false,off,Not,Enabled\r\n"
     "u5,tobedeleted,true,gone,Gone,Away\r\n"
     "u6,,true,parent,Pa,Rent\r\n"
     "u7,,true,alone,Has,Norole\r\n"},
    {"roles.csv",
     "sourcedId,userSourcedId,roleType,role\nr1,u1,primary,student\nr2,u2,primary,student\n"
     "r3,u3,primary,teacher\nr6,u6,primary,parent\nr9,u99,primary,student\n"},
    {"classes.csv", "sourcedId,status,title\nc1,,Year 2\nc2,,\"Course, spring\"\n"},
    {"enrollments.csv",
     "sourcedId,classSourcedId,userSourcedId,role\ne1,c1,u1,student\ne2,c1,u2,student\ne3,c1,u3,teacher\n"
     "e4,c2,u2,student\ne5,c2,u99,student\ne6,c77,u1,student\ne7,c2,u3,proctor\n"}};

std::string refusal(const std::map<std::string, std::string>& files, const char* name = "") {
    const RosterFiles folder(files);
    try {
        read_roster(folder.path(name));
        return {};
    } catch (const InputError& error) {
        EXPECT_FALSE(error.hint().empty());
        std::string text = error.what();
        const std::size_t at = text.find(folder.path());
        if (at != std::string::npos) text.erase(at, folder.path().size());
        return text;
    }
}

TEST(Roster, ReadsAOneRosterFolder) {
    const RosterFiles folder(school);
    const Roster roster = read_roster(folder.path());
    ASSERT_EQ(roster.people.size(), 3U);
    EXPECT_EQ(roster.people[0].login, "mia");
    EXPECT_EQ(roster.people[0].name, "Mia O\"Brien, Jr.");
    EXPECT_EQ(roster.people[0].roles, std::vector<Role>{Role::trainee});
    EXPECT_EQ(roster.people[0].place, "users.csv:2");
    EXPECT_EQ(roster.people[2].roles, std::vector<Role>{Role::educator});
    ASSERT_EQ(roster.cohorts.size(), 2U);
    EXPECT_EQ(roster.cohorts[0].name, "Year 2");
    EXPECT_EQ(roster.cohorts[0].members, (std::vector<std::string>{"mia", "Noah"}));
    EXPECT_EQ(roster.cohorts[0].educators, std::vector<std::string>{"tea.cher"});
    EXPECT_EQ(roster.cohorts[1].name, "Course, spring");
    EXPECT_EQ(roster.cohorts[1].members, std::vector<std::string>{"Noah"});
    // Everything that is not imported is named with its place.
    std::string all;
    for (const Sentence& line : roster.left_out) all += line.words() + "\n";
    for (const char* said :
         {"users.csv:5: off is not enabled", "users.csv:6: status tobedeleted",
          "users.csv:7: parent has the role parent, which is not imported", "users.csv:8: alone has no role",
          "enrollments.csv:6: there is no such user", "enrollments.csv:7: there is no such class",
          "enrollments.csv:8: the role proctor is not imported"})
        EXPECT_NE(all.find(said), std::string::npos) << said << " is not in\n" << all;
    EXPECT_EQ(roster.left_out.size(), 7U) << all;
}

TEST(Roster, TakesNobodyWhoIsNotEnabledHoweverASpreadsheetWroteIt) {
    for (const char* no : {"false", "FALSE", "False", "FALSCH", "0", "no"}) {
        auto saved = school;
        std::string& users = saved["users.csv"];
        users.replace(users.find("u4,,false,off"), 13, std::string("u4,,") + no + ",off");
        saved["roles.csv"] += "r4,u4,primary,student\n";
        const RosterFiles folder(saved);
        const Roster roster = read_roster(folder.path());
        EXPECT_EQ(roster.people.size(), 3U) << no;
        EXPECT_TRUE(std::any_of(roster.left_out.begin(), roster.left_out.end(), [](const Sentence& line) {
            return line.words() == "users.csv:5: off is not enabled";
        })) << no;
    }
    for (const char* yes : {"", "TRUE", "WAHR", "1"}) {
        auto saved = school;
        std::string& users = saved["users.csv"];
        users.replace(users.find("u1,,true"), 8, std::string("u1,,") + yes);
        EXPECT_EQ(read_roster(RosterFiles(saved).path()).people.size(), 3U) << yes;
    }
}

TEST(Roster, ReadsRolesOfOneRoster11FromTheUsers) {
    const RosterFiles folder(RosterFiles::Files{
        {"users.csv",
         "sourcedId,username,givenName,familyName,role\n1,a1,A,One,student\n2,b2,B,Two,teacher\n"}});
    const Roster roster = read_roster(folder.path());
    ASSERT_EQ(roster.people.size(), 2U);
    EXPECT_EQ(roster.people[1].roles, std::vector<Role>{Role::educator});
    EXPECT_TRUE(roster.cohorts.empty());
}

TEST(Roster, ReadsAList) {
    const RosterFiles folder(
        RosterFiles::Files{{"people.csv",
                            "Login,Name,Role,Cohort\nmia,Mia Berg,,Year 2\nMia,Mia Berg,trainee,Year 3\n\n"
                            "tom,Tom Cat,educator,Year 2\nlea,Lea \xC3\x84rztin,,\n"}});
    const Roster roster = read_roster(folder.path("people.csv"));
    ASSERT_EQ(roster.people.size(), 3U) << "one login, whatever the case";
    EXPECT_EQ(roster.people[2].name, "Lea \xC3\x84rztin");
    ASSERT_EQ(roster.cohorts.size(), 2U);
    EXPECT_EQ(roster.cohorts[1].members, std::vector<std::string>{"mia"});
    EXPECT_EQ(roster.cohorts[0].educators, std::vector<std::string>{"tom"});
}

TEST(Roster, NamesWhatIsWrongAndWhere) {
    const auto list = [](const std::string& rows) {
        return refusal({{"l.csv", "login,name,role,cohort\n" + rows}}, "l.csv");
    };
    EXPECT_NE(list("a b,Ab,,\n").find("l.csv:2: the login \"a b\" cannot be used"), std::string::npos);
    EXPECT_NE(list("synthetic-x,X,,\n").find("belong to simulated people"), std::string::npos);
    EXPECT_NE(list("ok,,,\n").find("name: it is empty or too long"), std::string::npos);
    EXPECT_NE(list("ok,Ok,boss,\n").find("'boss' is not a role that can be imported"), std::string::npos);
    EXPECT_NE(list("ok,Ok,,\nOK,Other,,\n").find("l.csv:3: login OK has another name here"),
              std::string::npos);
    EXPECT_NE(list("ok,Ok,\n").find("l.csv:2: has 3 cells where the first row has 4"), std::string::npos);
    EXPECT_NE(list("ok,\"Ok,,\n").find("a quotation mark opens here and is never closed"), std::string::npos);
    EXPECT_NE(list("ok,O\xFFk,,\n").find("is not UTF-8"), std::string::npos);
    EXPECT_NE(list("ok,Evil \xE2\x80\xAEname,,\n").find("control or direction characters"),
              std::string::npos);
    EXPECT_NE(refusal({{"l.csv", "login,login\n"}}, "l.csv").find("column 'login' occurs twice"),
              std::string::npos);
    EXPECT_NE(refusal({{"l.csv", "name\nx\n"}}, "l.csv").find("has no column login"), std::string::npos);
    EXPECT_NE(refusal({{"l.csv", ""}}, "l.csv").find("is empty"), std::string::npos);
    for (const char* separator : {";", "\t"}) {
        const std::string rows = std::string("login") + separator + "name\nmia" + separator + "Berg, Mia\n";
        EXPECT_NE(refusal({{"l.csv", rows}}, "l.csv").find("l.csv:1: its cells are separated by semicolons"),
                  std::string::npos)
            << rows;
    }
    EXPECT_NE(refusal({}, "none.csv").find("cannot be read"), std::string::npos);
    EXPECT_NE(refusal({{"classes.csv", "sourcedId,title\n"}}).find("has no users.csv"), std::string::npos);
    auto twice = school;
    twice["users.csv"] += "u1,,true,other,O,Ther\r\n";
    EXPECT_NE(refusal(twice).find("users.csv:9: sourcedId 'u1' occurs twice"), std::string::npos);
    twice = school;
    twice["users.csv"] += "u8,,true,MIA,Mia,Second\r\n";
    EXPECT_NE(refusal(twice).find("login MIA is also used by users.csv:2"), std::string::npos);
    twice = school;
    twice["classes.csv"] += "c3,,Year 2\n";
    EXPECT_NE(refusal(twice).find("classes.csv:4: the title 'Year 2' is also used by classes.csv:2"),
              std::string::npos)
        << "one educator would see the people of both";
    twice = school;
    twice["classes.csv"] += "c3,tobedeleted,Year 2\n";
    EXPECT_EQ(refusal(twice), "") << "it is not imported";
}

TEST(Roster, CsvKeepsLineEndsInQuotesAndCountsLines) {
    const CsvRows rows = CsvRows::parse("a,b\n\"one\ntwo\", x \n3,4", "t.csv");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows.cell(0, "A"), "one\ntwo");
    EXPECT_EQ(rows.cell(0, "b"), "x");
    EXPECT_EQ(rows.cell(1, "b"), "4");
    EXPECT_EQ(rows.place(1), "t.csv:4");
    EXPECT_EQ(rows.cell(0, "none"), "");
}

}  // namespace
}  // namespace fulcrum::database
