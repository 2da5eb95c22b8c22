// SPDX-License-Identifier: Apache-2.0
// The server of a tracker, in a thread of the test: sends poses of tools over OpenIGTLink, and what a test
// wants to be wrong.
#pragma once

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "sim_core/devices/device_page.h"
#include "sim_core/igtl/server.h"
#include "tests/support/device_thread.h"

namespace fulcrum::test {

class FakeTracker {
  public:
    enum class Mode {
        good,
        silent,
        not_a_number,
        not_a_rotation,
        wrong_checksum,
        garbage,
        tdata,
        position,
        image
    };

    /// `greeting`: what each client gets first.
    explicit FakeTracker(std::vector<std::string> tools, int port = 0, double rate = 100,
                         const igtl::Bytes& greeting = {})
        : tools_(std::move(tools)), poses_(tools_.size()), period_ns_(static_cast<std::int64_t>(1e9 / rate)) {
        server_ = std::make_unique<igtl::Server>(igtl::Address{"127.0.0.1", port});
        port_ = server_->port();
        server_->greet_with(greeting);
        thread_ = std::thread([this] { run(); });
    }
    ~FakeTracker() {
        stop_ = true;
        thread_.join();
    }
    FakeTracker(const FakeTracker&) = delete;
    FakeTracker& operator=(const FakeTracker&) = delete;

    int port() const { return port_; }
    std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
    void move(std::size_t tool, const igtl::Pose& pose) {
        const std::lock_guard<std::mutex> lock(mutex_);
        poses_.at(tool) = pose;
    }
    /// Another message that goes with every frame.
    void also_send(const igtl::Bytes& bytes) {
        const std::lock_guard<std::mutex> lock(mutex_);
        also_ = bytes;
    }
    std::atomic<Mode> mode{Mode::good};
    std::atomic<int> hidden{-1};  ///< this tool is not sent
    std::atomic<std::uint64_t> frames{0};

  private:
    void append(igtl::Bytes& out, std::size_t tool) {
        igtl::Transform transform = igtl::transform_of(poses_[tool]);
        if (mode == Mode::not_a_number) transform.values[10] = std::numeric_limits<float>::quiet_NaN();
        if (mode == Mode::not_a_rotation) transform.values[0] = transform.values[4] = transform.values[8] = 0;
        igtl::append_transform(out, tools_[tool], 0, transform, 2);
        if (mode == Mode::wrong_checksum) out.back() = static_cast<std::uint8_t>(out.back() ^ 1U);
    }
    igtl::Bytes frame() {
        const std::lock_guard<std::mutex> lock(mutex_);
        igtl::Bytes out = also_;
        if (mode == Mode::garbage) return igtl::Bytes(200, 'G');
        if (mode == Mode::image) {  // 200 kB that Fulcrum does not want
            igtl::Bytes image(200000, 7);
            igtl::append_message(out, {"IMAGE", "Video", 0, 1}, {image.data(), image.size()});
        }
        std::vector<igtl::Tracked> tracked;
        for (std::size_t i = 0; i < tools_.size(); ++i) {
            if (hidden == static_cast<int>(i)) continue;
            if (mode == Mode::tdata) {
                tracked.push_back({tools_[i], 2, igtl::transform_of(poses_[i])});
            } else if (mode == Mode::position) {
                igtl::Position position;
                const Quaternion q(poses_[i].rotation);
                for (int axis = 0; axis < 3; ++axis) {
                    const auto a = static_cast<std::size_t>(axis);
                    position.place[a] = static_cast<float>(1e3 * poses_[i].place[axis]);
                    position.quaternion[a] = static_cast<float>(q.coeffs()[axis]);
                }
                position.quaternion[3] = static_cast<float>(q.w());
                igtl::append_position(out, tools_[i], 0, position);
            } else {
                append(out, i);
            }
        }
        if (!tracked.empty()) igtl::append_tdata(out, "Tracker", 0, tracked.data(), tracked.size());
        return out;
    }
    void run() {
        work_as_a_device();
        std::int64_t due = monotonic_ns();
        while (!stop_) {
            const std::int64_t now = monotonic_ns();
            if (now < due) {
                server_->step(static_cast<int>((due - now) / 1'000'000) + 1);
                continue;
            }
            due = now + period_ns_;
            if (mode != Mode::silent) server_->send(frame());
            ++frames;
        }
    }

    std::vector<std::string> tools_;
    std::vector<igtl::Pose> poses_;
    igtl::Bytes also_;
    std::int64_t period_ns_;
    std::mutex mutex_;
    std::unique_ptr<igtl::Server> server_;
    int port_ = 0;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace fulcrum::test
