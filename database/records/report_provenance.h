// SPDX-License-Identifier: GPL-3.0-or-later
// Versions that the values of a report are based on, gathered over the attempts that enter them. Internal to
// this room.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "database/rows/attempt_records.h"
#include "database/store/audit.h"

namespace fulcrum::database {

/// What a query knows of each attempt, as texts: the versions of its metrics, or the file of its limits. They
/// change where the program of a station or its files change, so between two attempts of one group with the
/// same texts no others are looked for: few attempts are asked about, whatever their number. A report of one
/// person has its own: the attempts of others may be from another station.
class SharedTexts {
  public:
    using Set = std::set<std::string>;
    /// What attempts have in common. Its words are those of attempts and of tables, not copies.
    using Group = std::array<std::string_view, 6>;
    /// `sql`: asks for an attempt's id and a text, for the ids in the list that is put in place of %1.
    SharedTexts(const Store& store, QString sql) : store_(store), sql_(std::move(sql)) {}
    /// The attempt and the words of its group stay where they are until each().
    void add(const Group& group, const AttemptSummary& attempt) { added_[group].push_back(&attempt); }
    /// Every set of texts that occurs in a group, with an attempt that has it. Forgets what was added.
    void each(const std::function<void(const AttemptSummary&, const Set&)>& visit);

  private:
    using Attempts = std::vector<const AttemptSummary*>;  ///< by start
    const Set& of(const AttemptSummary& attempt);
    /// Of several in one query: of() knows them from then on.
    void read(const Attempts& attempts);
    void look_between(const Attempts& attempts, std::size_t first, std::size_t last,
                      const std::function<void(const AttemptSummary&, const Set&)>& visit);
    const Store& store_;
    QString sql_;
    std::map<Group, Attempts> added_;
    std::set<Set> sets_;
    std::unordered_map<std::string_view, const Set*> known_;  ///< by attempt
};

class Provenance {
  public:
    /// Which files are asked for: of assessed attempts, where the sets are a third of them, or also of
    /// practice.
    enum class Kinds { all, benchmark_sets, of_practice_too };
    /// Over the attempts (table `a`) for which `whose` holds with this value. `copies`: of reassigned
    /// attempts among them, where the caller has read them.
    Provenance(const Store& store, const QString& whose, const std::string& value, Kinds kinds = Kinds::all,
               std::optional<std::set<std::string>> copies = std::nullopt);
    /// The attempt stays where it is until write().
    void add(const AttemptSummary& attempt);
    /// The same where the metrics of its score have been read.
    void add(const AttemptSummary& attempt, const std::vector<MetricRow>& metrics);
    template <typename Report>
    void write(Report& report, const std::string& audit_head) {
        versions_.each([this](const AttemptSummary&, const SharedTexts::Set& versions) {
            metrics_.insert(versions.begin(), versions.end());
        });
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
    /// As the attempts used them.
    struct Files {
        std::vector<AssetFile> all;                                ///< by name
        std::map<std::string, std::set<std::string>> set_digests;  ///< by the name of the limits
    };
    void add_basis(const AttemptSummary& attempt);
    bool is_copy(const std::string& attempt_id);
    Files used_files();
    Files used_sets();
    std::vector<std::string> named_sets(const Files& files) const;

    const Store& store_;
    SharedTexts versions_;   ///< "path_len@1"
    SharedTexts set_files_;  ///< digest and file; on a screen
    std::optional<std::set<std::string>> copies_;
    QString whose_;
    std::string value_;
    Kinds kinds_;
    std::set<std::string> metrics_, sets_, programs_;
    std::map<int, std::string> task_versions_;  ///< their words, which groups name
};

}  // namespace fulcrum::database
