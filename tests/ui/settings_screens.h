// SPDX-License-Identifier: GPL-3.0-or-later
// The page of settings, with nothing remembered before and after.
#pragma once

#include <QSettings>

#include "tests/ui/screens.h"
#include "ui/language/language.h"
#include "ui/style/appearance.h"

namespace fulcrum::ui::window_test {

class SettingsScreens : public Screens {
  protected:
    SettingsScreens() { QSettings().clear(); }
    ~SettingsScreens() override {
        window.reset();
        QSettings().clear();
        apply_text_size(*qApp, 100);
        use_language(Language::english);
    }
    void open_page(Role role = Role::trainee) {
        open({1280, 800});
        sign_in(role);
        go_to("rail_settings");
    }
};

}  // namespace fulcrum::ui::window_test
