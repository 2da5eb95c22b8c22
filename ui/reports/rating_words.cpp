// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/rating_words.h"

#include <QCoreApplication>
#include <algorithm>

#include "assessment/learning/rater_agreement.h"
#include "ui/language/language.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString rating_say(const char* source) {
    return QCoreApplication::translate("fulcrum::ui::ratings", source);
}

QString level_word(double icc) {
    switch (agreement_level(icc)) {
        case AgreementLevel::poor:
            return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "poor"));
        case AgreementLevel::moderate:
            return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "moderate"));
        case AgreementLevel::good:
            return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "good"));
        case AgreementLevel::excellent:
            return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "excellent"));
    }
    return {};
}

}  // namespace

QString form_text(const std::string& english) {
    return asset_text(english);
}

QString rating_sum_text(const ObserverForm& form, const FormAnswers& answers) {
    const FormSum sum = form_sum(form, answers);
    if (sum.answered == 0) return QStringLiteral("–");
    return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "%1 of %2")).arg(sum.sum).arg(sum.highest);
}

QString rating_answer_text(const FormItem& item, const std::optional<int>& answer) {
    if (!answer) return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "not seen"));
    return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "%1 of %2")).arg(*answer).arg(item.highest);
}

QString blinding_text(database::Blinding blinding) {
    switch (blinding) {
        case database::Blinding::not_asked:
            return {};
        case database::Blinding::kept:
            return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "blind"));
        case database::Blinding::lifted:
            return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "not blind"));
    }
    return {};
}

QString rating_spread_text(const ObserverForm& form, const std::vector<FormAnswers>& answers) {
    if (answers.size() < 2) return {};
    int widest = -1, low = 0, high = 0, shared = 0;
    std::size_t where = 0;
    for (std::size_t i = 0; i < form.items.size(); ++i) {
        std::vector<int> given;
        for (const FormAnswers& one : answers)
            if (one[i]) given.push_back(*one[i]);
        if (given.size() < 2) continue;
        ++shared;
        const auto [least, most] = std::minmax_element(given.begin(), given.end());
        if (*most - *least <= widest) continue;
        widest = *most - *least;
        low = *least;
        high = *most;
        where = i;
    }
    if (shared == 0) return {};
    if (widest == 0)
        return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "The raters gave the same ratings."));
    return rating_say(
               QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "The raters differ most in \"%1\": %2 to %3."))
        .arg(form_text(form.items[where].title), QString::number(low), QString::number(high));
}

QString rater_agreement_text(const database::FormAgreement& agreement) {
    const QString form = form_text(agreement.title);
    if (agreement.attempts < 2)
        return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings",
                                            "Agreement of raters with %1: not known yet. It takes two "
                                            "attempts that the same two people rated."))
            .arg(form);
    if (!agreement.icc)
        return rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings",
                                            "Agreement of raters with %1: cannot be computed, because all "
                                            "their ratings are equal."))
            .arg(form);
    const QString low = level_word(agreement.icc->low), high = level_word(agreement.icc->high);
    const QString level =
        low == high ? low : rating_say(QT_TRANSLATE_NOOP("fulcrum::ui::ratings", "%1 to %2")).arg(low, high);
    return rating_say(
               QT_TRANSLATE_NOOP("fulcrum::ui::ratings",
                                 "Agreement of raters with %1: %2. ICC(2,1) %3, 95 % interval %4 to %5 (%6 "
                                 "raters, %7 attempts)."))
        .arg(form, level, decimal(agreement.icc->value, 2), decimal(agreement.icc->low, 2),
             decimal(agreement.icc->high, 2), QString::number(agreement.raters),
             QString::number(agreement.attempts));
}

}  // namespace fulcrum::ui
