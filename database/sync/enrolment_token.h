// SPDX-License-Identifier: GPL-3.0-or-later
// The token by which a station becomes one of a programme server: 40 characters that somebody can type. It
// names the server, itself and its end, and contains a secret; the last characters find mistakes of typing
// before anything is sent.
#pragma once

#include <string>

#include "database/store/store.h"

namespace fulcrum::database {

struct EnrolmentToken {
    std::string server;  ///< the first six digits of the server's id
    std::string id;      ///< ten hexadecimal digits: of the enrolment on the server
    UtcMilliseconds until = 0;
    std::string secret;  ///< hexadecimal

    static EnrolmentToken make(const std::string& server_id, UtcMilliseconds until);
    /// As it was typed: upper or lower case, with or without separators, O for 0 and I or L for 1. Throws
    /// StoreError bad_value.
    static EnrolmentToken parse(const std::string& typed);
    std::string text() const;

    /// The account that may do nothing but enrol, until the token ends.
    std::string account() const { return token_account_prefix + id; }
    /// The account that the station gets.
    std::string station_account() const { return station_account_prefix + id; }
    /// Of account().
    std::string password() const;
    /// What the server keeps of the secret.
    std::string proof() const;

    static constexpr const char *token_account_prefix = "enrol_", *station_account_prefix = "station_";
};

}  // namespace fulcrum::database
