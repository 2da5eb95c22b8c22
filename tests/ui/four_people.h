// SPDX-License-Identifier: GPL-3.0-or-later
// The people of a small programme: Alma (administrator), Tara (trainee), Ed (educator), Dora (director), and
// the cohort Spring with Tara and Ed.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "database/records/people.h"

namespace fulcrum::ui::window_test {

inline std::map<database::Role, database::Session> make_four_people(
    const database::Store& store, const std::string& programme = "Surgery") {
    using database::Role;
    const database::People people(store);
    std::map<Role, database::Session> sessions;
    const database::Session alma =
        people.create_programme(programme, "alma", "Alma Admin", "correct horse").administrator;
    sessions.emplace(Role::administrator, alma);
    for (const auto& [role, login, name] :
         {std::tuple{Role::trainee, "tara", "Tara Trainee"}, std::tuple{Role::educator, "ed", "Ed Educator"},
          std::tuple{Role::director, "dora", "Dora Director"}}) {
        const auto made = people.create(alma, login, name, {role});
        const database::Session once = people.sign_in(login, made.one_time_password);
        sessions.emplace(role, people.change_password(once, made.one_time_password, "a long password"));
    }
    const database::Session& dora = sessions.at(Role::director);
    const std::string cohort = people.create_cohort(dora, "Spring");
    people.set_members(dora, cohort, {sessions.at(Role::trainee).person_id()});
    people.set_educators(dora, cohort, {sessions.at(Role::educator).person_id()});
    return sessions;
}

}  // namespace fulcrum::ui::window_test
