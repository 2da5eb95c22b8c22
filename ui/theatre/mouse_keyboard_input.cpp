// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/mouse_keyboard_input.h"

#include <algorithm>
#include <cmath>

#include "ui/theatre/hand_deeds.h"

namespace fulcrum::ui {
namespace {

constexpr double radians_per_pixel = 0.008;

constexpr double radians_per_notch = 0.26;  // 15 degrees

constexpr double closed_share = 0.3;  // of the opening: jaws below it were holding

constexpr int longest_ramp = 400;  // ticks from one target to the next

struct KeyMove {
    KeyAction action;
    int hand;  // 0 left, 1 right, 2 camera
    double right, up, in, roll, head = 0;
};
using A = KeyAction;
constexpr KeyMove key_moves[] = {
    {A::left_left, 0, -1, 0, 0, 0},       {A::left_right, 0, 1, 0, 0, 0},
    {A::left_up, 0, 0, 1, 0, 0},          {A::left_down, 0, 0, -1, 0, 0},
    {A::left_in, 0, 0, 0, 1, 0},          {A::left_out, 0, 0, 0, -1, 0},
    {A::left_turn_back, 0, 0, 0, 0, -1},  {A::left_turn, 0, 0, 0, 0, 1},
    {A::right_left, 1, -1, 0, 0, 0},      {A::right_right, 1, 1, 0, 0, 0},
    {A::right_up, 1, 0, 1, 0, 0},         {A::right_down, 1, 0, -1, 0, 0},
    {A::right_in, 1, 0, 0, 1, 0},         {A::right_out, 1, 0, 0, -1, 0},
    {A::right_turn_back, 1, 0, 0, 0, -1}, {A::right_turn, 1, 0, 0, 0, 1},
    {A::scope_left, 2, 1, 0, 0, 0},       {A::scope_right, 2, -1, 0, 0, 0},
    {A::scope_up, 2, 0, -1, 0, 0},        {A::scope_down, 2, 0, 1, 0, 0},
    {A::scope_in, 2, 0, 0, 1, 0},         {A::scope_out, 2, 0, 0, -1, 0},
    {A::post_back, 2, 0, 0, 0, -1},       {A::post, 2, 0, 0, 0, 1},
    {A::head, 2, 0, 0, 0, 0, 1},          {A::head_back, 2, 0, 0, 0, 0, -1},
};

constexpr std::size_t bit(KeyAction action) {
    return static_cast<std::size_t>(action);
}

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
        meter_.add(1, 1e-3 * tick);
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

std::optional<RigUse> MouseKeyboardRig::use() const {
    RigUse use;
    use.measured = meter_.rate();
    use.motion = motion_;
    use.pedal = -1;
    return use;
}

MouseKeyboardInput::MouseKeyboardInput(const Scene& scene) {
    for (int h = 0; h < hand_count; ++h) {
        const InstrumentSpec* spec = scene.instrument(static_cast<Hand>(h));
        if (spec == nullptr) continue;
        hand_[h].exists = true;
        hand_[h].uses_pedal = ui::uses_pedal(scene, spec->hand);
        hand_[h].uses_exchange = ui::uses_exchange(scene, spec->hand);
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
                     on_screen(sensitivity_ * pixels.x() * metres_per_pixel,
                               -sensitivity_ * pixels.y() * metres_per_pixel));
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
    shift_handle(reading, trocar,
                 on_screen(sensitivity_ * pixels.x() * metres_per_pixel,
                           -sensitivity_ * pixels.y() * metres_per_pixel));
    insert_handle(reading, trocar, notches * metres_per_notch);
    reading.roll += turned_notches * radians_per_notch;
}

void MouseKeyboardInput::push_hand(Hand hand, const QPointF& pixels) {
    if (std::abs(pixels.y()) >= std::abs(pixels.x()))
        move_hand(hand, {}, -sensitivity_ * pixels.y() * metres_per_pixel / metres_per_notch, 0);
    else
        move_hand(hand, {}, 0, pixels.x() * radians_per_pixel / radians_per_notch);
}

void MouseKeyboardInput::set_hand_buttons(Hand hand, bool jaws, bool pedal, bool exchange) {
    Axis& axis = hand_[static_cast<std::size_t>(hand)];
    axis.jaws = jaws;
    axis.pedal = pedal;
    axis.exchange = exchange;
}

void MouseKeyboardInput::switch_hand() {
    active_ = active_ == Hand::left ? Hand::right : Hand::left;
}

void MouseKeyboardInput::set_primary_button(bool pressed) {
    button_ = pressed;
}

bool MouseKeyboardInput::press_key(int key, quint32 code) {
    const std::optional<KeyAction> action = keys_.action(key);
    if (!action) return false;
    switch (*action) {
        case A::sound:
            return false;  // the theatre's
        case A::other_hand:
            switch_hand();
            break;
        case A::left_jaws:
            hand_[0].latched = !hand_[0].latched;
            break;
        case A::right_jaws:
            hand_[1].latched = !hand_[1].latched;
            break;
        case A::jaws:
            hand_[static_cast<std::size_t>(active_)].latched =
                !hand_[static_cast<std::size_t>(active_)].latched;
            break;
        default:
            held_.set(bit(*action));
            if (code != 0) held_by_[code] = *action;
            break;
    }
    return true;
}

void MouseKeyboardInput::release_key(int key, quint32 code) {
    const auto by = held_by_.find(code);
    if (by != held_by_.end()) {
        held_.reset(bit(by->second));
        held_by_.erase(by);
    } else if (const std::optional<KeyAction> action = keys_.action(key)) {
        held_.reset(bit(*action));
    }
}

void MouseKeyboardInput::release_all() {
    held_.reset();
    held_by_.clear();
    button_ = false;
    for (Axis& axis : hand_) axis.jaws = axis.pedal = axis.exchange = false;
}

bool MouseKeyboardInput::jaws_closed(Hand hand) const {
    const Axis& axis = hand_[static_cast<std::size_t>(hand)];
    return axis.latched || axis.jaws || axis.trigger >= trigger_closed || (button_ && hand == active_);
}

/// The key is held, and this hand is the one that it is for.
bool MouseKeyboardInput::key_is_for(int hand, KeyAction action) const {
    if (!held_.test(bit(action))) return false;
    const int active = static_cast<int>(active_), other = 1 - active;
    const auto used = [&](int by) {
        return action == A::pedal ? hand_[by].uses_pedal : hand_[by].uses_exchange;
    };
    return hand == (device_ == Device::of_daemon && !used(active) && used(other) ? other : active);
}

void MouseKeyboardInput::advance(double dt) {
    for (const KeyMove& move : key_moves) {
        if (!held_.test(bit(move.action))) continue;
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
        set_jaw(h);
        unsigned buttons = closed ? button_primary : button_none;
        if (hand_[h].pedal || key_is_for(h, A::pedal)) buttons |= button_energy;
        if (hand_[h].exchange || key_is_for(h, A::exchange)) buttons |= button_exchange;
        targets_.hand[h].buttons = static_cast<std::uint16_t>(buttons);
    }
    publish();
}

void MouseKeyboardInput::set_jaw(int hand) {
    const Axis& axis = hand_[hand];
    DeviceReading& reading = targets_.hand[hand];
    if (device_ == Device::controller && !axis.latched && !axis.jaws) {
        // A trigger closes by degrees, then presses.
        reading.jaw = axis.opening * std::max(0.0, 1 - axis.trigger / trigger_closed);
        reading.grip = axis.grip * std::max(0.0, axis.trigger - trigger_closed) / (1 - trigger_closed);
        return;
    }
    const bool closed = jaws_closed(static_cast<Hand>(hand));
    reading.jaw = closed ? 0 : axis.opening * open_jaw_share;
    reading.grip = closed ? axis.grip : 0;
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

}  // namespace fulcrum::ui
