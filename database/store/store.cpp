// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/store.h"

#include <QDateTime>
#include <QStandardPaths>
#include <QSysInfo>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>

#include "database/access/session_maker.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/schema/migration.h"
#include "database/schema/server_version.h"
#include "database/store/audit.h"
#include "database/store/backup_list.h"
#include "database/store/store_file.h"
#include "database/store/store_owner.h"
#include "database/store/store_state.h"
#include "sim_core/numerics/boot_clock.h"

namespace fulcrum::database {
namespace {

constexpr const char* baseline_wanted = "baseline_wanted";

UtcMilliseconds system_clock_now() {
    return QDateTime::currentMSecsSinceEpoch();
}

BootTime system_boot_time() {
    static const std::string boot = [] {
        std::ifstream file("/proc/sys/kernel/random/boot_id");
        std::string id;
        std::getline(file, id);
        return id;
    }();
    return {boot, boot_ns() / 1'000'000};
}

/// What to add to the system clock so that a demonstration resumes when its record ends: its trainees would
/// all have stopped, and every check would be overdue, on whatever later day somebody looks at it. Settled
/// when this program first opens that store, so that all its connections agree.
UtcMilliseconds demo_clock_ahead(Connection& connection, const std::string& station_id) {
    static std::mutex mutex;
    static std::map<std::string, UtcMilliseconds> known;
    const std::lock_guard<std::mutex> lock(mutex);
    const auto found = known.find(station_id);
    if (found != known.end()) return found->second;
    Query last(connection, "SELECT MAX(time) FROM audit_entry WHERE station_id = ?");
    last.bind(station_id);
    const UtcMilliseconds ahead = last.next() && !last.is_null(0) ? last.integer(0) - system_clock_now() : 0;
    known.emplace(station_id, ahead);
    return ahead;
}

StoreOptions with_clocks(StoreOptions options) {
    if (!options.clock) options.clock = system_clock_now;
    if (!options.boot_time) options.boot_time = system_boot_time;
    return options;
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
    if (ServerAddress::is_address(path)) return true;
    std::error_code error;
    return std::filesystem::exists(path, error) && !is_unfinished(path);
}

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Store Store::open_or_create(const std::string& path, bool demo, StoreOptions options) {
    if (exists(path)) return open(path, std::move(options));
    try {
        return create(path, demo, options);
    } catch (const StoreError& error) {
        // Another program made it since we looked.
        if (error.kind() != StoreErrorKind::exists) throw;
        return open(path, std::move(options));
    }
}

Store Store::create(const std::string& path, bool demo, StoreOptions options) {
    if (ServerAddress::is_address(path)) fail_as_not_a_file(path);
    NewStoreFile file(path);
    {
        auto state = std::make_unique<State>();
        state->path = file.temporary_path();
        state->options = with_clocks(options);
        state->demo = demo;
        state->station_id = random_uuid();
        state->schema = latest_schema_version();
        state->connection =
            std::make_unique<Connection>(state->path, false, true, state->options.busy_timeout_ms);
        Connection& connection = *state->connection;
        connection.execute("PRAGMA journal_mode = WAL");
        connection.execute("PRAGMA application_id = " + QString::number(application_id));
        migrate(connection, latest_schema_version());
        const Store store(std::move(state));
        Transaction transaction(connection);
        Query(connection, "INSERT INTO station (id, name, created) VALUES (?, ?, ?)")
            .bind(store.station_id())
            .bind(demo ? std::string("Demonstration") : QSysInfo::machineHostName().toStdString())
            .bind(store.now())
            .run();
        write_setting(connection, "this_station", store.station_id());
        write_setting(connection, "demo", demo ? "1" : "0");
        write_setting(connection, "sign_in_picker", "1");
        Audit(store).append(store.station_session(), store.station_id(), "store.create",
                            json_object({{"demo", demo ? "yes" : "no"}}), all_records(connection));
        transaction.commit();
        // One file without a log: only then may it be renamed.
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)");
    }
    file.commit();
    return open(path, std::move(options));
}

namespace {

/// Keeps a copy of the store as it is, then brings it up to `known`.
void migrate_with_copy(Connection& connection, const std::string& path, int known) {
    const std::string copy = path + ".before-v" + std::to_string(known);
    std::error_code ignored;
    // Older programs left an empty file when they were killed while they copied.
    if (std::filesystem::file_size(copy, ignored) == 0) std::filesystem::remove(copy, ignored);
    if (!std::filesystem::exists(copy)) {
        try {
            copy_database(connection, copy);
        } catch (const StoreError& error) {
            // Another program opened the store at the same moment and has made the copy.
            if (error.kind() != StoreErrorKind::exists) throw;
        }
    }
    migrate(connection, known);
}

/// A restore or migration that was killed leaves the store without its write-ahead log.
void keep_log(Connection& connection) {
    {
        Query mode(connection, "PRAGMA journal_mode");
        if (mode.next() && mode.text(0) == "wal") return;
    }
    connection.execute("PRAGMA journal_mode = WAL");
}

/// Enters the records of a store from before the audit log had digests of them: what they are now is what
/// later checks compare with. Schema step 8 asks for it.
void enter_records(const Store& store) {
    Connection& connection = store.connection();
    if (read_setting(connection, baseline_wanted).empty()) return;
    Transaction transaction(connection);
    Query done(connection, "DELETE FROM setting WHERE key = ?");
    done.bind(baseline_wanted).run();
    if (done.rows_changed() == 0) return;  // another program has done it since
    Audit(store).append(store.station_session(), store.station_id(), baseline_operation, "{}",
                        all_records(connection));
    transaction.commit();
}

/// In the store of another account only the key that its log asks for may sign. A key of this account would
/// be a finding of every later check, and stop backups.
void require_key_of_owner(const std::string& path, const std::string& station, const Bytes& expected) {
    if (expected.empty() || !belongs_to_another_account(path)) return;
    // The prepared one first: between the two readings another program may put it in its place.
    for (const auto& key : {StationKey::prepared(station), StationKey::existing(station)})
        if (key && key->public_half() == expected) return;
    fail_as_of_another_account(path);
}

}  // namespace

Store Store::open_server(const std::string& address, StoreOptions options) {
    auto state = std::make_unique<State>();
    options.read_only = true;
    state->options = with_clocks(std::move(options));
    state->connection = std::make_unique<Connection>(ServerAddress::parse(address), true);
    state->path = state->connection->path();
    state->station_id = require_server(*state->connection);
    state->schema = latest_schema_version();
    return Store(std::move(state));
}

Store Store::open(const std::string& path, StoreOptions options) {
    if (ServerAddress::is_address(path)) return open_server(path, std::move(options));
    require_readable_file(path, options.read_only);
    auto state = std::make_unique<State>();
    state->path = path;
    const bool by_system_clock = !options.clock;
    state->options = with_clocks(std::move(options));
    state->connection =
        std::make_unique<Connection>(path, state->options.read_only, false, state->options.busy_timeout_ms);
    Connection& connection = *state->connection;
    require_finished(connection);
    const int found = read_schema_version(connection), known = latest_schema_version();
    if (found > known) {
        throw StoreError(
            StoreErrorKind::newer_schema,
            {QT_TRANSLATE_NOOP("errors", "%1: written by a newer program (schema %2, this program knows %3)"),
             path, found, known},
            QT_TRANSLATE_NOOP("errors", "update Fulcrum; nothing was changed"));
    }
    state->schema = state->options.read_only ? found : known;
    if (found < known && !(state->options.read_only && state->options.older_schema)) {
        if (state->options.read_only) {
            throw StoreError(
                StoreErrorKind::older_schema,
                {QT_TRANSLATE_NOOP(
                     "errors",
                     "%1: the store was written by an older program (schema %2, this program uses %3)"),
                 path, found, known},
                QT_TRANSLATE_NOOP("errors", "open it once for writing (`fulcrum db migrate`)"));
        }
        migrate_with_copy(connection, path, known);
    }
    if (!state->options.read_only) keep_log(connection);
    state->station_id = read_setting(connection, "this_station");
    state->demo = read_setting(connection, "demo") == "1";
    if (state->station_id.empty()) {
        throw StoreError(StoreErrorKind::corrupt,
                         {QT_TRANSLATE_NOOP("errors", "%1: the store does not name its station"), path},
                         QT_TRANSLATE_NOOP("errors", "run `fulcrum db check`, or restore the newest backup"));
    }
    if (by_system_clock && state->demo && read_setting(connection, "demo_sealed") == "1")
        state->ahead = demo_clock_ahead(connection, state->station_id);
    Store store(std::move(state));
    if (!store.is_read_only()) enter_records(store);
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
bool Store::is_server() const noexcept {
    return state_->connection->is_server();
}
const StationKey& Store::key(std::int64_t next_row, const Bytes& expected) const {
    if (!state_->key || (!expected.empty() && state_->key->public_half() != expected)) {
        require_key_of_owner(state_->path, state_->station_id, expected);
        state_->key = StationKey::of(state_->station_id, next_row, expected);
    }
    return *state_->key;
}
void Store::use_key(const StationKey& key) const {
    state_->key = key;
}

int Store::found_schema() const noexcept {
    return state_->schema;
}
bool Store::is_demo() const {
    return state_->demo;
}
const std::string& Store::station_id() const noexcept {
    return state_->station_id;
}
UtcMilliseconds Store::now() const {
    return state_->options.clock() + state_->ahead;
}
BootTime Store::boot_time() const {
    return state_->options.boot_time();
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
    StoreProgress copying, checking;
    if (progress) {
        copying = [&](double done, const std::string& line) { return progress(done * 0.5, line); };
        checking = [&](double done, const std::string& line) { return progress(0.5 + done * 0.5, line); };
    }
    StoreOptions reading = state_->options;
    reading.read_only = reading.older_schema = true;
    const auto check = [&](const std::string& path) {
        const Store copy = Store::open(path, reading);
        const CheckReport report = copy.check(copy.station_session(), checking);
        if (const CheckItem* item = first_finding(report))
            throw StoreError(StoreErrorKind::corrupt,
                             {QT_TRANSLATE_NOOP("errors", "%1: the copy does not pass the check (%2: %3)"),
                              to_path, item->name, item->problems.front()},
                             QT_TRANSLATE_NOOP(
                                 "errors",
                                 "no backup was written and older ones are unchanged; run `fulcrum db check` "
                                 "on the store, and back it up to another disk if it passes there"));
        return report.complete;
    };
    if (!copy_database(connection(), to_path, copying, check)) return false;
    note_backup_folder(path(), to_path);
    if (!is_read_only()) {
        Transaction transaction(connection());
        Audit(*this).append(session, station_id(), "store.backup",
                            json_object({{"to", std::filesystem::path(to_path).filename().string()}}));
        transaction.commit();
    }
    return true;
}

void Store::seal_demo(const Session& station) {
    if (!is_demo() || !station.is_station())
        throw AccessDenied("seal_demo", role_name(station.role()), DenialReason::demo_only);
    Transaction transaction(connection());
    write_setting(connection(), "demo_sealed", "1");
    // Times of a demonstration may be simulated; this one is the machine's.
    Audit(*this).append(station, station_id(), "demo.seal",
                        json_object({{"sealed", iso_utc(system_clock_now())}}),
                        {{RecordKind::setting, "demo_sealed"}});
    transaction.commit();
}

}  // namespace fulcrum::database
