// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the window's attempts are sent over OpenIGTLink, and where: FULCRUM_OPENIGTLINK=ADDRESS:PORT, or
// what the page of settings chose, which is this computer at the standard port. UI thread.
#pragma once

#include <memory>

#include "app/igtl/live_sender.h"
#include "ui/services/device_service.h"

namespace fulcrum::app {

class Sending {
  public:
    /// Listens where the variable or the settings of the program say so.
    Sending();
    ui::SendingState state() const;
    /// Remembered, unless the variable names an address.
    void choose(bool wanted);
    /// For an attempt in this scene; null where nothing is sent.
    std::shared_ptr<SampleTap> begin(const Scene& scene, std::uint64_t seed);

  private:
    void start(const std::string& address, const std::string& named);
    bool fixed_ = false;
    std::unique_ptr<LiveSender> sender_;
    std::string address_;
    Sentence trouble_;
};

}  // namespace fulcrum::app
