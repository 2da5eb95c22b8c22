// SPDX-License-Identifier: Apache-2.0
// Names of a metric's enums in files and in the store.
#pragma once

#include "assessment/metrics/metric.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum {

inline constexpr NameRow<Direction> metric_directions[] = {
    {Direction::lower, "lower", QT_TRANSLATE_NOOP("fulcrum::metric_names", "lower is better")},
    {Direction::higher, "higher", QT_TRANSLATE_NOOP("fulcrum::metric_names", "higher is better")},
    {Direction::context, "context", QT_TRANSLATE_NOOP("fulcrum::metric_names", "for information only")}};
static_assert(in_order(metric_directions));

inline constexpr NameRow<Absence> metric_absences[] = {{Absence::none, "none", ""},
                                                       {Absence::not_done, "not_done", ""},
                                                       {Absence::not_measured, "not_measured", ""}};
static_assert(in_order(metric_absences));

}  // namespace fulcrum
