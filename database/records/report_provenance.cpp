// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/report_provenance.h"

#include <algorithm>
#include <iterator>

#include "database/records/attempt_query.h"
#include "database/rows/connection.h"

namespace fulcrum::database {

const std::set<std::string>& MetricVersions::copies() {
    if (copies_) return *copies_;
    copies_.emplace();
    Query rows(store_.connection(),
               "SELECT a.id FROM attempt a JOIN attempt_asset c ON c.attempt_id = a.id AND c.file "
               "= " FULCRUM_COPIED_FROM " WHERE " +
                   whose_ +
                   " UNION SELECT a.id FROM attempt a JOIN attempt_reassignment c ON c.to_id = a.id WHERE " +
                   whose_);
    rows.bind(value_).bind(value_);
    while (rows.next()) copies_->insert(rows.text(0));
    return *copies_;
}

MetricVersions::Group MetricVersions::group_of(const AttemptSummary& attempt) {
    const AttemptMeta& meta = attempt.meta;
    const bool is_alone = is_cut_off(attempt.recorded_state) || copies().count(meta.id) != 0;
    return {attempt.station_id,
            meta.program_version,
            meta.task_id,
            std::to_string(meta.task_version),
            row_of(device_classes, meta.device_class).name,
            is_alone ? meta.id : std::string()};
}

const MetricVersions::Set& MetricVersions::of(const AttemptSummary& attempt) {
    std::map<Moment, const Set*>& known = known_[group_of(attempt)];
    const Moment moment{attempt.meta.started, attempt.meta.id};
    const auto next = known.lower_bound(moment);
    if (next != known.end()) {
        if (next->first == moment) return *next->second;
        if (next != known.begin() && std::prev(next)->second == next->second) return *next->second;
    }
    read({&attempt});
    const auto found = known.find(moment);
    return found == known.end() ? none_ : *found->second;
}

void MetricVersions::read(const std::vector<const AttemptSummary*>& attempts) {
    constexpr std::size_t at_once = 500;  // a statement has room for so many values
    for (std::size_t from = 0; from < attempts.size(); from += at_once) {
        const std::size_t to = std::min(attempts.size(), from + at_once);
        Query rows(store_.connection(),
                   "SELECT DISTINCT s.attempt_id, m.id, m.version FROM metric m JOIN score s ON s.id = "
                   "m.score_id WHERE s.in_force = 1 AND s.attempt_id IN (?" +
                       QString(", ?").repeated(static_cast<int>(to - from) - 1) + ")");
        for (std::size_t i = from; i < to; ++i) rows.bind(attempts[i]->meta.id);
        std::map<std::string, Set> versions;
        while (rows.next()) versions[rows.text(0)].insert(rows.text(1) + "@" + rows.text(2));
        for (std::size_t i = from; i < to; ++i) {
            const AttemptMeta& meta = attempts[i]->meta;
            const auto found = versions.find(meta.id);
            if (found == versions.end()) continue;
            known_[group_of(*attempts[i])].emplace(Moment{meta.started, meta.id},
                                                   &*sets_.insert(found->second).first);
        }
    }
}

void Provenance::add_basis(const AttemptMeta& meta) {
    programs_.insert(meta.program_version);
    if (!meta.limits.empty()) sets_.insert(meta.limits);
}

void Provenance::add(const AttemptSummary& attempt) {
    add_basis(attempt.meta);
    if (attempt.passed || !attempt.not_scored_because.empty())
        to_look_up_[versions_.group_of(attempt)].emplace_back(attempt.meta.started, &attempt);
}

void Provenance::add(const AttemptSummary& attempt, const std::vector<MetricRow>& metrics) {
    add_basis(attempt.meta);
    for (const MetricRow& metric : metrics) metrics_.insert(metric.id + "@" + std::to_string(metric.version));
}

void Provenance::look_up_versions() {
    std::vector<const AttemptSummary*> ends;
    for (auto& [group, attempts] : to_look_up_) {
        std::stable_sort(attempts.begin(), attempts.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        ends.push_back(attempts.front().second);
        if (attempts.size() > 1) ends.push_back(attempts.back().second);
    }
    versions_.read(ends);
    for (const auto& [group, attempts] : to_look_up_) {
        std::size_t first = 0, last = attempts.size() - 1;
        while (first < last && versions_.of(*attempts[first].second).empty()) ++first;
        while (first < last && versions_.of(*attempts[last].second).empty()) --last;
        look_up_versions(attempts, first, last);
    }
    to_look_up_.clear();
}

void Provenance::look_up_versions(const Scored& attempts, std::size_t first, std::size_t last) {
    const MetricVersions::Set& from = versions_.of(*attempts[first].second);
    const MetricVersions::Set& to = versions_.of(*attempts[last].second);
    metrics_.insert(from.begin(), from.end());
    metrics_.insert(to.begin(), to.end());
    if (&from == &to || last - first < 2) return;
    const std::size_t middle = first + (last - first) / 2;
    look_up_versions(attempts, first, middle);
    look_up_versions(attempts, middle, last);
}

Provenance::Files Provenance::used_files() const {
    Files files;
    std::set<std::pair<std::string, std::string>> all;
    Query rows(
        store_.connection(),
        QString("SELECT DISTINCT a.limits, f.file, f.digest FROM attempt a JOIN attempt_asset f ON "
                "f.attempt_id = a.id AND f.file <> " FULCRUM_COPIED_FROM " %1 WHERE a.mode = 'assessed' AND ")
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
