// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/accepted_assets.h"

#include <algorithm>

#include "database/rows/json.h"
#include "database/store/audit.h"

namespace fulcrum::database {
namespace {

bool is_delivered(const std::string& digest) {
    const std::vector<AssetFile>& files = delivered_assets();
    return std::any_of(files.begin(), files.end(),
                       [&](const AssetFile& file) { return file.digest == digest; });
}

bool is_accepted(const Store& store, const std::string& digest) {
    Query row(store.connection(), "SELECT 1 FROM asset_acceptance WHERE digest = ?");
    row.bind(digest);
    return row.next();
}

/// Accepted at a station that could not pass on what it says, under a name of another folder, or before
/// schema 21.
bool lacks_text(const Store& store, const AssetFile& file) {
    Query row(store.connection(),
              "SELECT 1 FROM asset_acceptance a WHERE a.digest = ? AND NOT EXISTS (SELECT 1 FROM asset_text "
              "t WHERE t.digest = a.digest)");
    row.bind(file.digest);
    return is_passed_on(file) && row.next();
}

}  // namespace

bool is_passed_on(const AssetFile& file) {
    return file.name.rfind("curricula/", 0) == 0 || file.name.rfind("benchmarks/", 0) == 0;
}

bool AcceptedAssets::is_to_accept(const AssetFile& file) const {
    return !unknown({file}).empty() || lacks_text(store_, file);
}

std::vector<AssetFile> AcceptedAssets::unknown(const std::vector<AssetFile>& files) const {
    std::vector<AssetFile> found;
    for (const AssetFile& file : files)
        if (!is_delivered(file.digest) && !is_accepted(store_, file.digest)) found.push_back(file);
    return found;
}

std::vector<AcceptedAsset> AcceptedAssets::list() const {
    // A server shows an account the file also where it does not show who accepted it.
    Query rows(store_.connection(),
               "SELECT a.file, a.digest, COALESCE(p.display_name, ''), a.reason, a.time FROM "
               "asset_acceptance a LEFT JOIN person p ON p.id = a.person_id ORDER BY a.time DESC, a.file");
    std::vector<AcceptedAsset> list;
    while (rows.next())
        list.push_back({{rows.text(0), rows.text(1)}, rows.text(2), rows.text(3), rows.integer(4)});
    return list;
}

std::vector<AcceptedText> AcceptedAssets::texts() const {
    Query rows(store_.connection(),
               "SELECT a.file, a.digest, a.time, t.text FROM asset_acceptance a JOIN asset_text t ON "
               "t.digest = a.digest ORDER BY a.time, a.digest");
    std::vector<AcceptedText> list;
    while (rows.next()) list.push_back({{rows.text(0), rows.text(1)}, rows.integer(2), rows.text(3)});
    return list;
}

void AcceptedAssets::accept(const Session& educator, const AssetFile& file, const std::string& reason,
                            const std::string& text, const std::string& takes_over) const {
    store_.require(educator, Operation::accept_assets);
    if (reason.find_first_not_of(" \t\r\n") == std::string::npos || reason.size() > 4000)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a reason is missing or too long"),
                         QT_TRANSLATE_NOOP("errors", "give a reason of 1 to 4,000 characters"));
    Transaction transaction(store_.connection());
    const bool is_known = unknown({file}).empty();
    if (is_known && (text.empty() || !lacks_text(store_, file)))
        throw StoreError(
            StoreErrorKind::conflict,
            {QT_TRANSLATE_NOOP("errors", "%1: this file can be used in assessed attempts already"),
             file.name},
            QT_TRANSLATE_NOOP("errors", "there is nothing left to do"));
    std::vector<RecordName> records;
    if (!is_known) {
        Query(store_.connection(),
              "INSERT INTO asset_acceptance (digest, file, person_id, time, reason) VALUES (?, ?, ?, ?, ?)")
            .bind(file.digest)
            .bind(file.name)
            .bind(educator.person_id())
            .bind(store_.now())
            .bind(reason)
            .run();
        records.push_back({RecordKind::asset, file.digest});
    }
    if (is_passed_on(file) && !text.empty()) {
        Query(store_.connection(), "INSERT INTO asset_text (digest, text) VALUES (?, ?)")
            .bind(file.digest)
            .bind(text)
            .run();
        records.push_back({RecordKind::asset_text, file.digest});
    }
    const std::string payload =
        takes_over.empty() ? json_object({{"file", file.name}, {"sha256", file.digest}, {"reason", reason}})
                           : json_object({{"file", file.name},
                                          {"sha256", file.digest},
                                          {"reason", reason},
                                          {"takes_over", takes_over}});
    Audit(store_).append(educator, store_.station_id(), "asset.accept", payload, records);
    transaction.commit();
}

Sentence practice_only_words(const std::vector<AssetFile>& unknown) {
    std::string files;
    for (const AssetFile& file : unknown)
        files += (files.empty() ? "" : ", ") + file.name + " (sha256 " + file.digest + ")";
    return {
        QT_TRANSLATE_NOOP("errors",
                          "practice only: these files are neither part of this program nor accepted by the "
                          "programme: %1; an educator accepts a file with `fulcrum assets accept FILE "
                          "--reason TEXT`"),
        files};
}

}  // namespace fulcrum::database
