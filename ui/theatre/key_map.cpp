// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/key_map.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QSettings>
#include <algorithm>

namespace fulcrum::ui {
namespace {

using A = KeyAction;
using G = KeyGroup;

constexpr const char* context = "fulcrum::key_actions";

// Qt asks for the names of keys in this context; its own translations are not part of the program.
[[maybe_unused]] constexpr const char* key_names[] = {
    QT_TRANSLATE_NOOP("QShortcut", "Up"),    QT_TRANSLATE_NOOP("QShortcut", "Left"),
    QT_TRANSLATE_NOOP("QShortcut", "Down"),  QT_TRANSLATE_NOOP("QShortcut", "Right"),
    QT_TRANSLATE_NOOP("QShortcut", "PgUp"),  QT_TRANSLATE_NOOP("QShortcut", "PgDown"),
    QT_TRANSLATE_NOOP("QShortcut", "Home"),  QT_TRANSLATE_NOOP("QShortcut", "End"),
    QT_TRANSLATE_NOOP("QShortcut", "Space"), QT_TRANSLATE_NOOP("QShortcut", "Backspace"),
    QT_TRANSLATE_NOOP("QShortcut", "Del"),   QT_TRANSLATE_NOOP("QShortcut", "Ins")};

/// The same key under its usual number.
int plain_key(int key) {
    return key == Qt::Key_Backtab ? static_cast<int>(Qt::Key_Tab) : key;
}

QString settings_key(const std::string& person_id, const QString& name) {
    return QStringLiteral("keys/%1/%2")
        .arg(person_id.empty() ? QStringLiteral("station") : QString::fromStdString(person_id), name);
}

}  // namespace

const std::array<KeyActionRow, key_action_count>& key_actions() {
    static const std::array<KeyActionRow, key_action_count> rows = {{
        {A::left_up, G::left, "left_up", QT_TRANSLATE_NOOP("fulcrum::key_actions", "handle up"), Qt::Key_W,
         Qt::Key_W},
        {A::left_left, G::left, "left_left", QT_TRANSLATE_NOOP("fulcrum::key_actions", "handle to the left"),
         Qt::Key_A, Qt::Key_A},
        {A::left_down, G::left, "left_down", QT_TRANSLATE_NOOP("fulcrum::key_actions", "handle down"),
         Qt::Key_S, Qt::Key_S},
        {A::left_right, G::left, "left_right",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "handle to the right"), Qt::Key_D, Qt::Key_D},
        {A::left_in, G::left, "left_in", QT_TRANSLATE_NOOP("fulcrum::key_actions", "in"), Qt::Key_R,
         Qt::Key_R},
        {A::left_out, G::left, "left_out", QT_TRANSLATE_NOOP("fulcrum::key_actions", "out"), Qt::Key_F,
         Qt::Key_F},
        {A::left_turn_back, G::left, "left_turn_back",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "turn to the left"), Qt::Key_Q, Qt::Key_Q},
        {A::left_turn, G::left, "left_turn", QT_TRANSLATE_NOOP("fulcrum::key_actions", "turn to the right"),
         Qt::Key_E, Qt::Key_E},
        {A::left_jaws, G::left, "left_jaws",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "jaws stay closed, or open"), Qt::Key_X, Qt::Key_X},
        {A::right_up, G::right, "right_up", QT_TRANSLATE_NOOP("fulcrum::key_actions", "handle up"), Qt::Key_I,
         Qt::Key_I},
        {A::right_left, G::right, "right_left",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "handle to the left"), Qt::Key_J, Qt::Key_J},
        {A::right_down, G::right, "right_down", QT_TRANSLATE_NOOP("fulcrum::key_actions", "handle down"),
         Qt::Key_K, Qt::Key_K},
        {A::right_right, G::right, "right_right",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "handle to the right"), Qt::Key_L, Qt::Key_L},
        {A::right_in, G::right, "right_in", QT_TRANSLATE_NOOP("fulcrum::key_actions", "in"), Qt::Key_P,
         Qt::Key_P},
        {A::right_out, G::right, "right_out", QT_TRANSLATE_NOOP("fulcrum::key_actions", "out"),
         Qt::Key_Semicolon, Qt::Key_Semicolon},
        {A::right_turn_back, G::right, "right_turn_back",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "turn to the left"), Qt::Key_U, Qt::Key_U},
        {A::right_turn, G::right, "right_turn",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "turn to the right"), Qt::Key_O, Qt::Key_O},
        {A::right_jaws, G::right, "right_jaws",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "jaws stay closed, or open"), Qt::Key_M, Qt::Key_M},
        {A::scope_up, G::scope, "scope_up", QT_TRANSLATE_NOOP("fulcrum::key_actions", "look up"), Qt::Key_Up,
         Qt::Key_Up},
        {A::scope_left, G::scope, "scope_left", QT_TRANSLATE_NOOP("fulcrum::key_actions", "look to the left"),
         Qt::Key_Left, Qt::Key_Left},
        {A::scope_down, G::scope, "scope_down", QT_TRANSLATE_NOOP("fulcrum::key_actions", "look down"),
         Qt::Key_Down, Qt::Key_Down},
        {A::scope_right, G::scope, "scope_right",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "look to the right"), Qt::Key_Right, Qt::Key_Right},
        {A::scope_in, G::scope, "scope_in", QT_TRANSLATE_NOOP("fulcrum::key_actions", "in"), Qt::Key_PageUp,
         Qt::Key_PageUp},
        {A::scope_out, G::scope, "scope_out", QT_TRANSLATE_NOOP("fulcrum::key_actions", "out"),
         Qt::Key_PageDown, Qt::Key_PageDown},
        {A::post_back, G::scope, "post_back",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "light post to the left"), Qt::Key_Home, Qt::Key_Home},
        {A::post, G::scope, "post", QT_TRANSLATE_NOOP("fulcrum::key_actions", "light post to the right"),
         Qt::Key_End, Qt::Key_End},
        {A::head, G::scope, "head", QT_TRANSLATE_NOOP("fulcrum::key_actions", "camera head to the left"),
         Qt::Key_Comma, Qt::Key_Comma},
        {A::head_back, G::scope, "head_back",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "camera head to the right"), Qt::Key_Period,
         Qt::Key_Period},
        {A::other_hand, G::active, "other_hand",
         QT_TRANSLATE_NOOP("fulcrum::key_actions", "the mouse takes the other hand"), Qt::Key_Tab,
         Qt::Key_Backspace},
        {A::jaws, G::active, "jaws", QT_TRANSLATE_NOOP("fulcrum::key_actions", "jaws stay closed, or open"),
         Qt::Key_Space, Qt::Key_Space},
        {A::pedal, G::active, "pedal", QT_TRANSLATE_NOOP("fulcrum::key_actions", "pedal (energy, suction)"),
         Qt::Key_B, Qt::Key_N},
        {A::exchange, G::active, "exchange", QT_TRANSLATE_NOOP("fulcrum::key_actions", "next instrument"),
         Qt::Key_T, Qt::Key_Y},
        {A::sound, G::program, "sound", QT_TRANSLATE_NOOP("fulcrum::key_actions", "sound off, on"),
         Qt::Key_F2, Qt::Key_F2},
    }};
    return rows;
}

