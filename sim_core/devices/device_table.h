// SPDX-License-Identifier: Apache-2.0
// Every kind of device for the hands and every fault that one can report: the one table that the daemon, the
// list of devices, the page of settings and the command line walk. Adding a device: docs/HOWTO.md.
//
// Texts are in English: titles and what is said where nothing is found are translated in the context
// "fulcrum::device_list", those of libraries and faults in "errors".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim_core/devices/device_page.h"
#include "sim_core/instrument/device_class.h"
#include "sim_core/instrument/workspace.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum {

/// What is wrong with a device that is open, as the process that reads it reports it. While there is a fault
/// the force is 0 and the hand that has it is not present, which pauses an attempt.
enum class DeviceFault : std::uint32_t {
    none,
    needs_calibration,  ///< positions are not valid yet
    warm_motors,        ///< the motors were too warm within the last seconds
    too_much_force,     ///< the device refused a force within the last second
    too_fast,           ///< it switched its motors off because it was moved too fast
    switched_off,       ///< force is switched off at the device
    no_answer,          ///< communication error: cable, power or firmware
    servo_stopped,      ///< the loop of the maker's library does not run
    driver,             ///< the maker's library refused a call
    connection_ended,   ///< the server of a tracker closed the connection, or it failed
    not_openigtlink,    ///< what that server sends is not OpenIGTLink
    wrong_checksum,     ///< its messages have wrong checksums
    not_a_pose,         ///< its poses are not numbers, or not a rotation and a place
    no_poses,           ///< it sends no poses of a tool
    spacenavd,          ///< the program that reads a SpaceMouse ended, or sends something else
    haply_ended,        ///< the service of Haply ended or closed the connection
    haply_silent,       ///< it does not answer
    haply_message,      ///< what it sends cannot be used
    no_power,           ///< the device has no power supply, so it renders no force
    safety_brake,       ///< the device braked itself within the last seconds
    trainer_unplugged,  ///< the serial port of a trainer hung up
    trainer_silent,     ///< it sends nothing new
    trainer_lines,      ///< what it sends are not its lines
    trainer_checksum,   ///< its lines have wrong checksums
    trainer_values,     ///< its angles or lengths are not possible
    firmware            ///< the maker's library says that the device's firmware does not suit it
};

