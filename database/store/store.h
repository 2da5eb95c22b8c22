// SPDX-License-Identifier: GPL-3.0-or-later
// The station's store: one SQLite file (WAL, foreign keys, user_version migrations); or, to be read only, the
// programme server (PostgreSQL), named by its address in place of the file. Needs a QCoreApplication
// (Qt loads the driver as a plugin). One Store is one connection: use it on the thread that opened it; other
// threads open their own on the same path.
//
// Rooms built on it, each constructed from a Store: People (people.h), Attempts (attempts.h), Reviews
// (reviews.h), Reports (report_data.h), Audit (audit.h); Recorder (recorder.h) opens its own connection.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "database/access/access.h"
#include "database/rows/errors.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum::database {

class Connection;

/// Milliseconds since 1970-01-01 UTC.
using UtcMilliseconds = std::int64_t;
/// "2026-11-21T04:07:37Z" (whole seconds).
std::string iso_utc(UtcMilliseconds time);

/// Time since this machine was started, standby included; `boot` names the start. Nobody can set it.
struct BootTime {
    std::string boot;
    std::int64_t ms = 0;
};

struct StoreOptions {
    bool read_only = false;
    int busy_timeout_ms = 5000;                   ///< how long to wait for another connection's write
    std::function<UtcMilliseconds()> clock = {};  ///< default: the system clock
    std::function<BootTime()> boot_time = {};     ///< default: the system's
    bool older_schema = false;  ///< with read_only: open an older store too, as it is, to check it
    bool close_interrupted =
        true;  ///< false: leave attempts that lost their program for the next start to list
};

/// What is checked. The last three: by `db check`, which can simulate, and with `--against` and `--key`.
enum class CheckId : std::uint8_t {
    integrity,
    foreign_keys,
    audit_chain,
    signatures,
    trace_checksums,
    records,
    score_digests,
    scenes,
    decisions,
    permissions,  ///< of the file, not of what is in it
    simulation,   ///< a sample of the attempts, made again from their inputs
    known_head,
    known_key
};
struct CheckRow {
    CheckId kind;
    const char* name;  ///< in output; permanent
};
inline constexpr CheckRow store_checks[] = {
    {CheckId::integrity, QT_TRANSLATE_NOOP("errors", "integrity")},
    {CheckId::foreign_keys, QT_TRANSLATE_NOOP("errors", "foreign keys")},
    {CheckId::audit_chain, QT_TRANSLATE_NOOP("errors", "audit chain")},
    {CheckId::signatures, QT_TRANSLATE_NOOP("errors", "signatures")},
    {CheckId::trace_checksums, QT_TRANSLATE_NOOP("errors", "trace checksums")},
    {CheckId::records, QT_TRANSLATE_NOOP("errors", "records")},
    {CheckId::score_digests, QT_TRANSLATE_NOOP("errors", "score digests")},
    {CheckId::scenes, QT_TRANSLATE_NOOP("errors", "scenes")},
    {CheckId::decisions, QT_TRANSLATE_NOOP("errors", "decisions")},
    {CheckId::permissions, QT_TRANSLATE_NOOP("errors", "permissions")},
    {CheckId::simulation, QT_TRANSLATE_NOOP("errors", "simulation")},
    {CheckId::known_head, QT_TRANSLATE_NOOP("errors", "known head")},
    {CheckId::known_key, QT_TRANSLATE_NOOP("errors", "known key")}};
static_assert(in_order(store_checks));

/// A finding of check(): ok == false names what is wrong and what to do.
struct CheckItem {
    explicit CheckItem(CheckId check = CheckId::integrity)
        : id(check), name(row_of(store_checks, check).name) {}

    CheckId id;
    std::string name;  ///< for people; what decides is `id`
    bool ok = true;
    std::int64_t count = 0;          ///< things looked at
    std::vector<Sentence> problems;  ///< empty if ok; at most 20, then a line that says how many more
    std::vector<Sentence> notes;     ///< to be known, without being wrong
};
struct CheckReport {
    bool ok = true;
    bool complete = true;  ///< false: stopped before the end; the items hold what was looked at
    std::vector<CheckItem> items;
};

