// SPDX-License-Identifier: Apache-2.0
// The grasp law: how a hand's jaws take tissue, hold it, lose it and let go, whatever the tissue.
//
// Jaws close when their opening falls below `close_share` with force, if they were open since they closed
// last. They open again above `open_share`: between the two they keep what they have. Tissue that was taken
// is held at one or more points, each through the pinched wall: a spring between the jaws and the tissue, of
// `pinch_share` times the tissue's stiffness over all points. Each point is drawn into the jaws in
// `correction_time` and follows them, at `fastest_hold` at most. Beyond 2 mu N, the friction of both faces,
// the tissue slides between the faces; it is lost when a point has slid out of them.
//
// A part supplies which tissue is nearest, how far it is, how stiff it is and where it is.
#pragma once

#include <array>
#include <cstdint>

#include "sim_core/contact/local_model.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum {

/// What jaws do in a step. `none`: nothing changes; of jaws that hold: their device does not answer.
enum class JawAction : std::uint8_t { none, close, hold, let_go };

/// Tissue as jaws hold it.
struct HeldTissue {
    double stiffness = 0;  ///< N/m
    double friction = 0;   ///< of the jaw faces on it
};

/// Jaws of one hand on the tissue of one part. Copyable state.
class Jaws {
  public:
    static constexpr double reach = 0.006;      ///< m from the middle of the jaws to the tissue
    static constexpr double pinch_share = 2.0;  ///< of the tissue's stiffness: both walls between the jaws
    static constexpr double margin = 0.003;     ///< m around the faces within which tissue is still held
    static constexpr int most_points = 3;

    /// A point at which tissue is held.
    struct Point {
        Vector3 offset = Vector3::Zero();      ///< m, tool frame, relative to the tip; changes as it slides
        Vector3 slid = Vector3::Zero();        ///< m, tool frame, since the jaws closed
        Vector3 correction = Vector3::Zero();  ///< m, tissue minus jaws when they closed; decays
        Vector3 target = Vector3::Zero();      ///< m, where the tissue shall be at the step's end
        Vector3 last = Vector3::Zero();        ///< m, target of the step before
    };

    /// Whether they would take tissue in this step. widest: rad, opening of the instrument's jaws.
    bool closing(const ToolKinematics& tool, double widest) const noexcept;
    /// Whether they are closed so far that they may hold something.
    static bool may_hold(const ToolKinematics& tool, double widest) noexcept;

    /// The law, once a step. After JawAction::close the part takes what is in reach, or nothing. lost:
    /// nothing of the tissue is left between them.
    JawAction step(const ToolKinematics& tool, double widest, bool lost = false) noexcept;
    /// Before a new hold: forgets the points of the last one.
    void clear_points() noexcept { count_ = 0; }
    /// Tissue at `point`; `jaws`: where the jaws are that take it there, `offset` in the tool's frame.
    void add_point(const Vector3& offset, const Vector3& jaws, const Vector3& point) noexcept;
    /// From now on they hold the points that were added, on an area (m2) that stays.
    void take(const ToolKinematics& tool, const HeldTissue& held, double area) noexcept;
    /// The points follow the jaws by one step. tissue: m, where the tissue of each is now; jaw_length: m.
    void carry(const ToolKinematics& tool, const HeldTissue& held, const Vector3* tissue, double jaw_length,
               double dt) noexcept;
    /// The tissue at a point is gone: those behind it move up.
    void drop_point(int index) noexcept;
    /// Nothing is left between them.
    void lose() noexcept;
    /// They take nothing before they were open again: their instrument was exchanged, or is one that does not
    /// grasp.
    void block() noexcept { ready_ = false; }

    bool held() const { return held_; }
    /// The last hold ended by a slip or a loss, not by opening.
    bool slipped() const { return slipped_; }
    /// Of the hold, or of the last one.
    int count() const { return count_; }
    const Point& point(int index) const { return points_[static_cast<std::size_t>(index)]; }
    double area() const { return area_; }  ///< m2, of the hold
    /// Of the spring at each point: N/m, and N, the most that the faces hold there.
    double stiffness() const { return stiffness_; }
    double most() const { return most_; }
    /// Where the jaws are, how fast they move and where in them the tissue is, by the first point.
    void fill(GraspModel& model) const noexcept;

  private:
    void press(const ToolKinematics& tool, const HeldTissue& held) noexcept;

    std::array<Point, most_points> points_;
    Vector3 velocity_ = Vector3::Zero();  ///< m/s, of the first point
    double stiffness_ = 0, most_ = 0;     ///< N/m, N, of each point
    double area_ = 0;                     ///< m2
    int count_ = 0;
    bool held_ = false, ready_ = true, slipped_ = false;
    bool out_ = false;  ///< a point has slid out of the faces
};

}  // namespace fulcrum
