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
/// A name in a payload, "state_hash" as "hash of the state"; one that is not in the table stays as it is.
QString audit_member_text(const std::string& name);
/// A payload {"before":"yes","after":"no"} as "after: no; before: yes"; what is not an object stays as it is.
/// Names, roles, modes, states and why an attempt became practice are in the reader's words (the last in rows
/// of older programs in English); what a person wrote stays as it is.
QString audit_details_text(const std::string& operation, const std::string& payload);

}  // namespace fulcrum::ui
