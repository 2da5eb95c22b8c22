// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a stored value can be held against what is said of its metric today.
#pragma once

#include "assessment/metrics/registry.h"
#include "database/records/report_data.h"

namespace fulcrum::ui {

/// The score in force stays after an update of the program, which can change the definition of a metric:
/// limits and bounds are of the present one.
inline bool is_of_present_version(const database::MetricRow& row) {
    const MetricDescriptor* metric = find_metric(row.id);
    return metric == nullptr || metric->version == row.version;
}

}  // namespace fulcrum::ui
