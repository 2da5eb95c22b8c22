// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/window_application.h"

#include <cstdio>
#include <exception>

#include "ui/language/error_text.h"

namespace fulcrum::ui {

bool WindowApplication::notify(QObject* receiver, QEvent* event) {
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "fulcrum: %s\n", error.what());
        if (trouble_) trouble_(error_text(error));
        return true;
    }
}

}  // namespace fulcrum::ui
