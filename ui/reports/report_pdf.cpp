// SPDX-License-Identifier: GPL-3.0-or-later
// Reports on A4 by QPainter: a person as a table with charts behind it, a cohort as a table of people and
// tasks with each person's pages behind it. A table continues over as many pages as its rows need.
#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <functional>
#include <set>

#include "ui/charts/attempt_chart.h"
#include "ui/reports/not_here_words.h"
#include "ui/reports/paper.h"
#include "ui/reports/rating_words.h"
#include "ui/reports/report_dashboard.h"
#include "ui/reports/report_rows.h"
#include "ui/reports/report_texts.h"
#include "ui/reports/report_writer.h"
#include "ui/style/palette.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString state_text(const database::CohortRow& row) {
    switch (row.state) {
        case database::TaskState::passed:
            return row.provisional ? ReportTexts::tr("passed (provisional)") : ReportTexts::tr("passed");
        case database::TaskState::attempted:
            return ReportTexts::tr("attempted");
        case database::TaskState::open:
            return ReportTexts::tr("not attempted");
    }
    return {};
}

bool any_provisional(const std::vector<database::CohortRow>& rows) {
    return std::any_of(rows.begin(), rows.end(),
                       [](const database::CohortRow& row) { return row.provisional; });
}

AttemptChartData chart_of(const database::PersonProgress& progress) {
    AttemptChartData data;
    data.y_title = ReportTexts::tr("points");
    data.y_maximum = 100;
    for (const database::ProgressSeries& series : progress.series) {
        AttemptSeries shown;
        shown.name = device_class_text(series.device_class);
        for (const database::ProgressPoint& point : series.points) {
            shown.points.push_back(
                {point.attempt_id, point.number, point.points, point.passed, point.counting, {}});
        }
        data.series.push_back(std::move(shown));
    }
    return data;
}

// Parts joined again as long as they fit into a line.
QStringList wrapped(Sheet& sheet, const QString& whole, const QString& between, double width) {
    const QFontMetricsF measure(sheet.painter().font(), sheet.painter().device());
    QStringList lines;
    for (const QString& part : whole.split(between)) {
        const QString longer = lines.isEmpty() ? part : lines.back() + between + part;
        if (!lines.isEmpty() && measure.horizontalAdvance(longer) <= width) {
            lines.back() = longer;
        } else {
            lines << part;
        }
    }
    return lines;
}

// One below the other; the sheet stays where it is.
void cell_lines(Sheet& sheet, double x, double width, const QStringList& lines) {
    const double top = sheet.y();
    for (int line = 0; line < lines.size(); ++line) {
        sheet.to(top + line * sheet.line_height());
        sheet.cell(x, width, lines[line]);
    }
    sheet.to(top);
}

// Charts in rows from where the sheet is; on pages of their own where they would be too low to read there.
void person_charts(Sheet& sheet, const std::vector<const database::PersonProgress*>& drawn,
                   const std::function<void()>& turn) {
    constexpr double lowest_mm = 40, highest_mm = 72;
    const bool landscape = sheet.width() > sheet.height();
    const std::size_t per_row = landscape || drawn.size() > 4 ? std::min<std::size_t>(drawn.size(), 3)
                                : drawn.size() > 3            ? 2
                                                              : 1;
    std::size_t chart_rows = (drawn.size() + per_row - 1) / per_row;
    if (bottom_of(sheet) - sheet.y() < static_cast<double>(chart_rows) * Sheet::mm(lowest_mm)) {
        turn();
        const double fitting = std::max(1.0, (bottom_of(sheet) - sheet.y()) / Sheet::mm(lowest_mm));
        chart_rows = std::min(chart_rows, static_cast<std::size_t>(fitting));
    }
    double top = sheet.y();
    const double each =
        std::min((bottom_of(sheet) - top) / static_cast<double>(chart_rows), Sheet::mm(highest_mm));
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (i > 0 && i % (per_row * chart_rows) == 0) {
            turn();
            top = sheet.y();
        }
        const double width = sheet.width() / static_cast<double>(per_row);
        const double x = static_cast<double>(i % per_row) * width;
        sheet.to(top + static_cast<double>(i / per_row % chart_rows) * each);
        sheet.font(9, true);
        sheet.cell(x, width, text(drawn[i]->task_id));
        sheet.font(7);
        const double heading = Sheet::mm(6);
        paint_attempt_chart(
            sheet.painter(),
            QRectF(x, sheet.y() + heading, width - Sheet::mm(4), each - heading - Sheet::mm(3)),
            chart_of(*drawn[i]), paper_palette(), dots_per_inch / 120.0);
    }
}

