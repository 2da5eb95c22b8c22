// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/sync/counting_proxy.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace fulcrum::database::test {
namespace {

constexpr const char* socket_name = "/.s.PGSQL.5432";

sockaddr_un socket_at(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path)
        throw std::system_error(ENAMETOOLONG, std::generic_category(), path);
    std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
    return address;
}

int new_socket() {
    const int made = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (made < 0) throw std::system_error(errno, std::generic_category(), "socket");
    return made;
}

}  // namespace

CountingProxy::CountingProxy(const ServerAddress& server, std::chrono::microseconds one_way)
    : address_(server), server_socket_(server.host + socket_name), one_way_(one_way) {
    address_.host = folder_.path().toStdString();
    const sockaddr_un here = socket_at(address_.host + socket_name);
    listener_ = new_socket();
    constexpr int waiting = 64;
    if (::bind(listener_, reinterpret_cast<const sockaddr*>(&here), sizeof here) != 0 ||
        ::listen(listener_, waiting) != 0)
        throw std::system_error(errno, std::generic_category(), here.sun_path);
    acceptor_ = std::thread([this] { accept_all(); });
}

CountingProxy::~CountingProxy() {
    ::shutdown(listener_, SHUT_RDWR);
    acceptor_.join();
    ::close(listener_);
    for (std::thread& one : connections_) one.join();
}

void CountingProxy::accept_all() {
    while (true) {
        const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        if (client < 0) return;
        connections_.emplace_back([this, client] {
            const int server = new_socket();
            const sockaddr_un there = socket_at(server_socket_);
            if (::connect(server, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0) {
                std::thread answers([&] { forward(server, client, down_); });
                forward(client, server, up_);
                answers.join();
            }
            ::close(client);
            ::close(server);
        });
    }
}

/// What has arrived by the time that the first of it would have is passed on together: a delay, not a limit
/// of the bytes in flight.
void CountingProxy::forward(int from, int to, std::atomic<std::int64_t>& count) const {
    std::vector<char> buffer(std::size_t{1} << 20U);
    while (true) {
        char first = 0;
        if (::recv(from, &first, 1, MSG_PEEK) <= 0) break;
        if (one_way_.count() > 0) std::this_thread::sleep_for(one_way_);
        const ssize_t length = ::recv(from, buffer.data(), buffer.size(), 0);
        if (length <= 0) break;
        count += length;
        for (ssize_t done = 0; done < length;) {
            const ssize_t sent =
                ::send(to, buffer.data() + done, static_cast<std::size_t>(length - done), MSG_NOSIGNAL);
            if (sent <= 0) break;
            done += sent;
        }
    }
    ::shutdown(to, SHUT_WR);
    ::shutdown(from, SHUT_RD);
}

}  // namespace fulcrum::database::test
