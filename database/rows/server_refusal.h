// SPDX-License-Identifier: GPL-3.0-or-later
// Why a programme server does not let this program in. Qt gives only the words of libpq for it, which are in
// the language of the server (lc_messages) or of this program; the codes of the server are the same in all.
#pragma once

#include <chrono>
#include <string>

#include "database/rows/errors.h"
#include "database/rows/server_address.h"

namespace fulcrum::database {

/// A server that refuses does so soon. Where nobody answers for so long, it is not asked for the reason.
inline constexpr std::chrono::seconds refused_within(5);

/// Asks a server that has just refused this connection: a connection of libpq that gives the codes as well.
ServerRefusal refusal_of(const ServerAddress& server, const std::string& password);
/// From the message of such a connection, in any language: "...: FATAL:  28P01: ... LOCATION:  auth_failed,
/// auth.c:337".
ServerRefusal refusal_in(const std::string& message);

}  // namespace fulcrum::database
