// SPDX-License-Identifier: GPL-3.0-or-later
// What the world looked like at a moment of a stored attempt, and the moment itself as the beginning of a
// practice run.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim_core/instrument/device.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum::ui {

/// A moment of a stored attempt. Constant; it outlives the source.
class ReplayMoment {
  public:
    virtual ~ReplayMoment() = default;
    virtual const Scene& scene() const = 0;
    virtual const std::string& task_id() const = 0;
    virtual double time_s() const = 0;
};

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
    /// The last moment up to a time (s) from which practice can begin: before the attempt ended, and where
    /// the re-simulation has come already and is the record's. Null: there is none.
    virtual std::shared_ptr<const ReplayMoment> moment(double time_s) const = 0;
};

}  // namespace fulcrum::ui
