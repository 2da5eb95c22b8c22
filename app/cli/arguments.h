// SPDX-License-Identifier: GPL-3.0-or-later
// The words and options of one command line, checked against the command's row in the table (command.h).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {

struct Command;

/// Bad usage. what() is one line, `OPTION: problem; hint`; exit status 2.
class UsageError : public InputError {
  public:
    UsageError(const Sentence& place, const Sentence& problem, const Sentence& hint)
        : InputError(place, "", problem, hint) {}
};

class Arguments {
  public:
    Arguments() = default;
    /// `words`: what follows the command's name. Throws UsageError.
    Arguments(const std::vector<std::string>& words, const Command& command);
    const std::vector<std::string>& words() const { return words_; }
    bool has(const std::string& option) const { return values_.count(option) != 0; }
    bool wants_help() const { return has("--help"); }
    std::optional<std::string> value(const std::string& option) const;
    std::string value_or(const std::string& option, const std::string& fallback) const;
    /// Throws UsageError if the argument is not an integer in [low, high].
    long long integer(const std::string& option, long long fallback, long long low, long long high) const;
    /// The folder that an option names, or the fallback; created if missing. Throws UsageError if it is not
    /// writable: call it before the work whose results go there.
    std::string folder(const std::string& option, const std::string& fallback) const;
    /// Throws UsageError if both are given.
    void exclude(const std::string& one, const std::string& other) const;

  private:
    void read_option(const Command& command, const std::vector<std::string>& words, std::size_t& at);
    std::vector<std::string> words_;
    std::map<std::string, std::string> values_;
};

/// An integer in [low, high]; nothing for any other text.
std::optional<long long> parse_integer(const std::string& text, long long low, long long high);

}  // namespace fulcrum::app
