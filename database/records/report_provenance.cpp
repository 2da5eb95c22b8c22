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

Provenance::Files Provenance::used_files() const {
    Files files;
    std::set<std::pair<std::string, std::string>> all;
    Query rows(
        store_.connection(),
        QString("SELECT DISTINCT a.limits, f.file, f.digest FROM attempt a JOIN attempt_asset f ON "
                "f.attempt_id = a.id %1 WHERE a.mode = 'assessed' AND ")
                // A range of the table's key, which sorts bytes.
                .arg(kinds_ == Kinds::all ? "" : "AND f.file > 'benchmarks/' AND f.file < 'benchmarks0'") +
            whose_);
    rows.bind(value_);
    while (rows.next()) {
        all.emplace(rows.text(1), rows.text(2));
        if (rows.text(1).rfind("benchmarks/", 0) == 0) files.set_digests[rows.text(0)].insert(rows.text(2));
    }
    for (const auto& [name, digest] : all) files.all.push_back({name, digest});
    return files;
}

/// With the beginning of the SHA-256 of each set's file: a name alone says nothing about the limits.
std::vector<std::string> Provenance::named_sets(const Files& files) const {
    std::vector<std::string> sets;
    for (const std::string& name : sets_) {
        const auto known = files.set_digests.find(name);
        if (known == files.set_digests.end()) {
            sets.push_back(name);
            continue;
        }
        for (const std::string& digest : known->second)
            sets.push_back(name + " sha256:" + digest.substr(0, 16));
    }
    return sets;
}

}  // namespace fulcrum::database
