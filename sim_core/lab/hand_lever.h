// SPDX-License-Identifier: Apache-2.0
// A simulated hand at the handle of an instrument that presses tissue beyond its trocar (docs/THEORY.md,
// section 6).
//
// Hand and device are one mass with the device's damping; an arm adds a spring and a damper to a place inside
// the tissue, without one the hand pushes with a constant force along a straight line. Between two ticks the
// motion is integrated in short steps under the force that the tick sent. The tick is the product's:
// step_tool_contact on a local model, then HandOutput. The world's part does not move.
#pragma once

#include <cstdint>
#include <memory>

#include "sim_core/haptics/hand_output.h"
#include "sim_core/instrument/moving_hand.h"

namespace fulcrum::lab {

enum class LeverTissue : std::uint8_t { wall, bowel, sheet, band };
inline constexpr LeverTissue lever_tissues[] = {LeverTissue::wall, LeverTissue::bowel, LeverTissue::sheet,
                                                LeverTissue::band};
const char* name_of(LeverTissue tissue);

struct LeverHand : HandProperties {
    ForceOutput device = {0.5, 3.3, 0.88};
    double period = 1e-3;  ///< s
    /// The tissue's force on the tip is sent as it is, as before the lever was known. Kept as a test of the
    /// test.
    bool tip_force = false;
};

struct LeverCase {
    LeverTissue tissue = LeverTissue::wall;
    double insertion = 0.5;  ///< share of the shaft beyond the trocar
    double tilt = 0;  ///< rad, of the tissue's normal from across the shaft (0) to against the tip (pi/2)
    double stiffness = 800, damping = 0.4;  ///< N/m, N s/m, of the tissue
};

/// A hand has settled where its swing (largest less smallest displacement along its push) in the last third
/// of a run is less than this share of the swing in the first third. Most of the 480 runs of
/// hand_lever_test.cpp end far below it; the largest share of them is 0.033.
inline constexpr double settled_share = 0.1;
/// s, in which every hand settles that Eq. 8 allows: without an arm nothing but the device's damping takes
/// energy, and what Eq. 8 leaves of it (a fifth, HandOutput) makes a hand of 0.5 kg swing for half a minute.
double time_to_settle(const LeverHand& hand);

struct LeverRun {
    bool finite = true;
    bool bounded = true;         ///< the hand stayed within 2 cm of where it began
    bool settles = false;        ///< see settled_share
    double seconds = 0;          ///< simulated
    double early = 0, late = 0;  ///< m, swing in the first and the last third
    double returned = 0;         ///< J, most that the hand got back beyond what it put in and the device lost
    double put_in = 0;           ///< J, most that the hand had put in
    double depth = 0;            ///< m, of the tip in the tissue at the end, along the normal
    double force = 0;            ///< N, largest sent
    bool limited = false;        ///< Eq. 8 reduced the model
    bool passive() const { return returned <= 1e-6 + 1e-3 * put_in; }
    bool sound() const { return finite && bounded && settles && passive(); }
};

/// Builds the tissues once.
class HandAtLever {
  public:
    HandAtLever();
    ~HandAtLever();
    HandAtLever(const HandAtLever&) = delete;
    HandAtLever& operator=(const HandAtLever&) = delete;

    /// For time_to_settle().
    LeverRun run(const LeverCase& at, const LeverHand& hand);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fulcrum::lab
