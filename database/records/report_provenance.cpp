// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/report_provenance.h"

#include <algorithm>
#include <tuple>

#include "database/records/attempt_query.h"
#include "database/rows/connection.h"

namespace fulcrum::database {

void SharedTexts::each(const std::function<void(const AttemptSummary&, const Set&)>& visit) {
    Attempts ends;
    for (auto& [group, attempts] : added_) {
        std::stable_sort(
            attempts.begin(), attempts.end(), [](const AttemptSummary* a, const AttemptSummary* b) {
                return std::tie(a->meta.started, a->meta.id) < std::tie(b->meta.started, b->meta.id);
            });
        ends.push_back(attempts.front());
        if (attempts.size() > 1) ends.push_back(attempts.back());
    }
    read(ends);
    for (const auto& [group, attempts] : added_) {
        std::size_t first = 0, last = attempts.size() - 1;
        while (first < last && of(*attempts[first]).empty()) ++first;
        while (first < last && of(*attempts[last]).empty()) --last;
        look_between(attempts, first, last, visit);
    }
    added_.clear();
    known_.clear();
}

void SharedTexts::look_between(const Attempts& attempts, std::size_t first, std::size_t last,
                               const std::function<void(const AttemptSummary&, const Set&)>& visit) {
    const Set &from = of(*attempts[first]), &to = of(*attempts[last]);
    visit(*attempts[first], from);
    if (&from != &to) visit(*attempts[last], to);
    if (&from == &to || last - first < 2) return;
    const std::size_t middle = first + (last - first) / 2;
    look_between(attempts, first, middle, visit);
    look_between(attempts, middle, last, visit);
}

const SharedTexts::Set& SharedTexts::of(const AttemptSummary& attempt) {
    const auto known = known_.find(attempt.meta.id);
    if (known != known_.end()) return *known->second;
    read({&attempt});
    return *known_.at(attempt.meta.id);
}

void SharedTexts::read(const Attempts& attempts) {
    constexpr std::size_t at_once = 500;  // a statement has room for so many values
    for (std::size_t from = 0; from < attempts.size(); from += at_once) {
        const std::size_t to = std::min(attempts.size(), from + at_once);
        Query rows(store_.connection(),
                   sql_.arg("?" + QString(", ?").repeated(static_cast<int>(to - from) - 1)));
        for (std::size_t i = from; i < to; ++i) rows.bind(attempts[i]->meta.id);
        std::map<std::string, Set> texts;
        while (rows.next()) texts[rows.text(0)].insert(rows.text(1));
        for (std::size_t i = from; i < to; ++i)
            known_[attempts[i]->meta.id] = &*sets_.insert(texts[attempts[i]->meta.id]).first;
    }
}

Provenance::Provenance(const Store& store, const QString& whose, const std::string& value, Kinds kinds,
                       std::optional<std::set<std::string>> copies)
    : store_(store),
      versions_(store,
                "SELECT DISTINCT s.attempt_id, m.id || '@' || m.version FROM metric m JOIN score s ON s.id = "
                "m.score_id WHERE s.in_force = 1 AND s.attempt_id IN (%1)"),
      set_files_(store,
                 "SELECT f.attempt_id, f.digest || ' ' || f.file FROM attempt_asset f WHERE "
                 "f.file > 'benchmarks/' AND f.file < 'benchmarks0' AND f.attempt_id IN (%1)"),
      copies_(std::move(copies)),
      whose_(whose),
      value_(value),
      kinds_(kinds) {}

bool Provenance::is_copy(const std::string& attempt_id) {
    if (!copies_) copies_ = copies_among(store_, whose_, value_);
    return copies_->count(attempt_id) != 0;
}

void Provenance::add_basis(const AttemptSummary& attempt) {
    const AttemptMeta& meta = attempt.meta;
    programs_.insert(meta.program_version);
    if (meta.limits.empty()) return;
    sets_.insert(meta.limits);
    if (kinds_ == Kinds::benchmark_sets && meta.mode == AttemptMode::assessed)
        set_files_.add({attempt.station_id,
                        meta.program_version,
                        meta.task_id,
                        meta.limits,
                        {},
                        is_copy(meta.id) ? std::string_view(meta.id) : std::string_view()},
                       attempt);
}

void Provenance::add(const AttemptSummary& attempt) {
    add_basis(attempt);
    if (!attempt.passed && attempt.not_scored_because.empty()) return;
    // Attempts that were cut off may have been scored later, by another program, and the copy of a reassigned
    // one has the scores of the station that recorded it: each of these is asked about.
    const AttemptMeta& meta = attempt.meta;
    const bool is_alone = is_cut_off(attempt.recorded_state) || is_copy(meta.id);
    std::string& version = task_versions_[meta.task_version];
    if (version.empty()) version = std::to_string(meta.task_version);
    versions_.add({attempt.station_id, meta.program_version, meta.task_id, version,
                   row_of(device_classes, meta.device_class).name,
                   is_alone ? std::string_view(meta.id) : std::string_view()},
                  attempt);
}

void Provenance::add(const AttemptSummary& attempt, const std::vector<MetricRow>& metrics) {
    add_basis(attempt);
    for (const MetricRow& metric : metrics) metrics_.insert(metric.id + "@" + std::to_string(metric.version));
}

Provenance::Files Provenance::used_sets() {
    Files files;
    std::set<std::pair<std::string, std::string>> all;
    set_files_.each([&](const AttemptSummary& attempt, const SharedTexts::Set& texts) {
        for (const std::string& text : texts) {
            const std::size_t space = text.find(' ');
            all.emplace(text.substr(space + 1), text.substr(0, space));
            files.set_digests[attempt.meta.limits].insert(text.substr(0, space));
        }
    });
    for (const auto& [name, digest] : all) files.all.push_back({name, digest});
    return files;
}

Provenance::Files Provenance::used_files() {
    if (kinds_ == Kinds::benchmark_sets) return used_sets();
    Files files;
    std::set<std::pair<std::string, std::string>> all;
    const QString of_mode = kinds_ == Kinds::of_practice_too ? "" : "a.mode = 'assessed' AND ";
    Query rows(store_.connection(),
               "SELECT DISTINCT a.limits, f.file, f.digest FROM attempt a JOIN attempt_asset f ON "
               "f.attempt_id = a.id AND f.file <> " FULCRUM_COPIED_FROM " WHERE " +
                   of_mode + whose_);
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
