// SPDX-License-Identifier: GPL-3.0-or-later
// What the world thread hands to the others after each step: the models of the next ticks to the haptic
// thread, the snapshot to the window and to a rig that observes the world.
#pragma once

#include "assessment/attempt/engine.h"
#include "sim_core/telemetry/ring.h"

namespace fulcrum::app {

struct View {
    WorldSnapshot snapshot;
    TaskDisplay display;
};

/// Neither allocates, locks nor throws after fill().
struct WorldProducts {
    TripleBuffer<LocalModels> models;
    TripleBuffer<View> view, rig_view;
    bool observed = false;  ///< the rig observes the world; a person's devices do not

    /// Before the threads start.
    void fill(AttemptEngine& engine, bool rig_observes) {
        observed = rig_observes;
        models.fill(engine.world().local_models());
        const View start{engine.initial_snapshot(), engine.display()};
        view.fill(start);
        if (observed) rig_view.fill(start);
    }
    /// World thread.
    void publish(const StepProducts& products) noexcept {
        models.write_slot() = *products.models;
        models.publish();
        show(products, view);
        if (observed) show(products, rig_view);
    }

  private:
    static void show(const StepProducts& products, TripleBuffer<View>& buffer) noexcept {
        View& slot = buffer.write_slot();
        slot.snapshot = *products.snapshot;
        slot.display = *products.display;
        buffer.publish();
    }
};

}  // namespace fulcrum::app
