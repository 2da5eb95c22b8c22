// SPDX-License-Identifier: GPL-3.0-or-later
// A task at the top of its page: the picture of its scene, what is to be done, what it leaves, its variants
// with what the person has performed of them, and the way to its briefing and to its demonstration.
#pragma once

#include <QFrame>
#include <string>

#include "ui/page/context.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class ScenePicture;

class TaskHeader : public QFrame {
    Q_OBJECT
  public:
    explicit TaskHeader(Context& context);
    /// Hidden for a task that is not installed.
    void show_task(const std::string& person_id, const std::string& task_id);

  private:
    void fill_variants(const std::string& person_id, const TaskDefinition& task, bool may_perform);
    Context& context_;
    std::string task_id_, pictured_;
    ScenePicture* picture_;
    QLabel *title_, *briefing_, *product_;
    QVBoxLayout* variants_;
    QPushButton *perform_, *watch_;
};

}  // namespace fulcrum::ui
