// SPDX-License-Identifier: Apache-2.0
// A cut reconstructed from its events: strokes (a blade in tissue, from penetration to leaving it) that
// consist of elements, each from one reported position of the blade to the next.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "assessment/trace/trace.h"

namespace fulcrum {

/// A straight piece of a cut between two places near the marked line. Time in s, lengths in m, traction in
/// N/m. Distances are positive towards the side that is too deep.
struct CutElement {
    double begin = 0, end = 0;               ///< s
    double from = 0, to = 0;                 ///< position along the marked line
    double from_distance = 0, distance = 0;  ///< signed, from the line
    double length = 0;                       ///< as cut, by the record; else by the two places
    std::optional<double> traction;  ///< across the cut while it was made; absent where nothing says it
};

/// One blade from breaking through to leaving the tissue, or fibres that parted under tension.
struct CutStroke {
    int hand = 0;               ///< -1: fibres parted
    double begin = 0, end = 0;  ///< s; a stroke without an end event lasts to the attempt's end
    std::vector<CutElement> elements;
};

/// The strokes of both hands, and what parted by none, in the order they began. A report outside any stroke
/// begins one. Pure.
std::vector<CutStroke> cut_strokes(const std::vector<Event>& events, double tick_period, double end);

/// The part of an element, as shares of its way, that lies within `corridor` of the line; empty where first
/// is not below second.
std::pair<double, double> part_within(const CutElement& element, double corridor) noexcept;
/// Area between a straight piece and the line, m2: exact also where it crosses.
double area_beside(const CutElement& element);
/// Share of an element's length, 0 to 1, whose distance is above a limit (below: of the negated distances).
double share_beyond(const CutElement& element, double limit);
/// Length-weighted quantile of the elements' distances from the line (size or signed); each element counts as
/// the straight piece that it is, cut into `pieces_per_element`. Absent without length.
std::optional<double> distance_quantile(const std::vector<CutStroke>& strokes, double share, bool size);
/// Length of the union of the positions that elements pass within `corridor` of the line, clamped to
/// [0, length], m.
double divided_length(const std::vector<CutStroke>& strokes, double length, double corridor);
/// The part of that union which parted by no hand before any blade passed there, m. A blade that trims it
/// afterwards changes nothing.
double torn_length(const std::vector<CutStroke>& strokes, double length, double corridor);

}  // namespace fulcrum
