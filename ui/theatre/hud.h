// SPDX-License-Identifier: GPL-3.0-or-later
// The head-up display over the scope's picture: time, current goal, force bars with their limits, warnings.
// Painted with QPainter in the black corners next to the round image; nothing smaller than 12 pt.
#pragma once

#include <QFont>
#include <QRectF>
#include <QString>

#include "assessment/task/monitor.h"
#include "assessment/task/task.h"
#include "sim_core/numerics/types.h"
#include "sim_core/world/part/field_view.h"

class QPainter;

namespace fulcrum {
struct Scene;
}

namespace fulcrum::ui {

struct HudState {
    const TaskDefinition* task = nullptr;
    TaskDisplay display;
    bool assessed = false;
    bool became_practice =
        false;  ///< a device was lost, or the program stood still: it does not count any more
    Hand active_hand = Hand::right;
    bool shows_active_hand = false;  ///< mouse: which hand it moves
    bool force_felt = true;
    bool hands = true;       ///< the scene has instruments; without, the scope alone is held
    double wanted_size = 0;  ///< rad, angular radius of a target of the wanted size; 0: none is to be framed
    double field_of_view = 0;  ///< rad, of the round image
    bool jaws_closed[hand_count] = {false, false};
    bool has_jaws[hand_count] = {true, true};  ///< a probe has none
    QString tool[hand_count];  ///< what the hand holds where instruments are exchanged, "" elsewhere
    bool tool_active[hand_count] = {false, false};  ///< its energy or suction is on
    QString next_key, pedal_key;  ///< names of the person's keys for the next instrument and the pedal
    QString health;               ///< small line at the foot, "" none
    QString place;                ///< where it happens: "replay ×0.5" instead of the mode, "" live
};

/// In pixels of the layout: points at 96 to the inch.
QFont hud_font(double points, bool bold = false);
/// The layout is made for text at 96 dots per inch in a picture of at least this size; the painter's scale
/// makes both follow the desktop's text size and the window's, as far as the picture has room. What is to be
/// painted on, in its units.
QRectF scaled_to_text(QPainter& painter, const QRectF& area, QSizeF smallest);
/// Sets what the HUD shows of the scope's work in this scene.
void set_scope(HudState& hud, const Scene& scene);
/// In words: "shears", "clip applier, 5 clips", "suction, in 1.2 s".
QString tool_words(const HandToolView& tool);

/// px: so much height texts and bars of force need above what covers the foot of their area.
inline constexpr double hud_height_above = 420;
/// `covered`: px at the foot that are under something else. What is drawn in the round image keeps its place;
/// texts and bars are above, smaller where that is needed.
void paint_hud(QPainter& painter, const QRectF& area, const HudState& state, double covered = 0);
/// A dimmed cover with a heading and lines in the middle: pause, device lost, help.
void paint_cover(QPainter& painter, const QRectF& area, const QString& heading, const QStringList& lines);

}  // namespace fulcrum::ui
