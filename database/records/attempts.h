// SPDX-License-Identifier: GPL-3.0-or-later
// Reads attempts; adds scores next to the one in force; voids and reassigns. Every call is checked against
// the access table. By concern: attempts.cpp lists and reads, attempt_trace.cpp decodes traces,
// attempt_changes.cpp changes, stale_scores.cpp finds scores that are out of date.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "database/rows/attempt_records.h"
#include "database/rows/trace_codec.h"
#include "database/store/store.h"

namespace fulcrum::database {

struct AttemptFilter {
    std::string person_id;              ///< "" any the session may read
    std::string task_id;                ///< "" any
    std::string cohort_id;              ///< "" any
    std::optional<AttemptState> state;  ///< empty: any; as AttemptSummary::state
    bool include_synthetic = true;      ///< people marked synthetic or external
    bool include_voided = true;
    int limit = 1000;  ///< newest first
    /// Only what tables and standings of a cohort need: without names, device, scene, comments, links and
    /// what the recorder says. Inside of this floor.
    bool for_table = false;
};

/// What a person has performed of one variant of a task.
struct VariantPractice {
    int attempts = 0;  ///< ended, not voided, assessed or practice
    int passes = 0;    ///< of those that count (AttemptSummary::counting)
};

struct CorrectionRequest {
    std::string id, attempt_id, person_id, person_name, text;
    std::int64_t asked = 0;
    bool settled = false;  ///< the attempt was voided or reassigned since
};

/// What a score made today would be based on.
struct ScoringInForce {
    std::map<std::string, int> metric_versions;  ///< by metric id
    /// As AttemptMeta::limits, by task, variant, device class and fidelity of an attempt; "": none.
    std::function<std::string(const AttemptMeta&)> limits;
};

/// An attempt none of whose scores is based on what is in force.
struct StaleScore {
    std::string attempt_id, person_id, person_name, task_id;
    std::string
        why;  ///< of its newest score: "sparc 1, now 2; limits A2-provisional@1, now A2-provisional@2"
    std::optional<bool> passed;  ///< of the score in force
};

/// Assessed attempts of one person at one task that were cut off one after the other: interrupted, ended by a
/// simulator fault, or turned into practice by a lost device. Newest first.
struct CutOffSeries {
    std::vector<AttemptSummary> attempts;
};

class Attempts {
  public:
    explicit Attempts(const Store& store) : store_(store) {}

    /// Those the session may read, newest first; others are left out, not refused (a named person or cohort
    /// is refused).
    std::vector<AttemptSummary> list(const Session& session, const AttemptFilter& filter = {}) const;
    AttemptSummary read(const Session& session, const std::string& attempt_id) const;
    /// By variant. Throws AccessDenied, StoreError.
    std::map<std::string, VariantPractice> practised(const Session& session, const std::string& person_id,
                                                     const std::string& task_id) const;
    /// Interrupted attempts within the session's scope that nobody has scored yet, oldest first: what their
    /// record holds decides whether they failed (docs/MANUAL.md), and add_score() writes it.
    std::vector<AttemptSummary> interrupted_without_score(const Session& session) const;
    /// The newest attempts of each real person at each task, where at least `least` in a row were cut off;
    /// the series with the newest attempt first. Of those the session may read.
    std::vector<CutOffSeries> cut_off_series(const Session& session, std::size_t least = 3) const;
    /// The score in force, if the attempt has one.
    std::optional<ScoreRow> score(const Session& session, const std::string& attempt_id) const;
    /// All scores, the one in force first.
    std::vector<ScoreRow> scores(const Session& session, const std::string& attempt_id) const;
    /// Everything recorded; checks every chunk. StoreError corrupt names the chunk.
    Trace read_trace(const Session& session, const std::string& attempt_id) const;
    /// The same with its samples and inputs packed (Trace::ticks): an hour takes tens of megabytes of memory,
    /// not 1.1 GB. Checked as there. In memory as they are where the two streams were not written together.
    Trace read_packed_trace(const Session& session, const std::string& attempt_id) const;
    /// What charts need of the samples, decoded on all cores, several times faster than read_trace():
    /// `prepare` gets the number of chunks, then `visit` each of them once, in any order, from worker
    /// threads at the same time (chunks never overlap in time; their numbers rise with it). Every chunk is
    /// checked as there.
    void read_overview(const Session& session, const std::string& attempt_id,
                       const std::function<void(std::size_t chunks)>& prepare,
                       const std::function<void(std::size_t chunk, const TraceOverview&)>& visit) const;
    std::vector<Event> read_events(const Session& session, const std::string& attempt_id) const;
    /// The scene as the attempt used it; empty for attempts from before scenes were kept. StoreError corrupt
    /// where the text is gone or does not match its digest. Operation::read_attempt.
    std::string scene_text(const Session& session, const std::string& attempt_id) const;
    /// The state that an attempt with an origin began with, unpacked; empty for others. StoreError corrupt
    /// where it does not match its checksum. Operation::read_trace.
    std::vector<std::uint8_t> start_state(const Session& session, const std::string& attempt_id) const;
    /// Of everything that its replay is made of: trace, scene, seed, the state that it began with; hex. Made
    /// of the stored checksums, which read_trace() compares. Operation::read_trace.
    std::string record_digest(const Session& session, const std::string& attempt_id) const;
    /// The files that it was performed with, by name; none for attempts from before they were kept.
    /// Operation::read_attempt.
    std::vector<AssetFile> assets(const Session& session, const std::string& attempt_id) const;
    std::vector<ProductBlob> products(const Session& session, const std::string& attempt_id) const;

    /// The first score of an attempt (one that was interrupted) is in force; any other is kept next to it.
    /// Returns its id.
    std::string add_score(const Session& session, const std::string& attempt_id, const ScoreRow& score) const;

    /// Those within the session's scope whose score is out of date, oldest first; voided ones are left out,
    /// and so is what was interrupted and has no score yet. A named person is refused outside the scope.
    /// Operation::recompute_score.
    std::vector<StaleScore> stale_scores(const Session& session, const ScoringInForce& now,
                                         const std::string& person_id = {}) const;

    /// Takes it out of progress, cohorts and benchmarks; it stays visible. Never one's own; a reason is
    /// needed.
    void void_attempt(const Session& educator, const std::string& attempt_id,
                      const std::string& reason) const;
    /// Voids it and writes a linked copy (trace, scores) for the right person. Returns the copy's id.
    std::string reassign(const Session& educator, const std::string& attempt_id, const std::string& person_id,
                         const std::string& reason) const;
    /// A trainee asks for either.
    void request_correction(const Session& trainee, const std::string& attempt_id,
                            const std::string& text) const;
    std::vector<CorrectionRequest> correction_requests(const Session& session) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
