// SPDX-License-Identifier: Apache-2.0
// What an error says can be put into the reader's language: every text that makes one is marked
// QT_TRANSLATE_NOOP("errors", "..."), so that lupdate finds it.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/structure/sources.h"

namespace fulcrum::structure {
namespace {

/// What takes texts that people read: exceptions, and the functions that throw them or collect problems.
constexpr const char* taking_sentences =
    R"re(\b(InputError|UsageError|StoreError|SignInRefused|AccessDenied|WordedError|StateArchiveError|Sentence|)re"
    R"re(GoalFault|fail|fail_at|refuse|refuse_wrong_try|bad|corrupt|damaged|damaged_chunk|lacks|require_name|)re"
    R"re(and_reconnect|sentence_packet|leave_out|problems\.push_back)\s*[({])re";

/// Sources whose errors stay in English, with the reason.
const std::map<std::string, std::string>& left_in_english() {
    static const std::map<std::string, std::string> places = {
        {"sim_core/lab/", "the laboratory is a program for developers"},
        {"app/lab/", "the laboratory is a program for developers"},
        {"sim_core/anatomy/", "values of a program; a scene's are checked by sim_core/scene, with a line"},
        {"sim_core/bowel/", "a mesh that the program made"},
        {"sim_core/collision/", "a mesh that the program made"},
        {"sim_core/cutting/", "a mesh that the program made"},
        {"sim_core/geometry/", "mesh files are read by the laboratory only"},
        {"sim_core/material/", "values of a program"},
        {"sim_core/membrane/", "values of a program; a scene's are checked by sim_core/scene, with a line"},
        {"sim_core/rod/", "values of a program"},
        {"sim_core/devices/device_page.cpp", "words of the operating system"},
        {"assessment/metrics/registry.cpp", "an incomplete descriptor stops every start of the program"},
    };
    return places;
}

/// A number with an odd number of digit separators, such as 1'000, outside of comments and literals; empty:
/// none. lupdate reads its last separator as the beginning of a character and misses the texts behind it.
std::string odd_separators(const std::string& line) {
    static const std::regex number(R"re((^|[^\w'])(\d[\dA-Fa-fxX]*(?:'[\dA-Fa-f]+)+))re");
    const std::string code = line.substr(0, line.find("//"));
    for (std::sregex_iterator it(code.begin(), code.end(), number), end; it != end; ++it) {
        const std::string found = (*it)[2];
        if (std::count(found.begin(), found.end(), '\'') % 2 != 0) return found;
    }
    return {};
}

/// The index behind the literal or bracket that begins at `at`.
std::size_t end_of(const std::string& text, std::size_t at) {
    if (text[at] == '"') {
        for (++at; at < text.size() && text[at] != '"'; ++at)
            if (text[at] == '\\') ++at;
        return at + 1;
    }
    const std::size_t begin = at++;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == ')' || c == '}' || c == ']') return at + 1;
        if (c == '\'' && text.compare(at, 3, "'\"'") == 0) {
            at += 2;
        } else if (c == '"' || c == '(' || c == '{' || c == '[') {
            at = end_of(text, at) - 1;
        } else if (text.compare(at, 2, "//") == 0) {
            at = std::min(text.find('\n', at), text.size() - 1);
        }
    }
    return std::max(at, begin + 1);
}

/// The place of an error of a command line.
const std::set<std::string> names_of_commands = {"benchmark build", "curriculum move", "--format trace"};

/// The texts of several words in a call that begins at `at` with its bracket, without those that are marked.
std::vector<std::string> unmarked_texts(const std::string& text, std::size_t at) {
    static const std::regex words("[a-z]{2,} [a-z]");
    const std::string mark = "QT_TRANSLATE_NOOP(";
    std::vector<std::string> found;
    const std::size_t end = end_of(text, at);
    for (std::size_t i = at + 1; i < end; ++i) {
        if (text.compare(i, mark.size(), mark) == 0) {
            i = end_of(text, i + mark.size() - 1) - 1;
        } else if (text.compare(i, 3, "'\"'") == 0) {
            i += 2;
        } else if (text[i] == '"') {
            const std::size_t last = end_of(text, i);
            const std::string literal = text.substr(i + 1, last - i - 2);
            if (std::regex_search(literal, words) && names_of_commands.count(literal) == 0)
                found.push_back(literal);
            i = last - 1;
        }
    }
    return found;
}

std::vector<std::string> unmarked_in(const std::string& code) {
    static const std::regex call(taking_sentences);
    std::vector<std::string> found;
    const std::sregex_iterator none;
    for (std::sregex_iterator each(code.begin(), code.end(), call); each != none; ++each) {
        const auto bracket = static_cast<std::size_t>(each->position() + each->length() - 1);
        for (const std::string& one : unmarked_texts(code, bracket)) found.push_back(one);
    }
    return found;
}

