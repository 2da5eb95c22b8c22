// SPDX-License-Identifier: GPL-3.0-or-later
// What the owner of a programme server does about its stations. Each call connects, works and ends. Any
// thread.
#pragma once

#include <string>
#include <vector>

#include "database/rows/errors.h"
#include "database/rows/server_address.h"
#include "database/store/store.h"
#include "database/sync/enrolment_proof.h"

namespace fulcrum::database {

class Connection;

struct TokenMade {
    std::string text;  ///< shown once; the server keeps nothing from which it could be made again
    std::string id;
    UtcMilliseconds until = 0;
    std::vector<std::string> cohorts;  ///< names
};
inline constexpr int shortest_token_h = 1, longest_token_h = 24 * 30, usual_token_h = 72;

/// A token for one station, which gets the people of these cohorts (names or ids); none: everybody. Accounts
/// of tokens that have ended are removed. Throws StoreError not_found (no such cohort), bad_value, read_only
/// (not the owner).
TokenMade make_enrolment_token(const ServerAddress& address, const std::string& name,
                               const std::vector<std::string>& cohorts, int hours);

struct EnrolledStation {
    enum class State { open, ended, enrolled, withdrawn };
    State state = State::open;
    std::string id, name, made_by, station_id, account;
    std::string key;                 ///< fingerprint of the key with which it was enrolled
    Proof proof = Proof::not_asked;  ///< that it held that key, as this program verifies it; of those used
    UtcMilliseconds made = 0, expires = 0, used = 0, withdrawn = 0;
    UtcMilliseconds last_row = 0;  ///< time of the newest row of its audit log on the server; 0: none
    std::vector<std::string> cohorts;
};
/// Tokens and the stations that used them, the newest first.
std::vector<EnrolledStation> enrolled_stations(const ServerAddress& address);

/// The token cannot be used any more; the station's account neither reads nor writes from then on. `id`: of
/// the token, or of a station. Throws StoreError not_found, read_only.
void withdraw_enrolment(const ServerAddress& address, const std::string& id);

/// What check_programme_server() says of stations whose log is not signed by the key that was enrolled, nor
/// by one that leads from it.
std::vector<Sentence> stations_with_other_keys(Connection& server);
/// And of people and cohorts that a station named without having been given them.
std::vector<Sentence> claims_that_were_refused(Connection& server);

}  // namespace fulcrum::database
