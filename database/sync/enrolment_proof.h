// SPDX-License-Identifier: GPL-3.0-or-later
// How a station proves to a programme server that it holds its signing key: it signs a statement that names
// the server, the token, itself, its key and its account's password, and the server verifies that before it
// makes the account. A statement is of use nowhere else: another server or token has another text, and
// whoever repeats it does not know the password.
#pragma once

#include <string>
#include <vector>

#include "database/rows/crypto.h"
#include "database/rows/errors.h"

namespace fulcrum::database {

class Connection;

/// What is signed. `verifier`: of the account's password (scram_verifier()). The function enrol_station() of
/// the server makes the same text.
std::string enrolment_statement(const std::string& server_id, const std::string& token_id,
                                const std::string& station_id, const Bytes& public_half,
                                const std::string& verifier);

/// Whether the server asks for it: one that was made by an older program does not until `server create`.
bool server_asks_for_proof(Connection& server);

/// The SQL function ed25519_holds(public half, message, signature): RFC 8032, and as libsodium it refuses a
/// key of small order and a number that is not below the order of the group. PostgreSQL has no such function
/// of its own; about 30 ms a call. It sees public data only.
const char* signature_function();

/// Of one enrolment as the server keeps it.
enum class Proof {
    not_asked,  ///< enrolled when the server did not ask
    holds,
    broken,  ///< the statement is not of this enrolment, or not signed by its key
};
struct KeptProof {
    std::string token_id, station_id, statement;
    Bytes public_half, signature;
};
Proof look_at_proof(const std::string& server_id, const KeptProof& kept);

/// What `server check` says of stations that have not proved it. `notes`: those that were never asked.
void check_proofs(Connection& server, std::vector<Sentence>& problems, std::vector<Sentence>& notes);

}  // namespace fulcrum::database
