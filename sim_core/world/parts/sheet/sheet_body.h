// SPDX-License-Identifier: Apache-2.0
// The sheet itself: model and state, where a place of it is now and was at rest, what is near a point, and
// what becomes of a cut in springs, places and pieces. What hands and fibres do to it is in objects of their
// own (SheetContact, SheetBlades, FibreParting), each with its own scratch; they share this one.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim_core/cutting/cut_mesh.h"
#include "sim_core/membrane/cut_membrane.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/step_events.h"
#include "sim_core/world/parts/sheet/sheet_layout.h"
#include "sim_core/world/parts/sheet/sheet_state.h"

namespace fulcrum {

class SheetBody {
  public:
    static constexpr std::size_t track_capacity = 38;  ///< samples of a blade's step
    static constexpr double slide_friction = 0.2;      ///< of a tool that does not bite
    // Both blades' tracks in the most parts that they can be reported in, four events each, and what else
    // happens in a step.
    using Events = StepEvents<static_cast<int>(hand_count * 4 * ((track_capacity + 1) / 2)) + 32>;
    /// With its corners: searches walk all of them, and the surface's rows are eight times as large.
    struct VisibleTriangle {
        std::int32_t number = -1;
        Triangle vertices;
    };

    /// Builds the sheet and lets it come to rest. Throws InputError (place "/sheet" or "/septa").
    SheetBody(const Scene& scene, double dt);

    const SheetSpec& spec() const { return spec_; }
    const std::optional<SeptaSpec>& septa() const { return septa_; }
    const TissueSpec& tissue() const { return tissue_; }  ///< of the areolar zone, or of all
    std::int16_t tissue_index() const { return tissue_index_; }
    std::int16_t fat_index() const { return fat_index_; }
    const SheetLayout& layout() const { return layout_; }
    const CutMesh& surface() const { return surface_; }
    CutMesh& surface() { return surface_; }
    const CutMembrane& membrane() const { return membrane_; }
    const SheetState& state() const { return state_; }
    SheetState& state() { return state_; }
    const CutMembraneInputs& inputs() const { return inputs_; }
    CutMembraneInputs& inputs() { return inputs_; }
    const Vector3& line_start() const { return line_start_; }
    const std::vector<double>& line_positions() const { return line_positions_; }
    const std::vector<VisibleTriangle>& visible() const { return visible_; }
    const Events& events() const { return events_; }
    std::uint32_t faults() const { return faults_; }

    /// A step that ends with this tick begins.
    void begin(std::uint32_t tick) noexcept;
    void clear_events() noexcept { events_.clear(); }
    void step_membrane(double dt) noexcept;
    /// N, sum of the edge's reactions (SheetPart::trial_edge_force).
    Vector3 trial_edge_force(int axis, double displacement, double dt);
    /// After its state was written: what is found from it.
    void follow_restore() noexcept;
    void note_fault(std::uint32_t fault) noexcept { faults_ = std::max(faults_, fault); }

    // Places.
    Vector3 place(const SheetPlace& at) const noexcept;  ///< m
    Vector3 rest(const SheetPlace& at) const noexcept;   ///< m, in the sheet's frame as SheetView::rest
    /// Whether a place at rest lies beyond the areolar tissue, in the mesorectum.
    bool in_fat(const Vector3& rest) const noexcept {
        return septa_ && rest.y() >= septa_->areolar_height - septa_->plane_height;
    }
    std::int32_t septum_of_root(std::int32_t root) const noexcept {
        return root / (surface_.root_count() / layout_.pieces);
    }
    std::int32_t septum_of(const SheetPlace& where) const noexcept {
        return where.fragment < 0 ? 0 : septum_of_root(surface_.fragment(where.fragment).root);
    }
    std::int32_t septum_at(const Vector3& rest) const noexcept {
        return septa_ ? static_cast<std::int32_t>(rest.x() / septa_->width) : 0;
    }
    Vector3 on_septum(const SheetPlace& where, Vector3 rest) const noexcept;
    SheetPlace closest(const Vector3& point) const noexcept;
    SheetPlace place_in(std::int32_t triangle, const Vector3& weights) const noexcept;
    SheetPlace find_in_root(std::int32_t root, const Vector3& barycentric, double slack) const noexcept;
    /// Of the triangles that a segment crosses, in no order, until visit(triangle, share of the way) is true.
    template <typename Visit>
    bool visit_crossings(const Vector3& from, const Vector3& to, Visit&& visit) const noexcept;
    bool crosses(const Vector3& from, const Vector3& to) const noexcept;
    bool crosses(const Vector3& from, const Vector3& to, std::int32_t septum) const noexcept;

