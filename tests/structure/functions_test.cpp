// SPDX-License-Identifier: Apache-2.0
// A function of the product is at most 80 lines long, or the comment above it says why it is longer.
#include "tests/structure/functions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fulcrum::structure {
namespace {

constexpr int most_lines = 80;

/// Those that are too long and give no reason.
std::vector<std::string> too_long(const Functions& functions) {
    std::vector<std::string> found;
    for (const Function& function : functions.found) {
        if (function.lines > most_lines && !function.has_reason)
            found.push_back("line " + std::to_string(function.line) + ": " + std::to_string(function.lines) +
                            " lines: " + function.head.substr(0, 100));
    }
    return found;
}
std::vector<std::string> too_long(const std::string& text) {
    return too_long(functions_of(text));
}

TEST(Functions, AreShortOrGiveAReason) {
    std::size_t functions = 0, reasons = 0;
    for (const std::string& floor : floors) {
        for (const fs::path& path : files_below(floor, {".h", ".cpp"})) {
            const Functions of_file = functions_of(read(path));
            EXPECT_TRUE(of_file.balanced) << path;
            for (const std::string& each : too_long(of_file)) ADD_FAILURE() << path.string() << ", " << each;
            functions += of_file.found.size();
            for (const Function& function : of_file.found) {
                reasons += function.has_reason ? 1U : 0U;
                EXPECT_FALSE(function.has_reason && function.lines <= most_lines)
                    << path << ":" << function.line << " gives a reason for its length but is short";
            }
        }
    }
    EXPECT_GT(functions, 2000U);
    EXPECT_LT(reasons, 10U) << "reasons for long functions should be rare";
}

std::string body(int lines) {
    std::string text;
    for (int i = 0; i < lines; ++i) text += "    use(" + std::to_string(i) + ");\n";
    return text;
}

TEST(Functions, ALongOneIsFoundUnlessItGivesAReason) {
    const std::string head = "int long_one(int a,\n             int b) noexcept {\n";
    EXPECT_EQ(too_long(head + body(77) + "}\n").size(), 0U);  // 80 lines
    ASSERT_EQ(too_long("\n" + head + body(78) + "}\n").size(), 1U);
    EXPECT_EQ(too_long("\n" + head + body(78) + "}\n")[0],
              "line 2: 81 lines: int long_one(int a, int b) noexcept");
    EXPECT_EQ(too_long("// Long because: one formula.\n" + head + body(78) + "}\n").size(), 0U);
    EXPECT_EQ(
        too_long("// Long because: one formula,\n// in its own order.\n" + head + body(78) + "}\n").size(),
        0U);
    EXPECT_EQ(too_long("// Long because:\n" + head + body(78) + "}\n").size(), 1U) << "no reason is given";
    EXPECT_EQ(too_long("// Long because: one formula.\n\n" + head + body(78) + "}\n").size(), 1U)
        << "the reason is not directly above";
}

TEST(Functions, EveryKindOfFunctionIsMeasured) {
    const std::string rest = body(90);
    for (const std::string head :
         {"auto f() -> std::vector<int> {\n", "Type::Type(int a) : a_{a}, b_(2) {\n",
          "Type::Type(int a) : a_{a} {\n", "bool operator()(int a) const override {\n",
          "template <class T, typename U>\nvoid f(T a, U b) {\n",
          "const std::vector<Row> rows = {{1, [](const Row& row) {\n",
          "struct Type {\n  public:\n    void f() const {\n", "void f() {\n    run([&](int i) {\n",
          "const auto f = []() noexcept {\n", "static const std::map<int, int> made = [] {\n"}) {
        EXPECT_EQ(too_long(std::string(head) + rest).size(), 0U) << "not closed, so not measured: " << head;
        std::string text = std::string(head) + rest;
        const auto count = [&](char c) { return std::count(text.begin(), text.end(), c); };
        while (count('{') > count('}')) text += "}\n";
        EXPECT_TRUE(functions_of(text).balanced) << head;
        EXPECT_EQ(too_long(text).size(), 1U) << head;
    }
}

TEST(Functions, OnlyFunctionsAreMeasured) {
    const std::string rest = body(90);
    for (const std::string head : {"namespace a {\n", "struct Type final : Base<int> {\n",
                                   "enum class Kind {\n", "const int table[] = {\n", "extern \"C\" {\n"})
        EXPECT_EQ(too_long(std::string(head) + rest + "};\n").size(), 0U) << head;
    const std::string shader = "const char* text = R\"glsl(\nvoid main() {\n" + rest + "}\n)glsl\";\n";
    EXPECT_EQ(functions_of(shader).found.size(), 0U);
    // Braces in comments, texts and characters belong to no function.
    const Functions two = functions_of(
        "void f() {  // {\n    g('{', \"{\\\"{\", 1'000); /* { */\n}\n#define OPEN {\nvoid h() {\n}\n");
    ASSERT_EQ(two.found.size(), 2U);
    EXPECT_TRUE(two.balanced);
    EXPECT_EQ(two.found[0].lines, 3);
    EXPECT_EQ(two.found[1].line, 5);
    EXPECT_FALSE(functions_of("void f() {\n").balanced);
}

}  // namespace
}  // namespace fulcrum::structure
