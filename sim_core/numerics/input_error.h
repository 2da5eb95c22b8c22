// SPDX-License-Identifier: Apache-2.0
// InputError: the one exception for bad input. It names the file, the place in it, what is wrong and what to
// do.
#pragma once

#include <stdexcept>
#include <string>

namespace fulcrum {

/// Thrown where files and command lines are read, never on the haptic or the world thread. what() is one
/// line: `FILE:PLACE: problem; hint`.
class InputError : public std::runtime_error {
  public:
    InputError(std::string file, std::string place, std::string problem, std::string hint)
        : std::runtime_error(file + (place.empty() ? "" : ":" + place) + ": " + problem + "; " + hint),
          file_(std::move(file)),
          place_(std::move(place)),
          problem_(std::move(problem)),
          hint_(std::move(hint)) {}
    const std::string& file() const noexcept { return file_; }
    const std::string& place() const noexcept { return place_; }
    const std::string& problem() const noexcept { return problem_; }
    const std::string& hint() const noexcept { return hint_; }

  private:
    std::string file_, place_, problem_, hint_;
};

}  // namespace fulcrum
