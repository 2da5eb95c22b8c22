// SPDX-License-Identifier: Apache-2.0
// Fig. 12 of Pan et al. 2011 by the product's own rule: one example for each of the ten cases in which a
// stroke divides a triangle.
#pragma once

#include <vector>

#include "sim_core/lab/cut_study.h"
#include "sim_core/lab/result_page.h"

namespace fulcrum::lab {

/// A stroke over one triangle for one case of Fig. 12.
struct CutExample {
    char letter = 'a';                                     ///< Fig. 12a ... j
    const char* what = "";                                 ///< description
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
