// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/store_restore.h"

#include <sys/stat.h>
#include <unistd.h>

#include <QDateTime>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/schema/migration.h"
#include "database/store/audit.h"
#include "database/store/kept_frames.h"
#include "database/store/store_file.h"
#include "database/store/store_owner.h"
#include "database/store/store_state.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

namespace files = std::filesystem;

constexpr const char* restoring = ".restoring-";

/// A file next to the store under a name of its own, removed unless it became the store.
class CopyFile {
  public:
    explicit CopyFile(const std::string& store_path)
        : store_path_(store_path), path_(store_path + restoring + random_uuid().substr(0, 8)) {}
    ~CopyFile() {
        for (const char* suffix : {"-wal", "-shm", "-journal", ""}) ::unlink((path_ + suffix).c_str());
    }
    CopyFile(const CopyFile&) = delete;
    CopyFile& operator=(const CopyFile&) = delete;
    const std::string& path() const { return path_; }
    /// The copy belongs to whom the file belongs that it will replace: a service account could not open what
    /// the superuser has restored. Its group has no say in it (0600). Throws StoreError failed.
    void give_to_owner() const {
        struct stat store {
        }, copy{};
        if (::stat(store_path_.c_str(), &store) != 0 || ::stat(path_.c_str(), &copy) != 0) return;
        if (store.st_uid != copy.st_uid && ::chown(path_.c_str(), store.st_uid, store.st_gid) != 0)
            fail_as_of_another_account(store_path_);
    }

  private:
    std::string store_path_, path_;
};

/// Where the store is: the file that a link names. The link itself would be replaced, and the old store stay
/// in use under its own name.
std::string place_of(const std::string& path) {
    std::error_code unknown;
    if (!files::is_symlink(files::symlink_status(path, unknown))) return path;
    const files::path file = files::canonical(path, unknown);
    return unknown ? path : file.string();
}

/// Copies that a killed restore or migration left next to the store. Only for whoever is alone with it: the
/// copy of another one that still runs is not touched.
void remove_left_copies(const std::string& path) {
    const files::path file(path);
    const std::string start = file.filename().string() + restoring;
    std::vector<files::path> left;
    std::error_code ignored;
    for (files::directory_iterator
             entry(file.parent_path().empty() ? files::path(".") : file.parent_path(), ignored),
         end;
         !ignored && entry != end; entry.increment(ignored))
        if (entry->path().filename().string().compare(0, start.size(), start) == 0)
            left.push_back(entry->path());
    for (const files::path& copy : left) files::remove(copy, ignored);
}

/// Keeps every other program out of the store until it ends.
class Alone {
  public:
    Alone(const std::string& path, int patience_ms, ReplacedFile what = ReplacedFile::store) {
        try {
            connection_ = std::make_unique<Connection>(path, false, false, patience_ms);
            connection_->execute("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; COMMIT");
            // Without a log nothing of the old store is left next to the new one, and nothing deletes the new
            // one's log when this connection is closed.
            connection_->execute("PRAGMA journal_mode = DELETE");
            read_schema_version(*connection_);
            remove_left_copies(path);
        } catch (const StoreError& error) {
            if (error.kind() == StoreErrorKind::locked)
                throw StoreError(
                    StoreErrorKind::locked,
                    {QT_TRANSLATE_NOOP("errors", "%1: a program has the store open, or writes to it"), path},
                    QT_TRANSLATE_NOOP("errors",
                                      "close every Fulcrum program that uses this store, then try again; "
                                      "nothing was changed"));
            if (error.kind() == StoreErrorKind::not_a_store && what == ReplacedFile::store)
                throw StoreError(StoreErrorKind::not_a_store,
                                 {QT_TRANSLATE_NOOP("errors", "%1: not a Fulcrum store"), path},
                                 QT_TRANSLATE_NOOP(
                                     "errors", "name the right file with --db, or move this one away first"));
            // So damaged that it cannot be read: in nobody's use, and moved away.
            if (error.kind() != StoreErrorKind::corrupt && error.kind() != StoreErrorKind::not_a_store) throw;
            connection_.reset();
        }
    }
    ~Alone() {
        if (!connection_ || replaced_) return;
        try {
            connection_->execute("PRAGMA journal_mode = WAL");
        } catch (const StoreError&) {
            // Store::open() asks for it again.
        }
    }
    Alone(const Alone&) = delete;
    Alone& operator=(const Alone&) = delete;
    /// Null where the store cannot be read.
    Connection* connection() const { return connection_.get(); }
    void replaced() { replaced_ = true; }
    /// The audit head of the store; empty where it cannot be read.
    std::string head() const {
        if (!connection_) return {};
        try {
            Query last(
                *connection_,
                "SELECT hash FROM audit_entry WHERE station_id = (SELECT value FROM setting WHERE key = "
                "'this_station') ORDER BY sequence DESC LIMIT 1");
            return last.next() ? to_hex(last.bytes(0)) : std::string();
        } catch (const StoreError&) {
            return {};
        }
    }

