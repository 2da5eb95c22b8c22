// SPDX-License-Identifier: GPL-3.0-or-later
// Chunks of a trace: delta-coded integers, field by field, zstd, with a checksum over the compressed bytes.
// Lossless. Decoding never trusts its input: sizes and counts are bounded before anything is allocated. Pure,
// any thread. Layout: docs/FORMATS.md.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim_core/instrument/device.h"
#include "sim_core/instrument/record_ticks.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum::database {

/// Stored numbers; add at the end.
enum class TraceStream : std::uint8_t { samples = 0, inputs = 1, steps = 2, events = 3 };
const char* stream_name(TraceStream stream);

inline constexpr std::size_t chunk_maximum_records = 16384;
inline constexpr std::size_t chunk_maximum_bytes = 8U << 20U;  ///< compressed

struct TraceChunk {
    TraceStream stream = TraceStream::samples;
    std::uint32_t first_tick = 0;  ///< of the first record (steps: its first input tick)
    std::uint32_t last_tick = 0;
    std::uint32_t count = 0;
    std::vector<std::uint8_t> data;      ///< compressed
    std::vector<std::uint8_t> checksum;  ///< BLAKE2b-128 of `data`
};

/// What a chart of forces and a picture of paths need of a chunk of samples: column by column, units as in
/// TickSample.
struct TraceOverview {
    struct Hand {
        std::array<std::vector<std::uint32_t>, 3> tip, force;  ///< two's complement
        std::vector<std::uint32_t> flags;
    };
    std::vector<std::uint32_t> tick;
    std::array<Hand, hand_count> hand;
};

/// Throws StoreError corrupt: checksum, size, layout.
class TraceCodec {
  public:
    TraceCodec();
    ~TraceCodec();
    TraceCodec(const TraceCodec&) = delete;
    TraceCodec& operator=(const TraceCodec&) = delete;

    /// At most chunk_maximum_records records; at least one.
    /// `inputs`: the inputs of the same ticks, one for each record, or null. With them a chunk is about a
    /// third smaller, and decoding needs them again.
    TraceChunk encode(const TickSample* records, std::size_t count, const RigSample* inputs = nullptr);
    TraceChunk encode(const RigSample* records, std::size_t count);
    TraceChunk encode(const StepRecord* records, std::size_t count);
    TraceChunk encode(const Event* records, std::size_t count);

    /// Appends to `records`. `inputs`: those of the whole attempt so far, ticks rising.
    void decode(const TraceChunk& chunk, std::vector<TickSample>& records,
                const std::vector<RigSample>* inputs = nullptr);
    void decode(const TraceChunk& chunk, std::vector<RigSample>& records);
    void decode(const TraceChunk& chunk, std::vector<StepRecord>& records);
    void decode(const TraceChunk& chunk, std::vector<Event>& records);

    /// Those columns alone, several times faster than the whole. `inputs`: the chunk of the same ticks, null
    /// where there is none. The checksums cover all of both.
    void decode_overview(const TraceChunk& samples, const TraceChunk* inputs, TraceOverview& overview);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// A whole attempt's record, in order.
struct Trace {
    std::vector<TickSample> samples;
    std::vector<RigSample> inputs;
    std::vector<StepRecord> steps;
    std::vector<Event> events;
    std::shared_ptr<const RecordTicks> ticks = {};  ///< in place of samples and inputs, which are empty then

    std::size_t tick_count() const { return ticks != nullptr ? ticks->size() : samples.size(); }
};
/// Its samples and inputs, wherever they are. As many of both.
std::shared_ptr<const RecordTicks> ticks_of(const std::shared_ptr<const Trace>& trace);

}  // namespace fulcrum::database
