// SPDX-License-Identifier: GPL-3.0-or-later
// What a person has to press: keys and clicks that any part of the window gets, counted as they arrive, how
// many are held at the same time, and for how long. Buttons of a device that Qt does not read are reported
// by the test that presses them.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <array>
#include <set>
#include <utility>

namespace fulcrum::app::program_test {

/// Sees every event of the application while it exists.
class InputWatch : public QObject {
  public:
    /// Where both mice are read one by one their buttons come by hold(), not as events.
    enum class MouseButtons { of_events, of_hold };
    explicit InputWatch(MouseButtons buttons = MouseButtons::of_events);
    ~InputWatch() override;

    /// Counts from now on, with nothing held: a window that was left gets no release.
    void restart();
    /// Keys and mouse buttons that went down. One that repeats itself, or that a widget passes on to the one
    /// around it, counts once; Shift, Ctrl and Alt do not.
    int presses() const { return presses_; }
    /// A button of another device; neither a key nor a click.
    void hold(int number, bool held);
    int most_held() const { return most_; }
    /// Of the time since restart(), with more than so many held, Shift, Ctrl and Alt among them.
    double share_above(int count);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    enum class Source { key, mouse, modifier, other };
    /// Whether it is new.
    bool set(Source source, int number, bool held);
    void see_modifiers(Qt::KeyboardModifiers now);
    void take_time();

    MouseButtons buttons_;
    std::set<std::pair<Source, int>> held_;
    int presses_ = 0, most_ = 0;
    QElapsedTimer clock_;
    std::int64_t since_ = 0;                    // ns of the clock
    std::array<std::int64_t, 16> time_with_{};  // ns, by how many were held
};

}  // namespace fulcrum::app::program_test
