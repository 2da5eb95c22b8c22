// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/audit_words.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

constexpr WordsOf operations[] = {
    {"asset.accept", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "File accepted for assessed attempts")},
    {"attempt.begin", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Attempt begun")},
    {"attempt.finish", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Attempt finished")},
    {"attempt.interrupted", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Attempt interrupted")},
    {"attempt.practice", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Attempt became practice")},
    {"attempt.import", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "External attempt imported")},
    {"attempt.reassign", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Attempt reassigned")},
    {"attempt.request_correction", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Correction requested")},
    {"attempt.void", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Attempt voided")},
    {"cohort.create", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Cohort created")},
    {"cohort.rename", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Cohort renamed")},
    {"cohort.set_educators", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Educators of a cohort set")},
    {"cohort.set_members", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Members of a cohort set")},
    {"comment.send", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Comment sent")},
    {"error.review", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Error confirmed or struck")},
    {"curriculum.move",
     QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Moved to another version of the curriculum")},
    {"demo.seal", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Demonstration closed")},
    {"goal.drop", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Personal goal dropped or changed")},
    {"goal.set", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Personal goal set")},
    {"payload.erase", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Contents of audit rows erased")},
    {"password.change", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Password changed")},
    {"password.issue_one_time", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "One-time password issued")},
    {"password.recover", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Password recovered")},
    {"person.create", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Person added")},
    {"person.create_synthetic", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Synthetic person added")},
    {"person.move_login", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Login of a simulated person changed")},
    {"key.begin", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "First row signed by the new key")},
    {"key.rotate", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "New key of the station announced")},
    {"person.merge", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Person merged into another account")},
    {"person.rename", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Person renamed")},
    {"person.set_active", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Account activated or deactivated")},
    {"person.unmerge", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Merge of a person undone")},
    {"person.set_login", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Login changed")},
    {"person.set_roles", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Roles changed")},
    {"programme.create", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Programme created")},
    {"programme.export_research", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Exported for research")},
    {"rating.hand_in", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Rating handed in")},
    {"rating.release", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Rating shown to the trainee")},
    {"schedule.add", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Report scheduled")},
    {"schedule.fail", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Scheduled report not written")},
    {"schedule.remove", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Schedule of a report ended")},
    {"schedule.write", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Scheduled report written")},
    {"score.add", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Score added")},
    {"setting.sign_in_picker", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Sign-in list shown or hidden")},
    {"sign_in", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Signed in")},
    {"standing.decide", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Standing decided by an educator")},
    {"station.enrol", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Enrolled at the programme server")},
    {"store.baseline", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Records entered in the audit log")},
    {"person.export", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "All data of the person exported")},
    {"setting.retention_months", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Time for keeping data set")},
    {"store.backup", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Store backed up")},
    {"store.copy_damaged", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Damaged store copied, unverified")},
    {"store.restore", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Store restored from a backup")},
    {"store.create", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Store created")},
    {"sync.begin", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "First exchange with the programme server begun")},
    {"sync.finish", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Synchronised with the programme server")},
    {"sync.receive", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Received from the programme server")},
    {"tissue.set", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Tissue values set")},
};

constexpr WordsOf groups[] = {
    {"asset", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Accepted files: all")},
    {"attempt", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Attempts: all")},
    {"cohort", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Cohorts: all")},
    {"comment", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Comments: all")},
    {"error", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Reviews of errors: all")},
    {"curriculum", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Versions of the curriculum: all")},
    {"demo", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Demonstration: all")},
    {"goal", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Personal goals: all")},
    {"key", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Keys of the station: all")},
    {"password", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Passwords: all")},
    {"payload", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Erased contents: all")},
    {"person", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "People: all")},
    {"programme", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Programme: all")},
    {"rating", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Ratings: all")},
    {"schedule", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Scheduled reports: all")},
    {"score", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Scores: all")},
    {"setting", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Settings: all")},
    {"standing", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Standings: all")},
    {"station", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Station: all")},
    {"store", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Store: all")},
    {"sync", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Programme server: all")},
    {"tissue", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "Tissue values: all")},
};

}  // namespace

QString audit_group_text(const std::string& group) {
    const QString words = words_in(groups, group, "fulcrum::ui::audit");
    return words.isEmpty() ? text(group) : words;
}

QString audit_operation_text(const std::string& operation) {
    const QString words = words_in(operations, operation, "fulcrum::ui::audit");
    return words.isEmpty() ? text(operation) : words;
}

QString audit_details_text(const std::string& operation, const std::string& payload) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(payload));
    if (!document.isObject()) return text(payload);
    const QJsonObject members = document.object();
    QStringList lines;
    for (auto member = members.begin(); member != members.end(); ++member) {
        const QString said = member.value().toString();
        const bool is_statement = operation == "attempt.practice" && member.key() == QLatin1String("reason");
        lines << member.key() + QStringLiteral(": ") +
                     (is_statement ? statement_text(statement_of(plain(said))) : said);
    }
    return lines.join(QStringLiteral("; "));
}

}  // namespace fulcrum::ui
