// SPDX-License-Identifier: Apache-2.0
// A simulated hand and its device as one mass, between two ticks of a haptic loop. No allocation or
// exception.
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct HandProperties {
    double mass = 0.1;     ///< kg, of hand and device
    double damping = 0.5;  ///< N s/m, what the device itself loses
    bool arm = false;      ///< a spring and a damper pull the hand to where it is wanted
    double arm_stiffness = 300, arm_damping = 3;  ///< N/m, N s/m
};

struct MovingHand {
    HandProperties hand;
    Vector3 rail = Vector3::Zero();    ///< unit: the hand moves along it alone; zero: anywhere
    Vector3 push = Vector3::Zero();    ///< N
    Vector3 wanted = Vector3::Zero();  ///< m, where the arm pulls to
    Vector3 place = Vector3::Zero(), velocity = Vector3::Zero();
    double given = 0, lost = 0;  ///< J, by the force sent; by the device's damping

    /// Moves for `period` (s) under a constant force (N) of the device.
    void step(const Vector3& force, double period) noexcept {
        constexpr int substeps = 20;
        const double dt = period / substeps;
        for (int i = 0; i < substeps; ++i) {
            Vector3 sum = force + push - hand.damping * velocity;
            if (hand.arm) sum += hand.arm_stiffness * (wanted - place) - hand.arm_damping * velocity;
            velocity += dt / hand.mass * sum;
            if (!rail.isZero()) velocity = rail * rail.dot(velocity);
            place += dt * velocity;
            given += dt * force.dot(velocity);
            lost += dt * hand.damping * velocity.squaredNorm();
        }
    }
};

}  // namespace fulcrum
