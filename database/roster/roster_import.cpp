// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/roster/roster_import.h"

#include <algorithm>
#include <map>

#include "database/records/people_rows.h"
#include "database/rows/csv_text.h"

namespace fulcrum::database {
namespace {

bool holds(const std::vector<Role>& roles, Role role) {
    return std::find(roles.begin(), roles.end(), role) != roles.end();
}

/// Ids of the people whom the cohort has, then of the added ones.
std::vector<std::string> with(std::vector<std::string> ids, const std::vector<std::string>& logins,
                              const std::map<std::string, Person>& people) {
    for (const std::string& login : logins) ids.push_back(people.at(login_key(login)).id);
    return ids;
}

std::map<std::string, Person> by_login(const People& people, const Session& session) {
    std::map<std::string, Person> found, by_id;
    const std::vector<Person> list = people.list(session);
    for (const Person& person : list) by_id.emplace(person.id, person);
    // A login that was merged stands for the person it belongs to.
    for (const Person& person : list) {
        const auto owner = by_id.find(person.merged_into);
        found.emplace(login_key(person.login), owner == by_id.end() ? person : owner->second);
    }
    return found;
}

}  // namespace

std::vector<PersonImport> RosterImport::plan_people(const Roster& roster) const {
    store_.require(session_, Operation::manage_people);
    const std::map<std::string, Person> known = by_login(People(store_), session_);
    std::vector<PersonImport> plan;
    for (const RosterPerson& person : roster.people) {
        PersonImport step;
        step.person = person;
        const auto found = known.find(login_key(person.login));
        if (found != known.end()) {
            const Person& there = found->second;
            step.person_id = there.id;
            for (const Role role : person.roles) {
                if (!holds(there.roles, role)) step.added.push_back(role);
            }
            step.what = step.added.empty() ? PersonImport::What::nothing : PersonImport::What::add_role;
            // create() moves a simulated person's login out of the way.
            if (there.kind != PersonKind::real) {
                step.what = PersonImport::What::create;
                step.added.clear();
                step.person_id.clear();
            } else if (!there.active) {
                step.what = PersonImport::What::refused;
                step.why = "is deactivated here";
            }
        }
        plan.push_back(std::move(step));
    }
    return plan;
}

void RosterImport::bring_people(std::vector<PersonImport>& plan,
                                const std::function<bool(std::size_t, std::size_t)>& progress) const {
    store_.require(session_, Operation::manage_people);
    const People people(store_);
    for (std::size_t i = 0; i < plan.size(); ++i) {
        if (!progress(i, plan.size())) return;
        PersonImport& step = plan[i];
        if (step.what == PersonImport::What::create) {
            People::Created created =
                people.create(session_, step.person.login, step.person.name, step.person.roles);
            step.person_id = created.person.id;
            step.one_time_password = std::move(created.one_time_password);
        } else if (step.what == PersonImport::What::add_role) {
            std::vector<Role> roles = people.find(session_, step.person_id).value().roles;
            roles.insert(roles.end(), step.added.begin(), step.added.end());
            people.set_roles(session_, step.person_id, roles);
        }
    }
    progress(plan.size(), plan.size());
}

std::vector<CohortImport> RosterImport::plan_cohorts(const Roster& roster) const {
    store_.require(session_, Operation::manage_cohorts);
    const People people(store_);
    const std::map<std::string, Person> known = by_login(people, session_);
    std::vector<CohortImport> plan;
    for (const RosterCohort& cohort : roster.cohorts) {
        CohortImport step;
        step.name = cohort.name;
        const std::optional<Cohort> there = people.find_cohort(session_, cohort.name);
        step.create = !there;
        const auto add = [&](const std::vector<std::string>& logins, const std::vector<std::string>& present,
                             std::optional<Role> needed, std::vector<std::string>& added) {
            for (const std::string& login : logins) {
                const auto found = known.find(login_key(login));
                if (found == known.end() || found->second.kind != PersonKind::real ||
                    (needed && !holds(found->second.roles, *needed))) {
                    step.missing.push_back(login);
                } else if (std::find(present.begin(), present.end(), found->second.id) == present.end()) {
                    added.push_back(found->second.login);
                }
            }
        };
        const Cohort now = there.value_or(Cohort{});
        add(cohort.members, now.members, {}, step.members);
        add(cohort.educators, now.educators, Role::educator, step.educators);
        plan.push_back(std::move(step));
    }
    return plan;
}

std::vector<CohortImport> RosterImport::bring_cohorts(const Roster& roster) const {
    const std::vector<CohortImport> steps = plan_cohorts(roster);
    const People people(store_);
    const std::map<std::string, Person> known = by_login(people, session_);
    for (const CohortImport& step : steps) {
        const std::string id = step.create ? people.create_cohort(session_, step.name)
                                           : people.find_cohort(session_, step.name).value().id;
        const Cohort now = people.find_cohort(session_, id).value();
        if (!step.members.empty()) people.set_members(session_, id, with(now.members, step.members, known));
        if (!step.educators.empty())
            people.set_educators(session_, id, with(now.educators, step.educators, known));
    }
    return steps;
}

void write_passwords(OutputFile& file, const std::vector<PersonImport>& steps) {
    file.write("login,name,one_time_password\n");
    for (const PersonImport& step : steps) {
        if (step.one_time_password.empty()) continue;
        file.write(csv_text(step.person.login) + ',' + csv_text(step.person.name) + ',' +
                   csv_text(step.one_time_password) + '\n');
    }
    file.commit();
}

}  // namespace fulcrum::database
