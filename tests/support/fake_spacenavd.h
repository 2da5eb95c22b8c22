// SPDX-License-Identifier: Apache-2.0
// The daemon of a SpaceMouse, at a socket of the test.
#pragma once

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>

namespace fulcrum::test {

/// Takes one client at a time, in a thread of its own.
class FakeSpacenavd {
  public:
    FakeSpacenavd(const std::string& path, int protocol) : protocol_(protocol) {
        unlink(path.c_str());
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        path.copy(address.sun_path, sizeof address.sun_path - 1);
        listening_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        if (bind(listening_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
            listen(listening_, 4) != 0)
            throw std::runtime_error(path);
        thread_ = std::thread([this] { run(); });
    }
    ~FakeSpacenavd() {
        stop_ = true;
        thread_.join();
        hang_up();
        close(listening_);
    }
    FakeSpacenavd(const FakeSpacenavd&) = delete;
    FakeSpacenavd& operator=(const FakeSpacenavd&) = delete;

    bool connected() const { return client_ >= 0; }
    void hang_up() {
        const int client = client_.exchange(-1);
        if (client >= 0) close(client);
    }
    void send_bytes(const void* bytes, std::size_t size) const { send(client_, bytes, size, MSG_NOSIGNAL); }
    void send_event(std::int32_t kind, std::array<std::int32_t, 7> rest) const {
        std::int32_t event[8] = {kind};
        std::copy(rest.begin(), rest.end(), event + 1);
        send_bytes(event, sizeof event);
    }
    std::atomic<float> sensitivity{0};

  private:
    void run() {
        while (!stop_) {
            pollfd one{listening_, POLLIN, 0};
            if (poll(&one, 1, 10) <= 0) continue;
            const int client = accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
            std::int32_t greeting = 0;
            if (recv(client, &greeting, sizeof greeting, 0) == sizeof greeting && protocol_ == 1)
                send(client, &greeting, sizeof greeting, MSG_NOSIGNAL);
            if (protocol_ == 0) {
                float asked = 0;
                if (recv(client, &asked, sizeof asked, 0) == sizeof asked) sensitivity = asked;
            }
            client_ = client;
        }
    }
    int protocol_, listening_ = -1;
    std::atomic<int> client_{-1};
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace fulcrum::test
