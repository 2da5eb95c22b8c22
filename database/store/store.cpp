// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/store.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDateTime>
#include <QStandardPaths>
#include <QSysInfo>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "database/access/session_maker.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/schema/migration.h"
#include "database/store/audit.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

namespace files = std::filesystem;

[[noreturn]] void fail_file(const std::string& path, int error) {
    if (error == EEXIST) {
        throw StoreError(StoreErrorKind::exists, path + ": a file is already there",
                         "name another, or open that one");
    }
    if (error == ENOSPC || error == EDQUOT) {
        throw StoreError(StoreErrorKind::disk_full, path + ": no room left on the disk",
                         "free some space and try again");
    }
    throw StoreError(StoreErrorKind::read_only, path + ": cannot be made (" + std::strerror(error) + ")",
                     "choose a folder that this user can write");
}

// Folders that are missing are made for this user alone; folders that exist are left as they are.
void make_folders(const files::path& folder) {
    if (folder.empty() || files::exists(folder)) return;
    make_folders(folder.parent_path());
    if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) fail_file(folder.string(), errno);
}

void make_private_file(const std::string& path) {
    make_folders(files::path(path).parent_path());
    const int descriptor = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
    if (descriptor < 0) fail_file(path, errno);
    ::fchmod(descriptor, 0600);
    ::close(descriptor);
}

void look_at_file(const std::string& path, bool read_only) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        throw StoreError(StoreErrorKind::missing, path + ": no store there",
                         "make one with `fulcrum db create` or name another with --db");
    }
    char header[16] = {};
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw StoreError(StoreErrorKind::read_only, path + ": this user may not read it",
                         "sign in as the file's owner");
    }
    file.read(header, sizeof header);
    if (file.gcount() != sizeof header || std::memcmp(header, "SQLite format 3", sizeof header) != 0) {
        throw StoreError(StoreErrorKind::not_a_store, path + ": not a Fulcrum store",
                         "name the right file with --db");
    }
    // The mode is looked at, not only access(): a file that someone made read-only is meant so, even for
    // root.
    if (!read_only && ((status.st_mode & S_IWUSR) == 0 || ::access(path.c_str(), W_OK) != 0)) {
        throw StoreError(StoreErrorKind::read_only, path + ": the store cannot be written",
                         "make the file writable (chmod u+w), or open it read-only");
    }
}

UtcMilliseconds system_clock_now() {
    return QDateTime::currentMSecsSinceEpoch();
}

}  // namespace

std::string iso_utc(UtcMilliseconds time) {
    return QDateTime::fromMSecsSinceEpoch(time, Qt::UTC).toString("yyyy-MM-dd'T'HH:mm:ss'Z'").toStdString();
}

std::string read_setting(Connection& connection, const std::string& key) {
    Query row(connection, "SELECT value FROM setting WHERE key = ?");
    row.bind(key);
    return row.next() ? row.text(0) : std::string();
}

void write_setting(Connection& connection, const std::string& key, const std::string& value) {
    Query(connection,
          "INSERT INTO setting (key, value) VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = "
          "excluded.value")
        .bind(key)
        .bind(value)
        .run();
}

std::string Store::default_path(bool demo) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return folder.toStdString() + "/fulcrum/" + (demo ? "demo.db" : "fulcrum.db");
}

int Store::schema_version() {
    return latest_schema_version();
}

bool Store::exists(const std::string& path) {
    std::error_code error;
    return files::exists(path, error);
}

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Store Store::create(const std::string& path, bool demo, StoreOptions options) {
    make_private_file(path);
    auto state = std::make_unique<State>();
    state->path = path;
    state->options = std::move(options);
    if (!state->options.clock) state->options.clock = system_clock_now;
    state->demo = demo;
    state->station_id = random_uuid();
    try {
        state->connection = std::make_unique<Connection>(path, false, true, state->options.busy_timeout_ms);
        Connection& connection = *state->connection;
        connection.execute("PRAGMA journal_mode = WAL");
        connection.execute("PRAGMA application_id = " + QString::number(application_id));
        migrate(connection, latest_schema_version());
        Store store(std::move(state));
        Transaction transaction(connection);
        Query(connection, "INSERT INTO station (id, name, created) VALUES (?, ?, ?)")
            .bind(store.station_id())
            .bind(QSysInfo::machineHostName().toStdString())
            .bind(store.now())
            .run();
        write_setting(connection, "this_station", store.station_id());
        write_setting(connection, "demo", demo ? "1" : "0");
        write_setting(connection, "sign_in_picker", "1");
        Audit(store).append(store.station_session(), store.station_id(), "store.create",
                            json_object({{"demo", demo ? "yes" : "no"}}));
        transaction.commit();
        return store;
    } catch (...) {
        // A half-made store must not stand in the way of the next try.
        state.reset();
        for (const char* suffix : {"", "-wal", "-shm", "-journal"}) ::unlink((path + suffix).c_str());
        throw;
    }
}

