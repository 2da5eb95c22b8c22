// SPDX-License-Identifier: Apache-2.0
// A sheet that is held and divided, as a part of the world (docs/THEORY.md 3 to 6; Eqs. 6 and 7).
// World thread. Nothing allocates after construction.
//
// The sheet is one cuttable surface (CutMesh: what is visible, which fragments of each root hang together)
// over one membrane of springs on virtual nodes (CutMembrane: where it is). A visible vertex lies in the
// nodes of its fragment. Each step: tools find their contact, jaws and tips enter the membrane's own solve as
// links, the membrane is stepped, blades advance, and what they cut becomes fragments, nodes and springs
// before the step ends. The hand gets the solution to first order (SheetContactModel) and never waits.
// Blades: blade_law.h; jaws: jaws.h.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "sim_core/contact/jaws.h"
#include "sim_core/contact/local_model.h"
#include "sim_core/cutting/cut_mesh.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/membrane/cut_membrane.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/rod/rod.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/blade_law.h"
#include "sim_core/world/part/heated_sheet.h"
#include "sim_core/world/part/jaws.h"
#include "sim_core/world/part/part.h"
#include "sim_core/world/part/snapshot.h"
#include "sim_core/world/part/step_events.h"
#include "sim_core/world/parts/sheet/sheet_fibres.h"
#include "sim_core/world/parts/sheet/sheet_layout.h"

namespace fulcrum {

/// One hand over one step, as the sheet sees it.
struct SheetAction {
    const InstrumentSpec* instrument = nullptr;  ///< null: no such hand
    ToolKinematics tool;                         ///< at the step's last tick
    bool busy = false;                           ///< its jaws hold something else
    bool takes = true;       ///< jaws that close take hold here; false: something else is nearer
    bool energised = false;  ///< its blade is under power: it needs CuttingSpec::energy_factor of the forces
};

/// A place on the sheet that moves with it.
struct SheetPlace {
    std::int32_t fragment = -1;
    Vector3 barycentric = Vector3::Zero();  ///< in the fragment's root
    std::int32_t triangle = -1;             ///< visible one that it lies in
};

class SheetPart : public Part, public HeatedSheet {
  public:
    /// What a hand does to the sheet, remembered from step to step.
    struct HandState : BladeHand {
        SheetPlace place;                 ///< under the tip; the blade's while it cuts
        double side = 1;                  ///< of the sheet that the tip is on, by the sheet's outward normal
        double gap = 0;                   ///< m, tip to sheet on its side
        Vector3 tip = Vector3::Zero();    ///< m, at the last step
        double friction = 0, radius = 0;  ///< of the tool, at the last step; m
        bool over = false;                ///< tissue was under it then
        bool known = false;               ///< `tip` and `side` mean something
        std::int32_t septum = 0;          ///< whose side it is
        Vector3 way = Vector3::Zero();    ///< m at rest: where the blade was last
        double cut_friction = 0;          ///< N, dynamic friction of the tissue that the blade is in
        double ease = 1;      ///< share of a tissue's forces that its blade needs: less under power
        bool adrift = false;  ///< the blade is between lips, in no tissue
        Vector3 drifted = Vector3::Zero();  ///< m: where it was then at the last step's end
        // Jaws.
        Jaws jaws;
        std::array<SheetPlace, Jaws::most_points> held_at;  ///< place of each of their points
        Vector3 pull = Vector3::Zero();                     ///< N, jaws on sheet
    };
    /// All that changes; with the surface's own state a step continues from it bit for bit.
    struct State {
        CutMembraneState membrane;
        std::vector<Vector3> positions;    ///< m, by visible vertex
        std::vector<SheetPlace> bindings;  ///< by visible vertex
        std::vector<std::uint16_t> loose;  ///< steps since a fragment came free, 0: it hangs on
        std::array<HandState, hand_count> hands;
        std::vector<SheetPlace> line;  ///< points of the marked line
        std::vector<std::uint8_t> divided;
        std::vector<double> traction;
        std::int32_t next_station = 0;
        std::int32_t any_loose = 0;  ///< fragments
        SheetFibres fibres;
    };

    /// Builds the sheet and lets it come to rest. Throws InputError (place "/sheet" or "/septa").
    SheetPart(const Scene& scene, double dt);

    void begin_step() noexcept override { events_.clear(); }
    double offer(int hand, const HeldTool& held) const noexcept override;
    void apply(const StepInput& input) noexcept override;
    std::uint32_t solve(const StepInput& input) noexcept override;
    void publish_model(int hand, const TickOutput& last, LocalModel& model) noexcept override;
    void size_snapshot(WorldSnapshot& snapshot) const override;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept override;
    void list_state(StateList& list) override;
    void follow_restore() override;
    void add_costs(double us, std::vector<PartCost>& costs) const override;
    using Part::restore;

