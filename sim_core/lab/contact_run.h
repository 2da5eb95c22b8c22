// SPDX-License-Identifier: Apache-2.0
// One tool over an oscillating bowel, as the tick and the world process it: setup of the contact workloads
// and studies.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/contact/patch_builder.h"
#include "sim_core/contact/patch_surface.h"
#include "sim_core/contact/tool_contact.h"

namespace fulcrum::lab {

inline constexpr std::uint32_t ticks_a_step = 5;

/// A tool and the skin it touches, with the tick's and the world's state.
struct ToolOnSkin {
    std::unique_ptr<BowelSkin> skin;
    std::unique_ptr<PatchBuilder> builder;
    PatchBuilder::Scratch scratch;
    std::vector<RingMotion> rings;
    ToolContactModel model;
    LocalModel local;
    ToolContactState state;
    ToolContactScratch tick_scratch;
    ToolContactResult result;
    InstrumentState instrument;
};

/// The tool slides over the bowel at up to 60 mm/s, 0 to 2 mm deep, while the bowel oscillates by 2 mm at 0.5
/// Hz.
struct ContactRun : ToolOnSkin {
    ToolKinematics tool;
    WalkPoint walk;
    std::uint32_t tick = 0;

    void move_rings(double t);
    void move_tool(double t, double lift);
    void publish();
    /// Prepares a tick: moves the hand, and every `period` ticks builds a new model.
    void prepare_tick(double lift, std::uint32_t period = ticks_a_step);
    void touch() { step_tool_contact(model, local, tool, tick, state, tick_scratch, result); }
};

/// A tube of 0.9 m, 2 * sections * around triangles.
std::shared_ptr<ContactRun> build_contact_run(int sections = 299, int around = 33);
/// As above, with about the given number of triangles at constant aspect: size sweeps.
std::shared_ptr<ContactRun> build_contact_run_of(int triangles);

/// Largest difference (m) between the contact's distance and brute force over all triangles, the tool 3 to 6
/// mm above the surface.
double worst_contact_distance(ContactRun& run, int poses = 20);

}  // namespace fulcrum::lab
