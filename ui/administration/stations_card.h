// SPDX-License-Identifier: GPL-3.0-or-later
// On the page Station: the other stations of the programme that this store knows, and when each was heard of.
#pragma once

#include <QFrame>
#include <vector>

#include "database/records/stations.h"
#include "ui/page/context.h"

class QTableWidget;

namespace fulcrum::ui {

class BackgroundJob;

class StationsCard : public QFrame {
    Q_OBJECT
  public:
    explicit StationsCard(Context& context);
    /// Reads in the background. Hidden until then, and where this station is the only one.
    void look();
    void stop();

  private:
    void show_stations(const std::vector<database::KnownStation>& stations);

    Context& context_;
    QTableWidget* table_;
    BackgroundJob* job_ = nullptr;
};

}  // namespace fulcrum::ui
