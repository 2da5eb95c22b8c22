// SPDX-License-Identifier: GPL-3.0-or-later
// A line on pages about cohorts: that this station holds some of the programme's cohorts only.
#pragma once

#include <QLabel>

#include "ui/page/context.h"

namespace fulcrum::ui {

class StationNote : public QLabel {
  public:
    StationNote();
    /// Shows the line where it is true for who is signed in, and nothing else.
    void look(Context& context);
};

}  // namespace fulcrum::ui
