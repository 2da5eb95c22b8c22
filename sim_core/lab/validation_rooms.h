// SPDX-License-Identifier: Apache-2.0
// The cases of each room; declare a new room here and list it in validation.cpp.
#pragma once

#include <vector>

#include "sim_core/lab/validation.h"

namespace fulcrum::lab {

/// Dead loads on a cantilever, helix, torque, rigid rotation, chain.
std::vector<ValidationCase> rod_validation();
/// Held ends, grasps against an elastica by multiple shooting, floor.
std::vector<ValidationCase> rod_constraint_validation();
/// Euler loads of three end conditions, twist of a straight rod: zeros of the tangent's smallest eigenvalue.
std::vector<ValidationCase> buckling_validation();
/// EXP2 in stretch and bending, four layers, indentation.
std::vector<ValidationCase> material_validation();
/// Mean value coordinates, rest pose, rings in a bend, volume.
std::vector<ValidationCase> skinning_validation();
/// Sum, power and continuity of the force filter.
std::vector<ValidationCase> filter_validation();

/// The global-local membrane solve against Newton.
std::vector<ValidationCase> membrane_validation();
/// A simulated device at the product's contact, and Eq. 8.
std::vector<ValidationCase> haptic_validation();

}  // namespace fulcrum::lab
