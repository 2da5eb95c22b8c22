// SPDX-License-Identifier: Apache-2.0
// A bowel of rings and a tool above it with everything between them, small enough for tests.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/contact/jaws.h"
#include "sim_core/contact/patch_builder.h"
#include "sim_core/contact/patch_surface.h"
#include "sim_core/contact/tool_contact.h"
#include "tests/support/tube.h"

namespace fulcrum::test {

enum class Tube { plain, haustral };

/// 0.4 m of tube of 16 mm radius, bound once per program.
inline const BowelSkin& test_skin(Tube tube) {
    static const BowelSkin plain = make_skin(0.4, 0.016, 0.016, 170, 45, plain_radius(0.016));
    static const BowelSkin haustral = make_skin(0.4, 0.016, 0.016, 170, 45, haustral_radius(0.016));
    return tube == Tube::plain ? plain : haustral;
}

/// A tube along +x with a tool through a trocar above it, pointing down.
struct ContactRig {
    const BowelSkin& skin;
    PatchBuilder builder;
    PatchBuilder::Scratch scratch;
    std::vector<RingMotion> rings;
    ToolContactModel model;
    std::unique_ptr<LocalModel> local = std::make_unique<LocalModel>();
    ToolContactState state;
    std::unique_ptr<ToolContactScratch> tick_scratch = std::make_unique<ToolContactScratch>();
    ToolContactResult result;
    std::uint32_t tick = 0;

    explicit ContactRig(Tube tube = Tube::plain, PatchOptions options = {})
        : skin(test_skin(tube)),
          builder(skin, options, divide_into_patches(skin, 4, 4)),
          scratch(builder.make_scratch()),
          rings(static_cast<std::size_t>(skin.rings())) {
        const std::vector<RingFrame> frames = rest_frames(skin.cage());
        for (std::size_t r = 0; r < frames.size(); ++r) rings[r].frame = frames[r];
        InstrumentSpec spec;
        spec.trocar.position = Vector3(0.2, 0.0, 0.2);
        spec.trocar.direction = Vector3(0, 0, -1);
        spec.trocar.up = Vector3(0, 1, 0);
        model.instrument = make_instrument(spec, 1e-3);
    }

    /// The tool with its tip at a position, moving with the given velocity.
    ToolKinematics tool_at(const Vector3& tip, const Vector3& velocity = Vector3::Zero()) const {
        DeviceReading reading;
        reading.handle = handle_for_tip(model.instrument.trocar, tip);
        ToolKinematics tool = tool_pose(model.instrument, quantise(reading, DeviceSample{}));
        tool.tip_velocity = velocity;
        return tool;
    }

    /// The world's part: a new model for the tool's present pose.
    void publish(const ToolKinematics& tool) {
        PatchRequest request;
        request.tool = tool;
        request.contact_vertex = result.touching_surface ? result.vertex : -1;
        local->step += 1;
        local->tick = tick;
        builder.build(rings.data(), request, scratch, *local);
    }

    /// The tick's part.
    const ToolContactResult& touch(const ToolKinematics& tool) {
        step_tool_contact(model, *local, tool, tick, state, *tick_scratch, result);
        return result;
    }
};

}  // namespace fulcrum::test
