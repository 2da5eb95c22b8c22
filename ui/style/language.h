// SPDX-License-Identifier: GPL-3.0-or-later
// The language of screens and printed pages: texts, dates and the decimal sign. Stored texts, exported tables
// and the command line do not depend on it.
#pragma once

#include <QLocale>
#include <QString>

#include "sim_core/numerics/name_table.h"

namespace fulcrum::ui {

enum class Language : std::uint8_t { system, english, german };

/// `name`: in settings, in FULCRUM_LANGUAGE and after --language. A language's title is in that language.
inline constexpr NameRow<Language> languages[] = {
    {Language::system, "system", QT_TRANSLATE_NOOP("fulcrum::ui::languages", "System language")},
    {Language::english, "en", "English"},
    {Language::german, "de", "Deutsch"},
};
static_assert(in_order(languages));

/// As the language is offered.
QString language_title(Language language);
/// What was chosen: FULCRUM_LANGUAGE if it names a language, else the setting, else the system's.
Language chosen_language();
/// Keeps the choice for the next start.
void keep_language(Language language);
/// From now on texts are translated into this language, and numbers and dates are written as it writes them.
/// What is on the screen already stays as it is. `system`: that of the desktop, English for one that the
/// program does not know.
void use_language(Language language);
/// `english` or `german`.
Language language_in_use();

/// A number with so many decimals, in the language in use.
QString decimal(double value, int decimals);
/// A number that was written with a point, with the decimal sign of the language in use.
QString with_decimal_sign(QString number);

}  // namespace fulcrum::ui
