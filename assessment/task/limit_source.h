// SPDX-License-Identifier: Apache-2.0
// Where the limit of a gate comes from. Scores and reports keep it as one line, "experts of this site, set 4,
// 12 experts"; that line is written and read here alone, and screens put what it says into words.
#pragma once

#include <cstdint>
#include <string>

namespace fulcrum {

/// The source of a benchmark set of simulated attempts begins with it (docs/FORMATS.md).
inline constexpr const char* simulated_experts = "synthetic operators";

struct LimitSource {
    enum class Kind : std::uint8_t {
        words,       ///< of the task's file
        range,       ///< of the experts of a benchmark set
        taken_over,  ///< the task's limit, which a set of the site took over
    };
    Kind kind = Kind::words;
    std::string of = {};         ///< the words; of a range: the set's source
    std::string site = {};       ///< taken over: the set's source
    int set = 0;                 ///< its version
    int experts = 0;             ///< of a range: how many were counted
    bool worst_counted = false;  ///< the limit is the worst value that counted, not one of the range
    /// Of a range: the experts were operators of the program.
    bool is_simulated() const { return of.rfind(simulated_experts, 0) == 0; }
};

std::string limit_source_line(const LimitSource& source);
/// Words for a line of another form.
LimitSource read_limit_source(const std::string& line);

}  // namespace fulcrum
