// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/stability.h"

namespace fulcrum::lab {

const char* name_of(StabilityOutcome outcome) {
    switch (outcome) {
        case StabilityOutcome::stable:
            return "stable";
        case StabilityOutcome::degraded:
            return "degraded";
        case StabilityOutcome::fault:
            return "fault";
    }
    return "fault";
}

}  // namespace fulcrum::lab
