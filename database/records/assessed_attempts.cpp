// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/assessed_attempts.h"

#include <algorithm>

#include "assessment/task/task.h"
#include "database/access/access.h"
#include "database/records/curricula.h"

namespace fulcrum::database {

bool builds_limits(const Session& session) {
    const std::vector<Role>& roles = session.roles();
    return std::any_of(roles.begin(), roles.end(),
                       [](Role role) { return scope_of(role, Operation::accept_assets) != Scope::none; });
}

void require_assessed(const Store& store, const Session& session, const std::string& person_id,
                      const Curriculum& newest, const TaskDefinition& task, DeviceClass used) {
    const Curricula curricula(store);
    curricula.require_here(session, person_id, newest);
    if (builds_limits(session) || used == DeviceClass::external)
        require_assessable(task, used);
    else
        require_counts(curricula.in_force(session, person_id, newest), task, used);
}

}  // namespace fulcrum::database
