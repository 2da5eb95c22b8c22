// SPDX-License-Identifier: Apache-2.0
// Tool contact: dynamic point, proxy and patch.
#include "tests/benchmarks/workloads.h"

int main(int argc, char** argv) {
    std::vector<fulcrum::lab::Workload> workloads;
    fulcrum::lab::add_contact_workloads(workloads);
    return fulcrum::run_benchmarks(argc, argv, workloads);
}
