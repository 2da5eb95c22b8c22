// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/curve_words.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString say(const char* source) {
    return QCoreApplication::translate("fulcrum::ui::learning_curve", source);
}

QString plateau_words(const CurveFit& fit, const std::string& unit) {
    if (!fit.plateau_low || !fit.plateau_high)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::learning_curve", "The curve has not levelled off yet."));
    return say(QT_TRANSLATE_NOOP("fulcrum::ui::learning_curve",
                                 "The curve levels off at %1 (95 % interval %2 to %3)."))
        .arg(figure_with_unit(fit.plateau, unit), figure(*fit.plateau_low), figure(*fit.plateau_high));
}

/// Of the nth completed attempt, as the chart numbers it: attempts that were not completed have numbers too.
/// Those that are still to come are taken to be completed.
int attempt_number(const std::vector<CurveValue>& values, int n) {
    const int known = static_cast<int>(values.size());
    return n <= known ? values[static_cast<std::size_t>(n - 1)].number : values.back().number + n - known;
}

/// The first of n attempts from `met` on, where the fit meets the limit, at which it does not meet it: of a
/// curve that gets worse. 0: none.
int first_missed(const CurveFit& fit, double limit, bool lower_is_better, int met, int n) {
    for (int x = met; x <= n; ++x)
        if (lower_is_better ? fit.at(x) > limit : fit.at(x) < limit) return x;
    return 0;
}

QString limit_words(const std::vector<CurveValue>& values, const std::vector<double>& measured,
                    const CurveFit& fit, double limit, bool lower_is_better, const std::string& unit) {
    const QString shown = figure_with_unit(limit, unit);
    const AttemptsToLimit met = attempts_to_limit(measured, fit, limit, lower_is_better);
    if (!met.attempts)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::learning_curve",
                                     "At this level it does not meet the limit of %1. Discuss with your "
                                     "educator what to change."))
            .arg(shown);
    const int attempt = attempt_number(values, *met.attempts), n = static_cast<int>(values.size());
    if (const int missed = first_missed(fit, limit, lower_is_better, *met.attempts, n))
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::learning_curve",
                                     "Since attempt %2 it no longer meets the limit of %1."))
            .arg(shown)
            .arg(attempt_number(values, missed));
    if (*met.attempts <= n)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::learning_curve",
                                     "It has met the limit of %1 since attempt %2."))
            .arg(shown)
            .arg(attempt);
    const int low = met.low ? attempt_number(values, *met.low) : attempt;
    const QString interval =
        met.high ? say(QT_TRANSLATE_NOOP("fulcrum::ui::learning_curve", "%1 to %2"))
                       .arg(low)
                       .arg(attempt_number(values, *met.high))
                 : say(QT_TRANSLATE_NOOP("fulcrum::ui::learning_curve", "%1 or later, or never")).arg(low);
    return say(QT_TRANSLATE_NOOP("fulcrum::ui::learning_curve",
                                 "It would meet the limit of %1 at attempt %2 (%3)."))
        .arg(shown)
        .arg(attempt)
        .arg(interval);
}

}  // namespace

LearningCurve learning_curve(const std::vector<CurveValue>& values, const std::optional<double>& limit,
                             bool lower_is_better, const std::string& unit,
                             const std::optional<double>& highest) {
    LearningCurve curve;
    if (values.empty()) return curve;
    std::vector<double> measured;
    for (const CurveValue& one : values) measured.push_back(one.value);
    const std::vector<CurveFit> fits = fit_curves(measured);
    if (fits.empty()) {
        curve.words = say(QT_TRANSLATE_NOOP("fulcrum::ui::learning_curve",
                                            "A learning curve is shown from %1 completed attempts on."))
                          .arg(fewest_attempts_of_a_curve);
        return curve;
    }
    CurveFit fit = best_curve(fits);
    for (std::size_t i = 0; i < values.size(); ++i)
        curve.line.emplace_back(values[i].number, fit.at(static_cast<double>(i + 1)));
    if (highest) {
        fit.plateau = std::min(fit.plateau, *highest);
        for (std::optional<double>* end : {&fit.plateau_low, &fit.plateau_high})
            if (*end) *end = std::min(**end, *highest);
    }
    if (fit.plateau_low && fit.plateau_high) {
        curve.plateau_low = fit.plateau_low;
        curve.plateau_high = fit.plateau_high;
    }
    curve.words = plateau_words(fit, unit);
    if (limit)
        curve.words +=
            QStringLiteral(" ") + limit_words(values, measured, fit, *limit, lower_is_better, unit);
    return curve;
}

}  // namespace fulcrum::ui
