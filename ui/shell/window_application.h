// SPDX-License-Identifier: GPL-3.0-or-later
// The application of the window: an error that a page did not expect becomes a message and the window stays.
#pragma once

#include <QApplication>
#include <functional>

namespace fulcrum::ui {

class WindowApplication : public QApplication {
  public:
    using QApplication::QApplication;
    /// Who shows an error that an event's handler threw. Without one it goes to standard error.
    void set_trouble(std::function<void(const QString& line)> trouble) { trouble_ = std::move(trouble); }
    bool notify(QObject* receiver, QEvent* event) override;

  private:
    std::function<void(const QString&)> trouble_;
};

}  // namespace fulcrum::ui
