// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that review and exchange until they are killed.
#include <fstream>
#include <random>

#include "assessment/assets/assets.h"
#include "database/records/error_reviews.h"
#include "database/records/ratings.h"
#include "database/records/standings.h"
#include "database/sync/sync.h"
#include "tests/database/deeds_journal.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

/// An educator and a trainee at the store: each deed is one call of what their pages call.
class Reviewer {
  public:
    Reviewer(const std::string& folder, int seed)
        : journal_(DeedsJournal::in(folder)),
          store_(Store::open(folder + "/fulcrum.db", clock_.options())),
          educator_(People(store_).sign_in("educator", password)),
          trainee_(People(store_).sign_in("ann", password)),
          form_(load_forms(asset_path("forms")).front()),
          random_(static_cast<unsigned>(seed)),
          number_(static_cast<std::uint32_t>(seed) * 10'000) {
        for (const AttemptSummary& attempt : Attempts(store_).list(educator_))
            if (attempt.voided_at == 0) attempts_.push_back(attempt);
    }
    void run() {
        journal_.ready.fetch_add(1);
        void (Reviewer::*const deeds[])() = {
            &Reviewer::mark,     &Reviewer::draft,       &Reviewer::rate,   &Reviewer::rate,
            &Reviewer::void_one, &Reviewer::add_score,   &Reviewer::decide, &Reviewer::ask,
            &Reviewer::move,     &Reviewer::review_error};
        for (;;) (this->*deeds[random_() % (sizeof deeds / sizeof deeds[0])])();
    }

  private:
    std::string one() { return attempts_[random_() % attempts_.size()].meta.id; }
    std::string words(const char* what) { return std::string(what) + " " + std::to_string(++number_); }
    /// A deed, entered when its call has returned.
    template <typename Call>
    void done(DeedKind kind, const std::string& object, Call&& call) {
        journal_.begin();
        call();
        journal_.acknowledge(kind, object, number_);
    }

