// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/recording_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "database/rows/connection.h"
#include "database/rows/errors.h"

namespace fulcrum::database {
namespace {

std::string lock_file(const std::string& store_path, const std::string& attempt_id) {
    std::error_code unknown;
    const std::filesystem::path path = std::filesystem::canonical(store_path, unknown);
    return (unknown ? store_path : path.string()) + ".recording-" + attempt_id;
}

struct LockRow {
    std::string file, boot;
    std::int64_t inode = 0;
};

/// What the store says of the lock; attempts of older programs are not entered.
LockRow row_of(const Store& store, const std::string& attempt_id) {
    Query row(store.connection(), "SELECT lock_file, boot, inode FROM recording WHERE attempt_id = ?");
    row.bind(attempt_id);
    if (row.next()) return {row.text(0), row.text(1), row.integer(2)};
    return {lock_file(store.path(), attempt_id), store.boot_time().boot, 0};
}

}  // namespace

RecordingLock::RecordingLock(const std::string& store_path, const std::string& attempt_id)
    : file_(lock_file(store_path, attempt_id)) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    struct stat status {};
    if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 ||
        ::fstat(descriptor_, &status) != 0) {
        const int error = errno;
        if (descriptor_ >= 0) ::close(descriptor_);
        throw StoreError(
            error == ENOSPC ? StoreErrorKind::disk_full : StoreErrorKind::read_only,
            {QT_TRANSLATE_NOOP("errors", "%1: cannot be created (%2)"), file_, std::strerror(error)},
            QT_TRANSLATE_NOOP("errors",
                              "make the store's folder writable and free some space on the disk; nothing was "
                              "recorded yet"));
    }
    inode_ = static_cast<std::int64_t>(status.st_ino);
}

RecordingLock::~RecordingLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void RecordingLock::enter(const Store& store, const std::string& attempt_id) const {
    Query(store.connection(),
          "INSERT INTO recording (attempt_id, lock_file, inode, boot) VALUES (?, ?, ?, ?)")
        .bind(attempt_id)
        .bind(file_)
        .bind(inode_)
        .bind(store.boot_time().boot)
        .run();
}

void RecordingLock::leave(const Store& store, const std::string& attempt_id) {
    Query(store.connection(), "DELETE FROM recording WHERE attempt_id = ?").bind(attempt_id).run();
}

void RecordingLock::release() noexcept {
    if (descriptor_ < 0) return;
    ::unlink(file_.c_str());
    ::close(descriptor_);
    descriptor_ = -1;
}

bool RecordingLock::is_held(const Store& store, const std::string& attempt_id) {
    const LockRow row = row_of(store, attempt_id);
    if (row.boot != store.boot_time().boot) return false;
    const int descriptor = ::open(row.file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) return errno != ENOENT;
    struct stat status {};
    const bool same = row.inode == 0 || (::fstat(descriptor, &status) == 0 &&
                                         static_cast<std::int64_t>(status.st_ino) == row.inode);
    const bool held = !same || ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
    ::close(descriptor);
    return held;
}

void RecordingLock::clean(const Store& store, const std::string& attempt_id) noexcept {
    try {
        ::unlink(row_of(store, attempt_id).file.c_str());
    } catch (const StoreError&) {
        // A file that is left behind is only untidy.
    }
}

}  // namespace fulcrum::database
