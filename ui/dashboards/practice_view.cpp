// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/practice_view.h"

#include <QAbstractTableModel>
#include <QDate>
#include <QDateTime>
#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableView>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int trainee_role = Qt::UserRole, week_role = Qt::UserRole + 1;
using Week = std::array<int, 7>;  // attempts from Monday to Sunday

const QDate epoch(1970, 1, 1);

QString short_date(const QDate& day) {
    return QLocale().toString(day, PracticeView::tr("d MMM"));
}

}  // namespace

/// Name, then one column for each week.
class PracticeModel : public QAbstractTableModel {
  public:
    using QAbstractTableModel::QAbstractTableModel;

    void set(const database::CohortTable& table) {
        beginResetModel();
        people_.clear();
        const QDate today = QDateTime::fromMSecsSinceEpoch(table.as_of).date();
        first_ = today.addDays(1 - today.dayOfWeek() - 7 * (practice_weeks - 1));
        for (const database::PersonStandings& one : table.standings) {
            Line line{text(one.person_id), account_text(one.name, one.active),
                      std::vector<Week>(practice_weeks, Week{})};
            for (const database::PracticeDay& day : one.days) {
                const qint64 offset = first_.daysTo(epoch.addDays(day.day));
                if (offset < 0 || offset >= 7 * practice_weeks) continue;
                line.weeks[static_cast<std::size_t>(offset / 7)][static_cast<std::size_t>(offset % 7)] +=
                    day.attempts;
            }
            people_.push_back(std::move(line));
        }
        endResetModel();
    }
    int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : static_cast<int>(people_.size());
    }
    int columnCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() || people_.empty() ? 0 : practice_weeks + 1;
    }
    QVariant data(const QModelIndex& index, int role) const override {
        const Line& line = people_[static_cast<std::size_t>(index.row())];
        if (role == trainee_role) return line.id;
        if (index.column() == 0)
            return role == Qt::DisplayRole || role == Qt::ToolTipRole ? line.name : QVariant();
        const Week& week = line.weeks[static_cast<std::size_t>(index.column() - 1)];
        if (role == week_role) return QVariant(reinterpret_cast<qulonglong>(&week));
        if (role != Qt::ToolTipRole && role != Qt::AccessibleTextRole) return {};
        QStringList days;
        int sum = 0;
        for (std::size_t d = 0; d < week.size(); ++d) {
            sum += week[d];
            if (week[d] > 0)
                days << PracticeView::tr("%1: %2")
                            .arg(short_date(monday(index.column()).addDays(static_cast<qint64>(d))))
                            .arg(week[d]);
        }
        const QString about = PracticeView::tr("%1, week of %2: %n attempts", nullptr, sum)
                                  .arg(line.name, short_date(monday(index.column())));
        return days.isEmpty()
                   ? about
                   : about + QStringLiteral(" (") + days.join(QStringLiteral(", ")) + QLatin1Char(')');
    }
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
        if (orientation != Qt::Horizontal) return {};
        if (role == Qt::TextAlignmentRole) return int(Qt::AlignLeft | Qt::AlignVCenter);
        if (role != Qt::DisplayRole) return {};
        // Day and month below each other, in the width of seven small squares.
        return section == 0 ? PracticeView::tr("Person")
                            : short_date(monday(section)).replace(QLatin1Char(' '), QLatin1Char('\n'));
    }

  private:
    struct Line {
        QString id, name;
        std::vector<Week> weeks;
    };
    QDate monday(int column) const { return first_.addDays(7 * (column - 1)); }

    std::vector<Line> people_;
    QDate first_;  // Monday of the first week shown
};