    void mark() {
        const std::string text = words("mark");
        journal_.begin();
        const std::string id = reviews_.write(educator_, one(), 0.01 * (number_ % 90), text, true);
        journal_.acknowledge(DeedKind::mark, id, number_);
        for (const Comment& unread : reviews_.unread(trainee_))
            if (unread.id == id) done(DeedKind::comment_read, id, [&] { reviews_.mark_read(trainee_, id); });
    }
    void review_error() {
        const std::string reason = words("the trocar had slipped");
        const ErrorVerdict verdict = number_ % 2 == 0 ? ErrorVerdict::struck : ErrorVerdict::confirmed;
        journal_.begin();
        const std::string id = ErrorReviews(store_).add(educator_, one(), Programme::slip(), verdict, reason);
        journal_.acknowledge(DeedKind::error_reviewed, id, number_);
    }
    void draft() {
        const std::string text = words("draft");
        journal_.begin();
        const std::string id = reviews_.write(educator_, one(), 0.5, text, false);
        journal_.acknowledge(DeedKind::draft, id, number_);
        for (std::uint64_t edits = random_() % 3; edits > 0; --edits) {
            const std::string next = words("draft");
            done(DeedKind::draft, id, [&] { reviews_.edit_draft(educator_, id, 0.6, next); });
        }
        if (random_() % 3 == 0) {
            journal_.announce(DeedKind::deletion_begun, id);
            done(DeedKind::draft_deleted, id, [&] { reviews_.delete_draft(educator_, id); });
        } else {
            done(DeedKind::draft_sent, id, [&] { reviews_.send(educator_, id); });
        }
    }
    void rate() {
        const std::string attempt = one();
        for (const RatingRow& row : ratings_.of_attempt(educator_, attempt).rows)
            if (row.rater_id == educator_.person_id()) return;  // one form a rater
        journal_.begin();
        const std::string id = ratings_.begin(educator_, attempt, form_);
        journal_.acknowledge(DeedKind::rating_begun, id);
        const std::vector<bool> answered(form_.items.size(), true);
        for (std::uint64_t rounds = 1 + random_() % 3; rounds > 0; --rounds) {
            const std::string remark = words("remark");
            FormAnswers answers;
            for (const FormItem& item : form_.items)
                answers.emplace_back(
                    item.lowest +
                    static_cast<int>(number_ % static_cast<unsigned>(item.highest - item.lowest + 1)));
            done(DeedKind::rating_answered, id,
                 [&] { ratings_.answer(educator_, id, answers, answered, remark); });
        }
        if (random_() % 4 == 0) {
            journal_.announce(DeedKind::discard_begun, id);
            done(DeedKind::rating_discarded, id, [&] { ratings_.discard(educator_, id); });
            return;
        }
        done(DeedKind::rating_handed_in, id, [&] { ratings_.hand_in(educator_, id); });
        done(DeedKind::rating_released, id, [&] { ratings_.release(educator_, attempt); });
    }
    /// Takes one away from those that can still be reviewed.
    std::string take() {
        const std::size_t at = random_() % attempts_.size();
        const std::string id = attempts_[at].meta.id;
        attempts_.erase(attempts_.begin() + static_cast<std::ptrdiff_t>(at));
        return id;
    }
    void void_one() {
        if (attempts_.size() < 8 || random_() % 4 != 0) return;
        const std::string id = take(), reason = words("the camera was off");
        done(DeedKind::attempt_voided, id, [&] { all_.void_attempt(educator_, id, reason); });
    }
    void move() {
        if (attempts_.size() < 8 || random_() % 4 != 0) return;
        const std::string person = attempts_.front().meta.person_id, id = attempts_.front().meta.id;
        const std::string other = person == trainee_.person_id() ? other_trainee() : trainee_.person_id();
        attempts_.erase(attempts_.begin());
        if (other.empty()) return;
        journal_.begin();
        const std::string copy = all_.reassign(educator_, id, other, words("it was the other one"));
        journal_.acknowledge(DeedKind::attempt_moved, copy, number_, id);
    }
    std::string other_trainee() const {
        for (const AttemptSummary& attempt : attempts_)
            if (attempt.meta.person_id != trainee_.person_id()) return attempt.meta.person_id;
        return {};
    }
    void add_score() {
        ScoreRow score = example_score(number_ % 2 == 0, 40 + number_ % 50);
        journal_.begin();
        const std::string id = all_.add_score(educator_, one(), score);
        journal_.acknowledge(DeedKind::score_added, id);
    }
    void decide() {
        const std::string reason = words("the instructor has seen it");
        journal_.begin();
        const std::string id = Standings(store_).decide(educator_, trainee_.person_id(), "B1",
                                                        StandingOverride::Kind::unlocked, reason);
        journal_.acknowledge(DeedKind::decided, id, number_);
    }
    void ask() {
        for (const AttemptSummary& attempt : attempts_) {
            if (attempt.meta.person_id != trainee_.person_id() || random_() % 4 != 0) continue;
            const std::string text = words("please void");
            done(DeedKind::correction_asked, attempt.meta.id,
                 [&] { all_.request_correction(trainee_, attempt.meta.id, text); });
            return;
        }
    }

    const ManualClock clock_;
    DeedsJournal& journal_;
    const Store store_;
    const Session educator_, trainee_;
    const ObserverForm form_;
    std::mt19937_64 random_;
    std::uint32_t number_;
    std::vector<AttemptSummary> attempts_;
    const Reviews reviews_{store_};
    const Ratings ratings_{store_};
    const Attempts all_{store_};
};

}  // namespace

int review_until_killed(const std::string& folder, int number) {
    Reviewer(folder, number).run();
    return 0;
}

int exchange_until_killed(const std::string& folder, int) {
    DeedsJournal& journal = DeedsJournal::in(folder);
    std::string address;
    std::getline(std::ifstream(folder + "/server"), address);
    const ManualClock clock;
    const Store store = Store::open(folder + "/fulcrum.db", clock.options());
    const Session session = People(store).sign_in("administrator", password);
    SyncOptions options;
    options.progress = [&](double, const std::string& line) {
        const bool up = line.rfind("sent ", 0) == 0;
        const std::size_t begin = up ? 5 : 9, colon = line.rfind(": ");
        const auto done = static_cast<std::uint32_t>(std::atoi(line.c_str() + colon + 2));
        journal.acknowledge(up ? DeedKind::sent : DeedKind::received, line.substr(begin, colon - begin),
                            done);
    };
    journal.ready.fetch_add(1);
    for (;;) {
        journal.begin();
        if (sync_with_server(store, session, ServerAddress::parse(address), options).complete)
            journal.acknowledge(DeedKind::exchanged, address);
    }
}

}  // namespace fulcrum::database::test
