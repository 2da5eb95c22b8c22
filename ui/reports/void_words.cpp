// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/void_words.h"

#include "ui/reports/report_texts.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

QStringList void_notes(const database::AttemptSummary& attempt) {
    QStringList notes;
    if (attempt.state != AttemptState::voided) return notes;
    notes << ReportTexts::tr("Voided by %1 on %2: %3. It does not count.")
                 .arg(text(attempt.voided_by), local_time(attempt.voided_at), text(attempt.void_reason));
    if (!attempt.reassigned_to.empty())
        notes << ReportTexts::tr("A copy was stored for the person who performed it.");
    return notes;
}

}  // namespace fulcrum::ui
