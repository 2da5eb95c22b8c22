// SPDX-License-Identifier: Apache-2.0
// The one error type of bad input: it names the file, the place in it, what is wrong and how to mend it.
#pragma once

#include <stdexcept>
#include <string>

namespace fulcrum {

/// Thrown at the edge (files, command line), never on the haptic or world thread. what() is one line:
/// `FILE:PLACE: wrong; mend`.
class InputError : public std::runtime_error {
  public:
    InputError(std::string file, std::string place, std::string wrong, std::string mend)
        : std::runtime_error(file + (place.empty() ? "" : ":" + place) + ": " + wrong + "; " + mend),
          file_(std::move(file)),
          place_(std::move(place)),
          wrong_(std::move(wrong)),
          mend_(std::move(mend)) {}
    const std::string& file() const noexcept { return file_; }
    const std::string& place() const noexcept { return place_; }
    const std::string& wrong() const noexcept { return wrong_; }
    const std::string& mend() const noexcept { return mend_; }

  private:
    std::string file_, place_, wrong_, mend_;
};

}  // namespace fulcrum
