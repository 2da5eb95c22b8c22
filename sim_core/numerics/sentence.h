// SPDX-License-Identifier: Apache-2.0
// Sentence: what an error says, in English with numbered places, and what is put there. It is put into words
// where it is shown, in the reader's language.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "sim_core/numerics/name_table.h"

namespace fulcrum {

/// A marked text (QT_TRANSLATE_NOOP) in the reader's language.
using Translate = std::string (*)(const char* context, const char* source);
/// The text as it is.
std::string in_english(const char* context, const char* source);

class Sentence {
  public:
    static constexpr const char* context = "errors";

    Sentence() = default;
    /// `source`: QT_TRANSLATE_NOOP("errors", "the login %1 is taken"). What is put in place of %1 to %9:
    /// texts, whole numbers, other sentences.
    template <typename... Parts>
    Sentence(const char* source, const Parts&... parts)  // NOLINT: a text is a sentence
        : source_(source), marked_(true), parts_{part(parts)...} {}
    /// A text that is the same in every language: a name, a path, what an operating system says.
    Sentence(std::string text) : source_(std::move(text)) {}  // NOLINT

    bool empty() const { return source_.empty(); }
    std::string words(Translate translate = in_english) const;

    /// For sending it to another process: the source, whether it is marked, and the parts.
    const std::string& source() const { return source_; }
    bool marked() const { return marked_; }
    const std::vector<Sentence>& parts() const { return parts_; }
    static Sentence from_parts(std::string source, bool marked, std::vector<Sentence> parts);

  private:
    template <typename Part>
    static Sentence part(const Part& one) {
        if constexpr (std::is_integral_v<Part>) {
            return std::to_string(one);
        } else {
            return one;
        }
    }
    std::string source_;
    bool marked_ = false;
    std::vector<Sentence> parts_;
};

/// In English, for files and programs.
std::vector<std::string> english_of(const std::vector<Sentence>& sentences);

}  // namespace fulcrum
