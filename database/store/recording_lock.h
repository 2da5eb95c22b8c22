// SPDX-License-Identifier: GPL-3.0-or-later
// Distinguishes a recording in progress from one whose program died: an advisory lock on a small file next to
// the store, held as long as the recorder lives and let go by the kernel however it ends. Internal to this
// floor.
#pragma once

#include <string>

namespace fulcrum::database {

class RecordingLock {
  public:
    /// Takes the lock; throws StoreError read_only or disk_full if the file cannot be made.
    RecordingLock(const std::string& store_path, const std::string& attempt_id);
    ~RecordingLock();
    RecordingLock(const RecordingLock&) = delete;
    RecordingLock& operator=(const RecordingLock&) = delete;
    /// Lets go and removes the file; the attempt has ended.
    void release() noexcept;
    /// True while some recorder of the attempt lives, in this program or another.
    static bool is_held(const std::string& store_path, const std::string& attempt_id);
    /// Removes what a dead recorder left.
    static void clean(const std::string& store_path, const std::string& attempt_id) noexcept;

  private:
    std::string file_;
    int descriptor_ = -1;
};

}  // namespace fulcrum::database
