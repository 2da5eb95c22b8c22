// SPDX-License-Identifier: Apache-2.0
// Recordings of poses by device: the XML that the transform recorder of PerkTutor (3D Slicer) writes, one
// <log type="transform" DeviceName TimeStampSec TimeStampNSec transform> for each pose, 16 numbers by rows.
// They become a table with one row for each time, which a mapping reads like any other. Internal to this
// room.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum {

/// "Stylus.x" is the x of the device Stylus; "Stylus.z_axis.x" that of the direction of its z axis.
struct TransformTable {
    std::string text;                  ///< CSV with a header row; time (s), then the columns asked for
    std::vector<std::string> ignored;  ///< devices of which no column is wanted
    std::size_t left_out = 0;          ///< poses of the slowest device without one of each other close by
};

inline constexpr std::size_t transform_pose_limit = 2'000'000;

/// The device in the name of a column; empty: it is not of that form.
std::string device_of_column(const std::string& column);

/// The columns are in the order in which they are named. Rows are at the times of the
/// device with the fewest poses; poses of the others are interpolated between two that are at most 0.1 s
/// apart. Throws InputError with the line of the file.
TransformTable transform_table(std::string_view text, const std::string& file,
                               const std::vector<std::string>& columns);

}  // namespace fulcrum