    /// Vertices that something else moves (SheetLayout::driven): target in, reaction out.
    std::vector<DrivenVertex>& edge() { return inputs_.driven; }
    /// N, sum of the edge's reactions in a step in which it is moved by a displacement (m) along an axis; -1:
    /// not moved. Changes no state.
    Vector3 trial_edge_force(int axis, double displacement, double dt);
    /// Turns every velocity off.
    void stop() noexcept;
    /// Jaws that would take hold in this step if something is within their reach.
    bool closing(int hand, const SheetAction& action) const noexcept;
    bool holds(int hand) const noexcept override {
        return state_.hands[static_cast<std::size_t>(hand)].jaws.held();
    }
    GraspState grasp(int hand) const noexcept override;
    bool slipped(int hand) const noexcept override {
        return state_.hands[static_cast<std::size_t>(hand)].jaws.slipped();
    }
    const HeatedSheet* heated_sheet() const noexcept override { return this; }
    const TriangleMesh& mesh() const noexcept override { return surface_.mesh(); }
    const std::vector<Vector3>& vertices_now() const noexcept override { return state_.positions; }
    bool root_in_fat(std::int32_t root) const override;
    SheetUnder under(int hand) const noexcept override;

    /// First half of a step of dt seconds that ends with this tick: jaws and tips on the sheet.
    void apply(const SheetAction* actions, std::uint32_t tick, double dt) noexcept;
    /// Second half: the membrane, then blades. Returns StepRecord::outcome.
    std::uint32_t solve(const SheetAction* actions, std::uint32_t tick, double dt) noexcept;
    std::uint32_t step(const SheetAction* actions, std::uint32_t tick, double dt) noexcept {
        apply(actions, tick, dt);
        return solve(actions, tick, dt);
    }

    const State& state() const { return state_; }
    const CutMesh& surface() const { return surface_; }
    const CutMembrane& membrane() const { return membrane_; }
    const CutMembraneInputs& inputs() const { return inputs_; }
    const SheetLayout& layout() const { return layout_; }
    /// State and surface of a part made for the same scene.
    void restore(const State& state, const CutState& surface);
    const Event* events() const { return events_.data(); }
    int event_count() const { return events_.count(); }
    std::size_t bytes() const;
    Vector3 place(const SheetPlace& at) const noexcept;  ///< m
    Vector3 rest(const SheetPlace& at) const noexcept;   ///< m, in the sheet's frame as SheetView::rest
    /// Whether a place at rest lies beyond the areolar tissue, in the mesorectum.
    bool in_fat(const Vector3& rest) const noexcept {
        return septa_ && rest.y() >= septa_->areolar_height - septa_->plane_height;
    }

    /// A cut along a blade's step, with all that follows from it; for studies and tests as for the hands.
    CutReport cut(const BladeStep& blade) noexcept;

