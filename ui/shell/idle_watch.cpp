// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/idle_watch.h"

#include <QCoreApplication>
#include <QEvent>

namespace fulcrum::ui {

IdleWatch::IdleWatch(QObject* parent, int lock_ms, int close_ms)
    : QObject(parent), lock_ms_(lock_ms), close_ms_(close_ms) {
    since_input_.start();
    lock_after(lock_ms);
    connect(&timer_, &QTimer::timeout, this, &IdleWatch::look);
    QCoreApplication::instance()->installEventFilter(this);
}

void IdleWatch::set_active(bool active) {
    active_ = active;
    locked_ = closed_ = false;
    since_input_.restart();
    if (active) {
        timer_.start();
    } else {
        timer_.stop();
    }
}

void IdleWatch::lock_after(int milliseconds) {
    lock_ms_ = milliseconds;
    timer_.setInterval(qBound(10, milliseconds / 20, 1000));
}

void IdleWatch::note_input() {
    since_input_.restart();
}

void IdleWatch::unlocked() {
    locked_ = closed_ = false;
    since_input_.restart();
}

bool IdleWatch::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::Wheel:
        case QEvent::TouchBegin:
        case QEvent::TabletPress:
            if (event->spontaneous() || event->type() != QEvent::MouseMove) since_input_.restart();
            break;
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

void IdleWatch::look() {
    if (!active_) return;
    if (!locked_) {
        if (since_input_.elapsed() < lock_ms_) return;
        locked_ = true;
        since_lock_.start();
        emit lock();
    } else if (!closed_ && since_lock_.elapsed() >= close_ms_) {
        closed_ = true;
        emit close_attempt();
    }
}

}  // namespace fulcrum::ui

#include "moc_idle_watch.cpp"
