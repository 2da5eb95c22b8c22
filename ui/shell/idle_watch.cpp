// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/idle_watch.h"

#include <QCoreApplication>
#include <QEvent>

#include "sim_core/numerics/boot_clock.h"

namespace fulcrum::ui {
namespace {

std::int64_t now_ms() {
    return boot_ns() / 1'000'000;
}

}  // namespace

IdleWatch::IdleWatch(QObject* parent, int lock_ms, int close_ms)
    : QObject(parent), lock_ms_(lock_ms), close_ms_(close_ms) {
    lock_after(lock_ms);
    connect(&timer_, &QTimer::timeout, this, &IdleWatch::look);
    QCoreApplication::instance()->installEventFilter(this);
}

void IdleWatch::set_active(bool active) {
    active_ = active;
    unlocked();
    if (active) {
        timer_.start();
    } else {
        timer_.stop();
    }
}

void IdleWatch::lock_after(int milliseconds) {
    lock_ms_ = milliseconds;
    input_ms_ = now_ms();
    timer_.setInterval(qBound(10, milliseconds / 20, 1000));
}

void IdleWatch::note_input() {
    const std::int64_t now = now_ms();
    if (now - input_ms_ < lock_ms_) input_ms_ = now;
}

void IdleWatch::unlocked() {
    locked_ = closed_ = false;
    input_ms_ = now_ms();
}

bool IdleWatch::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::Wheel:
        case QEvent::TouchBegin:
        case QEvent::TabletPress:
            if (event->spontaneous() || event->type() != QEvent::MouseMove) note_input();
            break;
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

void IdleWatch::look() {
    if (!active_) return;
    if (!locked_) {
        if (now_ms() - input_ms_ < lock_ms_) return;
        locked_ = true;
        lock_at_ms_ = now_ms();
        emit lock();
    } else if (!closed_ && now_ms() - lock_at_ms_ >= close_ms_) {
        closed_ = true;
        emit close_attempt();
    }
}

}  // namespace fulcrum::ui

#include "moc_idle_watch.cpp"
