// SPDX-License-Identifier: Apache-2.0
#include "sim_core/igtl/connection.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::igtl {
namespace {

using Resolved = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Resolved resolve(const Address& address) {
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    wanted.ai_flags = AI_NUMERICSERV;
    addrinfo* found = nullptr;
    const int failed =
        getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &wanted, &found);
    if (failed != 0)
        throw InputError(address.text(), "",
                         {QT_TRANSLATE_NOOP("errors", "no computer of this name: %1"), gai_strerror(failed)},
                         QT_TRANSLATE_NOOP("errors", "check the name, or give the number of its address"));
    return {found, &freeaddrinfo};
}

/// 0, or what the system says.
int connect_within(int socket, const addrinfo& to, int wait_ms) {
    if (connect(socket, to.ai_addr, to.ai_addrlen) == 0) return 0;
    if (errno != EINPROGRESS) return errno;
    pollfd one{socket, POLLOUT, 0};
    if (poll(&one, 1, wait_ms) <= 0) return ETIMEDOUT;
    int failed = 0;
    socklen_t size = sizeof failed;
    getsockopt(socket, SOL_SOCKET, SO_ERROR, &failed, &size);
    return failed;
}

}  // namespace

std::string Address::text() const {
    const bool bare = host.find(':') == std::string::npos;
    return (bare ? host : "[" + host + "]") + ":" + std::to_string(port);
}

Address parse_address(const std::string& text, const std::string& named, int least_port) {
    Address address;
    std::string host = text, port;
    const std::size_t bracket = text.rfind(']'), colon = text.rfind(':');
    if (!text.empty() && text[0] == '[' && bracket != std::string::npos) {
        host = text.substr(1, bracket - 1);
        const std::string rest = text.substr(bracket + 1);
        if (!rest.empty()) port = rest[0] == ':' ? rest.substr(1) : "?";
    } else if (colon != std::string::npos) {
        host = text.substr(0, colon);
        port = text.substr(colon + 1);
    }
    if (!host.empty()) address.host = host;
    char* end = nullptr;
    const long number = port.empty() ? standard_port : std::strtol(port.c_str(), &end, 10);
    const bool is_port = number >= least_port && number <= 65535 &&
                         (port.empty() || (*end == '\0' && port[0] >= '0' && port[0] <= '9'));
    const char* const no_part = text.empty() || text[0] != '[' ? " \t\r\n:[]" : " \t\r\n[]";
    if (!is_port || address.host.find_first_of(no_part) != std::string::npos)
        throw InputError(named, "", {QT_TRANSLATE_NOOP("errors", "\"%1\" is not HOST:PORT"), text},
                         QT_TRANSLATE_NOOP("errors", "such as 127.0.0.1:18944 or [::1]:18944"));
    address.port = static_cast<int>(number);
    return address;
}

Connection::Connection(const Address& address, int wait_ms) {
    const Resolved found = resolve(address);
    int why = ECONNREFUSED;
    for (const addrinfo* one = found.get(); one != nullptr; one = one->ai_next) {
        const int made =
            ::socket(one->ai_family, one->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, one->ai_protocol);
        if (made < 0) {
            why = errno;
            continue;
        }
        why = connect_within(made, *one, wait_ms);
        if (why == 0) {
            const int on = 1;
            setsockopt(made, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
            socket_ = made;
            return;
        }
        close(made);
    }
    throw InputError(address.text(), "",
                     {QT_TRANSLATE_NOOP("errors", "no OpenIGTLink server answers: %1"), std::strerror(why)},
                     QT_TRANSLATE_NOOP("errors",
                                       "start the server (in PLUS, 3D Slicer or the tracker's own program), "
                                       "and check its address, its port and the firewall"));
}

Connection::~Connection() {
    if (socket_ >= 0) close(socket_);
}

bool Connection::read_into(Decoder& decoder) noexcept {
    std::uint8_t* const space = decoder.space();
    const std::size_t room = decoder.room();
    if (room == 0) return true;  // the stream is broken, or next() has to be called
    const ssize_t got = recv(socket_, space, room, MSG_DONTWAIT);
    if (got > 0) decoder.take(static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR));
}

void Connection::wait(int ms) const noexcept {
    pollfd one{socket_, POLLIN, 0};
    poll(&one, 1, ms);
}

bool Connection::send(const Bytes& bytes) noexcept {
    return ::send(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL) ==
           static_cast<ssize_t>(bytes.size());
}

}  // namespace fulcrum::igtl
