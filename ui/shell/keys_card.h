// SPDX-License-Identifier: GPL-3.0-or-later
// The keys that move the hands: shown, changed one by one, and reset. A key that another action has is
// refused. Kept for the person who is signed in, on this computer.
#pragma once

#include <QFrame>
#include <array>

#include "ui/page/context.h"
#include "ui/theatre/key_map.h"

class QButtonGroup;
class QLabel;
class QPushButton;

namespace fulcrum::ui {

class KeysCard : public QFrame {
    Q_OBJECT
  public:
    explicit KeysCard(Context& context);

  protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* build_group(KeyGroup group);
    void wait_for_key(KeyAction action);
    void take_key(int key);
    void show_keys();
    void say(const char* role, const QString& words);
    void keep();
    Context& context_;
    KeyMap map_ = KeyMap::standard(false);
    QButtonGroup* layout_;
    std::array<QPushButton*, key_action_count> keys_{};
    QLabel* message_;
    std::optional<KeyAction> waiting_;
};

}  // namespace fulcrum::ui
