// SPDX-License-Identifier: Apache-2.0
// A server of OpenIGTLink: sends the same frames to every client. One thread uses it; nothing in it waits for
// a client: one that reads too slowly, or that sends what is not OpenIGTLink, is dropped.
#pragma once

#include <deque>

#include "sim_core/igtl/connection.h"
#include "sim_core/igtl/content.h"

namespace fulcrum::igtl {

inline constexpr std::size_t most_clients = 16;
inline constexpr std::size_t longest_queue = 1U << 20U;  ///< bytes that a client may be behind

/// What is sent at one moment, for both kinds of clients.
struct ServedFrame {
    Bytes transforms;  ///< for a client that has not asked for TDATA
    Bytes tdata;       ///< for one that has
    Bytes others;      ///< for both
};

class Server {
  public:
    /// Listens; port 0: one that is free. Throws InputError with what is wrong and what to do.
    explicit Server(const Address& address);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    int port() const { return port_; }
    std::size_t clients() const { return clients_.size(); }
    /// Clients that were dropped because they were too slow or sent something else.
    std::size_t dropped() const { return dropped_; }

    /// What each client gets first.
    void greet_with(Bytes bytes) { greeting_ = std::move(bytes); }
    /// Puts a frame into the queue of each client and sends what the system takes. `now`: ms of a clock that
    /// rises, for clients that want TDATA less often.
    void send(const ServedFrame& frame, std::int64_t now);
    void send(const Bytes& bytes);
    /// Takes new clients, reads what they ask for and sends what is queued; waits at most so long for
    /// something to do.
    void step(int wait_ms);
    /// Most bytes that a client is behind.
    std::size_t backlog() const;
    /// Drops the clients that are more than so many bytes behind.
    void drop_behind(std::size_t bytes);

  private:
    struct Client {
        int socket = -1;
        Decoder decoder;
        Bytes queue;
        std::size_t sent = 0;  // of the queue
        bool wants_tdata = false, gone = false;
        std::int64_t resolution = 0, last_tdata = 0;  // ms
    };
    void accept_all();
    void read(Client& client);
    void write(Client& client);
    static void put(Client& client, const Bytes& bytes);
    void remove_gone();

    int listening_ = -1, port_ = 0;
    std::deque<Client> clients_;
    std::size_t dropped_ = 0;
    Bytes greeting_;
};

}  // namespace fulcrum::igtl
