// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/not_here_words.h"

#include <QStringList>

#include "ui/reports/report_texts.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

QString not_here_line(const std::vector<database::PersonStandings>& people) {
    QStringList names;
    for (const database::PersonStandings& person : people)
        if (person.not_here)
            names << ReportTexts::tr("%1 (%2)").arg(text(person.name), text(person.curriculum));
    if (names.isEmpty()) return {};
    return ReportTexts::tr(
               "Nothing can be said of the standing of people who follow a version of the "
               "curriculum that is not at this station: %1.")
        .arg(names.join(QStringLiteral(", ")));
}

}  // namespace fulcrum::ui
