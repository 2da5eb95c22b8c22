// SPDX-License-Identifier: Apache-2.0
// A WebSocket to a server of this computer (127.0.0.1) and to no other, by libwebsockets. One thread.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

namespace fulcrum::haply {

/// 0 where something listens at this port of this computer, else the error number of the system.
int probe(int port) noexcept;

class WebSocket {
  public:
    enum class State {
        connecting,
        open,
        not_a_web_socket,  ///< what listens there does not speak this protocol
        closed             ///< by the other side, by a fault of it, or because a message was too long
    };
    /// Begins to connect. Throws WordedError where the library does not start.
    explicit WebSocket(int port);
    ~WebSocket();
    WebSocket(const WebSocket&) = delete;
    WebSocket& operator=(const WebSocket&) = delete;

    State state() const { return state_; }
    /// Reads and writes what is ready; waits for it for at most `wait` ns.
    void serve(std::int64_t wait);
    /// The oldest message that has arrived whole; false where there is none.
    bool take(std::string& text);
    /// Replaces a message that has not been sent yet.
    void send(const std::string& text);

  private:
    struct Library;
    int answer(int reason, void* in, std::size_t size);
    std::unique_ptr<Library> library_;
    State state_ = State::connecting;
    std::string arriving_, leaving_;
    std::deque<std::string> arrived_;
    bool sends_ = false;
};

}  // namespace fulcrum::haply
