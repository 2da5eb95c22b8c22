// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/damaged_copy.h"

#include <fcntl.h>
#include <unistd.h>

#include <QDateTime>
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "database/rows/json.h"
#include "database/schema/migration.h"
#include "database/store/audit.h"
#include "database/store/backup_list.h"
#include "database/store/store_file.h"
#include "database/store/store_state.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

namespace files = std::filesystem;

std::string unverified_name(const std::string& to) {
    std::error_code ignored;
    if (files::is_directory(to, ignored)) {
        const QString time = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd'T'HHmmss'Z'"));
        return (files::path(to) / ("fulcrum-" + time.toStdString() + unverified_ending)).string();
    }
    const std::string ending = unverified_ending;
    if (to.size() > ending.size() && to.compare(to.size() - ending.size(), ending.size(), ending) == 0)
        return to;
    files::path name(to);
    if (name.extension() == ".db") name.replace_extension();
    return name.string() + ending;
}

/// SQLite cannot open it, or cannot get at its first page.
bool is_damage(const StoreError& error) {
    return error.kind() == StoreErrorKind::corrupt || error.kind() == StoreErrorKind::not_a_store ||
           error.kind() == StoreErrorKind::missing || error.kind() == StoreErrorKind::failed ||
           error.kind() == StoreErrorKind::newer_schema;
}

/// The session, where the store is whole enough for somebody to sign in; signed in and out before the copy is
/// made, which holds no lock then.
void sign_in_if_possible(const std::string& path, const std::string& copy, const SignInToCopy& sign_in) {
    try {
        {
            Connection connection(path, true, false, StoreOptions().busy_timeout_ms);
            // Opening an older store for writing would bring it up to date, which damage must not go through.
            if (read_schema_version(connection) != latest_schema_version()) return;
        }
        StoreOptions options;
        options.close_interrupted = false;
        const Store store = Store::open(path, options);
        const Session session = sign_in(store);
        store.require(session, Operation::backup);
        Transaction transaction(store.connection());
        Audit(store).append(session, store.station_id(), "store.copy_damaged",
                            json_object({{"to", files::path(copy).filename().string()}}));
        transaction.commit();
    } catch (const StoreError& error) {
        if (!is_damage(error)) throw;
    }
}

/// Bytes that the disk does not give are zeros in the copy, and counted. False: stopped.
bool copy_bytes(const std::string& from, const std::string& to, std::int64_t& unreadable,
                const StoreProgress& progress) {
    constexpr std::size_t block = 4096;
    const int source = ::open(from.c_str(), O_RDONLY | O_CLOEXEC);
    if (source < 0) fail_file(from, errno);
    const off_t size = ::lseek(source, 0, SEEK_END);
    bool complete = true;
    try {
        OutputFile file(to, OutputFile::Existing::keep, OutputFile::Access::owner_only);
        std::vector<char> bytes(block);
        for (off_t at = 0; at < size && complete; at += static_cast<off_t>(block)) {
            const auto wanted = static_cast<std::size_t>(std::min<off_t>(size - at, block));
            const ssize_t got = ::pread(source, bytes.data(), wanted, at);
            if (got < 0 && errno != EIO) fail_file(from, errno);
            const std::size_t read = got < 0 ? 0 : static_cast<std::size_t>(got);
            std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(read), bytes.end(), '\0');
            unreadable += static_cast<std::int64_t>(wanted - read);
            file.write({bytes.data(), wanted});
            complete = !progress || progress(static_cast<double>(at) / static_cast<double>(size),
                                             QT_TRANSLATE_NOOP("errors", "copying the store"));
        }
        if (complete) file.commit();
    } catch (const std::system_error& error) {
        ::close(source);
        fail_file(to, error.code().value());
    } catch (...) {
        ::close(source);
        throw;
    }
    ::close(source);
    return complete;
}

}  // namespace

DamagedCopy copy_damaged(const std::string& path, const std::string& to, const SignInToCopy& sign_in,
                         const StoreProgress& progress) {
    require_readable_file(path, true);
    DamagedCopy copy;
    copy.path = unverified_name(to);
    std::error_code ignored;
    if (files::exists(files::symlink_status(copy.path, ignored))) fail_file(copy.path, EEXIST);
    sign_in_if_possible(path, copy.path, sign_in);
    try {
        Connection connection(path, true, false, StoreOptions().busy_timeout_ms);
        copy.stopped = !copy_database(connection, copy.path, progress);
        return copy;
    } catch (const StoreError& error) {
        if (!is_damage(error)) throw;
    }
    // No connection is open any more: closing this descriptor takes away no lock of ours.
    copy.by_database = false;
    // The log first: a copy without it that has the final name would pass for a whole one.
    for (const char* suffix : {"-wal", "-journal", ""}) {
        if (!files::exists(path + suffix, ignored)) continue;
        copy.stopped = !copy_bytes(path + suffix, copy.path + suffix, copy.unreadable_bytes, progress);
        if (copy.stopped) {
            for (const char* log : {"-wal", "-journal"}) ::unlink((copy.path + log).c_str());
            break;
        }
    }
    return copy;
}

}  // namespace fulcrum::database