// 0.68 as "68 %".
QString share_words(double scaled) {
    return ReportTexts::tr("%1 %").arg(figure(100 * scaled));
}

// Attempts with released forms, one line for each form: from where the sheet is, over as many pages as it
// needs.
void person_ratings(Sheet& sheet, const PersonReport& report, const std::function<void()>& turn) {
    const double columns[] = {0, 0.10, 0.27, 0.74, 0.88, 1.0};
    const auto line = [&](const QStringList& cells) {
        for (int i = 0; i < cells.size(); ++i)
            sheet.cell(columns[i] * sheet.width(), (columns[i + 1] - columns[i]) * sheet.width(), cells[i],
                       i >= 3 ? Qt::AlignRight : Qt::AlignLeft);
        sheet.skip(5);
    };
    const auto table_head = [&] {
        sheet.font(10, true);
        sheet.paragraph(ReportTexts::tr("Ratings by observers"));
        sheet.font(8, true, paper_palette().muted);
        line({capital(ReportTexts::tr("task")), capital(ReportTexts::tr("attempt of")),
              capital(ReportTexts::tr("form")), capital(ReportTexts::tr("raters")),
              capital(ReportTexts::tr("mean"))});
        sheet.rule();
        sheet.font(8.5);
    };
    bool begun = false;
    for (const database::PersonProgress& progress : report.progress) {
        for (const database::ProgressSeries& series : progress.series) {
            for (const database::ProgressPoint& point : series.points) {
                for (const database::RatedForm& form : database::rated_forms(point.ratings)) {
                    const bool full = sheet.y() + Sheet::mm(begun ? 5 : 22) > bottom_of(sheet);
                    if (full) turn();
                    if (full || !begun) table_head();
                    begun = true;
                    line({text(progress.task_id), date_text(point.started), form_text(form.title),
                          QString::number(form.forms), share_words(form.scaled)});
                }
            }
        }
    }
    if (begun) sheet.skip(4);
}

void person_pages(Sheet& sheet, const PersonReport& report) {
    int counting = 0;
    for (const database::CohortRow& row : report.rows) counting += row.attempts;
    const QString n = ReportTexts::tr("n = %1 counting attempts").arg(counting);
    const auto head = [&] {
        page_head(
            sheet, report.provenance, ReportTexts::tr("progress report"), report.name,
            join_with_dots(
                {report.login.empty() ? QString() : ReportTexts::tr("account %1").arg(text(report.login)),
                 ReportTexts::tr("data up to %1").arg(local_time(report.provenance.as_of))}),
            report.synthetic || report.provenance.demo, any_provisional(report.rows));
    };
    const double columns[] = {0, 0.25, 0.445, 0.655, 0.745, 0.855, 0.93, 1.0};
    const QString titles[] = {ReportTexts::tr("task"),   ReportTexts::tr("device"),
                              ReportTexts::tr("state"),  ReportTexts::tr("attempts"),
                              ReportTexts::tr("passed"), ReportTexts::tr("other"),
                              ReportTexts::tr("best")};
    const auto cell = [&](int column, const QString& shown) {
        sheet.cell(columns[column] * sheet.width(), (columns[column + 1] - columns[column]) * sheet.width(),
                   shown, column >= 3 ? Qt::AlignRight : Qt::AlignLeft);
    };
    const auto table_head = [&] {
        head();
        sheet.font(8, true, paper_palette().muted);
        for (int column = 0; column < 7; ++column) cell(column, capital(titles[column]));
        sheet.skip(5);
        sheet.rule();
    };
    table_head();
    for (const database::CohortRow& row : report.rows) {
        sheet.font(8.5);
        QString title = text(row.task_id);
        for (const ReportTask& task : report.tasks) {
            if (task.id == row.task_id) title += QStringLiteral(" · ") + asset_text(task.title);
        }
        const double title_width = columns[1] * sheet.width();
        const QStringList lines = wrapped(sheet, title, QStringLiteral(" "), title_width - Sheet::mm(3));
        const double height = (lines.size() - 1) * sheet.line_height() + Sheet::mm(5);
        if (sheet.y() + height > bottom_of(sheet)) {
            footer(sheet, report.provenance, n);
            table_head();
            sheet.font(8.5);
        }
        const double top = sheet.y();
        cell_lines(sheet, 0, title_width, lines);
        cell(1, !row.device_class ? QStringLiteral("–") : device_class_text(*row.device_class));
        cell(2, state_text(row));
        cell(3, QString::number(row.attempts));
        cell(4, QString::number(row.passes));
        cell(5, QString::number(row.not_counting));
        cell(6, points_figure(row.best_points));
        sheet.to(top + height);
    }
    sheet.skip(4);
    if (report.standings && report.standings->not_here) {
        sheet.font(8.5);
        sheet.paragraph(not_here_line({*report.standings}));
    }
    const auto turn = [&] {
        footer(sheet, report.provenance, n);
        head();
    };
    person_ratings(sheet, report, turn);
    std::vector<const database::PersonProgress*> drawn;
    for (const database::PersonProgress& progress : report.progress) {
        if (!progress.series.empty()) drawn.push_back(&progress);
    }
    if (!drawn.empty()) {
        person_charts(sheet, drawn, turn);
    } else {
        sheet.font(9, false, paper_palette().muted);
        if (sheet.y() + sheet.line_height() > bottom_of(sheet)) turn();
        sheet.font(9, false, paper_palette().muted);
        sheet.paragraph(ReportTexts::tr("No attempts yet."));
    }
    footer(sheet, report.provenance, n);
}

