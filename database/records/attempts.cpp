// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/attempts.h"

#include <algorithm>
#include <set>

#include "database/records/attempt_query.h"
#include "database/rows/crypto.h"
#include "database/store/score_rows.h"

namespace fulcrum::database {
std::vector<AttemptSummary> Attempts::list(const Session& session, const AttemptFilter& filter) const {
    if (!filter.person_id.empty()) {
        store_.require(session, Operation::read_attempt, Subject::person(filter.person_id));
    } else {
        store_.require(session, Operation::read_attempt);
    }
    if (!filter.cohort_id.empty())
        store_.require(session, Operation::list_cohorts, Subject::cohort(filter.cohort_id));
    return query_attempts(store_, session, filter);
}

std::map<std::string, VariantPractice> Attempts::practised(const Session& session,
                                                           const std::string& person_id,
                                                           const std::string& task_id) const {
    AttemptFilter filter;
    filter.person_id = person_id;
    filter.task_id = task_id;
    filter.include_voided = false;
    filter.limit = -1;
    std::map<std::string, VariantPractice> result;
    for (const AttemptSummary& attempt : list(session, filter)) {
        if (attempt.recorded_state == AttemptState::running) continue;
        VariantPractice& variant = result[attempt.meta.variant];
        ++variant.attempts;
        if (attempt.counting && *attempt.passed) ++variant.passes;
    }
    return result;
}

AttemptSummary Attempts::read(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_attempt, attempt_id);
    return query_attempt(store_, attempt_id);
}

std::vector<AttemptSummary> Attempts::interrupted_without_score(const Session& session) const {
    store_.require(session, Operation::score_interrupted);
    AttemptFilter filter;
    filter.state = AttemptState::interrupted;
    filter.limit = -1;
    std::vector<AttemptSummary> attempts = query_attempts(store_, session, filter);
    Query scored(
        store_.connection(),
        "SELECT attempt_id FROM score WHERE in_force = 1 AND attempt_id IN "
        "(SELECT id FROM attempt WHERE state = 'interrupted') UNION SELECT a.id FROM attempt a WHERE "
        "a.station_id <> ? OR NOT " +
            has_trace_here("a"));
    scored.bind(store_.station_id());
    std::set<std::string> done;
    while (scored.next()) done.insert(scored.text(0));
    attempts.erase(std::remove_if(attempts.begin(), attempts.end(),
                                  [&](const AttemptSummary& attempt) {
                                      return attempt.meta.origin || done.count(attempt.meta.id) > 0;
                                  }),
                   attempts.end());
    std::reverse(attempts.begin(), attempts.end());
    return attempts;
}

std::vector<ScoreRow> Attempts::scores(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_attempt, attempt_id);
    std::vector<std::string> ids;
    {
        Query rows(store_.connection(),
                   "SELECT id FROM score WHERE attempt_id = ? ORDER BY in_force DESC, computed, id");
        rows.bind(attempt_id);
        while (rows.next()) ids.push_back(rows.text(0));
    }
    std::vector<ScoreRow> scores;
    for (const std::string& id : ids) scores.push_back(read_score(store_.connection(), id));
    return scores;
}

std::optional<ScoreRow> Attempts::score(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_attempt, attempt_id);
    std::string id;
    {
        Query row(store_.connection(), "SELECT id FROM score WHERE attempt_id = ? AND in_force = 1");
        row.bind(attempt_id);
        if (!row.next()) return std::nullopt;
        id = row.text(0);
    }
    return read_score(store_.connection(), id);
}

std::string Attempts::scene_text(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_attempt, attempt_id);
    return stored_scene_text(store_, attempt_id);
}

std::string stored_scene_text(const Store& store, const std::string& attempt_id) {
    Query row(
        store.connection(),
        "SELECT a.scene_digest, s.text FROM attempt a LEFT JOIN scene_text s ON s.digest = a.scene_digest "
        "WHERE a.id = ?");
    row.bind(attempt_id);
    if (!row.next() || row.text(0).empty()) return {};
    if (row.is_null(1) || text_digest(row.text(1)) != row.text(0))
        throw StoreError(
            StoreErrorKind::corrupt,
            {QT_TRANSLATE_NOOP("errors", "%1: the scene of attempt %2 is damaged"), store.path(), attempt_id},
            QT_TRANSLATE_NOOP("errors", "restore the newest backup"));
    return row.text(1);
}

std::vector<AssetFile> Attempts::assets(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_attempt, attempt_id);
    return assets_of(store_, attempt_id);
}

std::vector<ProductBlob> Attempts::products(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    Query rows(store_.connection(),
               "SELECT kind, checksum, data FROM attempt_product WHERE attempt_id = ? ORDER BY kind");
    rows.bind(attempt_id);
    std::vector<ProductBlob> products;
    while (rows.next()) {
        ProductBlob product{rows.text(0), rows.bytes(2)};
        if (blake2b(product.data, 16) != rows.bytes(1)) {
            throw StoreError(StoreErrorKind::corrupt,
                             {QT_TRANSLATE_NOOP("errors", "%1: product %2 of attempt %3 is damaged"),
                              store_.path(), product.kind, attempt_id},
                             QT_TRANSLATE_NOOP("errors", "restore the newest backup"));
        }
        products.push_back(std::move(product));
    }
    return products;
}

}  // namespace fulcrum::database
