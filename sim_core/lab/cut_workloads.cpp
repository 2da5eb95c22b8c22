// SPDX-License-Identifier: Apache-2.0
// Reference workload cut_topology (docs/QUALITY.md): one step of 2 mm by a blade of 1 mm through a sheet,
// including the validation of everything it touched, on 10,000 and 100,000 triangles.
#include <cmath>
#include <memory>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/cut_run.h"

namespace fulcrum::lab {
namespace {

Workload cut_workload(const char* name, int triangles, double budget) {
    Workload workload;
    workload.name = name;
    workload.budget_mg = budget;
    workload.samples = 1000;
    workload.prepare = [triangles] {
        const auto run = std::make_shared<CutRun>(triangles);
        Workload::Prepared prepared;
        prepared.between = [run] { run->advance_blade(); };
        prepared.step = [run] { run->cut(); };
        prepared.error = [run]() -> std::optional<double> {
            const CutCheck check = check_cut(run->mesh, run->positions.data());
            if (!check.passed() || run->mesh.rolled_back() > 0) return std::nullopt;
            return check.area_error;
        };
        prepared.error_unit = "relative, area before less area after and removed";
        prepared.bytes = run->mesh.bytes();
        return prepared;
    };
    return workload;
}

}  // namespace

void add_cut_workloads(std::vector<Workload>& workloads) {
    workloads.push_back(cut_workload("cut_topology", 10000, 10));
    workloads.push_back(cut_workload("cut_topology_100k", 100000, 10));
}

}  // namespace fulcrum::lab
