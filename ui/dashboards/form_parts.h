// SPDX-License-Identifier: GPL-3.0-or-later
// What the forms of the curriculum are built from.
#pragma once

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <initializer_list>
#include <vector>

#include "assessment/curriculum/curriculum_draft.h"

class QLabel;

namespace fulcrum::ui {

struct CurriculumWords {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::CurriculumPage)
};

/// For the problems of a form; hidden until there are some.
QLabel* make_problems(const char* name);
/// The problems of these fields, a line each; hidden without any.
void put_problems(QLabel* label, const std::vector<CurriculumProblem>& problems, std::size_t index,
                  std::initializer_list<CurriculumField> fields);
/// For values as they are in files. A box rounds what it is given: as long as the person does not change it,
/// it stands for the value behind it, with all its digits.
class ExactBox : public QDoubleSpinBox {
  public:
    using QDoubleSpinBox::QDoubleSpinBox;
    /// With as many decimals as it needs, at least `least_decimals`.
    void show_value(double exact, int least_decimals);
    double exact_value() const { return value() == shown_ ? exact_ : value(); }

  private:
    double exact_ = 0, shown_ = 0;
};
/// A row with its name in front.
QWidget* add_named(QFormLayout* form, const QString& name, QWidget* field);
QFormLayout* make_form();

}  // namespace fulcrum::ui
