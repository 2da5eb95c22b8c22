// SPDX-License-Identifier: Apache-2.0
#include "sim_core/igtl/server.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::igtl {
namespace {

constexpr int most_waiting = 8;

/// A listening socket, or -1 with `why`.
int listen_at(const addrinfo& at, int& why) {
    const int made = ::socket(at.ai_family, at.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, at.ai_protocol);
    if (made < 0) {
        why = errno;
        return -1;
    }
    const int on = 1;
    setsockopt(made, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (bind(made, at.ai_addr, at.ai_addrlen) == 0 && listen(made, most_waiting) == 0) return made;
    why = errno;
    close(made);
    return -1;
}

int port_of(int socket) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
    if (address.ss_family == AF_INET6) return ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port);
    return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

}  // namespace

Server::Server(const Address& address) {
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    wanted.ai_flags = AI_NUMERICSERV | AI_PASSIVE;
    addrinfo* found = nullptr;
    int why = EADDRNOTAVAIL;
    if (getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &wanted, &found) == 0) {
        for (const addrinfo* one = found; one != nullptr && listening_ < 0; one = one->ai_next)
            listening_ = listen_at(*one, why);
        freeaddrinfo(found);
    }
    if (listening_ < 0)
        throw InputError(
            address.text(), "", {QT_TRANSLATE_NOOP("errors", "cannot be served: %1"), std::strerror(why)},
            QT_TRANSLATE_NOOP("errors",
                              "end the other program that uses this port (3D Slicer and PLUS use 18944 as "
                              "well), or choose another port or an address of this computer"));
    port_ = port_of(listening_);
}

Server::~Server() {
    for (const Client& client : clients_) close(client.socket);
    close(listening_);
}

void Server::put(Client& client, const Bytes& bytes) {
    if (client.queue.size() - client.sent + bytes.size() > longest_queue) {
        client.gone = true;
        return;
    }
    if (client.sent > 0 && client.sent >= client.queue.size() / 2) {
        client.queue.erase(client.queue.begin(),
                           client.queue.begin() + static_cast<std::ptrdiff_t>(client.sent));
        client.sent = 0;
    }
    client.queue.insert(client.queue.end(), bytes.begin(), bytes.end());
}

void Server::send(const ServedFrame& frame, std::int64_t now) {
    for (Client& client : clients_) {
        if (!client.wants_tdata) {
            put(client, frame.transforms);
        } else if (now - client.last_tdata >= client.resolution) {
            put(client, frame.tdata);
            client.last_tdata = now;
        }
        put(client, frame.others);
        write(client);
    }
    remove_gone();
}

void Server::send(const Bytes& bytes) {
    for (Client& client : clients_) {
        put(client, bytes);
        write(client);
    }
    remove_gone();
}

std::size_t Server::backlog() const {
    std::size_t most = 0;
    for (const Client& client : clients_) most = std::max(most, client.queue.size() - client.sent);
    return most;
}

void Server::drop_behind(std::size_t bytes) {
    for (Client& client : clients_) client.gone = client.gone || client.queue.size() - client.sent > bytes;
    remove_gone();
}

void Server::step(int wait_ms) {
    std::array<pollfd, most_clients + 1> waits{};
    waits[0] = {listening_, POLLIN, 0};
    const std::size_t count = clients_.size();
    for (std::size_t i = 0; i < count; ++i) {
        const bool behind = clients_[i].sent < clients_[i].queue.size();
        waits[i + 1] = {clients_[i].socket, static_cast<short>(behind ? POLLIN | POLLOUT : POLLIN), 0};
    }
    if (poll(waits.data(), count + 1, wait_ms) <= 0) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (waits[i + 1].revents == 0) continue;
        read(clients_[i]);
        write(clients_[i]);
    }
    if (waits[0].revents != 0) accept_all();
    remove_gone();
}

void Server::accept_all() {
    for (;;) {
        const int socket = accept4(listening_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (socket < 0) return;
        if (clients_.size() >= most_clients) {
            close(socket);
            continue;
        }
        const int on = 1;
        setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        clients_.emplace_back();
        clients_.back().socket = socket;
        put(clients_.back(), greeting_);
        write(clients_.back());
    }
}

void Server::read(Client& client) {
    if (client.gone) return;
    std::uint8_t* const space = client.decoder.space();
    const ssize_t got = recv(client.socket, space, client.decoder.room(), MSG_DONTWAIT);
    if (got == 0 || (got < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) {
        close(client.socket);
        client.socket = -1;
        client.gone = true;
        return;
    }
    if (got > 0) client.decoder.take(static_cast<std::size_t>(got));
    Message message;
    for (auto found = client.decoder.next(message); found != Decoder::Found::nothing;
         found = client.decoder.next(message)) {
        client.gone = client.gone || found == Decoder::Found::broken;
        if (found == Decoder::Found::broken) return;
        if (found != Decoder::Found::message) continue;
        // 3D Slicer sends a STATUS of version 2 when it connects; it and the rest are no concern of ours.
        StartTracking start;
        if (message.type == "STT_TDATA" && read_start_tracking(message.content, start)) {
            client.wants_tdata = true;
            client.resolution = std::max<std::int32_t>(start.resolution_ms, 0);
        } else if (message.type == "STP_TDATA") {
            client.wants_tdata = false;
        }
    }
}

void Server::write(Client& client) {
    while (!client.gone && client.sent < client.queue.size()) {
        const ssize_t took = ::send(client.socket, client.queue.data() + client.sent,
                                    client.queue.size() - client.sent, MSG_DONTWAIT | MSG_NOSIGNAL);
        if (took < 0 && errno == EINTR) continue;
        if (took < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
        if (took <= 0) {
            close(client.socket);
            client.socket = -1;
            client.gone = true;
            return;
        }
        client.sent += static_cast<std::size_t>(took);
    }
    if (client.sent == client.queue.size()) {
        client.queue.clear();
        client.sent = 0;
    }
}

void Server::remove_gone() {
    for (auto client = clients_.begin(); client != clients_.end();) {
        if (!client->gone) {
            ++client;
            continue;
        }
        if (client->socket >= 0) {
            ++dropped_;  // one that left by itself has no socket any more
            close(client->socket);
        }
        client = clients_.erase(client);
    }
}

}  // namespace fulcrum::igtl
