// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/mouse_keyboard_input.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace fulcrum::ui {
namespace {

constexpr double radians_per_pixel = 0.008;

constexpr double radians_per_notch = 0.26;  // 15 degrees

constexpr double closed_share = 0.3;  // of the opening: jaws below it were holding

constexpr int longest_ramp = 400;  // ticks from one target to the next

constexpr int pedal_key = Qt::Key_B, exchange_key = Qt::Key_T;

struct KeyMove {
    int key;
    int hand;  // 0 left, 1 right, 2 camera
    double right, up, in, roll, head = 0;
};
constexpr KeyMove key_moves[] = {
    {Qt::Key_A, 0, -1, 0, 0, 0},        {Qt::Key_D, 0, 1, 0, 0, 0},          {Qt::Key_W, 0, 0, 1, 0, 0},
    {Qt::Key_S, 0, 0, -1, 0, 0},        {Qt::Key_R, 0, 0, 0, 1, 0},          {Qt::Key_F, 0, 0, 0, -1, 0},
    {Qt::Key_Q, 0, 0, 0, 0, -1},        {Qt::Key_E, 0, 0, 0, 0, 1},          {Qt::Key_J, 1, -1, 0, 0, 0},
    {Qt::Key_L, 1, 1, 0, 0, 0},         {Qt::Key_I, 1, 0, 1, 0, 0},          {Qt::Key_K, 1, 0, -1, 0, 0},
    {Qt::Key_P, 1, 0, 0, 1, 0},         {Qt::Key_Semicolon, 1, 0, 0, -1, 0}, {Qt::Key_U, 1, 0, 0, 0, -1},
    {Qt::Key_O, 1, 0, 0, 0, 1},         {Qt::Key_Left, 2, 1, 0, 0, 0},       {Qt::Key_Right, 2, -1, 0, 0, 0},
    {Qt::Key_Up, 2, 0, -1, 0, 0},       {Qt::Key_Down, 2, 0, 1, 0, 0},       {Qt::Key_PageUp, 2, 0, 0, 1, 0},
    {Qt::Key_PageDown, 2, 0, 0, -1, 0}, {Qt::Key_Home, 2, 0, 0, 0, -1},      {Qt::Key_End, 2, 0, 0, 0, 1},
    {Qt::Key_Comma, 2, 0, 0, 0, 0, 1},  {Qt::Key_Period, 2, 0, 0, 0, 0, -1},
};

}  // namespace

MouseKeyboardRig::MouseKeyboardRig(const HandTargets& start) {
    restart(start);
}

void MouseKeyboardRig::restart(const HandTargets& start) {
    targets_.fill(start);
    for (int h = 0; h < hand_count; ++h) hand_[h] = HandleFollower(start.hand[h]);
    camera_ = HandleFollower(start.camera);
}

void MouseKeyboardRig::read(std::uint32_t tick, RigSample& sample) {
    ++since_target_;
    if (targets_.update()) {
        const int ramp = std::min(since_target_, longest_ramp) - 1;
        since_target_ = 0;
        const HandTargets& wanted = targets_.value();
        for (int h = 0; h < hand_count; ++h) hand_[h].aim(wanted.hand[h], ramp);
        camera_.aim(wanted.camera, ramp);
    }
    sample.tick = tick;
    for (int h = 0; h < hand_count; ++h) sample.hand[h] = hand_[h].tick();
    sample.camera = camera_.tick();
}

MouseKeyboardInput::MouseKeyboardInput(const Scene& scene) {
    for (int h = 0; h < hand_count; ++h) {
        const InstrumentSpec* spec = scene.instrument(static_cast<Hand>(h));
        if (spec == nullptr) continue;
        hand_[h].exists = true;
        hand_[h].trocar = make_trocar(spec->trocar);
        hand_[h].opening = spec->jaw_opening;
        hand_[h].grip = spec->grip_force;
        targets_.hand[h] = start_reading(spec->trocar.shaft_length, spec->start_insertion,
                                         spec->jaw_opening * open_jaw_share);
    }
    if (scene.camera) {
        has_camera_ = true;
        camera_trocar_ = make_trocar(scene.camera->trocar);
        targets_.camera = start_reading(scene.camera->trocar.shaft_length, scene.camera->start_insertion, 0);
        DeviceSample sample;
        for (int axis = 0; axis < 3; ++axis) {
            sample.handle[axis] =
                static_cast<std::int32_t>(std::lround(targets_.camera.handle[axis] / device_length_unit));
        }
        view_ = scope_pose(make_scope(*scene.camera), sample).orientation;
    }
    if (!hand_[1].exists) active_ = Hand::left;
    scope_alone_ = has_camera_ && scene.instruments.empty();
    rig_ = std::make_shared<MouseKeyboardRig>(targets_);
}

