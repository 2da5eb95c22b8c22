// SPDX-License-Identifier: GPL-3.0-or-later
// What must be known about an attempt to read its result: voided, taken over, practised with other files,
// simulated, without force, with errors that an educator struck.
#include <QLabel>
#include <algorithm>

#include "database/records/error_reviews.h"
#include "ui/reports/unaccepted_files.h"
#include "ui/reports/void_words.h"
#include "ui/review/debrief_page.h"
#include "ui/review/trace_panel.h"
#include "ui/services/device_service.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

/// Which are not those of simulated experts.
bool only_limits_of_task(const database::ScoreRow& score) {
    return std::none_of(score.gates.begin(), score.gates.end(), [](const database::GateRow& gate) {
        return gate.provisional && gate.kind == GateKind::benchmark;
    });
}

}  // namespace

QStringList DebriefPage::notes() const {
    const database::AttemptSummary& attempt = model_->summary;
    const bool voided = attempt.state == AttemptState::voided;
    const std::optional<bool> passed = model_->score ? model_->score->passed : attempt.passed;
    QStringList notes = void_notes(attempt);
    if (!attempt.reassigned_from.empty()) {
        notes << tr("Reassigned: recorded under another name and copied to the person who performed it.");
    }
    if (!unaccepted_.empty()) notes << unaccepted_note(unaccepted_);
    if (attempt.meta.device_class == DeviceClass::synthetic)
        notes << tr("Performed by a simulated operator, not by a person.");
    else if (attempt.synthetic)
        notes << tr("Performed in the demonstration, on the account of a synthetic person.");
    if (attempt.meta.origin) {
        const double from_s = attempt.meta.origin->tick * model_->tick;
        notes
            << (attempt.meta.origin->source_id.empty()
                    ? tr("Practice from step %1 of a demonstration: never scored.")
                          .arg(attempt.meta.origin->goal + 1)
                    : tr("Practice from the moment %1 of an attempt: never scored.").arg(clock_text(from_s)));
    } else if (!passed && !voided) {
        const Statement why = model_->score ? model_->score->not_scored_because : attempt.not_scored_because;
        // Where the advice above says the same, once is enough.
        const Statement advice = model_->score ? model_->score->advice : Statement();
        const Statement* said =
            advice.id() == StatementId::not_scored ? advice.statement("because") : nullptr;
        if (said == nullptr || *said != why)
            notes << tr("Not scored: %1")
                         .arg(why.empty() ? tr("the attempt has no score") : statement_text(why));
    }
    if (attempt.provisional) {
        notes
            << (model_->score && only_limits_of_task(*model_->score)
                    ? tr("Limits of the task itself are provisional: no benchmark set of the site has taken "
                         "them over. With them a task can be passed, but nobody becomes proficient.")
                    : tr("The limits are provisional: they come from simulated experts, not from surgeons. "
                         "With them a task can be passed, but nobody becomes proficient."));
    }
    if (attempt.without_limits && attempt.meta.mode == AttemptMode::assessed) {
        notes << tr(
            "No set of limits applies to this attempt. It failed for another reason, such as a critical "
            "error, and neither gives nor ends proficiency.");
    }
    if (struck_ > 0)
        notes << tr(
            "An educator struck %n errors that the program had recorded. The score stays as it is: "
            "scores are never edited. An educator can void the attempt, or decide on the standing.",
            "", struck_);
    if (model_->recomputed) {
        const database::ScoreRow& recomputed = *model_->recomputed;
        QString result = verdict(recomputed.passed, false);
        if (recomputed.passed && recomputed.points) result += tr(", %1").arg(points_text(*recomputed.points));
        if (!recomputed.passed)
            result += QStringLiteral(" (%1)").arg(statement_text(recomputed.not_scored_because));
        notes << tr("Recomputed on %1 with newer metrics or limits: %2. The score shown stays in force.")
                     .arg(local_time(recomputed.computed), result);
    }
    const QString felt = felt_text(attempt.meta.force_devices);
    if (felt.isEmpty() && !model_->scope_alone &&
        (attempt.meta.device_class == DeviceClass::mouse_keyboard ||
         attempt.meta.device_class == DeviceClass::controller)) {
        notes << tr("Force was not felt: this device cannot render it. It was shown as bars.");
    }
    if (!felt.isEmpty()) notes << felt;
    if (attempt.meta.device == two_mice_title && !attempt.meta.limits.empty())
        notes << tr(
            "Performed with two mice, for which no limits exist: it is compared with those of mouse and "
            "keyboard.");
    if (attempt.meta.rig_use) notes << rig_text(attempt.meta.device, *attempt.meta.rig_use);
    if (attempt.lost_samples > 0) notes << tr("%1 samples were lost.").arg(attempt.lost_samples);
    return notes;
}

/// While the person rates blind, what others said of the errors stays hidden, as their ratings do.
void DebriefPage::read_reviews() {
    std::vector<database::ErrorReview> reviews;
    context().guarded([&] {
        reviews = database::ErrorReviews(context().store()).in_force(context().session(), attempt_id_);
    });
    if (blind_)
        reviews.erase(std::remove_if(reviews.begin(), reviews.end(),
                                     [&](const database::ErrorReview& review) {
                                         return review.author_id != context().session().person_id();
                                     }),
                      reviews.end());
    struck_ = static_cast<int>(
        std::count_if(reviews.begin(), reviews.end(), [](const database::ErrorReview& review) {
            return review.verdict == database::ErrorVerdict::struck;
        }));
    traces_->show_reviews(std::move(reviews));
}

void DebriefPage::show_notes() {
    const QStringList shown = notes();
    notes_->setText(shown.join(QLatin1Char('\n')));
    notes_->setVisible(!shown.isEmpty());
}

}  // namespace fulcrum::ui
