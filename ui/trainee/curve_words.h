// SPDX-License-Identifier: GPL-3.0-or-later
// The learning curve of one person in one metric: its points for the chart and what it says in words.
#pragma once

#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include "assessment/learning/learning_curve.h"

namespace fulcrum::ui {

/// A completed, scored attempt that has a value.
struct CurveValue {
    int number = 0;  ///< of the attempt, as the chart numbers it
    double value = 0;
};
struct LearningCurve {
    std::vector<std::pair<double, double>> line;  ///< attempt number, fitted value; empty below 8 attempts
    std::optional<double> plateau_low, plateau_high;
    QString words;  ///< one or two sentences; empty without values
};
/// `limit`: of the metric's gate; none without one. `unit`: as stored. `highest`: no value can be above, such
/// as 100 points; a plateau that is fitted above it is said to be there.
LearningCurve learning_curve(const std::vector<CurveValue>& values, const std::optional<double>& limit,
                             bool lower_is_better, const std::string& unit,
                             const std::optional<double>& highest = {});

}  // namespace fulcrum::ui
