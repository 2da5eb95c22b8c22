// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that have less room than they need, where neither the widget's size nor a tool tip says so.
#pragma once

#include <QStringList>

class QWidget;

namespace fulcrum::ui::window_test {

/// Visible heads of columns, tabs, number and date fields, and lines of lists that do not scroll sideways: a
/// line for each one that is cut off and is not whole in its tool tip.
QStringList cut_texts(const QWidget& all);

}  // namespace fulcrum::ui::window_test
