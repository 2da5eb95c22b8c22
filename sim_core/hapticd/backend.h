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

/// How the daemon makes one kind of device. The header NAME_device.h of a backend ends with its own,
/// NAME_maker; CMake lists the headers, and backend.cpp compares the list with device_table when it is
/// compiled.
struct Maker {
    const char* name;  ///< of device_table, where fulcrum-hapticd reads the device
    std::unique_ptr<Backend> (*make)(const std::string& specification);
    LibraryLook (*look)() = nullptr;  ///< where it has a library of its maker
};
/// Maker::make: `Device` as what `read` makes of the specification says.
template <typename Device, auto read>
std::unique_ptr<Backend> make_device(const std::string& specification) {
    return std::make_unique<Device>(read(specification));
}
/// Maker::look.
template <typename Library>
LibraryLook load_whole() {
    Library library;
    return library.load();
}

/// The device that a specification names: "virtual:SCRIPT.json", "touch". Throws InputError.
std::unique_ptr<Backend> make_backend(const std::string& specification);
/// For a specification that names no kind of device.
[[noreturn]] void refuse_kind(const std::string& specification);
/// Loads the library of the maker of this kind of device and reports what is missing.
LibraryLook look_at_own_library(const std::string& kind);

}  // namespace fulcrum::hapticd
