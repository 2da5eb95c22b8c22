// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/appearance.h"

#include <QCoreApplication>
#include <QSettings>
#include <algorithm>
#include <cstdlib>

namespace fulcrum::ui {
namespace {

const QString theme_key = QStringLiteral("theme"), text_key = QStringLiteral("text_percent"),
              language_key = QStringLiteral("language");

template <typename Kind, std::size_t N>
Kind stored(const NameRow<Kind> (&table)[N], const QString& key, Kind standard) {
    const auto* row = find_row(table, QSettings().value(key).toString().toStdString());
    return row != nullptr ? row->kind : standard;
}

}  // namespace

Appearance stored_appearance() {
    Appearance look;
    look.theme = stored(themes, theme_key, look.theme);
    look.language = stored(languages, language_key, look.language);
    bool is_number = false;
    const int percent = QSettings().value(text_key).toInt(&is_number);
    // The nearest of the sizes that are offered.
    if (is_number)
        look.text_percent =
            *std::min_element(std::begin(text_percents), std::end(text_percents), [percent](int a, int b) {
                const auto away = [percent](int size) { return std::abs(static_cast<long>(size) - percent); };
                return away(a) < away(b);
            });
    return look;
}

void store_theme(Theme theme) {
    QSettings().setValue(theme_key, QString::fromLatin1(row_of(themes, theme).name));
}

void store_text_percent(int percent) {
    QSettings().setValue(text_key, percent);
}

void store_language(Language language) {
    QSettings().setValue(language_key, QString::fromLatin1(row_of(languages, language).name));
}

QString theme_title(Theme theme) {
    return QCoreApplication::translate("fulcrum::ui::themes", row_of(themes, theme).title);
}

}  // namespace fulcrum::ui
