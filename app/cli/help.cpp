// SPDX-License-Identifier: GPL-3.0-or-later
// Help, manual page and shell completion, written from the table of commands.
#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <sstream>

#include "app/cli/command.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t width = 79, usage_width = 29;

/// In the reader's language; a command of the laboratory in English.
std::string text_of(const Sentence& sentence, Translate translate = help_words) {
    return sentence.words(translate);
}
Translate language_of(const Command& command) {
    return command.is_laboratory() ? in_english : help_words;
}

/// Characters of UTF-8, each as wide as a column.
std::size_t columns(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t to) {
    return text + std::string(to - std::min(to, columns(text)), ' ');
}

/// `text` in lines of at most `width`, every line after the first indented.
std::string wrapped(const std::string& text, std::size_t indent) {
    std::istringstream words(text);
    std::string result;
    std::size_t column = indent;
    for (std::string word; words >> word;) {
        if (!result.empty() && column + columns(word) + 1 > width) {
            result += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (!result.empty()) {
            result += ' ';
            ++column;
        }
        result += word;
        column += columns(word);
    }
    return result;
}

std::string row(const std::string& left, const std::string& text, std::size_t indent) {
    std::string line = "  " + left;
    line = columns(line) + 2 > indent ? line + "\n" + std::string(indent, ' ') : padded(line, indent);
    return line + wrapped(text, indent) + "\n";
}

std::string written(const Option& option, Translate translate) {
    return (option.letter.empty() ? "" : option.letter + ", ") + option.name +
           (option.argument.empty() ? "" : " " + text_of(placeholders(option.argument), translate));
}

/// The name from its character `from` on, and what follows it.
std::string written(const Command& command, std::size_t from = 0) {
    return command.name.substr(from) +
           (command.words.empty() ? "" : " " + text_of(placeholders(command.words), language_of(command)));
}

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

std::string explained(const Option& option, Translate translate) {
    std::string text = text_of(option.help, translate);
    if (!option.choices.empty())
        text += " " + text_of({QT_TRANSLATE_NOOP("commands", "One of %1."), joined(option.choices, ", ")},
                              translate);
    if (!option.fallback.empty())
        text += " " + text_of({QT_TRANSLATE_NOOP("commands", "Default: %1."), option.fallback}, translate);
    return text;
}

/// What stands for a word of the reader. Others (N, HOST, HZ) are the same in every language.
constexpr const char* placeholder_words[] = {
    QT_TRANSLATE_NOOP("commands", "ADDRESS"), QT_TRANSLATE_NOOP("commands", "ATTEMPT"),
    QT_TRANSLATE_NOOP("commands", "CLASS"),   QT_TRANSLATE_NOOP("commands", "CODE"),
    QT_TRANSLATE_NOOP("commands", "COHORT"),  QT_TRANSLATE_NOOP("commands", "COMMAND"),
    QT_TRANSLATE_NOOP("commands", "DEVICE"),  QT_TRANSLATE_NOOP("commands", "EVENTS"),
    QT_TRANSLATE_NOOP("commands", "FILE"),    QT_TRANSLATE_NOOP("commands", "FINGERPRINT"),
    QT_TRANSLATE_NOOP("commands", "FOLDER"),  QT_TRANSLATE_NOOP("commands", "FORMAT"),
    QT_TRANSLATE_NOOP("commands", "FROM"),    QT_TRANSLATE_NOOP("commands", "HEAD"),
    QT_TRANSLATE_NOOP("commands", "ID"),      QT_TRANSLATE_NOOP("commands", "INTO"),
    QT_TRANSLATE_NOOP("commands", "KIND"),    QT_TRANSLATE_NOOP("commands", "HAND"),
    QT_TRANSLATE_NOOP("commands", "LEVEL"),   QT_TRANSLATE_NOOP("commands", "LIST"),
    QT_TRANSLATE_NOOP("commands", "LOGIN"),   QT_TRANSLATE_NOOP("commands", "MAPPING"),
    QT_TRANSLATE_NOOP("commands", "NAME"),    QT_TRANSLATE_NOOP("commands", "NEW"),
    QT_TRANSLATE_NOOP("commands", "PATH"),    QT_TRANSLATE_NOOP("commands", "PERSON"),
    QT_TRANSLATE_NOOP("commands", "RATINGS"), QT_TRANSLATE_NOOP("commands", "ROLE"),
    QT_TRANSLATE_NOOP("commands", "RULE"),    QT_TRANSLATE_NOOP("commands", "SCALE"),
    QT_TRANSLATE_NOOP("commands", "SHELL"),   QT_TRANSLATE_NOOP("commands", "TASK"),
    QT_TRANSLATE_NOOP("commands", "TEXT"),    QT_TRANSLATE_NOOP("commands", "TIME"),
    QT_TRANSLATE_NOOP("commands", "TO"),      QT_TRANSLATE_NOOP("commands", "TOKEN"),
    QT_TRANSLATE_NOOP("commands", "TRACE"),   QT_TRANSLATE_NOOP("commands", "VALUES"),
    QT_TRANSLATE_NOOP("commands", "VERSION")};

const char* const usage_heading = QT_TRANSLATE_NOOP("commands", "usage:");

std::string help_of(const Command& command) {
    const Translate translate = language_of(command);
    std::string text = text_of(usage_heading, translate) + " " + text_of(command.usage(), translate) +
                       "\n\n" + wrapped(text_of(command.help, translate), 0) + "\n";
    if (!command.details.empty()) text += "\n" + wrapped(text_of(command.details, translate), 0) + "\n";
    text += "\n" + text_of(QT_TRANSLATE_NOOP("commands", "options:"), translate) + "\n";
    for (const Option& option : command.options)
        text += row(written(option, translate), explained(option, translate), 28);
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

const char* const exit_statuses =
    QT_TRANSLATE_NOOP("commands",
                      "0: success. 1: the command failed, or a check found an error. 2: wrong usage or "
                      "invalid input; one line on standard error says what is wrong, where, and what to do.");

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

std::string help_words(const char* /*context*/, const char* source) {
    return QCoreApplication::translate("commands", source).toStdString();
}

Sentence placeholders(const std::string& text) {
    const auto capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    std::string source;
    std::vector<Sentence> parts;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && capital(text[end])) ++end;
        const std::string word = text.substr(at, end - at);
        if (std::find(std::begin(placeholder_words), std::end(placeholder_words), word) !=
            std::end(placeholder_words)) {
            parts.push_back(Sentence::from_parts(word, true, {}));
            source += "%" + std::to_string(parts.size());
        } else {
            source += word.empty() ? text.substr(end++, 1) : word;
        }
        at = end;
    }
    return Sentence::from_parts(source, false, parts);
}

