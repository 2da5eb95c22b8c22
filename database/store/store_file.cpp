// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/store_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#include "database/rows/crypto.h"
#include "database/schema/migration.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

namespace files = std::filesystem;

constexpr const char* making = ".making-";

// Folders that are missing are made for this user alone; folders that exist are left as they are.
void make_folders(const files::path& folder) {
    if (folder.empty() || files::exists(folder)) return;
    make_folders(folder.parent_path());
    if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) fail_file(folder.string(), errno);
}

void remove_store(const std::string& path) {
    for (const char* suffix : {"-wal", "-shm", "-journal", ""}) ::unlink((path + suffix).c_str());
}

void remove_abandoned(const std::string& path) {
    const std::string start = files::path(path).filename().string() + making;
    const files::path folder = files::path(path).parent_path();
    std::vector<std::string> found;
    std::error_code ignored;
    for (files::directory_iterator entry(folder.empty() ? files::path(".") : folder, ignored), end;
         !ignored && entry != end; entry.increment(ignored)) {
        if (entry->path().filename().string().compare(0, start.size(), start) == 0)
            found.push_back(entry->path().string());
    }
    for (const std::string& file : found) ::unlink(file.c_str());
}

std::int64_t number(Connection& connection, const char* sql) {
    Query row(connection, sql);
    return row.next() ? row.integer(0) : 0;
}

bool has_table(Connection& connection, const char* name) {
    Query row(connection, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?");
    row.bind(name);
    return row.next();
}

bool is_unfinished(Connection& connection) {
    const std::int64_t id = number(connection, "PRAGMA application_id");
    if (id == 0) return number(connection, "SELECT COUNT(*) FROM sqlite_master") == 0;
    if (id != application_id) return false;
    // The station is the last thing that is written, and everything else refers to it.
    if (!has_table(connection, "setting"))
        return number(connection, "SELECT COUNT(*) FROM sqlite_master") == 0;
    return number(connection, "SELECT COUNT(*) FROM setting") == 0 &&
           number(connection, "SELECT COUNT(*) FROM station") == 0 &&
           number(connection, "SELECT COUNT(*) FROM person") == 0;
}

}  // namespace

void fail_file(const std::string& path, int error) {
    if (error == EEXIST) {
        throw StoreError(StoreErrorKind::exists,
                         {QT_TRANSLATE_NOOP("errors", "%1: a file is already there"), path},
                         QT_TRANSLATE_NOOP("errors", "choose another name, or open that file"));
    }
    if (error == ENOSPC || error == EDQUOT) {
        throw StoreError(StoreErrorKind::disk_full,
                         {QT_TRANSLATE_NOOP("errors", "%1: no room left on the disk"), path},
                         QT_TRANSLATE_NOOP("errors", "free some space and try again"));
    }
    throw StoreError(StoreErrorKind::read_only,
                     {QT_TRANSLATE_NOOP("errors", "%1: cannot be created (%2)"), path, std::strerror(error)},
                     QT_TRANSLATE_NOOP("errors", "choose a folder that this user can write"));
}

void fail_as_not_a_file(const std::string& address) {
    throw StoreError(
        StoreErrorKind::bad_value,
        {QT_TRANSLATE_NOOP("errors", "%1: this is a programme server, not a file"), address},
        QT_TRANSLATE_NOOP("errors",
                          "name the station's own store; `fulcrum server` has the commands for a server"));
}

void require_readable_file(const std::string& path, bool read_only) {
    if (ServerAddress::is_address(path)) fail_as_not_a_file(path);
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        throw StoreError(StoreErrorKind::missing,
                         {QT_TRANSLATE_NOOP("errors", "%1: there is no store"), path},
                         QT_TRANSLATE_NOOP(
                             "errors", "create one with `fulcrum db create`, or name another one with --db"));
    }
    if (!S_ISREG(status.st_mode)) {
        throw StoreError(StoreErrorKind::not_a_store,
                         {QT_TRANSLATE_NOOP("errors", "%1: not a Fulcrum store"), path},
                         QT_TRANSLATE_NOOP("errors", "name the right file with --db"));
    }
    if (::access(path.c_str(), R_OK) != 0) {
        throw StoreError(
            StoreErrorKind::read_only, {QT_TRANSLATE_NOOP("errors", "%1: you may not read this file"), path},
            QT_TRANSLATE_NOOP("errors",
                              "log in to the computer as the file's owner, or ask them for read permission"));
    }
    // The mode is looked at, not only access(): a file that somebody made read-only must stay unchanged, even
    // for root.
    if (!read_only && ((status.st_mode & S_IWUSR) == 0 || ::access(path.c_str(), W_OK) != 0)) {
        throw StoreError(
            StoreErrorKind::read_only, {QT_TRANSLATE_NOOP("errors", "%1: the store cannot be written"), path},
            QT_TRANSLATE_NOOP("errors", "make the file writable (chmod u+w), or open it read-only"));
    }
}

void require_finished(Connection& connection) {
    if (!is_unfinished(connection)) return;
    throw StoreError(
        StoreErrorKind::missing,
        {QT_TRANSLATE_NOOP("errors", "%1: an unfinished store, nothing was entered in it yet"),
         connection.path()},
        QT_TRANSLATE_NOOP(
            "errors",
            "create it again with `fulcrum db create`, or start the window and create a programme"));
}

bool is_unfinished(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
    if (status.st_size == 0) return true;
    constexpr int patience_ms = 5000;
    try {
        // For writing where that is possible: SQLite then finishes or undoes what was interrupted.
        const bool read_only = (status.st_mode & S_IWUSR) == 0 || ::access(path.c_str(), W_OK) != 0;
        Connection connection(path, read_only, false, patience_ms);
        return is_unfinished(connection);
    } catch (const StoreError&) {
        return false;  // open() says what is wrong with it
    }
}

NewStoreFile::NewStoreFile(const std::string& path) : path_(path) {
    const files::path parent = files::path(path).parent_path();
    make_folders(parent);
    const std::string folder = parent.empty() ? "." : parent.string();
    folder_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder_ < 0) fail_file(path, errno);
    int refused = 0;
    do {
        refused = ::flock(folder_, LOCK_EX);
    } while (refused != 0 && errno == EINTR);
    std::error_code ignored;
    if (files::exists(files::symlink_status(path, ignored)) && !is_unfinished(path)) {
        ::close(folder_);
        fail_file(path, EEXIST);
    }
    remove_store(path);  // unfinished, or a log without its store
    // Where the file system has no such lock, temporary files may be in use.
    if (refused == 0) remove_abandoned(path);
    temporary_ = path + making + random_uuid().substr(0, 8);
    // SQLite would give the file the usual mode. No other process knows this file yet.
    const int descriptor = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
    if (descriptor < 0) {
        const int error = errno;
        ::close(folder_);
        fail_file(path, error);
    }
    ::close(descriptor);
}

NewStoreFile::~NewStoreFile() {
    if (!done_) remove_store(temporary_);
    ::close(folder_);
}

void NewStoreFile::commit() {
    if (files::exists(temporary_ + "-wal")) {
        throw StoreError(StoreErrorKind::failed,
                         {QT_TRANSLATE_NOOP("errors", "%1: the new store could not be completed"), path_},
                         QT_TRANSLATE_NOOP("errors", "check the disk's space and health and try again"));
    }
    bool named = false;
    try {
        named = rename_without_replacing(temporary_, path_);
    } catch (const std::system_error& error) {
        fail_file(path_, error.code().value());
    }
    if (!named) fail_file(path_, EEXIST);
    done_ = true;
}

}  // namespace fulcrum::database
