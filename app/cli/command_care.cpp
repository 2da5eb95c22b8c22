// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum db backup, restore and migrate: copies of the store, and what takes its place.
#include <iostream>

#include "app/cli/commands.h"
#include "database/store/backup_rotation.h"
#include "database/store/damaged_copy.h"
#include "database/store/store_restore.h"
#include "database/sync/station_erasure.h"

namespace fulcrum::app {
namespace {

/// A new file in the folder, and at most `keep` of them.
int rotate_backups(const Arguments& arguments, int keep) {
    const database::Store store = open_store(arguments, false);
    const auto done =
        database::backup_into(store, person_session(arguments, store), arguments.words()[0], keep);
    if (!done) return 1;
    if (arguments.has("--json")) {
        print_json({{"store", store_path(arguments)}, {"backup", done->path}, {"removed", done->removed}});
    } else {
        std::cout << "backed up " << store_path(arguments) << " to " << done->path << " (checked)\n";
        for (const std::string& path : done->removed) std::cout << "removed " << path << '\n';
    }
    return 0;
}

/// A copy of a store that does not pass its check.
int copy_damaged(const Arguments& arguments) {
    const std::string path = store_path(arguments);
    const database::DamagedCopy copy = database::copy_damaged(
        path, arguments.words()[0],
        [&](const database::Store& store) { return person_session(arguments, store); });
    if (arguments.has("--json")) {
        print_json({{"store", path},
                    {"copy", copy.path},
                    {"verified", false},
                    {"by_database", copy.by_database},
                    {"unreadable_bytes", copy.unreadable_bytes}});
        return 0;
    }
    std::cout << "copied " << path << " to " << copy.path << " as it is; NOT verified, and no backup\n";
    if (!copy.by_database) std::cout << "SQLite cannot read it: file and log were copied byte by byte\n";
    if (copy.unreadable_bytes > 0)
        std::cout << copy.unreadable_bytes << " bytes could not be read from the disk and are zeros\n";
    return 0;
}

int backup(const Arguments& arguments) {
    if (arguments.has("--damaged") && arguments.has("--keep"))
        throw UsageError("--damaged", QT_TRANSLATE_NOOP("errors", "cannot be used with --keep"),
                         QT_TRANSLATE_NOOP("errors", "a copy that nobody has verified replaces no backup"));
    if (arguments.has("--damaged")) return copy_damaged(arguments);
    if (arguments.has("--keep"))
        return rotate_backups(
            arguments, static_cast<int>(arguments.integer("--keep", 1, 1, database::most_kept_backups)));
    const database::Store store = open_store(arguments, false);
    const std::string& to = arguments.words()[0];
    store.backup(person_session(arguments, store), to);
    if (arguments.has("--json")) {
        print_json({{"store", store_path(arguments)}, {"backup", to}});
    } else {
        std::cout << "backed up " << store_path(arguments) << " to " << to << " (checked)\n";
    }
    return 0;
}

int restore(const Arguments& arguments) {
    const std::string path = store_path(arguments), from = arguments.words()[0];
    if (!arguments.has("--as"))
        throw UsageError(
            "--as",
            QT_TRANSLATE_NOOP("errors", "is missing; only an administrator of the backup restores it"),
            QT_TRANSLATE_NOOP(
                "errors", "sign in with --as LOGIN, and --password-file FILE where there is no terminal"));
    const database::Replaced done = database::restore_store(
        from, path, [&](const database::Store& copy) { return session_of(arguments, copy); });
    const int erased = database::erase_listed(database::Store::open(path));
    if (arguments.has("--json")) {
        print_json({{"store", path},
                    {"restored", from},
                    {"schema", done.from_schema},
                    {"head", done.head},
                    {"erased", erased},
                    {"kept", or_null(done.kept)},
                    {"kept_head", or_null(done.before)}});
    } else {
        std::cout << "restored " << path << " from " << from << " (checked before and after)\n";
        if (erased > 0)
            std::cout << "people whom this station had erased since, and who were erased again: " << erased
                      << '\n';
        if (!done.kept.empty()) std::cout << "what was there before is kept in " << done.kept << '\n';
    }
    return 0;
}

int migrate(const Arguments& arguments) {
    const std::string path = store_path(arguments);
    const database::Replaced done = database::migrate_store(path);
    const int now = database::Store::schema_version();
    if (arguments.has("--json")) {
        print_json({{"store", path}, {"from", done.from_schema}, {"to", now}, {"kept", or_null(done.kept)}});
    } else if (done.kept.empty()) {
        std::cout << path << " has schema " << now << " already\n";
    } else {
        std::cout << "brought " << path << " from schema " << done.from_schema << " to " << now
                  << "; the old file is kept in " << done.kept << '\n';
    }
    return 0;
}

}  // namespace

std::vector<Command> care_commands() {
    return {
        {"db backup", "TO", 1, 1,
         QT_TRANSLATE_NOOP("commands",
                           "Copies the store to a new file and checks the copy before it gets its name."),
         joined({{"--keep", "N",
                  QT_TRANSLATE_NOOP("commands",
                                    "TO is a folder: write a file named by the time, and keep the newest N "
                                    "backups of this station there; older ones are removed.")},
                 {"--damaged", "",
                  QT_TRANSLATE_NOOP("commands",
                                    "Copy a store that does not pass the check, as it is. The name of the "
                                    "copy ends in -unverified.db; it replaces no backup.")}},
                session_options()),
         backup},
        {"db restore", "FROM", 1, 1,
         QT_TRANSLATE_NOOP("commands",
                           "Puts a backup in the store's place, after checking it; the old store is kept."),
         session_options(), restore},
        {"db migrate",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP(
             "commands",
             "Brings an older store up to this program's schema, after checking it; the old file is kept."),
         {store_option(), json_option()},
         migrate}};
}

}  // namespace fulcrum::app
