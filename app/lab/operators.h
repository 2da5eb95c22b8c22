// SPDX-License-Identifier: GPL-3.0-or-later
// Synthetic experts, intermediates and novices at one task: how well each metric separates experts from
// novices, which gates stop whom, and whether every attempt replays bit for bit.
#pragma once

#include <string>
#include <vector>

#include "app/lab/measure.h"

namespace fulcrum::app {

/// First seed of the page; benchmark sets use 1000 to 1999.
inline constexpr int operators_first_seed = 2000;

/// `seeds` attempts a preset, on all cores; the first `replays` of each are replayed too. `identical` in the
/// document counts those that replay bit for bit, out of `replayed`. The first `retests` individuals of each
/// preset make a second attempt. Throws InputError for an unknown task.
Measured measure_operators(const std::string& task, int seeds, int replays, int retests);

/// How many of `seeds` attempts of each preset pass each task with each class of devices that it names.
/// Throws InputError for an unknown task.
Measured measure_passes(const std::vector<std::string>& tasks, int seeds);

/// The same for each variant of each task, with handles that move freely.
Measured measure_variant_passes(const std::vector<std::string>& tasks, int seeds);

}  // namespace fulcrum::app
