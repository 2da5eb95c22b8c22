// SPDX-License-Identifier: GPL-3.0-or-later
// The force test of a device that fulcrum-hapticd drives: a gentle force along each axis of each hand in
// turn, which can be stopped at any time. A thread of its own gives the commands, because the daemon switches
// the force off where none comes for 20 ms.
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "sim_core/devices/daemon_client.h"

namespace fulcrum::app {

/// What is asked for at a time after the begin: up from 0 along an axis and back, a second for each axis.
struct GentleForce {
    int axis = 0;
    double size = 0;  ///< N
};
GentleForce gentle_force(double time, double peak);

class ForceTest {
  public:
    static constexpr double first_peak = 0.1, peak = 0.3;  ///< N, of the first and the second round

    /// Begins. `client` renders force to a hand.
    explicit ForceTest(std::shared_ptr<DaemonClient> client);
    /// Stops.
    ~ForceTest();
    ForceTest(const ForceTest&) = delete;
    ForceTest& operator=(const ForceTest&) = delete;
    /// The force is 0 when it returns, or 50 ms later at the latest where the daemon does not run.
    void stop();

    /// Called by the window while it works: without it for 2 s the test stops, since nobody could stop it.
    void keep() { kept_.store(monotonic_ns()); }
    bool runs() const { return runs_.load(); }
    int hand() const { return hand_.load(); }
    int axis() const { return axis_.load(); }
    double asked() const { return asked_.load(); }
    double largest_asked() const { return largest_asked_.load(); }
    double rendered() const { return rendered_.load(); }
    double progress() const { return progress_.load(); }

  private:
    void run() noexcept;
    bool command(int hand, const GentleForce& force) noexcept;
    std::shared_ptr<DaemonClient> client_;
    ForceCommand sent_[2];
    std::atomic<bool> stop_{false}, runs_{true};
    std::atomic<std::int64_t> kept_{monotonic_ns()};
    std::atomic<int> hand_{0}, axis_{0};
    std::atomic<double> asked_{0}, largest_asked_{0}, rendered_{0}, progress_{0};
    std::thread thread_;
};

}  // namespace fulcrum::app
