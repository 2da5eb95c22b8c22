// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "database/store/store_file.h"
#include "database/store/store_state.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

constexpr int pages_a_step = 1024, patience = 200, pause_ms = 25;

/// SQLite's result; SQLITE_INTERRUPT if `progress` asked to stop.
int copy_pages(sqlite3_backup* copy, const StoreProgress& progress) {
    int code = SQLITE_OK;
    const auto report = [&] {
        const int all = sqlite3_backup_pagecount(copy), left = sqlite3_backup_remaining(copy);
        const double done = all > 0 ? static_cast<double>(all - left) / all : 0;
        return !progress ||
               progress(code == SQLITE_DONE ? 1 : done, QT_TRANSLATE_NOOP("errors", "copying the store"));
    };
    for (int waited = 0; waited < patience;) {
        if (!report()) return SQLITE_INTERRUPT;
        code = sqlite3_backup_step(copy, pages_a_step);
        if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
            ++waited;
            sqlite3_sleep(pause_ms);
        } else if (code != SQLITE_OK) {
            break;
        }
    }
    if (code != SQLITE_DONE) return code;
    report();  // complete: too late to stop it
    return SQLITE_OK;
}

int copy_into(const std::string& path, sqlite3* source, const StoreProgress& progress) {
    sqlite3* target = nullptr;
    int code = sqlite3_open_v2(path.c_str(), &target, SQLITE_OPEN_READWRITE, nullptr);
    if (code == SQLITE_OK) sqlite3_extended_result_codes(target, 1);
    // The file has no name of its own yet and is written through as a whole before it gets one.
    if (code == SQLITE_OK)
        code = sqlite3_exec(target, "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF", nullptr, nullptr,
                            nullptr);
    if (code == SQLITE_OK) {
        sqlite3_backup* copy = sqlite3_backup_init(target, "main", source, "main");
        code = copy == nullptr ? sqlite3_errcode(target) : copy_pages(copy, progress);
        if (copy != nullptr) sqlite3_backup_finish(copy);
    }
    sqlite3_close(target);
    return code;
}

/// The state at the beginning: without a view of its own SQLite would begin again after each write of another
/// program, and never end while somebody performs.
int copy_one_view(const std::string& path, Connection& connection, const StoreProgress& progress) {
    const OneView view(connection);
    Query(connection, "PRAGMA user_version").next();  // begins it, also where the tables are damaged
    return copy_into(path, connection.handle(), progress);
}

/// The error of the file system if it was the new file that could not be written; else 0.
int error_of_target(int code) {
    switch (code) {
        case SQLITE_FULL:
            return ENOSPC;
        case SQLITE_READONLY:
            return EROFS;
        case SQLITE_IOERR_WRITE:
        case SQLITE_IOERR_FSYNC:
        case SQLITE_IOERR_TRUNCATE:
            return EIO;
        default:
            return 0;
    }
}

/// Two bytes of SQLite's header say that a file has a log next to it (2) or none (1). By SQLite itself it
/// would need a log to say so. The error of the system, 0: none.
int mark_as_without_log(const std::string& path) {
    constexpr off_t write_version = 18;
    constexpr char without_log[] = {1, 1};
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) return errno;
    const bool written = ::pwrite(file, without_log, sizeof without_log, write_version) ==
                         static_cast<ssize_t>(sizeof without_log);
    const int error = written ? 0 : errno != 0 ? errno : EIO;
    ::close(file);
    return error;
}

}  // namespace

const CheckItem* first_finding(const CheckReport& report) {
    for (const CheckItem& item : report.items)
        if (!item.ok && item.id != CheckId::permissions) return &item;
    return nullptr;
}

bool copy_database(Connection& connection, const std::string& to_path, const StoreProgress& progress,
                   const CopyCheck& check) {
    try {
        OutputFile file(to_path, OutputFile::Existing::keep, OutputFile::Access::owner_only);
        const int code = copy_one_view(file.temporary_path(), connection, progress);
        if (code == SQLITE_INTERRUPT) return false;
        if (const int error = error_of_target(code)) fail_file(to_path, error);
        if (code != SQLITE_OK) connection.fail(QString::fromUtf8(sqlite3_errstr(code)), code);
        if (const int error = mark_as_without_log(file.temporary_path())) fail_file(to_path, error);
        if (check && !check(file.temporary_path())) return false;
        file.commit();
    } catch (const std::system_error& error) {
        fail_file(to_path, error.code().value());
    }
    return true;
}

}  // namespace fulcrum::database
