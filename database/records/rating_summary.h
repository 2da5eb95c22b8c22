// SPDX-License-Identifier: GPL-3.0-or-later
// Released observer forms of several attempts in a few values, for reports. Pure.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "database/records/ratings.h"

namespace fulcrum::database {

/// One version of a form over attempts.
struct RatedForm {
    std::string form, title;      ///< "goals@1", its title
    int attempts = 0, forms = 0;  ///< with a released form; released forms of all raters
    double scaled = 0;            ///< mean over the attempts of the mean over raters, 0 (lowest) to 1
    /// By item, on the scale of the item: the mean in the same way. An item that nobody saw is left out.
    std::map<std::string, double> items;
};

/// By name of the form. `attempts`: the released forms of one attempt each. A form in which nothing was seen
/// counts for nothing.
std::vector<RatedForm> rated_forms(const std::vector<const std::vector<RatingRow>*>& attempts);
inline std::vector<RatedForm> rated_forms(const std::vector<RatingRow>& of_one_attempt) {
    return rated_forms({&of_one_attempt});
}

}  // namespace fulcrum::database
