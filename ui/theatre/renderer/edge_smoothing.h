// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth edges of instruments and targets where the renderer takes one sample a pixel: the shape of each edge
// is read from its steps, and pixels along it are mixed with their neighbours (morphological anti-aliasing,
// Reshetov 2009). Cost grows with the length of the edges.
#pragma once

#include <QImage>

namespace fulcrum::ui {

/// Copies `drawn`, whose first row is the lowest of the picture, into `shown`, whose first row is the
/// highest. The alpha of a pixel says what is drawn there; an edge is where it changes. Both RGB32, of the
/// same size; `shown` gets alpha 255.
void copy_with_smooth_edges(const QImage& drawn, QImage& shown);
/// The same without touching an edge.
void copy_upright(const QImage& drawn, QImage& shown);

}  // namespace fulcrum::ui
