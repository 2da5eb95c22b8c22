// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/server_refusal.h"

#include <libpq-fe.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <memory>

namespace fulcrum::database {
namespace {

struct Closing {
    void operator()(PGconn* connection) const { PQfinish(connection); }
};
using LibpqConnection = std::unique_ptr<PGconn, Closing>;

/// A parameter as libpq reads it; nothing where it is empty.
std::string libpq_parameter(const char* name, const std::string& value) {
    if (value.empty()) return {};
    std::string text = std::string(" ") + name + "='";
    for (const char c : value) {
        if (c == '\'' || c == '\\') text += '\\';
        text += c;
    }
    return text + '\'';
}

/// What Qt gives to libpq for the same connection.
std::string libpq_parameters(const ServerAddress& server, const std::string& password) {
    std::string text = server.options();
    std::replace(text.begin(), text.end(), ';', ' ');
    return text + libpq_parameter("host", server.host) + libpq_parameter("dbname", server.database) +
           libpq_parameter("user", server.user) + libpq_parameter("password", password) +
           libpq_parameter("port", server.port == 0 ? std::string() : std::to_string(server.port));
}

/// Until it is made or refused. False where nobody answers.
bool is_answered(PGconn* connection) {
    const auto end = std::chrono::steady_clock::now() + refused_within;
    PostgresPollingStatusType next = PGRES_POLLING_WRITING;
    while (next == PGRES_POLLING_READING || next == PGRES_POLLING_WRITING) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now())
                .count();
        pollfd waited{};
        waited.fd = PQsocket(connection);
        waited.events = static_cast<short>(next == PGRES_POLLING_READING ? POLLIN : POLLOUT);
        if (left <= 0 || waited.fd < 0) return false;
        const int ready = ::poll(&waited, 1, static_cast<int>(left));
        if (ready > 0)
            next = PQconnectPoll(connection);
        else if (ready == 0 || errno != EINTR)
            return false;
    }
    return true;
}

/// The SQLSTATE: libpq writes it after the word for how bad it is, with two spaces between them.
std::string state_in(const std::string& message) {
    constexpr std::size_t length = 5;
    const auto is_of_code = [](char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z'); };
    for (std::size_t at = message.find(":  "); at != std::string::npos; at = message.find(":  ", at + 1)) {
        const std::string state = message.substr(at + 3, length);
        if (state.size() == length && std::all_of(state.begin(), state.end(), is_of_code) &&
            message.compare(at + 3 + length, 2, ": ") == 0)
            return state;
    }
    return {};
}

}  // namespace

ServerRefusal refusal_of(const ServerAddress& server, const std::string& password) {
    const LibpqConnection connection(PQconnectStart(libpq_parameters(server, password).c_str()));
    if (connection == nullptr || PQstatus(connection.get()) == CONNECTION_BAD) return ServerRefusal::none;
    PQsetErrorVerbosity(connection.get(), PQERRORS_VERBOSE);
    if (!is_answered(connection.get())) return ServerRefusal::none;
    if (PQconnectionNeedsPassword(connection.get()) != 0) return ServerRefusal::password;
    return refusal_in(PQerrorMessage(connection.get()));
}

ServerRefusal refusal_in(const std::string& message) {
    const std::string state = state_in(message);
    if (state == "28P01") return ServerRefusal::password;
    if (state == "3D000") return ServerRefusal::database;
    // The same code has a server without a rule for this address (pg_hba.conf), from another function of it.
    if (state == "28000")
        return message.find(" InitializeSessionUserId, ") != std::string::npos ? ServerRefusal::account
                                                                               : ServerRefusal::rule;
    return ServerRefusal::none;
}

}  // namespace fulcrum::database