QString title_of(KeyAction action) {
    return QCoreApplication::translate(context, key_actions()[static_cast<std::size_t>(action)].title);
}

QString title_of(KeyGroup group) {
    switch (group) {
        case KeyGroup::left:
            return QCoreApplication::translate("fulcrum::key_actions", "Left hand");
        case KeyGroup::right:
            return QCoreApplication::translate("fulcrum::key_actions", "Right hand");
        case KeyGroup::scope:
            return QCoreApplication::translate("fulcrum::key_actions", "Scope");
        case KeyGroup::active:
            return QCoreApplication::translate("fulcrum::key_actions", "Hand that the mouse moves");
        case KeyGroup::program:
            return QCoreApplication::translate("fulcrum::key_actions", "Program");
    }
    return {};
}

KeyMap KeyMap::standard(bool left_handed) {
    KeyMap map;
    map.left_handed_ = left_handed;
    for (const KeyActionRow& row : key_actions())
        map.keys_[static_cast<std::size_t>(row.action)] = left_handed ? row.left_handed_key : row.key;
    return map;
}

KeyMap KeyMap::of_person(const std::string& person_id) {
    const QSettings settings;
    const auto kept = [&](const char* name) {
        return settings.value(settings_key(person_id, QLatin1String(name))).toString();
    };
    const KeyMap usual = standard(kept("left_handed") == QLatin1String("yes"));
    KeyMap map = usual;
    for (const KeyActionRow& row : key_actions()) {
        const QString words = kept(row.name);
        if (words.isEmpty()) continue;
        const QKeySequence sequence = QKeySequence::fromString(words, QKeySequence::PortableText);
        if (sequence.count() != 1 || !can_be_used(sequence[0])) continue;
        map.keys_[static_cast<std::size_t>(row.action)] = sequence[0];
    }
    // Where a person chose the usual key of the sound before it had one, it takes the next that is free.
    auto& sound = map.keys_[static_cast<std::size_t>(A::sound)];
    const auto users = [&] { return std::count(map.keys_.begin(), map.keys_.end(), sound); };
    if (kept("sound").isEmpty())
        while (users() > 1 && sound < Qt::Key_F12) ++sound;
    for (std::size_t i = 0; i < key_action_count; ++i)
        for (std::size_t j = i + 1; j < key_action_count; ++j)
            if (map.keys_[i] == map.keys_[j]) return usual;
    return map;
}

