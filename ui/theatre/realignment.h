// SPDX-License-Identifier: GPL-3.0-or-later
// Ghosts of instruments: of an expert during practice; and the way back after a device was lost: instruments
// in their last pose as ghosts, the devices where they are, and how far it is.
#pragma once

#include <QRectF>

#include "sim_core/scene/scene.h"
#include "ui/services/attempt_session.h"
#include "ui/theatre/renderer/scene_renderer.h"

class QPainter;

namespace fulcrum::ui {

/// Turns the frame's instruments into ghosts and adds an instrument where each device is.
void add_ghosts(SceneFrame& frame, const Scene& scene, const Realignment& realignment);
/// Adds an expert's instruments as ghosts.
void add_ghost(SceneFrame& frame, const Scene& scene, const GhostPoint& ghost);
/// The box with one line a hand: its distance and angle, or that it is in place; and what to do next. As
/// large as the text that the person chose, where the area has room.
void paint_realignment(QPainter& painter, const QRectF& area, const Realignment& realignment);

}  // namespace fulcrum::ui
