// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that belong to the place and not to a person: theme, text size, language, devices. Each is
// remembered.
#pragma once

#include "ui/page/context.h"

class QButtonGroup;
class QComboBox;
class QFrame;

namespace fulcrum::ui {

class SettingsPage : public Page {
    Q_OBJECT
  public:
    explicit SettingsPage(Context& context);
    void enter() override;

  private:
    QFrame* build_appearance();
    QFrame* build_language();
    /// Shows what is in use, whoever changed it, or what the window asks about.
    void show_choices();
    QButtonGroup *theme_, *language_;
    QComboBox* text_size_;
};

}  // namespace fulcrum::ui
