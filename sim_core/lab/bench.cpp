// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sim_core/lab/yardstick.h"

namespace fulcrum::lab {
namespace {

AllocationCounter allocation_counter = nullptr;

std::uint64_t allocations() {
    return allocation_counter != nullptr ? allocation_counter() : 0;
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const auto index = static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)));
    return values[std::min(index, values.size() - 1)];
}

}  // namespace

void set_allocation_counter(AllocationCounter counter) {
    allocation_counter = counter;
}

WorkloadResult run_workload(const Workload& workload) {
    using Clock = std::chrono::steady_clock;
    const Workload::Prepared prepared = workload.prepare();
    for (int i = 0; i < workload.warm_up; ++i) {
        if (prepared.between) prepared.between();
        prepared.step();
    }

    std::vector<double> times, yardsticks;
    times.reserve(static_cast<std::size_t>(workload.samples));
    yardsticks.reserve(64);
    time_yardstick_us();
    const int group = std::max(1, workload.samples / 16);
    std::uint64_t allocated = 0;
    for (int i = 0; i < workload.samples; ++i) {
        if (i % group == 0) yardsticks.push_back(time_yardstick_us());
        if (prepared.between) prepared.between();
        const std::uint64_t before = allocations();
        const auto begin = Clock::now();
        prepared.step();
        const auto end = Clock::now();
        allocated += allocations() - before;
        times.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
    }

    WorkloadResult result;
    result.name = workload.name;
    result.median_us = quantile(times, 0.5);
    result.p99_us = quantile(times, 0.99);
    result.worst_us = quantile(times, 1);
    result.yardstick_us = quantile(yardsticks, 0.5);
    result.budget_mg = workload.budget_mg;
    result.worst_budget_mg = workload.worst_budget_mg;
    if (prepared.error) result.error = prepared.error();
    result.error_unit = prepared.error_unit;
    result.bytes = prepared.bytes;
    result.allocations_per_step = static_cast<double>(allocated) / workload.samples;
    return result;
}

std::vector<Workload> reference_workloads() {
    std::vector<Workload> workloads;
    add_rod_workloads(workloads);
    add_collision_workloads(workloads);
    add_skinning_workloads(workloads);
    add_contact_workloads(workloads);
    add_membrane_workloads(workloads);
    add_cut_workloads(workloads);
    add_sheet_workloads(workloads);
    return workloads;
}

}  // namespace fulcrum::lab
