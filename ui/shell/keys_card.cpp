// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/keys_card.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QKeyEvent>
#include <QKeySequence>
#include <QRadioButton>

#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

KeysCard::KeysCard(Context& context) : context_(context), layout_(new QButtonGroup(this)) {
    setProperty("role", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(18, 16, 18, 16);
    column->setSpacing(8);
    column->addWidget(make_label(tr("Mouse and keys for the hands"), "heading"));
    column->addWidget(make_label(tr("Saved for you on this computer. A change applies from the next attempt. "
                                    "The keys are shown when an attempt begins, and when you press F1."),
                                 "muted"));
    auto* choices = new QWidget;
    auto* row = new FlowRow(choices);
    const std::pair<QString, const char*> layouts[] = {{tr("Mouse in the right hand"), "keys_right_handed"},
                                                       {tr("Mouse in the left hand"), "keys_left_handed"}};
    for (int i = 0; i < 2; ++i) {
        auto* choice = new QRadioButton(layouts[i].first);
        choice->setObjectName(QLatin1String(layouts[i].second));
        choice->setAccessibleName(layouts[i].first);
        layout_->addButton(choice, i);
        row->add(choice);
    }
    column->addWidget(choices);
    column->addWidget(
        make_label(tr("With the mouse in the left hand, its two buttons are swapped, and the keys of the "
                      "mouse's hand move to the right side of the keyboard. This choice resets all keys."),
                   "muted"));
    auto* groups = new QWidget;
    auto* flow = new FlowRow(groups);
    for (const KeyGroup group :
         {KeyGroup::left, KeyGroup::right, KeyGroup::scope, KeyGroup::active, KeyGroup::program})
        flow->add(build_group(group), 1);
    column->addWidget(groups);
    message_ = make_label({});
    message_->setObjectName(QStringLiteral("keys_message"));
    column->addWidget(message_);
    QPushButton* reset = make_button(tr("Reset all keys"), "reset_keys");
    column->addWidget(reset, 0, Qt::AlignLeft);
    const auto use_standard = [this](bool left_handed) {
        waiting_.reset();
        map_ = KeyMap::standard(left_handed);
        message_->clear();
        keep();
    };
    connect(layout_, &QButtonGroup::idClicked, this, [use_standard](int id) { use_standard(id == 1); });
    connect(reset, &QPushButton::clicked, this, [this, use_standard] { use_standard(map_.left_handed()); });
}

QWidget* KeysCard::build_group(KeyGroup group) {
    auto* holder = new QWidget;
    auto* grid = new QGridLayout(holder);
    grid->setContentsMargins(0, 4, 18, 4);
    grid->setVerticalSpacing(4);
    auto* heading = new QLabel(title_of(group));
    set_role(heading, "neutral");
    grid->addWidget(heading, 0, 0, 1, 2);
    for (const KeyActionRow& row : key_actions()) {
        if (row.group != group) continue;
        QPushButton* key = make_button({}, "");
        key->setObjectName(QStringLiteral("key_") + QLatin1String(row.name));
        key->installEventFilter(this);
        keys_[static_cast<std::size_t>(row.action)] = key;
        auto* title = new QLabel(title_of(row.action));
        const int line = grid->rowCount();
        grid->addWidget(key, line, 0);
        grid->addWidget(title, line, 1);
        connect(key, &QPushButton::clicked, this, [this, action = row.action] { wait_for_key(action); });
    }
    grid->setRowStretch(grid->rowCount(), 1);
    grid->setColumnStretch(1, 1);
    return holder;
}

void KeysCard::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    waiting_.reset();
    message_->clear();
    map_ = KeyMap::of_person(context_.session().person_id());
    show_keys();
}

void KeysCard::show_keys() {
    layout_->button(map_.left_handed() ? 1 : 0)->setChecked(true);
    for (const KeyActionRow& row : key_actions()) {
        QPushButton* key = keys_[static_cast<std::size_t>(row.action)];
        const bool waits = waiting_ == row.action;
        key->setText(waits ? QStringLiteral("…") : map_.words(row.action));
        key->setAccessibleName(
            tr("%1, %2: %3").arg(title_of(row.group), title_of(row.action), map_.words(row.action)));
    }
    message_->setVisible(!message_->text().isEmpty());
}

/// What the person is asked for, or why a key was not taken.
void KeysCard::say(const char* role, const QString& words) {
    set_role(message_, role);
    announce_problem(message_, words);
    show_keys();
}

void KeysCard::wait_for_key(KeyAction action) {
    waiting_ = action;
    say(nullptr, tr("Press the new key for “%1”, or Escape.").arg(title_of(action)));
    keys_[static_cast<std::size_t>(action)]->setFocus();
}

bool KeysCard::eventFilter(QObject* watched, QEvent* event) {
    if (!waiting_ || watched != keys_[static_cast<std::size_t>(*waiting_)])
        return QFrame::eventFilter(watched, event);
    switch (event->type()) {
        case QEvent::ShortcutOverride:
            event->accept();
            return true;
        case QEvent::KeyPress:
            if (!static_cast<QKeyEvent*>(event)->isAutoRepeat())
                take_key(static_cast<QKeyEvent*>(event)->key());
            return true;
        case QEvent::KeyRelease:
            return true;  // of the key that chose the button
        case QEvent::FocusOut:
            waiting_.reset();
            message_->clear();
            show_keys();
            return false;
        default:
            return false;
    }
}

void KeysCard::take_key(int key) {
    if (key == Qt::Key_Escape) {
        waiting_.reset();
        message_->clear();
        show_keys();
        return;
    }
    const QString pressed = QKeySequence(key).toString(QKeySequence::NativeText);
    if (!KeyMap::can_be_used(key)) {
        say("bad",
            KeyMap::is_needed(key)
                ? tr("This key is needed for something else. Press another one, or Escape.")
                : tr("This key has no name under which it could be kept. Press another one, or Escape."));
        return;
    }
    if (const std::optional<KeyAction> other = map_.assign(*waiting_, key)) {
        say("bad", tr("%1 is already used (%2: %3). Press another key, or Escape and change that one first.")
                       .arg(pressed, title_of(key_actions()[static_cast<std::size_t>(*other)].group),
                            title_of(*other)));
        return;
    }
    message_->clear();
    waiting_.reset();
    keep();
}

void KeysCard::keep() {
    map_.keep_for(context_.session().person_id());
    show_keys();
}

}  // namespace fulcrum::ui

#include "moc_keys_card.cpp"
