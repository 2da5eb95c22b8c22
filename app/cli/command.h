// SPDX-License-Identifier: GPL-3.0-or-later
// One table describes every command and its options. Parsing, --help, shell completion and the man page are
// generated from it. What people read is marked QT_TRANSLATE_NOOP("commands", "...") and put into the
// reader's language when it is printed; names of commands and options, choices and other values are not.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/arguments.h"

namespace fulcrum::app {

/// The source of a text of the help in the language in use; `context` is not looked at.
std::string help_words(const char* context, const char* source);
/// "TRACE.csv", "LOGIN,LOGIN,...": the words in capitals stand for what the reader writes and are translated.
Sentence placeholders(const std::string& text);

struct Option {
    std::string name;                       ///< "--seed"
    std::string argument = {};              ///< "N"; empty: a flag
    Sentence help = {};                     ///< one sentence, shown by --help and in the man page
    Sentence fallback = {};                 ///< the default value; shown if not empty
    std::vector<std::string> choices = {};  ///< the allowed arguments; empty: any
    std::string letter = {};                ///< "-o"
};

struct Command {
    std::string name;   ///< "db backup": a group and an action, or one word
    std::string words;  ///< "TASK", "FILE...", "[N]"
    std::size_t minimum_words = 0, maximum_words = 0;
    Sentence help;  ///< one sentence
    std::vector<Option> options = {};
    std::function<int(const Arguments&)> run = {};
    bool draws = false;        ///< needs QApplication: fonts or OpenGL
    Sentence details = {};     ///< a paragraph for --help and the man page
    std::string program = {};  ///< the program that runs it, in the folder of this one; empty: this one

    const Option* option(const std::string& word) const;
    Sentence usage() const;      ///< "fulcrum db backup TO [options]"
    bool is_laboratory() const;  ///< its help stays in English: it is for developers
};

/// One parsed command line.
struct Invocation {
    const Command* command = nullptr;  ///< null: only `text` is printed
    Arguments arguments;
    std::string text;
    std::vector<std::string> given = {};  ///< the whole command line, for a command of another program

    bool draws() const { return command != nullptr && command->program.empty() && command->draws; }
    /// The exit status. A command of another program replaces this process. Throws InputError and what the
    /// command throws.
    int run() const;
};

class CommandTable {
  public:
    /// `version`: what --version prints after the program's name.
    CommandTable(std::vector<Command> commands, std::string version);
    const std::vector<Command>& commands() const { return commands_; }
    /// Throws UsageError for an unknown command or option (with the nearest known one), a wrong number of
    /// words, and an argument that is missing, empty, given twice, not UTF-8 or not one of the choices.
    Invocation parse(const std::vector<std::string>& words) const;

    std::string help() const;
    /// Help on a command or a group such as "db". Throws UsageError for any other name.
    std::string help(const std::string& name) const;
    std::string manual() const;  ///< fulcrum.1, in roff
    /// A completion script. Throws UsageError for shells other than bash and zsh.
    std::string completion(const std::string& shell) const;

  private:
    const Command* find(const std::string& name) const;
    bool is_group(const std::string& name) const;
    std::vector<std::string> names() const;  ///< of commands and groups, as the first word
    std::vector<std::string> names_in(const std::string& group) const;
    std::string action_of(std::vector<std::string>& words) const;
    std::vector<Command> commands_;
    std::string version_;
};

/// The entry of `known` that `word` most likely misspells; empty if none is similar.
std::string nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace fulcrum::app
