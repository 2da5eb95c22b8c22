// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/station_erasure.h"

#include <QDir>
#include <QFileInfo>
#include <fstream>
#include <set>
#include <sstream>

#include "database/records/people_rows.h"
#include "database/rows/connection.h"
#include "database/store/station_key.h"
#include "database/sync/erasure.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

constexpr const char* list_heading = "Fulcrum erasures 1: people whom this station has erased";

struct Listed {
    std::string person_id, time;
};

[[noreturn]] void fail_list(const std::string& path, const Sentence& why) {
    throw StoreError(
        StoreErrorKind::failed, {QT_TRANSLATE_NOOP("errors", "%1: the list of erased people: %2"), path, why},
        QT_TRANSLATE_NOOP("errors", "put its copy back, or make its folder writable; nothing was erased"));
}

std::vector<Listed> read_list(const std::string& path) {
    std::ifstream file(path);
    std::vector<Listed> list;
    if (!file) return list;
    std::string line;
    if (!std::getline(file, line) || line != list_heading)
        fail_list(path, QT_TRANSLATE_NOOP("errors", "is not such a list"));
    while (std::getline(file, line)) {
        std::istringstream words(line);
        Listed one;
        if (!(words >> one.person_id >> one.time)) fail_list(path, QT_TRANSLATE_NOOP("errors", "is damaged"));
        list.push_back(std::move(one));
    }
    return list;
}

void require_erasable(const Store& store, const std::string& person_id) {
    if (store.is_demo())
        throw StoreError(StoreErrorKind::sealed_demo,
                         QT_TRANSLATE_NOOP("errors", "nobody is erased in the demonstration"),
                         QT_TRANSLATE_NOOP("errors", "name the store of the programme with --db"));
    if (has_begun_exchange(store))
        throw StoreError(
            StoreErrorKind::conflict,
            QT_TRANSLATE_NOOP("errors", "this programme has a server, which would bring the person back"),
            QT_TRANSLATE_NOOP(
                "errors",
                "erase on the server (`fulcrum server erase`); each station follows at its next "
                "sync"));
    if (is_last_administrator(store.connection(), person_id))
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the last administrator cannot be erased"),
                         QT_TRANSLATE_NOOP("errors", "give another person the role first"));
}

}  // namespace

bool has_begun_exchange(const Store& store) {
    Query row(store.connection(),
              "SELECT 1 FROM audit_entry WHERE station_id = ? AND operation LIKE 'sync.%' LIMIT 1");
    row.bind(store.station_id());
    return row.next();
}

std::string erasure_list_path(const std::string& station_id) {
    const QFileInfo key(QString::fromStdString(StationKey::path_of(station_id)));
    return (key.path() + QLatin1Char('/') + key.completeBaseName() + QStringLiteral(".erased")).toStdString();
}

void add_to_erasure_list(const Store& store, const std::vector<std::string>& people) {
    // Under the write lock of the store, so that two do not overwrite each other.
    Transaction transaction(store.connection());
    const std::string path = erasure_list_path(store.station_id());
    std::string text = std::string(list_heading) + "\n";
    std::set<std::string> written;
    const auto write = [&](const Listed& one) {
        if (!written.insert(one.person_id).second) return false;
        text += one.person_id + " " + one.time + "\n";
        return true;
    };
    for (const Listed& one : read_list(path)) write(one);
    bool is_new = false;
    for (const std::string& id : people) is_new = write({id, iso_utc(store.now())}) || is_new;
    if (!is_new) return;
    try {
        QDir().mkpath(QFileInfo(QString::fromStdString(path)).path());
        write_output_file(path, text, OutputFile::Existing::replace, OutputFile::Access::owner_only);
    } catch (const std::system_error& error) {
        fail_list(path, {QT_TRANSLATE_NOOP("errors", "cannot be written (%1)"), error.code().message()});
    }
    transaction.commit();
}

std::vector<ErasedRows> erase_person(const Store& store, const Session& director,
                                     const std::string& person_id, const std::string& reason, bool dry_run) {
    store.require(director, Operation::erase_person, Subject::person(person_id));
    std::vector<ErasedRows> rows = rows_to_erase(store.connection(), person_id);
    require_erasable(store, person_id);
    if (dry_run) return rows;
    if (reason.find_first_not_of(" \t\n") == std::string::npos)
        throw StoreError(StoreErrorKind::bad_value, QT_TRANSLATE_NOOP("errors", "an erasure needs a reason"),
                         QT_TRANSLATE_NOOP("errors",
                                           "say who asked for it; the reason itself stays, so name "
                                           "nobody in it"));
    Transaction transaction(store.connection());
    const std::vector<std::string> people = with_merged(store.connection(), person_id);
    for (const std::string& id : people) erase_at_station(store, id, director, reason);
    // Cut off between the list and the commit: the next start erases whom it names.
    add_to_erasure_list(store, people);
    transaction.commit();
    return rows;
}

int erase_listed(const Store& store) {
    int erased = 0;
    for (const Listed& one : read_list(erasure_list_path(store.station_id()))) {
        try {
            if (erase_at_station(store, one.person_id, store.station_session(),
                                 "on the list of erased people of this station"))
                ++erased;
        } catch (const StoreError& error) {
            if (error.kind() != StoreErrorKind::locked) throw;  // performs now: at the next start
        }
    }
    return erased;
}

}  // namespace fulcrum::database
