// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/kept_frames.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "database/rows/connection.h"

namespace fulcrum::database {
namespace {

constexpr const char* frames_suffix = ".frames";

/// The files of a folder of frames; none where it is not our own folder.
class FramesFolder {
  public:
    explicit FramesFolder(const std::string& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)) {
        struct stat status {};
        if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0 || status.st_uid != ::geteuid()) return;
        DIR* listing = ::fdopendir(::dup(descriptor_));
        if (listing == nullptr) return;
        while (const dirent* entry = ::readdir(listing)) {
            const std::string name = entry->d_name;
            // What is being written has more after the suffix.
            if (name.find(frames_suffix) != std::string::npos) names_.push_back(name);
        }
        ::closedir(listing);
    }
    ~FramesFolder() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    FramesFolder(const FramesFolder&) = delete;
    FramesFolder& operator=(const FramesFolder&) = delete;

    const std::vector<std::string>& names() const { return names_; }
    bool remove(const std::string& name) const { return ::unlinkat(descriptor_, name.c_str(), 0) == 0; }

  private:
    int descriptor_;
    std::vector<std::string> names_;
};

std::string attempt_of(const std::string& file_name) {
    return file_name.substr(0, file_name.find(frames_suffix));
}

}  // namespace

std::string kept_frames_folder(const std::string& store_path) {
    std::error_code unknown;
    const std::filesystem::path path = std::filesystem::canonical(store_path, unknown);
    return (unknown ? store_path : path.string()) + frames_suffix;
}

std::string kept_frames_folder(const Store& store) {
    if (store.is_server() || store.is_read_only()) return {};
    return kept_frames_folder(store.path());
}

std::string kept_frames_name(const std::string& attempt_id) {
    constexpr std::size_t longest = 64;
    const bool plain = std::all_of(attempt_id.begin(), attempt_id.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
    });
    return plain && !attempt_id.empty() && attempt_id.size() <= longest ? attempt_id + frames_suffix : "";
}

void remove_kept_frames(const Store& store, const std::string& attempt_id) noexcept {
    try {
        const std::string path = kept_frames_folder(store);
        if (path.empty()) return;
        const FramesFolder folder(path);
        for (const std::string& name : folder.names())
            if (attempt_of(name) == attempt_id) folder.remove(name);
    } catch (const std::exception&) {  // frames that stay are removed at the next start
    }
}

void remove_all_kept_frames(const std::string& store_path) noexcept {
    try {
        const std::string path = kept_frames_folder(store_path);
        {
            const FramesFolder folder(path);
            for (const std::string& name : folder.names()) folder.remove(name);
        }
        ::rmdir(path.c_str());  // stays where something of somebody else is in it
    } catch (const std::exception&) {
    }
}

int remove_frames_without_attempt(const Store& store) noexcept {
    int removed = 0;
    try {
        const std::string path = kept_frames_folder(store);
        if (path.empty()) return 0;
        const FramesFolder folder(path);
        for (const std::string& name : folder.names()) {
            Query row(store.connection(), "SELECT 1 FROM attempt WHERE id = ?");
            row.bind(attempt_of(name));
            if (!row.next() && folder.remove(name)) ++removed;
        }
    } catch (const std::exception&) {
    }
    return removed;
}

}  // namespace fulcrum::database
