// SPDX-License-Identifier: GPL-3.0-or-later
// A draft of the curriculum that met another version than the one it was begun from: what was taken from that
// version, and where both authors changed the same thing, each with both values, to be decided.
#pragma once

#include <QString>
#include <QWidget>
#include <cstdint>
#include <vector>

#include "assessment/curriculum/curriculum_draft.h"
#include "assessment/curriculum/draft_merge.h"
#include "assessment/task/task.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace fulcrum::ui {

struct DraftMeeting {
    enum class Base : std::uint8_t {
        known,
        not_here,  ///< it is named, but this station has no such version
        not_named  ///< an older program saved the draft, or it was written elsewhere
    };
    Base base = Base::known;
    int from = 0;  ///< version that the draft was begun from; 0: not named
    std::vector<DraftDifference> taken, collisions;
};

/// Of what a difference is, in words: "A2, Pass rule".
QString part_words(const DraftDifference& one);
/// Where it is shown; `title` where the draft has no such task.
CurriculumField field_of(const DraftDifference& one, const Curriculum& draft);
/// Both values in words, which differ.
struct BothValues {
    QString draft, in_force;
};
BothValues both_values(const DraftDifference& one, const Curriculum& draft, const Curriculum& in_force,
                       const std::vector<TaskDefinition>& tasks);

class DraftMergeCard : public QWidget {
    Q_OBJECT
  public:
    explicit DraftMergeCard(QWidget* parent = nullptr);
    /// Hidden where there is none (null).
    void show_meeting(const DraftMeeting* meeting, const Curriculum& draft, const Curriculum& in_force,
                      const std::vector<TaskDefinition>& tasks);

  signals:
    /// By the person; `row`: of the collisions.
    void decided(int row, bool as_in_force);
    void place_wanted(int row);

  private:
    QLabel *note_, *ask_;
    QListWidget* list_;
    QWidget* choice_;
    QPushButton *keep_, *take_;
};

}  // namespace fulcrum::ui
