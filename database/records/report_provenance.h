// SPDX-License-Identifier: GPL-3.0-or-later
// Versions that the values of a report are based on, gathered over the attempts that enter them. Internal to
// this room.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "database/rows/attempt_records.h"
#include "database/store/audit.h"

namespace fulcrum::database {

/// One program gives one set of metric versions for a task: asked once, not for every attempt.
class MetricVersions {
  public:
    explicit MetricVersions(const Store& store) : store_(store) {}
    const std::set<std::string>& of(const AttemptSummary& attempt);

  private:
    const Store& store_;
    std::map<std::array<std::string, 4>, std::set<std::string>> known_;
};

class Provenance {
  public:
    /// Which files are asked for: the sets are a third of them.
    enum class Kinds { all, benchmark_sets };
    /// Over the attempts (table `a`) for which `whose` holds with this value.
    Provenance(const Store& store, MetricVersions& versions, const QString& whose, const std::string& value,
               Kinds kinds = Kinds::all)
        : store_(store), versions_(versions), whose_(whose), value_(value), kinds_(kinds) {}
    void add(const AttemptSummary& attempt);
    template <typename Report>
    void write(Report& report, const std::string& audit_head) const {
        report.metric_versions.assign(metrics_.begin(), metrics_.end());
        Files files = used_files();
        report.benchmark_sets = named_sets(files);
        report.assets = std::move(files.all);
        report.program_versions.assign(programs_.begin(), programs_.end());
        report.audit_head = audit_head;
    }
    template <typename Report>
    void write(Report& report) const {
        write(report, Audit(store_).head());
    }

  private:
    /// As the assessed attempts used them.
    struct Files {
        std::vector<AssetFile> all;                                ///< by name
        std::map<std::string, std::set<std::string>> set_digests;  ///< by the name of the limits
    };
    Files used_files() const;
    std::vector<std::string> named_sets(const Files& files) const;

    const Store& store_;
    MetricVersions& versions_;
    QString whose_;
    std::string value_;
    Kinds kinds_;
    std::set<std::string> metrics_, sets_, programs_;
    std::set<const std::set<std::string>*> added_;
};

}  // namespace fulcrum::database
