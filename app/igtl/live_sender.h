// SPDX-License-Identifier: GPL-3.0-or-later
// Sends a running attempt over OpenIGTLink, its newest sample 60 times a second and every event, from a
// thread of its own: neither the haptic thread nor the window waits for it or for a client.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "app/igtl/wire_frame.h"
#include "app/live/sample_tap.h"

namespace fulcrum::app {

class LiveSender {
  public:
    /// Listens from now on. Throws InputError with what is wrong and what to do.
    explicit LiveSender(const igtl::Address& address);
    ~LiveSender();
    LiveSender(const LiveSender&) = delete;
    LiveSender& operator=(const LiveSender&) = delete;

    /// The next attempt: what is returned goes into its LiveRequest. Its seed is sent when it is over, since
    /// it says where targets will be.
    std::shared_ptr<SampleTap> begin(const Scene& scene, std::uint64_t seed);

    int port() const { return port_; }
    std::size_t clients() const { return clients_.load(std::memory_order_relaxed); }
    /// Clients that were dropped because they were too slow or sent something else.
    std::size_t dropped() const { return dropped_.load(std::memory_order_relaxed); }

  private:
    struct Attempt {
        std::shared_ptr<SampleTap> tap;
        WireScene scene;
        std::uint64_t seed = 0;
        double tick_period = 1e-3;
    };
    class Pass;
    void run();

    igtl::Server server_;
    int port_;
    std::mutex mutex_;  // guards next_
    std::shared_ptr<const Attempt> next_;
    std::atomic<bool> stop_{false};
    std::atomic<std::size_t> clients_{0}, dropped_{0};
    std::thread thread_;
};

/// ns since 1970.
std::int64_t wall_clock_ns();

}  // namespace fulcrum::app
