// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

namespace fulcrum::app {
namespace {

const Option help_option{"--help", "", QT_TRANSLATE_NOOP("commands", "Print this help and exit."),
                         "",       {}, "-h"};

std::string group_of(const std::string& name) {
    const std::size_t space = name.find(' ');
    return space == std::string::npos ? "" : name.substr(0, space);
}

bool is_utf8(const std::string& text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const auto first = static_cast<unsigned char>(text[at]);
        const std::size_t length = first < 0x80       ? 1
                                   : first >> 5 == 6  ? 2
                                   : first >> 4 == 14 ? 3
                                   : first >> 3 == 30 ? 4
                                                      : 0;
        if (length == 0 || at + length > text.size()) return false;
        for (std::size_t i = 1; i < length; ++i)
            if ((static_cast<unsigned char>(text[at + i]) & 0xC0) != 0x80) return false;
        at += length;
    }
    return true;
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
            diagonal = above;
        }
    }
    return row.back();
}

/// `hint`, after the nearest known word where there is one.
Sentence did_you_mean(const std::string& word, const std::vector<std::string>& known, const Sentence& hint) {
    const std::string near = nearest(word, known);
    return near.empty() ? hint : Sentence(QT_TRANSLATE_NOOP("errors", "did you mean %1? %2"), near, hint);
}

void require_utf8(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!is_utf8(words[i]))
            throw UsageError({QT_TRANSLATE_NOOP("errors", "argument %1"), i + 1},
                             QT_TRANSLATE_NOOP("errors", "is not valid UTF-8"),
                             QT_TRANSLATE_NOOP("errors", "write it, and names of files, in UTF-8"));
    }
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& known) {
    if (word.size() > 40) return {};
    std::string best;
    std::size_t least = word.size() < 3 ? 2 : std::max<std::size_t>(2, word.size() / 3) + 1;
    for (const std::string& one : known) {
        const std::size_t distance = edit_distance(word, one);
        if (distance < least) {
            least = distance;
            best = one;
        }
    }
    if (!best.empty()) return best;
    for (const std::string& one : known)  // an abbreviation
        if (word.size() > 3 && one.rfind(word, 0) == 0) return one;
    return {};
}

const Option* Command::option(const std::string& word) const {
    for (const Option& one : options)
        if (one.name == word || (!one.letter.empty() && one.letter == word)) return &one;
    return nullptr;
}

Sentence Command::usage() const {
    return words.empty() ? Sentence(QT_TRANSLATE_NOOP("commands", "fulcrum %1 [options]"), name)
                         : Sentence(QT_TRANSLATE_NOOP("commands", "fulcrum %1 %2 [options]"), name,
                                    placeholders(words));
}

bool Command::is_laboratory() const {
    return group_of(name) == "lab";
}

namespace {

/// Replaces this process by the command's program with the same words. Throws UsageError if it is not there.
int start(const Command& command, std::vector<std::string> words) {
    std::string path =
        (std::filesystem::read_symlink("/proc/self/exe").parent_path() / command.program).string();
    std::vector<char*> arguments = {path.data()};
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::cout.flush();
    execv(path.c_str(), arguments.data());
    throw UsageError(command.name,
                     {QT_TRANSLATE_NOOP("errors", "needs the program '%1', which is missing"), path},
                     QT_TRANSLATE_NOOP("errors", "build the laboratory: ./run laboratory"));
}

}  // namespace

int Invocation::run() const {
    if (command != nullptr)
        return command->program.empty() ? command->run(arguments) : start(*command, given);
    std::cout << text;
    return 0;
}

CommandTable::CommandTable(std::vector<Command> commands, std::string version)
    : commands_(std::move(commands)), version_(std::move(version)) {
    commands_.push_back(
        {"completion",
         "SHELL",
         1,
         1,
         QT_TRANSLATE_NOOP("commands", "Prints a completion script for bash or zsh."),
         {},
         {},
         false,
         QT_TRANSLATE_NOOP(
             "commands",
             "For bash: fulcrum completion bash > ~/.local/share/bash-completion/completions/fulcrum")});
    commands_.push_back(
        {"help",
         "[COMMAND]",
         0,
         2,
         QT_TRANSLATE_NOOP("commands", "Prints what the commands do, or one command's options."),
         {},
         {}});
    commands_.push_back(
        {"manual",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP("commands", "Prints the manual page."),
         {},
         {},
         false,
         QT_TRANSLATE_NOOP("commands", "To read it: fulcrum manual > fulcrum.1; man ./fulcrum.1")});
    for (Command& command : commands_) command.options.push_back(help_option);
}

