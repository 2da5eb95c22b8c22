// SPDX-License-Identifier: Apache-2.0
// The haptic loop's tick: hands in, force out, one record sample. Haptic thread; no allocation, lock, I/O or
// exception.
#pragma once

#include <memory>
#include <optional>

#include "sim_core/contact/tool_contact.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/instrument/tick_output.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

class World;

class HapticLoop {
  public:
    /// The world gives the immutable cavity and the first models; the loop never reads it again.
    HapticLoop(const Scene& scene, const World& world);
    ~HapticLoop();
    HapticLoop(const HapticLoop&) = delete;
    HapticLoop& operator=(const HapticLoop&) = delete;

    /// What the hand's device can render; none (as at the start): it renders no force and 0 is sent. Before
    /// the first tick, from any thread.
    void set_device(Hand hand, const std::optional<ForceOutput>& device);
    /// From the next tick on forces come from these models; the one before stays for the bumpless swap.
    /// Copied.
    void adopt(const LocalModels& models) noexcept;
    /// One tick. The result stays valid until the next.
    const TickOutput& tick(const RigSample& input) noexcept;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fulcrum
