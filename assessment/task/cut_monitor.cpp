// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/cut_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double bridge = 0.003;  // m at a rim or between two strokes
// What became of a cell of the line; the first stays.
constexpr std::uint8_t open_cell = 0, divided_cell = 1, torn_cell = 2;
constexpr double blade_reach = 0.02;  // m, a blade further from the line is not about to cut it

}  // namespace

CutMonitor::CutMonitor(const TaskDefinition& task, const Scene& scene) {
    for (const Goal& goal : task.goals)
        if (goal.kind == GoalKind::divide_line && !goal_) goal_ = goal;
    if (!goal_) return;
    const auto count = static_cast<std::size_t>(std::max(1.0, std::round(goal_->length_m / cell)));
    cells_.assign(count, open_cell);
    cell_ = goal_->length_m / static_cast<double>(count);
    level_cells_ = count;
    least_open_ = static_cast<std::uint32_t>(std::max(1L, std::lround(bridge / cell_)));
    if (scene.septa)
        level_cells_ = static_cast<std::size_t>(std::max(1L, std::lround(scene.septa->width / cell_)));
    for (const InstrumentSpec& spec : scene.instruments)
        has_blade_[static_cast<std::size_t>(spec.hand)] = spec.cuts();
}

void CutMonitor::event(const Event& event) noexcept {
    if (!goal_) return;
    const bool of_hand = event.hand < hand_count;
    Blade& blade = blades_[of_hand ? event.hand : hand_count];
    if (event.kind == EventKind::cut_end) {
        if (of_hand) blade_in_[event.hand] = false;
        blade.placed = false;
        return;
    }
    const bool begins = event.kind == EventKind::cut_begin || event.kind == EventKind::fibres_parted;
    if (!begins && event.kind != EventKind::cut_advance) return;
    if (of_hand) blade_in_[event.hand] = true;
    CutElement element;
    element.from = blade.position;
    element.from_distance = blade.distance;
    const CutPlace place = cut_place_of(event);
    element.to = blade.position = place.along;
    element.distance = blade.distance = place.distance;
    if (of_hand) distance_ = blade.distance;
    const bool went_on = blade.placed && !begins;
    blade.placed = true;
    if (!went_on) return;
    const auto [first, last] = part_within(element, goal_->corridor_m);
    if (last <= first) return;
    const double a = element.from + first * (element.to - element.from);
    const double b = element.from + last * (element.to - element.from);
    const double count = static_cast<double>(cells_.size());
    // A cell is apart when its middle was passed.
    const auto cell_from = [&](double along) {
        return static_cast<std::size_t>(std::clamp(std::ceil(along / cell_ - 0.5), 0.0, count));
    };
    for (std::size_t i = cell_from(std::min(a, b)); i < cell_from(std::max(a, b)); ++i) {
        if (cells_[i] != open_cell) continue;
        cells_[i] = of_hand ? divided_cell : torn_cell;
        (of_hand ? cells_divided_ : cells_torn_) += 1U;
    }
    while (first_open_ < cells_.size() && !open_from(first_open_)) ++first_open_;
}

bool CutMonitor::open_from(std::size_t from) const noexcept {
    // A bridge ends where its level does.
    const std::size_t end = std::min(cells_.size(), (from / level_cells_ + 1) * level_cells_);
    std::size_t open = 0;
    while (open < least_open_ && from + open < end && cells_[from + open] == open_cell) ++open;
    return open >= least_open_;
}

void CutMonitor::look(const WorldSnapshot& world) noexcept {
    traction_ = 0;
    if (!goal_) return;
    const SheetView& sheet = world.sheet;
    const std::size_t count =
        std::min({sheet.line.size(), sheet.line_positions.size(), sheet.line_traction.size()});
    const auto open = [&](std::size_t i) {
        return i >= sheet.line_divided.size() || sheet.line_divided[i] == 0;
    };
    // Where a blade is near, there; else where the line is next to be divided.
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t h = 0; h < hand_count; ++h) {
        if (!has_blade_[h] || !world.tools[h].inside) continue;
        for (std::size_t i = 0; i < count; ++i) {
            const double away = (sheet.line[i] - world.tools[h].tip).norm();
            if (!open(i) || away >= std::min(nearest, blade_reach)) continue;
            nearest = away;
            traction_ = sheet.line_traction[i];
        }
    }
    if (nearest < blade_reach) return;
    for (std::size_t i = 0; i < count; ++i) {
        const double away = std::abs(sheet.line_positions[i] - next());
        if (!open(i) || away >= nearest) continue;
        nearest = away;
        traction_ = sheet.line_traction[i];
    }
}

TractionFault CutMonitor::fault(const Goal& goal, double margin) const noexcept {
    if (goal.traction_high_n_m <= goal.traction_low_n_m) return TractionFault::none;
    if (traction_ < goal.traction_low_n_m * (1 - margin)) return TractionFault::slack;
    if (traction_ > goal.traction_high_n_m * (1 + margin)) return TractionFault::tight;
    return TractionFault::none;
}

}  // namespace fulcrum
