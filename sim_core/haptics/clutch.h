// SPDX-License-Identifier: Apache-2.0
// The clutch: after a pause or a loss of the device an instrument continues from the pose at which it was
// held, wherever the device is by then. Sums of device counts saturate at the ends of their range, because a
// device or a record may contain any value.
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

/// Offset from the device's counts to the held counts.
inline std::int32_t clutch_offset(std::int32_t held, std::int32_t device) noexcept {
    return limited_count(static_cast<std::int64_t>(held) - device);
}

/// The device's count plus the clutch offset.
inline std::int32_t clutched(std::int32_t device, std::int32_t offset) noexcept {
    return limited_count(static_cast<std::int64_t>(device) + offset);
}

}  // namespace fulcrum
