// SPDX-License-Identifier: Apache-2.0
#include "sim_core/igtl/content.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim_core/igtl/byte_order.h"

namespace fulcrum::igtl {
namespace {

constexpr double mm = 1e-3;
constexpr double rotation_tolerance = 0.01;
constexpr std::size_t transform_size = 48, name_size = 20, frame_size = 32;
constexpr std::size_t status_head = 30, string_head = 4, sensor_head = 10;
constexpr std::size_t longest_string = 65535;

std::string_view zero_ended(const std::uint8_t* field, std::size_t size) noexcept {
    const auto* const begin = reinterpret_cast<const char*>(field);
    return {begin, static_cast<std::size_t>(std::find(begin, begin + size, '\0') - begin)};
}

void put_name(std::uint8_t* field, std::size_t size, std::string_view text) noexcept {
    std::memcpy(field, text.data(), std::min(size, text.size()));
}

void put_floats(std::uint8_t* to, const Transform& transform) noexcept {
    for (std::size_t i = 0; i < transform.values.size(); ++i)
        write_number(to + i * sizeof(float), transform.values[i]);
}
void get_floats(const std::uint8_t* from, Transform& transform) noexcept {
    for (std::size_t i = 0; i < transform.values.size(); ++i)
        transform.values[i] = read_number<float>(from + i * sizeof(float));
}

Envelope envelope_of(std::string_view type, std::string_view device, std::uint64_t time,
                     std::uint16_t version) {
    Envelope envelope;
    envelope.type = type;
    envelope.device = device;
    envelope.time = time;
    envelope.version = version;
    return envelope;
}

}  // namespace

Transform transform_of(const Pose& pose) noexcept {
    Transform transform;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            transform.values[static_cast<std::size_t>(3 * column + row)] =
                static_cast<float>(pose.rotation(row, column));
    for (int row = 0; row < 3; ++row)
        transform.values[static_cast<std::size_t>(9 + row)] = static_cast<float>(pose.place[row] / mm);
    return transform;
}

std::optional<Pose> pose_of(const Transform& transform) noexcept {
    Pose pose;
    for (std::size_t i = 0; i < transform.values.size(); ++i) {
        if (!std::isfinite(transform.values[i])) return std::nullopt;
        const auto row = static_cast<Eigen::Index>(i % 3), column = static_cast<Eigen::Index>(i / 3);
        if (column < 3)
            pose.rotation(row, column) = static_cast<double>(transform.values[i]);
        else
            pose.place[row] = mm * static_cast<double>(transform.values[i]);
    }
    const Matrix3 error = pose.rotation.transpose() * pose.rotation - Matrix3::Identity();
    if (!(error.cwiseAbs().maxCoeff() < rotation_tolerance) || pose.rotation.determinant() < 0)
        return std::nullopt;
    // The shaft's direction is kept; the others follow it.
    const Vector3 z = pose.rotation.col(2).normalized();
    const Vector3 x = (pose.rotation.col(0) - pose.rotation.col(0).dot(z) * z).normalized();
    pose.rotation.col(0) = x;
    pose.rotation.col(1) = z.cross(x);
    pose.rotation.col(2) = z;
    return pose;
}

void append_transform(Bytes& out, std::string_view device, std::uint64_t time, const Transform& transform,
                      std::uint16_t version) {
    std::array<std::uint8_t, transform_size> content{};
    put_floats(content.data(), transform);
    append_message(out, envelope_of("TRANSFORM", device, time, version), {content.data(), content.size()});
}

bool read_transform(ByteView content, Transform& transform) noexcept {
    if (content.size != transform_size) return false;
    get_floats(content.data, transform);
    return true;
}

void append_position(Bytes& out, std::string_view device, std::uint64_t time, const Position& position,
                     std::uint16_t version) {
    std::array<std::uint8_t, 28> content{};
    for (std::size_t i = 0; i < 3; ++i) write_number(content.data() + 4 * i, position.place[i]);
    for (std::size_t i = 0; i < 4; ++i) write_number(content.data() + 12 + 4 * i, position.quaternion[i]);
    append_message(out, envelope_of("POSITION", device, time, version), {content.data(), content.size()});
}

bool read_position(ByteView content, Position& position) noexcept {
    if (content.size != 12 && content.size != 24 && content.size != 28) return false;
    position = {};
    for (std::size_t i = 0; i < 3; ++i) position.place[i] = read_number<float>(content.data + 4 * i);
    for (std::size_t i = 0; 12 + 4 * i < content.size; ++i)
        position.quaternion[i] = read_number<float>(content.data + 12 + 4 * i);
    if (content.size != 24) return true;
    float rest = 1;
    for (std::size_t i = 0; i < 3; ++i) rest -= position.quaternion[i] * position.quaternion[i];
    position.quaternion[3] = rest > 0 ? std::sqrt(rest) : 0;
    return true;
}

std::optional<Pose> pose_of(const Position& position) noexcept {
    Pose pose;
    std::array<double, 4> q{};
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = static_cast<double>(position.quaternion[i]);
    for (std::size_t i = 0; i < 3; ++i)
        pose.place[static_cast<Eigen::Index>(i)] = mm * static_cast<double>(position.place[i]);
    const Quaternion quaternion(q[3], q[0], q[1], q[2]);
    if (!pose.place.allFinite() || !(std::abs(quaternion.norm() - 1) < rotation_tolerance))
        return std::nullopt;
    pose.rotation = quaternion.normalized().toRotationMatrix();
    return pose;
}

void append_tdata(Bytes& out, std::string_view device, std::uint64_t time, const Tracked* tracked,
                  std::size_t count, std::uint16_t version) {
    Bytes content(count * tracked_size, 0);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint8_t* const element = content.data() + i * tracked_size;
        put_name(element, name_size, tracked[i].name);
        element[name_size] = tracked[i].kind;
        put_floats(element + name_size + 2, tracked[i].transform);
    }
    append_message(out, envelope_of("TDATA", device, time, version), {content.data(), content.size()});
}

