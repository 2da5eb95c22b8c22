// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/retention.h"

#include <QDateTime>
#include <algorithm>

#include "database/rows/connection.h"
#include "database/rows/json.h"
#include "database/store/audit.h"
#include "database/store/record_digests.h"
#include "database/store/store_state.h"
#include "database/sync/station_erasure.h"

namespace fulcrum::database {
namespace {

constexpr const char* setting = "retention_months";

/// What is earlier is over.
UtcMilliseconds end_of_keeping(const Store& store, int months) {
    return QDateTime::fromMSecsSinceEpoch(store.now(), Qt::UTC).addMonths(-months).toMSecsSinceEpoch();
}

}  // namespace

std::optional<int> retention_months(const Store& store) {
    const std::string text = read_setting(store.connection(), setting);
    const int months = text.empty() ? 0 : QString::fromStdString(text).toInt();
    return months >= 1 && months <= longest_retention ? std::optional<int>(months) : std::nullopt;
}

void set_retention_months(const Store& store, const Session& director, const std::optional<int>& months) {
    store.require(director, Operation::erase_person);
    if (months && (*months < 1 || *months > longest_retention))
        throw StoreError(StoreErrorKind::bad_value,
                         {QT_TRANSLATE_NOOP("errors", "data cannot be kept for %1 months"), *months},
                         {QT_TRANSLATE_NOOP("errors", "give a number from 1 to %1"), longest_retention});
    Transaction transaction(store.connection());
    const std::string before = read_setting(store.connection(), setting),
                      after = months ? std::to_string(*months) : std::string();
    if (before == after) return;
    write_setting(store.connection(), setting, after);
    Audit(store).append(director, store.station_id(), "setting.retention_months",
                        json_object({{"before", before}, {"after", after}}),
                        {{RecordKind::setting, setting}});
    transaction.commit();
}

std::vector<DuePerson> people_due(const Store& store, const Session& director) {
    store.require(director, Operation::erase_person);
    const std::optional<int> months = retention_months(store);
    if (!months) return {};
    // An account that was merged belongs to the one that it was merged into.
    Query rows(
        store.connection(),
        "SELECT o.id, o.login, o.display_name, MAX(p.created), MAX(COALESCE((SELECT MAX(a.started) FROM "
        "attempt a WHERE a.person_id = p.id), 0)), MAX(COALESCE((SELECT MAX(s.last) FROM sign_in s WHERE "
        "s.person_id = p.id), 0)), SUM((SELECT COUNT(*) FROM attempt a WHERE a.person_id = p.id)) FROM "
        "person o JOIN person p ON p.id = o.id OR p.merged_into = o.id WHERE o.kind = 'real' AND "
        "o.merged_into = '' AND o.login <> 'erased-' || o.id AND EXISTS (SELECT 1 FROM person_role r "
        "WHERE r.person_id = o.id AND r.role = 'trainee') AND NOT EXISTS (SELECT 1 FROM person_role r "
        "WHERE (r.person_id = o.id OR r.person_id = p.id) AND r.role <> 'trainee') GROUP BY o.id, "
        "o.login, o.display_name");
    const UtcMilliseconds end = end_of_keeping(store, *months);
    std::vector<DuePerson> due;
    while (rows.next()) {
        DuePerson person{rows.text(0), rows.text(1), rows.text(2),
                         std::max({rows.integer(3), rows.integer(4), rows.integer(5)}), rows.integer(6)};
        if (person.last < end) due.push_back(std::move(person));
    }
    std::sort(due.begin(), due.end(), [](const DuePerson& a, const DuePerson& b) {
        return a.last != b.last ? a.last < b.last : a.login < b.login;
    });
    return due;
}

std::vector<std::string> erase_due(const Store& store, const Session& director,
                                   const std::vector<std::string>& person_ids,
                                   const StoreProgress& progress) {
    const std::vector<DuePerson> due = people_due(store, director);
    for (const std::string& id : person_ids) {
        if (std::none_of(due.begin(), due.end(), [&](const DuePerson& one) { return one.id == id; }))
            throw StoreError(StoreErrorKind::conflict,
                             {QT_TRANSLATE_NOOP("errors", "%1: this person is not due to be erased"), id},
                             QT_TRANSLATE_NOOP("errors", "look at the list again; nobody was erased"));
    }
    std::vector<std::string> erased;
    for (const std::string& id : person_ids) {
        if (progress && !progress(static_cast<double>(erased.size()) / static_cast<double>(person_ids.size()),
                                  QT_TRANSLATE_NOOP("errors", "erasing people")))
            break;
        erase_person(store, director, id, "the programme's time for keeping data is over", false);
        erased.push_back(id);
    }
    return erased;
}

}  // namespace fulcrum::database
