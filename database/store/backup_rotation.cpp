// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/backup_rotation.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDateTime>
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <regex>

#include "database/store/store_file.h"

namespace fulcrum::database {
namespace {

namespace files = std::filesystem;

/// "fulcrum-1b4e28ba-": what the names of a station's backups begin with.
std::string start_of_names(const Store& store) {
    constexpr std::size_t letters = 8;
    std::string station;
    for (const char letter : store.station_id().substr(0, letters))
        station += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
    return "fulcrum-" + station + "-";
}

/// One rotation at a time in a folder: of two at once, one would count files that the other removes.
class FolderLock {
  public:
    explicit FolderLock(const std::string& folder)
        : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        if (folder_ < 0) fail_file(folder, errno);
        while (::flock(folder_, LOCK_EX) != 0 && errno == EINTR) {
        }
    }
    ~FolderLock() { ::close(folder_); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    /// The changed names are on the disk.
    void sync() const { ::fsync(folder_); }

  private:
    int folder_;
};

struct Names {
    std::vector<std::string> backups;    ///< oldest first
    std::vector<std::string> abandoned;  ///< unfinished copies of backups
};

/// Regular files of this account only: a link is somebody's, also where it has such a name.
Names names_in(const std::string& folder, const std::string& start) {
    const std::regex whole(start + "\\d{8}T\\d{6}Z\\.db"),
        part(start + "\\d{8}T\\d{6}Z\\.db\\.part-fulcrum-[a-z0-9]{12}");
    Names names;
    std::error_code failed;
    for (files::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        struct stat status {};
        if (::lstat(entry->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode) ||
            status.st_uid != ::geteuid())
            continue;
        if (std::regex_match(name, whole)) names.backups.push_back(name);
        if (std::regex_match(name, part)) names.abandoned.push_back(name);
    }
    if (failed) fail_file(folder, failed.value());
    std::sort(names.backups.begin(), names.backups.end());
    return names;
}

/// A copy whose program was killed: nobody holds its lock (OutputFile).
void remove_abandoned_copy(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file < 0) return;
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
    ::close(file);
}

}  // namespace

std::optional<RotatedBackup> backup_into(const Store& store, const Session& session,
                                         const std::string& folder, int keep, const StoreProgress& progress) {
    store.require(session, Operation::backup);
    if (keep < 1 || keep > most_kept_backups)
        throw StoreError(StoreErrorKind::bad_value,
                         {QT_TRANSLATE_NOOP("errors", "%1 backups cannot be kept"), keep},
                         {QT_TRANSLATE_NOOP("errors", "give a number from 1 to %1"), most_kept_backups});
    std::error_code failed;
    if (!files::is_directory(folder, failed))
        throw StoreError(StoreErrorKind::bad_value,
                         {QT_TRANSLATE_NOOP("errors", "%1: this is not a folder"), folder},
                         QT_TRANSLATE_NOOP("errors",
                                           "backups that replace one another need a folder: make it, or name "
                                           "another one"));
    const FolderLock lock(folder);
    const std::string start = start_of_names(store);
    for (const std::string& part : names_in(folder, start).abandoned)
        remove_abandoned_copy((files::path(folder) / part).string());
    const std::string name = start +
                             QDateTime::fromMSecsSinceEpoch(store.now(), Qt::UTC)
                                 .toString(QStringLiteral("yyyyMMdd'T'HHmmss'Z'"))
                                 .toStdString() +
                             ".db";
    RotatedBackup done{(files::path(folder) / name).string(), {}};
    if (!store.backup(session, done.path, progress)) return std::nullopt;
    // The new one counts as the newest, whatever the clock says: names of a later time were given by another
    // clock, and go first.
    std::vector<std::string> older = names_in(folder, start).backups;
    older.erase(std::remove(older.begin(), older.end(), name), older.end());
    std::stable_partition(older.begin(), older.end(), [&](const std::string& one) { return one > name; });
    const std::size_t kept = static_cast<std::size_t>(keep) - 1;
    for (std::size_t i = 0; i + kept < older.size(); ++i) {
        const std::string path = (files::path(folder) / older[i]).string();
        if (::unlink(path.c_str()) != 0 && errno != ENOENT) fail_file(path, errno);
        done.removed.push_back(path);
    }
    if (!done.removed.empty()) lock.sync();
    return done;
}

}  // namespace fulcrum::database
