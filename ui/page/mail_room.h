// SPDX-License-Identifier: GPL-3.0-or-later
// What other threads leave to be done on this one. A lock of our own guards the letters, so that a sanitizer
// sees the hand-over that Qt's event queue hides from it.
#pragma once

#include <QObject>
#include <functional>
#include <mutex>
#include <vector>

namespace fulcrum::ui {

class MailRoom : public QObject {
    Q_OBJECT

  public:
    /// The UI thread's; lives as long as the application object. UI thread.
    static MailRoom* of_application();
    /// Runs `letter` on the UI thread, in the order of posting. Any thread.
    void post(std::function<void()> letter);

  private:
    using QObject::QObject;
    Q_INVOKABLE void deliver();
    std::mutex mutex_;
    std::vector<std::function<void()>> letters_;
};

}  // namespace fulcrum::ui