std::string CommandTable::help() const {
    const std::string usage = text_of(usage_heading) + " ";
    std::string text =
        usage + padded(text_of(QT_TRANSLATE_NOOP("commands", "fulcrum [--db STORE]")), usage_width) +
        text_of(QT_TRANSLATE_NOOP("commands",
                                  "the application; STORE: a file, or a programme server's address")) +
        "\n" + std::string(columns(usage), ' ') +
        padded(text_of(QT_TRANSLATE_NOOP("commands", "fulcrum COMMAND [options]")), usage_width) +
        text_of(QT_TRANSLATE_NOOP("commands", "one command, without the window")) + "\n\n" +
        text_of(QT_TRANSLATE_NOOP("commands", "commands:")) + "\n";
    for (const Command& command : commands_)
        text += row(written(command), text_of(command.help, language_of(command)), 32);
    text +=
        "\n" +
        text_of(QT_TRANSLATE_NOOP(
            "commands", "fulcrum COMMAND --help shows a command's options, fulcrum --version the version.")) +
        "\n";
    const std::string status = text_of(QT_TRANSLATE_NOOP("commands", "exit status:")) + " ";
    return text + status + wrapped(text_of(exit_statuses), columns(status)) + "\n";
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
    const Translate translate = name == "lab" ? in_english : help_words;
    std::string text =
        text_of(usage_heading, translate) + " " +
        text_of({QT_TRANSLATE_NOOP("commands", "fulcrum %1 ACTION [options]"), name}, translate) + "\n\n" +
        text_of(QT_TRANSLATE_NOOP("commands", "actions:"), translate) + "\n";
    for (const Command& command : commands_) {
        if (command.name.rfind(name + " ", 0) == 0)
            text += row(written(command, name.size() + 1), text_of(command.help, translate), 32);
    }
    return text + "\n" +
           text_of(
               {QT_TRANSLATE_NOOP("commands", "fulcrum %1 ACTION --help shows an action's options."), name},
               translate) +
           "\n";
}

