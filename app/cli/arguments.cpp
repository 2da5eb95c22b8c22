// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/cli/command.h"
#include "sim_core/numerics/files.h"

namespace fulcrum::app {
namespace {

Sentence see_help(const Command& command) {
    return {QT_TRANSLATE_NOOP("errors", "see fulcrum %1 --help"), command.name};
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
    throw UsageError(
        option, {QT_TRANSLATE_NOOP("errors", "unknown option of fulcrum %1"), command.name},
        near.empty() ? see_help(command)
                     : Sentence(QT_TRANSLATE_NOOP("errors", "did you mean %1? %2"), near, see_help(command)));
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
        throw UsageError(command.name, QT_TRANSLATE_NOOP("errors", "too few arguments"),
                         {QT_TRANSLATE_NOOP("errors", "usage: %1"), command.usage()});
    if (words_.size() > command.maximum_words)
        throw UsageError(words_[command.maximum_words], QT_TRANSLATE_NOOP("errors", "unexpected argument"),
                         {QT_TRANSLATE_NOOP("errors", "usage: %1"), command.usage()});
    for (const std::string& word : words_)
        if (word.empty())
            throw UsageError("''", QT_TRANSLATE_NOOP("errors", "an argument is empty"),
                             {QT_TRANSLATE_NOOP("errors", "usage: %1"), command.usage()});
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
    if (has(option->name))
        throw UsageError(name, QT_TRANSLATE_NOOP("errors", "given twice"),
                         QT_TRANSLATE_NOOP("errors", "give it once"));
    if (option->argument.empty()) {
        if (attached)
            throw UsageError(name, QT_TRANSLATE_NOOP("errors", "takes no argument"),
                             {QT_TRANSLATE_NOOP("errors", "leave '=%1' out"), *attached});
        values_[option->name] = "";
        return;
    }
    const Sentence hint(QT_TRANSLATE_NOOP("errors", "write %1 %2; %3"), name, placeholders(option->argument),
                        see_help(command));
    if (!attached) {
        if (at + 1 >= words.size())
            throw UsageError(name, QT_TRANSLATE_NOOP("errors", "its argument is missing"), hint);
        attached = words[++at];
    }
    if (attached->empty()) throw UsageError(name, QT_TRANSLATE_NOOP("errors", "its argument is empty"), hint);
    const auto& choices = option->choices;
    if (!choices.empty() && std::find(choices.begin(), choices.end(), *attached) == choices.end()) {
        const std::string near = nearest(*attached, choices);
        throw UsageError(name,
                         {QT_TRANSLATE_NOOP("errors", "'%1' is not a known %2"), *attached,
                          placeholders(option->argument)},
                         near.empty()
                             ? Sentence(QT_TRANSLATE_NOOP("errors", "use one of %1"), joined(choices))
                             : Sentence(QT_TRANSLATE_NOOP("errors", "did you mean %1? Use one of %2"), near,
                                        joined(choices)));
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
        throw UsageError(option,
                         {QT_TRANSLATE_NOOP("errors", "'%1' is not a whole number in the range"), *text},
                         {QT_TRANSLATE_NOOP("errors", "give a number from %1 to %2"), low, high});
    return *number;
}

std::string Arguments::folder(const std::string& option, const std::string& fallback) const {
    const std::filesystem::path folder = value_or(option, fallback);
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    try {
        require_writable_file((folder / "trial").string());
    } catch (const InputError&) {
        throw UsageError(option, {QT_TRANSLATE_NOOP("errors", "cannot write to %1"), folder.string()},
                         QT_TRANSLATE_NOOP("errors", "name a writable folder"));
    }
    return folder.string();
}

void Arguments::exclude(const std::string& one, const std::string& other) const {
    if (has(one) && has(other))
        throw UsageError(one, {QT_TRANSLATE_NOOP("errors", "cannot be combined with %1"), other},
                         QT_TRANSLATE_NOOP("errors", "use only one of them"));
}

std::optional<long long> parse_integer(const std::string& text, long long low, long long high) {
    long long number = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc() || end != last || number < low || number > high) return std::nullopt;
    return number;
}

}  // namespace fulcrum::app
