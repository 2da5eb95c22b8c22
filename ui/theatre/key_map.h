// SPDX-License-Identifier: GPL-3.0-or-later
// Which key does what in the theatre. A person can change it on the page of settings; it is kept for that
// person on this computer.
#pragma once

#include <QString>
#include <QStringList>
#include <array>
#include <optional>
#include <string>

namespace fulcrum::ui {

enum class KeyAction : std::uint8_t {
    left_up,
    left_left,
    left_down,
    left_right,
    left_in,
    left_out,
    left_turn_back,
    left_turn,
    left_jaws,
    right_up,
    right_left,
    right_down,
    right_right,
    right_in,
    right_out,
    right_turn_back,
    right_turn,
    right_jaws,
    scope_up,
    scope_left,
    scope_down,
    scope_right,
    scope_in,
    scope_out,
    post_back,
    post,
    head,
    head_back,
    other_hand,
    jaws,
    pedal,
    exchange,
    sound
};
inline constexpr std::size_t key_action_count = 33;
enum class KeyGroup : std::uint8_t { left, right, scope, active, program };

struct KeyActionRow {
    KeyAction action;
    KeyGroup group;
    const char* name;   ///< in the settings
    const char* title;  ///< of the context fulcrum::key_actions
    int key, left_handed_key;
};
const std::array<KeyActionRow, key_action_count>& key_actions();
QString title_of(KeyAction action);
QString title_of(KeyGroup group);

class KeyMap {
  public:
    /// The usual keys. With the mouse in the left hand, the keys of the active hand are on the right side of
    /// the keyboard, and the mouse's buttons change places.
    static KeyMap standard(bool left_handed);
    /// What this person chose here, else the usual keys. Of damaged settings an action that cannot be read
    /// has its usual key, and all have where two would have the same.
    static KeyMap of_person(const std::string& person_id);
    void keep_for(const std::string& person_id) const;

    bool left_handed() const { return left_handed_; }
    int key(KeyAction action) const { return keys_[static_cast<std::size_t>(action)]; }
    std::optional<KeyAction> action(int key) const;
    QString words(KeyAction action) const;
    /// Several keys, for a line of help.
    QString words(std::initializer_list<KeyAction> actions) const;
    /// Escape, F1, Enter or a key that changes others.
    static bool is_needed(int key);
    /// Nothing needs this key for something else, and it has a name under which it is kept.
    static bool can_be_used(int key);
    /// Refused where another action has the key, which is returned, or where the key cannot be used.
    std::optional<KeyAction> assign(KeyAction action, int key);
    bool operator==(const KeyMap& other) const {
        return left_handed_ == other.left_handed_ && keys_ == other.keys_;
    }

  private:
    bool left_handed_ = false;
    std::array<int, key_action_count> keys_{};
};

}  // namespace fulcrum::ui