    // Tissue.
    const CuttingSpec* cutting_at(const SheetPlace& where) const noexcept;
    double friction(const SheetAction& action) const noexcept;
    double traction_at(const Vector3& point, const Vector3& way, const Vector3& normal) const noexcept;
    void measure_station() noexcept;
    void update_positions() noexcept;

    // Cuts.
    /// With all that follows from it.
    CutReport cut(const BladeStep& blade) noexcept;
    void begin_stroke() noexcept { surface_.begin_stroke(); }
    /// A blade comes out.
    void leave(int hand, std::uint32_t tick) noexcept;
    void mark_divided(const Vector3& from, const Vector3& to) noexcept;
    void drop_loose(std::uint32_t tick) noexcept;
    void add_event(std::uint32_t tick, EventKind kind, int hand, double value, double detail,
                   bool fat = false) noexcept;
    void add_place_event(std::uint32_t tick, EventKind kind, int hand, const Vector3& at) noexcept;
    std::size_t bytes() const { return membrane_.bytes(); }

  private:
    void settle(double dt) noexcept;
    void mark_line(const SacralCurve& curve);
    void bind(std::int32_t vertex) noexcept;
    void list_visible() noexcept;
    void take_over() noexcept;
    void remake_pieces() noexcept;
    void note_loose(std::uint32_t tick) noexcept;
    bool jaws_hold(std::int32_t piece) const noexcept;

    SheetSpec spec_;
    std::optional<SeptaSpec> septa_;
    TissueSpec tissue_, fat_;
    std::int16_t tissue_index_ = -1, fat_index_ = -1;
    Vector3 line_start_ = Vector3::Zero(), gravity_ = Vector3::Zero();
    SheetLayout layout_;
    CutMesh surface_;
    CutMembrane membrane_;
    CutMembraneScratch scratch_;
    SheetState state_;
    std::vector<double> line_positions_;
    std::int32_t stations_ = 0;  ///< of one septum
    // Scratch.
    CutMembraneInputs inputs_;
    MembraneCut cut_;
    std::vector<VisibleTriangle> visible_;
    /// Places in visible_ that were closest to the last points asked for: a search that begins there looks at
    /// few others. They change no result.
    mutable std::array<std::size_t, hand_count> recent_ = {};
    std::vector<std::uint8_t> touched_;  ///< by root
    std::uint32_t faults_ = 0, tick_ = 0;
    Events events_;
};

template <typename Visit>
bool SheetBody::visit_crossings(const Vector3& from, const Vector3& to, Visit&& visit) const noexcept {
    const Vector3 way = to - from;
    for (const VisibleTriangle& t : visible_) {
        const Triangle& v = t.vertices;
        const Vector3 &a = state_.positions[sheet_rows::at(v[0])],
                      &b = state_.positions[sheet_rows::at(v[1])],
                      &c = state_.positions[sheet_rows::at(v[2])];
        const Vector3 n = (b - a).cross(c - a);
        const double before = (from - a).dot(n), after = (to - a).dot(n);
        if (before * after > 0 || before == after) continue;
        const double share = before / (before - after);
        if (blade_law::covers(from + share * way, n, a, b, c) && visit(t.number, share)) return true;
    }
    return false;
}

}  // namespace fulcrum
