// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/hand_deeds.h"

#include <algorithm>
#include <cmath>

#include "sim_core/scene/instrument_type.h"

namespace fulcrum::ui {
namespace {

// More than a hand that rests does.
constexpr double least_swing = 0.035;                             // rad, of the shaft
constexpr double least_depth = 5e-3;                              // m
constexpr double least_turn = 0.2;                                // rad
constexpr double least_use = 5e-3;                                // m, of the handle
constexpr double deed_open_share = 0.5, deed_closed_share = 0.3;  // of the opening

template <typename Test>
bool any_kind(const InstrumentSpec* spec, Test&& test) {
    if (spec == nullptr) return false;
    if (spec->exchange.empty()) return test(type_of(spec->kind));
    return std::any_of(spec->exchange.begin(), spec->exchange.end(),
                       [&](InstrumentKind kind) { return test(type_of(kind)); });
}

bool has_jaws(const InstrumentSpec* spec) {
    return any_kind(spec, [](const InstrumentType& type) { return type.jaws; });
}

Vector3 place_of(const DeviceSample& sample) {
    return device_length_unit * Vector3(sample.handle[0], sample.handle[1], sample.handle[2]);
}

/// Its tip is not the same all around.
bool has_sides(const InstrumentSpec* spec) {
    return any_kind(
        spec, [](const InstrumentType& type) { return type.jaws || type.blade != InstrumentBlade::none; });
}

}  // namespace

bool uses_pedal(const Scene& scene, Hand hand) {
    return any_kind(scene.instrument(hand), [](const InstrumentType& type) {
        return type.energy != InstrumentEnergy::none || type.suction;
    });
}

bool uses_exchange(const Scene& scene, Hand hand) {
    const InstrumentSpec* const spec = scene.instrument(hand);
    return spec != nullptr && spec->exchange.size() > 1;
}

HandDeeds needed_deeds(const Scene& scene, bool one_mouse) {
    HandDeeds needed;
    needed.set(bit_of(HandDeed::scope_moved), scene.camera.has_value());
    if (scene.instruments.empty()) {
        if (scene.camera)
            for (const HandDeed deed : {HandDeed::inserted, HandDeed::post_turned, HandDeed::head_turned})
                needed.set(bit_of(deed));
        return needed;
    }
    needed.set(bit_of(HandDeed::moved));
    needed.set(bit_of(HandDeed::inserted));
    needed.set(bit_of(HandDeed::other_hand), one_mouse && scene.instruments.size() > 1);
    for (const InstrumentSpec& spec : scene.instruments) {
        if (has_sides(&spec)) needed.set(bit_of(HandDeed::rolled));
        if (has_jaws(&spec)) needed.set(bit_of(HandDeed::jaws_closed));
        if (uses_pedal(scene, spec.hand)) needed.set(bit_of(HandDeed::pedal));
        if (uses_exchange(scene, spec.hand)) needed.set(bit_of(HandDeed::exchanged));
    }
    return needed;
}

HandWatch::HandWatch(const Scene& scene) : scope_alone_(scene.instruments.empty()) {
    for (auto& mask : done_) mask = 0;
    for (int h = 0; h < hand_count; ++h) {
        const auto hand = static_cast<Hand>(h);
        const InstrumentSpec* const spec = scene.instrument(hand);
        Part& part = part_[static_cast<std::size_t>(h)];
        part.exists = spec != nullptr;
        part.has_jaws = has_jaws(spec);
        part.has_pedal = uses_pedal(scene, hand);
        part.has_exchange = uses_exchange(scene, hand);
        if (spec != nullptr) part.opening = spec->jaw_opening;
    }
    part_[hand_count].exists = scene.camera.has_value();
}

bool HandWatch::is_use(Part& part, const DeviceSample& sample) noexcept {
    if (!part.marked) {
        part.marked = true;
        part.mark = sample;
        return false;
    }
    const double moved = (place_of(sample) - place_of(part.mark)).norm();
    if (moved < least_use && sample.buttons == part.mark.buttons) return false;
    part.mark = sample;
    return true;
}

void HandWatch::see_part(Part& part, const DeviceSample& sample) noexcept {
    if (!part.exists || sample.present == 0 || sample.faulty != 0) return;
    if (is_use(part, sample))
        uses_.store(uses_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    if (!part.begun) {
        part.begun = true;
        part.first = sample;
    }
    const Vector3 now = place_of(sample), then = place_of(part.first);
    const double reach = now.norm() * then.norm();
    const auto note = [&part](HandDeed deed) { part.mask |= 1U << bit_of(deed); };
    if (reach > 0 && now.cross(then).norm() > least_swing * reach) note(HandDeed::moved);
    if (std::abs(now.norm() - then.norm()) > least_depth) note(HandDeed::inserted);
    if (device_angle_unit * std::abs(sample.roll - part.first.roll) > least_turn) note(HandDeed::rolled);
    if ((sample.buttons & button_clutch) != 0) note(HandDeed::clutched);
    const double jaw = device_angle_unit * sample.jaw;
    if (&part == &part_[hand_count]) {
        if (std::abs(jaw - device_angle_unit * part.first.jaw) > least_turn) note(HandDeed::head_turned);
        return;
    }
    if (jaw > deed_open_share * part.opening) part.was_open = true;
    if (part.has_jaws && part.was_open && jaw < deed_closed_share * part.opening) note(HandDeed::jaws_closed);
    if (part.has_pedal && (sample.buttons & button_energy) != 0) note(HandDeed::pedal);
    if (part.has_exchange && (sample.buttons & button_exchange) != 0) note(HandDeed::exchanged);
}

void HandWatch::see(const RigSample& sample) noexcept {
    const std::uint32_t restarts = restarts_.load(std::memory_order_relaxed);
    const bool restarted = restarts != seen_restarts_.load(std::memory_order_relaxed);
    if (restarted) {
        for (Part& part : part_) {
            part.begun = part.was_open = false;
            part.mask = 0;
        }
    }
    for (std::size_t i = 0; i < part_.size(); ++i) {
        see_part(part_[i], i < hand_count ? sample.hand[i] : sample.camera);
        done_[i].store(part_[i].mask, std::memory_order_relaxed);
    }
    if (restarted) seen_restarts_.store(restarts, std::memory_order_release);
}

HandDeeds HandWatch::done(bool one_mouse) const {
    HandDeeds all;
    if (seen_restarts_.load(std::memory_order_acquire) != restarts_.load(std::memory_order_relaxed))
        return all;
    const HandDeeds scope(done_[hand_count].load(std::memory_order_relaxed));
    const auto did = [&scope](HandDeed deed) { return scope.test(bit_of(deed)); };
    if (scope_alone_) {
        all.set(bit_of(HandDeed::scope_moved), did(HandDeed::moved));
        all.set(bit_of(HandDeed::inserted), did(HandDeed::inserted));
        all.set(bit_of(HandDeed::post_turned), did(HandDeed::rolled));
        all.set(bit_of(HandDeed::head_turned), did(HandDeed::head_turned));
        all.set(bit_of(HandDeed::clutched), did(HandDeed::clutched));
        return all;
    }
    bool each = true, any = false;
    for (std::size_t h = 0; h < hand_count; ++h) {
        const HandDeeds hand(done_[h].load(std::memory_order_relaxed));
        const bool moved = hand.test(bit_of(HandDeed::moved));
        any = any || moved;
        each = each && (moved || !part_[h].exists);
        all |= hand;
    }
    all.set(bit_of(HandDeed::moved), one_mouse ? any : each);
    all.set(bit_of(HandDeed::other_hand), one_mouse && each);
    all.set(bit_of(HandDeed::scope_moved), did(HandDeed::moved) || did(HandDeed::inserted));
    if (did(HandDeed::clutched)) all.set(bit_of(HandDeed::clutched));
    return all;
}

}  // namespace fulcrum::ui
