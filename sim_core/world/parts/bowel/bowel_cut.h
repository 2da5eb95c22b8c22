// SPDX-License-Identifier: Apache-2.0
// Blades in the bowel's wall, as a part of BowelPart where the bowel's tissue has `cutting`: what of the
// surface is left (CutSkin), what each hand's tool does to it by blade_law.h, what comes of it for the
// contact and for the hand.
//
// The skin's triangles stay the contact's ground, because what a cut leaves lies in them: a cut vertex
// follows the cage in its root. What was taken away carries nothing: a contact answers by its `cover`, the
// share of the tool's width with tissue under it. So a slit narrower than the tool is no hole, a hole is none
// that one falls into with a jerk, and forces on the skin's vertices are forces on what is left of their
// triangles. A tool that is through the wall presses nothing; where its shaft crosses the wall the lips hold
// it, along the wall, until it has come out again.
//
// World thread; after construction nothing allocates, throws or locks. SI units, patient frame.
#pragma once

#include <array>
#include <vector>

#include "sim_core/bowel/cut_skin.h"
#include "sim_core/contact/tool_contact.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/world/part/blade_law.h"
#include "sim_core/world/part/snapshot.h"
#include "sim_core/world/part/state_list.h"
#include "sim_core/world/part/step_events.h"

namespace fulcrum {

struct ToolAction;

/// A place on the skin.
struct SkinPlace {
    std::int32_t root = -1;
    Vector3 barycentric = Vector3::Zero();
};

class BowelCut {
  public:
    /// reaction: across the wall.
    struct HandState : BladeHand {
        HandState() { cover = 1; }
        SkinPlace place;                 ///< that the tool's spring along the wall hangs on, with `linked`
        bool free = false;               ///< nothing holds it yet: it is between the lips
        double arm = 0;                  ///< m, back along the shaft from the tip to where it touches
        Vector3 tip = Vector3::Zero();   ///< m, at the last step
        Vector3 drag = Vector3::Zero();  ///< N, tool on tissue, along it
        double grip = 0;                 ///< N, most of it
        double slope = 0;                ///< N/m, of it
        Vector3 velocity = Vector3::Zero();  ///< m/s, of the place
    };

    BowelCut(const Scene& scene, const BowelSkin& skin, const std::vector<std::int32_t>& held);

    /// Before the rod's step: what each tool reaches, where it would have the wall. contact: as ToolAction's.
    void approach(int hand, const ToolAction& action, const RingMotion* rings, std::uint32_t tick,
                  double dt) noexcept;
    /// N, tool on tissue, that its spring asks for along the wall; null place without.
    Vector3 wanted(int hand, const RingFrame* frames) const noexcept;
    /// What the rod made of it, N; stiffness: N/m, of the tissue there along the force.
    void bear(int hand, const Vector3& drag, double stiffness) noexcept;
    /// After the rod's step: Eqs. 6 and 7, cuts, what falls. True where the surface changed.
    bool follow(const ToolAction* actions, const RingFrame* frames, std::uint32_t tick, double dt) noexcept;

    const CutSkin& skin() const { return skin_; }
    const HandState& hand(int hand) const { return hands_[static_cast<std::size_t>(hand)]; }
    SkinRow row(const SkinPlace& place) const noexcept;
    /// m along the bowel at rest.
    double rest_arc(const SkinPlace& place) const noexcept { return rest(place).x(); }
    /// Share of a skin vertex's ground that is left and hangs on, 0 .. 1.
    double vertex_share(std::int32_t vertex) const noexcept;
    /// Corner of the skin nearest to where the surface that is left comes nearest to a point, within `reach`
    /// (m) of it; -1: none. start: a root near.
    std::int32_t nearest_left(const Vector3& point, std::int32_t start, double reach,
                              const RingFrame* frames) noexcept;
    /// A cut; for studies and tests as for the hands. What jaws hold follows in the next step.
    CutSkin::Report cut(const BladeStep& blade, const RingFrame* frames, std::uint32_t tick,
                        int hand) noexcept;

    void fill_local_model(int hand, LocalModel& model) const noexcept;
    void forget_events() noexcept { events_.clear(); }
    void size_snapshot(WorldSnapshot& snapshot) const;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept;
    void list_state(StateList& list);
    std::size_t bytes() const;

  private:
    /// Visible ground near a point that hangs on.
    struct NearTriangle {
        std::int32_t triangle = -1;
        Vector3 a, b, c;
    };
    void gather(const Vector3& point, std::int32_t start, double reach, const RingFrame* frames) noexcept;
    bool covered(const Vector3& point, const Vector3& normal) const noexcept;
    SkinPlace closest_left(const Vector3& point, double& distance) const noexcept;
    SkinPlace on_skin(const Vector3& point, const RingFrame* frames) const noexcept;
    Vector3 where(const SkinPlace& place, const RingFrame* frames) const noexcept;
    Vector3 normal_at(const SkinPlace& place, const RingFrame* frames) const noexcept;
    Vector3 rest(const SkinPlace& place) const noexcept;
    struct Approach;  // the blade law's tissue, before the rod is solved and after
    struct Follow;
    void between_lips(HandState& hand, const ToolKinematics& tool, const RingFrame* frames) noexcept;
    void leave(int hand, std::uint32_t tick) noexcept;
    void advance(int hand, const Vector3& here, const Vector3& excess, const RingFrame* frames,
                 std::uint32_t tick) noexcept;
    void add_event(std::uint32_t tick, EventKind kind, int hand, double value, double detail) noexcept;
    void add_place_event(std::uint32_t tick, EventKind kind, int hand, const SkinPlace& place) noexcept;

    const BowelSkin& whole_;
    TissueSpec tissue_;
    std::int16_t tissue_index_ = -1;
    double blade_width_ = 0.0006, thickness_ = 0.003;
    Vector3 gravity_ = Vector3::Zero();
    CutSkin skin_;
    std::array<HandState, hand_count> hands_;
    std::uint64_t followed_ = 0;  // version at the end of the last step
    // Scratch.
    std::vector<RingFrame> frames_;
    std::vector<NearTriangle> near_;
    std::vector<std::int32_t> roots_;  // near the point gathered last
    std::vector<std::uint32_t> root_mark_;
    std::uint32_t mark_ = 0;
    bool near_cut_ = false;  // ground was taken from one of them
    StepEvents<24> events_;
};

}  // namespace fulcrum
