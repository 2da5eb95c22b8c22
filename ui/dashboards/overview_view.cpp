// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/overview_view.h"

#include <QHeaderView>
#include <QPainter>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "ui/charts/chart_frame.h"
#include "ui/style/palette.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

using database::TaskOverview;

namespace {

/// From what is done to what is locked, as the bar shows it from the left.
constexpr Standing bar_order[] = {
    Standing::maintained, Standing::proficient, Standing::due,  Standing::relapsed, Standing::awaiting_rating,
    Standing::passed,     Standing::attempted,  Standing::open, Standing::locked};

QColor colour_of(Standing standing) {
    const Palette& p = colours();
    switch (standing) {
        case Standing::maintained:
        case Standing::proficient:
            return p.good;
        case Standing::due:
            return p.warning;
        case Standing::relapsed:
            return p.bad;
        case Standing::awaiting_rating:
        case Standing::passed:
        case Standing::attempted:
            return p.accent;
        case Standing::open:
        case Standing::locked:
            break;
    }
    return p.line;
}

QString percent(double share) {
    return QString::number(qRound(100 * share));
}

}  // namespace

QString share_text(const TaskOverview& task) {
    if (task.attempted == 0) return QStringLiteral("–");
    return OverviewView::tr("%1 of %2 (%3 %, %4 to %5 %)")
        .arg(task.passed)
        .arg(task.attempted)
        .arg(percent(task.share.share), percent(task.share.low), percent(task.share.high));
}

QString days_text(const SurvivalMedian& days, int people) {
    if (people == 0) return QStringLiteral("–");
    if (!days.median) return OverviewView::tr("fewer than half so far");
    const auto whole = [](double value) { return figure(std::round(value)); };
    const QString median = whole(*days.median), low = whole(days.low.value_or(0));
    return days.high ? OverviewView::tr("%1 days (%2 to %3)").arg(median, low, whole(*days.high))
                     : OverviewView::tr("%1 days (%2 or more)").arg(median, low);
}

/// One bar for each task, divided by standing. A part wide enough has the sign and the number in it.
class OverviewChart : public QWidget, public TabledChart {
  public:
    OverviewChart() {
        setAccessibleName(OverviewView::tr("People in each standing, task by task"));
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    void set(std::vector<TaskOverview> tasks) {
        tasks_ = std::move(tasks);
        QStringList words;
        for (const TaskOverview& task : tasks_) {
            QStringList parts;
            for (const auto& [standing, count] : task.people)
                parts << QStringLiteral("%1 %2").arg(count).arg(QCoreApplication::translate(
                    "fulcrum::standings", row_of(standing_names, standing).title));
            words << text(task.task) + QStringLiteral(": ") + parts.join(QStringLiteral(", "));
        }
        setAccessibleDescription(words.join(QStringLiteral("; ")));
        setToolTip(words.join(QLatin1Char('\n')));
        updateGeometry();
        update();
        values_changed();
    }
    ChartTable table() const override {
        ChartTable table;
        table.columns.push_back({OverviewView::tr("Task")});
        const auto title = [](const auto& row) {
            return QCoreApplication::translate("fulcrum::standings", row.title);
        };
        for (const auto& row : standing_names)
            table.columns.push_back({title(row), OverviewView::tr("people")});
        for (const TaskOverview& task : tasks_) {
            ChartRow row{{ChartCell::words(text(task.task))}};
            for (const auto& standing : standing_names) {
                const auto found = task.people.find(standing.kind);
                row.cells.push_back(ChartCell::count(found == task.people.end() ? 0 : found->second));
            }
            table.rows.push_back(std::move(row));
        }
        return table;
    }
    QSize sizeHint() const override { return {400, static_cast<int>(tasks_.size()) * line() + 4}; }
    QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        int widest = 0;
        for (const TaskOverview& task : tasks_)
            widest = std::max(widest, fontMetrics().horizontalAdvance(text(task.task)));
        int y = 2;
        for (const TaskOverview& task : tasks_) {
            painter.setPen(colours().text);
            painter.drawText(QRect(0, y, widest, line()), Qt::AlignVCenter, text(task.task));
            paint_bar(painter, QRectF(widest + 12, y + 3, width() - widest - 14, line() - 6), task);
            y += line();
        }
    }

