// SPDX-License-Identifier: GPL-3.0-or-later
// Two instruments and the scope by mouse and keyboard. The mouse moves the *handle* of the active hand in the
// plane of the screen, so the tip goes the other way, as through any trocar; keys move either hand's handle
// and the scope at the same time. In a scene without instruments the mouse moves the scope's handle.
//
// Threads: MouseKeyboardInput lives on the UI thread and hands targets over through a triple buffer; its rig
// is read by the haptic thread, which follows the targets smoothly so that the window's events become 1,000
// steady ticks: from one target to the next in a straight line over as long as the one before took to come
// (drawing on a busy processor can hold the window up for 300 ms), then two low-passes at 12 Hz in a row.
#pragma once

#include <QPointF>
#include <QStringList>
#include <bitset>
#include <map>
#include <memory>

#include "sim_core/controllers/game_controller.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/instrument/mouse_mapping.h"
#include "sim_core/scene/scene.h"
#include "sim_core/telemetry/ring.h"
#include "ui/theatre/key_map.h"

namespace fulcrum::ui {

/// Where the hands and the scope are wanted; SI, trocar frames.
struct HandTargets {
    DeviceReading hand[hand_count];
    DeviceReading camera;
};

class MouseKeyboardRig : public Rig {
  public:
    explicit MouseKeyboardRig(const HandTargets& start);
    void read(std::uint32_t tick, RigSample& sample) override;
    void write_force(Hand, const Vector3&) override {}
    bool has_force(Hand) const override { return false; }
    double damping(Hand) const override { return -1; }
    /// Its rate is that of the window, which hands the newest targets over.
    std::optional<RigUse> use() const override;
    /// Before it is read.
    void set_motion(double scale) { motion_ = scale; }
    /// Before it is read: as if made with these.
    void restart(const HandTargets& start);
    /// UI thread.
    TripleBuffer<HandTargets>& targets() { return targets_; }

  private:
    TripleBuffer<HandTargets> targets_;
    HandleFollower hand_[hand_count], camera_;
    int since_target_ = 0;  ///< ticks since the last target came
    RateMeter meter_;
    double motion_ = 1;
};

class MouseKeyboardInput {
  public:
    /// Keys and what they do are listed in help_lines().
    explicit MouseKeyboardInput(const Scene& scene);
    std::shared_ptr<Rig> rig() const { return rig_; }

    Hand active_hand() const { return active_; }
    void switch_hand();
    /// The mouse moves this hand from now on, if it holds an instrument.
    void take_hand(Hand hand) {
        if (hand_[static_cast<std::size_t>(hand)].exists) active_ = hand;
    }
    /// The picture's orientation, so that the mouse moves in the plane of the screen.
    void set_camera(const Quaternion& orientation) { view_ = orientation; }
    /// What the mouse does: it moves the handle, turns the shaft (of the scope: the light post), or turns the
    /// camera head.
    enum class MouseUse { move, turn, turn_head };
    /// Pixels since the last call.
    void move_mouse(const QPointF& pixels, MouseUse use = MouseUse::move);
    void turn_wheel(double notches);
    void set_primary_button(bool pressed);
    /// True if the key means something here. `code` (QKeyEvent::nativeScanCode(), 0: not known) is that of
    /// the key itself, whose name changes with Shift: what was pressed under it ends with its release,
    /// whatever it is called by then.
    bool press_key(int key, quint32 code = 0);
    void release_key(int key, quint32 code = 0);
    /// The window lost the keyboard: nothing is held down any more; latched jaws stay.
    void release_all();
    /// Hands and scope are where a device's sample has them; jaws that were closed stay closed. Before the
    /// rig is read.
    void begin_from(const RigSample& sample);
    /// Whether the devices answer at all; a station whose mouse or keyboard was unplugged says no.
    void set_connected(bool connected);
    /// Integrates held keys over `dt` seconds and hands the targets to the haptic thread.
    void advance(double dt);
    const HandTargets& targets() const { return targets_; }
    bool jaws_closed(Hand hand) const;

    /// What moves the hands apart from the keys. With two mice or a controller the one mouse of the functions
    /// above is not used. With a device that the daemon reads the keys of pedal and exchange are for the hand
    /// that has a use for them, where the active one has none.
    enum class Device { mouse, two_mice, controller, of_daemon };
    void set_device(Device device) { device_ = device; }
    /// Before keys are pressed.
    void set_keys(const KeyMap& keys) { keys_ = keys; }
    const KeyMap& keys() const { return keys_; }
    /// Movement of the handle for that of a mouse or stick, over the usual one.
    void set_sensitivity(double scale) {
        sensitivity_ = scale;
        rig_->set_motion(scale);
    }
    void move_hand(Hand hand, const QPointF& pixels, double notches, double turned_notches);
    /// While the right button of that hand's mouse is held: away from the person is in, sideways turns the
    /// shaft; the larger of both counts.
    void push_hand(Hand hand, const QPointF& pixels);
    void set_hand_buttons(Hand hand, bool jaws, bool pedal, bool exchange);
    /// What a game controller asked for since the last call.
    void move_by_controller(const ControllerMotion& motion);
    /// The controller is gone: jaws that its triggers closed stay closed.
    void hold_jaws();

    QStringList help_lines() const;
    Device device() const { return device_; }

  private:
    struct Axis {
        Trocar trocar;
        double opening = 1.0, grip = 8.0;
        bool exists = false, latched = false;
        bool uses_pedal = false, uses_exchange = false;
        bool jaws = false, pedal = false, exchange = false;  ///< held on its own mouse or controller
        double trigger = 0;                                  ///< of the controller, 0 to 1
    };
    void publish();
    void set_jaw(int hand);
    bool key_is_for(int hand, KeyAction action) const;
    /// What the mouse moves; null: nothing.
    DeviceReading* held_reading();
    const Trocar& held_trocar() const;
    Vector3 on_screen(double right, double up) const { return view_ * Vector3(right, up, 0); }

    HandTargets targets_;
    Axis hand_[hand_count];
    Trocar camera_trocar_;
    bool has_camera_ = false, scope_alone_ = false, button_ = false;
    Device device_ = Device::mouse;
    double sensitivity_ = 1;
    Hand active_ = Hand::right;
    Quaternion view_ = Quaternion::Identity();
    KeyMap keys_ = KeyMap::standard(false);
    std::bitset<key_action_count> held_;
    std::map<quint32, KeyAction> held_by_;  ///< by code
    std::shared_ptr<MouseKeyboardRig> rig_;
};

}  // namespace fulcrum::ui
