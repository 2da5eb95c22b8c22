// SPDX-License-Identifier: Apache-2.0
// The contents of the messages that Fulcrum sends and reads. Lengths in OpenIGTLink are millimetres.
//
// A read function returns false for a content of the wrong size; it allocates nothing.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "sim_core/igtl/message.h"
#include "sim_core/numerics/types.h"

namespace fulcrum::igtl {

/// A pose as it is sent: the columns R1, R2, R3 of a rotation, then the place in mm.
struct Transform {
    std::array<float, 12> values = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
};
/// A pose: place in m.
struct Pose {
    Matrix3 rotation = Matrix3::Identity();
    Vector3 place = Vector3::Zero();
};
Transform transform_of(const Pose& pose) noexcept;
/// Nothing where a number is not finite or the columns are not those of a rotation (to 1 %). The rotation is
/// made orthonormal.
std::optional<Pose> pose_of(const Transform& transform) noexcept;

void append_transform(Bytes& out, std::string_view device, std::uint64_t time, const Transform& transform,
                      std::uint16_t version = 1);
bool read_transform(ByteView content, Transform& transform) noexcept;

/// POSITION: place in mm and quaternion x, y, z, w; a content of 12 bytes has no quaternion, one of 24 no w.
struct Position {
    std::array<float, 3> place = {0, 0, 0};
    std::array<float, 4> quaternion = {0, 0, 0, 1};
};
void append_position(Bytes& out, std::string_view device, std::uint64_t time, const Position& position,
                     std::uint16_t version = 1);
bool read_position(ByteView content, Position& position) noexcept;
/// Nothing where a number is not finite or the quaternion's length is not one (to 1 %).
std::optional<Pose> pose_of(const Position& position) noexcept;

/// An element of TDATA.
struct Tracked {
    std::string_view name;  ///< at most 20 bytes
    std::uint8_t kind = 2;  ///< 1 tracker, 2 instrument with 6 degrees of freedom, 3 with 3, 4 with 5
    Transform transform;
};
inline constexpr std::size_t tracked_size = 70;
void append_tdata(Bytes& out, std::string_view device, std::uint64_t time, const Tracked* tracked,
                  std::size_t count, std::uint16_t version = 1);
/// How many elements a TDATA has; nothing where its size is that of none.
std::optional<std::size_t> count_of_tdata(ByteView content) noexcept;
Tracked element_of_tdata(ByteView content, std::size_t index) noexcept;

/// STT_TDATA: asks for TDATA, at most once in so many ms, in this frame.
struct StartTracking {
    std::int32_t resolution_ms = 0;
    std::string_view frame;  ///< at most 32 bytes
};
void append_start_tracking(Bytes& out, std::string_view device, std::uint64_t time,
                           const StartTracking& start, std::uint16_t version = 1);
bool read_start_tracking(ByteView content, StartTracking& start) noexcept;
/// STP_TDATA: asks for its end.
void append_stop_tracking(Bytes& out, std::string_view device, std::uint64_t time, std::uint16_t version = 1);
/// RTS_TDATA: the answer to both. Fulcrum reads it and sends none, because 3D Slicer cannot read it.
void append_tracking_answer(Bytes& out, std::string_view device, std::uint64_t time, bool good,
                            std::uint16_t version = 1);
bool read_tracking_answer(ByteView content, bool& good) noexcept;

struct Status {
    std::uint16_t code = 1;  ///< 1: good
    std::int64_t subcode = 0;
    std::string_view name;  ///< at most 20 bytes
    std::string_view text;
};
void append_status(Bytes& out, std::string_view device, std::uint64_t time, const Status& status,
                   std::uint16_t version = 1);
bool read_status(ByteView content, Status& status) noexcept;

/// STRING, in US-ASCII or UTF-8; cut at 65,535 bytes.
void append_string(Bytes& out, std::string_view device, std::uint64_t time, std::string_view text,
                   std::uint16_t encoding = 3, std::uint16_t version = 1);
bool read_string(ByteView content, std::string_view& text, std::uint16_t& encoding) noexcept;

/// SENSOR: at most 255 numbers with one unit.
inline constexpr std::uint64_t unit_newton = 0x02C4000000000000ULL;  ///< no prefix, N, exponent 1
inline constexpr std::uint64_t unit_none = 0;
struct Sensor {
    std::uint8_t count = 0, status = 0;
    std::uint64_t unit = unit_none;
    std::array<double, 255> values;  ///< `count` valid
};
void append_sensor(Bytes& out, std::string_view device, std::uint64_t time, const double* values,
                   std::uint8_t count, std::uint64_t unit, std::uint16_t version = 1);
bool read_sensor(ByteView content, Sensor& sensor) noexcept;

}  // namespace fulcrum::igtl
