// SPDX-License-Identifier: GPL-3.0-or-later
// People and cohorts as another system lists them: a folder or ZIP archive of OneRoster 1.1 or 1.2 CSV files
// (users, classes, enrollments, roles), or one CSV with the columns login, name, role and cohort. Reading
// asks no store. Source of the columns: 1EdTech OneRoster 1.2, CSV binding.
#pragma once

#include <string>
#include <vector>

#include "database/access/access.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum::database {

struct RosterPerson {
    std::string login, name;
    std::vector<Role> roles;  ///< trainee, educator or both; in this order
    std::string place;        ///< "users.csv:12", for messages
};

struct RosterCohort {
    std::string name;
    std::vector<std::string> members, educators;  ///< logins
    std::string place;
};

struct Roster {
    std::vector<RosterPerson> people;   ///< each login once, in the order of the file
    std::vector<RosterCohort> cohorts;  ///< each name once
    std::vector<Sentence> left_out;     ///< a sentence for each row that is not imported, with its place
};

/// A folder and a ZIP archive are read as OneRoster, another file as login, name, role, cohort. Throws
/// InputError with file and line: not readable as above, a login that the store would refuse or that is there
/// twice with two names, a role that is none, an id or a title of a class that is there twice. Rows of other
/// roles, rows marked to be deleted, people who are not enabled and enrollments of unknown people or classes
/// are left out, and `left_out` says so.
Roster read_roster(const std::string& path);

}  // namespace fulcrum::database
