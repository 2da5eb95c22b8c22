// SPDX-License-Identifier: GPL-3.0-or-later
// Locks the window after a time without input, and says when it has been locked for as long again. Any key,
// button, wheel or pointer movement of the application counts, and whatever a device reports through
// note_input(). The time that the machine sleeps counts too.
#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>

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
    /// Input that comes when the time is over, before the lock, does not prevent it.
    void note_input();
    /// This long without input, which is counted from now on.
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
    std::int64_t input_ms_ = 0, lock_at_ms_ = 0;  ///< boot_ns(), in ms
    QTimer timer_;
};

}  // namespace fulcrum::ui
