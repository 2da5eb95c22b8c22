// SPDX-License-Identifier: GPL-3.0-or-later
// A task at the top of its page: the picture of its scene, what is to be done, what it leaves, the variants
// that the person has performed, and the way to its briefing.
#pragma once

#include <QFrame>
#include <string>

#include "database/records/report_data.h"
#include "ui/page/context.h"

class QLabel;
class QPushButton;

namespace fulcrum::ui {

class ScenePicture;

class TaskHeader : public QFrame {
    Q_OBJECT
  public:
    explicit TaskHeader(Context& context);
    /// Hidden for a task that is not installed. `progress`: null where there is none.
    void show_task(const std::string& person_id, const std::string& task_id,
                   const database::PersonProgress* progress);

  private:
    Context& context_;
    std::string task_id_, pictured_;
    ScenePicture* picture_;
    QLabel *title_, *briefing_, *product_, *variants_;
    QPushButton* perform_;
};

}  // namespace fulcrum::ui
