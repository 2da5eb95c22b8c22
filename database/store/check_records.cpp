// SPDX-License-Identifier: GPL-3.0-or-later
// Every deed has its rows and every row its deed: the digests in the audit payloads against the tables.
#include <QJsonDocument>
#include <QJsonObject>
#include <map>

#include "database/store/record_digests.h"
#include "database/store/store_check.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

struct KnownRecord {
    std::string digest;    ///< "": it is gone
    std::string sequence;  ///< of the newest audit row about it
    Sentence about;        ///< " of attempt 4f2a...", where the row says so
    bool seen = false;
};

/// A baseline enters the records of a store from before there were digests: once, before all others. A later
/// one would make any edit good.
void require_one_baseline(bool any_before, const std::string& sequence, CheckItem& item) {
    if (any_before)
        item.problems.push_back(
            {QT_TRANSLATE_NOOP(
                 "errors",
                 "audit row %1: enters all records again, although earlier rows have their digests"),
             sequence});
}

std::map<std::string, KnownRecord> read_known(const Store& store, CheckItem& item) {
    std::map<std::string, KnownRecord> known;
    Query rows(store.connection(),
               "SELECT e.sequence, p.payload, e.operation FROM audit_entry e JOIN audit_payload p ON "
               "p.station_id = e.station_id AND p.sequence = e.sequence ORDER BY e.station_id, e.sequence");
    while (rows.next()) {
        const std::string payload = rows.text(1);
        if (payload.find(records_key) == std::string::npos) continue;
        const QJsonObject said = QJsonDocument::fromJson(QByteArray::fromStdString(payload)).object();
        const QJsonObject digests = said.value(QLatin1String(records_key)).toObject();
        if (rows.text(2) == baseline_operation) require_one_baseline(!known.empty(), rows.text(0), item);
        const std::string attempt = said.value(QLatin1String("attempt")).toString().toStdString();
        for (auto digest = digests.begin(); digest != digests.end(); ++digest) {
            known[digest.key().toStdString()] = {
                digest.value().toString().toStdString(), rows.text(0),
                attempt.empty() ? Sentence()
                                : Sentence(QT_TRANSLATE_NOOP("errors", " of attempt %1"), attempt),
                false};
        }
    }
    return known;
}

}  // namespace

void check_records(const Store& store, CheckItem& item, CheckWatch& watch) {
    std::map<std::string, KnownRecord> known = read_known(store, item);
    if (known.empty()) {
        item.problems.push_back(QT_TRANSLATE_NOOP("errors",
                                                  "the audit log has no digests of the records: open the "
                                                  "store once for writing, or restore the newest backup"));
        return;
    }
    RecordDigests digests(store.connection());
    const double all = static_cast<double>(known.size());
    for (const RecordName& name : all_records(store.connection())) {
        constexpr std::int64_t between = 64;
        if (++item.count % between == 0 && !watch.at(static_cast<double>(item.count) / all)) return;
        const std::string digest = digests.of(name);
        const auto found = known.find(name.text());
        if (found == known.end() || found->second.digest.empty()) {
            item.problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "%1: the audit log has no row for it"), name.text()});
        } else if (found->second.digest != digest &&
                   (digest.empty() || found->second.digest != digests.of_before_origins(name))) {
            item.problems.push_back({digest.empty()
                                         ? QT_TRANSLATE_NOOP("errors", "%1%2: gone since audit row %3")
                                         : QT_TRANSLATE_NOOP("errors", "%1%2: changed since audit row %3"),
                                     name.text(), found->second.about, found->second.sequence});
        }
        if (found != known.end()) found->second.seen = true;
    }
    for (const auto& [name, record] : known) {
        if (!record.seen && !record.digest.empty())
            item.problems.push_back({QT_TRANSLATE_NOOP("errors", "%1%2: gone since audit row %3"), name,
                                     record.about, record.sequence});
    }
}

}  // namespace fulcrum::database