struct FaultRow {
    DeviceFault kind;
    const char* words;     ///< what is wrong and what to do
    bool opens = false;    ///< the device has to be opened again
    int remembered = 200;  ///< ms that it stays after it was seen last
};
inline constexpr FaultRow device_faults[] = {
    {DeviceFault::none, ""},
    {DeviceFault::needs_calibration,
     QT_TRANSLATE_NOOP(
         "errors",
         "The device needs calibration. Put the stylus of a Touch into its inkwell and take it out "
         "after two seconds; move the handle of another device slowly to each end of its range. Where "
         "that does not help, calibrate it with the maker's program.")},
    {DeviceFault::warm_motors,
     QT_TRANSLATE_NOOP("errors",
                       "The motors of the device are too warm. Let go of it for half a minute, then resume."),
     false, 3000},
    {DeviceFault::too_much_force,
     QT_TRANSLATE_NOOP("errors",
                       "The device refused a force as too large. Resume; where it happens "
                       "again, lower the force given to the hand on the page Settings."),
     false, 1000},
    {DeviceFault::too_fast,
     QT_TRANSLATE_NOOP("errors",
                       "The device was moved too fast and switched its motors off. Hold it still.")},
    {DeviceFault::switched_off,
     QT_TRANSLATE_NOOP("errors",
                       "Force is switched off at the device. Press its force button, or let "
                       "its hand sensor see your hand.")},
    {DeviceFault::no_answer,
     QT_TRANSLATE_NOOP("errors",
                       "The device does not answer. Check its cable and power; unplug it and "
                       "connect it again."),
     true},
    {DeviceFault::servo_stopped,
     QT_TRANSLATE_NOOP("errors",
                       "The maker's driver of the device has stopped reading it. Unplug the "
                       "device and connect it again."),
     true},
    {DeviceFault::driver,
     QT_TRANSLATE_NOOP("errors",
                       "The maker's driver of the device refused a request. Install the "
                       "driver's newest version; its messages are on standard error."),
     true},
    {DeviceFault::connection_ended,
     QT_TRANSLATE_NOOP("errors",
                       "The connection to the tracker's server ended. Start the server again "
                       "and check the network."),
     true},
    {DeviceFault::not_openigtlink,
     QT_TRANSLATE_NOOP("errors", "What the tracker's server sends is not OpenIGTLink. Check its port."),
     true},
    {DeviceFault::wrong_checksum,
     QT_TRANSLATE_NOOP("errors",
                       "Messages of the tracker's server have wrong checksums and are not "
                       "used. Install the newest version of the program that sends them.")},
    {DeviceFault::not_a_pose,
     QT_TRANSLATE_NOOP("errors",
                       "The tracker sends poses that cannot be used. Bring the instrument into "
                       "its view, and calibrate it where that does not help.")},
    {DeviceFault::no_poses,
     QT_TRANSLATE_NOOP("errors",
                       "The tracker sends no pose of an instrument. Bring the instrument into "
                       "its view, and check that the tracker is running.")},
    {DeviceFault::spacenavd,
     QT_TRANSLATE_NOOP("errors",
                       "spacenavd, which reads the SpaceMouse, ended or sends something else. "
                       "Start it again: `sudo systemctl restart spacenavd`."),
     true},
    {DeviceFault::haply_ended,
     QT_TRANSLATE_NOOP("errors",
                       "The Inverse service of Haply ended or closed the connection. Start it "
                       "again, and end other programs that use the device."),
     true},
    {DeviceFault::haply_silent,
     QT_TRANSLATE_NOOP("errors",
                       "The Inverse service of Haply does not answer. Restart it, and check the "
                       "cable of the device."),
     true},
    {DeviceFault::haply_message,
     QT_TRANSLATE_NOOP("errors",
                       "The Inverse service of Haply sends readings that cannot be used. "
                       "Restart it, and install its newest version.")},
    {DeviceFault::no_power,
     QT_TRANSLATE_NOOP("errors",
                       "The device has no power supply, so it renders no force. Connect its "
                       "power supply.")},
    {DeviceFault::safety_brake,
     QT_TRANSLATE_NOOP("errors",
                       "The device stopped its motors for safety: its brake triggered, it stalled or it "
                       "became unstable. Let go of the handle for three seconds, then resume; move it "
                       "more slowly."),
     false, 3000},
    {DeviceFault::trainer_unplugged,
     QT_TRANSLATE_NOOP("errors",
                       "The trainer was unplugged. Plug it in again; where it comes off by itself, use "
                       "another cable or port."),
     true},
    {DeviceFault::trainer_silent,
     QT_TRANSLATE_NOOP("errors",
                       "The trainer sends nothing new. Press the reset button of its board; where that does "
                       "not help, unplug it and plug it in again.")},
    {DeviceFault::trainer_lines,
     QT_TRANSLATE_NOOP("errors",
                       "What the trainer sends cannot be read. Press the reset button of its board, and "
                       "load the sketch that came with this version of Fulcrum."),
     false, 1000},
    {DeviceFault::trainer_checksum,
     QT_TRANSLATE_NOOP("errors",
                       "Lines of the trainer arrive damaged. Use a shorter cable, away from motors and "
                       "electrosurgery, or a lower rate on both sides."),
     false, 1000},
    {DeviceFault::trainer_values,
     QT_TRANSLATE_NOOP("errors",
                       "The trainer reports an angle or a length that is not possible. Check the plugs of "
                       "its sensors and the ranges in its sketch."),
     false, 1000},
    {DeviceFault::firmware,
     QT_TRANSLATE_NOOP(
         "errors",
         "The maker's driver reports that the firmware of the device does not suit it. Update "
         "the firmware with the maker's program, or install the driver that belongs to it; then "
         "connect the device again."),
     true}};
