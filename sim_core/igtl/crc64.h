// SPDX-License-Identifier: Apache-2.0
// The checksum of OpenIGTLink: CRC-64 of ECMA-182, polynomial 0x42F0E1EBA9EA3693, most significant bit first,
// start value 0.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fulcrum::igtl {

/// Of `size` bytes; `before` is the checksum of the bytes before them.
std::uint64_t crc64(const std::uint8_t* bytes, std::size_t size, std::uint64_t before = 0) noexcept;

}  // namespace fulcrum::igtl
