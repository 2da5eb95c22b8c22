// SPDX-License-Identifier: GPL-3.0-or-later
// Theme, text size and language as they are remembered for everyone who uses this account of the computer.
#pragma once

#include "sim_core/numerics/name_table.h"
#include "ui/language/language.h"
#include "ui/style/palette.h"

namespace fulcrum::ui {

inline constexpr NameRow<Theme> themes[] = {
    {Theme::light, "light", QT_TRANSLATE_NOOP("fulcrum::ui::themes", "Light")},
    {Theme::dark, "dark", QT_TRANSLATE_NOOP("fulcrum::ui::themes", "Dark")},
};
static_assert(in_order(themes));

struct Appearance {
    Theme theme = Theme::light;
    int text_percent = 100;
    Language language = Language::english;
};

/// What is remembered; the standard in place of everything that is missing or cannot be read.
Appearance stored_appearance();
void store_theme(Theme theme);
void store_text_percent(int percent);
void store_language(Language language);

/// In today's language.
QString theme_title(Theme theme);

}  // namespace fulcrum::ui
