// SPDX-License-Identifier: GPL-3.0-or-later
// Checks and rows that sign-in, accounts and cohorts share. Internal to this floor.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "database/records/people.h"
#include "database/rows/connection.h"

namespace fulcrum::database {

/// Lower case of ASCII letters: how logins are compared.
std::string login_key(const std::string& login);
/// Each throws StoreError bad_value with what is wrong and what to do.
void require_login(const std::string& login);
/// As require_login(), and not in the space that is reserved for simulated people.
void require_persons_login(const std::string& login);
/// "synthetic-..." and "external-...": only the station makes these.
bool is_reserved_login(const std::string& login);
void require_name(const std::string& name, const char* what);
void require_password(const std::string& password);

std::vector<Role> roles_of(Connection& connection, const std::string& person_id);
/// Removes roles not named and adds those that are.
void write_roles(Connection& connection, const std::string& person_id, const std::vector<Role>& roles);
/// Returns the new id. StoreError conflict if the login is taken.
std::string insert_person(const Store& store, const std::string& login, const std::string& display_name,
                          PersonKind kind);
/// A simulated person who has this login gets one in the reserved space: nobody can keep a login from a
/// person by performing under it without signing in. Audited; inside the caller's transaction.
void make_room_for(const Store& store, const Session& actor, const std::string& login);
void write_verifier(const Store& store, const std::string& person_id, const std::string& verifier,
                    bool one_time);
/// Those who were merged into another person, with that person.
std::map<std::string, std::string> merged_people(Connection& connection);
/// True if no other active person is administrator.
bool is_last_administrator(Connection& connection, const std::string& person_id);
/// Throws not_found.
Person read_person(const Store& store, const std::string& person_id);
/// Throws conflict where the person is merged into another one.
void require_own_account(const Person& person);
/// Throws sealed_demo, or AccessDenied for anyone but the station of a demo store.
void require_open_demo(const Store& store, const Session& station);

}  // namespace fulcrum::database
