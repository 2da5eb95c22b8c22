// SPDX-License-Identifier: Apache-2.0
// The suites that tests/CMakeLists.txt takes out of the quick label are suites that exist: one that is
// renamed would otherwise return to it unnoticed.
#include <gtest/gtest.h>

#include <set>

#include "tests/structure/sources.h"

namespace fulcrum::structure {
namespace {

/// Suites, with their instances' names, of the tests below a folder.
std::set<std::string> suites_below(const std::string& folder) {
    static const std::regex test(R"(\b(TEST|TEST_F|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+)\s*,)");
    static const std::regex instance(R"(\bINSTANTIATE_TEST_SUITE_P\(\s*(\w+)\s*,\s*(\w+))");
    std::set<std::string> suites;
    for (const fs::path& path : files_below(folder, {".cpp", ".h"})) {
        const std::string text = read(path);
        // Only from the places where a macro can be: reading all of the text takes long.
        const auto collect = [&](const char* word, const std::regex& pattern, auto name_of) {
            for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
                std::smatch match;
                const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
                if (std::regex_search(begin, text.end(), match, pattern,
                                      std::regex_constants::match_continuous))
                    suites.insert(name_of(match));
            }
        };
        const auto suite = [](const std::smatch& match) { return match[2].str(); };
        collect("TEST", test, suite);
        collect("RC_GTEST_", test, suite);
        collect("INSTANTIATE_TEST_SUITE_P", instance,
                [](const std::smatch& match) { return match[1].str() + "/" + match[2].str(); });
    }
    return suites;
}

TEST(Labels, SuitesWithALabelOfTheirOwnExist) {
    static const std::regex list(R"(set\(([a-z]+(?:_core)?)\w*_(?:full|quick|window)\s([^)]*)\))");
    const std::string text = read(source_path("tests/CMakeLists.txt"));
    int lists = 0;
    const std::sregex_iterator end;
    for (std::sregex_iterator each(text.begin(), text.end(), list); each != end; ++each, ++lists) {
        const std::set<std::string> suites = suites_below("tests/" + (*each)[1].str());
        EXPECT_FALSE(suites.empty()) << (*each)[1];
        std::istringstream patterns((*each)[2].str());
        for (std::string pattern; patterns >> pattern;) {
            ASSERT_GT(pattern.size(), 2U);
            EXPECT_EQ(pattern.substr(pattern.size() - 2), ".*") << pattern;
            EXPECT_EQ(suites.count(pattern.substr(0, pattern.size() - 2)), 1U) << pattern;
        }
    }
    EXPECT_EQ(lists, 7);
    EXPECT_EQ(suites_below("tests/structure").count("Labels"), 1U);
    EXPECT_EQ(suites_below("tests/structure").count("Label"), 0U);
}

}  // namespace
}  // namespace fulcrum::structure