  private:
    std::unique_ptr<Connection> connection_;
    bool replaced_ = false;
};

/// Throws StoreError newer_schema.
void require_known_schema(Connection& connection) {
    const int found = read_schema_version(connection), known = latest_schema_version();
    if (found > known)
        throw StoreError(
            StoreErrorKind::newer_schema,
            {QT_TRANSLATE_NOOP("errors", "%1: written by a newer program (schema %2, this program knows %3)"),
             connection.path(), found, known},
            QT_TRANSLATE_NOOP("errors", "update Fulcrum; nothing was changed"));
}

/// False: stopped. Throws StoreError corrupt with the first finding.
bool require_sound(const Store& store, const std::string& what, const StoreProgress& progress) {
    const CheckReport report = store.check(store.station_session(), progress);
    if (const CheckItem* item = first_finding(report))
        throw StoreError(
            StoreErrorKind::corrupt, {"%1: %2: %3", what, item->name, item->problems.front()},
            QT_TRANSLATE_NOOP(
                "errors",
                "use another backup; nothing was changed (`fulcrum db check --db FILE` lists all)"));
    return report.complete;
}

/// A part of the whole work.
StoreProgress share_of(const StoreProgress& progress, double from, double to) {
    if (!progress) return {};
    return [=](double done, const std::string& line) { return progress(from + done * (to - from), line); };
}

/// Copies `source` to a new file, checks it as it is, brings it up to this program's schema, and checks it
/// again. `finish` is called with the open copy. False: stopped.
bool make_copy(Connection& source, const CopyFile& copy, const StoreOptions& options,
               const std::function<void(const Store&)>& finish, const StoreProgress& progress = {}) {
    require_known_schema(source);
    constexpr double copied = 0.2, checked = 0.6;
    if (!copy_database(source, copy.path(), share_of(progress, 0, copied))) return false;
    copy.give_to_owner();
    {
        StoreOptions reading = options;
        reading.read_only = reading.older_schema = true;
        if (!require_sound(Store::open(copy.path(), reading), source.path(),
                           share_of(progress, copied, checked)))
            return false;
    }
    {
        Connection connection(copy.path(), false, false, options.busy_timeout_ms);
        connection.execute("PRAGMA journal_mode = WAL");
        migrate(connection, latest_schema_version());
    }
    StoreOptions writing = options;
    writing.read_only = false;
    const Store store = Store::open(copy.path(), writing);
    finish(store);
    if (!require_sound(store, source.path(), share_of(progress, checked, 1))) return false;
    // One file without a log: only then may it be renamed.
    store.connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
    return true;
}

/// A second name for the file, so that replacing it loses nothing.
std::string keep(const std::string& path, const std::string& suffix) {
    std::string kept = path + suffix;
    for (int number = 2; files::exists(kept); ++number) kept = path + suffix + "-" + std::to_string(number);
    if (::link(path.c_str(), kept.c_str()) != 0) {
        if (errno != EPERM && errno != EOPNOTSUPP && errno != ENOSYS) fail_file(kept, errno);
        std::error_code failed;  // a file system without second names
        files::copy_file(path, kept, failed);
        if (failed) fail_file(kept, failed.value());
    }
    return kept;
}

/// What is left of a damaged store's log goes with it.
void move_logs(const std::string& path, const std::string& kept) {
    for (const char* suffix : {"-wal", "-shm", "-journal"}) {
        if (::rename((path + suffix).c_str(), (kept + suffix).c_str()) != 0 && errno != ENOENT)
            fail_file(kept + suffix, errno);
    }
}

/// For names of files: "20261126T201500Z".
std::string compact_utc(const StoreOptions& options) {
    const UtcMilliseconds now = options.clock ? options.clock() : QDateTime::currentMSecsSinceEpoch();
    return QDateTime::fromMSecsSinceEpoch(now, Qt::UTC)
        .toString(QStringLiteral("yyyyMMdd'T'HHmmss'Z'"))
        .toStdString();
}

