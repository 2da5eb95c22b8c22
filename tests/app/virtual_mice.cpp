// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/virtual_mice.h"

#include <X11/Xlib.h>
#include <X11/extensions/XInput.h>
#include <X11/extensions/XInput2.h>
#include <X11/extensions/XTest.h>

#include <cstring>
#include <stdexcept>
#include <string>

namespace fulcrum::app::program_test {
namespace {
constexpr const char* second_name = "second";
constexpr const char* names[2] = {"Virtual core XTEST pointer", "second XTEST pointer"};
}  // namespace

struct VirtualMice::Server {
    Display* display = XOpenDisplay(nullptr);
    XDevice* mice[2] = {nullptr, nullptr};

    int id_of(const char* name) const {
        int count = 0, id = 0;
        XIDeviceInfo* const devices = XIQueryDevice(display, XIAllDevices, &count);
        for (int i = 0; i < count; ++i) {
            if (std::strcmp(devices[i].name, name) == 0) id = devices[i].deviceid;
        }
        XIFreeDeviceInfo(devices);
        return id;
    }
    void open(int mouse) {
        const int id = id_of(names[mouse]);
        mice[mouse] = id != 0 ? XOpenDevice(display, static_cast<XID>(id)) : nullptr;
        if (mice[mouse] == nullptr) throw std::runtime_error("no test pointer " + std::string(names[mouse]));
    }
    void add_second() {
        std::string name = second_name;
        XIAnyHierarchyChangeInfo change{};
        change.type = XIAddMaster;
        change.add.name = name.data();
        change.add.send_core = False;
        change.add.enable = True;
        XIChangeHierarchy(display, &change, 1);
        XSync(display, False);
        open(1);
    }
    void remove_second() {
        if (mice[1] != nullptr) XCloseDevice(display, mice[1]);
        mice[1] = nullptr;
        XIAnyHierarchyChangeInfo change{};
        change.type = XIRemoveMaster;
        change.remove.deviceid = id_of("second pointer");
        change.remove.return_mode = XIFloating;
        if (change.remove.deviceid != 0) XIChangeHierarchy(display, &change, 1);
        XSync(display, False);
    }
};

VirtualMice::VirtualMice() : server_(std::make_unique<Server>()) {
    if (server_->display == nullptr) throw std::runtime_error("no X server");
    int major = 2, minor = 2;
    XIQueryVersion(server_->display, &major, &minor);
    server_->open(0);
    server_->add_second();
}

VirtualMice::~VirtualMice() {
    server_->remove_second();
    XCloseDevice(server_->display, server_->mice[0]);
    XCloseDisplay(server_->display);
}

void VirtualMice::move(int mouse, int right, int down) {
    int axes[2] = {right, down};
    XTestFakeDeviceMotionEvent(server_->display, server_->mice[mouse], True, 0, axes, 2, 0);
    XFlush(server_->display);
}

void VirtualMice::button(int mouse, int number, bool pressed) {
    XTestFakeDeviceButtonEvent(server_->display, server_->mice[mouse], static_cast<unsigned>(number),
                               pressed ? True : False, nullptr, 0, 0);
    XFlush(server_->display);
}

void VirtualMice::wheel(int mouse, int notches) {
    for (int i = 0; i < (notches < 0 ? -notches : notches); ++i) {
        button(mouse, notches > 0 ? 4 : 5, true);
        button(mouse, notches > 0 ? 4 : 5, false);
    }
}

void VirtualMice::unplug_second() {
    server_->remove_second();
}
void VirtualMice::plug_in_second() {
    server_->add_second();
}

}  // namespace fulcrum::app::program_test
