// SPDX-License-Identifier: GPL-3.0-or-later
// Key frames of an attempt while it runs, so that its replay can be sought anywhere as soon as it is over: a
// second engine makes the record again, a moment behind the hands, on a thread of the lowest priority. The
// attempt's own threads do nothing for it but copy what they record.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/live/frame_store.h"
#include "app/live/real_time.h"
#include "app/live/replay_player.h"

namespace fulcrum::app {

/// begin() to complete() from the recorder's thread, the rest from any other. Nothing here throws: without
/// frames the first opening of the replay makes them.
class FrameFollower {
  public:
    /// Bytes of a record that waits to be made again; where it falls back further it gives up.
    static constexpr std::size_t most_waiting = 256U << 20U;

    explicit FrameFollower(std::size_t most = most_waiting) : most_(most) {}
    /// Stops; what is not in a file then is lost.
    ~FrameFollower();
    FrameFollower(const FrameFollower&) = delete;
    FrameFollower& operator=(const FrameFollower&) = delete;

    /// The follower of the attempt before: it ends on this one's thread, since only that may wait for it.
    void replaces(std::shared_ptr<FrameFollower> previous) { previous_ = std::move(previous); }
    /// The attempt begins.
    void begin(ReplayStart start, const ForceDevices& devices) noexcept;
    /// An input and what it led to, in pairs.
    void append(const RigSample& input, const TickSample& sample) noexcept;
    void append(const StepRecord& step) noexcept;
    /// After appending, where every step that the ticks so far depend on was appended too. Never waits.
    void hand_on() noexcept;
    /// The attempt is stored. The rest is made, then the file is written.
    void complete(const std::string& attempt_id, FrameKeeping keeping) noexcept;

    /// After complete(): makes what is missing in the calling thread, which waits for the follower's first.
    /// False where there are no frames.
    bool finish_here() noexcept;
    /// Memory that the frames and what waits to be made take; any thread.
    std::size_t bytes() const noexcept { return waiting_bytes_.load() + made_bytes_.load(); }
    /// Stops soon, and gives the frames made so far, of the record's beginning; none where this is another
    /// attempt, where the file is written already, or where there are none. Does not wait.
    std::vector<PackedFrame> take(const std::string& attempt_id) noexcept;

  private:
    struct Waiting {
        std::vector<RigSample> inputs;
        std::vector<TickSample> samples;
        std::vector<StepRecord> steps;
        std::size_t bytes() const noexcept;
    };
    void run() noexcept;
    void make_or_give_up() noexcept;
    void make();
    void make_slice(std::uint32_t until);
    void fetch();
    bool write_file();
    void give_up() noexcept { given_up_.store(true); }
    void stop() noexcept;

    const std::size_t most_;
    std::shared_ptr<FrameFollower> previous_;
    ReplayStart start_;
    std::thread thread_;
    Signal there_is_more_;
    std::atomic<bool> stop_{false}, given_up_{false}, written_{false};
    std::atomic<std::size_t> waiting_bytes_{0};  ///< of what is appended; the recorder's thread writes it
    std::atomic<std::size_t> made_bytes_{0};     ///< of frames and record; the follower's thread writes it

    Waiting appended_;  ///< recorder's thread

    std::mutex mutex_;  ///< guards what follows
    Waiting waiting_;
    bool complete_ = false;
    std::string attempt_id_;
    FrameKeeping keeping_;
    std::shared_ptr<FrameStore> frames_;  ///< the follower's thread alone adds to it

    // The follower's thread's own; after its end the owner's.
    AttemptRecord record_;      ///< what is not made yet
    std::uint32_t newest_ = 0;  ///< tick
    bool whole_ = false;        ///< nothing comes any more
    std::optional<ReplayPlayer> player_;
    double since_frame_ = 0;             ///< s
    std::size_t run_since_dropped_ = 0;  ///< ticks
};

}  // namespace fulcrum::app
