// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/report_dashboard.h"

#include "ui/reports/dashboard_pictures.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

void paint_picture(Sheet& sheet, const QRectF& cell, const QString& title, const DashboardPicture& picture) {
    QPainter& painter = sheet.painter();
    sheet.font(9, true);
    QRectF used;
    painter.drawText(cell, Qt::AlignLeft | Qt::TextWordWrap, title, &used);
    const double top = used.bottom() + Sheet::mm(1.5);
    sheet.font(7, false, paper_palette().muted);
    const QRectF words = painter.boundingRect(cell, Qt::AlignLeft | Qt::TextWordWrap, picture.words);
    const QRectF room(cell.left(), top, cell.width(), cell.bottom() - words.height() - Sheet::mm(1.5) - top);
    if (is_empty(picture.figure)) {
        painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, picture.nothing);
    } else {
        paint_figure(painter, room, picture.figure, paper_palette(), Sheet::mm(0.25));
    }
    sheet.font(7, false, paper_palette().muted);
    painter.drawText(QRectF(cell.left(), room.bottom() + Sheet::mm(1.5), cell.width(), words.height()),
                     Qt::AlignLeft | Qt::TextWordWrap, picture.words);
}

}  // namespace

void paint_dashboard(Sheet& sheet, const CohortReport& report) {
    std::vector<std::pair<std::string, std::string>> titles;
    for (const ReportTask& task : report.tasks) titles.emplace_back(task.id, task.title);
    const DashboardNames names = dashboard_names(*report.curriculum, titles);
    const std::size_t task = telling_task(report.dashboard);
    const int columns = sheet.width() > sheet.height() ? 3 : 2;
    const int lines = (static_cast<int>(std::size(dashboard_parts)) + columns - 1) / columns;
    const double gap = Sheet::mm(8), top = sheet.y() + Sheet::mm(1), bottom = bottom_of(sheet);
    const double width = (sheet.width() - (columns - 1) * gap) / columns,
                 height = (bottom - top - (lines - 1) * gap) / lines;
    int place = 0;
    for (const auto& part : dashboard_parts) {
        const QRectF cell(place % columns * (width + gap), top + place / columns * (height + gap), width,
                          height);
        QString title = dashboard_title(part.kind);
        if (part.kind == DashboardPart::times && task < report.dashboard.overview.size())
            title = join_with_dots({title, names.tasks.value(static_cast<int>(task))});
        paint_picture(sheet, cell, title,
                      dashboard_picture(part.kind, report.dashboard, report.table.standings, names, task));
        ++place;
    }
}

}  // namespace fulcrum::ui
