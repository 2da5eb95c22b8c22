// SPDX-License-Identifier: GPL-3.0-or-later
// Locks the window after a time without input, and says when it has been locked for as long again. Any key,
// button, wheel or pointer movement of the application counts, and whatever a device reports through
// note_input().
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace fulcrum::ui {

class IdleWatch : public QObject {
    Q_OBJECT
  public:
    static constexpr int lock_after_ms = 10 * 60 * 1000;
    static constexpr int close_after_ms = 10 * 60 * 1000;

    /// Other durations serve tests.
    explicit IdleWatch(QObject* parent, int lock_ms = lock_after_ms, int close_ms = close_after_ms);
    /// Watches only while someone is signed in.
    void set_active(bool active);
    void note_input();
    /// From now on, ms without input.
    void lock_after(int milliseconds);
    /// The lock was lifted.
    void unlocked();
    bool locked() const { return locked_; }

  signals:
    void lock();
    /// Locked for close_ms: a running attempt is closed as interrupted.
    void close_attempt();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void look();
    int lock_ms_, close_ms_;
    bool active_ = false, locked_ = false, closed_ = false;
    QElapsedTimer since_input_, since_lock_;
    QTimer timer_;
};

}  // namespace fulcrum::ui
