// SPDX-License-Identifier: GPL-3.0-or-later
// On the page Station: the other stations of the programme that this store knows, and when each was heard of.
#pragma once

#include <QFrame>

#include "ui/page/context.h"

class QTableWidget;

namespace fulcrum::ui {

class StationsCard : public QFrame {
    Q_OBJECT
  public:
    explicit StationsCard(Context& context);
    /// Hidden where this station is the only one.
    void look();

  private:
    Context& context_;
    QTableWidget* table_;
};

}  // namespace fulcrum::ui