DeviceReading* MouseKeyboardInput::held_reading() {
    if (scope_alone_) return &targets_.camera;
    const auto h = static_cast<std::size_t>(active_);
    return hand_[h].exists ? &targets_.hand[h] : nullptr;
}

const Trocar& MouseKeyboardInput::held_trocar() const {
    return scope_alone_ ? camera_trocar_ : hand_[static_cast<std::size_t>(active_)].trocar;
}

void MouseKeyboardInput::move_mouse(const QPointF& pixels, MouseUse use) {
    DeviceReading* reading = held_reading();
    if (reading == nullptr) return;
    if (use == MouseUse::turn) {
        reading->roll += pixels.x() * radians_per_pixel;
    } else if (use == MouseUse::turn_head && scope_alone_) {
        reading->jaw -= pixels.x() * radians_per_pixel;
    } else if (use == MouseUse::move) {
        shift_handle(*reading, held_trocar(),
                     on_screen(pixels.x() * metres_per_pixel, -pixels.y() * metres_per_pixel));
    }
}

void MouseKeyboardInput::turn_wheel(double notches) {
    DeviceReading* reading = held_reading();
    if (reading != nullptr) insert_handle(*reading, held_trocar(), notches * metres_per_notch);
}

void MouseKeyboardInput::move_hand(Hand hand, const QPointF& pixels, double notches, double turned_notches) {
    const auto h = static_cast<std::size_t>(hand);
    // In a scene for the scope alone the mouse of the right hand moves the scope.
    if (scope_alone_ && hand == Hand::left) return;
    if (!scope_alone_ && !hand_[h].exists) return;
    DeviceReading& reading = scope_alone_ ? targets_.camera : targets_.hand[h];
    const Trocar& trocar = scope_alone_ ? camera_trocar_ : hand_[h].trocar;
    shift_handle(reading, trocar, on_screen(pixels.x() * metres_per_pixel, -pixels.y() * metres_per_pixel));
    insert_handle(reading, trocar, notches * metres_per_notch);
    reading.roll += turned_notches * radians_per_notch;
}

void MouseKeyboardInput::set_hand_buttons(Hand hand, bool jaws, bool pedal, bool exchange) {
    Axis& axis = hand_[static_cast<std::size_t>(hand)];
    axis.jaws = jaws;
    axis.pedal = pedal;
    axis.exchange = exchange;
}

void MouseKeyboardInput::set_primary_button(bool pressed) {
    button_ = pressed;
}

bool MouseKeyboardInput::press_key(int key) {
    switch (key) {
        case Qt::Key_Tab:
        case Qt::Key_Backtab:
            switch_hand();
            return true;
        case Qt::Key_X:
            hand_[0].latched = !hand_[0].latched;
            return true;
        case Qt::Key_M:
            hand_[1].latched = !hand_[1].latched;
            return true;
        case Qt::Key_Space:
            hand_[static_cast<std::size_t>(active_)].latched =
                !hand_[static_cast<std::size_t>(active_)].latched;
            return true;
        case pedal_key:
        case exchange_key:
            held_.insert(key);
            return true;
        default:
            break;
    }
    for (const KeyMove& move : key_moves) {
        if (move.key == key) {
            held_.insert(key);
            return true;
        }
    }
    return false;
}

void MouseKeyboardInput::release_key(int key) {
    held_.remove(key);
}

void MouseKeyboardInput::release_all() {
    held_.clear();
    button_ = false;
    for (Axis& axis : hand_) axis.jaws = axis.pedal = axis.exchange = false;
}

bool MouseKeyboardInput::jaws_closed(Hand hand) const {
    const Axis& axis = hand_[static_cast<std::size_t>(hand)];
    return axis.latched || axis.jaws || (button_ && hand == active_);
}

