// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as data: positional words, options with a value, flags. Every subcommand declares what it
// takes.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace fulcrum::app {

/// Bad usage: one line that names the place and the hint; exit status 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct OptionSpec {
    std::set<std::string> with_value;  ///< "--seed"
    std::set<std::string> flags;       ///< "--json"
    std::size_t minimum_words = 0, maximum_words = 0;
    std::string usage;  ///< one line, shown with every error
};

class Arguments {
  public:
    /// Throws UsageError: unknown option, missing value, an option given twice, too few or too many words.
    Arguments(const std::vector<std::string>& words, const OptionSpec& spec);
    const std::vector<std::string>& words() const { return words_; }
    bool has(const std::string& option) const { return values_.count(option) != 0; }
    std::optional<std::string> value(const std::string& option) const;
    std::string value_or(const std::string& option, const std::string& fallback) const;
    /// Throws UsageError where the value is no whole number in [low, high].
    long long integer(const std::string& option, long long fallback, long long low, long long high) const;
    /// The folder that an option names, or the fallback, made where it is not there. Throws UsageError where
    /// nothing can be written in it: before the work whose results go there, not after it.
    std::string folder(const std::string& option, const std::string& fallback) const;
    const std::string& usage() const { return usage_; }

  private:
    std::vector<std::string> words_;
    std::map<std::string, std::string> values_;
    std::string usage_;
};

}  // namespace fulcrum::app
