// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum xapi send and list, as they are called, with a record store of the tests.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/services/program.h"
#include "tests/app/access_programme.h"
#include "tests/database/xapi/fake_record_store.h"
#include "tests/support/support.h"

namespace fulcrum::app::program_test {
namespace {

class XapiCommands : public ::testing::Test {
  protected:
    XapiCommands() {
        programme.store.reset();
        password_file = file("password.txt", std::string(database::test::password) + "\n", 0600);
        credentials = file("lrs.txt", "key:secret\n", 0600);
    }
    std::string file(const char* name, const std::string& content, mode_t mode) const {
        std::string path = programme.folder.filePath(QString::fromLatin1(name)).toStdString();
        std::ofstream(path) << content;
        ::chmod(path.c_str(), mode);
        return path;
    }
    nlohmann::json run(std::vector<std::string> words, int wanted, const char* as = "director") const {
        for (const std::string& word :
             {std::string("--db"), programme.path, std::string("--as"), std::string(as),
              std::string("--password-file"), password_file, std::string("--json")})
            words.push_back(word);
        std::ostringstream output;
        struct Redirected {
            std::streambuf* before;
            ~Redirected() { std::cout.rdbuf(before); }
        };
        {
            const Redirected redirected{std::cout.rdbuf(output.rdbuf())};
            EXPECT_EQ(run_command(words), wanted);
        }
        return nlohmann::json::parse(output.str());
    }
    nlohmann::json send(std::vector<std::string> more, int wanted, const char* as = "director") const {
        std::vector<std::string> words = {"xapi",        "send",          "--to",
                                          lrs.address(), "--credentials", credentials};
        words.insert(words.end(), more.begin(), more.end());
        return run(words, wanted, as);
    }
    AccessProgramme programme;
    database::test::FakeRecordStore lrs;
    std::string password_file, credentials;
};

TEST_F(XapiCommands, SendTheStatementsOfACohortOnceAndListWhatIsLeft) {
    const std::vector<std::string> year = {"--cohort", "Year 1", "--home-page", "https://training.example"};
    const nlohmann::json first = send(year, 0);
    const int queued = first["queued"];
    EXPECT_GE(queued, 3) << "two attempts and a released rating";
    EXPECT_EQ(first["sent"], queued);
    EXPECT_EQ(lrs.statements.size(), static_cast<std::size_t>(queued));
    for (const auto& [id, text] : lrs.statements) {
        EXPECT_EQ(text.find("Ann"), std::string::npos);
        EXPECT_EQ(nlohmann::json::parse(text)["id"], id);
    }
    const nlohmann::json again = send(year, 0);
    EXPECT_EQ(again["queued"], 0);
    EXPECT_EQ(again["sent"], 0);
    EXPECT_EQ(again["done"], queued);
    // Eve's is refused: it is listed with what the record store says.
    lrs.instead = [](const database::test::HttpRequest&) { return 400; };
    lrs.words = "no such verb";
    EXPECT_EQ(send({"--person", "eve", "--home-page", "https://training.example"}, 1)["newly_quarantined"],
              1);
    const nlohmann::json list = run({"xapi", "list"}, 0);
    ASSERT_EQ(list["record_stores"].size(), 1U);
    EXPECT_EQ(list["record_stores"][0]["done"], queued);
    EXPECT_EQ(list["record_stores"][0]["problems"][0]["problem"], "HTTP 400: no such verb");
    lrs.instead = [](const database::test::HttpRequest&) { return 0; };
    EXPECT_EQ(send({}, 1)["sent"], 0) << "quarantined stays so";
    EXPECT_EQ(send({"--again"}, 0)["sent"], 1);
}

TEST_F(XapiCommands, SendWhatACrashCutOffOnceItIsScored) {
    programme.open();
    const std::string broken = programme.record_broken("ann");
    programme.store.reset();
    const auto interrupted = [&] {
        std::vector<nlohmann::json> found;
        for (const auto& [id, text] : lrs.statements) {
            const nlohmann::json one = nlohmann::json::parse(text);
            const nlohmann::json extensions =
                one.value(nlohmann::json::json_pointer("/context/extensions"), nlohmann::json::object());
            if (extensions.value("urn:fulcrum:xapi:state", "") == "interrupted") found.push_back(one);
        }
        return found;
    };
    const std::vector<std::string> year = {"--cohort", "Year 1", "--home-page", "https://training.example"};
    EXPECT_GE(send(year, 0)["queued"], 3);
    EXPECT_TRUE(interrupted().empty()) << "its record may hold that it failed";
    programme.open();
    ASSERT_EQ(programme.attempts().read(programme.session("ann"), broken).state, AttemptState::interrupted);
    programme.attempts().add_score(programme.session("ann"), broken, database::test::example_score(false, 0));
    programme.store.reset();
    EXPECT_EQ(send(year, 0)["queued"], 1);
    ASSERT_EQ(interrupted().size(), 1U);
    EXPECT_EQ(interrupted()[0]["verb"]["id"], "http://adlnet.gov/expapi/verbs/failed");
    EXPECT_EQ(send(year, 0)["queued"], 0);
}

TEST(XapiProfileCommand, WritesTheProfileThatIsDelivered) {
    QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("profile.jsonld")).toStdString();
    ASSERT_EQ(run_command({"xapi", "profile", "-o", path}), 0);
    std::ifstream written(path), delivered(fulcrum::test::source_path("assets/schemas/xapi_profile.jsonld"));
    std::ostringstream one, other;
    one << written.rdbuf();
    other << delivered.rdbuf();
    EXPECT_EQ(one.str(), other.str());
    EXPECT_EQ(nlohmann::json::parse(one.str())["type"], "Profile");
    EXPECT_THROW(run_command({"xapi", "profile", "-o", folder.path().toStdString()}), InputError);
}

TEST_F(XapiCommands, RefuseOthersThanDirectorsAndCredentialsThatOthersCanRead) {
    EXPECT_THROW(send({}, 0, "ann"), database::AccessDenied);
    EXPECT_THROW(send({}, 0, "administrator"), database::AccessDenied);
    EXPECT_THROW(run({"xapi", "list"}, 0, "ann"), database::AccessDenied);
    EXPECT_THROW(send({"--cohort", "Year 1"}, 0), InputError) << "no home page";
    EXPECT_THROW(send({"--cohort", "Year 9", "--home-page", "https://training.example"}, 0), InputError);
    const std::string good = credentials;
    for (const auto& [name, content, mode] :
         {std::tuple{"open.txt", "key:secret\n", 0644}, std::tuple{"group.txt", "key:secret\n", 0640},
          std::tuple{"empty.txt", "", 0600}, std::tuple{"key.txt", "key:\n", 0600},
          std::tuple{"secret.txt", ":secret", 0600}, std::tuple{"words.txt", "secret", 0600}}) {
        credentials = file(name, content, static_cast<mode_t>(mode));
        EXPECT_THROW(send({}, 0), InputError) << name;
    }
    credentials = programme.folder.path().toStdString();
    EXPECT_THROW(send({}, 0), InputError) << "a folder";
    credentials = programme.folder.filePath("link.txt").toStdString();
    ASSERT_EQ(::symlink(good.c_str(), credentials.c_str()), 0);
    EXPECT_THROW(send({}, 0), InputError) << "a link";
    credentials = good;
    EXPECT_THROW(run({"xapi", "send", "--to", "http://lrs.example/xapi"}, 0), InputError);
    EXPECT_TRUE(lrs.requests.empty());
}

}  // namespace
}  // namespace fulcrum::app::program_test
