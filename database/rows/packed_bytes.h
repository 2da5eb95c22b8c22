// SPDX-License-Identifier: GPL-3.0-or-later
// Compressed bytes (zstd), for states of the simulation and for the demonstration. Any thread.
#pragma once

#include <cstdint>
#include <vector>

namespace fulcrum::database {

/// One zstd frame that names its size. `level`: of zstd, 1 (fast) to 19 (small).
std::vector<std::uint8_t> pack_bytes(const std::vector<std::uint8_t>& bytes, int level = 1);
/// Throws StoreError corrupt where it is not such a frame, or has more than packed_maximum_bytes.
std::vector<std::uint8_t> unpack_bytes(const std::vector<std::uint8_t>& packed);
inline constexpr std::size_t packed_maximum_bytes = 256U << 20U;

}  // namespace fulcrum::database
