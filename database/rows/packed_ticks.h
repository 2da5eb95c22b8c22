// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs and samples of a stored attempt in memory as they are stored: some tens of megabytes an hour. A
// reader unpacks a chunk at a time.
#pragma once

#include <vector>

#include "database/rows/trace_codec.h"
#include "sim_core/instrument/record_ticks.h"

namespace fulcrum::database {

class PackedTicks : public RecordTicks, public std::enable_shared_from_this<PackedTicks> {
  public:
    /// The next chunk of both streams. Unpacks them once, so that no reader ever fails. Throws StoreError
    /// corrupt; false, and nothing is added, where they are not of the same ticks.
    bool add(TraceChunk inputs, TraceChunk samples);

    std::size_t size() const override { return size_; }
    std::uint32_t first_tick() const override { return parts_.front().first_tick; }
    const TickSample& last_sample() const override { return last_; }
    /// Only of one that a shared pointer owns: the reader shares it.
    std::unique_ptr<TickReader> reader() const override;

  private:
    friend class PackedTickReader;
    struct Part {
        TraceChunk inputs, samples;
        std::size_t first = 0;  ///< index of its first sample
        std::uint32_t first_tick = 0, last_tick = 0;
    };
    struct Unpacked {
        std::vector<RigSample> inputs;
        std::vector<TickSample> samples;
    };
    static void unpack(TraceCodec& codec, const Part& part, Unpacked& into);

    std::vector<Part> parts_;
    std::size_t size_ = 0;
    TickSample last_;
    TraceCodec codec_;  ///< while chunks are added
    Unpacked checked_;
};

}  // namespace fulcrum::database