/// How far long work is, 0..1, and what it is at; false asks it to stop.
using StoreProgress = std::function<bool(double done, const std::string& line)>;

/// An attempt that was running when its program ended.
struct InterruptedAttempt {
    std::string attempt_id, person_id, task_id;
    UtcMilliseconds started = 0;
    double recorded_s = 0;  ///< how much of the trace is there
};

class StationKey;

class Store {
  public:
    /// Where the window keeps its store unless another file is named: XDG data folder /fulcrum/fulcrum.db
    /// (demo: demo.db).
    static std::string default_path(bool demo = false);
    /// Makes a new store (file 0600, missing folders 0700) with its station, no people. It has its name only
    /// when it is complete; an unfinished store of that name, left by a program that was killed, is replaced.
    /// Throws StoreError exists, read_only, disk_full.
    static Store create(const std::string& path, bool demo = false, StoreOptions options = {});
    /// Opens, migrates (one transaction a step; a copy FILE.before-vN is kept), and closes interrupted
    /// attempts, unless read_only. Throws StoreError missing, not_a_store, newer_schema, older_schema,
    /// read_only, locked, corrupt; of a programme server's address unreachable.
    static Store open(const std::string& path, StoreOptions options = {});
    /// Opens the store, or makes it if there is none.
    static Store open_or_create(const std::string& path, bool demo = false, StoreOptions options = {});
    /// A file of that name exists and is not an unfinished store (which create() replaces), or it is the
    /// address of a server.
    static bool exists(const std::string& path);
    /// The schema version this program writes.
    static int schema_version();
    /// The schema version of this store: lower with StoreOptions::older_schema only.
    int found_schema() const noexcept;

    Store(Store&&) noexcept;
    Store& operator=(Store&&) noexcept;
    ~Store();

    /// The file, or the server's address: what open() takes.
    const std::string& path() const noexcept;
    bool is_read_only() const noexcept;
    /// The programme server: what all stations have sent, read only. People::account_session() signs in.
    bool is_server() const noexcept;
    bool is_demo() const;
    const std::string& station_id() const noexcept;
    /// By the clock; in a sealed demo store time resumes when its record ends, whatever the date.
    UtcMilliseconds now() const;
    BootTime boot_time() const;

    /// The session of the program itself: synthetic work, db check. No person's data.
    Session station_session() const;

    /// True once *Create programme* was done.
    bool has_administrator() const;
    /// Empty if there is no programme.
    std::string programme_name() const;

    /// What the store will say; the window uses it to show or hide. False for unknown subjects.
    bool allowed(const Session& session, Operation operation, const Subject& subject = {}) const;
    /// As allowed(), throwing AccessDenied. Every room calls it first.
    void require(const Session& session, Operation operation, const Subject& subject = {}) const;

    /// Attempts found running without their program when this connection opened; closed as interrupted, in
    /// the audit chain.
    const std::vector<InterruptedAttempt>& interrupted_at_open() const noexcept;

    /// Reads everything once. Operation::check_store.
    CheckReport check(const Session& session, const StoreProgress& progress = {}) const;
    /// A consistent copy while others write (SQLite backup interface), 0600. False if it was stopped, leaving
    /// no file. Operation::backup. Throws StoreError exists.
    bool backup(const Session& session, const std::string& to_path, const StoreProgress& progress = {}) const;
    /// Ends the building of a demo store: from then on only practice attempts are accepted. The audit log
    /// gets the machine's date, as the times in the store may be simulated.
    void seal_demo(const Session& station);

    Connection& connection() const noexcept;  ///< for the rooms of this floor
    /// Signs what this station writes; read, or made to sign from that row of its audit log on, when it is
    /// first asked for, and again where the log `expects` another one (its public half; empty: none yet). For
    /// the rooms of this floor. Throws StoreError (failed).
    const StationKey& key(std::int64_t next_row, const std::vector<std::uint8_t>& expected) const;
    void use_key(const StationKey& key) const;

  private:
    struct State;
    explicit Store(std::unique_ptr<State> state);
    static Store open_server(const std::string& address, StoreOptions options);
    std::unique_ptr<State> state_;
};

}  // namespace fulcrum::database
