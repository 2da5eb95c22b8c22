// SPDX-License-Identifier: GPL-3.0-or-later
// The roles of a programme server that a person's account can be a member of. The account has the person's id
// as its name. Internal to this floor.
#pragma once

#include <string>

#include "database/access/access.h"

namespace fulcrum::database {

/// Administrators look after accounts and stations, which a server has none of: no role of their own.
inline constexpr Role server_roles[] = {Role::trainee, Role::educator, Role::director};

/// "fulcrum_educator".
inline std::string server_group(Role role) {
    return std::string("fulcrum_") + role_name(role);
}

}  // namespace fulcrum::database
