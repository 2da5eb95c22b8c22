// SPDX-License-Identifier: GPL-3.0-or-later
// A pass rule to play with: its kind and numbers by sliders, and at once what it does to trainees who pass
// 90, 70 and 50 % of their attempts, next to the rule in force. Picture first, the same as a table below it.
#pragma once

#include <QWidget>

#include "assessment/learning/pass_rule.h"

class QComboBox;
class QLabel;
class QSlider;
class QTableWidget;

namespace fulcrum::ui {

class PassRuleChart;

/// "5 passes in a row", "4 passes among the last 5 attempts", "LC-CUSUM: ...".
QString pass_rule_words(const PassRule& rule);

class PassRuleDesigner : public QWidget {
    Q_OBJECT
  public:
    explicit PassRuleDesigner(QWidget* parent = nullptr);
    /// `in_force`: the curriculum's; `tried`: what the sliders show; `variants`: on how many the passes have
    /// to be. A rule that nobody could meet is not among those that the sliders offer.
    void show_rule(const PassRule& in_force, const PassRule& tried, int variants);
    const PassRule& tried() const { return tried_; }

  signals:
    /// By the person, not by show_rule().
    void changed();

  private:
    struct Dial {
        QWidget* row = nullptr;
        QSlider* slider = nullptr;
        QLabel *name = nullptr, *value = nullptr;
        int given = 0;  ///< by the rule, not by the person; rounded
        bool is_moved() const;
    };
    Dial make_dial(const QString& name, const char* object);
    void set_dials();
    void read_dials();
    void refresh();

    PassRule in_force_, tried_;
    int variants_ = 1;
    bool setting_ = false;
    QComboBox* kind_;
    Dial passes_, among_, acceptable_, unacceptable_, limit_;
    PassRuleChart* chart_;
    QTableWidget* table_;
    QLabel* words_;
};

}  // namespace fulcrum::ui
