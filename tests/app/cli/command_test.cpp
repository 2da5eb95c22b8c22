// SPDX-License-Identifier: GPL-3.0-or-later
// The table of commands: parsing, help, manual page and completion.
#include "app/cli/command.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QString>
#include <QXmlStreamReader>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "app/lab/commands.h"
#include "app/services/controller_trial.h"
#include "app/services/program.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"
#include "ui/language/language.h"

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

/// Texts are in German during its lifetime.
struct GermanHelp {
    GermanHelp() { ui::use_language(ui::Language::german); }
    ~GermanHelp() { ui::use_language(ui::Language::english); }
    GermanHelp(const GermanHelp&) = delete;
    GermanHelp& operator=(const GermanHelp&) = delete;
};

/// The texts of commands that have a German translation.
std::set<std::string> translated_texts() {
    QFile file(QString::fromStdString(test::source_path("ui/style/translations/fulcrum_de.ts")));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    std::set<std::string> texts;
    std::string context, source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) context = xml.readElementText().toStdString();
        if (xml.name() == QLatin1String("source")) source = xml.readElementText().toStdString();
        if (xml.name() == QLatin1String("translation") && context == "commands" &&
            !xml.attributes().hasAttribute(QLatin1String("type")))
            texts.insert(source);
    }
    return texts;
}

/// The sources in a sentence that have letters, without places of other sentences.
void collect_sources(const Sentence& sentence, std::vector<std::string>& found) {
    const bool letters = std::any_of(sentence.source().begin(), sentence.source().end(),
                                     [](unsigned char c) { return std::isalpha(c) != 0; });
    if (sentence.marked() && letters) found.push_back(sentence.source());
    for (const Sentence& part : sentence.parts()) collect_sources(part, found);
}

/// A text of the table has its translation; every word in capitals as well, unless it is a unit or a part of
/// an address.
void expect_translated(const std::set<std::string>& known, const Sentence& text, const std::string& where) {
    std::vector<std::string> sources;
    collect_sources(text, sources);
    for (const std::string& source : sources)
        EXPECT_EQ(known.count(source), 1U) << where << ": \"" << source << '"';
}
void expect_translated_words(const std::set<std::string>& known, const std::string& words,
                             const std::string& where) {
    const std::set<std::string> same = {"HOST", "PORT", "HZ", "N", "Q", "S", ""};
    expect_translated(known, placeholders(words), where);
    std::string word;
    for (const char c : words + " ") {
        if (c >= 'A' && c <= 'Z') {
            word += c;
            continue;
        }
        EXPECT_TRUE(same.count(word) != 0 || known.count(word) != 0) << where << ": " << word;
        word.clear();
    }
}

TEST(ProgramCommands, EveryTextOfTheHelpHasAGermanTranslation) {
    const std::set<std::string> known = translated_texts();
    const std::set<std::string> values = {"1",
                                          "5",
                                          "20",
                                          "30",
                                          "60",
                                          "500",
                                          "pdf",
                                          "raw",
                                          "out",
                                          "week",
                                          "haptic",
                                          "expert",
                                          "standard",
                                          "127.0.0.1:18944",
                                          "LeftTipToPatient",
                                          "RightTipToPatient",
                                          "CameraToPatient"};
    int options = 0;
    for (const Command& command : program_commands().commands()) {
        if (command.is_laboratory()) continue;
        expect_translated(known, command.help, command.name);
        expect_translated(known, command.details, command.name);
        expect_translated_words(known, command.words, command.name);
        for (const Option& option : command.options) {
            ++options;
            const std::string where = command.name + " " + option.name;
            expect_translated(known, option.help, where);
            expect_translated_words(known, option.argument, where);
            if (values.count(option.fallback.source()) == 0) expect_translated(known, option.fallback, where);
        }
    }
    EXPECT_GT(options, 150);
}

TEST(ProgramCommands, GermanHelpHasAlignedColumns) {
    const CommandTable& table = program_commands();
    const std::string english = table.help("perform"), laboratory = table.help("lab bench"),
                      laboratory_actions = table.help("lab");
    const GermanHelp german;
    EXPECT_NE(table.help("perform"), english);
    EXPECT_EQ(table.help("lab bench"), laboratory) << "the laboratory stays in English";
    EXPECT_EQ(table.help("lab"), laboratory_actions);
    int umlauts = 0;
    for (const Command& command : table.commands()) {
        if (command.is_laboratory()) continue;
        const QStringList lines = QString::fromStdString(table.help(command.name)).split(QLatin1Char('\n'));
        EXPECT_EQ(lines[0].left(16), QStringLiteral("Aufruf: fulcrum ")) << command.name;
        const int heading = lines.indexOf(QStringLiteral("Optionen:"));
        ASSERT_GT(heading, 0) << command.name;
        for (int i = heading + 1; i + 1 < lines.size(); ++i) {
            const QString& line = lines[i];
            const std::string where = command.name + ": " + line.toStdString();
            EXPECT_LE(line.size(), 79) << where;
            const bool long_name = line.startsWith(QLatin1String("  -")) && line.size() <= 40 &&
                                   !line.mid(2).contains(QLatin1String("  ")) &&
                                   lines[i + 1].startsWith(QString(28, QLatin1Char(' ')));
            if (long_name && line.size() > 26) continue;
            ASSERT_GT(line.size(), 28) << where;
            EXPECT_EQ(line.mid(26, 2), QStringLiteral("  ")) << where;
            EXPECT_NE(line[28], QLatin1Char(' ')) << where;
            EXPECT_TRUE(line.startsWith(QLatin1String("  -")) || line.left(28).trimmed().isEmpty()) << where;
            umlauts += line.contains(QChar(0x00fc)) || line.contains(QChar(0x00e4));
        }
    }
    EXPECT_GT(umlauts, 30);
}

