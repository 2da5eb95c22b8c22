// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum import as it is called: a trace of a public format becomes an external attempt; what does not fit
// is refused with file, row and hint before anything is stored.
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/services/program.h"
#include "sim_core/numerics/input_error.h"
#include "tests/app/access_programme.h"
#include "tests/support/support.h"

namespace fulcrum::app::program_test {
namespace {

/// Twenty seconds of the JIGSAWS columns: the left tool goes round, the right one stands still.
std::string jigsaws_text() {
    std::ostringstream text;
    for (int i = 0; i < 600; ++i) {
        for (int column = 1; column <= 76; ++column) {
            const double angle = 0.1 * i;
            const double value = column == 39   ? 0.05 * std::cos(angle)
                                 : column == 40 ? 0.05 * std::sin(angle)
                                                : 0.01;
            text << (column > 1 ? "    " : "") << value;
        }
        text << '\n';
    }
    return text.str();
}

class ImportCommand : public ::testing::Test {
  protected:
    ImportCommand() {
        programme.store.reset();
        std::ofstream(path("password.txt")) << database::test::password << '\n';
        std::ofstream(path("suturing.txt")) << jigsaws_text();
    }
    std::string path(const char* name) const {
        return programme.folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    nlohmann::json run(std::vector<std::string> words, int wanted = 0) const {
        words.insert(words.end(), {"--db", programme.path, "--json"});
        std::ostringstream output;
        struct Redirected {
            std::streambuf* before;
            ~Redirected() { std::cout.rdbuf(before); }
        };
        {
            const Redirected redirected{std::cout.rdbuf(output.rdbuf())};
            EXPECT_EQ(run_command(words), wanted);
        }
        return output.str().empty() ? nlohmann::json() : nlohmann::json::parse(output.str());
    }
    std::vector<std::string> signed_in(std::vector<std::string> words) const {
        words.insert(words.end(), {"--as", AccessProgramme::login_of(Role::educator), "--role", "educator",
                                   "--password-file", path("password.txt")});
        return words;
    }
    std::vector<std::string> call(const std::string& person) const {
        return {"import",     path("suturing.txt"),
                "--mapping",  fulcrum::test::source_path("assets/mappings/jigsaws.json"),
                "--exercise", "suturing",
                "--person",   person};
    }
    AccessProgramme programme;
};

TEST_F(ImportCommand, TraceOfTheJigsawsFormatBecomesAnExternalAttempt) {
    std::vector<std::string> dry = signed_in(call("ann"));
    dry.emplace_back("--dry-run");
    EXPECT_TRUE(run(dry)["attempt"].is_null());
    std::vector<std::string> words = signed_in(call("ann"));
    words.insert(words.end(), {"--performed", "2026-01-20 14:05"});
    const nlohmann::json stored = run(words);
    EXPECT_EQ(stored["task"], "external-suturing");
    EXPECT_EQ(stored["device_class"], "external");
    EXPECT_EQ(stored["samples"], 600);
    EXPECT_NEAR(stored["duration_s"].get<double>(), 599 / 30.0, 1e-9);
    const std::string id = stored["attempt"];

    programme.open();
    const database::AttemptSummary attempt =
        database::Attempts(*programme.store).read(programme.session("educator"), id);
    EXPECT_EQ(attempt.meta.person_id, programme.id("ann"));
    EXPECT_FALSE(attempt.counting);
    bool has_path = false;
    const auto score = database::Attempts(*programme.store).score(programme.session("educator"), id);
    for (const database::MetricRow& row : score->metrics)
        has_path = has_path || (row.id == "path_len" && row.hand == "left" && row.value && *row.value > 1000);
    EXPECT_TRUE(has_path) << "20 s at 0.15 m/s";
    programme.store.reset();
    EXPECT_THROW(run(signed_in(call("ann"))), database::StoreError) << "the same file again";
}

TEST_F(ImportCommand, StationStoresItForAnExternalPersonOnly) {
    std::vector<std::string> dry = call("external-robot");
    dry.emplace_back("--dry-run");
    run(dry);
    programme.open();
    EXPECT_FALSE(
        database::People(*programme.store).find_login(programme.store->station_session(), "external-robot"))
        << "a dry run makes nobody";
    programme.store.reset();
    const nlohmann::json stored = run(call("external-robot"));
    const std::string folder = path("exported");
    run({"report", "--attempt", stored["attempt"].get<std::string>(), "--format", "trace", "-o", folder});
    std::ifstream trace(folder + "/trace.csv");
    std::string names;
    std::getline(trace, names);
    EXPECT_EQ(names.rfind("t,left.px", 0), 0U) << names;
    std::ifstream document(folder + "/attempt.json");
    const nlohmann::json exported = nlohmann::json::parse(document);
    EXPECT_EQ(exported["device_class"], "external");
    EXPECT_TRUE(exported["passed"].is_null());
    EXPECT_EQ(exported["not_scored_code"]["id"], "score.recorded_elsewhere");
    EXPECT_THROW(run(call("ann")), database::StoreError) << "a real person";
}

TEST_F(ImportCommand, TheRecordOfAVoidedOneSaysSo) {
    const std::string id = run(signed_in(call("ann")))["attempt"], folder = path("exported");
    const auto exported = [&] {
        run(signed_in({"report", "--attempt", id, "--format", "trace", "-o", folder}));
        std::ifstream document(folder + "/attempt.json");
        return nlohmann::json::parse(document);
    };
    const nlohmann::json before = exported();
    EXPECT_EQ(before["state"], "completed");
    ASSERT_TRUE(before.contains("voided"));
    EXPECT_TRUE(before["voided"].is_null());
    programme.open();
    database::Attempts(*programme.store)
        .void_attempt(programme.asker(Role::educator), id, "it was somebody else");
    programme.store.reset();
    const nlohmann::json after = exported();
    EXPECT_EQ(after["state"], "voided");
    EXPECT_EQ(after["voided"]["reason"], "it was somebody else");
    EXPECT_TRUE(after["voided"]["time"].is_string());
}

TEST_F(ImportCommand, EveryFormOfReportHoldsIt) {
    const std::string id = run(signed_in(call("ann")))["attempt"];
    for (const char* format : {"pdf", "csv", "xlsx", "json", "xapi"})
        for (const auto& [option, value] : {std::pair<const char*, std::string>{"--person", "ann"},
                                            {"--attempt", id},
                                            {"--cohort", "Year 1"}}) {
            const bool table = std::string(format) == "xlsx" || std::string(format) == "xapi";
            if (table && std::string(option) == "--attempt") continue;  // one attempt has none
            const std::string file = path("report.") + format;
            std::vector<std::string> words = {"report", option, value, "--format", format, "-o", file};
            if (std::string(format) == "xapi")
                words.insert(words.end(), {"--home-page", "https://example.org"});
            words.insert(words.end(), {"--as", AccessProgramme::login_of(Role::director), "--role",
                                       "director", "--password-file", path("password.txt")});
            const nlohmann::json files = run(words)["files"];
            ASSERT_FALSE(files.empty()) << format << ' ' << option;
            if (std::string(format) == "pdf" || std::string(format) == "xlsx") continue;
            std::string text;
            for (const nlohmann::json& name : files) {
                std::ifstream in(name.get<std::string>());
                text.append(std::istreambuf_iterator<char>(in), {});
            }
            const bool is_cohort = std::string(option) == "--cohort";  // counts tasks of the curriculum
            EXPECT_TRUE(is_cohort || text.find("external-suturing") != std::string::npos)
                << format << ' ' << option;
            if (std::string(option) == "--attempt") {
                EXPECT_EQ(text.find("\"success\":true"), std::string::npos) << "nothing was passed";
            }
        }
}

TEST_F(ImportCommand, RecordingOfPerkTutorBecomesOne) {
    std::ofstream file(path("needle.xml"));
    file << "<TransformRecorderLog>\n";
    for (int i = 0; i < 200; ++i)
        for (const char* device : {"ProbeToRAS", "StylusTipToRAS"})
            file << "  <log TimeStampSec=\"" << i / 50 << "\" TimeStampNSec=\"" << i % 50 * 20'000'000
                 << "\" type=\"transform\" DeviceName=\"" << device << "\" transform=\"1 0 0 " << i
                 << " 0 1 0 10 0 0 1 20 0 0 0 1 \" />\n";
    file << "</TransformRecorderLog>\n";
    file.close();
    const nlohmann::json stored = run({"import", path("needle.xml"), "--mapping",
                                       fulcrum::test::source_path("assets/mappings/perktutor.json"),
                                       "--exercise", "lumbar-puncture", "--person", "external-student"});
    EXPECT_EQ(stored["task"], "external-lumbar-puncture");
    EXPECT_EQ(stored["samples"], 200);
    for (const nlohmann::json& row : stored["metrics"])
        if (row["id"] == "path_len" && row["hand"] == "right") {
            EXPECT_NEAR(row["value"].get<double>(), 199, 2);
        }
}

TEST_F(ImportCommand, WhatDoesNotFitNamesItsRowAndLeavesNothing) {
    const auto problem = [&](std::vector<std::string> words) {
        try {
            run(std::move(words));
        } catch (const std::exception& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    std::ofstream(path("suturing.txt"), std::ios::app) << "1 2 3\n";
    EXPECT_NE(problem(call("external-robot")).find("suturing.txt:601"), std::string::npos)
        << problem(call("external-robot"));
    std::vector<std::string> words = call("external-robot");
    words[1] = path("no-such-file.txt");
    EXPECT_NE(problem(words), "");
    words = call("external-robot");
    words[5] = "two words";
    std::ofstream(path("suturing.txt")) << jigsaws_text();
    EXPECT_NE(problem(words).find("two words"), std::string::npos);
    words = call("external-robot");
    words.insert(words.end(), {"--performed", "yesterday"});
    EXPECT_NE(problem(words).find("yesterday"), std::string::npos);
    EXPECT_NE(problem({"import", path("suturing.txt"), "--exercise", "suturing"}).find("--person"),
              std::string::npos);
    programme.open();
    database::AttemptFilter filter;
    filter.task_id = "external-suturing";
    EXPECT_TRUE(
        database::Attempts(*programme.store).list(programme.store->station_session(), filter).empty());
}

}  // namespace
}  // namespace fulcrum::app::program_test
