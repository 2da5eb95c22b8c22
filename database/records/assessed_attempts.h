// SPDX-License-Identifier: GPL-3.0-or-later
// Who may begin an assessed attempt at a task with a class of device, as the curriculum that the person
// follows has it. The window and the command line ask the same.
#pragma once

#include <string>

#include "assessment/curriculum/curriculum.h"
#include "database/store/store.h"

namespace fulcrum::database {

/// Whether the person holds a role that puts benchmark sets in force, whatever the role of this session.
bool builds_limits(const Session& session);

/// Throws InputError where the task is practice only with this class of device, or the person's version of
/// the curriculum does not count it; StoreError where that version is not installed. Whether the curriculum
/// counts the class is not asked of anyone who builds limits: a set for it is built of such attempts before
/// it can be counted. Nor of a trace of another program. The standing leaves both out. `newest`: as for
/// Curricula. Checked as read_progress.
void require_assessed(const Store& store, const Session& session, const std::string& person_id,
                      const Curriculum& newest, const TaskDefinition& task, DeviceClass used);

}  // namespace fulcrum::database
