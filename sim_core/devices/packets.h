// SPDX-License-Identifier: Apache-2.0
// The control socket between fulcrum-hapticd and the program: JSON packets of at most 64 KiB over a pair of
// connected Unix sockets, with descriptors where a packet carries some. Not for haptic threads.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum {

/// Two connected sockets that keep packets whole; closed on exec. Throws std::system_error.
void make_socket_pair(int (&ends)[2]);

/// False if the other side is gone or its buffer is full.
bool send_packet(int socket, const nlohmann::json& packet, const std::vector<int>& descriptors = {});

struct Packet {
    std::string text;  ///< JSON
    std::vector<int> descriptors;
    bool ended = false;  ///< the other side is gone
};
/// Waits at most `milliseconds`; nothing if none came. The caller closes the descriptors.
std::optional<Packet> receive_packet(int socket, int milliseconds);

}  // namespace fulcrum
