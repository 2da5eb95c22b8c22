// SPDX-License-Identifier: Apache-2.0
// Where spacenavd, the program that reads a SpaceMouse, listens.
#pragma once

#include <string>

namespace fulcrum {

/// $SPNAV_SOCKET, else `socket=` of the configuration of spacenavd, else its usual path.
std::string spacenavd_socket(const std::string& configuration = "/etc/spnavrc");

}  // namespace fulcrum
