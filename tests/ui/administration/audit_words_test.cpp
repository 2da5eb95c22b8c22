// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/audit_words.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "assessment/metrics/statement.h"
#include "tests/support/support.h"
#include "ui/language/language.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

/// Every operation that a source of the store's records appends to the audit log.
std::set<std::string> audited_operations() {
    static const std::regex call(R"re(append\([^;]*?"((?:[a-z]+\.[a-z_]+)|sign_in)")re");
    std::set<std::string> names;
    for (const char* folder : {"database/records", "database/store", "database/sync"}) {
        for (const auto& entry : std::filesystem::directory_iterator(fulcrum::test::source_path(folder))) {
            std::stringstream source;
            source << std::ifstream(entry.path()).rdbuf();
            const std::string text = source.str();
            for (std::sregex_iterator found(text.begin(), text.end(), call), end; found != end; ++found)
                names.insert((*found)[1]);
        }
    }
    return names;
}

/// Every name that is put into what is stored with an audited operation.
std::set<std::string> audited_members() {
    static const std::regex member(R"re(\{"([a-z_0-9]+)",)re");
    const std::string call = "json_object({";
    std::set<std::string> names;
    for (const char* folder : {"records", "store", "sync", "schedules", "research"}) {
        const std::string place = fulcrum::test::source_path(std::string("database/") + folder);
        for (const auto& entry : std::filesystem::directory_iterator(place)) {
            std::stringstream source;
            source << std::ifstream(entry.path()).rdbuf();
            const std::string text = source.str();
            for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
                const std::string members = text.substr(at + call.size() - 1, text.find(';', at) - at);
                for (std::sregex_iterator found(members.begin(), members.end(), member), end; found != end;
                     ++found)
                    names.insert((*found)[1]);
            }
        }
    }
    return names;
}

TEST(AuditWords, DetailsAreInTheReadersLanguage) {
    const std::set<std::string> names = audited_members();
    EXPECT_GT(names.size(), 40U);
    for (const std::string& name : names)
        EXPECT_FALSE(audit_member_text(name).contains('_')) << name << " has no words";
    use_language(Language::german);
    const auto details = [](const char* operation, const nlohmann::json& payload) {
        return audit_details_text(operation, payload.dump()).toStdString();
    };
    EXPECT_EQ(details("person.create", {{"login", "tara"}, {"roles", "trainee, educator"}}),
              "Anmeldename: tara; Rollen: " + role_text("trainee").toStdString() + ", " +
                  role_text("educator").toStdString());
    EXPECT_EQ(details("person.set_active", {{"before", "yes"}, {"after", "no"}}),
              "nachher: nein; vorher: ja");
    EXPECT_EQ(details("person.rename", {{"before", "yes"}}), "vorher: yes") << "a name stays a name";
    EXPECT_EQ(details("attempt.begin", {{"mode", "assessed"}, {"task", "A2"}}),
              "Modus: " + mode_text(AttemptMode::assessed).toStdString() + "; Aufgabe: A2");
    EXPECT_EQ(details("setting.sign_in_picker", {{"after", "on"}}), "nachher: ein");
    EXPECT_EQ(audit_details_text("person.rename", "payload erased"), "Inhalt gelöscht");
    EXPECT_EQ(role_text("station"), "Arbeitsplatz") << "what the station does by itself";
    int untranslated = 0;
    for (const std::string& name : names) untranslated += audit_member_text(name) == text(name) ? 1 : 0;
    use_language(Language::english);
    EXPECT_LT(untranslated, 8) << "Format, Token and the like have capitals at least";
    EXPECT_EQ(details("attempt.finish", {{"state", "timed_out"}}), "state: timed out");
}

TEST(AuditWords, EveryAuditedOperationHasWords) {
    const std::set<std::string> names = audited_operations();
    EXPECT_GT(names.size(), 18U);
    for (const std::string& name : names) {
        const QString shown = audit_operation_text(name);
        EXPECT_FALSE(shown.contains('.') || shown.contains('_')) << name;
        const std::size_t point = name.find('.');
        if (point != std::string::npos) {
            EXPECT_TRUE(audit_group_text(name.substr(0, point)).endsWith(": all")) << name;
        }
    }
    EXPECT_EQ(audit_operation_text("attempt.finish"), "Attempt finished");
    EXPECT_EQ(audit_operation_text("later.operation"), "later.operation");
}

TEST(AuditWords, WhyAnAttemptBecamePracticeIsPutIntoWordsAndAnOldRowStaysReadable) {
    const auto shown = [](const Statement& why) {
        const nlohmann::json payload = {{"from", "assessed"}, {"reason", stored_text(why)}};
        return audit_details_text("attempt.practice", payload.dump()).toStdString();
    };
    EXPECT_EQ(shown(StatementId::practice_device_lost),
              "from: assessed; reason: a device was lost and came back");
    EXPECT_EQ(shown({StatementId::practice_stood_still, {{"seconds", 1.5}}}),
              "from: assessed; reason: the program stood still for 1.5 s");
    EXPECT_EQ(shown(Statement::plain("the program stood still for 1.5 s")),
              "from: assessed; reason: the program stood still for 1.5 s");
    const std::string typed = stored_text(StatementId::practice_device_lost);  // by a person, elsewhere
    const nlohmann::json other = {{"reason", typed}};
    EXPECT_EQ(audit_details_text("person.merge", other.dump()).toStdString(), "reason: " + typed);
    EXPECT_EQ(audit_details_text("attempt.practice", "payload erased").toStdString(), "payload erased");
}

}  // namespace
}  // namespace fulcrum::ui
