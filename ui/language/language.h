// SPDX-License-Identifier: GPL-3.0-or-later
// The language of screens and printed pages: texts, dates and the decimal sign. Stored texts, exported tables
// and the command line do not depend on it.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>

#include "sim_core/numerics/name_table.h"

namespace fulcrum::ui {

enum class Language : std::uint8_t { english, german };

/// `name`: in FULCRUM_LANGUAGE. A language's title is in that language.
inline constexpr NameRow<Language> languages[] = {
    {Language::english, "en", "English"},
    {Language::german, "de", "Deutsch"},
};
static_assert(in_order(languages));

/// What FULCRUM_LANGUAGE names, `otherwise` if it is not set; nothing for a word that names no language.
std::optional<Language> chosen_language(Language otherwise = Language::english);
/// FULCRUM_LANGUAGE is set: the language cannot be chosen on a screen.
bool language_is_fixed();
/// From now on texts are translated into this language, and numbers and dates are written as it writes them.
/// What is on the screen already stays as it is.
void use_language(Language language);
Language language_in_use();

/// A number with so many decimals, in the language in use.
QString decimal(double value, int decimals);
/// A number that was written with a point, with the decimal sign of the language in use.
QString with_decimal_sign(QString number);

}  // namespace fulcrum::ui
