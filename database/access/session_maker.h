// SPDX-License-Identifier: GPL-3.0-or-later
// The only door to a Session's fields; internal to this floor.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "database/access/access.h"

namespace fulcrum::database {

struct SessionMaker {
    static Session station(const std::string& station_id) {
        Session session;
        session.login_ = "station";
        session.display_name_ = "Station";
        session.station_id_ = station_id;
        return session;
    }
    static Session person(std::string person_id, std::string login, std::string display_name,
                          std::vector<Role> roles, Role role, std::string station_id,
                          bool must_change_password, bool demo) {
        Session session;
        session.person_id_ = std::move(person_id);
        session.login_ = std::move(login);
        session.display_name_ = std::move(display_name);
        session.roles_ = std::move(roles);
        session.role_ = role;
        session.station_id_ = std::move(station_id);
        session.must_change_password_ = must_change_password;
        session.demo_ = demo;
        return session;
    }
};

}  // namespace fulcrum::database
