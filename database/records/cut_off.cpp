// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts that were cut off again and again: one loss of power is bad luck, three in a row are for an
// educator to look at.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "database/records/attempt_query.h"

namespace fulcrum::database {
namespace {

/// Attempts that began as assessed and became practice because a device was lost.
std::set<std::string> became_practice(Connection& connection) {
    std::set<std::string> ids;
    Query rows(connection, "SELECT object_id FROM audit_entry WHERE operation = 'attempt.practice'");
    while (rows.next()) ids.insert(rows.text(0));
    return ids;
}

}  // namespace

std::vector<CutOffSeries> Attempts::cut_off_series(const Session& session, std::size_t least) const {
    store_.require(session, Operation::read_attempt);
    AttemptFilter filter;
    filter.include_synthetic = filter.include_voided = false;
    filter.limit = -1;
    const std::set<std::string> practice = became_practice(store_.connection());
    std::map<std::pair<std::string, std::string>, CutOffSeries> newest;
    std::set<std::pair<std::string, std::string>> over;  // an attempt ran to its end after that
    for (AttemptSummary& attempt : query_attempts(store_, session, filter)) {  // newest first
        const bool lost_device = practice.count(attempt.meta.id) > 0;
        if (attempt.meta.mode != AttemptMode::assessed && !lost_device) continue;
        if (attempt.state == AttemptState::running) continue;
        const auto key = std::make_pair(attempt.meta.person_id, attempt.meta.task_id);
        if (over.count(key) > 0) continue;
        if (lost_device || is_cut_off(attempt.state)) {
            newest[key].attempts.push_back(std::move(attempt));
        } else {
            over.insert(key);
        }
    }
    std::vector<CutOffSeries> found;
    for (auto& [key, series] : newest)
        if (series.attempts.size() >= least) found.push_back(std::move(series));
    std::sort(found.begin(), found.end(), [](const CutOffSeries& a, const CutOffSeries& b) {
        return a.attempts.front().meta.started > b.attempts.front().meta.started;
    });
    return found;
}

}  // namespace fulcrum::database