namespace {

void paint_days(QPainter& painter, const QRectF& room, const Week& week) {
    const double side = std::min(room.width() / 7, room.height());
    const Palette& p = colours();
    for (std::size_t d = 0; d < week.size(); ++d) {
        const QRectF box(room.left() + static_cast<double>(d) * side + 1, room.center().y() - side / 2 + 1,
                         side - 2, side - 2);
        QColor colour = p.line;
        if (week[d] > 0) {
            // Three steps, so that they can be distinguished: 1, 2 to 3, more.
            colour = p.accent;
            colour.setAlphaF(week[d] >= 4 ? 1.0 : week[d] >= 2 ? 0.65 : 0.35);
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(week[d] > 0 ? QBrush(colour) : QBrush(Qt::NoBrush));
        if (week[d] == 0) painter.setPen(QPen(colour, 1));
        painter.drawRect(box);
    }
}

class PracticeDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const auto* week = reinterpret_cast<const Week*>(index.data(week_role).toULongLong());
        if (week == nullptr) return;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if ((option.state & QStyle::State_Selected) != 0)
            painter->fillRect(option.rect.adjusted(2, 2, -2, -2), colours().card);
        paint_days(*painter, QRectF(option.rect).adjusted(4, 4, -4, -4), *week);
        if ((option.state & QStyle::State_HasFocus) != 0) {
            painter->setBrush(Qt::NoBrush);
            painter->setPen(QPen(colours().text, 2));
            painter->drawRect(option.rect.adjusted(1, 1, -2, -2));
        }
        painter->restore();
    }
};

/// One square for each step of colour, with its words.
class PracticeLegend : public QWidget {
  public:
    PracticeLegend() {
        setFixedHeight(static_cast<int>(1.5 * fontMetrics().height()));
        QStringList words;
        for (const auto& step : steps()) words << step.second;
        setAccessibleName(words.join(QStringLiteral(", ")));
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const int side = height() - 4;
        int x = 0;
        for (const auto& [count, words] : steps()) {
            const Week one{count, 0, 0, 0, 0, 0, 0};
            painter.save();
            painter.setClipRect(x, 0, side, height());
            paint_days(painter, QRectF(x, 2, 7 * side, side), one);
            painter.restore();
            painter.setPen(colours().muted);
            x += side + 6;
            const int whole = fontMetrics().horizontalAdvance(words);
            painter.drawText(QRect(x, 0, whole, height()), Qt::AlignVCenter, words);
            x += whole + 18;
        }
    }

  private:
    /// Attempts on a day, from which on it has this colour.
    static std::vector<std::pair<int, QString>> steps() {
        return {{0, PracticeView::tr("no attempt")},
                {1, PracticeView::tr("1 attempt")},
                {2, PracticeView::tr("2 or 3 attempts")},
                {4, PracticeView::tr("4 attempts or more")}};
    }
};

}  // namespace

PracticeView::PracticeView(QWidget* parent) : QWidget(parent), model_(new PracticeModel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 10, 10, 10);
    view_ = new QTableView;
    view_->setObjectName(QStringLiteral("practice_days"));
    view_->setAccessibleName(tr("Days of practice"));
    view_->setModel(model_);
    view_->setItemDelegate(new PracticeDelegate(view_));
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->setShowGrid(false);
    view_->setTabKeyNavigation(false);  // Tab leads on to the next control, arrows to the next cell
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view_->setMinimumHeight(300);
    layout->addWidget(view_, 1);
    layout->addWidget(new PracticeLegend);
    connect(view_, &QTableView::activated, this, [this](const QModelIndex& index) {
        emit person_wanted(index.data(trainee_role).toString(), {});
    });
}

void PracticeView::show_table(const database::CohortTable& table) {
    model_->set(table);
    QHeaderView* heads = view_->horizontalHeader();
    if (model_->columnCount() == 0) return;
    // Twelve weeks and the names have room in a window of 1280 pixels.
    heads->setMinimumSectionSize(fontMetrics().horizontalAdvance(QStringLiteral("30 MMM")) + 2);
    heads->setSectionResizeMode(QHeaderView::Stretch);
    heads->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    view_->verticalHeader()->setDefaultSectionSize(static_cast<int>(1.9 * fontMetrics().height()));
}

}  // namespace fulcrum::ui

#include "moc_practice_view.cpp"
