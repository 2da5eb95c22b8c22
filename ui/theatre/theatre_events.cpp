// SPDX-License-Identifier: GPL-3.0-or-later
// What the theatre's page does with keys, mouse and wheel, and with another size.
#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>

#include "ui/style/palette.h"
#include "ui/style/widgets.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"
#include "ui/theatre/two_mice.h"

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
            view_->setFocus();
            if (mice_ != nullptr || pad_ != nullptr) return true;  // read by itself
            const auto* press = static_cast<QMouseEvent*>(event);
            const bool left_handed = input_->keys().left_handed();
            if (press->button() == (left_handed ? Qt::RightButton : Qt::LeftButton))
                input_->set_primary_button(true);
            if (press->button() == (left_handed ? Qt::LeftButton : Qt::RightButton)) input_->switch_hand();
            return true;
        }
        case QEvent::MouseButtonRelease:
            if (static_cast<QMouseEvent*>(event)->button() ==
                (input_->keys().left_handed() ? Qt::RightButton : Qt::LeftButton))
                input_->set_primary_button(false);
            return true;
        case QEvent::MouseMove:
            mouse_move(static_cast<QMouseEvent*>(event));
            return true;
        case QEvent::Wheel:
            if (live && mice_ == nullptr && pad_ == nullptr)
                input_->turn_wheel(static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0);
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

/// False while the person is asked to bring the handles of the device to where the attempt is to begin.
bool TheatrePage::hands_are_there() {
    if (watch_ == nullptr || session_->hands_at_start() != nullptr) return true;
    const QStringList lines =
        begin_place_.look(context().services(), session_->scene(), session_->snapshot());
    if (!lines.isEmpty() && !help_shown_)
        view_->set_cover(tr("Bring the handles to where you begin"),
                         lines + QStringList(tr("Enter: begin where they are")));
    if (lines.isEmpty() && !help_shown_ && !view_->cover().isEmpty()) view_->set_cover({}, {});
    return lines.isEmpty();
}

bool TheatrePage::key(QKeyEvent* event, bool pressed) {
    if (event->isAutoRepeat()) return true;
    if (!pressed) {
        input_->release_key(event->key(), event->nativeScanCode());
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
    if (input_->keys().action(event->key()) == KeyAction::sound) {
        toggle_sound();
        return true;
    }
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        if (!has_begun()) begin_place_.skip();
        if (aligning_) {
            session_->resume();
        } else if (help_shown_) {
            teach_again();
        } else if (learns_ && strip_->isVisible()) {
            skip_teaching();
        }
        return true;
    }
    if (mice_ != nullptr && input_->keys().action(event->key()) == KeyAction::other_hand) {
        if (takes_hands()) {
            mice_->swap();
            input_->release_all();
        }
        return true;
    }
    return takes_hands() && input_->press_key(event->key(), event->nativeScanCode());
}

void TheatrePage::mouse_move(QMouseEvent* event) {
    if (!takes_hands()) {
        mouse_known_ = false;
        return;
    }
    // Its place on the screen: the view moves under a pointer that rests when a message comes or goes and
    // when the window is maximised.
    const QPoint now = event->globalPos();
    if (!mouse_known_) put_back_to_.reset();
    // What the mouse did before the pointer was put back comes after it, with places at the border.
    if (put_back_to_ && (now - *put_back_to_).manhattanLength() < (now - last_mouse_).manhattanLength()) {
        last_mouse_ = *put_back_to_;
        put_back_to_.reset();
    }
    if (mouse_known_ && mice_ == nullptr && pad_ == nullptr) {
        const QPoint moved = now - last_mouse_;
        using Use = MouseKeyboardInput::MouseUse;
        const Qt::KeyboardModifiers with = event->modifiers();
        input_->move_mouse(moved, with.testFlag(Qt::ShiftModifier)     ? Use::turn
                                  : with.testFlag(Qt::ControlModifier) ? Use::turn_head
                                                                       : Use::move);
    }
    mouse_known_ = true;
    last_mouse_ = now;
    keep_pointer(event->pos());
}

