// SPDX-License-Identifier: Apache-2.0
// The clutch: after a pause or a loss an instrument goes on from where it was held, wherever its device
// stands by then. Sums of device counts stop at the ends of their range: a device or a record may say
// anything.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace fulcrum {

/// Counts, within the range of a count.
inline std::int32_t limited_count(std::int64_t count) noexcept {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(count, std::numeric_limits<std::int32_t>::min(),
                                                              std::numeric_limits<std::int32_t>::max()));
}

/// Counts from the device to what is held.
inline std::int32_t clutch_offset(std::int32_t held, std::int32_t device) noexcept {
    return limited_count(static_cast<std::int64_t>(held) - device);
}

/// The device's count with the clutch's offset.
inline std::int32_t clutched(std::int32_t device, std::int32_t offset) noexcept {
    return limited_count(static_cast<std::int64_t>(device) + offset);
}

}  // namespace fulcrum
