// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/report_provenance.h"

#include "database/rows/connection.h"

namespace fulcrum::database {

const std::set<std::string>& MetricVersions::of(const AttemptSummary& attempt) {
    const AttemptMeta& meta = attempt.meta;
    const std::array<std::string, 4> key{meta.program_version, meta.task_id,
                                         std::to_string(meta.task_version),
                                         row_of(device_classes, meta.device_class).name};
    std::set<std::string>& known = known_[key];
    if (!known.empty() || (!attempt.passed && attempt.not_scored_because.empty())) return known;
    Query rows(store_.connection(),
               "SELECT DISTINCT m.id, m.version FROM metric m JOIN score s ON s.id = m.score_id "
               "WHERE s.attempt_id = ? AND s.in_force = 1");
    rows.bind(attempt.meta.id);
    while (rows.next()) known.insert(rows.text(0) + "@" + rows.text(1));
    return known;
}

void Provenance::add(const AttemptSummary& attempt) {
    programs_.insert(attempt.meta.program_version);
    if (!attempt.meta.limits.empty()) sets_.insert(attempt.meta.limits);
    const std::set<std::string>& versions = versions_.of(attempt);
    if (!versions.empty() && added_.insert(&versions).second)
        metrics_.insert(versions.begin(), versions.end());
}

/// With the beginning of the SHA-256 of each set's file, as assessed attempts used it: a name alone says
/// nothing about the limits.
std::vector<std::string> Provenance::named_sets() const {
    if (sets_.empty()) return {};
    std::map<std::string, std::set<std::string>> digests;
    // Files whose names begin with "benchmarks/".
    Query rows(store_.connection(),
               QString("SELECT DISTINCT a.limits, f.digest FROM attempt a JOIN attempt_asset f ON "
                       "f.attempt_id = a.id AND f.file > 'benchmarks/' AND f.file < 'benchmarks0' WHERE "
                       "a.mode = 'assessed' AND ") +
                   whose_);
    rows.bind(value_);
    while (rows.next()) digests[rows.text(0)].insert(rows.text(1).substr(0, 16));
    std::vector<std::string> sets;
    for (const std::string& name : sets_) {
        const auto known = digests.find(name);
        if (known == digests.end()) {
            sets.push_back(name);
            continue;
        }
        for (const std::string& digest : known->second) sets.push_back(name + " sha256:" + digest);
    }
    return sets;
}

}  // namespace fulcrum::database
