// SPDX-License-Identifier: Apache-2.0
// Agreement of raters where not everybody rated everything: the largest complete table of raters and targets,
// its ICC(2,1), and the words for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/learning/agreement.h"

namespace fulcrum {

/// One rater's score of one target. The last one counts where a rater gave several.
struct RaterScore {
    std::string target, rater;
    double score = 0;
};

/// Every rater rated every target.
struct RatingTable {
    std::vector<std::string> targets, raters;  ///< sorted
    std::vector<std::vector<double>> scores;   ///< [target][rater]
};

/// Raters beyond this number are left out, those with the fewest ratings first: the search tries every group.
inline constexpr std::size_t most_raters = 12;

/// The complete table with at least two raters, two targets and the most scores; of equals the one with more
/// targets, then the one whose raters come first by name. Empty where there is none.
RatingTable largest_complete_table(const std::vector<RaterScore>& scores);

/// None for an empty table, and where all scores are equal: then nothing can be said.
std::optional<Correlation> agreement_of(const RatingTable& table);

/// Koo and Li 2016: below 0.5, 0.75, 0.9, and from 0.9 on.
enum class AgreementLevel { poor, moderate, good, excellent };
AgreementLevel agreement_level(double icc);

}  // namespace fulcrum
