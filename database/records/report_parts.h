// SPDX-License-Identifier: GPL-3.0-or-later
// What the reports of one person and of a cohort are made of. Internal to this floor.
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "database/records/attempts.h"
#include "database/records/report_data.h"
#include "database/records/report_provenance.h"
#include "database/store/score_rows.h"

namespace fulcrum::database {

struct PersonName {
    std::string id, login, name;
    bool synthetic = false;
    bool active = true;
};

/// Throws not_found.
PersonName name_of(const Store& store, const std::string& person_id);

/// The released forms that the session may see, by attempt.
using ReleasedForms = std::map<std::string, std::vector<RatingRow>>;
ReleasedForms released_forms(const Store& store, const Session& session, const std::string& person_id,
                             const std::string& task_id = {});

/// All attempts of a person that were not voided.
AttemptFilter all_of_person(const std::string& person_id);

/// What decides about standings apart from attempts.
struct Decisions {
    std::vector<CurriculumAssignment> followed;
    std::vector<OverrideRow> overrides;
    std::vector<ReleasedRating> ratings;   ///< empty where the curriculum asks for none
    std::vector<LimitsPutInForce> limits;  ///< as PersonRecord
};

Decisions decisions_of(const Store& store, const Session& session, const std::string& person_id,
                       const Curriculum& curriculum);

/// One person's attempts, oldest first, and what is shown with them.
struct PersonSource {
    PersonName person;
    std::vector<AttemptSummary> attempts;    ///< not voided
    std::vector<AttemptSummary> voided;      ///< empty where nobody asks for them
    std::map<std::string, ScoreRow> scores;  ///< in force, by attempt; empty: the report shows no metrics
    /// In place of scores: the metrics alone, by attempt, of more people than this one.
    std::unordered_map<std::string, std::vector<MetricRow>>* metrics = nullptr;
    ReleasedForms released;  ///< empty where the report is not to be exported

    void add(AttemptSummary&& attempt);
    void sort();  ///< after the last one was added
};

/// Tasks in the order given; every task has at least one row.
std::vector<CohortRow> rows_of(const PersonSource& source, const std::vector<std::string>& tasks);
/// From then on only what the standings count is counting in the source, for rows and progress.
PersonStandings standings_of(PersonSource& source, const Curriculum& curriculum, std::int64_t at,
                             const Decisions& decisions);
/// Takes the scores of this task out of the source.
PersonProgress progress_of(PersonSource& source, const std::string& task_id, Provenance& provenance);
/// Rows, progress and standings of one person from the same attempts.
PersonData data_of(PersonSource& source, const PersonDataOptions& options, const Decisions& decisions,
                   std::int64_t at, Provenance& provenance);
/// Adds the tasks of these attempts; sorted.
void add_tasks(std::vector<std::string>& tasks, const std::vector<AttemptSummary>& attempts);

}  // namespace fulcrum::database
