// SPDX-License-Identifier: GPL-3.0-or-later
// Kills a deed before one of its changes to files: a forked child is traced (ptrace), and gets SIGKILL before
// its n-th system call that writes, shortens, creates, renames, links or removes a file. Between two of them
// a kill leaves the same files, so n = 1, 2, 3 … covers a kill at every statement, and within statements.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace fulcrum::database::test {

struct CutOff {
    bool killed = false;  ///< false: the deed ended first
    int status = -1;      ///< of a deed that ended: 0, or 1 where it threw (the message is printed)
    int changes = 0;      ///< changes made (killed: before the kill)
    std::string call;     ///< the one that was not made
};

/// False where this machine forbids tracing; tests are skipped then.
bool can_trace();
/// `number` 0: never killed. No connection to a store may be open in this process.
CutOff cut_off(int number, const std::function<void()>& deed);
/// Which of 1 … `all` to take: every one if the environment variable FULCRUM_CUT_OFF is set, else about
/// `few`, evenly, the first and last included.
std::vector<int> cut_off_points(int all, int few);

/// While it exists, temporary folders are made in memory, where the machine has such a place: a test that
/// kills does not wait for a disk. A kill leaves the same files there as on a disk; a power cut would not.
class TemporaryFoldersInMemory {
  public:
    TemporaryFoldersInMemory();
    ~TemporaryFoldersInMemory();
    TemporaryFoldersInMemory(const TemporaryFoldersInMemory&) = delete;
    TemporaryFoldersInMemory& operator=(const TemporaryFoldersInMemory&) = delete;

  private:
    std::string before_;
};

}  // namespace fulcrum::database::test
