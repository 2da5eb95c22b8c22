// SPDX-License-Identifier: GPL-3.0-or-later
// Records as rows of 32-bit columns, and which columns help to predict which; internal to this floor.
#pragma once

#include <array>
#include <cstring>
#include <limits>

#include "database/rows/trace_bits.h"
#include "database/rows/trace_codec.h"

namespace fulcrum::database {

// Values narrower than 32 bits are checked on the way back: a damaged chunk that passed its checksum must not
// wrap.
template <typename Narrow>
Narrow narrow_value(std::uint32_t value) {
    const auto wide = static_cast<std::int32_t>(value);
    if (wide < std::numeric_limits<Narrow>::min() || wide > std::numeric_limits<Narrow>::max()) {
        damaged_chunk(QT_TRANSLATE_NOOP("errors", "a value out of range"));
    }
    return static_cast<Narrow>(wide);
}

class ColumnWriter {
  public:
    explicit ColumnWriter(std::uint32_t* out) : out_(out) {}
    void operator()(std::uint32_t value) { *out_++ = value; }
    template <typename Signed>
    void operator()(Signed value) {
        *out_++ = static_cast<std::uint32_t>(static_cast<std::int32_t>(value));
    }

  private:
    std::uint32_t* out_;
};

class ColumnReader {
  public:
    explicit ColumnReader(const std::uint32_t* in) : in_(in) {}
    void operator()(std::uint32_t& value) { value = *in_++; }
    void operator()(std::int32_t& value) { value = static_cast<std::int32_t>(*in_++); }
    template <typename Narrow>
    void operator()(Narrow& value) {
        value = narrow_value<Narrow>(*in_++);
    }

