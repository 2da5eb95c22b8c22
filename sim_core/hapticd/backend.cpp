// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/backend.h"

#include "sim_core/hapticd/all_devices.h"  // made by the build: every *_device.h of this folder
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {
namespace {

#define FULCRUM_MAKER(name) name##_maker,
constexpr Maker makers[] = {ALL_DEVICES(FULCRUM_MAKER)};
#undef FULCRUM_MAKER

constexpr bool each_row_has_its_maker() {
    for (const DeviceRow& row : device_table) {
        int found = 0;
        for (const Maker& one : makers) found += std::string_view(one.name) == row.name ? 1 : 0;
        if (found != (row.read_by == ReadBy::daemon ? 1 : 0)) return false;
    }
    return true;
}
constexpr bool each_maker_has_a_row() {
    for (const Maker& one : makers)
        if (find_row(device_table, one.name) == nullptr) return false;
    return true;
}
static_assert(each_row_has_its_maker(),
              "device_table has a row of ReadBy::daemon that no backend is for, or two");
static_assert(each_maker_has_a_row(), "a backend has no row in device_table");

const Maker* maker(const std::string& specification) {
    return find_row(makers, std::string_view(specification).substr(0, specification.find(':')));
}

}  // namespace

void refuse_kind(const std::string& specification) {
    throw InputError("device", "",
                     {QT_TRANSLATE_NOOP("errors", "'%1' is not the name of a kind of device"), specification},
                     {QT_TRANSLATE_NOOP("errors",
                                        "write one of %1, in small letters; `fulcrum devices` lists what is "
                                        "connected"),
                      typed_devices(true)});
}

std::unique_ptr<Backend> make_backend(const std::string& specification) {
    if (const Maker* const row = maker(specification)) return row->make(specification);
    refuse_kind(specification);
}

LibraryLook look_at_own_library(const std::string& kind) {
    const Maker* const row = maker(kind);
    return row != nullptr && row->look != nullptr ? row->look() : LibraryLook{LibraryState::unusable, kind};
}

}  // namespace fulcrum::hapticd
