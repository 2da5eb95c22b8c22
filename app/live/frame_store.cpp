// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/frame_store.h"

#include <algorithm>

#include "database/rows/packed_bytes.h"
#include "sim_core/numerics/state_archive.h"

namespace fulcrum::app {

void FrameStore::add(ReplayCursor& cursor) {
    plain_.clear();
    StateArchive archive(plain_);
    cursor.transfer(archive);
    auto packed = std::make_shared<const std::vector<std::uint8_t>>(database::pack_bytes(plain_));
    const std::lock_guard<std::mutex> lock(mutex_);
    bytes_ += packed->size();
    frames_.push_back({cursor.tick(), std::move(packed)});
    while (bytes_ > most_ && frames_.size() > 2) {
        std::vector<Frame> kept;
        bytes_ = 0;
        for (std::size_t i = 0; i < frames_.size(); i += 2) {
            bytes_ += frames_[i].packed->size();
            kept.push_back(std::move(frames_[i]));
        }
        frames_ = std::move(kept);
        gap_s_ *= 2;
    }
}

FrameStore::Frame FrameStore::before(std::uint32_t tick) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto after = std::upper_bound(frames_.begin(), frames_.end(), tick,
                                        [](std::uint32_t t, const Frame& frame) { return t < frame.tick; });
    return after == frames_.begin() ? Frame() : *(after - 1);
}

void FrameStore::put(const Frame& frame, ReplayCursor& cursor) {
    const std::vector<std::uint8_t> bytes = database::unpack_bytes(*frame.packed);
    StateArchive archive(bytes.data(), bytes.size());
    cursor.transfer(archive);
}

std::size_t FrameStore::bytes() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return bytes_;
}

std::size_t FrameStore::count() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return frames_.size();
}

}  // namespace fulcrum::app
