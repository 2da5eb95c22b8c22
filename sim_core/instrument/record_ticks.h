// SPDX-License-Identifier: Apache-2.0
// The inputs and samples of a recorded attempt by their index. An hour of them takes 1.1 GB of memory, so
// that whoever keeps an attempt open keeps them packed, and each of its readers unpacks the part that it
// looks at.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim_core/instrument/device.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum {

/// Used by one thread. A reference holds until it is asked for another index. Keeps what it reads alive.
class TickReader {
  public:
    virtual ~TickReader() = default;
    virtual const RigSample& input(std::size_t index) = 0;
    virtual const TickSample& sample(std::size_t index) = 0;
    /// Index of the first sample at or after the tick; the number of samples where there is none.
    virtual std::size_t at_or_after(std::uint32_t tick) = 0;
};

/// As many inputs as samples, ticks rising. Constant once made; any thread.
class RecordTicks {
  public:
    virtual ~RecordTicks() = default;
    virtual std::size_t size() const = 0;
    /// Only where there are any.
    virtual std::uint32_t first_tick() const = 0;
    virtual const TickSample& last_sample() const = 0;
    virtual std::unique_ptr<TickReader> reader() const = 0;
};

/// Those that are in memory as they are.
class TicksInMemory : public RecordTicks {
  public:
    /// `owner` keeps both alive. Both of the same length.
    TicksInMemory(std::shared_ptr<const void> owner, const std::vector<RigSample>& inputs,
                  const std::vector<TickSample>& samples)
        : owner_(std::move(owner)), inputs_(inputs), samples_(samples) {}
    std::size_t size() const override { return samples_.size(); }
    std::uint32_t first_tick() const override { return samples_.front().tick; }
    const TickSample& last_sample() const override { return samples_.back(); }
    std::unique_ptr<TickReader> reader() const override;

  private:
    std::shared_ptr<const void> owner_;
    const std::vector<RigSample>& inputs_;
    const std::vector<TickSample>& samples_;
};

}  // namespace fulcrum
