// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/demonstration_deeds.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/lab/demonstration_plan.h"
#include "assessment/assets/assets.h"
#include "assessment/forms/observer_form.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/records/ratings.h"
#include "database/records/reviews.h"
#include "database/records/standings.h"

namespace fulcrum::app {
namespace {

/// So many of the attempts whose trace is kept are also rated with a form.
constexpr std::size_t rated_attempts = 6;

database::Session educator_session(const database::Store& store, std::size_t educator) {
    return database::People(store).demo_session(demo_educators().at(educator).login,
                                                database::Role::educator);
}
database::Session trainee_session(const database::Store& store, std::size_t trainee) {
    return database::People(store).demo_session(demo_trainee(trainee).login, database::Role::trainee);
}

ObserverForm form_named(const std::string& id) {
    for (ObserverForm& form : newest_forms(load_forms(asset_path("forms"))))
        if (form.id == id) return form;
    throw std::logic_error("assets/forms has no form " + id);
}

/// Better answers for a better trainee, and not the same one to every item.
FormAnswers answers_to(const ObserverForm& form, double mastery, std::size_t educator) {
    FormAnswers answers;
    for (std::size_t i = 0; i < form.items.size(); ++i) {
        const FormItem& item = form.items[i];
        if (item.optional && i % 3 == 2) {
            answers.push_back(std::nullopt);
            continue;
        }
        const double share =
            std::clamp(mastery + 0.08 * (static_cast<double>((i + educator) % 3) - 1), 0.0, 1.0);
        answers.push_back(item.lowest + static_cast<int>(std::lround(share * (item.highest - item.lowest))));
    }
    return answers;
}

void rate(const database::Store& store, const ShownAttempt& attempt, std::size_t educator, bool release) {
    const ObserverForm form = form_named(attempt.task == "C4" ? "gas" : "goals");
    const database::Session session = educator_session(store, educator);
    const database::Ratings ratings(store);
    const std::string id = ratings.begin(session, attempt.id, form);
    ratings.answer(session, id, answers_to(form, attempt.mastery, educator),
                   std::vector<bool>(form.items.size(), true),
                   attempt.passed ? "Ready for the next step." : "To be seen again in two weeks.");
    ratings.hand_in(session, id);
    if (release) ratings.release(session, attempt.id);
}

/// Two raters before anybody has seen name and score; then the comment.
void review(const database::Store& store, const ShownAttempt& attempt) {
    const std::size_t educators = demo_educators().size(), author = attempt.number % educators;
    if (attempt.number < rated_attempts || attempt.task == "C4") {
        rate(store, attempt, (author + 1) % educators, false);
        rate(store, attempt, author, true);
    }
    const database::Session session = educator_session(store, author);
    database::Reviews(store).write(session, attempt.id, attempt.moment_s,
                                   demo_comment(attempt.task, attempt.passed), true);
}

void correct(const database::Store& store, const DemoCorrection& wanted) {
    const database::Session trainee = trainee_session(store, wanted.trainee);
    const database::Attempts attempts(store);
    database::AttemptFilter filter;
    filter.person_id = trainee.person_id();
    filter.limit = 1;
    const std::vector<database::AttemptSummary> latest = attempts.list(trainee, filter);
    if (latest.empty()) return;
    const std::string& id = latest.front().meta.id;
    attempts.request_correction(trainee, id, wanted.request);
    if (wanted.granted) attempts.void_attempt(educator_session(store, wanted.educator), id, wanted.reason);
}

}  // namespace

void do_deeds(const database::Store& store, std::size_t trainees, int day,
              const std::vector<ShownAttempt>& shown) {
    const database::Reviews reviews(store);
    for (std::size_t i = 0; i < trainees && day <= demo_read_until; ++i) {
        const database::Session session = trainee_session(store, i);
        for (const database::Comment& comment : reviews.unread(session))
            reviews.mark_read(session, comment.id);
    }
    for (const ShownAttempt& attempt : shown) review(store, attempt);
    for (const DemoDecision& decision : demo_decisions(trainees, day))
        database::Standings(store).decide(educator_session(store, decision.educator),
                                          trainee_session(store, decision.trainee).person_id(), decision.task,
                                          decision.kind, decision.reason);
    for (const DemoCorrection& wanted : demo_corrections(trainees, day)) correct(store, wanted);
}

}  // namespace fulcrum::app