bool stays_english(const std::string& name) {
    for (const auto& [place, reason] : left_in_english())
        if (name.rfind(place, 0) == 0) return true;
    return false;
}

TEST(Sentences, EveryTextOfAnErrorIsMarked) {
    std::size_t marked = 0;
    for (const std::string& floor : floors) {
        for (const fs::path& path : files_below(floor, {".h", ".cpp"})) {
            const std::string name = fs::relative(path, source_path("")).generic_string();
            const std::string code = read(path);
            for (std::size_t at = code.find("(\"errors\","); at != std::string::npos;
                 at = code.find("(\"errors\",", at + 1))
                ++marked;
            if (stays_english(name)) continue;
            for (const std::string& text : unmarked_in(code))
                ADD_FAILURE() << name << ": \"" << text
                              << "\" is not marked; see docs/HOWTO.md, A message of an error";
        }
    }
    EXPECT_GT(marked, 1000U);
}

TEST(Sentences, WhatStaysEnglishIsThere) {
    for (const auto& [place, reason] : left_in_english())
        EXPECT_TRUE(fs::exists(source_path(place))) << place;
}

/// Standard exceptions: an error of the program itself, or words of the operating system.
TEST(Sentences, StandardExceptionsAreForErrorsOfTheProgram) {
    const std::map<std::string, std::string> known = {
        {"assessment/learning/agreement.cpp",
         "caught by the command line, which puts its marked text into words"},
        {"assessment/metrics/compute.cpp", "a metric that the caller took from the registry"},
        {"assessment/operators/operator.cpp", "a goal kind without a behaviour"},
        {"app/services/command_demonstrate.cpp", "PNG is part of Qt"},
        {"database/rows/crypto.cpp", "a broken library, a seed of the wrong size"},
        {"database/sync/exchange.cpp", "a table that the caller took from the list"},
        {"sim_core/scene/json_schema.cpp", "the built-in schema is not valid"},
        {"sim_core/devices/device_page.cpp", "words of the operating system"},
        {"sim_core/devices/packets.cpp", "words of the operating system"},
        {"sim_core/hapticd/overseer.cpp", "words of the operating system"},
        {"sim_core/numerics/files.cpp", "words of the operating system"},
        {"sim_core/numerics/output_file.cpp", "words of the operating system"},
        {"ui/language/linguist_file.cpp", "the translations are part of the program"},
    };
    static const std::regex thrown(R"(\bthrow std::(\w+)\()");
    for (const std::string& floor : floors) {
        for (const fs::path& path : files_below(floor, {".h", ".cpp"})) {
            const std::string name = fs::relative(path, source_path("")).generic_string();
            if (known.count(name) != 0 || stays_english(name)) continue;
            const std::string code = read(path);
            std::smatch match;
            EXPECT_FALSE(std::regex_search(code, match, thrown))
                << name << " throws std::" << match[1] << ": throw a WordedError";
        }
    }
    for (const auto& [name, reason] : known)
        EXPECT_NE(read(source_path(name)).find("throw std::"), std::string::npos) << name;
}

TEST(Sentences, AnUnmarkedTextIsFound) {
    EXPECT_EQ(unmarked_in(R"(throw InputError(path, "", "cannot be read", hint);)"),
              std::vector<std::string>{"cannot be read"});
    EXPECT_EQ(unmarked_in(R"(fail(place, {QT_TRANSLATE_NOOP("errors", "%1 is bad"), "a (b"}, "give one");)"),
              std::vector<std::string>{"give one"});
    EXPECT_EQ(
        unmarked_in(R"(throw StoreError(kind, QT_TRANSLATE_NOOP("errors", "no room left"), "%1: %2");)"),
        std::vector<std::string>());
}

TEST(Sentences, NoNumberKeepsLupdateFromFindingTexts) {
    EXPECT_EQ(odd_separators("constexpr long second = 1'000'000'000;"), "1'000'000'000");
    EXPECT_EQ(odd_separators("constexpr long ms = 1'000'000;  // not 1'000"), "");
    for (const std::string& floor : floors)
        for (const fs::path& path : files_below(floor, {".h", ".cpp"})) {
            int number = 0;
            for (const std::string& line : lines_of(read(path))) {
                ++number;
                if (line.find('\'') == std::string::npos) continue;
                EXPECT_EQ(odd_separators(line), "") << path << ":" << number;
            }
        }
}

}  // namespace
}  // namespace fulcrum::structure