std::string CommandTable::manual() const {
    const auto section = [](const char* heading) { return ".SH " + text_of(heading) + "\n"; };
    std::string text =
        ".TH FULCRUM 1 \"\" \"fulcrum " + roff(version_) + "\" \"" +
        text_of(QT_TRANSLATE_NOOP("commands", "User Commands")) + "\"\n" +
        section(QT_TRANSLATE_NOOP("commands", "NAME")) + "fulcrum \\- " +
        roff(text_of(QT_TRANSLATE_NOOP("commands", "trainer for laparoscopic bowel surgery"))) + "\n" +
        section(QT_TRANSLATE_NOOP("commands", "SYNOPSIS")) + ".B fulcrum\n" +
        roff(text_of(QT_TRANSLATE_NOOP("commands", "[--db STORE]"))) + "\n.br\n.B fulcrum\n.I " +
        text_of(placeholders("COMMAND")) + "\n" + text_of(QT_TRANSLATE_NOOP("commands", "[options]")) + "\n" +
        section(QT_TRANSLATE_NOOP("commands", "DESCRIPTION")) +
        roff(text_of(QT_TRANSLATE_NOOP(
            "commands",
            "Without a command the window opens, with the store STORE (a file, or the address of a programme "
            "server, which is only read). With a command the program runs it without a window."))) +
        "\n" +
        text_of({QT_TRANSLATE_NOOP("commands",
                                   "Every command that takes %1 prints one JSON document on standard output "
                                   "and everything else on standard error."),
                 std::string("\\fB\\-\\-json\\fR")}) +
        "\n" + section(QT_TRANSLATE_NOOP("commands", "COMMANDS"));
    for (const Command& command : commands_) {
        const Translate translate = language_of(command);
        text += ".SS \"" + roff(written(command)) + "\"\n" + roff(text_of(command.help, translate)) + "\n";
        if (!command.details.empty()) text += ".PP\n" + roff(text_of(command.details, translate)) + "\n";
        for (const Option& option : command.options)
            text += ".TP\n.B " + roff(written(option, translate)) + "\n" +
                    roff(explained(option, translate)) + "\n";
    }
    return text + section(QT_TRANSLATE_NOOP("commands", "OPTIONS")) + ".TP\n.B \\-\\-version\n" +
           roff(text_of(QT_TRANSLATE_NOOP("commands", "Print the version and exit."))) + "\n" +
           section(QT_TRANSLATE_NOOP("commands", "EXIT STATUS")) + roff(text_of(exit_statuses)) + "\n" +
           section(QT_TRANSLATE_NOOP("commands", "ENVIRONMENT")) + ".TP\n.B FULCRUM_DATA\n" +
           roff(text_of(QT_TRANSLATE_NOOP("commands", "Folder of the window's stores."))) +
           "\n.TP\n.B FULCRUM_ASSETS\n" +
           roff(text_of(QT_TRANSLATE_NOOP(
               "commands", "Folder of tasks, scenes and benchmarks, if it is not next to the program."))) +
           "\n";
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