  private:
    const std::uint32_t* in_;
};

template <typename Visitor, typename Hand>
void visit_hand(Visitor& visit, Hand& hand) {
    for (auto& value : hand.tip) visit(value);
    for (auto& value : hand.axis) visit(value);
    visit(hand.roll);
    visit(hand.jaw_angle);
    for (auto& value : hand.force) visit(value);
    for (auto& value : hand.device_force) visit(value);
    visit(hand.jaw_force);
    visit(hand.jaw_area);
    visit(hand.tissue);
    visit(hand.patch);
    visit(hand.flags);
    visit(hand.filter_grade);
}

template <typename Visitor, typename Device>
void visit_device(Visitor& visit, Device& device) {
    for (auto& value : device.handle) visit(value);
    visit(device.roll);
    visit(device.jaw);
    visit(device.grip);
    visit(device.buttons);
    visit(device.present);
    visit(device.faulty);
}

/// Three columns of the inputs (-1: fewer) whose residuals explain a column's.
using Guides = std::array<int, 3>;
inline constexpr Guides no_guides{-1, -1, -1};

/// columns, stream, visit(), partner(): an earlier column of the same record or -1, guides(): columns of the
/// inputs.
template <typename Record>
struct Layout;

template <>
struct Layout<RigSample> {
    static constexpr TraceStream stream = TraceStream::inputs;
    static constexpr std::size_t device_columns = 9, columns = 2 + 3 * device_columns,
                                 fewest_columns = columns;
    template <typename Visitor, typename Record>
    static void visit(Visitor& visitor, Record& record) {
        visitor(record.tick);
        visitor(record.flags);
        for (auto& hand : record.hand) visit_device(visitor, hand);
        visit_device(visitor, record.camera);
    }
    static int partner(std::size_t) { return -1; }
    static Guides guides(std::size_t) { return no_guides; }
    static std::uint32_t first_tick(const RigSample& record) { return record.tick; }
    static std::uint32_t last_tick(const RigSample& record) { return record.tick; }
};

template <>
struct Layout<TickSample> {
    static constexpr TraceStream stream = TraceStream::samples;
    static constexpr std::size_t force = 8, flags = 18;  // within a hand's columns
    static constexpr std::size_t hand_column(std::size_t hand, std::size_t part) {
        return 4 + hand * hand_columns + part;
    }
    // Columns are only ever added at the end: an older chunk has fewer, and what it lacks reads as 0.
    static constexpr std::size_t hand_columns = 20, first_camera = 4 + 2 * hand_columns,
                                 first_torque = first_camera + 7, columns = first_torque + 6,
                                 fewest_columns = first_torque;
    template <typename Visitor, typename Record>
    static void visit(Visitor& visitor, Record& record) {
        visitor(record.tick);
        visitor(record.rig_flags);
        visitor(record.model_step);
        visitor(record.missed);
        for (auto& hand : record.hand) visit_hand(visitor, hand);
        for (auto& value : record.camera.tip) visitor(value);
        for (auto& value : record.camera.orientation) visitor(value);
        for (auto& hand : record.hand) {
            for (auto& value : hand.torque) visitor(value);
        }
    }
    static int partner(std::size_t column) {
        if (column < 4 || column >= first_camera) return -1;
        // The device force follows the force.
        const std::size_t within = (column - 4) % hand_columns;
        return within >= 11 && within < 14 ? static_cast<int>(column) - 3 : -1;
    }
    // Tip, axis, force and torque are functions of the handle; roll, jaw angle and jaw force of what was
    // asked.
    static Guides guides(std::size_t column) {
        if (column < 4) return no_guides;
        constexpr int first_device = 2, device = static_cast<int>(Layout<RigSample>::device_columns);
        if (column >= first_torque) {
            const int hand = first_device + device * static_cast<int>((column - first_torque) / 3);
            return {hand, hand + 1, hand + 2};
        }
        const bool camera = column >= first_camera;
        const std::size_t within = camera ? 0 : (column - 4) % hand_columns;
        const int base = first_device + device * (camera ? 2 : static_cast<int>((column - 4) / hand_columns));
        if (within < 6 || (within >= 8 && within < 11)) return {base, base + 1, base + 2};
        if (within == 6) return {base + 3, -1, -1};
        if (within == 7) return {base + 4, -1, -1};
        if (within == 14) return {base + 5, -1, -1};
        return no_guides;
    }
    static std::uint32_t first_tick(const TickSample& record) { return record.tick; }
    static std::uint32_t last_tick(const TickSample& record) { return record.tick; }
};

template <>
struct Layout<StepRecord> {
    static constexpr TraceStream stream = TraceStream::steps;
    static constexpr std::size_t columns = 6, fewest_columns = columns;
    static void visit(ColumnWriter& visitor, const StepRecord& record) {
        visitor(record.step);
        visitor(record.first_tick);
        visitor(record.last_tick);
        visitor(record.outcome);
        visitor(static_cast<std::uint32_t>(record.state_hash));
        visitor(static_cast<std::uint32_t>(record.state_hash >> 32U));
    }
    static void visit(ColumnReader& visitor, StepRecord& record) {
        visitor(record.step);
        visitor(record.first_tick);
        visitor(record.last_tick);
        visitor(record.outcome);
        std::uint32_t low = 0, high = 0;
        visitor(low);
        visitor(high);
        record.state_hash = low | static_cast<std::uint64_t>(high) << 32U;
    }
    static int partner(std::size_t column) { return column == 2 ? 1 : -1; }
    static Guides guides(std::size_t) { return no_guides; }
    static std::uint32_t first_tick(const StepRecord& record) { return record.first_tick; }
    static std::uint32_t last_tick(const StepRecord& record) { return record.last_tick; }
};

template <>
struct Layout<Event> {
    static constexpr TraceStream stream = TraceStream::events;
    static constexpr std::size_t columns = 6, fewest_columns = columns;
    static void visit(ColumnWriter& visitor, const Event& record) {
        visitor(record.tick);
        visitor(static_cast<std::uint16_t>(record.kind));
        visitor(record.hand);
        visitor(record.tissue);
        visitor(record.detail);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &record.value, sizeof bits);
        visitor(bits);
    }
    static void visit(ColumnReader& visitor, Event& record) {
        visitor(record.tick);
        std::uint16_t kind = 0;
        visitor(kind);
        record.kind = static_cast<EventKind>(kind);
        visitor(record.hand);
        visitor(record.tissue);
        visitor(record.detail);
        std::uint32_t bits = 0;
        visitor(bits);
        std::memcpy(&record.value, &bits, sizeof bits);
    }
    static int partner(std::size_t) { return -1; }
    static Guides guides(std::size_t) { return no_guides; }
    static std::uint32_t first_tick(const Event& record) { return record.tick; }
    static std::uint32_t last_tick(const Event& record) { return record.tick; }
};

}  // namespace fulcrum::database
