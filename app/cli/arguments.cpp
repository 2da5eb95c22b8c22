// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/cli/command.h"
#include "sim_core/numerics/files.h"

namespace fulcrum::app {
namespace {

std::string see_help(const Command& command) {
    return "see fulcrum " + command.name + " --help";
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

[[noreturn]] void refuse_unknown(const Command& command, const std::string& option) {
    std::vector<std::string> known;
    for (const Option& one : command.options) known.push_back(one.name);
    const std::string near = nearest(option, known);
    throw UsageError(option, "unknown option of fulcrum " + command.name,
                     (near.empty() ? "" : "did you mean " + near + "? ") + see_help(command));
}

}  // namespace

Arguments::Arguments(const std::vector<std::string>& words, const Command& command) {
    bool only_words = false;
    for (std::size_t at = 0; at < words.size(); ++at) {
        const std::string& word = words[at];
        if (only_words || word.size() < 2 || word[0] != '-') {
            words_.push_back(word);
        } else if (word == "--") {
            only_words = true;
        } else {
            read_option(command, words, at);
        }
    }
    if (wants_help()) return;  // before any other error of the line
    if (words_.size() < command.minimum_words)
        throw UsageError(command.name, "too few arguments", "usage: " + command.usage());
    if (words_.size() > command.maximum_words)
        throw UsageError(words_[command.maximum_words], "unexpected argument", "usage: " + command.usage());
    for (const std::string& word : words_)
        if (word.empty()) throw UsageError("''", "an argument is empty", "usage: " + command.usage());
}

void Arguments::read_option(const Command& command, const std::vector<std::string>& words, std::size_t& at) {
    std::string name = words[at];
    std::optional<std::string> attached;
    const std::size_t equals = name.rfind("--", 0) == 0 ? name.find('=') : std::string::npos;
    if (equals != std::string::npos) {
        attached = name.substr(equals + 1);
        name.resize(equals);
    }
    const Option* const option = command.option(name);
    if (option == nullptr) refuse_unknown(command, name);
    if (has(option->name)) throw UsageError(name, "given twice", "give it once");
    if (option->argument.empty()) {
        if (attached) throw UsageError(name, "takes no argument", "leave '=" + *attached + "' out");
        values_[option->name] = "";
        return;
    }
    const std::string hint = "write " + name + " " + option->argument + "; " + see_help(command);
    if (!attached) {
        if (at + 1 >= words.size()) throw UsageError(name, "its argument is missing", hint);
        attached = words[++at];
    }
    if (attached->empty()) throw UsageError(name, "its argument is empty", hint);
    const auto& choices = option->choices;
    if (!choices.empty() && std::find(choices.begin(), choices.end(), *attached) == choices.end()) {
        const std::string near = nearest(*attached, choices);
        throw UsageError(name, "'" + *attached + "' is not a known " + option->argument,
                         near.empty() ? "use one of " + joined(choices)
                                      : "did you mean " + near + "? Use one of " + joined(choices));
    }
    values_[option->name] = *attached;
}

std::optional<std::string> Arguments::value(const std::string& option) const {
    const auto found = values_.find(option);
    return found == values_.end() ? std::nullopt : std::optional<std::string>(found->second);
}

std::string Arguments::value_or(const std::string& option, const std::string& fallback) const {
    return value(option).value_or(fallback);
}

long long Arguments::integer(const std::string& option, long long fallback, long long low,
                             long long high) const {
    const auto text = value(option);
    if (!text) return fallback;
    const auto number = parse_integer(*text, low, high);
    if (!number)
        throw UsageError(option, "'" + *text + "' is not a whole number in the range",
                         "give a number from " + std::to_string(low) + " to " + std::to_string(high));
    return *number;
}

std::string Arguments::folder(const std::string& option, const std::string& fallback) const {
    const std::filesystem::path folder = value_or(option, fallback);
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    try {
        require_writable_file((folder / "trial").string());
    } catch (const InputError&) {
        throw UsageError(option, "cannot write to " + folder.string(), "name a writable folder");
    }
    return folder.string();
}

void Arguments::exclude(const std::string& one, const std::string& other) const {
    if (has(one) && has(other))
        throw UsageError(one, "cannot be combined with " + other, "use only one of them");
}

std::optional<long long> parse_integer(const std::string& text, long long low, long long high) {
    long long number = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc() || end != last || number < low || number > high) return std::nullopt;
    return number;
}

}  // namespace fulcrum::app
