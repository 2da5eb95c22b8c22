// SPDX-License-Identifier: GPL-3.0-or-later
// Has replays made ready while somebody is signed in and no attempt runs: looks once a minute whether there
// are attempts whose replay would have to be simulated first, however they came into the store.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

#include "ui/page/context.h"

namespace fulcrum::ui {

class ReplayWatch : public QObject {
    Q_OBJECT
  public:
    /// `attempt_runs`: asked before each look.
    ReplayWatch(Context& context, std::function<bool()> attempt_runs, QObject* parent = nullptr);

  private:
    void session_changed();
    void look();

    Context& context_;
    std::function<bool()> attempt_runs_;
    QTimer timer_;
};

}  // namespace fulcrum::ui
