// SPDX-License-Identifier: Apache-2.0
// Fig. 12 of Pan et al. 2011 by the product's own rule: the ten ways a stroke divides a triangle, each by an
// example.
#pragma once

#include <vector>

#include "sim_core/lab/cut_study.h"
#include "sim_core/lab/result_page.h"

namespace fulcrum::lab {

/// A stroke over one triangle that Fig. 12 names.
struct CutExample {
    char letter = 'a';                                     ///< Fig. 12a ... j
    const char* what = "";                                 ///< in words
    Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< m
    double width = 0;                                      ///< m
};

/// The triangle of Fig. 12: 10 mm wide, 9 mm high, in the plane z = 0.
TriangleMesh figure_triangle();
std::vector<CutExample> cut_examples();
/// An example cut; tally.cases names it.
RestBlade run_example(const CutExample& example, RestBlade::Tally& tally);

/// Picture and counts: `fulcrum lab cut --output FOLDER`.
ResultPage cut_figures_page();

}  // namespace fulcrum::lab