const Command* CommandTable::find(const std::string& name) const {
    for (const Command& command : commands_)
        if (command.name == name) return &command;
    return nullptr;
}

bool CommandTable::is_group(const std::string& name) const {
    return !name.empty() && std::any_of(commands_.begin(), commands_.end(), [&](const Command& command) {
        return group_of(command.name) == name;
    });
}

std::vector<std::string> CommandTable::names() const {
    std::set<std::string> names;
    for (const Command& command : commands_)
        names.insert(group_of(command.name).empty() ? command.name : group_of(command.name));
    return {names.begin(), names.end()};
}

std::vector<std::string> CommandTable::names_in(const std::string& group) const {
    std::vector<std::string> actions;
    for (const Command& command : commands_)
        if (group_of(command.name) == group) actions.push_back(command.name.substr(group.size() + 1));
    return actions;
}

/// Takes the group and its action out of `words`; options may precede the action.
std::string CommandTable::action_of(std::vector<std::string>& words) const {
    const std::string group = words[0];
    const std::vector<std::string> actions = names_in(group);
    std::string list;
    for (const std::string& action : actions) list += (list.empty() ? "" : ", ") + action;
    std::size_t at = 1;
    for (; at < words.size() && words[at].size() > 1 && words[at][0] == '-'; ++at) {
        const bool takes_argument =
            std::any_of(commands_.begin(), commands_.end(), [&](const Command& command) {
                const Option* const option =
                    group_of(command.name) == group ? command.option(words[at]) : nullptr;
                return option != nullptr && !option->argument.empty();
            });
        if (words[at] == "--help" || words[at] == "-h") return group;
        if (takes_argument) ++at;
    }
    if (at >= words.size())
        throw UsageError(group, QT_TRANSLATE_NOOP("errors", "the action is missing"),
                         {QT_TRANSLATE_NOOP("errors", "use one of %1"), list});
    if (std::find(actions.begin(), actions.end(), words[at]) == actions.end())
        throw UsageError(
            group + " " + words[at], QT_TRANSLATE_NOOP("errors", "unknown action"),
            did_you_mean(words[at], actions, {QT_TRANSLATE_NOOP("errors", "use one of %1"), list}));
    const std::string name = group + " " + words[at];
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
    words.erase(words.begin());
    return name;
}

Invocation CommandTable::parse(const std::vector<std::string>& given) const {
    require_utf8(given);
    std::vector<std::string> words = given;
    const std::string first = words.at(0);
    if (first == "--help" || first == "-h") return {nullptr, {}, help()};
    if (first == "--version") return {nullptr, {}, "fulcrum " + version_ + "\n"};
    std::string name = first;
    if (is_group(first)) {
        name = action_of(words);
        if (name == first) return {nullptr, {}, help(name)};
    } else {
        words.erase(words.begin());
    }
    const Command* const command = find(name);
    if (command == nullptr) {
        std::vector<std::string> known = names();
        const bool option = first.rfind('-', 0) == 0;
        if (option) known = {"--help", "--version"};
        throw UsageError(first.empty() ? "''" : first,
                         option ? Sentence(QT_TRANSLATE_NOOP("errors", "unknown option"))
                                : Sentence(QT_TRANSLATE_NOOP("errors", "unknown command")),
                         did_you_mean(first, known, QT_TRANSLATE_NOOP("errors", "see fulcrum --help")));
    }
    Invocation call{command, Arguments(words, *command), {}};
    const std::vector<std::string>& rest = call.arguments.words();
    if (call.arguments.wants_help()) return {nullptr, {}, help(name)};
    if (name == "manual") return {nullptr, {}, manual()};
    if (name == "completion") return {nullptr, {}, completion(rest[0])};
    if (name == "help")
        return {
            nullptr, {}, rest.empty() ? help() : help(rest.size() == 2 ? rest[0] + " " + rest[1] : rest[0])};
    call.given = given;
    return call;
}

}  // namespace fulcrum::app
