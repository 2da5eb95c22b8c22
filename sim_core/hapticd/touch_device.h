// SPDX-License-Identifier: Apache-2.0
// 3D Systems Touch (and its predecessors of Geomagic and SensAble) through libHD: one device or two, read and
// given force in the servo loop of the library, 1000 times a second.
//
// The frame of libHD is that of docs/DEVICES.md, in millimetres. The turn of the stylus is the roll, the
// front button closes the jaws, the rear one gives energy. Order of calls: open all devices, then schedule
// one callback, then start the scheduler; stop it before a device is closed.
#pragma once

#include <memory>

#include "sim_core/hapticd/servo_backend.h"
#include "sim_core/hapticd/touch_library.h"

namespace fulcrum::hapticd {

/// The names of the devices in the settings of the maker's driver.
struct TouchNames {
    std::optional<std::string> hand[2];  ///< none: not used; empty: the default device
};
/// Of "touch" (the default device moves the right hand) or "touch:LEFT,RIGHT", of which one may be empty.
/// Throws InputError.
TouchNames touch_names(const std::string& specification);

class TouchDevice : public ServoBackend {
  public:
    explicit TouchDevice(TouchNames names);
    ~TouchDevice() override { close(); }
    void open() override;
    void close() noexcept override;

  private:
    struct Hand {
        hd::Handle handle = hd::invalid_handle;
        std::uint32_t style = 0;  // calibration that the device has; 0: by hand only
        std::uint32_t state = 0;  // hd::Calibration
        double jaw = 1;
        ServoReading last;
        FaultMemory memory;
    };
    void open_hand(int hand, const std::string& name);
    hd::Handle init(const std::string& name);
    void read_limits(int hand);
    void read_workspace(int hand);
    void read_versions();
    std::uint32_t first_error() noexcept;
    std::string words_of_error(std::uint32_t code) const;
    static std::uint32_t servo(void* device) noexcept;
    void tick() noexcept;
    void serve(int hand, std::int64_t now) noexcept;
    void calibrate(Hand& one) noexcept;
    void take_errors(int hand, std::int64_t now) noexcept;

    TouchNames names_;
    TouchLibrary library_;
    Hand hands_[2];
    unsigned long scheduled_ = 0;
    bool running_ = false;
    std::uint64_t ticks_ = 0;
};

inline constexpr Maker touch_maker = {"touch", make_device<TouchDevice, touch_names>,
                                      load_whole<TouchLibrary>};

}  // namespace fulcrum::hapticd
