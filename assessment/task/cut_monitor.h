// SPDX-License-Identifier: Apache-2.0
// Follows a cut along a marked line: divided length, distance of the blade from the line, traction at the
// place that is or will be cut.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "assessment/task/task.h"
#include "assessment/trace/cut_strokes.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum {

/// Whether the traction is too low or too high.
enum class TractionFault : std::int8_t { slack = -1, none = 0, tight = 1 };

/// One attempt's cut. Allocates nothing after construction, never throws. Inactive without a divide_line
/// goal.
class CutMonitor {
  public:
    static constexpr double cell = 0.0005;  ///< m of the line that count as divided together

    CutMonitor(const TaskDefinition& task, const Scene& scene);
    /// What a step did to tissue, in order.
    void event(const Event& event) noexcept;
    /// After the step's events: the traction at the place in question.
    void look(const WorldSnapshot& world) noexcept;

    bool line() const noexcept { return goal_.has_value(); }                ///< the task marks one
    double length() const noexcept { return goal_ ? goal_->length_m : 0; }  ///< m
    /// m of the line, by a blade. What was torn is apart, but never divided.
    double divided() const noexcept { return cells_divided_ * cell_; }
    double torn() const noexcept { return cells_torn_ * cell_; }
    /// First place that is neither divided nor torn, m along the line; its length where nothing is left to
    /// divide. Bridges too narrow to be cut are skipped.
    double next() const noexcept { return first_open_ * cell_; }
    double traction() const noexcept { return traction_; }  ///< N/m
    double distance() const noexcept { return distance_; }  ///< m, signed, of the last advance
    bool cutting() const noexcept { return blade_in_[0] || blade_in_[1]; }
    /// Against the band of a goal, widened by `margin` of its limits.
    TractionFault fault(const Goal& goal, double margin) const noexcept;

    /// All that changes.
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(blade_in_, blades_, cells_, cells_divided_, cells_torn_, first_open_, traction_, distance_);
    }

  private:
    bool open_from(std::size_t from) const noexcept;
    struct Blade {
        double position = 0, distance = 0;
        bool placed = false;
    };
    std::optional<Goal> goal_;     ///< divide_line
    std::size_t level_cells_ = 1;  ///< cells of a septum; of one sheet all
    std::array<bool, hand_count> has_blade_{}, blade_in_{};
    std::array<Blade, hand_count + 1> blades_{};  ///< the last: fibres that part by no hand
    std::vector<std::uint8_t> cells_;
    std::uint32_t cells_divided_ = 0, cells_torn_ = 0, first_open_ = 0,
                  least_open_ = 1;  ///< cells of the shortest bridge that counts
    double cell_ = cell, traction_ = 0, distance_ = 0;
};

}  // namespace fulcrum
