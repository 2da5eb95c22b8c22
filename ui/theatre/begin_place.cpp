// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/begin_place.h"

#include <QCoreApplication>
#include <cmath>
#include <cstring>

#include "ui/language/language.h"

namespace fulcrum::ui {
namespace {

constexpr double close_to_ring = 0.01;  // m

QString place_text(const char* source) {
    return QCoreApplication::translate("fulcrum::begin_place", source);
}

}  // namespace

QString step_words(const Vector3& step) {
    const char* const ways[3][2] = {{QT_TRANSLATE_NOOP("fulcrum::begin_place", "%1 mm to the left"),
                                     QT_TRANSLATE_NOOP("fulcrum::begin_place", "%1 mm to the right")},
                                    {QT_TRANSLATE_NOOP("fulcrum::begin_place", "%1 mm down"),
                                     QT_TRANSLATE_NOOP("fulcrum::begin_place", "%1 mm up")},
                                    {QT_TRANSLATE_NOOP("fulcrum::begin_place", "%1 mm away from you"),
                                     QT_TRANSLATE_NOOP("fulcrum::begin_place", "%1 mm towards you")}};
    QStringList parts;
    for (int axis = 0; axis < 3; ++axis) {
        const double mm = 1e3 * step[axis];
        if (std::abs(mm) < 1) continue;
        parts << place_text(ways[axis][mm > 0 ? 1 : 0]).arg(decimal(std::abs(mm), 0));
    }
    return parts.join(QStringLiteral(", "));
}

const DeviceReadings::Slot* slot_of_hand(const DeviceReadings& readings, const SlotChoice& choice, int hand) {
    const int part = hand == 0 ? choice.left : choice.right;
    for (const DeviceReadings::Slot& slot : readings.held) {
        const int own = std::strcmp(slot.name, "left") == 0    ? 0
                        : std::strcmp(slot.name, "right") == 0 ? 1
                                                               : 2;
        if (own == part && slot.workspace) return &slot;
    }
    return nullptr;
}

QStringList BeginPlace::look(DeviceService& devices, const Scene& scene, const WorldSnapshot& at_start) {
    if (done_) return {};
    const DeviceInUse device = devices.device_in_use();
    done_ = !devices.begins_at_ring(device.kind);
    if (done_) return {};
    const auto readings = devices.device_readings();
    if (!known_) reach_ = fulcrum::scene_reach(scene, at_start);
    known_ = true;
    const double motion = devices.motion_scale(device.kind);
    const SlotChoice choice = devices.slot_choice(device.kind);
    // A fault of any hand of the device takes the force from all, which pauses an attempt.
    const bool faulty = readings && readings->gives_force && !devices.device_trouble().empty();
    QStringList lines;
    for (int h = 0; h < hand_count; ++h) {
        const auto& needs = reach_[static_cast<std::size_t>(h)];
        const DeviceReadings::Slot* const slot = readings ? slot_of_hand(*readings, choice, h) : nullptr;
        // Without readings its process has ended or does not answer: the hand is nowhere.
        const bool waits = readings ? slot != nullptr : device.drives[h];
        if (!waits || !needs) continue;
        const bool has_force = (h == 0 ? choice.left : choice.right) < hand_count;
        const QString name = h == 0 ? place_text(QT_TRANSLATE_NOOP("fulcrum::begin_place", "Left hand"))
                                    : place_text(QT_TRANSLATE_NOOP("fulcrum::begin_place", "Right hand"));
        if (slot == nullptr || !slot->present || !slot->position.allFinite()) {
            lines << place_text(QT_TRANSLATE_NOOP("fulcrum::begin_place", "%1: does not answer")).arg(name);
            continue;
        }
        if (has_force && faulty) {
            lines << place_text(QT_TRANSLATE_NOOP("fulcrum::begin_place",
                                                  "%1: no force, because the device has a fault"))
                         .arg(name);
            continue;
        }
        const Vector3 step = place_to_begin(*slot->workspace, *needs, motion) - slot->position;
        if (step.norm() > close_to_ring)
            lines << place_text(QT_TRANSLATE_NOOP("fulcrum::begin_place", "%1: move the handle %2"))
                         .arg(name, step_words(step));
    }
    done_ = lines.isEmpty();
    return lines;
}

}  // namespace fulcrum::ui
