// SPDX-License-Identifier: Apache-2.0
// Where an operator believes the plane between mesorectum and fascia to be. Traction opens the loose fibres
// and shows it; under weak traction, or to an operator who does not recognise the fibres, it stays unseen and
// its height is guessed. A guess leans towards the rectum, away from the veins. An operator who is in a wrong
// plane follows it from level to level, and goes back as far as the fibres are recognised. The grade of the
// specimen is not known here. The random numbers are a stream of their own.
#pragma once

#include <algorithm>
#include <cstdint>

#include "assessment/operators/skill.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {

class PlaneSense {
  public:
    PlaneSense(const PlaneSkill& skill, std::uint64_t attempt) : skill_(skill), random_(attempt, stream) {}

    /// The next level comes into view. `opened`: traction as a share of the least asked for.
    void next_level(double opened) noexcept {
        const double guess = skill_.lean + skill_.blur * std::clamp(random_.normal(), -2.0, 2.0);
        off_ = follow * off_ + unseen(opened) * guess;
    }
    /// A stroke is planned under this traction; returns the distance from the plane to the believed one, m,
    /// positive towards the rectum.
    double stroke(double opened) noexcept {
        const double unseen_share = unseen(opened);
        off_ *= 1 - return_share * (1 - unseen_share);
        const double slack = unseen_share - unseen(1.0);  // this stroke begins before the fibres are open
        return std::clamp(off_ + slack * skill_.blur * random_.normal(), -furthest_out, furthest_in);
    }

  private:
    static constexpr std::uint64_t stream = 0x706c616e65;
    static constexpr double follow = 0.85;  // of a wrong plane, from one level to the next
    static constexpr double return_share =
        0.25;  // of the distance, in a stroke, where all fibres are recognised
    static constexpr double furthest_out = 0.002,
                            furthest_in = 0.0075;  // m: bone, and yellow fat that anyone sees
    static constexpr double wide_open = 0.7;       // of the least traction asked for: all fibres are seen
    double unseen(double opened) const noexcept {
        return 1 - skill_.recognition * std::clamp(opened / wide_open, 0.0, 1.0);
    }

    PlaneSkill skill_;
    Random random_;
    double off_ = 0;  // m, positive towards the rectum
};

}  // namespace fulcrum