  private:
    int line() const { return static_cast<int>(1.9 * fontMetrics().height()); }
    void paint_bar(QPainter& painter, const QRectF& room, const TaskOverview& task) const {
        int people = 0;
        for (const auto& [standing, count] : task.people) people += count;
        if (people == 0) return;
        double x = room.left();
        for (const Standing standing : bar_order) {
            const auto found = task.people.find(standing);
            if (found == task.people.end()) continue;
            const double part = room.width() * found->second / people;
            const QRectF box(x, room.top(), part, room.height());
            QColor fill = colour_of(standing);
            if (standing == Standing::attempted || standing == Standing::open) fill.setAlphaF(0.3);
            if (standing == Standing::passed) fill.setAlphaF(0.6);
            if (standing == Standing::awaiting_rating) fill.setAlphaF(0.8);
            painter.setPen(QPen(colours().card, 1.5));
            painter.setBrush(standing == Standing::locked ? QBrush(Qt::NoBrush) : QBrush(fill));
            if (standing == Standing::locked) painter.setPen(QPen(colours().line, 1));
            painter.drawRect(box);
            paint_part(painter, box, standing, found->second);
            x += part;
        }
    }
    void paint_part(QPainter& painter, const QRectF& box, Standing standing, int count) const {
        const double side = box.height() - 6;
        const QString number = QString::number(count);
        const double digits = fontMetrics().horizontalAdvance(number);
        if (box.width() < side + digits + 14) {
            // No room for the sign: the number alone.
            if (box.width() < digits + 6) return;
            const QRectF plate(box.center().x() - digits / 2 - 3, box.top() + 2, digits + 6, side + 2);
            painter.setPen(Qt::NoPen);
            painter.setBrush(colours().card);
            painter.drawRoundedRect(plate, 4, 4);
            painter.setPen(colours().text);
            painter.drawText(plate, Qt::AlignCenter, number);
            return;
        }
        const QRectF sign(box.left() + 5, box.top() + 3, side, side);
        TaskStanding one;
        one.standing = standing;
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours().card);
        painter.drawRoundedRect(sign.adjusted(-2, -1, fontMetrics().horizontalAdvance(number) + 8, 1), 4, 4);
        paint_standing(painter, sign, one);
        painter.setPen(colours().text);
        painter.drawText(QRectF(sign.right() + 4, box.top(), box.width(), box.height()), Qt::AlignVCenter,
                         number);
    }

    std::vector<TaskOverview> tasks_;
};

OverviewView::OverviewView(QWidget* parent) : QWidget(parent), chart_(new OverviewChart) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 10, 10, 10);
    layout->setSpacing(10);
    layout->addWidget(new ChartFrame(chart_, tr("People in each standing"), "overview_chart"));
    table_ = make_table({tr("Task"), tr("Passed"), tr("First pass after"), tr("Proficient after")},
                        "cohort_overview");
    table_->setAccessibleName(tr("Tasks of the curriculum"));
    layout->addWidget(table_, 1);
    layout->addWidget(make_label(
        tr("Passed: people who passed at least once, of those who tried (95 % interval). Days: from a "
           "person's first attempt that counts; median over people by the Kaplan-Meier method (95 % "
           "interval). With provisional limits a task can be passed, but nobody becomes proficient."),
        "muted"));
}

void OverviewView::show_table(const database::CohortTable& table, const QStringList& titles) {
    const std::vector<TaskOverview> tasks = database::overview_of(table.standings, table.as_of);
    chart_->set(tasks);
    table_->setRowCount(static_cast<int>(tasks.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const TaskOverview& task = tasks[static_cast<std::size_t>(row)];
        table_->setItem(row, 0, make_cell(titles.value(row)));
        table_->setItem(row, 1, make_cell(share_text(task)));
        table_->setItem(row, 2, make_cell(days_text(task.days_to_pass, task.attempted)));
        table_->setItem(row, 3, make_cell(days_text(task.days_to_proficiency, task.attempted)));
    }
    fit_columns(table_, {1, 2, 3});
}

}  // namespace fulcrum::ui

#include "moc_overview_view.cpp"
