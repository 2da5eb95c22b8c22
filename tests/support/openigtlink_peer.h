// SPDX-License-Identifier: Apache-2.0
// tests/fakes/openigtlink_peer.cpp as a process of a test: a client or a server of OpenIGTLink that was made
// with the library of the protocol's own project.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace fulcrum::test {

class OpenIgtlinkPeer {
  public:
    /// It is built only where libopenigtlink is installed.
    static bool built();
    static constexpr const char* not_built =
        "built without libopenigtlink: install the package libopenigtlink-dev (./run test does)";

    explicit OpenIgtlinkPeer(std::vector<std::string> words);
    ~OpenIgtlinkPeer();
    OpenIgtlinkPeer(const OpenIgtlinkPeer&) = delete;
    OpenIgtlinkPeer& operator=(const OpenIgtlinkPeer&) = delete;

    /// The whole lines that it has printed since the last call; waits at most so long for the first of them.
    std::vector<std::string> lines(int wait_ms);

  private:
    pid_t process_ = -1;
    int output_ = -1;
    std::string text_;  // the beginning of a line
};

}  // namespace fulcrum::test
