// SPDX-License-Identifier: Apache-2.0
// Ratings by observers that a task of a curriculum asks for on top of its passes, and whether the released
// ratings of an attempt meet them. Pure.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/forms/observer_form.h"

namespace fulcrum {

struct Curriculum;

struct RatingRule {
    std::string form;                ///< id of the observer form; every version of it counts
    int raters = 1;                  ///< at least so many people, whose forms are released
    double lowest_mean = 0;          ///< mean over the raters of each rater's mean, on the scale of the items
    std::vector<std::string> items;  ///< that count; empty: every item of the form
    bool every_item = false;         ///< each item's mean over the raters as well
    bool blind = false;              ///< only forms of raters who saw neither name nor score
};

/// A form that was handed in for an attempt and released by an educator.
struct ReleasedRating {
    std::string id, attempt, rater;
    std::string form;                    ///< id without the version
    std::int64_t time = 0;               ///< UTC ms, of the release
    bool blind = false;                  ///< the rater saw neither name nor score
    std::map<std::string, int> answers;  ///< by item; an item that was not seen is left out
};

struct RatingVerdict {
    int raters = 0;              ///< whose ratings count
    bool enough = false;         ///< as many as the rule asks for
    bool met = false;            ///< enough, and high enough
    std::optional<double> mean;  ///< of those that count; none without one
};
/// What `ratings` (of one attempt, in any order) say at `at`: those that are released later are left out. Of
/// several of one rater the one released last counts. A rating in which no item of the rule was seen does
/// not.
RatingVerdict judge_ratings(const RatingRule& rule, const std::vector<ReleasedRating>& ratings,
                            std::int64_t at);

/// Whether any installed version of the curriculum asks for ratings.
bool asks_for_ratings(const Curriculum& curriculum);
/// Throws InputError with file and place where a rule names a form or an item that is not installed, a mean
/// outside its scale, or blind raters of a form that is not blind. With all installed versions.
void check_ratings(const Curriculum& curriculum, const std::vector<ObserverForm>& forms);

}  // namespace fulcrum
