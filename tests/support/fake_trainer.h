// SPDX-License-Identifier: Apache-2.0
// A trainer on a serial port: a pseudo-terminal whose other end a thread of the test reads and writes, and
// whatever a test wants to be wrong with it.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <string>
#include <thread>

#include "sim_core/devices/device_page.h"
#include "sim_core/hapticd/trainer_line.h"
#include "tests/support/device_thread.h"
#include "tests/support/own_folder.h"

namespace fulcrum::test {

inline constexpr double trainer_length = 0.34;  ///< m from handle to tip

class FakeTrainer {
  public:
    enum class Mode {
        good,
        silent,    ///< it answers, and sends nothing
        deaf,      ///< it answers nothing either
        repeated,  ///< the same line again and again
        gaps,      ///< two of three lines are lost
        wrong_checksum,
        garbage,
        not_a_number,
        out_of_range,
        other_version
    };
    /// False on a machine that gives no pseudo-terminals: tests of trainers are left out there.
    static bool is_possible() {
        const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        char name[64] = {};
        const bool usable = terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0 &&
                            ptsname_r(terminal, name, sizeof name) == 0 && access(name, R_OK | W_OK) == 0;
        if (terminal >= 0) close(terminal);
        return usable;
    }
    /// `letters`: its parts, "LR".
    explicit FakeTrainer(std::string letters, double rate = 200)
        : letters_(std::move(letters)), period_ns_(static_cast<std::int64_t>(1e9 / rate)) {
        plug();
        thread_ = std::thread([this] { run(); });
    }
    ~FakeTrainer() {
        stop_ = true;
        thread_.join();
        unplug();
    }
    FakeTrainer(const FakeTrainer&) = delete;
    FakeTrainer& operator=(const FakeTrainer&) = delete;

    /// A link that stays where the port behind it changes, as those of udev do.
    std::string port() const { return (folder_.path() / "port").string(); }
    std::string specification() const { return "trainer:" + port(); }
    void plug() {
        const std::lock_guard<std::mutex> lock(mutex_);
        end_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        char name[64] = {};
        grantpt(end_);
        unlockpt(end_);
        ptsname_r(end_, name, sizeof name);
        unlink(port().c_str());
        if (symlink(name, port().c_str()) != 0) name[0] = 0;
        asked_ = false;
        received_.clear();
    }
    void unplug() {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (end_ >= 0) close(end_);
        end_ = -1;
        unlink(port().c_str());
    }
    /// The part of this letter; handle in the device frame, its pivot at the origin.
    void move(char letter, const Vector3& handle, double length = trainer_length) {
        const Vector3 to_the_tip = -handle.normalized();
        const long pitch = std::lround(1e6 * std::asin(to_the_tip.y()));
        const long yaw = std::lround(1e6 * std::atan2(to_the_tip.x(), -to_the_tip.z()));
        const long insertion = std::lround(1e6 * (length - handle.norm()));
        const std::lock_guard<std::mutex> lock(mutex_);
        Place& place = place_[letter == 'L' ? 0 : letter == 'R' ? 1 : 2];
        place.pitch = pitch;
        place.yaw = yaw;
        place.insertion = insertion;
    }
    /// rad about the shaft.
    void turn(char letter, double roll) {
        const std::lock_guard<std::mutex> lock(mutex_);
        place_[letter == 'L' ? 0 : letter == 'R' ? 1 : 2].roll = std::lround(1e6 * roll);
    }
    void hold(char letter, int jaw, int buttons) {
        const std::lock_guard<std::mutex> lock(mutex_);
        Place& place = place_[letter == 'L' ? 0 : letter == 'R' ? 1 : 2];
        place.jaw = jaw;
        place.buttons = buttons;
    }
    void send(const std::string& bytes) {
        const std::lock_guard<std::mutex> lock(mutex_);
        put(bytes);
    }
    /// The next line has the number after this one.
    void count_from(std::uint16_t sequence) {
        const std::lock_guard<std::mutex> lock(mutex_);
        sequence_ = sequence;
    }
    std::uint16_t counted() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return sequence_;
    }
    /// As after a press of its reset button: it counts from 0 and waits to be asked.
    void begin_again() {
        const std::lock_guard<std::mutex> lock(mutex_);
        asked_ = false;
        sequence_ = 0;
    }
    std::atomic<Mode> mode{Mode::good};
    std::atomic<char> hidden{0};  ///< this part is not sent
    std::atomic<int> asked_for{0};

  private:
    struct Place {
        long pitch = 0, yaw = 0, insertion = 100000, roll = 0;
        int jaw = 1000, buttons = 0;
    };
    void put(const std::string& bytes) {
        if (end_ >= 0 && write(end_, bytes.data(), bytes.size()) < 0) ++lost_;
    }
    void greet() {
        const Mode now = mode;
        ++asked_for;
        if (now == Mode::deaf) return;
        asked_ = true;
        if (now == Mode::garbage) return put("ATZ\r\nOK\r\nReady.\r\n");
        std::string line =
            hapticd::trainer_line((now == Mode::other_version ? "F2,H,Box," : "F1,H,Box,") +
                                  std::to_string(1000 * 1'000'000 / period_ns_) + "," + letters_);
        if (now == Mode::wrong_checksum) line[line.size() - 2] ^= 1;
        put(line);
    }
    std::string pose(char letter) {
        const Mode now = mode;
        const Place& place = place_[letter == 'L' ? 0 : letter == 'R' ? 1 : 2];
        std::string pitch = std::to_string(place.pitch);
        if (now == Mode::not_a_number) pitch = "nan";
        if (now == Mode::out_of_range) pitch = "1600000";
        std::string line = hapticd::trainer_line(
            "F1,P," + std::to_string(sequence_) + "," + std::to_string(sequence_ * 5000U) + "," + letter +
            "," + pitch + "," + std::to_string(place.yaw) + "," + std::to_string(place.insertion) + "," +
            std::to_string(place.roll) + "," + std::to_string(place.jaw) + "," +
            std::to_string(place.buttons));
        if (now == Mode::wrong_checksum) line[line.size() - 2] ^= 1;
        return now == Mode::garbage ? "!!!! rubbish ????\r\n" : line;
    }
    void step() {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (end_ < 0) return;
        char bytes[256];
        const ssize_t got = ::read(end_, bytes, sizeof bytes);
        if (got > 0) received_.append(bytes, static_cast<std::size_t>(got));
        const std::string question = hapticd::trainer_line("F1,?");
        for (std::size_t at; (at = received_.find(question)) != std::string::npos;) {
            received_.erase(0, at + question.size());
            greet();
        }
        const std::int64_t now = monotonic_ns();
        const Mode how = mode;
        if (!asked_ || now < due_ || how == Mode::silent || how == Mode::deaf || how == Mode::other_version)
            return;
        due_ = now + period_ns_;
        if (how != Mode::repeated) sequence_ = static_cast<std::uint16_t>(sequence_ + 1);
        if (how == Mode::gaps && sequence_ % 3 != 0) return;
        for (const char letter : letters_)
            if (letter != hidden) put(pose(letter));
    }
    void run() {
        work_as_a_device();
        while (!stop_) {
            step();
            usleep(500);
        }
    }
    std::string letters_;
    std::int64_t period_ns_;
    OwnFolder folder_;
    std::mutex mutex_;
    int end_ = -1, lost_ = 0;
    bool asked_ = false;
    std::string received_;
    Place place_[3];
    std::uint16_t sequence_ = 0;
    std::int64_t due_ = 0;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace fulcrum::test
