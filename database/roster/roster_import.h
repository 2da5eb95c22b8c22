// SPDX-License-Identifier: GPL-3.0-or-later
// Brings a roster into the store: accounts by an administrator, cohorts by a director. Whoever is there
// already keeps name, password and cohorts; an import adds and removes nobody, so it can be repeated and, cut
// off in the middle, be begun again.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "database/records/people.h"
#include "database/roster/roster.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {

struct PersonImport {
    enum class What { create, add_role, nothing, refused };
    What what = What::create;
    RosterPerson person;
    std::string person_id;          ///< of one who is there, or was created
    std::vector<Role> added;        ///< roles that a person who is there gets
    std::string why;                ///< of a refusal
    std::string one_time_password;  ///< of one who was created; shown once
};

struct CohortImport {
    std::string name;
    bool create = false;
    std::vector<std::string> members, educators;  ///< logins that are added
    std::vector<std::string> missing;             ///< logins that are nobody's here, or lack the role
};

class RosterImport {
  public:
    RosterImport(const Store& store, const Session& session) : store_(store), session_(session) {}

    /// What an import would do; changes nothing. Refused are logins of simulated people and of people who
    /// cannot sign in.
    std::vector<PersonImport> plan_people(const Roster& roster) const;
    /// Does what the plan says and fills it in, a person at a time; about 0.1 s each who is created.
    /// `progress` is given how many are done and answers false to stop. After a stop or an error the plan
    /// says what was done: who was created has an id and a password.
    void bring_people(std::vector<PersonImport>& plan,
                      const std::function<bool(std::size_t, std::size_t)>& progress) const;

    std::vector<CohortImport> plan_cohorts(const Roster& roster) const;
    std::vector<CohortImport> bring_cohorts(const Roster& roster) const;

  private:
    const Store& store_;
    const Session& session_;
};

/// login, name, one_time_password of those who were created, as CSV; then the file has its name. Throws
/// std::system_error.
void write_passwords(OutputFile& file, const std::vector<PersonImport>& steps);

}  // namespace fulcrum::database
