// SPDX-License-Identifier: GPL-3.0-or-later
// Key frames of stored attempts that have none (cut off by a killed program, fetched from the programme
// server, of the demonstration, recorded by another build of the program), made on a thread of the lowest
// priority so that the first opening of their replays need not make them.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "app/live/frame_file.h"
#include "database/records/attempts.h"

namespace fulcrum::app {

class FrameStore;

/// Owner's thread. Nothing here throws, and nothing depends on it: a replay without frames makes them.
class FramesInAdvance {
  public:
    /// Attempts that are looked at: the newest that the session may read.
    static constexpr int most_attempts = 40;
    /// Of all files in the folder; above it nothing is made in advance. Half of what they may take, so that
    /// one made in advance never displaces another.
    static constexpr std::uint64_t most_bytes = FrameKeeping::most_in_folder / 2;

    FramesInAdvance() = default;
    ~FramesInAdvance() { finish(); }
    FramesInAdvance(const FramesInAdvance&) = delete;
    FramesInAdvance& operator=(const FramesInAdvance&) = delete;

    /// Looks for attempts without frames and makes them, unless it is at work; returns at once. `except`:
    /// attempts that are left out, because their replays are open.
    void begin(const std::string& store_path, const database::Session& session,
               std::set<std::string> except = {}) noexcept;
    /// Stops soon; does not wait.
    void stop() noexcept;
    /// Stops, and waits until the store is closed here.
    void finish() noexcept;
    bool at_work() const { return work_ != nullptr && !work_->ended.load(); }
    /// Its replay is opened. Stops soon, and gives the frames made so far where the work is on this attempt;
    /// the next begin() looks at it again. Does not wait.
    std::vector<PackedFrame> take(const std::string& attempt_id) noexcept;

  private:
    /// What the thread and the owner share.
    struct Work {
        Work(std::string path, const database::Session& who) : store_path(std::move(path)), session(who) {}

        const std::string store_path;
        const database::Session session;
        std::set<std::string> except;
        std::set<std::string> seen;  ///< need not be looked at again; the thread's until it has ended
        std::atomic<bool> stop{false}, ended{false};

        std::mutex mutex;                    ///< guards what follows
        std::string attempt_id;              ///< that is worked on
        std::shared_ptr<FrameStore> frames;  ///< the thread alone adds
    };
    static void run(Work& work) noexcept;
    static void make_all(Work& work);
    static void make_one(Work& work, const database::Store& store, const database::Attempts& attempts,
                         const database::AttemptSummary& attempt);

    std::shared_ptr<Work> work_;
    std::set<std::string> opened_;  ///< since the last begin()
    std::thread thread_;
};

}  // namespace fulcrum::app
