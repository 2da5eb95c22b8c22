// SPDX-License-Identifier: GPL-3.0-or-later
// The table of commands: parsing, help, manual page and completion.
#include "app/cli/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "app/lab/commands.h"
#include "app/services/program.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

CommandTable small_table() {
    const Option seed{"--seed", "N", "The seed.", "1"};
    const Option format{"--format", "FORMAT", "The kind of file.", "pdf", {"pdf", "csv"}};
    const Option output{"--output", "FILE", "The file.", "", {}, "-o"};
    const Option practice{"--practice", "", "For practice."};
    const auto run = [](const Arguments&) { return 0; };
    return CommandTable({{"perform", "TASK", 1, 1, "Performs.", {seed, practice}, run},
                         {"db check", "", 0, 0, "Checks.", {format, output}, run},
                         {"db backup", "TO", 1, 1, "Copies.", {practice}, run}},
                        "1.2.3");
}

std::string refusal(const std::vector<std::string>& words) {
    try {
        small_table().parse(words);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(CommandTable, ReadsOptionsInEveryWrittenForm) {
    const CommandTable table = small_table();
    EXPECT_EQ(table.parse({"perform", "--seed", "7", "A2"}).arguments.value("--seed"), "7");
    EXPECT_EQ(table.parse({"perform", "A2", "--seed=8"}).arguments.value("--seed"), "8");
    EXPECT_EQ(table.parse({"db", "check", "-o", "x"}).arguments.value("--output"), "x");
    EXPECT_EQ(table.parse({"db", "--output", "check", "check"}).arguments.value("--output"), "check");
    EXPECT_EQ(table.parse({"perform", "--", "--odd"}).arguments.words(), std::vector<std::string>{"--odd"});
    EXPECT_EQ(table.parse({"perform", "-"}).arguments.words(), std::vector<std::string>{"-"});
    EXPECT_TRUE(table.parse({"perform", "A2", "--practice"}).arguments.has("--practice"));
}

TEST(CommandTable, RefusesWrongLinesAndSuggestsTheNearestWord) {
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"preform", "A2"}, "did you mean perform?"},
        {{"perform", "A2", "--sed", "1"}, "did you mean --seed?"},
        {{"perform", "A2", "-s"}, "unknown option"},
        {{"db", "chek"}, "did you mean check?"},
        {{"db"}, "the action is missing"},
        {{"db", "check", "--format", "pfd"}, "did you mean pdf?"},
        {{"--hepl"}, "did you mean --help?"},
        {{"perform"}, "too few arguments"},
        {{"perform", "A2", "A3"}, "A3: unexpected argument"},
        {{"perform", ""}, "an argument is empty"},
        {{""}, "unknown command"},
        {{"perform", "A2", "--seed"}, "its argument is missing"},
        {{"perform", "A2", "--seed", ""}, "its argument is empty"},
        {{"perform", "A2", "--seed="}, "its argument is empty"},
        {{"perform", "A2", "--seed", "1", "--seed", "1"}, "given twice"},
        {{"db", "check", "-o", "x", "--output", "x"}, "given twice"},
        {{"perform", "A2", "--practice=yes"}, "takes no argument"},
        {{"perform", "A2", "--seed", "\xff\xfe"}, "argument 4: is not valid UTF-8"},
        {{"completion", "fish"}, "bash or zsh"},
        {{"help", "dance"}, "unknown command"},
    };
    for (const auto& [words, expected] : cases) {
        const std::string said = refusal(words);
        EXPECT_NE(said.find(expected), std::string::npos) << said;
        EXPECT_NE(said.find(';'), std::string::npos) << "no hint: " << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
    const std::string huge(100000, 'x');
    EXPECT_NE(refusal({huge}).find("unknown command"), std::string::npos);
}

