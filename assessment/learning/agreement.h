// SPDX-License-Identifier: Apache-2.0
// How far raters agree (intraclass correlations, Shrout and Fleiss 1979) and how far the items of a form
// measure one thing (Cronbach 1951). Complete tables only.
#pragma once

#include <vector>

namespace fulcrum {

/// With its 95 % interval from F distributions; negative values are kept.
struct Correlation {
    double value = 0, low = 0, high = 0;
};
/// One rating (1,1 / 2,1 / 3,1) or the mean of all raters (1,k / 2,k / 3,k). 1: each target has raters of its
/// own; 2: the same raters, drawn from many; 3: the same raters, the only ones of interest.
struct IntraclassCorrelations {
    Correlation one_1, two_1, three_1, one_k, two_k, three_k;
};

/// `ratings[target][rater]`: at least 2 targets and 2 raters, all rows of one length, finite, not all equal
/// within and between targets. Throws std::invalid_argument otherwise.
IntraclassCorrelations intraclass_correlations(const std::vector<std::vector<double>>& ratings);

/// `scores[target][item]`: as above. 1 where all items say the same.
double cronbach_alpha(const std::vector<std::vector<double>>& scores);

/// The value that an F distribution with d1 and d2 degrees of freedom stays below with probability p.
/// d1, d2 > 0, 0 < p < 1.
double f_quantile(double p, double d1, double d2);

}  // namespace fulcrum
