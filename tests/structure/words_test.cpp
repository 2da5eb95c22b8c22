// SPDX-License-Identifier: Apache-2.0
// Documents, user-visible texts, comments and names of tests use plain English: a short list of words and
// phrases that are always wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/structure/sources.h"
#include "tests/support/generated.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

namespace fs = std::filesystem;

using structure::lines_of;

/// As structure::files_below, as paths relative to the repository.
std::vector<std::string> files_below(const std::string& folder, const std::vector<std::string>& extensions) {
    std::vector<std::string> names;
    for (const fs::path& path : structure::files_below(folder, extensions))
        names.push_back(fs::relative(path, test::source_path("")).generic_string());
    return names;
}

/// The first word of the text that is always wrong; empty: none.
std::string avoided_word(const std::string& text) {
    static const std::regex pattern(
        R"re(\b(anew|besides?|meanwhile|untold|told|mend|mended|mends|hitherto|whilst|whiles|thereof|whereupon|)re"
        R"re(goes on|otherwise than|clock stands|comes? to rest on|is no (number|file|folder|name|text))\b)re");
    std::smatch match;
    return std::regex_search(text, match, pattern) ? match.str() : std::string();
}

/// The text between quotation marks in a line of C++, all literals one after another; comments are left out.
std::string literals_of(const std::string& line) {
    std::string text;
    bool inside = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (!inside && line.compare(i, 2, "//") == 0) break;
        if (!inside && line.compare(i, 3, "'\"'") == 0) {
            i += 2;
        } else if (line[i] == '"') {
            inside = !inside;
            text += ' ';
        } else if (inside) {
            if (line[i] == '\\') ++i;
            if (i < line.size()) text += line[i];
        }
    }
    return text;
}

/// What follows // in a line of C++ outside its literals; empty: nothing.
std::string comment_of(const std::string& line) {
    bool inside = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        if (inside && line[i] == '\\')
            ++i;
        else if (line[i] == '"' && (i == 0 || line[i - 1] != '\''))
            inside = !inside;
        else if (!inside && line[i] == '/' && line[i + 1] == '/')
            return line.substr(i + 2);
    }
    return {};
}

/// The first word of a test's name that is always wrong there; empty: none.
std::string avoided_in_name(const std::string& name) {
    std::string words;
    for (const char letter : name) {
        if (letter >= 'A' && letter <= 'Z') words += ' ';
        words += static_cast<char>(std::tolower(letter));
    }
    const std::string word = avoided_word(words);
    if (!word.empty()) return word;
    static const std::regex pattern(R"re(^ who\b|\b(is said|go on|tells|lies|stands? (out|in the))\b)re");
    std::smatch match;
    return std::regex_search(words, match, pattern) ? match.str() : std::string();
}

TEST(Words, DocumentsUsePlainWords) {
    std::vector<std::string> documents = files_below("docs", {".md"});
    for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"}) documents.push_back(name);
    for (const std::string& name : documents) {
        bool generated = false;  // tables of names from elsewhere
        int number = 0;
        for (const std::string& line : lines_of(test::text_of(name))) {
            ++number;
            if (line.rfind("<!-- generated: ", 0) == 0) generated = true;
            if (line.rfind("<!-- end of ", 0) == 0) generated = false;
            if (!generated) {
                EXPECT_EQ(avoided_word(line), "") << name << ":" << number;
            }
        }
    }
    EXPECT_GT(documents.size(), 30U);
}

TEST(Words, ScreensAndMessagesUsePlainWords) {
    std::size_t literals = 0;
    for (const char* folder : {"sim_core", "assessment", "database", "app", "ui"})
        for (const std::string& name : files_below(folder, {".h", ".cpp"})) {
            int number = 0;
            for (const std::string& line : lines_of(test::text_of(name))) {
                ++number;
                const std::string text = literals_of(line);
                if (text.find(' ', 1) == std::string::npos) continue;
                ++literals;
                EXPECT_EQ(avoided_word(text), "") << name << ":" << number;
            }
        }
    EXPECT_GT(literals, 2000U);
}

TEST(Words, CommentsUsePlainWords) {
    std::size_t comments = 0;
    for (const char* folder : {"sim_core", "assessment", "database", "app", "ui", "tests"})
        for (const std::string& name : files_below(folder, {".h", ".cpp"})) {
            if (name == "tests/structure/words_test.cpp") continue;  // its comments quote what it looks for
            int number = 0;
            for (const std::string& line : lines_of(test::text_of(name))) {
                ++number;
                const std::string comment = comment_of(line);
                if (comment.empty()) continue;
                ++comments;
                EXPECT_EQ(avoided_word(comment), "") << name << ":" << number;
            }
        }
    EXPECT_GT(comments, 5000U);
}

TEST(Words, NamesOfTestsUsePlainWords) {
    static const std::regex test(R"re(^(?:TEST|TEST_F|TEST_P|RC_GTEST\w*PROP)\(\w+,\s*(\w+))re");
    std::size_t names = 0;
    for (const std::string& file : files_below("tests", {".cpp"}))
        for (const std::string& line : lines_of(test::text_of(file))) {
            std::smatch match;
            if (line.empty() || (line[0] != 'T' && line[0] != 'R') || !std::regex_search(line, match, test))
                continue;
            ++names;
            EXPECT_EQ(avoided_in_name(match[1]), "") << file << ": " << match[1];
        }
    EXPECT_GT(names, 1500U);
}

TEST(Words, TasksScenesAndSchemasUsePlainWords) {
    std::size_t files = 0;
    for (const std::string& name : files_below("assets", {".json"})) {
        ++files;
        int number = 0;
        for (const std::string& line : lines_of(test::text_of(name)))
            EXPECT_EQ(avoided_word(line), "") << name << ":" << ++number;
    }
    EXPECT_GT(files, 20U);
}

TEST(Words, AnAvoidedWordIsFound) {
    EXPECT_EQ(avoided_word("the page is made anew"), "anew");
    EXPECT_EQ(avoided_word("'x' is no number"), "is no number");
    EXPECT_EQ(avoided_word("the clock stands and the scene is hidden"), "clock stands");
    for (const char* plain : {"inside and sidebar", "amended", "retold"})
        EXPECT_EQ(avoided_word(plain), "") << plain;
}

TEST(Words, AnAvoidedWordInACommentOrANameIsFound) {
    EXPECT_EQ(avoided_word(comment_of("int a;  // beside it")), "beside");
    EXPECT_EQ(comment_of("const char* url = \"http://told\";"), "");
    EXPECT_EQ(avoided_in_name("WhoRatedLittleIsLeftOut"), " who");
    EXPECT_EQ(avoided_in_name("ARaterIsToldSo"), "told");
    EXPECT_EQ(avoided_in_name("NamesThePersonWhoSigned"), "");
}

TEST(Words, OnlyLiteralsAreRead) {
    EXPECT_EQ(avoided_word(literals_of("f(tr(\"try\"), \"again, or make it anew\");")), "anew");
    EXPECT_EQ(avoided_word(literals_of("bool told = said('\"', \"\\\"plain\\\"\");  // told anew")), "");
}

}  // namespace
}  // namespace fulcrum