void MouseKeyboardInput::advance(double dt) {
    for (const KeyMove& move : key_moves) {
        if (!held_.contains(move.key)) continue;
        const bool camera = move.hand == 2;
        if (camera ? !has_camera_ : !hand_[move.hand].exists) continue;
        DeviceReading& reading = camera ? targets_.camera : targets_.hand[move.hand];
        const Trocar& trocar = camera ? camera_trocar_ : hand_[move.hand].trocar;
        const double reach = (camera ? key_camera_speed : key_handle_speed) * dt;
        if (move.right != 0 || move.up != 0) {
            shift_handle(reading, trocar, on_screen(move.right * reach, move.up * reach));
        }
        if (move.in != 0) insert_handle(reading, trocar, move.in * key_insertion_speed * dt);
        reading.roll += move.roll * key_turn_speed * dt;
        if (camera) reading.jaw += move.head * key_turn_speed * dt;
    }
    for (int h = 0; h < hand_count; ++h) {
        const bool closed = jaws_closed(static_cast<Hand>(h));
        targets_.hand[h].jaw = closed ? 0 : hand_[h].opening * open_jaw_share;
        targets_.hand[h].grip = closed ? hand_[h].grip : 0;
        const bool active = h == static_cast<int>(active_);
        unsigned buttons = closed ? button_primary : button_none;
        if (hand_[h].pedal || (active && held_.contains(pedal_key))) buttons |= button_energy;
        if (hand_[h].exchange || (active && held_.contains(exchange_key))) buttons |= button_exchange;
        targets_.hand[h].buttons = static_cast<std::uint16_t>(buttons);
    }
    publish();
}

void MouseKeyboardInput::publish() {
    rig_->targets().write_slot() = targets_;
    rig_->targets().publish();
}

void MouseKeyboardInput::begin_from(const RigSample& sample) {
    const auto put = [](const DeviceSample& from, DeviceReading& reading) {
        for (int axis = 0; axis < 3; ++axis) reading.handle[axis] = from.handle[axis] * device_length_unit;
        reading.roll = from.roll * device_angle_unit;
        reading.jaw = from.jaw * device_angle_unit;
    };
    for (int h = 0; h < hand_count; ++h) {
        if (!hand_[h].exists) continue;
        put(sample.hand[h], targets_.hand[h]);
        hand_[h].latched = targets_.hand[h].jaw < closed_share * hand_[h].opening;
    }
    if (has_camera_) put(sample.camera, targets_.camera);
    advance(0);
    rig_->restart(targets_);
}

void MouseKeyboardInput::set_connected(bool connected) {
    for (DeviceReading& reading : targets_.hand) reading.present = connected;
    targets_.camera.present = connected;
    publish();
}

QStringList MouseKeyboardInput::help_lines() const {
    const auto words = [](const char* source) {
        return QCoreApplication::translate("fulcrum::ui::MouseKeyboardInput", source);
    };
    if (two_mice_) {
        return {
            words("Each mouse\tmoves the handle of its hand; the tip goes the other way"),
            words("Left button\tcloses the jaws of that hand while held"),
            words("Wheel\tin and out"),
            words("Right button + wheel\tturns the shaft"),
            words("Middle button\tpedal of that hand (energy, suction)"),
            words("Side button\tnext instrument of that hand"),
            words("Tab\tthe mice change hands"),
            words("X · M\tjaws of the left, right hand stay closed, or open again"),
            words("Arrows · Page up, down\tscope: look · in, out"),
            words("Home, End · , .\tscope: light post · camera head"),
            words("Escape, F1\tpause · this help"),
        };
    }
    if (scope_alone_) {
        return {
            words("Mouse\tmoves the handle of the scope; the lens goes the other way"),
            words("Wheel\tin and out"),
            words("Shift + mouse\tturns the light post: the direction in which the scope looks"),
            words("Ctrl + mouse\tturns the camera head: the image alone"),
            words("Arrows · Page up, down\tlook · in, out"),
            words("Home, End · , .\tlight post · camera head"),
            words("Escape, F1\tpause · this help"),
        };
    }
    return {
        words("Mouse\tmoves the handle of the active hand; the tip goes the other way"),
        words("Left button\tcloses the jaws while held"),
        words("Right button, Tab\tthe other hand"),
        words("Wheel\tin and out"),
        words("Shift + mouse\tturns the shaft"),
        words("Space\tjaws of the active hand stay closed, or open again"),
        words("W A S D · R F · Q E · X\tleft hand: handle · in, out · turn · jaws"),
        words("I J K L · P ; · U O · M\tright hand: handle · in, out · turn · jaws"),
        words("B · T\tpedal of the active hand (energy, suction) · its next instrument"),
        words("Arrows · Page up, down\tscope: look · in, out"),
        words("Home, End · , .\tscope: light post · camera head"),
        words("Escape, F1\tpause · this help"),
    };
}

}  // namespace fulcrum::ui
