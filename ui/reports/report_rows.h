// SPDX-License-Identifier: GPL-3.0-or-later
// What every report says in the same way. Internal to this room.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ui/reports/report.h"

namespace fulcrum::ui {

ReportProvenance provenance_of(const database::Store& store, const database::Session& session,
                               const std::string& program_version);
nlohmann::ordered_json provenance_json(const ReportProvenance& provenance);
/// A released form with its answers.
nlohmann::ordered_json rating_json(const database::RatingRow& rating);
nlohmann::ordered_json metric_json(const database::MetricRow& metric);
/// Why an attempt has no verdict, in English. `continues`: it is practice that began with a state of another
/// one; such an attempt has no score that could say so.
std::string why_not_scored(const Statement& because, bool continues);
/// With a blank between them.
std::string joined(const std::vector<std::string>& parts);
/// "tasks/A2.json sha256:9f86…", with a blank between them.
std::string joined_assets(const std::vector<database::AssetFile>& files);
/// What the values of a report are based on.
template <typename Source>
void take_basis(ReportProvenance& provenance, const Source& from) {
    provenance.audit_head = from.audit_head;
    provenance.metric_versions = from.metric_versions;
    provenance.benchmark_sets = from.benchmark_sets;
    provenance.program_versions = from.program_versions;
    provenance.assets = from.assets;
}
/// Null where the table has no standing of this person in this task.
const TaskStanding* standing_in(const database::CohortTable& table, const std::string& person_id,
                                const std::string& task_id);
/// Of one person, for JSON: standing of each task and what an educator should look at.
nlohmann::ordered_json standings_json(const database::PersonStandings& person);

}  // namespace fulcrum::ui
