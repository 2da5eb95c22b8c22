// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/rating_summary.h"

namespace fulcrum::database {
namespace {

struct RatingMean {
    double sum = 0;
    int count = 0;
    void add(double value) {
        sum += value;
        ++count;
    }
    double value() const { return sum / count; }
};

struct FormMeans {
    std::string title;
    int forms = 0;
    RatingMean scaled;
    std::map<std::string, RatingMean> items;
};

/// Of one attempt, by name of the form: the means over its raters.
std::map<std::string, FormMeans> means_of(const std::vector<RatingRow>& ratings) {
    std::map<std::string, FormMeans> found;
    for (const RatingRow& rating : ratings) {
        const std::optional<double> share = form_share(rating.form, rating.answers);
        if (!share) continue;
        FormMeans& means = found[rating.form.name()];
        means.title = rating.form.title;
        ++means.forms;
        means.scaled.add(*share);
        for (std::size_t i = 0; i < rating.form.items.size(); ++i)
            if (rating.answers[i]) means.items[rating.form.items[i].id].add(*rating.answers[i]);
    }
    return found;
}

}  // namespace

std::vector<RatedForm> rated_forms(const std::vector<const std::vector<RatingRow>*>& attempts) {
    std::map<std::string, FormMeans> all;
    for (const std::vector<RatingRow>* attempt : attempts) {
        for (const auto& [name, of_attempt] : means_of(*attempt)) {
            FormMeans& means = all[name];
            means.title = of_attempt.title;
            means.forms += of_attempt.forms;
            means.scaled.add(of_attempt.scaled.value());
            for (const auto& [item, mean] : of_attempt.items) means.items[item].add(mean.value());
        }
    }
    std::vector<RatedForm> result;
    for (const auto& [name, means] : all) {
        RatedForm form{name, means.title, means.scaled.count, means.forms, means.scaled.value(), {}};
        for (const auto& [item, mean] : means.items) form.items[item] = mean.value();
        result.push_back(std::move(form));
    }
    return result;
}

}  // namespace fulcrum::database
