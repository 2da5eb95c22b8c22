// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of a completed stage on paper, with its check code.
#pragma once

#include <string>
#include <vector>

#include "assessment/task/task.h"
#include "database/records/certificates.h"

namespace fulcrum::ui {

/// Checked as export_person. Throws AccessDenied, StoreError where the file cannot be written.
void write_certificate(const database::Store& store, const database::Session& session,
                       const database::Certificate& certificate, const std::vector<TaskDefinition>& tasks,
                       const std::string& program_version, const std::string& path);

}  // namespace fulcrum::ui
