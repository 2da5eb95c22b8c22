// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/frame_store.h"

#include <algorithm>

#include "database/rows/packed_bytes.h"

namespace fulcrum::app {
namespace {

constexpr int packing_level = 2;  // of zstd: as fast as 1 here, and a tenth smaller

}  // namespace

/// Frame `number` of a list; a whole one is the difference from nothing.
FrameStore::Frame FrameStore::packed(std::size_t number, std::uint32_t tick, const StateImage& before,
                                     const StateImage& image) {
    const bool whole = number % frames_in_group == 0;
    return {tick, std::make_shared<const std::vector<std::uint8_t>>(database::pack_bytes(
                      state_difference(whole ? StateImage() : before, image), packing_level))};
}

/// `image`: of the frame before; anything where this one is whole. `spare`: anything, for its memory.
void FrameStore::unpack(std::size_t number, const std::vector<std::uint8_t>& packed, StateImage& image,
                        StateImage& spare) {
    if (number % frames_in_group == 0) {
        image.bytes.clear();
        image.starts.clear();
    }
    apply_difference(image, database::unpack_bytes(packed), spare);
    if (image.bytes.size() > database::packed_maximum_bytes)  // of a file: each frame could add as much
        throw StateArchiveError(
            QT_TRANSLATE_NOOP("errors", "a kept key frame cannot be read, or does not match its checksum"));
}

void FrameStore::restore(std::shared_ptr<const FrameFile> file) {
    std::vector<Frame> frames;
    for (std::size_t i = 0; file != nullptr && i < file->count(); ++i)
        frames.push_back({file->tick(i), nullptr});
    newest_ = {};
    gap_s_ = longest_gap_s;
    const std::lock_guard<std::mutex> lock(mutex_);
    bytes_ = file != nullptr ? file->bytes() : 0;
    frames_ = std::move(frames);
    file_ = std::move(file);
}

void FrameStore::restore(std::vector<PackedFrame> frames) {
    StateImage last, spare;
    const std::size_t count = frames.size();
    std::size_t bytes = 0;
    for (std::size_t i = count - count % frames_in_group; i < count; ++i)
        unpack(i, *frames[i].packed, last, spare);
    for (const PackedFrame& frame : frames) bytes += frame.packed->size();
    newest_ = std::move(last);
    gap_s_ = longest_gap_s;
    const std::lock_guard<std::mutex> lock(mutex_);
    bytes_ = bytes;
    frames_ = std::move(frames);
    file_.reset();
}

std::vector<PackedFrame> FrameStore::frames() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return frames_;
}

void FrameStore::add(ReplayCursor& cursor) {
    StateArchive archive = new_frame();
    cursor.transfer(archive);
    keep_new_frame(cursor.tick());
}

void FrameStore::add(AttemptEngine& engine, ReplayPlace& place) {
    StateArchive archive = new_frame();
    place.transfer(archive, engine);
    keep_new_frame(engine.next_tick() - 1);
}

StateArchive FrameStore::new_frame() {
    added_.bytes.clear();
    added_.starts.clear();
    return StateArchive(added_.bytes, &added_.starts);
}

void FrameStore::keep_new_frame(std::uint32_t tick) {
    Frame frame = packed(frames_.size(), tick, newest_, added_);
    std::swap(newest_, added_);
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        bytes_ += frame.packed->size();
        frames_.push_back(std::move(frame));
    }
    while (bytes_ > most_ && frames_.size() > 2) drop_every_second();
}

void FrameStore::drop_every_second() {
    std::vector<Frame> kept;
    std::size_t bytes = 0;
    StateImage image, spare, last;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        unpack(i, *frames_[i].packed, image, spare);
        if (i % 2 != 0) continue;
        kept.push_back(packed(kept.size(), frames_[i].tick, last, image));
        bytes += kept.back().packed->size();
        last = image;
    }
    newest_ = std::move(last);
    gap_s_ *= 2;
    const std::lock_guard<std::mutex> lock(mutex_);
    frames_ = std::move(kept);
    bytes_ = bytes;
}

std::int64_t FrameStore::before(std::uint32_t tick) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto after = std::upper_bound(frames_.begin(), frames_.end(), tick,
                                        [](std::uint32_t t, const Frame& frame) { return t < frame.tick; });
    return after == frames_.begin() ? -1 : static_cast<std::int64_t>((after - 1)->tick);
}

std::vector<std::uint8_t> FrameStore::state(std::uint32_t tick) const {
    std::vector<Frame> group;  // from its whole frame to the one asked for
    std::shared_ptr<const FrameFile> file;
    std::size_t first = 0;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto after =
            std::upper_bound(frames_.begin(), frames_.end(), tick,
                             [](std::uint32_t t, const Frame& frame) { return t < frame.tick; });
        if (after == frames_.begin()) return {};
        const auto last = static_cast<std::size_t>(after - frames_.begin()) - 1;
        first = last - last % frames_in_group;
        group.assign(frames_.begin() + static_cast<std::ptrdiff_t>(first), after);
        file = file_;
    }
    StateImage image, spare;
    for (std::size_t i = 0; i < group.size(); ++i)
        unpack(i, file != nullptr ? file->packed(first + i) : *group[i].packed, image, spare);
    return std::move(image.bytes);
}

void FrameStore::put(std::uint32_t tick, ReplayCursor& cursor) const {
    const std::vector<std::uint8_t> bytes = state(tick);
    if (bytes.empty()) return;
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
