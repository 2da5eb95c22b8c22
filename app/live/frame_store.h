// SPDX-License-Identifier: GPL-3.0-or-later
// Key frames of one replay, in order: engine states with their place in the record.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "app/live/frame_file.h"
#include "app/live/state_difference.h"
#include "assessment/attempt/replay_cursor.h"
#include "sim_core/numerics/state_archive.h"

namespace fulcrum::app {

/// Every frames_in_group-th frame is kept whole, the others as the difference from the one before; all are
/// packed. Bounded: above most_bytes every second frame is dropped and the distance doubles, so that seeks
/// take longer and memory does not grow with the attempt. add() from one thread, the rest from any.
class FrameStore {
  public:
    /// Ten minutes of the largest scene fit, also on a slow machine (docs/results/lab_seek.md).
    static constexpr std::size_t most_bytes = 384U << 20U;
    static constexpr std::size_t frames_in_group = 32;
    /// s of processor time that simulating from one frame to the next may take, of the 0.2 s of a seek.
    static constexpr double longest_gap_s = 0.08;

    explicit FrameStore(std::size_t most = most_bytes) : most_(most) {}

    /// Whether the cursor, which has run for `run_s` since the last frame, shall leave one here.
    bool wants(double run_s) const { return run_s >= gap_s_; }
    void add(ReplayCursor& cursor);
    /// The same of an attempt that is performed: after a step, with every tick stepped.
    void add(AttemptEngine& engine, ReplayPlace& place);
    /// In place of what is here: the frames of a file, which are read when they are asked for; null: none.
    /// Of add()'s thread, which adds none to them.
    void restore(std::shared_ptr<const FrameFile> file);
    /// In place of what is here: frames() of another one. Of add()'s thread, which continues from the last.
    /// Throws StateArchiveError, StoreError.
    void restore(std::vector<PackedFrame> frames);
    /// All frames, to be kept in a file.
    std::vector<PackedFrame> frames() const;
    /// Tick of the last frame at or before this one; -1: there is none.
    std::int64_t before(std::uint32_t tick) const;
    /// The cursor's state (ReplayCursor::transfer) at that frame; empty: there is none. This and put() throw
    /// StateArchiveError, StoreError where the file is damaged.
    std::vector<std::uint8_t> state(std::uint32_t tick) const;
    /// Brings the cursor to that frame; where there is none, it stays.
    void put(std::uint32_t tick, ReplayCursor& cursor) const;

    std::size_t bytes() const;
    std::size_t count() const;
    /// Of the newest frame, neither packed nor a difference; add()'s thread.
    std::size_t plain_bytes() const { return newest_.bytes.size(); }

  private:
    using Frame = PackedFrame;
    StateArchive new_frame();
    void keep_new_frame(std::uint32_t tick);
    static Frame packed(std::size_t number, std::uint32_t tick, const StateImage& before,
                        const StateImage& image);
    static void unpack(std::size_t number, const std::vector<std::uint8_t>& packed, StateImage& image,
                       StateImage& spare);
    void drop_every_second();

    const std::size_t most_;
    double gap_s_ = longest_gap_s;  ///< add()'s thread, as what follows
    StateImage newest_, added_;
    mutable std::mutex mutex_;   ///< guards what follows
    std::vector<Frame> frames_;  ///< with ticks alone where they are in file_
    std::shared_ptr<const FrameFile> file_;
    std::size_t bytes_ = 0;
};

}  // namespace fulcrum::app
