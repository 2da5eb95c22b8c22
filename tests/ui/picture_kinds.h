// SPDX-License-Identifier: GPL-3.0-or-later
// Which kinds of pictures a test draws of every screen: size, theme, language and size of text.
// FULCRUM_PICTURES_AS="1280x800,dark,de,200 1024x3000" asks for other kinds; what is not given is 1024 x 768,
// light, English, 100 %. A height of several thousand pixels shows a page whole, without its scroll bar.
#pragma once

#include <gtest/gtest.h>

#include <QSize>
#include <QString>
#include <QStringList>
#include <QtGlobal>
#include <vector>

#include "ui/language/language.h"
#include "ui/style/palette.h"

namespace fulcrum::ui::window_test {

struct PictureKind {
    QSize size{1024, 768};
    Theme theme = Theme::light;
    Language language = Language::english;
    int percent = 100;

    /// As in the names of files: 1024x768-light, and what differs from English at 100 %.
    QString name() const {
        QString all = QStringLiteral("%1x%2-").arg(size.width()).arg(size.height());
        all += theme == Theme::light ? "light" : "dark";
        if (language != Language::english) all += QLatin1Char('-') + row_of(languages, language).name;
        if (percent != 100) all += QStringLiteral("-%1").arg(percent);
        return all;
    }
};

inline PictureKind picture_kind(const QString& words) {
    PictureKind kind;
    for (const QString& word : words.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const QStringList sides = word.split(QLatin1Char('x'));
        if (sides.size() == 2 && sides[0].toInt() > 0 && sides[1].toInt() > 0) {
            kind.size = {sides[0].toInt(), sides[1].toInt()};
        } else if (word == QLatin1String("light") || word == QLatin1String("dark")) {
            kind.theme = word == QLatin1String("dark") ? Theme::dark : Theme::light;
        } else if (word == QLatin1String("en") || word == QLatin1String("de")) {
            kind.language = word == QLatin1String("de") ? Language::german : Language::english;
        } else {
            kind.percent = word.toInt();
            EXPECT_GE(kind.percent, 100) << "FULCRUM_PICTURES_AS: " << word.toStdString();
        }
    }
    return kind;
}

/// The kinds that FULCRUM_PICTURES_AS asks for, else `usual`.
inline std::vector<PictureKind> picture_kinds(std::vector<PictureKind> usual) {
    const QStringList asked =
        QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES_AS")).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    if (asked.isEmpty()) return usual;
    std::vector<PictureKind> kinds;
    for (const QString& words : asked) kinds.push_back(picture_kind(words));
    return kinds;
}

}  // namespace fulcrum::ui::window_test
