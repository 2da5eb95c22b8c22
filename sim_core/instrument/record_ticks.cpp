// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/record_ticks.h"

#include <algorithm>

namespace fulcrum {
namespace {

class MemoryTickReader : public TickReader {
  public:
    MemoryTickReader(std::shared_ptr<const void> owner, const std::vector<RigSample>& inputs,
                     const std::vector<TickSample>& samples)
        : owner_(std::move(owner)), inputs_(inputs), samples_(samples) {}
    const RigSample& input(std::size_t index) override { return inputs_[index]; }
    const TickSample& sample(std::size_t index) override { return samples_[index]; }
    std::size_t at_or_after(std::uint32_t tick) override {
        const auto found =
            std::lower_bound(samples_.begin(), samples_.end(), tick,
                             [](const TickSample& sample, std::uint32_t t) { return sample.tick < t; });
        return static_cast<std::size_t>(found - samples_.begin());
    }

  private:
    std::shared_ptr<const void> owner_;
    const std::vector<RigSample>& inputs_;
    const std::vector<TickSample>& samples_;
};

}  // namespace

std::unique_ptr<TickReader> TicksInMemory::reader() const {
    return std::make_unique<MemoryTickReader>(owner_, inputs_, samples_);
}

}  // namespace fulcrum