// The standing in the curriculum first; without one, the state with each device class.
QString cohort_cell(const database::CohortTable& table, const std::string& person, const std::string& task,
                    bool with_device) {
    QStringList lines;
    const TaskStanding* standing = standing_in(table, person, task);
    if (standing != nullptr) lines << standing_name(*standing);
    for (const database::CohortRow& row : table.rows) {
        if (row.person_id != person || row.task_id != task) continue;
        if (!row.device_class) {
            if (standing == nullptr) lines << state_text(row);
            continue;
        }
        const QString best = points_figure(row.best_points);
        lines << (standing != nullptr ? ReportTexts::tr("attempts %1 · best %2").arg(row.attempts).arg(best)
                                      : ReportTexts::tr("%1 · attempts %2 · best %3")
                                            .arg(state_text(row))
                                            .arg(row.attempts)
                                            .arg(best));
        if (with_device) lines << device_class_text(*row.device_class);
        for (const database::RatedForm& form : row.ratings)
            lines << ReportTexts::tr("%1: %2, attempts %3")
                         .arg(text(form.form).section(QLatin1Char('@'), 0, 0).toUpper(),
                              share_words(form.scaled))
                         .arg(form.attempts);
    }
    return lines.join(QLatin1Char('\n'));
}

/// One is named at the head, several in each cell.
std::set<DeviceClass> devices_of(const CohortReport& report) {
    std::set<DeviceClass> devices;
    for (const database::CohortRow& row : report.table.rows)
        if (row.device_class) devices.insert(*row.device_class);
    return devices;
}

/// Who the report is of, and from which data.
QString cohort_line(const CohortReport& report) {
    const std::set<DeviceClass> devices = devices_of(report);
    const int left_out = report.table.left_out_synthetic;
    return join_with_dots(
        {ReportTexts::tr("data up to %1").arg(local_time(report.provenance.as_of)),
         ReportTexts::tr("people: n = %1").arg(report.table.people),
         report.table.deactivated > 0 ? ReportTexts::tr("deactivated: %1").arg(report.table.deactivated)
                                      : QString(),
         devices.size() == 1 ? device_class_text(*devices.begin()) : QString(),
         left_out > 0 ? ReportTexts::tr("%1 synthetic people left out").arg(left_out) : QString()});
}

void dashboard_page(Sheet& sheet, const CohortReport& report) {
    if (report.curriculum == nullptr || report.table.standings.empty()) return;
    page_head(sheet, report.provenance, ReportTexts::tr("cohort report"), report.table.cohort_name,
              cohort_line(report), false, any_provisional(report.table.rows));
    paint_dashboard(sheet, report);
    footer(sheet, report.provenance, ReportTexts::tr("people: n = %1").arg(report.table.people));
}

