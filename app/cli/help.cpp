// SPDX-License-Identifier: GPL-3.0-or-later
// Help, manual page and shell completion, written from the table of commands.
#include <algorithm>
#include <sstream>

#include "app/cli/command.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t width = 79;

/// `text` in lines of at most `width`, every line after the first indented.
std::string wrapped(const std::string& text, std::size_t indent) {
    std::istringstream words(text);
    std::string result;
    std::size_t column = indent;
    for (std::string word; words >> word;) {
        if (!result.empty() && column + word.size() + 1 > width) {
            result += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (!result.empty()) {
            result += ' ';
            ++column;
        }
        result += word;
        column += word.size();
    }
    return result;
}

std::string row(const std::string& left, const std::string& text, std::size_t indent) {
    std::string line = "  " + left;
    line +=
        line.size() + 2 > indent ? "\n" + std::string(indent, ' ') : std::string(indent - line.size(), ' ');
    return line + wrapped(text, indent) + "\n";
}

std::string written(const Option& option) {
    return (option.letter.empty() ? "" : option.letter + ", ") + option.name +
           (option.argument.empty() ? "" : " " + option.argument);
}

std::string explained(const Option& option) {
    std::string text = option.help;
    if (!option.choices.empty()) {
        text += " One of";
        for (std::size_t i = 0; i < option.choices.size(); ++i)
            text += (i == 0 ? " " : ", ") + option.choices[i];
        text += ".";
    }
    if (!option.fallback.empty()) text += " Default: " + option.fallback + ".";
    return text;
}

std::string help_of(const Command& command) {
    std::string text = "usage: " + command.usage() + "\n\n" + wrapped(command.help, 0) + "\n";
    if (!command.details.empty()) text += "\n" + wrapped(command.details, 0) + "\n";
    text += "\noptions:\n";
    for (const Option& option : command.options) text += row(written(option), explained(option), 28);
    return text;
}

std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else if ((c == '.' || c == '\'') && result.empty()) {
            result += "\\&";
            result += c;
        } else {
            result += c;
        }
    }
    return result;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

const char* const exit_statuses =
    "0: success. 1: the command failed, or a check found an error. 2: wrong usage or invalid input; one line "
    "on standard error says what is wrong, where, and what to do.";

/// The case branch that completes one command.
std::string completion_of(const Command& command) {
    std::vector<std::string> flags;
    std::string branch = "    '" + command.name + "')\n        case \"$previous\" in\n";
    for (const Option& option : command.options) {
        flags.push_back(option.name);
        if (option.argument.empty()) continue;
        const std::string pattern = option.name + (option.letter.empty() ? "" : "|" + option.letter);
        const std::string reply = "$(compgen -W '" + joined(option.choices, " ") + "' -- \"$current\")";
        branch +=
            "        " + pattern + ") COMPREPLY=(" + (option.choices.empty() ? "" : reply) + "); return ;;\n";
    }
    const std::string words = command.name == "completion" ? "bash zsh" : "";
    branch += "        esac\n        if [[ $current == -* ]]; then\n            COMPREPLY=($(compgen -W '" +
              joined(flags, " ") + "' -- \"$current\"))\n";
    if (!words.empty())
        branch += "        else\n            COMPREPLY=($(compgen -W '" + words + "' -- \"$current\"))\n";
    return branch + "        fi ;;\n";
}

}  // namespace

std::string CommandTable::help() const {
    std::string text =
        "usage: fulcrum [--db STORE]         the application; STORE: a file, or a programme server's "
        "address\n"
        "       fulcrum COMMAND [options]    one command, without the window\n\n"
        "commands:\n";
    for (const Command& command : commands_)
        text += row(command.name + (command.words.empty() ? "" : " " + command.words), command.help, 32);
    text += "\nfulcrum COMMAND --help shows a command's options, fulcrum --version the version.\n";
    return text + "exit status: " + wrapped(exit_statuses, 13) + "\n";
}

