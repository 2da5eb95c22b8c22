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
    static constexpr int first_look_ms = 3000;  ///< after the sign-in: the first page is drawn first
    static constexpr int every_ms = 60000;

    /// `attempt_runs`: asked before each look.
    ReplayWatch(Context& context, std::function<bool()> attempt_runs, QObject* parent = nullptr,
                int first_ms = first_look_ms, int then_ms = every_ms);

  private:
    void session_changed();
    void look();

    Context& context_;
    const std::function<bool()> attempt_runs_;
    const int first_ms_, then_ms_;
    QTimer timer_;
};

}  // namespace fulcrum::ui
