// SPDX-License-Identifier: Apache-2.0
// The documents and the comments agree with the repository: links and file names exist, comments refer to
// nothing outside it, every source that is named is in docs/BIBLIOGRAPHY.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
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

const std::vector<std::string> folders = {"sim_core", "assessment", "database", "ui",    "app",
                                          "assets",   "tests",      "docs",     "cmake", "LICENSES"};

std::vector<fs::path> files_with(const std::vector<std::string>& extensions) {
    const fs::path root = test::source_path("");
    std::vector<fs::path> found;
    const auto take = [&](const fs::path& path) {
        const std::string extension = path.extension().string();
        if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
            found.push_back(path);
    };
    for (const auto& entry : fs::directory_iterator(root))
        if (entry.is_regular_file()) take(entry.path());
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file()) take(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

std::string relative_name(const fs::path& path) {
    return fs::relative(path, test::source_path("")).generic_string();
}

/// A path of the repository as a document writes it, without wildcards and names to be filled in.
bool is_file_name(const std::string& word) {
    if (word.find_first_of("*<>{}$ |,…") != std::string::npos) return false;
    const std::size_t slash = word.find('/');
    if (slash == std::string::npos) return false;
    if (std::find(folders.begin(), folders.end(), word.substr(0, slash)) == folders.end()) return false;
    static const std::regex placeholder("(^|/|_)(NAME|TASK|ID|FILE|ROOM|KIND|X|N)(_|/|\\.|$)");
    return !std::regex_search(word, placeholder);
}

/// What is between `open` and `close` in a line, each time.
std::vector<std::string> between(const std::string& line, const std::string& open, const std::string& close) {
    std::vector<std::string> found;
    for (std::size_t at = line.find(open); at != std::string::npos;) {
        const std::size_t begin = at + open.size(), end = line.find(close, begin);
        if (end == std::string::npos) break;
        found.push_back(line.substr(begin, end - begin));
        at = line.find(open, end + close.size());
    }
    return found;
}

/// The files that a document links to or names and that are not there.
std::vector<std::string> missing_files(const std::string& document, const fs::path& folder, bool history) {
    std::vector<std::string> missing;
    for (const std::string& line : lines_of(document)) {
        for (std::string target : between(line, "](", ")")) {
            if (target.rfind("http", 0) == 0 || target[0] == '#') continue;
            target = target.substr(0, target.find('#'));
            if (!fs::exists(folder / target)) missing.push_back(target);
        }
        if (history) continue;  // names what was there at the time
        for (const std::string& word : between(line, "`", "`"))
            if (is_file_name(word) && !fs::exists(fs::path(test::source_path("")) / word))
                missing.push_back(word);
    }
    return missing;
}

TEST(Documents, EveryLinkAndFileNameExists) {
    std::size_t documents = 0;
    for (const fs::path& path : files_with({".md"})) {
        const std::string name = relative_name(path);
        ++documents;
        for (const std::string& missing :
             missing_files(test::text_of(name), path.parent_path(), name == "CHANGELOG.md"))
            ADD_FAILURE() << name << " names " << missing << ", which does not exist";
    }
    EXPECT_GT(documents, 30U);
}

TEST(Documents, AMissingFileIsFound) {
    const fs::path docs = test::source_path("docs");
    EXPECT_EQ(missing_files("[a](THEORY.md) and [b](NOWHERE.md#x)", docs, false),
              std::vector<std::string>{"NOWHERE.md"});
    EXPECT_EQ(
        missing_files("`sim_core/rod/rod.h`, `sim_core/rod/no_such.h`, `assets/tasks/*.json`", docs, false),
        std::vector<std::string>{"sim_core/rod/no_such.h"});
    EXPECT_TRUE(missing_files("`tests/a/NAME_test.cpp`, `sim_core/gone.h`", docs, true).empty());
}

/// The first reference in a line to a text that is not in the repository; empty: none.
std::string outside_reference(const std::string& line) {
    static const std::regex design(
        R"re((^|[^/\w])(theory|product|quality|platform|formats|metrics|devices|house|words|architecture|examples|interop)\.md)re");
    static const std::regex section(R"re((^|[^/\w])[Tt]heory,? (section )?\d)re");
    static const std::regex other(
        R"re((\(issue[: ]|\bissue \d|shared/design|\bthe paper\b, (Eq|Fig)|specification, ))re");
    static const std::vector<std::string> signs = {".md",     "heory", "issue",
                                                   "shared/", "paper", "specification"};
    if (std::none_of(signs.begin(), signs.end(),
                     [&](const std::string& sign) { return line.find(sign) != std::string::npos; }))
        return {};
    std::smatch match;
    for (const std::regex* pattern : {&design, &section, &other})
        if (std::regex_search(line, match, *pattern)) return match.str();
    return {};
}

/// The sections of docs/THEORY.md: "1", "1.1", ...
std::set<std::string> theory_sections() {
    std::set<std::string> sections;
    static const std::regex heading(R"(^#+ (\d+(\.\d+)?)\.? )");
    for (const std::string& line : lines_of(test::text_of("docs/THEORY.md"))) {
        std::smatch match;
        if (std::regex_search(line, match, heading)) sections.insert(match[1].str());
    }
    return sections;
}

TEST(Documents, EveryEnvironmentVariableIsInBuilding) {
    static const std::regex variable(R"re("(FULCRUM_[A-Z_]+)")re");
    const std::string building = test::text_of("docs/BUILDING.md");
    std::set<std::string> variables;
    for (const fs::path& path : files_with({".h", ".cpp"})) {
        const std::string text = structure::read(path);
        for (std::sregex_iterator it(text.begin(), text.end(), variable), end; it != end; ++it)
            variables.insert((*it)[1]);
    }
    EXPECT_GT(variables.size(), 30U);
    for (const std::string& name : variables)
        EXPECT_TRUE(std::regex_search(building, std::regex("\\b" + name + "\\b"))) << name;
}

TEST(Documents, CommentsReferToNothingOutsideTheRepository) {
    const std::set<std::string> sections = theory_sections();
    EXPECT_GT(sections.size(), 8U);
    static const std::regex document(R"(docs/([A-Za-z_/0-9]+\.md)((, section)? (\d+(\.\d+)?))?)");
    std::size_t references = 0;
    for (const fs::path& path : files_with({".h", ".cpp", ".txt", ".cmake", ".json", ".vert", ".frag"})) {
        const std::string name = relative_name(path);
        if (name == "tests/structure/documents_test.cpp") continue;
        int number = 0;
        for (const std::string& line : lines_of(test::text_of(relative_name(path)))) {
            ++number;
            EXPECT_EQ(outside_reference(line), "") << name << ":" << number;
            if (line.find("docs/") == std::string::npos) continue;
            for (std::sregex_iterator it(line.begin(), line.end(), document), end; it != end; ++it) {
                ++references;
                const std::string file = (*it)[1].str();
                EXPECT_TRUE(fs::exists(fs::path(test::source_path("docs")) / file))
                    << name << ":" << number << " names docs/" << file;
                if (file == "THEORY.md" && (*it)[4].matched) {
                    EXPECT_EQ(sections.count((*it)[4].str()), 1U)
                        << name << ":" << number << ": no section " << (*it)[4].str();
                }
            }
        }
    }
    EXPECT_GT(references, 80U);
}

TEST(Documents, AnOutsideReferenceIsFound) {
    for (const char* bad :
         {"// (quality.md)", "// see theory, section 4", "// theory 1.1", "// (issue: tools)"})
        EXPECT_NE(outside_reference(bad), "") << bad;
    for (const char* good :
         {"// docs/QUALITY.md", "// docs/THEORY.md 4", "// what theory says", "map.theory = 3"})
        EXPECT_EQ(outside_reference(good), "") << good;
}

struct Citation {
    std::string name, year;
};

/// "Name 2001", "Name (2001)", "Name et al. 2001", "Name and Other 2001": the name next to the year, or the
/// one before "et al.".
std::vector<Citation> citations(const std::string& line) {
    static const std::regex pattern(
        R"re(([A-Z][A-Za-z'\x80-\xff-]+)( et al\.)? \(?((18|19|20)\d\d)(?![\d-]))re");
    static const std::set<std::string> not_names = {"Version", "January", "June", "December",
                                                    "Nov",     "Qt",      "ISO",  "RFC"};
    std::vector<Citation> found;
    if (line.find("19") == std::string::npos && line.find("20") == std::string::npos) return found;
    for (std::sregex_iterator it(line.begin(), line.end(), pattern), end; it != end; ++it)
        if (not_names.count((*it)[1].str()) == 0 && std::stoi((*it)[3].str()) < 2026)
            found.push_back({(*it)[1].str(), (*it)[3].str()});
    return found;
}

bool in_bibliography(const std::vector<std::string>& entries, const Citation& citation) {
    return std::any_of(entries.begin(), entries.end(), [&](const std::string& entry) {
        return entry.rfind("- ", 0) == 0 && entry.find(citation.name) != std::string::npos &&
               entry.find(citation.year) != std::string::npos;
    });
}

TEST(Documents, EverySourceThatIsNamedIsInTheBibliography) {
    const std::vector<std::string> entries = lines_of(test::text_of("docs/BIBLIOGRAPHY.md"));
    std::size_t checked = 0;
    for (const fs::path& path : files_with({".h", ".cpp", ".json", ".md"})) {
        const std::string name = relative_name(path);
        const bool source = name.rfind("sim_core/", 0) == 0 || name.rfind("assessment/", 0) == 0 ||
                            name.rfind("ui/", 0) == 0 || name.rfind("assets/", 0) == 0 ||
                            name == "docs/THEORY.md" || name == "docs/METRICS.md";
        if (!source) continue;
        for (const std::string& line : lines_of(test::text_of(relative_name(path))))
            for (const Citation& citation : citations(line)) {
                ++checked;
                EXPECT_TRUE(in_bibliography(entries, citation))
                    << name << " names " << citation.name << " " << citation.year;
            }
    }
    EXPECT_GT(checked, 40U);
    EXPECT_FALSE(in_bibliography(entries, {"Nobody", "2001"}));
    ASSERT_EQ(citations("// after Flash and Hogan 1985 and Pan et al. 2011").size(), 2U);
}

}  // namespace
}  // namespace fulcrum
