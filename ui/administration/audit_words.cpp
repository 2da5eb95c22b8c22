// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/audit_words.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

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

/// Names in what is stored with a row.
constexpr WordsOf members[] = {
    {"address", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "address")},
    {"administrator", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "administrator")},
    {"after", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "after")},
    {"attempt", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "attempt")},
    {"attempts", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "attempts")},
    {"before", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "before")},
    {"blinding", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "blinding")},
    {"cause", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "cause")},
    {"clock_ahead_s", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "clock ahead (s)")},
    {"cohort", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "cohort")},
    {"cohorts", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "cohorts")},
    {"conflicts", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "conflicts")},
    {"copy", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "copy")},
    {"count", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "number")},
    {"demo", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "demonstration")},
    {"digest", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "digest")},
    {"erased", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "erased")},
    {"every", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "how often")},
    {"file", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "file")},
    {"folder", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "folder")},
    {"form", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "form")},
    {"format", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "format")},
    {"from", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "from")},
    {"head", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "head of the chain")},
    {"into", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "into")},
    {"key", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "key")},
    {"kind", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "kind")},
    {"last", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "last")},
    {"login", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "login")},
    {"mode", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "mode")},
    {"name", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "name")},
    {"new", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "new")},
    {"old", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "old")},
    {"people", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "people")},
    {"person", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "person")},
    {"problem", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "problem")},
    {"programme", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "programme")},
    {"reason", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "reason")},
    {"received", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "received")},
    {"replaced", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "replaced")},
    {"role", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "role")},
    {"roles", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "roles")},
    {"rows", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "rows")},
    {"said", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "message")},
    {"sealed", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "closed")},
    {"sent", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "sent")},
    {"server", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "server")},
    {"sha256", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "SHA-256")},
    {"source", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "source")},
    {"state", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "state")},
    {"state_hash", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "hash of the state")},
    {"takes_over", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "takes over")},
    {"task", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "task")},
    {"text", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "text")},
    {"to", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "to")},
    {"token", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "token")},
    {"what", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "what")},
    {"verifier", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "verifier")},
};

constexpr WordsOf stored_answers[] = {
    {"yes", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "yes")},
    {"no", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "no")},
    {"on", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "on")},
    {"off", QT_TRANSLATE_NOOP("fulcrum::ui::audit", "off")},
};

/// Names separated by commas or spaces.
QString roles_text(const QString& stored) {
    QStringList shown;
    for (const QString& role : stored.split(QRegularExpression(QStringLiteral("[, ]+")), Qt::SkipEmptyParts))
        shown << role_text(plain(role));
    return shown.join(QStringLiteral(", "));
}

/// A word that the program stores in the reader's language; what a person wrote, ids and numbers as they are.
QString value_text(const std::string& operation, const std::string& name, const QString& stored) {
    if (operation == "attempt.practice" && name == "reason")
        return statement_text(statement_of(plain(stored)));
    if (stored == QLatin1String("withheld") && (name == "reason" || name == "text" || name == "state"))
        return QCoreApplication::translate("fulcrum::ui::audit", "withheld");
    if (name == "role" || name == "roles" || operation == "person.set_roles") return roles_text(stored);
    if (name == "mode" || (operation == "attempt.practice" && name == "from")) {
        const auto* const mode = find_row(attempt_modes, plain(stored));
        return mode == nullptr ? stored : mode_text(mode->kind);
    }
    if (name == "state") {
        const auto* const state = find_row(attempt_states, plain(stored));
        return state == nullptr ? stored : attempt_state(state->kind);
    }
    if (operation != "person.set_active" && operation != "store.create" &&
        operation != "setting.sign_in_picker")
        return stored;
    const QString answer = words_in(stored_answers, plain(stored), "fulcrum::ui::audit");
    return answer.isEmpty() ? stored : answer;
}

}  // namespace

QString audit_group_text(const std::string& group) {
    const QString words = words_in(groups, group, "fulcrum::ui::audit");
    return words.isEmpty() ? text(group) : words;
}

QString audit_operation_text(const std::string& operation) {
    const QString words = words_in(operations, operation, "fulcrum::ui::audit");
    return words.isEmpty() ? text(operation) : words;
}

QString audit_member_text(const std::string& name) {
    const QString words = words_in(members, name, "fulcrum::ui::audit");
    return words.isEmpty() ? text(name) : words;
}

QString audit_details_text(const std::string& operation, const std::string& payload) {
    if (payload == "payload erased")
        return QCoreApplication::translate("fulcrum::ui::audit", "payload erased");
    if (payload == "unreadable") return QCoreApplication::translate("fulcrum::ui::audit", "unreadable");
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(payload));
    if (!document.isObject()) return text(payload);
    const QJsonObject stored = document.object();
    QStringList lines;
    for (auto member = stored.begin(); member != stored.end(); ++member) {
        const std::string name = plain(member.key());
        lines << audit_member_text(name) + QStringLiteral(": ") +
                     value_text(operation, name, member.value().toString());
    }
    return lines.join(QStringLiteral("; "));
}

}  // namespace fulcrum::ui
