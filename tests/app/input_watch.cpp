// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/input_watch.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <numeric>

namespace fulcrum::app::program_test {

InputWatch::InputWatch(MouseButtons buttons) : buttons_(buttons) {
    clock_.start();
    qApp->installEventFilter(this);
}

InputWatch::~InputWatch() {
    qApp->removeEventFilter(this);
}

void InputWatch::restart() {
    presses_ = most_ = 0;
    held_.clear();
    time_with_.fill(0);
    since_ = clock_.nsecsElapsed();
}

void InputWatch::take_time() {
    const std::int64_t now = clock_.nsecsElapsed();
    time_with_[std::min(held_.size(), time_with_.size() - 1)] += now - since_;
    since_ = now;
}

double InputWatch::share_above(int count) {
    take_time();
    const std::int64_t all = std::accumulate(time_with_.begin(), time_with_.end(), std::int64_t{0});
    const std::int64_t above =
        std::accumulate(time_with_.begin() + count + 1, time_with_.end(), std::int64_t{0});
    return all > 0 ? static_cast<double>(above) / static_cast<double>(all) : 0;
}

bool InputWatch::set(Source source, int number, bool held) {
    take_time();
    if (!held) {
        held_.erase(std::make_pair(source, number));
        return false;
    }
    const bool added = held_.emplace(source, number).second;
    most_ = std::max(most_, static_cast<int>(held_.size()));
    return added;
}

void InputWatch::hold(int number, bool held) {
    set(Source::other, number, held);
}

void InputWatch::see_modifiers(Qt::KeyboardModifiers now) {
    for (const Qt::KeyboardModifier one : {Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier})
        set(Source::modifier, static_cast<int>(one), now.testFlag(one));
}

bool InputWatch::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::KeyRelease: {
            const auto* key = static_cast<QKeyEvent*>(event);
            see_modifiers(key->modifiers());
            const bool is_modifier = key->key() == Qt::Key_Shift || key->key() == Qt::Key_Control ||
                                     key->key() == Qt::Key_Alt || key->key() == Qt::Key_AltGr;
            if (key->isAutoRepeat() || is_modifier) return false;
            if (set(Source::key, key->key(), event->type() == QEvent::KeyPress)) ++presses_;
            return false;
        }
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseMove: {
            const auto* mouse = static_cast<QMouseEvent*>(event);
            see_modifiers(mouse->modifiers());
            if (event->type() == QEvent::MouseMove || buttons_ == MouseButtons::of_hold) return false;
            const bool pressed = event->type() != QEvent::MouseButtonRelease;
            if (set(Source::mouse, static_cast<int>(mouse->button()), pressed)) ++presses_;
            return false;
        }
        default:
            return false;
    }
}

}  // namespace fulcrum::app::program_test