void KeyMap::keep_for(const std::string& person_id) const {
    QSettings settings;
    settings.remove(settings_key(person_id, {}).chopped(1));
    if (left_handed_)
        settings.setValue(settings_key(person_id, QStringLiteral("left_handed")), QStringLiteral("yes"));
    const KeyMap usual = standard(left_handed_);
    for (const KeyActionRow& row : key_actions())
        if (key(row.action) != usual.key(row.action))
            settings.setValue(settings_key(person_id, QLatin1String(row.name)),
                              QKeySequence(key(row.action)).toString(QKeySequence::PortableText));
}

std::optional<KeyAction> KeyMap::action(int key) const {
    for (std::size_t i = 0; i < key_action_count; ++i)
        if (keys_[i] == plain_key(key)) return static_cast<KeyAction>(i);
    return std::nullopt;
}

QString KeyMap::words(KeyAction action) const {
    return QKeySequence(key(action)).toString(QKeySequence::NativeText);
}

QString KeyMap::words(std::initializer_list<KeyAction> actions) const {
    QStringList all;
    for (const KeyAction one : actions) all << words(one);
    return all.join(QLatin1Char(' '));
}

bool KeyMap::is_needed(int key) {
    switch (key) {
        case Qt::Key_Escape:
        case Qt::Key_F1:
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Shift:
        case Qt::Key_Control:
        case Qt::Key_Alt:
        case Qt::Key_AltGr:
        case Qt::Key_Meta:
        case Qt::Key_CapsLock:
        case Qt::Key_NumLock:
            return true;
        default:
            return (key & static_cast<int>(Qt::KeyboardModifierMask)) != 0;
    }
}

bool KeyMap::can_be_used(int key) {
    if (key == 0 || key == Qt::Key_unknown || is_needed(key)) return false;
    // Qt has no name for a dead key, and another key's for a few letters.
    constexpr auto kept_as = QKeySequence::PortableText;
    return QKeySequence::fromString(QKeySequence(key).toString(kept_as), kept_as) == QKeySequence(key);
}

std::optional<KeyAction> KeyMap::assign(KeyAction action, int key) {
    if (!can_be_used(key)) return std::nullopt;
    const std::optional<KeyAction> other = this->action(key);
    if (other && *other != action) return other;
    keys_[static_cast<std::size_t>(action)] = plain_key(key);
    return std::nullopt;
}

}  // namespace fulcrum::ui
