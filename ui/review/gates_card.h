// SPDX-License-Identifier: GPL-3.0-or-later
// The gates of an attempt, each with value, limit, result and where the limit comes from.
#pragma once

#include <QFrame>

class QLabel;
class QTableWidget;

namespace fulcrum::ui {

struct AttemptModel;

class GatesCard : public QFrame {
    Q_OBJECT
  public:
    explicit GatesCard(QWidget* parent = nullptr);
    /// Hidden where the attempt has none.
    void open(const AttemptModel& model);

  signals:
    /// The moment that decided a gate.
    void time_chosen(double time);
    void metric_chosen(const QString& metric_id);

  private:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void fit();
    QTableWidget* table_;
    QLabel* sources_;                    ///< where the table has no room for their column
    int others_ = 0, last_but_one_ = 0;  ///< px
};

}  // namespace fulcrum::ui
