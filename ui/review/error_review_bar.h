// SPDX-License-Identifier: GPL-3.0-or-later
// Below the list of events, for an educator: the error that was chosen there is confirmed or struck, with a
// reason. The replay moves the list's cursor, not the choice.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <string>

#include "database/records/error_reviews.h"
#include "ui/page/context.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace fulcrum::ui {

struct EventLine;

/// "struck by NAME: REASON".
QString review_words(const database::ErrorReview& review);

class ErrorReviewBar : public QWidget {
    Q_OBJECT
  public:
    explicit ErrorReviewBar(Context& context, QWidget* parent = nullptr);
    /// Nothing is chosen. `person_id`: whose attempt it is; the bar is hidden from whoever may not review it.
    void open(const std::string& attempt_id, const std::string& person_id);
    /// An event that is no error leaves nothing chosen.
    void choose(const EventLine& line);

  signals:
    void reviewed();

  private:
    void clear();
    void add(database::ErrorVerdict verdict);
    Context& context_;
    std::string attempt_id_;
    std::optional<Event> event_;
    QLabel* chosen_;
    QLineEdit* reason_;
    QPushButton *confirm_, *strike_;
};

}  // namespace fulcrum::ui
