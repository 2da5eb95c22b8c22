// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace fulcrum {

std::optional<double> parse_decimal(std::string_view text) {
    double value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, value);
    if (error != std::errc() || end != last || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string decimal_text(double value, int digits) {
    std::array<char, 512> text{};  // the largest double has 309 digits before the point
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0 : value,
                                            std::chars_format::fixed, digits);
    return error == std::errc() ? std::string(text.data(), end) : "?";
}

}  // namespace fulcrum
