// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `db check` and `server check` that say which attempts are simulated again.
#pragma once

#include <limits>

#include "app/cli/command.h"
#include "app/live/simulation_check.h"

namespace fulcrum::app {

inline std::vector<Option> simulation_options() {
    return {{"--simulate", "N",
             QT_TRANSLATE_NOOP("commands",
                               "Simulate so many attempts again from their inputs, drawn by chance, however "
                               "long it takes; 0: none. Without it: 3, in 20 seconds.")},
            {"--seed", "N",
             QT_TRANSLATE_NOOP("commands", "Draw the attempts that a check with this seed has drawn.")}};
}

/// A number that is asked for is simulated however long it takes.
inline SimulationSample simulation_sample(const Arguments& arguments) {
    SimulationSample sample;
    sample.seed = arguments.has("--seed") ? static_cast<std::uint64_t>(arguments.integer(
                                                "--seed", 1, 0, std::numeric_limits<std::int64_t>::max()))
                                          : random_sample_seed();
    if (!arguments.has("--simulate")) return sample;
    sample.attempts = static_cast<int>(arguments.integer("--simulate", sample.attempts, 0, most_simulated));
    sample.most_s = 0;
    return sample;
}

}  // namespace fulcrum::app
