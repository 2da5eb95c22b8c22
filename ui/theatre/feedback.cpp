// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/feedback.h"

#include <algorithm>

#include "sim_core/scene/instrument_type.h"

namespace fulcrum::ui {
namespace {

constexpr double loudest_contact = 2;  // N

}  // namespace

RumbleStrength rumble_of(double force, double limit) {
    constexpr double usual_limit = 5;  // N
    if (!(force > felt_from)) return {};
    const double share = force / (limit > 0 ? limit : usual_limit);
    return {0.1 + 0.4 * std::min(1.0, share), limit > 0 && share > 1 ? 1.0 : 0.0};
}

void Feedback::follow_hand(int hand, double force, double limit) {
    const RumbleStrength one = rumble_of(force, limit);
    rumble_.slow = std::max(rumble_.slow, one.slow);
    rumble_.fast = std::max(rumble_.fast, one.fast);
    if (!touches_[hand] && force > felt_from) {
        ++sound_.contacts[hand];
        sound_.strength[hand] = std::min(1.0, force / loudest_contact);
        sound_.hard[hand] = limit > 0 ? 0 : 1;
    }
    touches_[hand] = force > (touches_[hand] ? felt_until : felt_from);
    sound_.excess[hand] = limit > 0 && force > limit ? force / limit - 1 : 0;
}

void Feedback::follow(const TaskDisplay* display, const WorldSnapshot* world) {
    rumble_ = {};
    for (int h = 0; h < hand_count; ++h) sound_.excess[h] = 0;
    sound_.energy[0] = sound_.energy[1] = sound_.bleeding = 0;
    // What a hand touches during a pause is not a new contact after it.
    if (display == nullptr || world == nullptr) return;
    for (int h = 0; h < hand_count; ++h) follow_hand(h, display->force[h], display->force_limit[h]);
    double flow = 0;
    for (const FieldView& field : world->field) {
        for (const OutletView& outlet : field.outlets) flow += outlet.flow;
        for (int h = 0; h < hand_count; ++h)
            if (field.tools[h].active && gives_energy(field.tools[h].kind)) sound_.energy[h] = 1;
    }
    sound_.bleeding = flow > alarm_flow ? 1 : 0;
}

}  // namespace fulcrum::ui
