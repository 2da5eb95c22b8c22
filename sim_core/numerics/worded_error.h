// SPDX-License-Identifier: Apache-2.0
// WordedError: the base of all errors that people read.
#pragma once

#include <stdexcept>
#include <utility>

#include "sim_core/numerics/sentence.h"

namespace fulcrum {

/// what() is in English, for logs; screens and the command line put sentence() into the reader's words.
class WordedError : public std::runtime_error {
  public:
    explicit WordedError(Sentence sentence)
        : std::runtime_error(sentence.words()), sentence_(std::move(sentence)) {}
    const Sentence& sentence() const noexcept { return sentence_; }

  private:
    Sentence sentence_;
};

/// Of another exception: its text as it is.
inline Sentence sentence_of(const std::exception& error) {
    const auto* worded = dynamic_cast<const WordedError*>(&error);
    return worded != nullptr ? worded->sentence() : Sentence(std::string(error.what()));
}

/// A problem and a hint (what to do).
class HintedError : public WordedError {
  public:
    HintedError(Sentence line, Sentence problem, Sentence hint)
        : WordedError(std::move(line)),
          problem_words_(std::move(problem)),
          hint_words_(std::move(hint)),
          problem_(problem_words_.words()),
          hint_(hint_words_.words()) {}
    /// In English.
    const std::string& problem() const noexcept { return problem_; }
    const std::string& hint() const noexcept { return hint_; }
    const Sentence& problem_sentence() const noexcept { return problem_words_; }
    const Sentence& hint_sentence() const noexcept { return hint_words_; }

  private:
    Sentence problem_words_, hint_words_;
    std::string problem_, hint_;
};

}  // namespace fulcrum
