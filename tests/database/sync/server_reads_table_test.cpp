// SPDX-License-Identifier: GPL-3.0-or-later
// Every call of this floor's headers that takes a store has one row, in server_reads.h or in not_asked.h.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "tests/database/sync/not_asked.h"
#include "tests/database/sync/server_reads.h"
#include "tests/support/support.h"

namespace fulcrum::database::test::reads {
namespace {

/// Without comments, preprocessor lines and empty braces, which would end or hide a declaration.
std::string declarations_in(const std::string& text) {
    std::string code;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find_first_not_of(' ');
        if (first != std::string::npos && line[first] == '#') continue;
        code += line.substr(0, line.find("//")) + '\n';
    }
    code = std::regex_replace(code, std::regex(R"(\s*= \{\})"), "");
    return std::regex_replace(code, std::regex(R"(\{\})"), ";");
}

/// Where the block ends that begins with the brace at `at`.
std::size_t end_of_block(const std::string& code, std::size_t at) {
    int depth = 0;
    for (; at < code.size(); ++at) {
        if (code[at] == '{') ++depth;
        if (code[at] == '}' && --depth == 0) return at;
    }
    return code.size();
}

void add_names(const std::string& code, const std::regex& call, const std::string& before,
               std::set<std::string>& to) {
    const std::sregex_iterator end;
    for (std::sregex_iterator each(code.begin(), code.end(), call); each != end; ++each)
        to.insert(before + (*each)[1].str());
}

/// "Attempts::list" of classes that are made of a store, "certificates" of functions that take one.
std::set<std::string> calls_in(const std::string& text) {
    static const std::regex block(R"(\b(?:class|struct) (\w+)(?: : [^{;]*)? \{)");
    static const std::regex method(R"((\w+)\(([^;{}]*?)\)\s*const(?: noexcept)?\s*[;{])");
    static const std::regex function(
        R"((\w+)\(([^;{}]*?\bconst (?:database::)?Store& \w+[^;{}]*?)\)\s*(?:noexcept\s*)?[;{])");
    const std::string code = declarations_in(text);
    std::set<std::string> names;
    std::string outside;
    std::size_t at = 0;
    const std::sregex_iterator end;
    for (std::sregex_iterator each(code.begin(), code.end(), block); each != end; ++each) {
        const auto from = static_cast<std::size_t>(each->position());
        if (from < at) continue;  // inside of another one
        const std::size_t open = from + static_cast<std::size_t>(each->length()) - 1,
                          close = end_of_block(code, open);
        outside += code.substr(at, from - at);
        at = std::min(code.size(), close + 1);
        const std::string name = (*each)[1].str(), body = code.substr(open, close - open);
        if (body.find(name + "(const Store& store") != std::string::npos)
            add_names(body.substr(0, body.find("private:")), method, name + "::", names);
    }
    outside += code.substr(at);
    add_names(outside, function, "", names);
    return names;
}

/// Of all headers of this floor that are not parts of other calls.
std::set<std::string> calls_of_the_floor() {
    static const std::regex internal("[Ii]nternal to (the database|this floor|this room)");
    std::set<std::string> names;
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(fulcrum::test::source_path("database"))) {
        if (file.path().extension() != ".h") continue;
        std::ifstream stream(file.path());
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        if (!std::regex_search(text, internal)) names.merge(calls_in(text));
    }
    return names;
}

TEST(ServerReadsTable, FindsCallsHoweverTheyAreWritten) {
    EXPECT_EQ(calls_in("class One {\n  public:\n    explicit One(const Store& store) : store_(store) {}\n"
                       "    int list(const Session& session, const Filter& filter = {}) const;  // all\n"
                       "    bool each(const std::function<bool(Data&&, double)>& visit) const;\n"
                       "    bool held() const noexcept { return held_; }\n    void write(int value);\n"
                       "  private:\n    int hidden() const;\n};\n"
                       "struct Two {\n    int size() const;\n};\n"
                       "int take(const Session& session,\n         const database::Store& store);\n"
                       "int pure(int value);\n"),
              (std::set<std::string>{"One::list", "One::each", "One::held", "take"}));
}

TEST(ServerReadsTable, HasEveryCallThatTakesAStoreOnce) {
    std::map<std::string, int> rows;
    for (const Read& row : answered) ++rows[row.name];
    for (const Refused& row : refused) ++rows[row.name];
    for (const NotAsked& group : not_asked())
        for (const char* name : group.names) ++rows[name];
    const std::set<std::string> calls = calls_of_the_floor();
    EXPECT_GT(calls.size(), 150U);
    for (const std::string& call : calls)
        EXPECT_EQ(rows[call], 1) << call
                                 << ": give it a row in server_reads.h, or in not_asked.h with the reason";
    for (const auto& [name, count] : rows) EXPECT_EQ(calls.count(name), 1U) << name << " is no such call";
}

}  // namespace
}  // namespace fulcrum::database::test::reads
