// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the lines of help that several devices have.
#pragma once

#include <QStringList>

#include "ui/theatre/key_map.h"

namespace fulcrum::ui {

QString mouse_button_words(bool left);
/// The keys with which the scope looks around.
QString look_words(const KeyMap& keys);
/// The scope with keys.
QStringList scope_lines(const KeyMap& keys);
QString sound_line(const KeyMap& keys);
QString pause_line();

}  // namespace fulcrum::ui
