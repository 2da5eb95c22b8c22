// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/attempts.h"
#include "database/records/report_data.h"
#include "database/records/report_provenance.h"

namespace fulcrum::database {

std::optional<PathologyReport> pathology_of(const ScoreRow& score) {
    if (score.pathology.empty()) return std::nullopt;
    return parse_pathology(score.pathology, "score " + score.id);
}

AttemptReport Reports::attempt_report(const Session& session, const std::string& attempt_id,
                                      ReportPurpose purpose) const {
    const Attempts attempts(store_);
    AttemptReport report;
    report.attempt = attempts.read(session, attempt_id);
    if (purpose == ReportPurpose::exported)
        store_.require(session, Operation::export_person, Subject::person(report.attempt.meta.person_id));
    report.score = attempts.score(session, attempt_id);
    if (report.score) report.pathology = pathology_of(*report.score);
    Provenance provenance(store_, "a.id = ?", attempt_id, Provenance::Kinds::of_practice_too);
    if (report.score)
        provenance.add(report.attempt, report.score->metrics);
    else
        provenance.add(report.attempt);
    provenance.write(report);
    return report;
}

}  // namespace fulcrum::database
