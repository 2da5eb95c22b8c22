// SPDX-License-Identifier: Apache-2.0
// A device that fulcrum-hapticd owns. Made by the overseer, used by the device process.
#pragma once

#include <memory>
#include <string>

#include "sim_core/devices/device_facts.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/devices/maker_library.h"

namespace fulcrum::hapticd {

class Backend {
  public:
    virtual ~Backend() = default;
    /// Complete after open().
    virtual const DeviceFacts& facts() const = 0;
    /// Once, in the device process, before rights are given up: opens what has to be opened. Throws
    /// InputError.
    virtual void open() {}
    /// Once, after the last render(), which was 0.
    virtual void close() noexcept {}
    /// Reads all slots; `time` is set by the caller. Real-time loop: no allocation, lock or exception.
    virtual void read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept = 0;
    /// Renders a force (N, device frame) and a torque about the shaft (N m) on a hand. Real-time loop.
    virtual void render(int hand, const Vector3& force, double torque) noexcept = 0;
    /// What was wrong when read() was called last. Real-time loop.
    virtual FaultReport fault() const noexcept { return {}; }
    /// The device has to be opened again, by another process. Real-time loop.
    virtual bool lost() const noexcept { return false; }
};

/// The device that a specification names: "virtual:SCRIPT.json", "touch". Throws InputError.
std::unique_ptr<Backend> make_backend(const std::string& specification);
/// Loads the library of the maker of this kind of device and reports what is missing.
LibraryLook look_at_own_library(const std::string& kind);

}  // namespace fulcrum::hapticd
