// SPDX-License-Identifier: GPL-3.0-or-later
// The metrics of an attempt against those of what was recorded of it over OpenIGTLink (docs/FORMATS.md).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "assessment/metrics/registry.h"

namespace fulcrum::test {

/// Why a value is absent; empty where there is one.
inline std::string absence_of(const nlohmann::json& row) {
    return row["value"].is_null() ? row["absent_code"]["id"].get<std::string>() : std::string();
}

struct Recorded {
    bool events = false;
    double rate = 0;  ///< Hz
    /// How far values may be apart: the larger of a share of the value and a multiple of what is worth
    /// showing.
    double share = 0, precisions = 0;
    /// Metrics that can be measured of it as of the attempt; others are neither compared nor asked for.
    std::function<bool(const MetricDescriptor&)> comparable = [](const MetricDescriptor&) { return true; };
};

/// Metrics, by id.
struct Compared {
    std::set<std::string> equal, absent;
    int values = 0;
};

/// Every value of the attempt is in the recording, but for those that it cannot have: each with that reason.
inline Compared compare_metrics(const nlohmann::json& attempt, const nlohmann::json& read,
                                const Recorded& recorded) {
    Compared compared;
    for (const nlohmann::json& one : attempt) {
        const std::string what = one["id"].dump() + one["hand"].dump() + one["tissue"].dump();
        const MetricDescriptor* const metric = find_metric(one["id"].get<std::string>());
        if (metric == nullptr) {
            ADD_FAILURE() << what;
            continue;
        }
        const auto same = std::find_if(read.begin(), read.end(), [&](const nlohmann::json& other) {
            return other["id"] == one["id"] && other["hand"] == one["hand"] &&
                   other["tissue"] == one["tissue"];
        });
        if (same == read.end()) {
            ADD_FAILURE() << what << " has no row";
            continue;
        }
        if (one["value"].is_null() || !recorded.comparable(*metric)) continue;
        const std::string reason = metric->needs_events && !recorded.events       ? "metric.no_events"
                                   : recorded.rate < metric->minimum_rate * 0.999 ? "metric.low_rate"
                                                                                  : "";
        EXPECT_EQ(absence_of(*same), reason) << what;
        if ((*same)["value"].is_null()) {
            compared.absent.insert(metric->id);
            continue;
        }
        const double a = one["value"].get<double>(), b = (*same)["value"].get<double>();
        EXPECT_LE(std::abs(a - b),
                  std::max(recorded.share * std::abs(a), recorded.precisions * metric->precision))
            << what << ": " << a << " in the attempt, " << b << " in the recording";
        compared.equal.insert(metric->id);
        ++compared.values;
    }
    return compared;
}

}  // namespace fulcrum::test
