// SPDX-License-Identifier: GPL-3.0-or-later
// When the host of a virtual machine took its processors: the kernel's steal time. A thread's processor time
// can contain a part of it, so that a late tick looks like the program's own doing.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace fulcrum::app::program_test {

/// Reads it a hundred times a second while it exists.
class HostWitness {
  public:
    using Clock = std::chrono::steady_clock;
    HostWitness() : thread_([this] { watch(); }) {}
    ~HostWitness() {
        stop_.store(true);
        thread_.join();
    }
    HostWitness(const HostWitness&) = delete;
    HostWitness& operator=(const HostWitness&) = delete;
    /// s of all processors between two moments, to 10 ms; each begins and ends up to `reach` later.
    double taken(Clock::time_point from, Clock::time_point to) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        double sum = 0;
        for (const Taken& one : taken_)
            if (one.at >= from - reach && one.at <= to + reach) sum += one.seconds;
        return sum;
    }
    double taken() const { return taken(Clock::time_point::min() + reach, Clock::time_point::max() - reach); }

  private:
    static constexpr auto reach = std::chrono::milliseconds(50);
    struct Taken {
        Clock::time_point at;
        double seconds;
    };
    /// Hundredths of a second: user, nice, system, idle, iowait, irq, softirq, steal.
    static std::int64_t steal() {
        std::ifstream file("/proc/stat");
        std::string name;
        std::int64_t value = 0;
        file >> name;
        for (int column = 0; column < 8; ++column) file >> value;
        return file ? value : 0;
    }
    void watch() {
        std::int64_t before = steal();
        while (!stop_.load()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            const std::int64_t now = steal();
            if (now == before) continue;
            const std::lock_guard<std::mutex> lock(mutex_);
            taken_.push_back({Clock::now(), 0.01 * static_cast<double>(now - before)});
            before = now;
        }
    }
    mutable std::mutex mutex_;
    std::vector<Taken> taken_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace fulcrum::app::program_test
