// SPDX-License-Identifier: Apache-2.0
// InputError: the one exception for bad input. It names the file, the place in it, what is wrong and what to
// do.
#pragma once

#include <string>

#include "sim_core/numerics/worded_error.h"

namespace fulcrum {

/// Thrown where files and command lines are read, never on the haptic or the world thread. what() is one
/// line: `FILE:PLACE: problem; hint`.
class InputError : public HintedError {
  public:
    InputError(const Sentence& file, std::string place, const Sentence& problem, const Sentence& hint)
        : HintedError(place.empty() ? Sentence("%1: %2; %3", file, problem, hint)
                                    : Sentence("%1:%2: %3; %4", file, place, problem, hint),
                      problem, hint),
          file_(file.words()),
          place_(std::move(place)) {}
    const std::string& file() const noexcept { return file_; }
    const std::string& place() const noexcept { return place_; }

  private:
    std::string file_, place_;
};

}  // namespace fulcrum
