// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/recording_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "database/rows/errors.h"

namespace fulcrum::database {
namespace {

std::string lock_file(const std::string& store_path, const std::string& attempt_id) {
    return store_path + ".recording-" + attempt_id;
}

}  // namespace

RecordingLock::RecordingLock(const std::string& store_path, const std::string& attempt_id)
    : file_(lock_file(store_path, attempt_id)) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
        const int error = errno;
        if (descriptor_ >= 0) ::close(descriptor_);
        throw StoreError(
            error == ENOSPC ? StoreErrorKind::disk_full : StoreErrorKind::read_only,
            file_ + ": cannot be made (" + std::strerror(error) + ")",
            "make the store's folder writable and leave room on the disk; nothing was recorded yet");
    }
}

RecordingLock::~RecordingLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void RecordingLock::release() noexcept {
    if (descriptor_ < 0) return;
    ::unlink(file_.c_str());
    ::close(descriptor_);
    descriptor_ = -1;
}

bool RecordingLock::is_held(const std::string& store_path, const std::string& attempt_id) {
    const int descriptor = ::open(lock_file(store_path, attempt_id).c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
    ::close(descriptor);
    return held;
}

void RecordingLock::clean(const std::string& store_path, const std::string& attempt_id) noexcept {
    ::unlink(lock_file(store_path, attempt_id).c_str());
}

}  // namespace fulcrum::database
