// SPDX-License-Identifier: GPL-3.0-or-later
// What the theatre's page does with keys, mouse and wheel.
#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui {

bool TheatrePage::eventFilter(QObject* watched, QEvent* event) {
    if (watched != view_ || session_ == nullptr || input_ == nullptr)
        return Page::eventFilter(watched, event);
    const bool live = takes_hands();
    switch (event->type()) {
        case QEvent::ShortcutOverride:
            event->accept();
            return true;
        case QEvent::KeyPress:
            return key(static_cast<QKeyEvent*>(event), true);
        case QEvent::KeyRelease:
            return key(static_cast<QKeyEvent*>(event), false);
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick: {
            if (!live) return false;
            const auto* press = static_cast<QMouseEvent*>(event);
            if (press->button() == Qt::LeftButton) input_->set_primary_button(true);
            if (press->button() == Qt::RightButton) input_->switch_hand();
            view_->setFocus();
            return true;
        }
        case QEvent::MouseButtonRelease:
            if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
                input_->set_primary_button(false);
            return true;
        case QEvent::MouseMove:
            mouse_move(static_cast<QMouseEvent*>(event));
            return true;
        case QEvent::Wheel:
            if (live) input_->turn_wheel(static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0);
            return true;
        case QEvent::Leave:
            mouse_known_ = false;
            return false;
        case QEvent::FocusOut:
            input_->release_all();
            return false;
        default:
            return Page::eventFilter(watched, event);
    }
}

bool TheatrePage::takes_hands() const {
    return session_ != nullptr && shown_ == Panel::none && demonstrated_.isEmpty() &&
           (session_->phase() == AttemptPhase::running || aligning_);
}

bool TheatrePage::key(QKeyEvent* event, bool pressed) {
    if (event->isAutoRepeat()) return true;
    if (!pressed) {
        input_->release_key(event->key());
        return true;
    }
    if (event->key() == Qt::Key_Escape) {
        if (help_shown_) {
            toggle_help();
        } else if (!has_begun() || aligning_ || !demonstrated_.isEmpty()) {
            ask_before_leaving();
        } else {
            pause();
        }
        return true;
    }
    if (event->key() == Qt::Key_F1) {
        toggle_help();
        return true;
    }
    if (aligning_ && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
        session_->resume();
        return true;
    }
    return takes_hands() && input_->press_key(event->key());
}

void TheatrePage::mouse_move(QMouseEvent* event) {
    if (!takes_hands()) {
        mouse_known_ = false;
        return;
    }
    const QPoint now = event->pos();
    if (mouse_known_) {
        const QPoint moved = now - last_mouse_;
        using Use = MouseKeyboardInput::MouseUse;
        const Qt::KeyboardModifiers with = event->modifiers();
        input_->move_mouse(moved, with.testFlag(Qt::ShiftModifier)     ? Use::turn
                                  : with.testFlag(Qt::ControlModifier) ? Use::turn_head
                                                                       : Use::move);
    }
    mouse_known_ = true;
    last_mouse_ = now;
    // The hand's reach must not end at the window's border: from there the pointer is put back into the
    // middle.
    if (!view_->rect().adjusted(40, 40, -40, -40).contains(now) && view_->isActiveWindow()) {
        last_mouse_ = view_->rect().center();
        QCursor::setPos(view_->mapToGlobal(last_mouse_));
    }
}

}  // namespace fulcrum::ui
