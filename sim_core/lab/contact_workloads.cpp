// SPDX-License-Identifier: Apache-2.0
// Reference workloads tool_contact and proxy (docs/QUALITY.md): one tool and tick on the deforming surface of
// 20,000 triangles, and the world's part, patch_build.
#include <memory>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/contact_run.h"
#include "sim_core/lab/size_sweep.h"

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

void add_contact_sweeps(std::vector<SweepCase>& sweeps) {
    SweepCase tick;
    tick.model = "surface, a tick of contact";
    tick.element = "vertex";
    tick.operation = "vertices skinned: what is under the tool, however many lie elsewhere";
    tick.sizes = {4000, 12600, 40000, 126000, 400000};  // triangles
    tick.counted = 200;
    tick.prepare = [](int triangles) {
        const std::shared_ptr<ContactRun> contact = build_contact_run_of(triangles);
        const auto skinned = std::make_shared<double>(0);
        SweepRun run;
        run.elements = contact->skin->vertices();
        // Vertices skinned by the previous tick are still marked.
        run.between = [contact, skinned] {
            for (const std::uint32_t stamp : contact->tick_scratch.position_stamp)
                *skinned += stamp == contact->tick_scratch.stamp ? 1 : 0;
            contact->prepare_tick(0);
        };
        run.step = [contact] { contact->touch(); };
        run.operations = [skinned] { return *skinned; };
        return run;
    };
    sweeps.push_back(tick);
    SweepCase patch = tick;
    patch.model = "surface, building a patch";
    patch.operation = "vertices skinned: those of the rings within reach";
    patch.prepare = [](int triangles) {
        const std::shared_ptr<ContactRun> contact = build_contact_run_of(triangles);
        const auto found = std::make_shared<double>(0);
        SweepRun run;
        run.elements = contact->skin->vertices();
        run.between = [contact] {
            contact->prepare_tick(0);
            contact->touch();
        };
        run.step = [contact, found] {
            contact->publish();
            *found += static_cast<double>(contact->scratch.found.size());
        };
        run.operations = [found] { return *found; };
        return run;
    };
    sweeps.push_back(patch);
}

}  // namespace fulcrum::lab