static_assert(in_order(device_faults));

/// For a number that another process wrote: the row of none where it is not a fault.
constexpr const FaultRow& fault_row(DeviceFault fault) {
    return static_cast<std::size_t>(fault) < std::size(device_faults) ? row_of(device_faults, fault)
                                                                      : device_faults[0];
}
/// What is wrong and what to do; empty for none and for a number that is not a fault.
constexpr const char* words_of(DeviceFault fault) {
    return fault_row(fault).words;
}
/// True if the device has to be opened again.
constexpr bool needs_opening(DeviceFault fault) {
    return fault_row(fault).opens;
}

enum class ReadBy : std::uint8_t {
    window,   ///< as events of the mouse and keys
    program,  ///< in a thread of its own
    daemon    ///< fulcrum-hapticd; sim_core/hapticd/backend.cpp makes it
};

/// How the list of devices finds out whether one is there and can be used (app/services/device_list.cpp).
enum class FoundBy : std::uint8_t {
    screen,
    mice,       ///< of the X server
    sdl,        ///< what SDL 2 reports
    script,     ///< always there
    library,    ///< that of its maker, and its USB numbers
    port,       ///< somebody listens at one of its ports on this computer
    spacenavd,  ///< its socket
    joystick,   ///< what SDL 2 reports, and a calibration
    serial,     ///< the only serial port of a board with one of its USB numbers
};

/// What a device can move; the rest is moved with mouse and keyboard.
inline constexpr unsigned moves_hands = 1, moves_scope = 2, moves_pedal = 4;
struct DevicePart {
    unsigned bit;
    const char* name;  ///< in files
};
inline constexpr DevicePart device_parts[] = {
    {moves_hands, "hands"}, {moves_scope, "scope"}, {moves_pedal, "pedal"}};

/// A product of "" is any product of the vendor; a vendor of "": no more numbers.
struct UsbNumber {
    const char *vendor = "", *product = "";
};

/// Of its maker, which the person installs.
struct DeviceLibrary {
    const char* variable = "";              ///< environment variable with the path of another one, for tests
    const char *install = "", *needs = "";  ///< what to do where it is missing, incomplete
};

struct DeviceRow {
    const char* name;   ///< as typed, before the colon; permanent
    const char* typed;  ///< with its address, as help shows it
    const char* title;
    DeviceClass device_class;  ///< haptic: tracked where it renders no force
    ReadBy read_by;
    FoundBy found_by;
    unsigned moves;
    const char *absent = "", *connect = "";  ///< where it is not found: why, and what to do
    UsbNumber usb[12] = {};
    const char* rule = "";  ///< what to do where its file may not be opened
    int ports[2] = {0, 0};  ///< of this computer
    DeviceLibrary library = {};
    /// mm, device frame: least and most, as its maker publishes it, where its library does not state it.
    double workspace[6] = {};
};

