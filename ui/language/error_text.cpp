// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/error_text.h"

#include <QCoreApplication>
#include <iterator>

#include "database/rows/errors.h"
#include "ui/language/words.h"

namespace fulcrum::ui {
namespace {

// clang-format off
/// Operations of database/access.h and what else the store refuses.
constexpr WordsOf operations[] = {
    {"read_sign_in_list", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "see who signed in here")},
    {"list_people", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "see the list of people")},
    {"manage_people", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "add or change people")},
    {"manage_roles", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "change roles")},
    {"issue_one_time_password", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "issue a one-time password")},
    {"change_password", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "change this password")},
    {"create_synthetic", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "create synthetic people")},
    {"list_cohorts", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "see the cohorts")},
    {"manage_cohorts", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "change cohorts")},
    {"perform_attempt", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "perform an attempt")},
    {"read_attempt", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "open this attempt")},
    {"read_trace", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "read the recording of this attempt")},
    {"read_progress", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "see this person's progress")},
    {"read_cohort_table", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "see this cohort")},
    {"score_interrupted", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "score interrupted attempts")},
    {"recompute_score", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "recompute scores")},
    {"comment", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "comment on this attempt")},
    {"read_comment", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "read the comments on this attempt")},
    {"mark_comment_read", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "mark comments as read")},
    {"decide_standing", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "decide on someone's standing")},
    {"accept_assets", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "accept files for assessed attempts")},
    {"void_attempt", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "void this attempt")},
    {"reassign_attempt", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "reassign this attempt")},
    {"request_correction", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "ask for a correction of this attempt")},
    {"read_requests", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "read requests for corrections")},
    {"export_person", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "export this person's data")},
    {"export_cohort", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "export this cohort's data")},
    {"view_audit", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "read the audit log")},
    {"check_store", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "check the store")},
    {"backup", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "back up the store")},
    {"manage_settings", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "change settings")},
    {"read_tissues", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "see the tissue values")},
    {"set_tissues", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "change the tissue values")},
    {"rate", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "rate this attempt")},
    {"read_ratings", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "see the ratings of this attempt")},
    {"release_ratings", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "show the ratings of this attempt to the trainee")},
    {"set_goal", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "set this goal")},
    {"read_goals", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "see this person's goals")},
    {"import_attempt", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "import a trace for this person")},
    {"rotate_key", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "change the station's key")},
    {"erase_person", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "erase this person")},
    {"export_all", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "export all that is stored about this person")},
    {"review_error", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "confirm or strike this error")},
    {"merge_people", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "merge these accounts")},
    {"act_as", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "act in this role")},
    {"demo_session", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "use this demonstration account")},
    {"seal_demo", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "close the demonstration programme")},
    {"build_demo", QT_TRANSLATE_NOOP("fulcrum::ui::errors", "build the demonstration")},
};
/// Why it was refused; %1: what the reason is about.
struct ReasonRow {
    database::DenialReason kind;
    const char* shown;
};
constexpr ReasonRow reasons[] = {
    {database::DenialReason::none, ""},
    {database::DenialReason::not_in_role, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "This role does not include it.")},
    {database::DenialReason::demo_practice_only, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "The demonstration accepts practice attempts only.")},
    {database::DenialReason::server_only_read, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "The programme server is only read here. Do it at a station.")},
    {database::DenialReason::outside_people, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "The person is not in your care.")},
    {database::DenialReason::own_attempt, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "You may not do this to your own attempt.")},
    {database::DenialReason::own_account, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "You may not do this to an account of your own.")},
    {database::DenialReason::other_store, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "You are signed in to another programme. Sign in again.")},
    {database::DenialReason::demo_people_elsewhere, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "Demonstration accounts exist in the demonstration only.")},
    {database::DenialReason::demo_only, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "This is possible in the demonstration only.")},
    {database::DenialReason::account_inactive, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "The account is no longer active.")},
    {database::DenialReason::role_withdrawn, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "The role was withdrawn. Sign in again.")},
    {database::DenialReason::one_time_password, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "Change the one-time password first.")},
    {database::DenialReason::role_not_held, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "You do not hold the role %1.")},
    {database::DenialReason::other_login, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "It belongs to another account.")},
    {database::DenialReason::other_form, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "The form belongs to another person.")},
    {database::DenialReason::other_comment, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "The comment belongs to another person.")},
    {database::DenialReason::program_only, QT_TRANSLATE_NOOP("fulcrum::ui::errors", "Only the program does this, in the demonstration.")},
};
// clang-format on
static_assert(in_order(reasons) && std::size(reasons) == std::size(database::denial_reasons),
              "a row for every reason, in the enum's order");

/// Empty without a reason.
QString reason_text(const database::AccessDenied& denied) {
    if (denied.why() == database::DenialReason::none) return {};
    const QString shown =
        QCoreApplication::translate("fulcrum::ui::errors", row_of(reasons, denied.why()).shown);
    return denied.why() == database::DenialReason::role_not_held ? shown.arg(role_text(denied.of())) : shown;
}

}  // namespace

QString error_text(const std::exception& error) {
    const auto* denied = dynamic_cast<const database::AccessDenied*>(&error);
    if (denied == nullptr) return sentence_text(sentence_of(error));
    const QString operation = words_in(operations, denied->operation(), "fulcrum::ui::errors");
    QString line = operation.isEmpty()
                       ? QCoreApplication::translate("fulcrum::ui::errors", "You may not do this as %1.")
                             .arg(role_text(denied->role()))
                       : QCoreApplication::translate("fulcrum::ui::errors", "You may not %1 as %2.")
                             .arg(operation, role_text(denied->role()));
    const QString reason = reason_text(*denied);
    if (!reason.isEmpty()) line += QLatin1Char(' ') + reason;
    return line;
}

}  // namespace fulcrum::ui
