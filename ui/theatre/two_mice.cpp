// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/two_mice.h"

#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::ui {
namespace {

struct CloseDisplay {
    void operator()(Display* display) const { XCloseDisplay(display); }
};
using Connection = std::unique_ptr<Display, CloseDisplay>;

/// A connection of its own; null where the server has no XInput 2.1.
Connection connect_to_server(int& opcode) {
    Connection display(XOpenDisplay(nullptr));
    int event = 0, error = 0, major = 2, minor = 1;
    if (!display || !XQueryExtension(display.get(), "XInputExtension", &opcode, &event, &error)) return {};
    if (XIQueryVersion(display.get(), &major, &minor) != Success || major < 2 || (major == 2 && minor < 1))
        return {};
    return display;
}

bool is_virtual(const char* name) {
    return std::strstr(name, "XTEST") != nullptr;
}

std::vector<MouseDevice> mice_of(Display* display, bool virtual_too) {
    std::vector<MouseDevice> mice;
    int count = 0;
    XIDeviceInfo* const devices = XIQueryDevice(display, XIAllDevices, &count);
    for (int i = 0; i < count; ++i) {
        const XIDeviceInfo& one = devices[i];
        if (one.use == XISlavePointer && one.enabled && is_virtual(one.name) == virtual_too)
            mice.push_back({one.deviceid, one.name});
    }
    if (devices != nullptr) XIFreeDeviceInfo(devices);
    return mice;
}

constexpr int button_left = 1, button_middle = 2, button_right = 3, wheel_up = 4, wheel_down = 5,
              button_side = 8;

class ServersMice : public TwoMice {
  public:
    ServersMice(Connection display, int opcode, MouseDevice left, MouseDevice right)
        : display_(std::move(display)), opcode_(opcode), mice_{std::move(left), std::move(right)} {
        unsigned char bits[XIMaskLen(XI_LASTEVENT)] = {};
        for (const int kind : {XI_RawMotion, XI_RawButtonPress, XI_RawButtonRelease, XI_HierarchyChanged})
            XISetMask(bits, kind);
        XIEventMask mask{XIAllDevices, sizeof bits, bits};
        XISelectEvents(display_.get(), DefaultRootWindow(display_.get()), &mask, 1);
        XSync(display_.get(), False);
    }
    const MouseDevice& mouse(int hand) const override { return mice_[hand]; }
    void swap() override {
        std::swap(mice_[0], mice_[1]);
        std::swap(state_[0], state_[1]);
        std::swap(right_held_[0], right_held_[1]);
    }
    void read(MouseMotion (&motion)[2]) override {
        for (MouseMotion& one : state_) {
            one.right = one.down = one.notches = one.turned_notches = 0;
            one.held_right = one.held_down = 0;
        }
        while (XPending(display_.get()) > 0) {
            XEvent event;
            XNextEvent(display_.get(), &event);
            XGenericEventCookie& cookie = event.xcookie;
            if (cookie.type != GenericEvent || cookie.extension != opcode_ ||
                XGetEventData(display_.get(), &cookie) == False)
                continue;
            if (cookie.evtype == XI_HierarchyChanged)
                follow_changes();
            else
                take(*static_cast<const XIRawEvent*>(cookie.data));
            XFreeEventData(display_.get(), &cookie);
        }
        for (int h = 0; h < 2; ++h) motion[h] = state_[h];
    }

  private:
    /// A mouse that is unplugged takes its buttons with it; plugged in again it has another number.
    void follow_changes() {
        const std::vector<MouseDevice> now = mice_of(display_.get(), is_virtual(mice_[0].name.c_str()));
        const auto there = [&now](int id) {
            return std::any_of(now.begin(), now.end(), [id](const MouseDevice& one) { return one.id == id; });
        };
        for (int h = 0; h < 2; ++h) {
            if (there(mice_[h].id)) {
                state_[h].connected = true;
                continue;
            }
            state_[h] = {};
            right_held_[h] = state_[h].connected = false;
            for (const MouseDevice& one : now) {
                if (one.name != mice_[h].name || one.id == mice_[1 - h].id) continue;
                mice_[h].id = one.id;
                state_[h].connected = true;
            }
        }
    }
    void take(const XIRawEvent& event) {
        // The server reports each event for the mouse and again for the pointer that it moves.
        const int h = event.deviceid == mice_[0].id ? 0 : event.deviceid == mice_[1].id ? 1 : -1;
        if (h < 0) return;
        MouseMotion& motion = state_[h];
        if (event.evtype == XI_RawMotion) {
            const double* value = event.raw_values;
            double& right = right_held_[h] ? motion.held_right : motion.right;
            double& down = right_held_[h] ? motion.held_down : motion.down;
            for (int axis = 0; axis < 8 * event.valuators.mask_len; ++axis) {
                if (!XIMaskIsSet(event.valuators.mask, axis)) continue;
                if (axis < 2 && std::isfinite(*value)) (axis == 0 ? right : down) += *value;
                ++value;
            }
            return;
        }
        const bool pressed = event.evtype == XI_RawButtonPress;
        switch (event.detail) {
            case button_left:
                motion.left_button = pressed;
                break;
            case button_middle:
                motion.middle_button = pressed;
                break;
            case button_right:
                right_held_[h] = pressed;
                break;
            case button_side:
                motion.side_button = pressed;
                break;
            case wheel_up:
            case wheel_down:
                if (pressed)
                    (right_held_[h] ? motion.turned_notches : motion.notches) +=
                        event.detail == wheel_up ? 1 : -1;
                break;
            default:
                break;
        }
    }

    Connection display_;
    int opcode_;
    MouseDevice mice_[2];
    MouseMotion state_[2];
    bool right_held_[2] = {false, false};
};

}  // namespace

std::vector<MouseDevice> TwoMice::connected(bool virtual_too) {
    int opcode = 0;
    const Connection display = connect_to_server(opcode);
    return display ? mice_of(display.get(), virtual_too) : std::vector<MouseDevice>();
}

std::unique_ptr<TwoMice> TwoMice::open(bool virtual_too) {
    int opcode = 0;
    Connection display = connect_to_server(opcode);
    if (!display)
        throw InputError(
            QT_TRANSLATE_NOOP("errors", "two mice"), "",
            QT_TRANSLATE_NOOP("errors", "cannot be read: there is no X server with XInput 2.1"),
            QT_TRANSLATE_NOOP("errors", "start Fulcrum in an X11 session, or use mouse and keyboard"));
    const std::vector<MouseDevice> mice = mice_of(display.get(), virtual_too);
    if (mice.size() < 2)
        throw InputError(QT_TRANSLATE_NOOP("errors", "two mice"), "",
                         {QT_TRANSLATE_NOOP("errors", "%1 connected; two are needed"), mice.size()},
                         QT_TRANSLATE_NOOP("errors", "connect a second mouse, or use mouse and keyboard"));
    return std::make_unique<ServersMice>(std::move(display), opcode, mice[0], mice[1]);
}

}  // namespace fulcrum::ui
