// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/cut_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

namespace fulcrum {

namespace {

constexpr int pieces_per_element = 8;

/// One hand, or what parts by none, while its events are read.
struct Reading {
    std::optional<std::size_t> stroke;  ///< the open one
    double time = 0, position = 0, distance = 0;
    bool placed = false;  ///< a place is known from which the next element starts
};

void place(Reading& reading, double time, const Event& event) {
    reading.time = time;
    const CutPlace at = cut_place_of(event);
    reading.position = at.along;
    reading.distance = at.distance;
    reading.placed = true;
}

void open(Reading& reading, std::vector<CutStroke>& strokes, int hand, double time, double end) {
    reading.stroke = strokes.size();
    reading.placed = false;
    strokes.push_back({hand, time, std::max(time, end), {}});
}

/// The positions that an element passes within `corridor` of the line, clamped to [0, length]; absent where
/// it is nowhere within.
std::optional<std::pair<double, double>> span_of(const CutElement& element, double length, double corridor) {
    const auto [first, last] = part_within(element, corridor);
    if (last <= first) return std::nullopt;
    const double a = element.from + first * (element.to - element.from);
    const double b = element.from + last * (element.to - element.from);
    return std::pair(std::clamp(std::min(a, b), 0.0, length), std::clamp(std::max(a, b), 0.0, length));
}

/// Adds [a, b] to disjoint intervals, from begin to end, and returns how much of it was in none of them.
double add_interval(std::map<double, double>& intervals, double a, double b) {
    if (!(b > a)) return 0;
    double fresh = b - a, from = a, to = b;
    auto next = intervals.upper_bound(a);
    if (next != intervals.begin() && std::prev(next)->second >= a) --next;
    while (next != intervals.end() && next->first <= b) {
        fresh -= std::max(0.0, std::min(b, next->second) - std::max(a, next->first));
        from = std::min(from, next->first);
        to = std::max(to, next->second);
        next = intervals.erase(next);
    }
    intervals.emplace(from, to);
    return std::max(0.0, fresh);
}

}  // namespace

std::pair<double, double> part_within(const CutElement& element, double corridor) noexcept {
    double first = 0, last = 1;
    const double a = element.from_distance, b = element.distance;
    for (const double side : {1.0, -1.0}) {  // side * distance <= corridor
        const double u = side * a - corridor, v = side * b - corridor;
        if (u > 0 && v > 0) return {0, 0};
        if (u > 0) first = std::max(first, u / (u - v));
        if (v > 0) last = std::min(last, u / (u - v));
    }
    return {first, std::max(first, last)};
}

std::vector<CutStroke> cut_strokes(const std::vector<Event>& events, double tick_period, double end) {
    std::vector<CutStroke> strokes;
    std::array<Reading, hand_count + 1> readings;
    for (const Event& event : events) {
        const double time = event.tick * tick_period;
        const bool of_hand = event.hand < hand_count;
        Reading& reading = readings[of_hand ? event.hand : hand_count];
        switch (event.kind) {
            case EventKind::fibres_parted:
                open(reading, strokes, -1, time, time);
                place(reading, time, event);
                break;
            case EventKind::cut_begin:
                if (reading.stroke) strokes[*reading.stroke].end = time;
                open(reading, strokes, event.hand, time, end);
                place(reading, time, event);
                break;
            case EventKind::cut_advance: {
                if (!reading.stroke && !of_hand) break;
                if (!reading.stroke) open(reading, strokes, event.hand, time, end);
                if (reading.placed) {
                    CutElement element;
                    element.begin = reading.time;
                    element.end = time;
                    element.from = reading.position;
                    element.from_distance = reading.distance;
                    const CutPlace to = cut_place_of(event);
                    element.to = to.along;
                    element.distance = to.distance;
                    element.length =
                        std::hypot(element.to - element.from, element.distance - element.from_distance);
                    strokes[*reading.stroke].elements.push_back(element);
                }
                place(reading, time, event);
                break;
            }
            case EventKind::cut_traction:
                // It says under what traction, and how far, the blade came to the place just reported.
                if (reading.stroke && !strokes[*reading.stroke].elements.empty()) {
                    CutElement& element = strokes[*reading.stroke].elements.back();
                    const CutTraction told = cut_traction_of(event);
                    element.traction = told.traction;
                    element.length = told.length;
                }
                break;
            case EventKind::cut_end:
                if (reading.stroke) strokes[*reading.stroke].end = time;
                reading.stroke.reset();
                break;
            default:
                break;
        }
    }
    return strokes;
}

double area_beside(const CutElement& element) {
    const double a = element.from_distance, b = element.distance;
    const double width = std::abs(element.to - element.from);
    if (a * b >= 0) return 0.5 * width * std::abs(a + b);
    return 0.5 * width * (a * a + b * b) / (std::abs(a) + std::abs(b));
}

double share_beyond(const CutElement& element, double limit) {
    const double a = element.from_distance - limit, b = element.distance - limit;
    if (a > 0 && b > 0) return 1;
    if (a <= 0 && b <= 0) return 0;
    return (a > 0 ? a : b) / std::abs(a - b);
}

std::optional<double> distance_quantile(const std::vector<CutStroke>& strokes, double share, bool size) {
    struct Piece {
        double distance, length;
    };
    std::vector<Piece> pieces;
    double whole = 0;
    for (const CutStroke& stroke : strokes) {
        for (const CutElement& element : stroke.elements) {
            if (!(element.length > 0)) continue;
            for (int i = 0; i < pieces_per_element; ++i) {
                const double at = (i + 0.5) / pieces_per_element;
                const double distance =
                    element.from_distance + at * (element.distance - element.from_distance);
                pieces.push_back({size ? std::abs(distance) : distance, element.length / pieces_per_element});
            }
            whole += element.length;
        }
    }
    if (pieces.empty()) return std::nullopt;
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Piece& a, const Piece& b) { return a.distance < b.distance; });
    // Each piece stands at the middle of its own length; linear between them.
    double before = 0, last_at = 0, last_distance = pieces.front().distance;
    for (const Piece& piece : pieces) {
        const double at = before + 0.5 * piece.length;
        if (at >= share * whole) {
            const double part = at > last_at ? (share * whole - last_at) / (at - last_at) : 1.0;
            return last_distance + std::clamp(part, 0.0, 1.0) * (piece.distance - last_distance);
        }
        before += piece.length;
        last_at = at;
        last_distance = piece.distance;
    }
    return pieces.back().distance;
}

