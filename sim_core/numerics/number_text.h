// SPDX-License-Identifier: Apache-2.0
// Numbers as text and back, the same under every locale: printf and strtod follow the language of the desktop
// once Qt has set it. Not for the haptic or world thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fulcrum {

/// A finite decimal number that fills the whole text ("0.12", "-3e-5"); nothing for any other text.
std::optional<double> parse_decimal(std::string_view text);

/// `digits` digits after the point: decimal_text(37.5, 1) is "37.5". Zero has no sign.
std::string decimal_text(double value, int digits);

}  // namespace fulcrum
