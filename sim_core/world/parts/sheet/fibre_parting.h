// SPDX-License-Identifier: Apache-2.0
// Fibres between two layers part under tension: at the ends of cuts, which then run on along the marked line,
// and at any point of that line where the tension is above their strength. Each parting is a cut like a
// blade's, a transaction.
#pragma once

#include "sim_core/world/parts/sheet/sheet_body.h"

namespace fulcrum {

class FibreParting {
  public:
    explicit FibreParting(SheetBody& sheet) : sheet_(sheet) {}
    /// A hand's blade enters; it has cut from one place at rest to another.
    void begin_stroke(int hand) noexcept;
    void move_ends(int hand, const Vector3& from, const Vector3& reached) noexcept;
    void step(std::uint32_t tick, double dt) noexcept;

  private:
    bool along_line(const SheetPlace& where, Vector3& way, Vector3& normal) const noexcept;
    SheetFibres::Tip find_end(const Vector3& reached, double direction) const noexcept;
    bool open_fibres(std::int32_t station, std::uint32_t tick) noexcept;
    bool part(const SheetPlace& here, const Vector3& begin, const Vector3& way, const Vector3& normal,
              double run, double traction, std::uint32_t tick, Vector3& reached) noexcept;

    SheetBody& sheet_;
};

}  // namespace fulcrum
