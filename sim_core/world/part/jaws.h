// SPDX-License-Identifier: Apache-2.0
// The grasp law: how a hand's jaws take tissue, hold it, lose it and let go, whatever the tissue.
//
// Jaws close when their opening falls below `close_share` with force, if they were open since they closed
// last. They open again above `open_share`: between the two they keep what they have. Tissue that was taken
// is held at one or more points. Each point is drawn into the jaws in `correction_time` and follows them, at
// `fastest_hold` at most. A reaction above 2 mu N, the friction of both faces, for longer than `slip_delay`
// pulls the tissue out of the jaws.
//
// A part supplies which tissue is nearest, how far it is, how stiff it is and with what force it answers.
#pragma once

#include <array>
#include <cstdint>

#include "sim_core/contact/local_model.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum {

/// What jaws do in a step. `none`: nothing changes; of jaws that hold: their device does not answer.
enum class JawAction : std::uint8_t { none, close, hold, let_go };

/// What answers the jaws that hold tissue.
struct JawLoad {
    double reaction = 0;  ///< N
    double friction = 0;  ///< of the jaw faces on the tissue
    bool lost = false;    ///< nothing of it is left between them
};

/// Jaws of one hand on the tissue of one part. Copyable state.
class Jaws {
  public:
    static constexpr double reach = 0.006;      ///< m from the middle of the jaws to the tissue
    static constexpr double pinch_share = 2.0;  ///< of the tissue's stiffness: both walls between the jaws
    static constexpr int most_points = 3;

    /// A point at which tissue is held.
    struct Point {
        Vector3 offset = Vector3::Zero();      ///< m, tool frame, relative to the tip
        Vector3 correction = Vector3::Zero();  ///< m, tissue minus jaws when they closed; decays
        Vector3 target = Vector3::Zero();      ///< m, where the tissue shall be at the step's end
        Vector3 last = Vector3::Zero();        ///< m, target of the step before
    };

    /// Whether they would take tissue in this step. widest: rad, opening of the instrument's jaws.
    bool closing(const ToolKinematics& tool, double widest) const noexcept;
    /// Whether they are closed so far that they may hold something.
    static bool may_hold(const ToolKinematics& tool, double widest) noexcept;

    /// The law, once a step. After JawAction::close the part takes what is in reach, or nothing.
    JawAction step(const ToolKinematics& tool, double widest, const JawLoad& load, double dt) noexcept;
    /// Before a new hold: forgets the points of the last one.
    void clear_points() noexcept { count_ = 0; }
    /// Tissue at `point`; `jaws`: where the jaws are that take it there, `offset` in the tool's frame.
    void add_point(const Vector3& offset, const Vector3& jaws, const Vector3& point) noexcept;
    /// From now on they hold the points that were added.
    void take() noexcept;
    /// The points follow the jaws by one step.
    void carry(const ToolKinematics& tool, double dt) noexcept;
    /// The tissue at a point is gone: those behind it move up.
    void drop_point(int index) noexcept;
    /// Nothing is left between them.
    void lose() noexcept;
    /// They take nothing before they were open again: their instrument was exchanged.
    void block() noexcept { ready_ = false; }

    bool held() const { return held_; }
    /// The last hold ended by a slip or a loss, not by opening.
    bool slipped() const { return slipped_; }
    /// Of the hold, or of the last one.
    int count() const { return count_; }
    const Point& point(int index) const { return points_[static_cast<std::size_t>(index)]; }
    /// Where the jaws are, how fast they move and where in them the tissue is, by the first point.
    void fill(GraspModel& model) const noexcept;

  private:
    std::array<Point, most_points> points_;
    Vector3 velocity_ = Vector3::Zero();  ///< m/s, of the first point
    double slip_time_ = 0;                ///< s of load beyond what the jaws can hold
    int count_ = 0;
    bool held_ = false, ready_ = true, slipped_ = false;
};

}  // namespace fulcrum
