// SPDX-License-Identifier: GPL-3.0-or-later
// What the world looked like at a moment of a stored attempt.
#pragma once

#include <optional>

#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum::ui {

class ReplaySource {
  public:
    virtual ~ReplaySource() = default;
    virtual const Scene& scene() const = 0;
    virtual double duration_s() const = 0;
    /// Asks for the world at a time on the record's clock (s); the answer comes through update() when it is
    /// ready.
    virtual void seek(double time_s) = 0;
    /// True if a newer snapshot is there.
    virtual bool update() = 0;
    virtual const WorldSnapshot& snapshot() const = 0;
    /// Time that snapshot() shows.
    virtual double shown_s() const = 0;
    /// How far the re-simulation has come, 0..1; 1 when only poses are shown.
    virtual double ready() const = 0;
    /// From here on the re-simulated tissue differs from the record (another build): poses stay the recorded
    /// ones.
    virtual std::optional<double> differs_from_s() const = 0;
};

}  // namespace fulcrum::ui
