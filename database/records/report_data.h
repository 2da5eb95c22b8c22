// SPDX-License-Identifier: GPL-3.0-or-later
// The one query behind screens and exports, so that their values always agree. Voided attempts, and people
// marked synthetic or external (unless asked), are left out. Device classes are never pooled: every row has
// one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "assessment/pathology/pathology.h"
#include "database/records/cohort_standings.h"
#include "database/records/rating_summary.h"
#include "database/rows/attempt_records.h"
#include "database/store/store.h"

namespace fulcrum::database {

/// The reason that exports give for practice that continues another attempt: it has no score that could. In
/// English, as all of their reasons.
inline constexpr const char* never_scored_words =
    "practice from a moment of another attempt or of a demonstration is never scored";

enum class TaskState { open, attempted, passed };
const char* task_state_name(TaskState state);

struct CohortTableOptions {
    std::vector<std::string> tasks;          ///< columns; empty: the tasks that have attempts
    bool include_synthetic = false;          ///< demo stores: always
    const Curriculum* curriculum = nullptr;  ///< null: no standings
};

/// One person, one task, one device class. A person who never tried a task has one row
/// without a device class.
struct CohortRow {
    std::string person_id, login, name, task_id;
    std::optional<DeviceClass> device_class;
    TaskState state = TaskState::open;
    bool provisional = false;  ///< every pass is based on provisional limits: "passed (provisional)"
    /// Counting: assessed, scored, ended by the trainee or the clock; with a curriculum those that the
    /// standing of the task counts.
    int attempts = 0;
    int passes = 0;        ///< of these
    int not_counting = 0;  ///< practice, interrupted, not scored, or not counted by the standing
    std::optional<double> best_points;
    std::string best_attempt_id;
    std::int64_t last_attempt = 0;   ///< UTC ms, any attempt; 0 none
    std::vector<RatedForm> ratings;  ///< released forms of its attempts; in exports only
    bool active = true;              ///< false: the account is deactivated
};

struct CohortTable {
    std::string cohort_id, cohort_name;
    std::int64_t as_of = 0;                    ///< UTC ms
    std::vector<std::string> tasks;            ///< columns, in order
    int people = 0;                            ///< n, without the deactivated
    int deactivated = 0;                       ///< people with rows who cannot sign in any more
    int left_out_synthetic = 0;                ///< people of the cohort left out
    std::vector<CohortRow> rows;               ///< by name, then task, then device class
    std::string curriculum;                    ///< "rectal@1"; empty: no standings were asked for
    std::vector<PersonStandings> standings;    ///< of the same people, in the same order
    std::vector<std::string> metric_versions;  ///< "path_len@1", sorted
    std::vector<std::string> benchmark_sets;   ///< "B1-operators@1 sha256:9f86d081884c7d65", sorted
    std::vector<std::string> program_versions;
    /// Files of the assessed attempts behind the values, by name; on a screen those of benchmark sets alone.
    std::vector<AssetFile> assets;
    std::string audit_head;  ///< hex, printed on reports
};

struct ProgressPoint {
    std::string attempt_id;
    int number = 0;  ///< 1, 2, ... within its series
    std::int64_t started = 0;
    int utc_offset_min = 0;
    AttemptMode mode = AttemptMode::practice;
    AttemptState state = AttemptState::running;
    std::string variant, fidelity, limits;
    bool counting = false;
    /// Counts by itself, but no standing counts it: `counting` is false.
    bool left_out = false;
    bool continues = false;  ///< practice from a state of another attempt or of a demonstration: never scored
    double duration_s = 0;
    std::optional<bool> passed;
    bool provisional = false;
    Statement not_scored_because;
    std::optional<double> points;
    std::vector<MetricRow> metrics;            ///< of the score in force
    std::vector<GateRow> gates;                ///< of the score in force
    std::optional<PathologyReport> pathology;  ///< of the score in force, where the task leaves a specimen
    std::vector<RatingRow> ratings;            ///< released forms, by handing in
};
struct ProgressSeries {
    DeviceClass device_class = DeviceClass::mouse_keyboard;
    std::vector<ProgressPoint> points;  ///< by start
};
/// An attempt that an educator took out, for those who have already received it.
struct VoidedAttempt {
    std::string attempt_id;
    std::int64_t started = 0, at = 0;       ///< UTC ms
    std::vector<std::string> ratings = {};  ///< ids of its released forms
};
struct PersonProgress {
    std::string person_id, login, name, task_id;
    bool synthetic = false;
    TaskState state = TaskState::open;   ///< over all device classes shown
    std::vector<ProgressSeries> series;  ///< by device class
    std::vector<VoidedAttempt> voided;   ///< by start; in no other figure
    std::vector<std::string> metric_versions, benchmark_sets, program_versions;
    std::vector<AssetFile> assets;
    std::string audit_head;
};

/// All that an exported report says of a person, from one reading of the attempts.
struct PersonData {
    std::string person_id, login, name;
    bool synthetic = false;
    std::vector<CohortRow> rows;           ///< by task, then device class
    std::vector<PersonProgress> progress;  ///< one a task; their provenance is below
    std::optional<PersonStandings> standings;
    std::vector<std::string> metric_versions, benchmark_sets, program_versions;
    std::vector<AssetFile> assets;
    std::string audit_head;
};
/// What the points of a progress have of their scores: nothing, their metrics, or metrics, gates and
/// pathology.
enum class PointDetail { none, metrics, all };
struct PersonDataOptions {
    std::vector<std::string> tasks;
    const Curriculum* curriculum = nullptr;  ///< null: no standings
    PointDetail detail = PointDetail::all;
    bool with_rows =
        true;  ///< false: progress alone, without the rows and without versions and benchmark sets
};

/// The pathology report that a score holds; empty where the task leaves no specimen. Screens, paper and
/// exports all read it here. Throws InputError where it cannot be read.
std::optional<PathologyReport> pathology_of(const ScoreRow& score);

/// One attempt in its present state.
struct AttemptReport {
    AttemptSummary attempt;
    std::optional<ScoreRow> score;  ///< in force
    std::optional<PathologyReport> pathology;
    std::vector<std::string> metric_versions, benchmark_sets, program_versions;
    std::vector<AssetFile> assets;
    std::string audit_head;
};

enum class ReportPurpose { screen, exported };  ///< exported: checked as export_cohort, export_person

class Reports {
  public:
    explicit Reports(const Store& store) : store_(store) {}
    CohortTable cohort_table(const Session& session, const std::string& cohort_id,
                             const CohortTableOptions& options = {},
                             ReportPurpose purpose = ReportPurpose::screen) const;
    /// With a curriculum only what its standings count is counting, as in cohort_table.
    PersonProgress person_progress(const Session& session, const std::string& person_id,
                                   const std::string& task_id, ReportPurpose purpose = ReportPurpose::screen,
                                   const Curriculum* curriculum = nullptr) const;
    /// Checked as export_person.
    PersonData person_data(const Session& session, const std::string& person_id,
                           const PersonDataOptions& options) const;
    /// Of each member of a cohort, by name, with how far it is (0 to 1); false once `visit` said so. Checked
    /// as export_cohort and export_person.
    bool each_of_cohort(const Session& session, const std::string& cohort_id,
                        const PersonDataOptions& options,
                        const std::function<bool(PersonData&&, double)>& visit) const;
    /// Both from one reading of the attempts: the table, and each person of it when it is whole; nothing once
    /// `visit` returned false. Checked as each_of_cohort.
    std::optional<CohortTable> table_with_people(
        const Session& session, const std::string& cohort_id, const CohortTableOptions& options,
        const PersonDataOptions& people,
        const std::function<bool(const CohortTable&, PersonData&&, double)>& visit) const;
    AttemptReport attempt_report(const Session& session, const std::string& attempt_id,
                                 ReportPurpose purpose = ReportPurpose::screen) const;
    /// Where a person stands in a curriculum, as in cohort_table.
    PersonStandings standings(const Session& session, const std::string& person_id,
                              const Curriculum& curriculum,
                              ReportPurpose purpose = ReportPurpose::screen) const;
    /// The rows of cohort_table for one person.
    std::vector<CohortRow> person_table(const Session& session, const std::string& person_id,
                                        const std::vector<std::string>& tasks,
                                        ReportPurpose purpose = ReportPurpose::screen,
                                        const Curriculum* curriculum = nullptr) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