void cohort_pages(Sheet& sheet, const CohortReport& report) {
    std::vector<std::pair<std::string, QString>> people;
    for (const database::CohortRow& row : report.table.rows) {
        if (people.empty() || people.back().first != row.person_id)
            people.emplace_back(row.person_id, account_text(row.name, row.active));
    }
    const double name_width = sheet.width() * 0.22;
    const double task_width =
        (sheet.width() - name_width) / static_cast<double>(std::max<std::size_t>(report.tasks.size(), 1));
    const QString n = ReportTexts::tr("people: n = %1").arg(report.table.people);
    const bool with_device = devices_of(report).size() > 1;
    const QString line = cohort_line(report);
    const auto head = [&] {
        page_head(sheet, report.provenance, ReportTexts::tr("cohort report"), report.table.cohort_name, line,
                  false, any_provisional(report.table.rows));
        sheet.font(8.5, true, paper_palette().muted);
        sheet.cell(0, name_width, capital(ReportTexts::tr("person")));
        const double first_line = sheet.y();
        int head_lines = 1;
        for (std::size_t t = 0; t < report.tasks.size(); ++t) {
            const QStringList words = wrapped(
                sheet, text(report.tasks[t].id) + QLatin1Char(' ') + asset_text(report.tasks[t].title),
                QStringLiteral(" "), task_width - Sheet::mm(3));
            cell_lines(sheet, name_width + static_cast<double>(t) * task_width, task_width, words);
            head_lines = std::max(head_lines, static_cast<int>(words.size()));
        }
        sheet.to(first_line + (head_lines - 1) * sheet.line_height());
        sheet.skip(5);
        sheet.rule();
    };
    head();
    for (const auto& [person, name] : people) {
        int lines = 1;
        std::vector<QStringList> cells;
        sheet.font(8.5);
        for (const ReportTask& task : report.tasks) {
            QStringList cell;
            for (const QString& part :
                 cohort_cell(report.table, person, task.id, with_device).split(QLatin1Char('\n'))) {
                for (const QString& piece :
                     wrapped(sheet, part, QStringLiteral(" · "), task_width - Sheet::mm(3)))
                    cell << wrapped(sheet, piece, QStringLiteral(" "), task_width - Sheet::mm(3));
            }
            lines = std::max(lines, static_cast<int>(cell.size()));
            cells.push_back(cell);
        }
        const double height = sheet.line_height() * lines + Sheet::mm(1.5);
        if (sheet.y() + height > bottom_of(sheet)) {
            footer(sheet, report.provenance, n);
            head();
            sheet.font(8.5);
        }
        const double top = sheet.y();
        sheet.cell(0, name_width, name);
        for (std::size_t t = 0; t < cells.size(); ++t)
            cell_lines(sheet, name_width + static_cast<double>(t) * task_width, task_width, cells[t]);
        sheet.to(top + height);
    }
    const QString not_here = not_here_line(report.table.standings);
    if (!not_here.isEmpty()) {
        if (sheet.y() + 4 * sheet.line_height() > bottom_of(sheet)) {
            footer(sheet, report.provenance, n);
            head();
        }
        sheet.font(8.5);
        sheet.paragraph(not_here);
    }
    footer(sheet, report.provenance, n);
}

}  // namespace

void write_person_pdf(const PersonReport& report, const std::string& path) {
    Sheet sheet(path, false, ReportTexts::tr("Progress of %1").arg(text(report.name)));
    person_pages(sheet, report);
    sheet.finish();
}

bool write_cohort_pdf(const CohortReport& report, const std::string& path, const Progress& progress) {
    Sheet sheet(path, report.tasks.size() > 4,
                ReportTexts::tr("Cohort %1").arg(text(report.table.cohort_name)));
    dashboard_page(sheet, report);
    cohort_pages(sheet, report);
    for (std::size_t i = 0; i < report.people.size(); ++i) {
        const double done = static_cast<double>(i) / static_cast<double>(report.people.size());
        if (progress && !progress(0.5 + 0.5 * done, report.people[i].name)) return false;
        person_pages(sheet, report.people[i]);
    }
    sheet.finish();
    return true;
}

namespace {

class PdfWriter : public ReportWriter {
  public:
    ReportFiles write_attempt(const AttemptPaper& paper, const ReportRequest& request) const override {
        write_attempt_pdf(paper, request.path);
        return {request.path};
    }
    ReportFiles write_person(const PersonReport& report, const ReportRequest& request) const override {
        write_person_pdf(report, request.path);
        return {request.path};
    }
    ReportFiles write_cohort(const ReportSource& source, const ReportRequest& request,
                             const Progress& progress) const override {
        const auto report = gather_cohort(source, request, PeoplePages::pages, progress);
        const bool whole = report && write_cohort_pdf(*report, request.path, progress);
        return whole ? ReportFiles{request.path} : ReportFiles();
    }
};

}  // namespace

const ReportWriter& pdf_writer() {
    static const PdfWriter writer;
    return writer;
}

}  // namespace fulcrum::ui
