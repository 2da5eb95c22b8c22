// SPDX-License-Identifier: GPL-3.0-or-later
// What a mouse shows and a sighted person reads next to a control is there for the keyboard and for a screen
// reader too.
#pragma once

class QApplication;

namespace fulcrum::ui {

/// From now on a tool tip is also shown where the keyboard goes: of a control to which Tab leads, and of the
/// cell or line to which the arrow keys lead. A choice has its name read when it gets the focus: on Linux Qt
/// gives the line that is chosen in place of the accessible name, unless a label is its buddy.
void aid_keyboard(QApplication& application);

}  // namespace fulcrum::ui
