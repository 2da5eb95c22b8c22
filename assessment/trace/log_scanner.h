// SPDX-License-Identifier: Apache-2.0
// The elements of an XML file that has nothing but elements with attributes. Internal to this room.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "sim_core/numerics/worded_error.h"

namespace fulcrum {

struct LogElement {
    std::string name;
    bool closes = false;  ///< </name>
    std::map<std::string, std::string, std::less<>> attributes;
};

/// Reads one element after another; comments, declarations and text between elements are skipped.
class LogScanner {
  public:
    LogScanner(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}
    /// False at the end. Throws InputError.
    bool next(LogElement& element);
    /// About the element that next() gave last.
    [[noreturn]] void fail(const Sentence& problem, const Sentence& hint) const;
    /// Its attribute. Throws InputError where it has none of that name.
    const std::string& attribute(const LogElement& element, const char* name) const;

  private:
    void skip_to(std::string_view end);
    void move(std::size_t to);
    void read_attribute(LogElement& element);
    void skip_space();
    bool is_at_end() const { return place_ == text_.size(); }

    std::string_view text_;
    std::string file_;
    std::size_t place_ = 0, line_ = 1, element_line_ = 1;
};

}  // namespace fulcrum
