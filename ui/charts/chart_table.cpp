// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_table.h"

#include <QDate>
#include <QLocale>

#include "database/rows/csv_text.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

ChartCell ChartCell::words(const QString& words) {
    return {words, database::tsv_text(plain(words)), false};
}

ChartCell ChartCell::value(const std::optional<double>& value) {
    return {figure(value), database::csv_number(value), true};
}

ChartCell ChartCell::count(long long count) {
    return {QString::number(count), std::to_string(count), true};
}

ChartCell ChartCell::day(std::int64_t day) {
    const QDate date = QDate(1970, 1, 1).addDays(day);
    return {QLocale().toString(date, day_format()), plain(date.toString(Qt::ISODate)), false};
}

QString column_title(const ChartColumn& column) {
    return column.unit.isEmpty() ? column.name : QStringLiteral("%1 (%2)").arg(column.name, column.unit);
}

QString copied_table(const ChartTable& table) {
    std::string copied;
    const auto add = [&copied](const std::string& cell, bool first) { copied += (first ? "" : "\t") + cell; };
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        add(database::tsv_text(plain(column_title(table.columns[c]))), c == 0);
    copied += '\n';
    for (const ChartRow& row : table.rows) {
        for (std::size_t c = 0; c < row.cells.size(); ++c) add(row.cells[c].copied, c == 0);
        copied += '\n';
    }
    return text(copied);
}

}  // namespace fulcrum::ui
