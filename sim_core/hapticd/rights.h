// SPDX-License-Identifier: Apache-2.0
// What the device process gives up after its device is open, and what it asks the system for.
#pragma once

#include <string>
#include <vector>

namespace fulcrum::hapticd {

/// Real-time priority and memory that stays in place, as far as the system allows. Each note says what was
/// refused and what to do.
struct RealTime {
    bool priority = false, memory = false;
    std::vector<std::string> notes;
};
RealTime become_real_time(int priority);

/// From now on this process gets no new rights, opens no socket and starts no program or process (threads
/// are allowed). False where the system has no filter for system calls.
bool give_up_rights();

}  // namespace fulcrum::hapticd
