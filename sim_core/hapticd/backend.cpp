// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/backend.h"

#include "sim_core/hapticd/force_dimension_device.h"
#include "sim_core/hapticd/haply_device.h"
#include "sim_core/hapticd/igtl_device.h"
#include "sim_core/hapticd/joystick_device.h"
#include "sim_core/hapticd/space_mouse_device.h"
#include "sim_core/hapticd/touch_device.h"
#include "sim_core/hapticd/trainer_device.h"
#include "sim_core/hapticd/virtual_device.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {
namespace {

[[noreturn]] void refuse_kind(const std::string& specification) {
    throw InputError("device", "",
                     {QT_TRANSLATE_NOOP("errors", "'%1' is not the name of a kind of device"), specification},
                     {QT_TRANSLATE_NOOP("errors",
                                        "write one of %1, in small letters; `fulcrum devices` lists what is "
                                        "connected"),
                      typed_devices(true)});
}

DeviceScript script_of(const std::string& specification) {
    const std::size_t colon = specification.find(':');
    if (colon == std::string::npos) refuse_kind(specification);
    return read_device_script(specification.substr(colon + 1));
}

/// `Device` as what `read` makes of the specification says.
template <typename Device, auto read>
std::unique_ptr<Backend> make_device(const std::string& specification) {
    return std::make_unique<Device>(read(specification));
}

template <typename Library>
LibraryLook load_whole() {
    Library library;
    return library.load();
}

struct MakerRow {
    const char* name;  ///< of device_table, where fulcrum-hapticd reads the device
    std::unique_ptr<Backend> (*make)(const std::string& specification);
    LibraryLook (*look)() = nullptr;  ///< where it has a library of its maker
};
constexpr MakerRow makers[] = {{"virtual", make_device<VirtualDevice, script_of>},
                               {"touch", make_device<TouchDevice, touch_names>, load_whole<TouchLibrary>},
                               {"force-dimension", make_device<ForceDimensionDevice, force_dimension_numbers>,
                                load_whole<ForceDimensionLibrary>},
                               {"haply", make_device<HaplyDevice, haply_specification>},
                               {"openigtlink", make_device<IgtlDevice, igtl_specification>},
                               {"space-mouse", make_device<SpaceMouseDevice, space_mouse_slot>},
                               {"trainer", make_device<TrainerDevice, trainer_specification>},
                               {"joystick", make_device<JoystickDevice, joystick_specification>}};

const MakerRow* maker(const std::string& specification) {
    return find_row(makers, std::string_view(specification).substr(0, specification.find(':')));
}

}  // namespace

std::unique_ptr<Backend> make_backend(const std::string& specification) {
    if (const MakerRow* const row = maker(specification)) return row->make(specification);
    refuse_kind(specification);
}

LibraryLook look_at_own_library(const std::string& kind) {
    const MakerRow* const row = maker(kind);
    return row != nullptr && row->look != nullptr ? row->look() : LibraryLook{LibraryState::unusable, kind};
}

}  // namespace fulcrum::hapticd
