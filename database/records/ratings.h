// SPDX-License-Identifier: GPL-3.0-or-later
// Observer forms of attempts. A draft is its rater's alone. Before their own form is handed in, raters see
// none of the others' where the form asks for blinding; the trainee sees a form once it is released. Nothing
// here touches a score.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/rating_rule.h"
#include "assessment/forms/observer_form.h"
#include "assessment/learning/rater_agreement.h"
#include "database/store/store.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum::database {

enum class Blinding {
    not_asked,  ///< the form does not ask for it
    kept,       ///< from beginning to handing in the page showed neither name, score nor other forms
    lifted,     ///< the rater had opened the attempt with name and score, or did so before handing in
};
inline constexpr NameRow<Blinding> blindings[] = {{Blinding::not_asked, "not_asked", "not asked for"},
                                                  {Blinding::kept, "kept", "blind"},
                                                  {Blinding::lifted, "lifted", "not blind"}};
static_assert(in_order(blindings));

struct RatingRow {
    std::string id, attempt_id, rater_id, rater_name;
    ObserverForm form;  ///< as it was when the rating was begun
    Blinding blinding = Blinding::not_asked;
    std::int64_t begun = 0, handed_in = 0, released = 0;  ///< UTC ms; 0: a draft; not released
    std::string remark;
    FormAnswers answers;         ///< an answer an item
    std::vector<bool> answered;  ///< false: not yet; true without an answer: not seen
};

/// What a session may see of the forms of one attempt.
struct AttemptRatings {
    std::vector<RatingRow> rows;  ///< own drafts first, then by handing in
    int hidden = 0;               ///< handed in, but not shown to this session (yet)
};

/// An attempt as a rater may see it before rating: no name, no score.
struct RatableAttempt {
    std::string attempt_id, task_id, variant;
    std::int64_t started = 0;  ///< UTC ms
    double duration_s = 0;
    int handed_in = 0;                      ///< forms of all raters
    int own_handed_in = 0;                  ///< of the session
    bool own_draft = false, blind = false;  ///< blind: a form begun now would count as blind
    bool awaited = false;                   ///< a curriculum waits for ratings of this attempt
    bool wants_blind = false;               ///< and only blind ones count
};

/// Agreement over the attempts that the same raters rated with one version of a form.
struct FormAgreement {
    std::string form, title;
    int forms = 0;                 ///< handed in, all of them
    int attempts = 0, raters = 0;  ///< of the largest complete table; 0: there is none
    std::optional<Correlation> icc;
};

/// What the function of standings needs of the released forms of a person's attempts, by id, those left out
/// that an account of the same person filled in before a merge. Not checked: for those who may read the
/// person's progress.
std::vector<ReleasedRating> released_ratings(Connection& connection, const std::string& person_id);

class Ratings {
  public:
    explicit Ratings(const Store& store) : store_(store) {}

    /// Newest first, attempts of real people (demo: all) that have ended, are not voided and not one's own,
    /// and whose trace was kept. With a curriculum those that it waits for come first and are marked. A
    /// sealed demo lists them for the roles that rate, although nobody rates there.
    std::vector<RatableAttempt> to_rate(const Session& rater, const Curriculum* curriculum = nullptr,
                                        int limit = 200) const;
    AttemptRatings of_attempt(const Session& session, const std::string& attempt_id) const;
    /// By attempt; attempts without ratings are left out. task_id empty: all tasks.
    std::map<std::string, AttemptRatings> of_person(const Session& session, const std::string& person_id,
                                                    const std::string& task_id = {}) const;
    /// Whether the session has a draft whose blinding was kept so far: name and score stay hidden.
    bool is_blind(const Session& rater, const std::string& attempt_id) const;
    /// The session has opened the attempt with name and score; lifts the blinding of its drafts, and of forms
    /// begun later. Nothing where the session may not rate the attempt, or the store is read-only.
    void note_seen(const Session& rater, const std::string& attempt_id) const;

    /// A draft; returns its id. Throws StoreError conflict where this rater has a draft or a form of the same
    /// id for this attempt, or the attempt runs or is voided.
    std::string begin(const Session& rater, const std::string& attempt_id, const ObserverForm& form) const;
    /// Replaces the answers of an own draft; one an item of its form. Throws bad_value outside an item's
    /// scale, or for a remark of more than 4,000 characters.
    void answer(const Session& rater, const std::string& rating_id, const FormAnswers& answers,
                const std::vector<bool>& answered, const std::string& remark) const;
    void discard(const Session& rater, const std::string& rating_id) const;
    /// For good. Throws bad_value where an item is left.
    void hand_in(const Session& rater, const std::string& rating_id) const;
    /// Shows the trainee every form that was handed in so far; returns how many were not shown before.
    int release(const Session& educator, const std::string& attempt_id) const;

    /// Over the attempts that the session may rate, voided ones and (except in a demo) synthetic people left
    /// out.
    std::vector<FormAgreement> agreement(const Session& rater) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
