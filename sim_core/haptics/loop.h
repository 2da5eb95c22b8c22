// SPDX-License-Identifier: Apache-2.0
// The haptic loop's tick: hands in, force out, one record sample. Haptic thread; no allocation, lock, I/O or
// exception.
#pragma once

#include <memory>

#include "sim_core/contact/tool_contact.h"
#include "sim_core/haptics/safety.h"
#include "sim_core/haptics/stability.h"
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

    /// Device damping b (N s/m) for Eq. 8; negative: the hand feels no force, Eq. 8 does not apply.
    void set_device_damping(Hand hand, double damping);
    /// From the next tick on forces come from these models; the one before stays for the bumpless swap.
    /// Copied.
    void adopt(const LocalModels& models) noexcept;
    /// One tick. The result stays valid until the next.
    const TickOutput& tick(const RigSample& input) noexcept;
    /// Hands for which Eq. 8 had to reduce the model since the last call (bit mask).
    unsigned take_stability_limited() noexcept;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fulcrum
