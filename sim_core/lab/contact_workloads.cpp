// SPDX-License-Identifier: Apache-2.0
// Reference workloads tool_contact and proxy (quality.md): one tool and tick against the deforming surface of
// 20,000 triangles, and the world's part, patch_build.
#include <memory>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/contact_run.h"

namespace fulcrum::lab {

void add_contact_workloads(std::vector<Workload>& workloads) {
    Workload contact;
    contact.name = "tool_contact";
    contact.budget_mg = 1.5;
    contact.samples = 2000;
    contact.prepare = [] {
        const auto run = build_contact_run();
        Workload::Prepared prepared;
        prepared.between = [run] { run->prepare_tick(0); };
        prepared.step = [run] { run->touch(); };
        prepared.error = [run]() -> std::optional<double> { return worst_contact_distance(*run); };
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
        const auto run = build_contact_run();
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
        const auto run = build_contact_run();
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