std::string CommandTable::help(const std::string& name) const {
    if (const Command* const command = find(name)) return help_of(*command);
    if (!is_group(name)) {
        const std::string near = nearest(name, names());
        throw UsageError(
            name, QT_TRANSLATE_NOOP("errors", "unknown command"),
            near.empty()
                ? Sentence(QT_TRANSLATE_NOOP("errors", "see fulcrum --help"))
                : Sentence(QT_TRANSLATE_NOOP("errors", "did you mean %1? see fulcrum --help"), near));
    }
    std::string text = "usage: fulcrum " + name + " ACTION [options]\n\nactions:\n";
    for (const Command& command : commands_) {
        if (command.name.rfind(name + " ", 0) == 0)
            text +=
                row(command.name.substr(name.size() + 1) + (command.words.empty() ? "" : " " + command.words),
                    command.help, 32);
    }
    return text + "\nfulcrum " + name + " ACTION --help shows an action's options.\n";
}

std::string CommandTable::manual() const {
    std::string text =
        ".TH FULCRUM 1 \"\" \"fulcrum " + roff(version_) +
        "\" \"User Commands\"\n.SH NAME\nfulcrum \\- trainer "
        "for laparoscopic bowel surgery\n.SH SYNOPSIS\n.B fulcrum\n[\\-\\-db STORE]\n.br\n.B fulcrum\n.I "
        "COMMAND\n[options]\n"
        ".SH DESCRIPTION\nWithout a command the window opens, with the store STORE (a file, or the address "
        "of a "
        "programme server, which is only read). With a command the program runs it without a "
        "window.\nEvery command that takes \\fB\\-\\-json\\fR prints one JSON document on standard output "
        "and "
        "everything else on standard error.\n.SH COMMANDS\n";
    for (const Command& command : commands_) {
        text += ".SS \"" + roff(command.name) + (command.words.empty() ? "" : " " + roff(command.words)) +
                "\"\n" + roff(command.help) + "\n";
        if (!command.details.empty()) text += ".PP\n" + roff(command.details) + "\n";
        for (const Option& option : command.options)
            text += ".TP\n.B " + roff(written(option)) + "\n" + roff(explained(option)) + "\n";
    }
    return text + ".SH OPTIONS\n.TP\n.B \\-\\-version\nPrint the version and exit.\n.SH EXIT STATUS\n" +
           roff(exit_statuses) +
           "\n.SH ENVIRONMENT\n.TP\n.B FULCRUM_DATA\nFolder of the window's stores.\n.TP\n.B "
           "FULCRUM_ASSETS\nFolder of tasks, scenes and benchmarks, if it is not next to the program.\n";
}

std::string CommandTable::completion(const std::string& shell) const {
    if (shell != "bash" && shell != "zsh")
        throw UsageError(shell, QT_TRANSLATE_NOOP("errors", "no completion for this shell"),
                         QT_TRANSLATE_NOOP("errors", "use bash or zsh"));
    std::string text =
        shell == "zsh" ? "#compdef fulcrum\nautoload -U +X bashcompinit && bashcompinit\n" : "";
    text +=
        "_fulcrum() {\n    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
        "    local command=${COMP_WORDS[1]}\n    COMPREPLY=()\n    if ((COMP_CWORD == 1)); then\n"
        "        COMPREPLY=($(compgen -W '" +
        joined(names(), " ") +
        " --help --version' -- \"$current\"))\n        return\n    fi\n    case $command in\n";
    for (const std::string& name : names()) {
        if (!is_group(name)) continue;
        text += "    " + name +
                ")\n        if ((COMP_CWORD == 2)); then\n            COMPREPLY=($(compgen -W '" +
                joined(names_in(name), " ") + " --help' -- \"$current\"))\n            return\n        fi\n" +
                "        command=\"$command ${COMP_WORDS[2]}\" ;;\n";
    }
    text += "    esac\n    case $command in\n";
    for (const Command& command : commands_) text += completion_of(command);
    return text + "    esac\n}\ncomplete -o bashdefault -o default -F _fulcrum fulcrum\n";
}

}  // namespace fulcrum::app
