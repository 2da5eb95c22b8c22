// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <random>
#include <vector>

namespace fulcrum {
namespace {

namespace files = std::filesystem;

// Nobody else names a file like this: what is removed as abandoned is ours.
constexpr const char* mark = ".part-fulcrum-";
constexpr std::size_t random_letters = 12;

[[noreturn]] void fail(const std::string& path, int error) {
    throw std::system_error(error, std::generic_category(), path);
}

files::path folder_of(const std::string& path) {
    const files::path folder = files::path(path).parent_path();
    return folder.empty() ? files::path(".") : folder;
}

/// The new name of a file is on the disk only when its folder is. Some file systems cannot do that for a
/// folder (EINVAL); the name is as safe there as they make it.
void sync_folder(const std::string& path) {
    const int folder = ::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;  // a folder that may be written but not listed
    const int failed = ::fsync(folder) != 0 ? errno : 0;
    ::close(folder);
    if (failed != 0 && failed != EINVAL) fail(path, failed);
}

/// Temporary files of the same output whose program has ended: nobody holds their lock.
void remove_abandoned(const std::string& path) {
    const std::string start = files::path(path).filename().string() + mark;
    std::error_code ignored;
    std::vector<files::path> found;
    for (files::directory_iterator entry(folder_of(path), ignored), end; !ignored && entry != end;
         entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        if (name.size() == start.size() + random_letters && name.compare(0, start.size(), start) == 0)
            found.push_back(entry->path());
    }
    for (const files::path& file : found) {
        const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
        if (descriptor < 0) continue;
        struct stat status {};
        const bool ours =
            ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
        if (ours && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(file.c_str());
        ::close(descriptor);
    }
}

void require_place(const std::string& path, OutputFile::Existing existing) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0) {
        if (errno != ENOENT) fail(path, errno);
        return;
    }
    const bool ours = S_ISREG(status.st_mode) || S_ISLNK(status.st_mode);
    if (!ours || existing == OutputFile::Existing::keep) fail(path, EEXIST);
}

/// -1 with errno EEXIST if the name is taken.
int make_file(std::string& temporary, const std::string& path, mode_t mode) {
    static constexpr char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
    std::random_device random;
    temporary = path + mark;
    for (std::size_t i = 0; i < random_letters; ++i) temporary += letters[random() % (sizeof letters - 1)];
    return ::open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
}

}  // namespace

OutputFile::OutputFile(std::string path, Existing existing, Access access)
    : path_(std::move(path)), existing_(existing) {
    require_place(path_, existing_);
    remove_abandoned(path_);
    for (;;) {
        descriptor_ = make_file(temporary_, path_, access == Access::owner_only ? 0600 : 0666);
        if (descriptor_ < 0) {
            if (errno == EEXIST) continue;
            fail(path_, errno);
        }
        // Another writer may take the file for an abandoned one until its lock is held.
        struct stat status {};
        const bool locked = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
        if (locked && ::fstat(descriptor_, &status) == 0 && status.st_nlink > 0) break;
        ::close(descriptor_);
    }
}

OutputFile::~OutputFile() {
    if (descriptor_ < 0) return;
    ::unlink(temporary_.c_str());
    ::close(descriptor_);
}

void OutputFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0) {
            if (errno == EINTR) continue;
            fail(path_, errno);
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void OutputFile::commit() {
    // A writer that replaces the temporary file by another of the same name leaves our descriptor on the old
    // one.
    struct stat ours {
    }, named{};
    if (::fstat(descriptor_, &ours) != 0 || ::lstat(temporary_.c_str(), &named) != 0) fail(path_, errno);
    if (ours.st_ino != named.st_ino || ours.st_dev != named.st_dev) fail(path_, ESTALE);
    if (::fsync(descriptor_) != 0) fail(path_, errno);
    if (existing_ == Existing::replace) {
        rename_replacing(temporary_, path_);
    } else if (!rename_without_replacing(temporary_, path_)) {
        fail(path_, EEXIST);
    }
    ::close(descriptor_);
    descriptor_ = -1;
}

void write_output_file(const std::string& path, std::string_view content, OutputFile::Existing existing,
                       OutputFile::Access access) {
    OutputFile file(path, existing, access);
    file.write(content);
    file.commit();
}

bool rename_without_replacing(const std::string& from, const std::string& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) != 0) {
        if (errno == EEXIST) return false;
        if (errno != EINVAL && errno != ENOSYS) fail(to, errno);
        // A file system without that call: a second name, then the first one goes.
        if (::link(from.c_str(), to.c_str()) != 0) {
            if (errno == EEXIST) return false;
            fail(to, errno);
        }
        ::unlink(from.c_str());
    }
    sync_folder(to);
    return true;
}

void rename_replacing(const std::string& from, const std::string& to) {
    if (::rename(from.c_str(), to.c_str()) != 0) fail(to, errno);
    sync_folder(to);
}

}  // namespace fulcrum
