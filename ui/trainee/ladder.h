// SPDX-License-Identifier: GPL-3.0-or-later
// The curriculum as a path: one column of cards for each stage, from the first to the last, with a line from
// each task to those that it unlocks. Where the columns have no room, the stages are shown below each other.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "assessment/curriculum/standing.h"

class QFrame;
class QBoxLayout;

namespace fulcrum::ui {

class Ladder : public QWidget {
    Q_OBJECT
  public:
    explicit Ladder(QWidget* parent = nullptr);

    struct Step {
        std::string task;
        std::vector<std::string> after;  ///< tasks that unlock it
        bool unlocked = false;
        QFrame* card = nullptr;  ///< becomes the ladder's
    };
    struct Stage {
        QString title;
        std::vector<Step> steps;
    };
    void set_stages(std::vector<Stage> stages);
    QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    int widest_card() const;
    /// In columns where the cards have room side by side.
    void arrange();

    std::vector<Stage> stages_;
    QBoxLayout* layout_;
    bool in_columns_ = true;
};

}  // namespace fulcrum::ui
