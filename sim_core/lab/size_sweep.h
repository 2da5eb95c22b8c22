// SPDX-License-Identifier: Apache-2.0
// Each model at growing sizes (docs/QUALITY.md, Reference workloads): operations, counted by the model itself
// and so equal on every machine, and the time of a step. `fulcrum lab bench --sweep` prints them; tests check
// the counts against the limits.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/result_page.h"

namespace fulcrum::lab {

/// One size, ready to run.
struct SweepRun {
    double elements = 0;
    std::function<void()> step;
    std::function<void()> between;       ///< run untimed before each step; may be empty
    std::function<double()> operations;  ///< of all steps so far
};

struct SweepCase {
    std::string model;
    std::string element;    ///< singular: "segment"
    std::string operation;  ///< what is counted
    std::vector<int> sizes;
    std::function<SweepRun(int)> prepare;
    double exponent_limit = 1.05;  ///< of the operations
    double ratio_limit = 2;        ///< time per element, largest size over smallest
    int warm_up = 24, counted = 40;
};

struct SweepPoint {
    double elements = 0, operations = 0;  ///< operations per step, mean of the counted steps
    double time_us = 0;                   ///< median of a step; 0 if not timed
};

struct SizeSweep {
    std::string model, element, operation;
    double exponent_limit = 0, ratio_limit = 0;
    std::vector<SweepPoint> points;
    /// Slope of log(operations) over log(elements), least squares; of time likewise.
    double operation_exponent() const;
    double time_exponent() const;
    /// Largest over smallest size: time per element, operations per element.
    double time_ratio() const;
    double operation_ratio() const;
    bool within() const { return operation_exponent() <= exponent_limit && time_ratio() <= ratio_limit; }
};

/// Counts only, for sizes up to `largest`.
SizeSweep count_sweep(const SweepCase& sweep, int largest);
/// Counts, and times all sizes in turn for several rounds: the smallest of the rounds' medians.
SizeSweep time_sweep(const SweepCase& sweep);

/// All models: one registration function per room, like the workloads.
std::vector<SweepCase> size_sweeps();
void add_rod_sweeps(std::vector<SweepCase>& sweeps);
void add_collision_sweeps(std::vector<SweepCase>& sweeps);
void add_skinning_sweeps(std::vector<SweepCase>& sweeps);
void add_contact_sweeps(std::vector<SweepCase>& sweeps);
void add_membrane_sweeps(std::vector<SweepCase>& sweeps);

nlohmann::json to_json(const std::vector<SizeSweep>& sweeps);
ResultPage size_sweep_page(const std::vector<SizeSweep>& sweeps);

}  // namespace fulcrum::lab
