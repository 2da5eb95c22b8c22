// SPDX-License-Identifier: Apache-2.0
// The Inverse service of Haply, in a thread of the test: answers each command over a WebSocket, and what a
// test wants to be wrong.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "sim_core/numerics/types.h"

namespace fulcrum::test {

/// A server of WebSockets at 127.0.0.1, with one thread.
class WebSocketServer {
  public:
    /// `first`: what each client gets at once, nothing where it is empty; `answer`: to its message, likewise.
    /// Both are called in the server's thread. Port 0: one that is free.
    WebSocketServer(int port, std::function<std::string()> first,
                    std::function<std::string(const std::string&)> answer);
    ~WebSocketServer();
    WebSocketServer(const WebSocketServer&) = delete;
    WebSocketServer& operator=(const WebSocketServer&) = delete;
    int port() const { return port_; }
    int clients() const { return clients_; }
    /// Messages of a client that came before the answer to the one before had left.
    int early() const { return early_; }
    /// To every client.
    void say(const std::string& text);
    void hang_up() { hang_up_ = true; }

  private:
    struct Library;
    void run();
    std::function<std::string()> first_;
    std::function<std::string(const std::string&)> answer_;
    std::unique_ptr<Library> library_;
    int port_ = 0;
    std::atomic<int> clients_{0}, early_{0};
    std::atomic<bool> stop_{false}, hang_up_{false};
    std::mutex mutex_;
    std::vector<std::string> to_say_;
    std::thread thread_;
};

class FakeHaply {
  public:
    enum class Mode {
        good,
        silent,
        garbage,
        cut,            ///< JSON that ends in the middle
        nan,            ///< a number that JSON does not have
        null,           ///< no number
        far_away,       ///< a kilometre from the device
        no_device,      ///< an answer without the devices
        other_service,  ///< JSON of something else
        not_calibrated,
        no_power,
        slow,           ///< answers after 5 to 15 ms
        falling_behind  ///< after 5 ms, each 1 ms later than the one before, up to 40 ms
    };
    enum class Form { vector, values, refuses_vector };  ///< what it renders: version 3.5, 3.1, a strict 3.1
    struct Device {
        std::string id, handedness;
    };
    explicit FakeHaply(std::vector<Device> devices, int grips = 0, int port = 0);
    int port() const { return service_->port(); }
    /// "haply:PORT,events=PORT"
    std::string specification() const;

    void move(std::size_t device, const Vector3& position);  ///< m, the service's frame
    void turn(std::size_t grip, const Quaternion& orientation, bool a = false, bool b = false,
              bool c = false);
    Vector3 force(std::size_t device) const;  ///< N, of the newest command that it renders
    /// N, at the motors: a command counts for 20 ms, as the service's commands count for a tick of it.
    Vector3 rendered(std::size_t device) const;
    /// `reason`: in the data of the event, where there is one.
    void event(const std::string& name, const std::string& device, const std::string& reason = "") const;
    int early() const { return service_->early(); }
    int clients() const { return service_->clients(); }
    void hang_up() { service_->hang_up(); }
    std::atomic<Mode> mode{Mode::good};
    std::atomic<Form> form{Form::vector};
    std::atomic<std::uint64_t> commands{0};
    /// So many inventories yet report that another session uses the first device.
    std::atomic<int> inventories_in_use{0};
    std::atomic<int> inventories{0};  ///< sent

  private:
    std::string inventory();
    std::string answer(const std::string& command);
    std::string state() const;
    std::vector<Device> devices_;
    struct Grip {
        Quaternion orientation = Quaternion::Identity();
        bool button[3] = {false, false, false};
    };
    mutable std::mutex mutex_;
    void take_time();
    std::vector<Vector3> places_, forces_;
    std::int64_t commanded_ = 0;  // ns
    int answers_ = 0;             // since it was slow first
    std::vector<Grip> grips_;
    std::unique_ptr<WebSocketServer> service_, events_;
};

}  // namespace fulcrum::test
