// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/packed_ticks.h"

#include <algorithm>

namespace fulcrum::database {

class PackedTickReader : public TickReader {
  public:
    explicit PackedTickReader(std::shared_ptr<const PackedTicks> ticks) : ticks_(std::move(ticks)) {}

    const RigSample& input(std::size_t index) override {
        bring(index);
        return unpacked_.inputs[index - begin_];
    }
    const TickSample& sample(std::size_t index) override {
        bring(index);
        return unpacked_.samples[index - begin_];
    }
    std::size_t at_or_after(std::uint32_t tick) override {
        const auto& parts = ticks_->parts_;
        const auto part =
            std::lower_bound(parts.begin(), parts.end(), tick,
                             [](const PackedTicks::Part& one, std::uint32_t t) { return one.last_tick < t; });
        if (part == parts.end()) return ticks_->size();
        bring(part->first);
        const std::vector<TickSample>& samples = unpacked_.samples;
        const auto found =
            std::lower_bound(samples.begin(), samples.end(), tick,
                             [](const TickSample& sample, std::uint32_t t) { return sample.tick < t; });
        return begin_ + static_cast<std::size_t>(found - samples.begin());
    }

  private:
    void bring(std::size_t index) {
        if (index >= begin_ && index < begin_ + unpacked_.samples.size()) return;
        const auto& parts = ticks_->parts_;
        const auto after =
            std::upper_bound(parts.begin(), parts.end(), index,
                             [](std::size_t i, const PackedTicks::Part& one) { return i < one.first; });
        const PackedTicks::Part& part = *(after - 1);
        PackedTicks::unpack(codec_, part, unpacked_);
        begin_ = part.first;
    }

    std::shared_ptr<const PackedTicks> ticks_;
    TraceCodec codec_;
    PackedTicks::Unpacked unpacked_;
    std::size_t begin_ = 0;
};

void PackedTicks::unpack(TraceCodec& codec, const Part& part, Unpacked& into) {
    into.inputs.clear();
    into.samples.clear();
    codec.decode(part.inputs, into.inputs);
    codec.decode(part.samples, into.samples, &into.inputs);
}

bool PackedTicks::add(TraceChunk inputs, TraceChunk samples) {
    Part part{std::move(inputs), std::move(samples), size_};
    unpack(codec_, part, checked_);
    const auto same_tick = [](const RigSample& input, const TickSample& sample) {
        return input.tick == sample.tick;
    };
    if (checked_.samples.empty() || !std::equal(checked_.inputs.begin(), checked_.inputs.end(),
                                                checked_.samples.begin(), checked_.samples.end(), same_tick))
        return false;
    part.first_tick = checked_.samples.front().tick;
    part.last_tick = checked_.samples.back().tick;
    last_ = checked_.samples.back();
    size_ += checked_.samples.size();
    parts_.push_back(std::move(part));
    return true;
}

std::unique_ptr<TickReader> PackedTicks::reader() const {
    return std::make_unique<PackedTickReader>(shared_from_this());
}

}  // namespace fulcrum::database