void take_place(const std::string& copy, const std::string& path) {
    if (files::exists(copy + "-wal"))
        throw StoreError(
            StoreErrorKind::failed,
            {QT_TRANSLATE_NOOP("errors", "%1: the copy could not be completed"), copy},
            QT_TRANSLATE_NOOP("errors",
                              "check the disk's space and health and try again; nothing was changed"));
    try {
        rename_replacing(copy, path);
    } catch (const std::system_error& error) {
        fail_file(path, error.code().value());
    }
}

}  // namespace

Replaced restore_store(const std::string& from, const std::string& named, const SignInToCopy& sign_in,
                       StoreOptions options, const StoreProgress& progress, ReplacedFile replaced) {
    if (ServerAddress::is_address(named)) fail_as_not_a_file(named);
    const std::string path = place_of(named);
    require_readable_file(from, true);
    std::error_code ignored;
    if (files::exists(path) && files::equivalent(from, path, ignored))
        throw StoreError(StoreErrorKind::bad_value,
                         {QT_TRANSLATE_NOOP("errors", "%1: this is the store itself"), from},
                         QT_TRANSLATE_NOOP("errors", "name the backup, and the store with --db"));
    Replaced done;
    std::unique_ptr<Alone> alone;
    if (files::exists(path)) {
        require_readable_file(path, false);
        alone = std::make_unique<Alone>(path, options.busy_timeout_ms, replaced);
        done.before = alone->head();
    } else if (files::exists(path + "-wal")) {
        throw StoreError(
            StoreErrorKind::locked,
            {QT_TRANSLATE_NOOP("errors", "%1-wal: this is the log of a store that is missing"), path},
            QT_TRANSLATE_NOOP("errors",
                              "put the store back next to it, or move the log away, then try again"));
    }
    const CopyFile copy(path);
    {
        Connection source(from, true, false, options.busy_timeout_ms);
        require_finished(source);
        done.from_schema = read_schema_version(source);
        const auto enter = [&](const Store& store) {
            done.head = Audit(store).head();
            const Session session = sign_in(store);
            store.require(session, Operation::backup);
            Transaction transaction(store.connection());
            Audit(store).append(session, store.station_id(), "store.restore",
                                json_object({{"from", files::path(from).filename().string()},
                                             {"head", done.head},
                                             {"replaced", done.before}}));
            transaction.commit();
        };
        done.stopped = !make_copy(source, copy, options, enter, progress);
        if (done.stopped) return done;
    }
    if (alone) {
        done.kept = keep(path, ".before-restore-" + compact_utc(options));
        move_logs(path, done.kept);
    }
    take_place(copy.path(), path);
    remove_all_kept_frames(path);  // of the store that was replaced
    if (alone) alone->replaced();
    return done;
}

Replaced migrate_store(const std::string& named, StoreOptions options) {
    require_readable_file(named, false);
    const std::string path = place_of(named);
    Replaced done;
    Alone alone(path, options.busy_timeout_ms);
    if (alone.connection() == nullptr)
        throw StoreError(StoreErrorKind::corrupt,
                         {QT_TRANSLATE_NOOP("errors", "%1: the store is damaged"), path},
                         QT_TRANSLATE_NOOP("errors", "restore the newest backup (`fulcrum db restore`)"));
    require_finished(*alone.connection());
    done.before = done.head = alone.head();
    done.from_schema = read_schema_version(*alone.connection());
    if (done.from_schema == latest_schema_version()) return done;
    const CopyFile copy(path);
    make_copy(*alone.connection(), copy, options, [](const Store&) {});
    done.kept = keep(path, ".before-v" + std::to_string(latest_schema_version()));
    take_place(copy.path(), path);
    alone.replaced();
    return done;
}

std::string put_aside(const std::string& path, StoreOptions options) {
    require_readable_file(path, false);
    Alone alone(path, options.busy_timeout_ms, ReplacedFile::any);
    const std::string kept = keep(path, ".damaged-" + compact_utc(options));
    move_logs(path, kept);
    // The second name holds the file: cut off before this, there are both.
    if (::unlink(path.c_str()) != 0) fail_file(path, errno);
    alone.replaced();
    return kept;
}

}  // namespace fulcrum::database
