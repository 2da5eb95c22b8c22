// SPDX-License-Identifier: GPL-3.0-or-later
// The ratings of an attempt with observer forms. Raters fill in a form and see those of others once theirs is
// handed in; an educator releases them; the trainee sees what was released.
#pragma once

#include <QFrame>
#include <string>
#include <vector>

#include "assessment/forms/observer_form.h"
#include "database/records/ratings.h"
#include "ui/page/context.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class BackgroundJob;
class RatingEditor;

class RatingsCard : public QFrame {
    Q_OBJECT
  public:
    explicit RatingsCard(Context& context, QWidget* parent = nullptr);
    /// `blind`: on a page without name and score, where nothing that others gave is shown either.
    void open(const database::AttemptSummary& attempt, bool blind);
    /// Keeps a draft that was not kept yet.
    void keep();
    /// The same, and stops what runs.
    void leave();

  signals:
    /// A form of this person was handed in: name and score are no secret from them any longer.
    void handed_in();

  private:
    using Rows = std::vector<database::RatingRow>;
    void build_begin();
    void fill();
    /// Takes out what others gave while this person may still rate and has not asked to see it.
    int hold_back(Rows& rows, bool may_rate) const;
    void show_form(const Rows& rows);
    void show_row(const database::RatingRow& row, int mark);
    void offer_forms(const Rows& own);
    void begin();
    void release();
    void ask_agreement(const Rows& shown);

    Context& context_;
    database::AttemptSummary attempt_;
    std::vector<ObserverForm> forms_;  ///< those that this person can still begin
    bool blind_ = false, revealed_ = false;
    BackgroundJob* job_ = nullptr;
    QLabel *title_, *hidden_, *agreement_;
    QPushButton *reveal_, *release_, *begin_;
    QVBoxLayout* list_;
    QWidget* begin_row_;
    QComboBox* form_;
    RatingEditor* editor_;
};

}  // namespace fulcrum::ui
