// SPDX-License-Identifier: GPL-3.0-or-later
// How each thing that the hands do is done with each kind of device (with one that has no lines of its own,
// in general words): the lines of the first steps and, for a device with handles of its own, of the help.
#pragma once

#include <QStringList>
#include <string>
#include <vector>

#include "ui/services/device_service.h"
#include "ui/theatre/hand_deeds.h"
#include "ui/theatre/key_map.h"

namespace fulcrum::ui {

/// s of work after which the first steps end, whatever was done.
inline constexpr double teaching_s = 120;

/// What moves the hands in an attempt.
struct TaughtHands {
    std::string kind = "mouse-keyboard";  ///< a name of device_table
    bool drives[hand_count + 1] = {false, false,
                                   false};  ///< left, right, scope: of a device that the daemon reads
    ClutchButton clutch = ClutchButton::none;
    int pedal = pedal_of_each_hand;  ///< SlotChoice::pedal
};

struct TaughtLine {
    HandDeed deed;
    QString line;  ///< what to do, a tab, what it does
};

/// One mouse, or a device for one of two hands: a hand is moved after the other.
bool is_one_mouse(const Scene& scene, const TaughtHands& hands);
/// What the scene needs, and the clutch of a device that has one.
HandDeeds needed_deeds(const Scene& scene, const TaughtHands& hands);
/// What the scene needs, with the keys of this map; in the order in which it is taught.
std::vector<TaughtLine> taught_lines(const Scene& scene, const TaughtHands& hands, const KeyMap& keys);
/// The help for a device that the daemon reads; `mouse`: that of mouse and keyboard, which move the hands
/// where it does not.
QStringList device_help(const Scene& scene, const TaughtHands& hands, const KeyMap& keys,
                        const QStringList& mouse);

}  // namespace fulcrum::ui
