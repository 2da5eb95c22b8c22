// SPDX-License-Identifier: Apache-2.0
// The reference workloads of `fulcrum lab bench`: the product's own code, timed in one process together with
// the yardstick.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::lab {

struct WorkloadResult {
    std::string name;
    double median_us = 0, p99_us = 0, worst_us = 0;
    double yardstick_us = 0;      ///< median of the yardstick runs between this workload's samples
    double budget_mg = 0;         ///< of the median; 0: informative only
    double worst_budget_mg = 0;   ///< of the worst sample; 0: none is set
    std::optional<double> error;  ///< against the reference that `error_unit` names
    std::string error_unit;
    std::uint64_t bytes = 0;          ///< size of the workload's state and tables
    double allocations_per_step = 0;  ///< after warm-up
    double median_mg() const { return 1000.0 * median_us / yardstick_us; }
    double p99_mg() const { return 1000.0 * p99_us / yardstick_us; }
    double worst_mg() const { return 1000.0 * worst_us / yardstick_us; }
    bool within() const {
        return (budget_mg <= 0 || median_mg() <= budget_mg) &&
               (worst_budget_mg <= 0 || worst_mg() <= worst_budget_mg);
    }
};

/// A workload: `prepare` builds it and returns the step to time; the step must do the same work in every
/// call.
struct Workload {
    std::string name;
    double budget_mg = 0, worst_budget_mg = 0;
    int warm_up = 20, samples = 400;
    struct Prepared {
        std::function<void()> step;
        std::function<void()> between;                 ///< run untimed before each step; may be empty
        std::function<std::optional<double>()> error;  ///< may be empty
        std::string error_unit;
        std::uint64_t bytes = 0;
    };
    std::function<Prepared()> prepare;
};

/// Number of heap allocations of this process so far. A program that links a counter registers it here
/// (without one, 0 is reported).
using AllocationCounter = std::uint64_t (*)();
void set_allocation_counter(AllocationCounter counter);

/// Times one workload: warm-up, then samples with the yardstick run between groups of them.
WorkloadResult run_workload(const Workload& workload);

/// All workloads, in the order of docs/FORMATS.md; one registration function per room, listed in bench.cpp.
std::vector<Workload> reference_workloads();

void add_rod_workloads(std::vector<Workload>& workloads);
void add_collision_workloads(std::vector<Workload>& workloads);
void add_skinning_workloads(std::vector<Workload>& workloads);
void add_contact_workloads(std::vector<Workload>& workloads);
void add_membrane_workloads(std::vector<Workload>& workloads);
void add_cut_workloads(std::vector<Workload>& workloads);
void add_sheet_workloads(std::vector<Workload>& workloads);

}  // namespace fulcrum::lab
