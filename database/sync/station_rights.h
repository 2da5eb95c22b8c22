// SPDX-License-Identifier: GPL-3.0-or-later
// Stations that were enrolled: the server's tables and functions for that, and which rows a station's account
// sees. Internal to this room.
#pragma once

#include "database/rows/connection.h"

namespace fulcrum::database {

/// Makes the tables where they are missing. Within the transaction that makes or upgrades a server.
void make_enrolment_tables(Connection& server);
/// Functions and policies, after those of set_server_rights().
void set_station_rights(Connection& server);

/// Tables of the server's own, of which stations and people see nothing but what functions answer.
inline constexpr const char* enrolment_tables[] = {"enrolment", "enrolment_cohort", "station_unit",
                                                   "station_shown", "server_log"};

}  // namespace fulcrum::database
