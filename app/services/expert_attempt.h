// SPDX-License-Identifier: GPL-3.0-or-later
// An expert's attempt in the scene of a stored one, to compare it with.
#pragma once

#include <functional>
#include <optional>

#include "database/scoring/loaded_task.h"
#include "ui/services/application_services.h"

namespace fulcrum::app {

/// Makes the first counted attempt of the first synthetic expert, as `fulcrum benchmark build` draws it
/// (seed 1000), with the class of device that limits for `attempt` are made with. The newest one is kept
/// while the program runs. The function may run on any thread.
std::function<std::optional<ui::ExpertAttempt>(const ui::Progress&)> expert_maker(
    LoadedTask loaded, const database::AttemptMeta& attempt);

}  // namespace fulcrum::app