  private:
    /// Tissue under a point of a blade, nearest first: a sheet may lie in folds, of which the blade divides
    /// one.
    struct UnderBlade {
        struct Layer {
            Vector3 rest = Vector3::Zero();
            std::int32_t root = -1;
            double away = 0;  ///< along the normal, of twice the blade's reach
        };
        static constexpr std::size_t capacity = 3;
        std::size_t count = 0;
        double beside = 0;  ///< m along the surface, from the point to what the blade's width alone reaches
        std::array<Layer, capacity> layers;
    };
    /// A blade's step before it divides anything.
    struct BladeTrack {
        static constexpr std::size_t capacity = 38;
        std::size_t count = 0;
        double spacing = 0;  ///< m between its samples; the first lies where the step begins
        std::array<UnderBlade, capacity> samples;
    };
    struct Near {
        SheetPlace place;
        Vector3 point = Vector3::Zero(), normal = Vector3::UnitZ();
        double distance = 0, gap = 0, cover = 0;
    };
    Near find_near(const Vector3& tip, double radius) noexcept;
    SheetPlace closest(const Vector3& point) const noexcept;
    SheetPlace find_in_root(std::int32_t root, const Vector3& barycentric, double slack) const noexcept;
    SheetPlace place_in(std::int32_t triangle, const Vector3& weights) const noexcept;
    /// Of the triangles that a segment crosses, in no order, until visit(triangle, share of the way) is true.
    template <typename Visit>
    bool visit_crossings(const Vector3& from, const Vector3& to, Visit&& visit) const noexcept;
    bool crosses(const Vector3& from, const Vector3& to) const noexcept;
    /// What lies within a depth (m) along a normal, either side.
    void find_under(const Vector3& point, const Vector3& normal, double depth,
                    UnderBlade& found) const noexcept;
    void add_under(const SheetPlace& where, double away, UnderBlade& found) const noexcept;
    void approach(int hand, const SheetAction& action, std::uint32_t tick, double dt) noexcept;
    struct Approach;  // the blade law's tissue, before the sheet is solved and after
    struct Follow;
    bool has_lost(const HandState& hand) const noexcept;
    void update_jaws(int hand, const SheetAction& action, double dt) noexcept;
    double area_in(const JawBox& box) const noexcept;
    void take(int hand, const SheetAction& action) noexcept;
    void add_links(const SheetAction* actions) noexcept;
    void read_links() noexcept;
    void follow(int hand, const SheetAction& action, std::uint32_t tick) noexcept;
    void advance(int hand, const Vector3& way, std::uint32_t tick) noexcept;
    void enter(int hand, const Vector3& here, const Vector3& along, std::uint32_t tick) noexcept;
    void drift(int hand, std::uint32_t tick) noexcept;
    void leave(int hand, std::uint32_t tick) noexcept;
    void take_over() noexcept;
    void note_loose(std::uint32_t tick) noexcept;
    void drop_loose(std::uint32_t tick) noexcept;
    void mark_divided(const Vector3& from, const Vector3& to) noexcept;
    void measure_station() noexcept;
    // sheet_fibres.cpp
    bool along_line(const SheetPlace& where, Vector3& way, Vector3& normal) const noexcept;
    void begin_ends(int hand) noexcept;
    void move_ends(int hand, const Vector3& from, const Vector3& reached) noexcept;
    SheetFibres::Tip find_end(const Vector3& reached, double direction) const noexcept;
    void part_fibres(std::uint32_t tick, double dt) noexcept;
    bool open_fibres(std::int32_t station, std::uint32_t tick) noexcept;
    bool part(const SheetPlace& here, const Vector3& begin, const Vector3& way, const Vector3& normal,
              double run, double traction, std::uint32_t tick, Vector3& reached) noexcept;
    void update_positions() noexcept;
    void list_visible() noexcept;
    void settle(double dt) noexcept;
    void mark_line(const SacralCurve& curve);
    const CuttingSpec* cutting_at(const SheetPlace& where) const noexcept;
    std::int32_t septum_of(const SheetPlace& where) const noexcept {
        return where.fragment < 0
                   ? 0
                   : surface_.fragment(where.fragment).root / (surface_.root_count() / layout_.pieces);
    }
    std::int32_t septum_at(const Vector3& rest) const noexcept {
        return septa_ ? static_cast<std::int32_t>(rest.x() / septa_->width) : 0;
    }
    Vector3 on_septum(const SheetPlace& where, Vector3 rest) const noexcept;
    Vector3 begin_of_way(const SheetPlace& where, const Vector3& behind,
                         const Vector3& normal) const noexcept;
    void report_cut(int hand, const Vector3& reached, double traction, std::uint32_t tick) noexcept;
    void follow_track(const BladeStep& blade, BladeTrack& track) const noexcept;
    static bool over_tissue(const UnderBlade& sample) noexcept;
    bool meets_tissue(const SheetPlace& from, const BladeTrack& track) const noexcept;
    bool joined(const UnderBlade::Layer& a, const UnderBlade::Layer& b) const noexcept;
    const UnderBlade::Layer* divided_of(const UnderBlade& sample) const noexcept;
    void report_track(int hand, const BladeTrack& track, double traction, std::uint32_t tick) noexcept;
    Vector3 keep_off_wall(const SheetPlace& where, const Vector3& way) const noexcept;
    void remake_pieces() noexcept;
    bool jaws_hold(std::int32_t piece) const noexcept;
    void fill_touch(const HandState& hand, SheetContactModel& model) const noexcept;
    void fill_grasp(const HandState& hand, LocalModel& model) const noexcept;
    double friction(const SheetAction& action) const noexcept;
    void bind(std::int32_t vertex) noexcept;
    double traction_at(const Vector3& point, const Vector3& way, const Vector3& normal) const noexcept;
    void add_event(std::uint32_t tick, EventKind kind, int hand, double value, double detail,
                   bool fat = false) noexcept;
    void add_place_event(std::uint32_t tick, EventKind kind, int hand, const Vector3& at) noexcept;

    SheetSpec spec_;
    std::optional<SeptaSpec> septa_;
    TissueSpec tissue_, fat_;  ///< of the areolar zone, or of all; of the fat
    std::int16_t tissue_index_ = -1, fat_index_ = -1;
    Vector3 line_start_ = Vector3::Zero(), gravity_ = Vector3::Zero();
    SheetLayout layout_;
    CutMesh surface_;
    CutMembrane membrane_;
    CutMembraneScratch scratch_;
    State state_;
    std::vector<double> line_positions_;
    std::int32_t stations_ = 0;  ///< of one septum
    // Scratch.
    CutMembraneInputs inputs_;
    SheetAction actions_[hand_count];  ///< of the step
    std::array<int, hand_count> tip_link_ = {-1, -1}, jaw_link_ = {-1, -1};
    MembraneCut cut_;
    /// With its corners: searches walk all of them, and the surface's rows are eight times as large.
    struct VisibleTriangle {
        std::int32_t number = -1;
        Triangle vertices;
    };
    std::vector<VisibleTriangle> visible_, near_;
    /// Places in visible_ that were closest to the last points asked for: a search that begins there looks at
    /// few others. They change no result.
    mutable std::array<std::size_t, hand_count> recent_ = {};
    std::vector<std::uint8_t> touched_;  ///< by root
    std::uint32_t faults_ = 0, tick_ = 0;
    // Both blades' tracks in the most parts that they can be reported in, four events each, and what else
    // happens in a step.
    StepEvents<static_cast<int>(hand_count * 4 * ((BladeTrack::capacity + 1) / 2)) + 32> events_;
};

std::unique_ptr<Part> build_sheet_part(const Scene& scene, std::uint64_t seed, const PartList& parts);

}  // namespace fulcrum
