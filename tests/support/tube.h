// SPDX-License-Identifier: Apache-2.0
// The laboratory's reference tube and skin, under the tests' namespace.
#pragma once

#include "sim_core/lab/reference_skin.h"

namespace fulcrum::test {

using lab::bent_frames;
using lab::haustral_radius;
using lab::make_skin;
using lab::make_tube;
using lab::plain_radius;
using lab::rest_frames;
using lab::TubeRadius;
using lab::twisted_frames;

}  // namespace fulcrum::test
