// SPDX-License-Identifier: Apache-2.0
// The program's side of fulcrum-hapticd: starts it, watches it, and gives access to its pages.
//
// One thread starts, polls and destroys it (the window's). The pages may be read and written by a haptic
// thread while the client exists.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "sim_core/devices/device_facts.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum {

/// fulcrum-hapticd in the folder of this program, or FULCRUM_HAPTICD where that is set.
std::string hapticd_program();

class DaemonClient {
  public:
    /// Starts `program` for the device that `specification` names and waits until the device is open. Throws
    /// InputError with what is wrong and what to do.
    DaemonClient(const std::string& program, const std::string& specification);
    ~DaemonClient();
    DaemonClient(const DaemonClient&) = delete;
    DaemonClient& operator=(const DaemonClient&) = delete;

    const DeviceFacts& facts() const { return facts_; }
    const StatePage& state() const { return *state_.get(); }
    CommandPage& command() { return *command_.get(); }
    /// What the system refused (no real-time priority, …), with what to do.
    const std::vector<std::string>& notes() const { return notes_; }
    pid_t overseer() const { return overseer_; }
    pid_t device_process() const { return device_; }
    int state_descriptor() const { return state_.descriptor(); }

    enum class Health {
        good,
        restarting,  ///< the device process ended and is being started again
        ended,       ///< for good
        silent       ///< the overseer does not run
    };
    /// Reads what the daemon reported since the last call. Does not wait.
    Health poll();
    /// False where the overseer gives no sign of itself in half a second; one that runs gives it in 5 ms.
    bool wait_for_sign() const;
    /// What happened to the daemon, else the device's fault, and what to do; empty while both are good.
    const Sentence& message() const { return message_.empty() ? fault_ : message_; }

  private:
    void start(const std::string& program, const std::string& specification);
    void take(const std::string& text);
    void lose(Health health, const Sentence& what);
    void end();

    DeviceFacts facts_;
    std::vector<std::string> notes_;
    SharedPage<StatePage> state_;
    SharedPage<CommandPage> command_;
    int socket_ = -1;
    pid_t overseer_ = 0, device_ = 0;
    Health health_ = Health::good;
    Sentence message_, fault_;
};

}  // namespace fulcrum
