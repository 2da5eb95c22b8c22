// SPDX-License-Identifier: Apache-2.0
// Collision: spheres in a cavity and among themselves.
#include "tests/benchmarks/workloads.h"

int main(int argc, char** argv) {
    std::vector<fulcrum::lab::Workload> workloads;
    fulcrum::lab::add_collision_workloads(workloads);
    return fulcrum::run_benchmarks(argc, argv, workloads);
}
