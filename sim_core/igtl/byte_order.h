// SPDX-License-Identifier: Apache-2.0
// Numbers in the byte order of OpenIGTLink: the most significant byte first. Internal to this room.
#pragma once

#include <cstdint>
#include <cstring>

namespace fulcrum::igtl {

template <typename T>
T read_number(const std::uint8_t* from) noexcept {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) bits = (bits << 8U) | from[i];
    if constexpr (sizeof(T) == 8) {
        T value{};
        std::memcpy(&value, &bits, sizeof value);
        return value;
    } else if constexpr (sizeof(T) == 4) {
        const auto low = static_cast<std::uint32_t>(bits);
        T value{};
        std::memcpy(&value, &low, sizeof value);
        return value;
    } else {
        return static_cast<T>(bits);
    }
}

template <typename T>
void write_number(std::uint8_t* to, T value) noexcept {
    std::uint64_t bits = 0;
    if constexpr (sizeof(T) == 8) {
        std::memcpy(&bits, &value, sizeof value);
    } else if constexpr (sizeof(T) == 4) {
        std::uint32_t low = 0;
        std::memcpy(&low, &value, sizeof value);
        bits = low;
    } else {
        bits = static_cast<std::uint64_t>(value);
    }
    for (std::size_t i = 0; i < sizeof(T); ++i)
        to[i] = static_cast<std::uint8_t>(bits >> (8U * (sizeof(T) - 1 - i)));
}

}  // namespace fulcrum::igtl
