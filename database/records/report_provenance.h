// SPDX-License-Identifier: GPL-3.0-or-later
// Versions that the values of a report are based on, gathered over the attempts that enter them. Internal to
// this room.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "database/rows/attempt_records.h"
#include "database/store/audit.h"

namespace fulcrum::database {

/// The versions of the metrics in the scores of one report's attempts. They change where the program of a
/// station is updated, so between two attempts of one station (of one task and version, device class and
/// program) with the same ones no others are looked for: few attempts are asked about, whatever their number.
/// Attempts that were cut off may have been scored later, by another program, and the copy of a reassigned
/// one has the scores of the station that recorded it: each of these is asked about. A report of one person
/// has its own: the attempts of others may be from another station.
class MetricVersions {
  public:
    using Set = std::set<std::string>;         ///< "path_len@1"
    using Group = std::array<std::string, 6>;  ///< what attempts have in common
    Group group_of(const AttemptSummary& attempt);

    /// `whose`, `value`: as those of Provenance.
    MetricVersions(const Store& store, const QString& whose, const std::string& value)
        : store_(store), whose_(whose), value_(value) {}
    /// Empty where the attempt has no score, or one without metrics.
    const Set& of(const AttemptSummary& attempt);
    /// Of several in one query: of() knows them from then on.
    void read(const std::vector<const AttemptSummary*>& attempts);

  private:
    using Moment = std::pair<std::int64_t, std::string>;  ///< start, attempt
    /// Copies of reassigned attempts among them, read once.
    const std::set<std::string>& copies();
    const Store& store_;
    QString whose_;
    std::string value_;
    std::optional<std::set<std::string>> copies_;
    Set none_;
    std::set<Set> sets_;
    std::map<Group, std::map<Moment, const Set*>> known_;  ///< none of them empty
};

class Provenance {
  public:
    /// Which files are asked for: the sets are a third of them.
    enum class Kinds { all, benchmark_sets };
    /// Over the attempts (table `a`) for which `whose` holds with this value.
    Provenance(const Store& store, const QString& whose, const std::string& value, Kinds kinds = Kinds::all)
        : store_(store), versions_(store, whose, value), whose_(whose), value_(value), kinds_(kinds) {}
    /// The attempt stays where it is until write().
    void add(const AttemptSummary& attempt);
    /// The same where the metrics of its score have been read.
    void add(const AttemptSummary& attempt, const std::vector<MetricRow>& metrics);
    template <typename Report>
    void write(Report& report, const std::string& audit_head) {
        look_up_versions();
        report.metric_versions.assign(metrics_.begin(), metrics_.end());
        Files files = used_files();
        report.benchmark_sets = named_sets(files);
        report.assets = std::move(files.all);
        report.program_versions.assign(programs_.begin(), programs_.end());
        report.audit_head = audit_head;
    }
    template <typename Report>
    void write(Report& report) {
        write(report, Audit(store_).head());
    }

  private:
    /// As the assessed attempts used them.
    struct Files {
        std::vector<AssetFile> all;                                ///< by name
        std::map<std::string, std::set<std::string>> set_digests;  ///< by the name of the limits
    };
    using Scored = std::vector<std::pair<std::int64_t, const AttemptSummary*>>;  ///< by start
    void add_basis(const AttemptMeta& meta);
    void look_up_versions();
    /// Those of the attempts from `first` to `last`.
    void look_up_versions(const Scored& attempts, std::size_t first, std::size_t last);
    Files used_files() const;
    std::vector<std::string> named_sets(const Files& files) const;

    const Store& store_;
    MetricVersions versions_;
    QString whose_;
    std::string value_;
    Kinds kinds_;
    std::set<std::string> metrics_, sets_, programs_;
    std::map<MetricVersions::Group, Scored> to_look_up_;
};

}  // namespace fulcrum::database