TEST(CommandTable, HelpIsShownWhateverElseIsWrong) {
    const CommandTable table = small_table();
    for (const std::vector<std::string>& words : {std::vector<std::string>{"perform", "--help"},
                                                  {"perform", "-h"},
                                                  {"help", "perform"},
                                                  {"perform", "a", "b", "--help"}}) {
        const Invocation call = table.parse(words);
        EXPECT_EQ(call.command, nullptr);
        EXPECT_EQ(call.text, table.help("perform"));
    }
    EXPECT_EQ(table.parse({"--help"}).text, table.help());
    EXPECT_EQ(table.parse({"db", "--help"}).text, table.help("db"));
    EXPECT_EQ(table.parse({"help", "db", "check"}).text, table.help("db check"));
    EXPECT_EQ(table.parse({"--version"}).text, "fulcrum 1.2.3\n");
    EXPECT_NE(table.help("perform").find("Default: 1."), std::string::npos);
}

TEST(ProgramCommands, HelpManualAndCompletionNameEveryCommandAndOption) {
    const CommandTable& table = program_commands();
    std::string manual = table.manual();
    manual.erase(std::remove(manual.begin(), manual.end(), '\\'), manual.end());
    const std::string completion = table.completion("bash");
    std::set<std::string> names;
    for (const Command& command : table.commands()) {
        EXPECT_TRUE(names.insert(command.name).second) << command.name;
        EXPECT_FALSE(command.help.empty()) << command.name;
        EXPECT_NE(table.help().find(command.name), std::string::npos) << command.name;
        const std::size_t section = manual.find(".SS \"" + command.name);
        ASSERT_NE(section, std::string::npos) << command.name;
        const std::string in_manual = manual.substr(section, manual.find(".SS", section + 1) - section);
        const std::size_t branch = completion.find("    '" + command.name + "')");
        ASSERT_NE(branch, std::string::npos) << command.name;
        const std::string in_completion =
            completion.substr(branch, completion.find("fi ;;", branch) - branch);
        for (const Option& option : command.options) {
            const std::string where = command.name + " " + option.name;
            EXPECT_FALSE(option.help.empty()) << where;
            EXPECT_NE(table.help(command.name).find(option.name), std::string::npos) << where;
            EXPECT_NE(in_manual.find(option.name), std::string::npos) << where;
            EXPECT_NE(in_completion.find(option.name), std::string::npos) << where;
            if (!option.letter.empty()) {
                EXPECT_NE(in_manual.find(option.letter + ","), std::string::npos) << where;
            }
            for (const std::string& choice : option.choices)
                EXPECT_NE(in_completion.find(choice), std::string::npos) << where << ' ' << choice;
        }
    }
    EXPECT_GE(names.size(), 27U);
}

TEST(ProgramCommands, BashCompletesFromTheScript) {
    const test::OwnFolder folder;
    const std::string file = folder / "completion.bash";
    std::ofstream(file) << program_commands().completion("bash");
    const auto completed = [&](const std::string& line) {
        const std::string command =
            "bash -c 'source " + file + "; COMP_WORDS=(" + line +
            "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _fulcrum; echo ${COMPREPLY[*]}'";
        FILE* const pipe = popen(command.c_str(), "r");
        char text[4096] = {};
        const std::size_t size = fread(text, 1, sizeof text - 1, pipe);
        EXPECT_EQ(pclose(pipe), 0) << line;
        return std::string(text, size);
    };
    EXPECT_EQ(completed("fulcrum per"), "perform\n");
    EXPECT_EQ(completed("fulcrum db ba"), "backup\n");
    EXPECT_EQ(completed("fulcrum db audit --un"), "--until\n");
    EXPECT_EQ(completed("fulcrum report --format \"\""), "pdf csv xlsx json xapi trace\n");
    EXPECT_EQ(completed("fulcrum perform A2 --operator nov"), "novice\n");
    EXPECT_EQ(completed("fulcrum --ver"), "--version\n");
}

TEST(ProgramCommands, EveryCommandHasCodeHereOrInTheLaboratory) {
    const CommandTable laboratory = laboratory_table();
    std::set<std::string> in_laboratory;
    for (const Command& command : laboratory.commands())
        if (command.run != nullptr) in_laboratory.insert(command.name);
    int passed_on = 0;
    for (const Command& command : program_commands().commands()) {
        if (command.program.empty()) continue;
        EXPECT_EQ(command.program, "fulcrum-lab") << command.name;
        EXPECT_EQ(in_laboratory.count(command.name), 1U) << command.name;
        ++passed_on;
    }
    EXPECT_GE(passed_on, 10);
}

}  // namespace
}  // namespace fulcrum::app