TEST(ProgramCommands, NumbersInTheWordsOfTheHelpHaveTheDecimalSignOfItsLanguage) {
    static const std::regex with_point(R"([0-9]\.[0-9]+\s+(ms|%))"), with_comma(R"([0-9],[0-9]+\s+(ms|%))");
    const auto count = [](const std::string& text, const std::regex& number) {
        return std::distance(std::sregex_iterator(text.begin(), text.end(), number), {});
    };
    const CommandTable& table = program_commands();
    const std::string english = table.help("perform");
    EXPECT_GT(count(english, with_point), 4);
    EXPECT_EQ(count(english, with_comma), 0);
    const GermanHelp german;
    EXPECT_EQ(count(table.help("perform"), with_comma), count(english, with_point));
    EXPECT_EQ(count(table.help("perform"), with_point), 0);
}

TEST(CommandTable, EnglishHelpIsAsWrittenInTheTable) {
    EXPECT_EQ(small_table().help("perform"),
              "usage: fulcrum perform TASK [options]\n\nPerforms.\n\noptions:\n"
              "  --seed N                  The seed. Default: 1.\n"
              "  --practice                For practice.\n"
              "  -h, --help                Print this help and exit.\n");
    EXPECT_EQ(small_table().help("db").substr(0, 77),
              "usage: fulcrum db ACTION [options]\n\nactions:\n  check                         ");
    EXPECT_EQ(refusal({"perform"}), "perform: too few arguments; usage: fulcrum perform TASK [options]");
    EXPECT_EQ(refusal({"db", "check", "-o"}),
              "-o: its argument is missing; write -o FILE; see fulcrum db check --help");
}

TEST(CommandTable, WrapsHelpByCharactersNotBytes) {
    std::string words;
    for (int i = 0; i < 21; ++i) words += (i == 0 ? "" : " ") + std::string("\u00e4\u00f6\u00fc");
    const CommandTable table({{"perform", "", 0, 0, words, {}, [](const Arguments&) { return 0; }}}, "1");
    const QStringList lines = QString::fromStdString(table.help("perform")).split(QLatin1Char('\n'));
    EXPECT_EQ(lines[2].size(), 79);
    EXPECT_EQ(lines[3].size(), 3);
}

TEST(CommandTable, OnlyKnownWordsInCapitalsAreTranslated) {
    const GermanHelp german;
    const std::pair<const char*, const char*> cases[] = {{"TRACE.csv", "AUFZEICHNUNG.csv"},
                                                         {"LOGIN,LOGIN,...", "ANMELDENAME,ANMELDENAME,..."},
                                                         {"[HOST:PORT]", "[HOST:PORT]"},
                                                         {"FILENAME", "FILENAME"},
                                                         {"", ""}};
    for (const auto& [english, expected] : cases)
        EXPECT_EQ(placeholders(english).words(help_words), expected);
}

TEST(ProgramCommands, PrintTheTestOfAControllerInTheReadersLanguage) {
    ControllerTrial trial;
    trial.name = "Pad";
    trial.rate = 250;
    trial.in_middle[1] = true;
    trial.buttons = 3;
    const auto printed = [&] {
        std::ostringstream output;
        std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
        print_controller(trial);
        std::cout.rdbuf(before);
        return output.str();
    };
    EXPECT_EQ(
        printed(),
        "Pad\nrate: 250.0 readings a second; longest gap 0.0 ms\n"
        "left stick: 0 to 0 % to the right, 0 to 0 % up; never in its middle: it moves nothing; trigger up "
        "to 0 %\n"
        "right stick: 0 to 0 % to the right, 0 to 0 % up; trigger up to 0 %\n"
        "buttons pressed: south, east\n");
    const GermanHelp german;
    EXPECT_EQ(
        printed(),
        "Pad\nRate: 250.0 Messwerte je Sekunde; l\u00e4ngste L\u00fccke 0.0 ms\n"
        "linker Stick: 0 bis 0 % nach rechts, 0 bis 0 % nach oben; nie in der Mitte: er bewegt nichts; Abzug "
        "bis 0 %\n"
        "rechter Stick: 0 bis 0 % nach rechts, 0 bis 0 % nach oben; Abzug bis 0 %\n"
        "gedr\u00fcckte Tasten: unten, rechts\n");
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
