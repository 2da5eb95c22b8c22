// SPDX-License-Identifier: Apache-2.0
// The process that guards the motors: it starts the process of the device, learns from the system at once
// when that stops or ends, switches the force off then, and starts it again. When the program at the other
// end of the control socket is gone, it ends both.
#pragma once

#include <string>

namespace fulcrum::hapticd {

/// `control`: one end of make_socket_pair(). Returns the exit status: 0 after the program has gone, 2 where
/// the device cannot be opened (the reason was sent), 1 where the system refused something.
int oversee(int control, const std::string& specification);

}  // namespace fulcrum::hapticd