Store Store::open(const std::string& path, StoreOptions options) {
    look_at_file(path, options.read_only);
    auto state = std::make_unique<State>();
    state->path = path;
    state->options = std::move(options);
    if (!state->options.clock) state->options.clock = system_clock_now;
    state->connection =
        std::make_unique<Connection>(path, state->options.read_only, false, state->options.busy_timeout_ms);
    Connection& connection = *state->connection;
    const int found = read_schema_version(connection), known = latest_schema_version();
    if (found > known) {
        throw StoreError(StoreErrorKind::newer_schema,
                         path + ": written by a newer program (schema " + std::to_string(found) +
                             ", this one knows " + std::to_string(known) + ")",
                         "update Fulcrum; nothing was changed");
    }
    if (found < known) {
        if (state->options.read_only) {
            throw StoreError(StoreErrorKind::older_schema,
                             path + ": schema " + std::to_string(found) + " is older than this program's " +
                                 std::to_string(known),
                             "open it once for writing (`fulcrum db migrate`)");
        }
        const std::string copy = path + ".before-v" + std::to_string(known);
        if (!files::exists(copy)) copy_database(connection, copy);
        migrate(connection, known);
    }
    state->station_id = read_setting(connection, "this_station");
    state->demo = read_setting(connection, "demo") == "1";
    if (state->station_id.empty()) {
        throw StoreError(StoreErrorKind::corrupt, path + ": the making of this store was interrupted",
                         "nothing is in it: delete it and make it again, or restore a backup");
    }
    Store store(std::move(state));
    if (!store.is_read_only() && store.state_->options.close_interrupted)
        store.state_->interrupted = close_interrupted_attempts(store);
    return store;
}

const std::string& Store::path() const noexcept {
    return state_->path;
}
bool Store::is_read_only() const noexcept {
    return state_->options.read_only;
}
bool Store::is_demo() const {
    return state_->demo;
}
const std::string& Store::station_id() const noexcept {
    return state_->station_id;
}
UtcMilliseconds Store::now() const {
    return state_->options.clock();
}
Connection& Store::connection() const noexcept {
    return *state_->connection;
}
Session Store::station_session() const {
    return SessionMaker::station(state_->station_id);
}
const std::vector<InterruptedAttempt>& Store::interrupted_at_open() const noexcept {
    return state_->interrupted;
}

bool Store::has_administrator() const {
    Query row(connection(), "SELECT 1 FROM person_role WHERE role = 'administrator' LIMIT 1");
    return row.next();
}

std::string Store::programme_name() const {
    Query row(connection(), "SELECT name FROM programme LIMIT 1");
    return row.next() ? row.text(0) : std::string();
}

CheckReport Store::check(const Session& session, const StoreProgress& progress) const {
    require(session, Operation::check_store);
    return check_store(*this, progress);
}

bool Store::backup(const Session& session, const std::string& to_path, const StoreProgress& progress) const {
    require(session, Operation::backup);
    if (!copy_database(connection(), to_path, progress)) return false;
    if (!is_read_only()) {
        Audit(*this).append(session, station_id(), "store.backup",
                            json_object({{"to", files::path(to_path).filename().string()}}));
    }
    return true;
}

void Store::seal_demo(const Session& station) {
    if (!is_demo() || !station.is_station())
        throw AccessDenied("seal_demo", role_name(station.role()), "demo stores only");
    Transaction transaction(connection());
    write_setting(connection(), "demo_sealed", "1");
    Audit(*this).append(station, station_id(), "demo.seal", "{}");
    transaction.commit();
}

bool copy_database(Connection& connection, const std::string& to_path, const StoreProgress& progress) {
    make_private_file(to_path);
    const std::string part = to_path + ".part";
    const auto leave_nothing = [&] {
        ::unlink(part.c_str());
        ::unlink(to_path.c_str());
    };
    try {
        make_private_file(part);
        sqlite3* target = nullptr;
        bool stopped = false;
        int code = sqlite3_open_v2(part.c_str(), &target, SQLITE_OPEN_READWRITE, nullptr);
        if (code == SQLITE_OK) {
            sqlite3_backup* copy = sqlite3_backup_init(target, "main", connection.handle(), "main");
            code = copy == nullptr ? sqlite3_errcode(target) : SQLITE_OK;
            if (copy != nullptr) {
                constexpr int pages = 1024, patience = 200, pause_ms = 25;
                const auto go_on = [&] {
                    const int all = sqlite3_backup_pagecount(copy), left = sqlite3_backup_remaining(copy);
                    const double done = all > 0 ? static_cast<double>(all - left) / all : 0;
                    return !progress || progress(code == SQLITE_DONE ? 1 : done, "copying the store");
                };
                for (int waited = 0; waited < patience;) {
                    stopped = !go_on();
                    if (stopped) break;
                    code = sqlite3_backup_step(copy, pages);
                    if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
                        ++waited;
                        sqlite3_sleep(pause_ms);
                    } else if (code != SQLITE_OK) {
                        break;
                    }
                }
                if (code == SQLITE_DONE) go_on();  // whole: too late to stop it
                sqlite3_backup_finish(copy);
                if (code == SQLITE_DONE) code = SQLITE_OK;
            }
        }
        sqlite3_close(target);
        if (stopped) {
            leave_nothing();
            return false;
        }
        if (code != SQLITE_OK) connection.fail(QString::fromUtf8(sqlite3_errstr(code)), code);
        if (::rename(part.c_str(), to_path.c_str()) != 0) fail_file(to_path, errno);
    } catch (...) {
        leave_nothing();
        throw;
    }
    return true;
}

}  // namespace fulcrum::database