std::optional<std::size_t> count_of_tdata(ByteView content) noexcept {
    if (content.size % tracked_size != 0) return std::nullopt;
    return content.size / tracked_size;
}

Tracked element_of_tdata(ByteView content, std::size_t index) noexcept {
    Tracked tracked;
    const std::uint8_t* const element = content.data + index * tracked_size;
    tracked.name = zero_ended(element, name_size);
    tracked.kind = element[name_size];
    get_floats(element + name_size + 2, tracked.transform);
    return tracked;
}

void append_start_tracking(Bytes& out, std::string_view device, std::uint64_t time,
                           const StartTracking& start, std::uint16_t version) {
    std::array<std::uint8_t, 4 + frame_size> content{};
    write_number(content.data(), start.resolution_ms);
    put_name(content.data() + 4, frame_size, start.frame);
    append_message(out, envelope_of("STT_TDATA", device, time, version), {content.data(), content.size()});
}

bool read_start_tracking(ByteView content, StartTracking& start) noexcept {
    if (content.size != 4 + frame_size) return false;
    start.resolution_ms = read_number<std::int32_t>(content.data);
    start.frame = zero_ended(content.data + 4, frame_size);
    return true;
}

void append_stop_tracking(Bytes& out, std::string_view device, std::uint64_t time, std::uint16_t version) {
    append_message(out, envelope_of("STP_TDATA", device, time, version), {});
}

void append_tracking_answer(Bytes& out, std::string_view device, std::uint64_t time, bool good,
                            std::uint16_t version) {
    const std::uint8_t status = good ? 0 : 1;
    append_message(out, envelope_of("RTS_TDATA", device, time, version), {&status, 1});
}

bool read_tracking_answer(ByteView content, bool& good) noexcept {
    if (content.size != 1) return false;
    good = content.data[0] == 0;
    return true;
}

void append_status(Bytes& out, std::string_view device, std::uint64_t time, const Status& status,
                   std::uint16_t version) {
    Bytes content(status_head + status.text.size() + 1, 0);
    write_number(content.data(), status.code);
    write_number(content.data() + 2, status.subcode);
    put_name(content.data() + 10, name_size, status.name);
    std::memcpy(content.data() + status_head, status.text.data(), status.text.size());
    append_message(out, envelope_of("STATUS", device, time, version), {content.data(), content.size()});
}

bool read_status(ByteView content, Status& status) noexcept {
    if (content.size < status_head) return false;
    status.code = read_number<std::uint16_t>(content.data);
    status.subcode = read_number<std::int64_t>(content.data + 2);
    status.name = zero_ended(content.data + 10, name_size);
    status.text = zero_ended(content.data + status_head, content.size - status_head);
    return true;
}

void append_string(Bytes& out, std::string_view device, std::uint64_t time, std::string_view text,
                   std::uint16_t encoding, std::uint16_t version) {
    const std::size_t size = std::min(text.size(), longest_string);
    Bytes content(string_head + size, 0);
    write_number(content.data(), encoding);
    write_number(content.data() + 2, static_cast<std::uint16_t>(size));
    if (size > 0) std::memcpy(content.data() + string_head, text.data(), size);
    append_message(out, envelope_of("STRING", device, time, version), {content.data(), content.size()});
}

bool read_string(ByteView content, std::string_view& text, std::uint16_t& encoding) noexcept {
    if (content.size < string_head) return false;
    const std::size_t size = read_number<std::uint16_t>(content.data + 2);
    if (content.size - string_head != size) return false;
    encoding = read_number<std::uint16_t>(content.data);
    text = {reinterpret_cast<const char*>(content.data + string_head), size};
    return true;
}

void append_sensor(Bytes& out, std::string_view device, std::uint64_t time, const double* values,
                   std::uint8_t count, std::uint64_t unit, std::uint16_t version) {
    Bytes content(sensor_head + std::size_t{count} * sizeof(double), 0);
    content[0] = count;
    write_number(content.data() + 2, unit);
    for (std::size_t i = 0; i < count; ++i)
        write_number(content.data() + sensor_head + i * sizeof(double), values[i]);
    append_message(out, envelope_of("SENSOR", device, time, version), {content.data(), content.size()});
}

bool read_sensor(ByteView content, Sensor& sensor) noexcept {
    if (content.size < sensor_head || content.size - sensor_head != content.data[0] * sizeof(double))
        return false;
    sensor.count = content.data[0];
    sensor.status = content.data[1];
    sensor.unit = read_number<std::uint64_t>(content.data + 2);
    for (std::size_t i = 0; i < sensor.count; ++i)
        sensor.values[i] = read_number<double>(content.data + sensor_head + i * sizeof(double));
    return true;
}

}  // namespace fulcrum::igtl
