// SPDX-License-Identifier: GPL-3.0-or-later
// What appears by itself is read out by a screen reader: messages, problems at fields, results. UI thread.
#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace fulcrum::ui {

/// Property of the widget that announces: how often it has.
inline constexpr char announced_property[] = "fulcrum_announced";

/// Has these words read out, once for each call. `from`: a widget of the window in which they are shown.
void announce(const QWidget* from, const QString& words);
/// Writes a problem into the label that is there for it, and announces it.
void announce_problem(QLabel* label, const QString& problem);
/// The same for what is looked at again and again: announced only where the words are new and are seen.
void announce_change(QLabel* label, const QString& words);

}  // namespace fulcrum::ui
