// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/tradeoff.h"

namespace fulcrum::lab {

void mark_pareto(TradeoffStudy& study) {
    for (TradeoffLevel& level : study.levels) {
        level.pareto =
            std::none_of(study.levels.begin(), study.levels.end(), [&](const TradeoffLevel& other) {
                return other.error_unit == level.error_unit && other.error <= level.error &&
                       other.time_us <= level.time_us &&
                       (other.error < level.error || other.time_us < level.time_us);
            });
    }
}

}  // namespace fulcrum::lab
