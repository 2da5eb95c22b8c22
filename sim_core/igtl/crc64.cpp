// SPDX-License-Identifier: Apache-2.0
#include "sim_core/igtl/crc64.h"

#include <array>

namespace fulcrum::igtl {
namespace {

constexpr std::array<std::uint64_t, 256> make_crc_table() {
    std::array<std::uint64_t, 256> table{};
    for (std::uint64_t byte = 0; byte < 256; ++byte) {
        std::uint64_t value = byte << 56U;
        for (int bit = 0; bit < 8; ++bit)
            value = (value >> 63U) != 0 ? (value << 1U) ^ 0x42F0E1EBA9EA3693ULL : value << 1U;
        table[byte] = value;
    }
    return table;
}
constexpr std::array<std::uint64_t, 256> crc_table = make_crc_table();

}  // namespace

std::uint64_t crc64(const std::uint8_t* bytes, std::size_t size, std::uint64_t before) noexcept {
    std::uint64_t value = before;
    for (std::size_t i = 0; i < size; ++i) value = (value << 8U) ^ crc_table[(value >> 56U) ^ bytes[i]];
    return value;
}

}  // namespace fulcrum::igtl
