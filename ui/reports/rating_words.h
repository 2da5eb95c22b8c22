// SPDX-License-Identifier: GPL-3.0-or-later
// Ratings with observer forms in words, the same on screens and on paper.
#pragma once

#include <QString>

#include "assessment/forms/observer_form.h"
#include "database/records/ratings.h"

namespace fulcrum::ui {

/// A form's title, an item's title or an anchor in the reader's language.
QString form_text(const std::string& english);
/// "17 of 25"; "–" where nothing was rated.
QString rating_sum_text(const ObserverForm& form, const FormAnswers& answers);
/// "4 of 5", "not seen".
QString rating_answer_text(const FormItem& item, const std::optional<int>& answer);
/// Whether the rater could see name and score: "blind", "not blind"; empty where the form does not ask.
QString blinding_text(database::Blinding blinding);
/// How far raters who used one form for one attempt are apart, in a sentence; empty for fewer than two.
QString rating_spread_text(const ObserverForm& form, const std::vector<FormAnswers>& answers);
/// ICC with its interval and what they mean, or why there is none.
QString rater_agreement_text(const database::FormAgreement& agreement);

}  // namespace fulcrum::ui
