// SPDX-License-Identifier: Apache-2.0
// A connection to a server of OpenIGTLink.
#pragma once

#include <string>

#include "sim_core/igtl/message.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum::igtl {

struct Address {
    std::string host = "127.0.0.1";
    int port = standard_port;
    std::string text() const;
};
/// "HOST", ":PORT", "HOST:PORT" or "[HOST]:PORT"; empty: this computer at the standard port. Throws
/// InputError, in which `named` is where the text is from. Port 0 only for a server: one that is free.
Address parse_address(const std::string& text, const std::string& named, int least_port = 1);

/// Owns a socket that does not block.
class Connection {
  public:
    Connection() = default;
    /// Throws InputError with what is wrong and what to do; waits for at most `wait_ms`.
    Connection(const Address& address, int wait_ms);
    ~Connection();
    Connection(Connection&& other) noexcept { std::swap(socket_, other.socket_); }
    Connection& operator=(Connection&& other) noexcept {
        std::swap(socket_, other.socket_);
        return *this;
    }
    int socket() const { return socket_; }

    /// Reads what has arrived into the decoder, without waiting. False where the other side has closed the
    /// connection or it failed.
    bool read_into(Decoder& decoder) noexcept;
    /// Waits until something arrives.
    void wait(int ms) const noexcept;
    /// Sends all of it or nothing where the system takes no more. False for nothing.
    bool send(const Bytes& bytes) noexcept;

  private:
    int socket_ = -1;
};

}  // namespace fulcrum::igtl
