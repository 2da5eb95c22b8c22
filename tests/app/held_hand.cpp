// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/held_hand.h"

#include <QtTest>
#include <algorithm>

#include "app/live/device_rig.h"
#include "sim_core/instrument/instrument.h"
#include "tests/app/mouse_hand.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::app::program_test {
namespace {

constexpr double pushed_ahead = 12e-3;       // m of the handle, of a device whose deflection is a speed
constexpr int longest_exchange_press = 300;  // ms
constexpr double jaws_close_within = 150;    // ms, as jaws that a button closes
constexpr double exactly = 2e-4;             // m: what is left stays as an offset
constexpr int shift_is_seen_after = 200;     // ms, on the screen
enum HeldPart : int { held_jaws, held_pedal, held_exchange };

}  // namespace

HeldHand::HeldHand(ui::TheatrePage& theatre, ObservingRig& mind, HeldDevice& device)
    : PosedHand(
          theatre, mind, [&device](int hand, const Vector3& position) { device.put(hand, position); },
          device.begin(), {}, device.is_pushed ? pushed_ahead : std::numeric_limits<double>::infinity()),
      device_(device) {}

void HeldHand::let_go() {
    for (int h = 0; h < hand_count; ++h) {
        hold(h, {});
        device_.put(h, device_.begin());
    }
    if (theatre_.session() == nullptr) return;
    hold_key(pedal_key_, Qt::Key_B, false);
    hold_key(exchange_key_, Qt::Key_T, false);
}

bool HeldHand::has(int hand, ui::HandDeed deed) const {
    return device_.moves[hand] && device_.own.test(ui::bit_of(deed));
}

void HeldHand::hold(int hand, const HeldParts& parts) {
    HeldParts& held = held_[hand];
    const auto note = [&](HeldPart part, bool before, bool now) {
        if (before == now) return false;
        note_hold(10 * hand + part, now);
        ++events_;
        return true;
    };
    const bool jaws = note(held_jaws, held.closed, parts.closed);
    const bool pedal = note(held_pedal, held.energy, parts.energy);
    const bool exchange = note(held_exchange, held.exchange, parts.exchange);
    const bool moved = held.open != parts.open;
    held = parts;
    if (jaws || moved || pedal || exchange) device_.hold(hand, parts);
}

void HeldHand::hold_key(bool& held, int key, bool wanted) {
    if (held == wanted) return;
    held = wanted;
    wanted ? QTest::keyPress(theatre_.view(), static_cast<Qt::Key>(key))
           : QTest::keyRelease(theatre_.view(), static_cast<Qt::Key>(key));
    ++events_;
}

/// Until the exchange begins, or is refused: then the mind asks again.
bool HeldHand::exchanges(int hand) {
    const auto& field = theatre_.session()->snapshot().field;
    if (field.empty() || field[0].tools[hand].exchange_left > 0) asks_exchange_[hand] = false;
    QElapsedTimer& asked = exchange_asked_[hand];
    if (asks_exchange_[hand] && !asked.isValid()) asked.start();
    if (asked.isValid() && asked.elapsed() > longest_exchange_press) asks_exchange_[hand] = false;
    if (!asks_exchange_[hand]) asked.invalidate();
    return asks_exchange_[hand];
}

/// Of a handle that is closed or opened at a hand's pace.
double HeldHand::opening(int hand, bool closed) {
    QElapsedTimer& since = since_jaws_[hand];
    const double step = since.isValid() ? static_cast<double>(since.elapsed()) / jaws_close_within : 0;
    since.start();
    open_[hand] += std::clamp((closed ? 0.0 : 1.0) - open_[hand], -step, step);
    return open_[hand];
}

void HeldHand::use(int hand, const HeldParts& wanted) {
    const bool jaws = has(hand, ui::HandDeed::jaws_closed), pedal = has(hand, ui::HandDeed::pedal),
               exchange = has(hand, ui::HandDeed::exchanged);
    HeldParts own;
    own.closed = jaws && wanted.closed;
    own.open = jaws ? wanted.open : 1;
    own.energy = pedal && wanted.energy;
    own.exchange = exchange && wanted.exchange;
    if (device_.moves[hand]) hold(hand, own);
    const auto which = static_cast<Hand>(hand);
    if (!jaws && wanted.closed != theatre_.input()->jaws_closed(which)) {
        QTest::keyClick(theatre_.view(), hand == 0 ? Qt::Key_X : Qt::Key_M);
        ++events_;
    }
    // The keys are for the hand that has a use for them.
    const Scene& scene = theatre_.session()->scene();
    if (!pedal && ui::uses_pedal(scene, which)) hold_key(pedal_key_, Qt::Key_B, wanted.energy);
    if (!exchange && ui::uses_exchange(scene, which)) hold_key(exchange_key_, Qt::Key_T, wanted.exchange);
}

void HeldHand::push(int h) {
    const ui::AttemptSession& session = *theatre_.session();
    HeldParts wanted;
    wanted.closed = wants_closed(session, wish_, h);
    wanted.open = opening(h, wanted.closed);
    wanted.energy = (wish_.hand[h].buttons & button_energy) != 0;
    wanted.exchange = exchanges(h);
    use(h, wanted);
    if (!device_.moves[h]) {
        keep_pointer_in(*theatre_.view());
        if (theatre_.session() == nullptr) return;  // it ended there
        events_ += bring_by_mouse(theatre_, handle(h), handle_of(wish_.hand[h]),
                                  theatre_.session()->scene().instrument(static_cast<Hand>(h))->trocar);
    } else if (device_.is_pushed) {  // again and again: a cap that sends nothing is let go
        device_.put(h, DeviceRig::turned(handle_of(wish_.hand[h]) - handle(h)));
        ++events_;
    } else {
        PosedHand::push(h);
    }
}

bool HeldHand::brings_back(const ui::Realignment& now) {
    if (since_shift_.isValid() && since_shift_.elapsed() < shift_is_seen_after) return true;
    bool shifted = false;
    for (int h = 0; h < hand_count; ++h) {
        const ui::Realignment::OneHand& one = now.hand[h];
        if (!one.exists || !device_.moves[h] || one.distance <= exactly) continue;
        shift(h, handle(h) - handle_in(h, one.device));
        shifted = true;
    }
    if (shifted) since_shift_.start();
    return shifted;
}

void HeldHand::come_back() {
    if (theatre_.session()->phase() != ui::AttemptPhase::device_lost) return;
    const ui::Realignment now = theatre_.view()->realignment().value_or(ui::Realignment());
    if (!now.back) return;
    if (device_.is_pushed) {
        if (!now.in_place) device_.go_back(now.hand[0].distance);
    } else if (brings_back(now)) {
        return;
    }
    if (!now.in_place) return;
    QTest::keyClick(theatre_.view(), Qt::Key_Return);
    ++events_;
}

/// By what the screen shows: on the shaft's line, outside.
Vector3 HeldHand::handle(int hand) const {
    if (!device_.moves[hand]) return WorkingHand::handle(hand);
    return handle_in(hand, theatre_.session()->snapshot().tools[hand]);
}

Vector3 HeldHand::handle_in(int hand, const ToolPose& now) const {
    const ui::AttemptSession& session = *theatre_.session();
    const TrocarSpec& trocar = session.scene().instrument(static_cast<Hand>(hand))->trocar;
    return make_trocar(trocar).rotation.transpose() * (now.tip - trocar.shaft_length * now.axis - now.trocar);
}

}  // namespace fulcrum::app::program_test