inline constexpr DeviceRow device_table[] = {
    {"mouse-keyboard", "mouse-keyboard", QT_TRANSLATE_NOOP("fulcrum::device_list", "mouse and keyboard"),
     DeviceClass::mouse_keyboard, ReadBy::window, FoundBy::screen, moves_hands | moves_scope | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list", "there is no screen here"),
     QT_TRANSLATE_NOOP("fulcrum::device_list", "start Fulcrum on a desktop, or set DISPLAY")},
    {"two-mice", "two-mice", QT_TRANSLATE_NOOP("fulcrum::device_list", "two mice, one for each hand"),
     DeviceClass::mouse_keyboard, ReadBy::window, FoundBy::mice, moves_hands | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list", "no mouse that an X server with XInput 2.1 reads by itself"),
     QT_TRANSLATE_NOOP("fulcrum::device_list", "start Fulcrum in an X11 session and connect two mice")},
    {"controller", "controller", QT_TRANSLATE_NOOP("fulcrum::device_list", "game controller"),
     DeviceClass::controller, ReadBy::program, FoundBy::sdl, moves_hands | moves_scope | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list", "none is connected"),
     QT_TRANSLATE_NOOP("fulcrum::device_list",
                       "connect one by cable or Bluetooth and switch it on; your account "
                       "needs the right to read /dev/input/event*")},
    {"virtual", "virtual:SCRIPT.json", QT_TRANSLATE_NOOP("fulcrum::device_list", "virtual device: a script"),
     DeviceClass::haptic, ReadBy::daemon, FoundBy::script, moves_hands | moves_scope | moves_pedal},
    {"touch",
     "touch",
     QT_TRANSLATE_NOOP("errors", "3D Systems Touch"),
     DeviceClass::haptic,
     ReadBy::daemon,
     FoundBy::library,
     moves_hands | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list", "no USB device of this kind was found"),
     QT_TRANSLATE_NOOP("fulcrum::device_list",
                       "connect it and its power supply; a model for a network card "
                       "can be tried with `fulcrum devices --test`"),
     {{"2988", ""}, {"0301", "2988"}},  // USB numbers: the makers' udev rules
     QT_TRANSLATE_NOOP(
         "errors",
         "write the line SUBSYSTEMS==\"usb\", ATTRS{idVendor}==\"2988\", MODE=\"0660\", TAG+=\"uaccess\" "
         "to /etc/udev/rules.d/70-fulcrum-touch.rules, then unplug the device and connect it again"),
     {},
     {"FULCRUM_LIBHD",
      QT_TRANSLATE_NOOP("errors",
                        "install OpenHaptics for Linux and the Touch driver of 3D Systems, then run "
                        "`sudo ldconfig`"),
      QT_TRANSLATE_NOOP("errors",
                        "install that library: libPhantomIOLib42.so comes with the Touch driver, "
                        "libncurses.so.5 and libtinfo.so.5 with the packages libncurses5 and libtinfo5")},
     // Touch and Geomagic Touch: 160 x 120 x 70 mm
     {-80, -60, -35, 80, 60, 35}},
    {"force-dimension",
     "force-dimension",
     QT_TRANSLATE_NOOP("errors", "Force Dimension, Novint Falcon"),
     DeviceClass::haptic,
     ReadBy::daemon,
     FoundBy::library,
     moves_hands | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list", "no USB device of this kind was found"),
     QT_TRANSLATE_NOOP("fulcrum::device_list",
                       "connect it and its power supply; a model for a network card "
                       "can be tried with `fulcrum devices --test`"),
     {{"1451", ""}, {"0403", "cb48"}},
     QT_TRANSLATE_NOOP(
         "errors",
         "write the lines SUBSYSTEMS==\"usb\", ATTRS{idVendor}==\"1451\", MODE=\"0660\", "
         "TAG+=\"uaccess\" and SUBSYSTEMS==\"usb\", ATTRS{idVendor}==\"0403\", "
         "ATTRS{idProduct}==\"cb48\", MODE=\"0660\", TAG+=\"uaccess\" to "
         "/etc/udev/rules.d/70-fulcrum-force-dimension.rules, then unplug the device and connect it "
         "again"),
     {},
     {"FULCRUM_LIBDRD",
      QT_TRANSLATE_NOOP("errors",
                        "install the Force Dimension SDK and name its folder in FDSDK, or copy its "
                        "libdrd.so to /usr/local/lib and run `sudo ldconfig`"),
      QT_TRANSLATE_NOOP("errors",
                        "install that library: libusb-1.0.so.0 comes with the package libusb-1.0-0")}},
    {"haply",
     "haply",
     QT_TRANSLATE_NOOP("fulcrum::device_list", "Haply Inverse3, VerseGrip"),
     DeviceClass::haptic,
     ReadBy::daemon,
     FoundBy::port,
     moves_hands | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list",
                       "the Inverse service of Haply does not run: nothing listens at port "
                       "10001 of this computer"),
     QT_TRANSLATE_NOOP(
         "fulcrum::device_list",
         "install the Inverse service from Haply and start it; connect the device and its power supply"),
     {},
     "",
     {10001, 10000}},
    {"openigtlink",
     "openigtlink:HOST:PORT",
     QT_TRANSLATE_NOOP("fulcrum::device_list", "tracked instruments over OpenIGTLink"),
     DeviceClass::tracked,
     ReadBy::daemon,
     FoundBy::port,
     moves_hands | moves_scope | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list", "no server listens at port 18944 of this computer"),
     QT_TRANSLATE_NOOP(
         "fulcrum::device_list",
         "start PLUS, 3D Slicer or the tracker's program with an OpenIGTLink server; for one on another "
         "computer start Fulcrum with FULCRUM_DEVICE=openigtlink:HOST:PORT"),
     {},
     "",
     {18944}},
    {"space-mouse",
     "space-mouse",
     QT_TRANSLATE_NOOP("fulcrum::device_list", "SpaceMouse"),
     DeviceClass::controller,
     ReadBy::daemon,
     FoundBy::spacenavd,
     moves_hands | moves_scope | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list", "spacenavd, which reads it, does not run"),
     QT_TRANSLATE_NOOP("fulcrum::device_list",
                       "install the package spacenavd and start it with `sudo systemctl restart spacenavd`"),
     {{"256f", ""}}},
    {"trainer",
     "trainer:PORT",
     QT_TRANSLATE_NOOP("fulcrum::device_list", "box trainer on a serial port"),
     DeviceClass::tracked,
     ReadBy::daemon,
     FoundBy::serial,
     moves_hands | moves_scope | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list", "no serial port of a micro-controller was found"),
     QT_TRANSLATE_NOOP("fulcrum::device_list",
                       "load the sketch of docs/trainer on a board with sensors and plug it in; a port of "
                       "another kind is named: FULCRUM_DEVICE=trainer:PORT"),
     // Arduino, and the chips for USB that boards like it have; the Falcon is 0403 as well.
     {{"2341", ""},
      {"2a03", ""},
      {"1a86", ""},
      {"10c4", "ea60"},
      {"0403", "6001"},
      {"0403", "6015"},
      {"16c0", "0483"},
      {"2e8a", ""},
      {"303a", ""},
      {"239a", ""},
      {"1b4f", ""}},
     QT_TRANSLATE_NOOP("errors",
                       "run `sudo usermod -aG dialout $USER` (the group that owns the port), then sign out "
                       "and in again")},
    {"joystick", "joystick", QT_TRANSLATE_NOOP("fulcrum::device_list", "HID joystick as an instrument"),
     DeviceClass::tracked, ReadBy::daemon, FoundBy::joystick, moves_hands | moves_pedal,
     QT_TRANSLATE_NOOP("fulcrum::device_list", "none is connected"),
     QT_TRANSLATE_NOOP("fulcrum::device_list",
                       "connect the joystick of the trainer; your account needs the right to read "
                       "/dev/input/event*")}};

/// The row of a specification such as "openigtlink:HOST:PORT"; null where its first word is not the name of
/// one.
constexpr const DeviceRow* device_row(std::string_view specification) {
    return find_row(device_table, specification.substr(0, specification.find(':')));
}
/// For the hands, on the page of settings: a script needs its file, which is not asked for there.
constexpr bool can_be_chosen(const DeviceRow& row) {
    return row.found_by != FoundBy::script;
}
/// "controller, virtual:SCRIPT.json, …": what can be typed, without the first kinds where only events of the
/// window read them.
std::string typed_devices(bool of_window);
/// The workspace that its maker publishes; none where the row has none.
std::optional<WorkspaceBox> published_workspace(const DeviceRow& row);

/// Rules of udev with which the person at the screen may open devices of this row; none where nothing of it
/// is opened.
std::vector<std::string> udev_rules_of(const DeviceRow& row);

struct UsbDevice;
bool is_of(const DeviceRow& row, const UsbDevice& device);
/// The serial ports of the devices of this row.
std::vector<std::string> serial_ports_of(const DeviceRow& row, const std::vector<UsbDevice>& connected);

}  // namespace fulcrum
