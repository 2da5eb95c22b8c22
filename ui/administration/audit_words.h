// SPDX-License-Identifier: GPL-3.0-or-later
// The store's names of audited operations, in words for screens. The store and exports keep the names.
#pragma once

#include <QString>
#include <string>

namespace fulcrum::ui {

/// "attempt.finish" as "Attempt finished"; a name that is not in the table stays as it is.
QString audit_operation_text(const std::string& operation);
/// The operations that begin with this word, "attempt" for attempt.finish and others: "Attempts, all".
QString audit_group_text(const std::string& group);

}  // namespace fulcrum::ui
