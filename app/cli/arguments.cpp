// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"

#include <charconv>
#include <filesystem>
#include <fstream>

namespace fulcrum::app {

Arguments::Arguments(const std::vector<std::string>& words, const OptionSpec& spec) : usage_(spec.usage) {
    bool only_words = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (only_words || word.rfind("--", 0) != 0) {
            const bool short_output = word == "-o" && spec.with_value.count("--output") != 0;
            if (!short_output) {
                if (word.size() > 1 && word[0] == '-' && !only_words)
                    throw UsageError("command line: " + word + ": unknown option; " + usage_);
                words_.push_back(word);
                continue;
            }
        }
        if (word == "--") {
            only_words = true;
            continue;
        }
        const std::string name = word == "-o" ? "--output" : word;
        if (values_.count(name) != 0)
            throw UsageError("command line: " + name + ": given twice; give it once");
        if (spec.flags.count(name) != 0) {
            values_[name] = "";
        } else if (spec.with_value.count(name) != 0) {
            if (i + 1 >= words.size())
                throw UsageError("command line: " + name + ": needs a value; " + usage_);
            values_[name] = words[++i];
        } else {
            throw UsageError("command line: " + name + ": unknown option; " + usage_);
        }
    }
    if (words_.size() < spec.minimum_words) throw UsageError("command line: a word is missing; " + usage_);
    if (words_.size() > spec.maximum_words)
        throw UsageError("command line: " + words_[spec.maximum_words] + ": not expected; " + usage_);
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
    long long number = 0;
    const auto result = std::from_chars(text->data(), text->data() + text->size(), number);
    if (result.ec != std::errc() || result.ptr != text->data() + text->size() || number < low ||
        number > high) {
        throw UsageError("command line: " + option + ": '" + *text + "' is no whole number from " +
                         std::to_string(low) + " to " + std::to_string(high) + "; " + usage_);
    }
    return number;
}

std::string Arguments::folder(const std::string& option, const std::string& fallback) const {
    const std::filesystem::path folder = value_or(option, fallback);
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    const std::filesystem::path trial = folder / ".fulcrum-writes-here";
    if (!std::ofstream(trial))
        throw UsageError("command line: " + option + ": cannot write in " + folder.string() +
                         "; name a folder that can be written");
    std::filesystem::remove(trial, failed);
    return folder.string();
}

}  // namespace fulcrum::app
