// SPDX-License-Identifier: GPL-3.0-or-later
// Below the list of events, for an educator: the error that was chosen there is confirmed or struck, with a
// reason. The replay moves the list's cursor, not the choice. A reason that was begun and not given is kept
// as a draft of its author that names the error, and is there again, with it, when the attempt is opened.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "database/records/error_reviews.h"
#include "ui/page/context.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace fulcrum::ui {

struct EventLine;

/// "struck by NAME: REASON".
QString review_words(const database::ErrorReview& review);

/// What was typed of a reason that was begun (database::is_begun_reason): its draft without the mark and the
/// error that it names.
std::string begun_words(const database::Comment& draft);

class ErrorReviewBar : public QWidget {
    Q_OBJECT
  public:
    explicit ErrorReviewBar(Context& context, QWidget* parent = nullptr);
    /// Nothing is chosen, unless a reason was begun. `person_id`: whose attempt it is; the bar is hidden from
    /// whoever may not review it.
    void open(const std::string& attempt_id, const std::string& person_id,
              const std::vector<EventLine>& events);
    /// An event that is no error leaves nothing chosen.
    void choose(const EventLine& line);
    /// What was typed becomes a draft of its author.
    void keep_unsent();
    /// The draft was deleted elsewhere: it does not come back.
    void forget(const std::string& draft_id);

  signals:
    void reviewed();

  private:
    void clear();
    /// What is typed next is about no error yet.
    void forget_error();
    void add(database::ErrorVerdict verdict);
    bool may_review() const;
    void take_up_draft(const std::vector<EventLine>& events);
    /// Still there: another window may have deleted or used it.
    const database::Comment* find_draft(const std::vector<database::Comment>& comments) const;
    Context& context_;
    std::string attempt_id_, person_id_, author_id_;  ///< person: whose attempt; author: who types
    std::optional<Event> event_;                      ///< chosen, to be confirmed or struck
    std::string about_;     ///< a draft begins with it: of the error chosen last, also after another line
    double time_ = 0;       ///< s, of that error
    std::string draft_id_;  ///< "": what is typed has no draft yet
    QLabel* chosen_;
    QLineEdit* reason_;
    QPushButton *confirm_, *strike_;
};

}  // namespace fulcrum::ui
