// SPDX-License-Identifier: Apache-2.0
// Only this file is compiled with -O3 -march=native -DEigen=EigenYardstick (sim_core/CMakeLists.txt): Eigen's
// templates get a separate namespace here, so that no wide-vector instantiation can replace one of the
// product's at link time.
#include "sim_core/lab/yardstick.h"

#include <Eigen/Core>
#include <chrono>

namespace fulcrum::lab {
namespace {

constexpr int order = 512;

struct Operands {
    Eigen::MatrixXd a = Eigen::MatrixXd::Constant(order, order, 0.5);
    Eigen::MatrixXd b = Eigen::MatrixXd::Constant(order, order, 0.25);
    Eigen::MatrixXd c = Eigen::MatrixXd::Zero(order, order);
};

}  // namespace

double time_yardstick_us() {
    static Operands operands;
    const auto begin = std::chrono::steady_clock::now();
    operands.c.noalias() = operands.a * operands.b;
    const auto end = std::chrono::steady_clock::now();
    operands.a(0, 0) = operands.c(1, 1) * 1e-3;  // the next product depends on this one
    return std::chrono::duration<double, std::micro>(end - begin).count();
}

}  // namespace fulcrum::lab
