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

class StateArchive;
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
    /// World step whose model is in use; 0 before the first.
    std::uint32_t model_step() const noexcept;
    /// One tick. The result stays valid until the next.
    const TickOutput& tick(const RigSample& input) noexcept;

    /// Writes what changes from tick to tick, or reads it for the same scene in the same build; `world`:
    /// whose models these are. Throws StateArchiveError. Not on the haptic thread.
    void transfer(StateArchive& archive, const World& world);
    /// What the devices said at the last tick.
    const RigSample& last_input() const noexcept;
    /// What an instrument follows: what its device said, with the clutch; stays in pauses and losses.
    const DeviceSample& held(Hand hand) const noexcept;
    /// As after a pause: from the next tick on the devices move the instruments from where these are,
    /// wherever the devices are, and the force on the hands grows from 0.
    void clutch_in() noexcept;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fulcrum