/// What both mice did since the last call; thrown away while the attempt does not take it.
void TheatrePage::read_mice() {
    MouseMotion motion[hand_count];
    mice_->read(motion);
    const bool connected = motion[0].connected && motion[1].connected;
    if (connected != input_->targets().hand[0].present) input_->set_connected(connected);
    if (!takes_hands() || !view_->isVisible() || !view_->isActiveWindow()) return;
    for (int h = 0; h < hand_count; ++h) {
        const auto hand = static_cast<Hand>(h);
        input_->move_hand(hand, QPointF(motion[h].right, motion[h].down), motion[h].notches,
                          motion[h].turned_notches);
        input_->push_hand(hand, QPointF(motion[h].held_right, motion[h].held_down));
        input_->set_hand_buttons(hand, motion[h].left_button, motion[h].middle_button, motion[h].side_button);
        if (motion[h].right != 0 || motion[h].down != 0 || motion[h].held_down != 0) context().note_input();
    }
}

/// What the controller asked for since the last call; thrown away while the attempt does not take it.
void TheatrePage::read_controller() {
    const ControllerMotion motion = pad_->take();
    if (motion.connected != input_->targets().hand[0].present) {
        if (!motion.connected) input_->hold_jaws();
        input_->set_connected(motion.connected);
    }
    // Behind the lock nobody resumes: the scene is not seen.
    if (!motion.connected || !view_->isVisible() || !view_->window()->isActiveWindow()) return;
    if (motion.used) context().note_input();
    if (motion.starts % 2 == 1 && demonstrated_.isEmpty()) {
        if (aligning_) {
            session_->resume();
        } else if (shown_ == Panel::none) {
            pause();
        } else if (shown_ == Panel::paused) {
            resume();
        }
        return;
    }
    if (takes_hands()) input_->move_by_controller(motion);
}

/// Who works with a device that is not mouse or keyboard is there too: the window does not lock.
void TheatrePage::note_use() {
    if (watch_ == nullptr || watch_->uses() == seen_uses_) return;
    seen_uses_ = watch_->uses();
    context().note_input();
}

/// Remembered, as on the page of settings.
void TheatrePage::toggle_sound() {
    SoundChoice choice = context().services().sound_choice();
    choice.wanted = !choice.wanted;
    context().services().choose_sound(choice);
    show_sound();
}

void TheatrePage::show_sound() {
    const KeyMap keys = input_ != nullptr ? input_->keys() : KeyMap::standard(false);
    const QString words =
        context().services().sound_choice().wanted ? tr("Sound off (%1)") : tr("Sound on (%1)");
    sound_->setText(words.arg(keys.words(KeyAction::sound)));
}

/// Rumble, an intensity and no force, and sound: of a task that runs and is shown, also of a demonstration.
void TheatrePage::give_feedback() {
    const bool runs =
        session_ != nullptr && session_->phase() == AttemptPhase::running && shown_ == Panel::none;
    feedback_.follow(runs ? &session_->display() : nullptr, runs ? &session_->snapshot() : nullptr);
    ApplicationServices& services = context().services();
    services.play_sound(feedback_.sound());
    if (pad_ == nullptr) return;
    const RumbleStrength felt = services.rumble_wanted() ? feedback_.rumble() : RumbleStrength();
    pad_->rumble(felt.slow, felt.fast);
}

/// The hand's reach must not end at the window's border: from there the pointer is put back into the middle.
/// `place`: in the view.
void TheatrePage::keep_pointer(const QPoint& place) {
    if (put_back_to_ || !view_->isActiveWindow()) return;
    if (view_->rect().adjusted(40, 40, -40, -40).contains(place)) return;
    put_back_to_ = view_->mapToGlobal(view_->rect().center());
    QCursor::setPos(*put_back_to_);
}

void TheatrePage::place_panel() {
    const int width = std::min(with_text(560), this->width() - 40);
    panel_->setFixedWidth(width);
    // adjustSize() reserves too little for lines that are wrapped.
    panel_->resize(width, panel_->layout()->totalHeightForWidth(width));
    panel_->move((this->width() - width) / 2, std::max(20, (height() - panel_->height()) / 2 - 30));
}

void TheatrePage::resizeEvent(QResizeEvent* event) {
    Page::resizeEvent(event);
    place_panel();
    place_strip();
}

}  // namespace fulcrum::ui
