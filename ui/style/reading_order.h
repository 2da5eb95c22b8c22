// SPDX-License-Identifier: GPL-3.0-or-later
// Tab goes through a window as it is read. UI thread.
#pragma once

class QWidget;

namespace fulcrum::ui {

/// Gives the keyboard to the next control that is visible in `all`, or to the one before it, and scrolls
/// until it is seen: from line to line as the layouts have it. Qt's own order is that of creation, and what a
/// page fills in again comes last there, after all that is below it. False where there is no other control.
bool focus_in_reading_order(QWidget& all, bool next);

}  // namespace fulcrum::ui
