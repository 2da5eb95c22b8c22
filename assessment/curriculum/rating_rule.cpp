// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/rating_rule.h"

#include <algorithm>
#include <tuple>

#include "assessment/curriculum/curriculum.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum {
namespace {

constexpr double rating_tolerance = 1e-9;  // a mean of whole ratings that is equal to the limit meets it

bool names_item(const RatingRule& rule, const std::string& item) {
    return rule.items.empty() || std::find(rule.items.begin(), rule.items.end(), item) != rule.items.end();
}

/// The newest rating of each rater up to `at` that the rule accepts, by rater.
std::map<std::string, const ReleasedRating*> accepted(const RatingRule& rule,
                                                      const std::vector<ReleasedRating>& ratings,
                                                      std::int64_t at) {
    std::map<std::string, const ReleasedRating*> newest;
    for (const ReleasedRating& one : ratings) {
        const bool seen = std::any_of(one.answers.begin(), one.answers.end(),
                                      [&](const auto& answer) { return names_item(rule, answer.first); });
        if (one.time > at || one.form != rule.form || (rule.blind && !one.blind) || !seen) continue;
        const ReleasedRating*& kept = newest[one.rater];
        if (kept == nullptr || std::tie(kept->time, kept->id) < std::tie(one.time, one.id)) kept = &one;
    }
    return newest;
}

struct RatingSum {
    double sum = 0;
    int count = 0;
    void add(double value) {
        sum += value;
        ++count;
    }
    double mean() const { return sum / count; }
};

void check_rating_rule(const Curriculum& curriculum, std::size_t number, const RatingRule& rule,
                       const std::vector<ObserverForm>& forms) {
    const std::string file = curriculum.file.empty() ? curriculum.name() : curriculum.file;
    const auto fail = [&](const char* key, const Sentence& problem, const Sentence& hint) {
        throw InputError(file, "/tasks/" + std::to_string(number) + "/ratings/" + key, problem, hint);
    };
    const ObserverForm* form = nullptr;  // the newest version: load_forms() sorts them
    for (const ObserverForm& one : forms)
        if (one.id == rule.form) form = &one;
    if (form == nullptr)
        fail("form", {QT_TRANSLATE_NOOP("errors", "no observer form %1 is installed"), rule.form},
             QT_TRANSLATE_NOOP("errors", "name the id of a file of assets/forms"));
    if (rule.blind && !form->blind)
        fail("blind", {QT_TRANSLATE_NOOP("errors", "the form %1 is not filled in blind"), rule.form},
             QT_TRANSLATE_NOOP("errors", "leave blind out, or choose a form with \"blind\": true"));
    for (const std::string& item : rule.items)
        if (form->find(item) == nullptr)
            fail("items",
                 {QT_TRANSLATE_NOOP("errors", "%1 is not an item of the form %2"), item, form->name()},
                 QT_TRANSLATE_NOOP("errors", "name items of the form by their id"));
    for (const FormItem& item : form->items)
        if (names_item(rule, item.id) && (rule.lowest_mean < item.lowest || rule.lowest_mean > item.highest))
            fail("lowest_mean",
                 {QT_TRANSLATE_NOOP("errors", "is outside the scale of the item %1 (is %2)"), item.id,
                  decimal_text(rule.lowest_mean, 2)},
                 {QT_TRANSLATE_NOOP("errors", "use a mean from %1 to %2"), item.lowest, item.highest});
}

}  // namespace

RatingVerdict judge_ratings(const RatingRule& rule, const std::vector<ReleasedRating>& ratings,
                            std::int64_t at) {
    RatingSum over_raters;
    std::map<std::string, RatingSum> by_item;
    const auto newest = accepted(rule, ratings, at);
    for (const auto& [rater, rating] : newest) {
        RatingSum own;
        for (const auto& [item, value] : rating->answers) {
            if (!names_item(rule, item)) continue;
            own.add(value);
            by_item[item].add(value);
        }
        over_raters.add(own.mean());
    }
    RatingVerdict verdict;
    verdict.raters = static_cast<int>(newest.size());
    verdict.enough = verdict.raters >= rule.raters;
    if (newest.empty()) return verdict;
    verdict.mean = over_raters.mean();
    const double least = rule.lowest_mean - rating_tolerance;
    verdict.met = verdict.enough && *verdict.mean >= least &&
                  (!rule.every_item || std::all_of(by_item.begin(), by_item.end(), [&](const auto& item) {
                      return item.second.mean() >= least;
                  }));
    return verdict;
}

bool asks_for_ratings(const Curriculum& curriculum) {
    return std::any_of(curriculum.tasks.begin(), curriculum.tasks.end(),
                       [](const CurriculumTask& task) { return task.ratings.has_value(); }) ||
           std::any_of(curriculum.older.begin(), curriculum.older.end(), asks_for_ratings);
}

void check_ratings(const Curriculum& curriculum, const std::vector<ObserverForm>& forms) {
    for (std::size_t i = 0; i < curriculum.tasks.size(); ++i)
        if (curriculum.tasks[i].ratings)
            check_rating_rule(curriculum, i, *curriculum.tasks[i].ratings, forms);
    for (const Curriculum& one : curriculum.older) check_ratings(one, forms);
}

}  // namespace fulcrum
