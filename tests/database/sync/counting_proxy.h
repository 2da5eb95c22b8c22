// SPDX-License-Identifier: GPL-3.0-or-later
// Between stations and the tests' PostgreSQL: counts the bytes of both directions and holds each message back
// for the time that a network would take.
#pragma once

#include <QTemporaryDir>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "database/rows/server_address.h"

namespace fulcrum::database::test {

class CountingProxy {
  public:
    /// `one_way`: how long a message is held back in each direction.
    CountingProxy(const ServerAddress& server, std::chrono::microseconds one_way);
    ~CountingProxy();
    CountingProxy(const CountingProxy&) = delete;
    CountingProxy& operator=(const CountingProxy&) = delete;

    /// Where stations connect.
    const ServerAddress& address() const { return address_; }
    std::int64_t bytes_to_server() const { return up_; }
    std::int64_t bytes_from_server() const { return down_; }

  private:
    void accept_all();
    void forward(int from, int to, std::atomic<std::int64_t>& count) const;

    QTemporaryDir folder_;
    ServerAddress address_;
    std::string server_socket_;
    std::chrono::microseconds one_way_;
    int listener_ = -1;
    std::atomic<std::int64_t> up_{0}, down_{0};
    std::mutex mutex_;
    std::vector<std::thread> connections_;
    std::thread acceptor_;
};

}  // namespace fulcrum::database::test
