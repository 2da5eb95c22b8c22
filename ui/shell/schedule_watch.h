// SPDX-License-Identifier: GPL-3.0-or-later
// Writes scheduled reports that are due while a director is signed in at a station: looked at once a minute,
// written in the background. One that failed is tried again after an hour.
#pragma once

#include <QObject>
#include <QTimer>
#include <map>
#include <string>

#include "ui/page/context.h"

namespace fulcrum::ui {

class ScheduleWatch : public QObject {
    Q_OBJECT
  public:
    explicit ScheduleWatch(Context& context, QObject* parent = nullptr);
    /// Looks now; what a minute does.
    void look();
    bool is_writing() const { return job_ != nullptr; }

  private:
    void session_changed();

    Context& context_;
    QTimer timer_;
    BackgroundJob* job_ = nullptr;
    std::map<std::string, std::int64_t> not_before_;  ///< by schedule, UTC ms: of those that failed
};

}  // namespace fulcrum::ui
