// SPDX-License-Identifier: Apache-2.0
// Reference workloads tool_contact and proxy (quality.md): one tool and tick against the deforming surface of
// 20,000 triangles, and the world's part, patch_build. The tool slides over the bowel at 60 mm/s while the
// bowel moves.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "sim_core/contact/patch_builder.h"
#include "sim_core/contact/patch_surface.h"
#include "sim_core/contact/tool_contact.h"
#include "sim_core/geometry/closest_point.h"
#include "sim_core/lab/bench.h"
#include "sim_core/lab/reference_tube.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {
namespace {

constexpr double length = 0.9, mean_radius = 0.016;
constexpr std::uint32_t ticks_a_step = 5;

struct ContactRun {
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
    ToolKinematics tool;
    WalkPoint walk;
    std::uint32_t tick = 0;

    // The bowel sways by 2 mm at 0.5 Hz; a ring's velocity is the derivative.
    void move_rings(double t) {
        double sine = 0, cosine = 1;
        math::sin_cos(3.14159265358979 * t, sine, cosine);
        for (std::size_t r = 0; r < rings.size(); ++r) {
            const RingFrame rest = rest_frame(skin->cage().arc_lengths[r]);
            rings[r].frame = rest;
            rings[r].frame.position.z() += 0.002 * sine;
            rings[r].velocity = Vector3(0, 0, 0.002 * 3.14159265358979 * cosine);
        }
    }
    // To and fro along the bowel, weaving over its back, 0 to 2 mm deep.
    void move_tool(double t, double lift) {
        const double along = 0.45 + 0.05 * math::sin(1.2 * t), weave = 0.3 * math::sin(2.0 * t);
        const double height = mean_radius + 0.0015 + lift - 0.001 * math::sin(5 * t);
        DeviceReading reading;
        reading.handle = handle_for_tip(model.instrument.trocar,
                                        {along, height * math::sin(weave), height * math::cos(weave)});
        tool = step_instrument(model.instrument, quantise(reading, instrument.last), instrument);
    }
    void publish() {
        PatchRequest request;
        request.tool = tool;
        request.contact_vertex = result.touching_surface ? result.vertex : -1;
        ++local.step;
        local.tick = tick;
        builder->build(rings.data(), request, scratch, local);
    }
    // What comes before a tick: the hand moves, and every fifth tick there is a new model.
    void prepare_tick(double lift) {
        ++tick;
        const double t = tick * 1e-3;
        move_tool(t, lift);
        if (tick % ticks_a_step == 0) {
            move_rings(t);
            publish();
        }
    }
};

std::shared_ptr<ContactRun> build() {
    auto run = std::make_shared<ContactRun>();
    TriangleMesh mesh = make_tube(length, 299, 33, haustral_radius(mean_radius));  // 19,800 triangles
    const SphereChain spheres = sample_spheres(length, 0.016, [](double) { return mean_radius; });
    Cage cage = build_cage(mesh, length, spheres);
    run->skin = std::make_unique<BowelSkin>(std::move(mesh), std::move(cage));
    run->builder =
        std::make_unique<PatchBuilder>(*run->skin, PatchOptions{}, divide_into_patches(*run->skin, 4, 4));
    run->scratch = run->builder->make_scratch();
    run->rings.resize(static_cast<std::size_t>(run->skin->rings()));
    InstrumentSpec spec;
    spec.trocar.position = Vector3(0.45, 0.0, 0.2);
    spec.trocar.direction = Vector3(0, 0, -1);
    spec.trocar.up = Vector3(0, 1, 0);
    run->model.instrument = make_instrument(spec, 1e-3);
    run->move_rings(0);
    run->move_tool(0, 0);
    run->publish();
    return run;
}

// Distance of the tool to the surface against brute force over all triangles, with the tool held clear of it.
double worst_distance(ContactRun& run) {
    std::vector<RingFrame> frames(run.rings.size());
    std::vector<Vector3> all(static_cast<std::size_t>(run.skin->vertices()));
    double worst = 0;
    for (int k = 0; k < 20; ++k) {
        for (std::uint32_t i = 0; i < 7 * ticks_a_step || run.tick % ticks_a_step != 0; ++i) {
            run.prepare_tick(0.004);
            step_tool_contact(run.model, run.local, run.tool, run.tick, run.state, run.tick_scratch,
                              run.result);
        }
        for (std::size_t r = 0; r < frames.size(); ++r) frames[r] = run.rings[r].frame;
        skin_all(*run.skin, frames.data(), all.data());
        double nearest = std::numeric_limits<double>::infinity();
        for (const Triangle& t : run.skin->rest().triangles) {
            const Vector3 foot = closest_point_on_triangle(run.tool.tip, all[static_cast<std::size_t>(t[0])],
                                                           all[static_cast<std::size_t>(t[1])],
                                                           all[static_cast<std::size_t>(t[2])])
                                     .position;
            nearest = std::min(nearest, (run.tool.tip - foot).norm());
        }
        worst = std::max(worst, std::abs(run.result.distance - (nearest - run.model.instrument.tip_radius)));
    }
    return worst;
}

}  // namespace

void add_contact_workloads(std::vector<Workload>& workloads) {
    Workload contact;
    contact.name = "tool_contact";
    contact.budget_mg = 1.5;
    contact.samples = 2000;
    contact.prepare = [] {
        const auto run = build();
        Workload::Prepared prepared;
        prepared.between = [run] { run->prepare_tick(0); };
        prepared.step = [run] {
            step_tool_contact(run->model, run->local, run->tool, run->tick, run->state, run->tick_scratch,
                              run->result);
        };
        prepared.error = [run]() -> std::optional<double> { return worst_distance(*run); };
        prepared.error_unit = "m from brute force, 3 to 6 mm above the surface";
        prepared.bytes = sizeof(LocalModel) + sizeof(ToolContactScratch) + sizeof(ToolContactState) +
                         sizeof(ToolContactResult);
        return prepared;
    };
    workloads.push_back(contact);

    Workload proxy;
    proxy.name = "proxy";
    proxy.budget_mg = 0.6;
    proxy.samples = 2000;
    proxy.prepare = [] {
        const auto run = build();
        run->walk.triangle = run->local.patch.seed_triangle;
        Workload::Prepared prepared;
        prepared.between = [run] {
            const std::int32_t id =
                run->local.patch.triangle_id[static_cast<std::size_t>(run->walk.triangle)];
            run->prepare_tick(0);
            const std::int32_t here = run->local.patch.find_triangle(id);
            run->walk.triangle = here >= 0 ? here : run->local.patch.seed_triangle;
        };
        prepared.step = [run] {
            PatchSurface surface(run->local.patch, (run->tick - run->local.tick) * 1e-3, run->tick_scratch);
            WalkOptions options;
            options.curvature_radius = run->local.patch.curvature_radius;
            walk_surface(surface, run->tool.trocar, run->tool.tip, options, run->walk);
        };
        prepared.bytes = sizeof(LocalModel) + sizeof(ToolContactScratch);
        return prepared;
    };
    workloads.push_back(proxy);

    Workload patch;
    patch.name = "patch_build";
    patch.samples = 1000;
    patch.prepare = [] {
        const auto run = build();
        Workload::Prepared prepared;
        prepared.between = [run] {
            run->tick += ticks_a_step;
            run->move_tool(run->tick * 1e-3, 0);
            run->move_rings(run->tick * 1e-3);
        };
        prepared.step = [run] { run->publish(); };
        prepared.bytes = sizeof(LocalModel);
        return prepared;
    };
    workloads.push_back(patch);
}

}  // namespace fulcrum::lab