double divided_length(const std::vector<CutStroke>& strokes, double length, double corridor) {
    std::vector<std::pair<double, double>> spans;
    for (const CutStroke& stroke : strokes)
        for (const CutElement& element : stroke.elements)
            if (const auto span = span_of(element, length, corridor)) spans.push_back(*span);
    std::sort(spans.begin(), spans.end());
    double divided = 0, reached = 0;
    for (const auto& [a, b] : spans) {
        divided += std::max(0.0, b - std::max(a, reached));
        reached = std::max(reached, b);
    }
    return divided;
}

double torn_length(const std::vector<CutStroke>& strokes, double length, double corridor) {
    struct Passed {
        double time, from, to;
        bool torn;
    };
    std::vector<Passed> passed;
    for (const CutStroke& stroke : strokes)
        for (const CutElement& element : stroke.elements)
            if (const auto span = span_of(element, length, corridor))
                passed.push_back({element.end, span->first, span->second, stroke.hand < 0});
    std::stable_sort(passed.begin(), passed.end(),
                     [](const Passed& a, const Passed& b) { return a.time < b.time; });
    std::map<double, double> apart;
    double torn = 0;
    for (const Passed& one : passed) {
        const double fresh = add_interval(apart, one.from, one.to);
        if (one.torn) torn += fresh;
    }
    return torn;
}

}  // namespace fulcrum
