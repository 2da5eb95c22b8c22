// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/cohort_grid.h"

#include <QAbstractTableModel>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>
#include <algorithm>
#include <optional>

#include "assessment/scoring/score.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

using database::PersonStandings;
using database::PersonTask;
using database::RecentAttempt;

namespace {

constexpr int person_role = Qt::UserRole, task_role = Qt::UserRole + 1, cell_role = Qt::UserRole + 2,
              unknown_role = Qt::UserRole + 3;
enum class Order { name, least_done, longest_ago };

int tasks_done(const PersonStandings& person) {
    return static_cast<int>(std::count_if(person.tasks.begin(), person.tasks.end(), database::is_done));
}

}  // namespace

QString grid_cell_text(const QString& name, const QString& title, const PersonTask& task) {
    QString line = CohortGrid::tr("%1, %2: %3.").arg(name, title, standing_name(task.standing));
    if (task.recent.empty()) return line;
    QStringList attempts;
    for (const RecentAttempt& attempt : task.recent) {
        const QString points = attempt.points ? QStringLiteral(" ") + figure(*attempt.points) : QString();
        attempts << (attempt.passed ? CohortGrid::tr("passed") : CohortGrid::tr("failed")) + points;
    }
    line += CohortGrid::tr(" Latest attempts with %1: %2.")
                .arg(device_class_text(*task.device_class), attempts.join(QStringLiteral(", ")));
    return line;
}

QString unknown_cell_text(const QString& name, const QString& title, const QString& curriculum) {
    return CohortGrid::tr("%1, %2: %3. The curriculum %4 is not at this station.")
        .arg(name, title, unknown_standing_name(), curriculum);
}

/// People by tasks: name, one column for each task, latest practice.
class CohortGridModel : public QAbstractTableModel {
  public:
    using QAbstractTableModel::QAbstractTableModel;

    void set(std::vector<PersonStandings> people, QStringList titles, std::vector<std::string> tasks) {
        beginResetModel();
        people_ = std::move(people);
        titles_ = std::move(titles);
        tasks_ = std::move(tasks);
        endResetModel();
    }
    int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : static_cast<int>(people_.size());
    }
    int columnCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() || people_.empty() ? 0 : static_cast<int>(tasks_.size()) + 2;
    }
    bool is_task(int column) const { return column > 0 && column <= static_cast<int>(tasks_.size()); }
    const PersonStandings& person(int row) const { return people_[static_cast<std::size_t>(row)]; }
    const PersonTask& task(int row, int column) const {
        return person(row).tasks[static_cast<std::size_t>(column - 1)];
    }
    QVariant data(const QModelIndex& index, int role) const override {
        const PersonStandings& one = person(index.row());
        if (role == person_role) return text(one.person_id);
        if (is_task(index.column())) {
            const PersonTask& cell = task(index.row(), index.column());
            if (role == task_role) return text(cell.standing.task);
            if (role == cell_role) return QVariant(reinterpret_cast<qulonglong>(&cell));
            if (role == unknown_role) return one.not_here;
            if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
                const QString name = account_text(one.name, one.active),
                              title = titles_.at(index.column() - 1);
                return one.not_here ? unknown_cell_text(name, title, text(one.curriculum))
                                    : grid_cell_text(name, title, cell);
            }
            return {};
        }
        if (role == Qt::ToolTipRole || role == Qt::DisplayRole)
            return index.column() == 0     ? account_text(one.name, one.active)
                   : one.last_attempt == 0 ? CohortGrid::tr("never")
                                           : date_text(one.last_attempt);
        return {};
    }
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
        if (orientation != Qt::Horizontal) return {};
        if (role == Qt::TextAlignmentRole) return int(Qt::AlignLeft | Qt::AlignVCenter);
        if (is_task(section)) {
            if (role == Qt::ToolTipRole) return titles_.at(section - 1);
            if (role == Qt::DisplayRole) return text(tasks_[static_cast<std::size_t>(section - 1)]);
            return {};
        }
        if (role != Qt::DisplayRole) return {};
        return section == 0 ? CohortGrid::tr("Person") : CohortGrid::tr("Latest practice");
    }

  private:
    std::vector<PersonStandings> people_;
    QStringList titles_;
    std::vector<std::string> tasks_;
};

namespace {

/// The badge of the standing, then a bar for each of the latest attempts that have room: filled where it was
/// passed, an outline where it failed, as high as its points; a line at the pass mark.
class GridDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const auto* task = reinterpret_cast<const PersonTask*>(index.data(cell_role).toULongLong());
        if (task == nullptr) {
            if ((option.state & QStyle::State_HasFocus) != 0) paint_focus(*painter, option.rect);
            return;
        }
        const int side =
            std::min(option.rect.height() - 8, static_cast<int>(1.5 * option.fontMetrics.height()));
        const QRect badge(option.rect.left() + 8, option.rect.center().y() - side / 2, side, side);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        // On the selection's colour a badge would be lost.
        if ((option.state & QStyle::State_Selected) != 0) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(colours().card);
            painter->drawRoundedRect(option.rect.adjusted(3, 3, -3, -3), 4, 4);
        }
        if (index.data(unknown_role).toBool())
            paint_unknown_standing(*painter, badge);
        else
            paint_standing(*painter, badge, task->standing);
        paint_bars(
            *painter,
            QRectF(badge.right() + 8, badge.top(), option.rect.right() - 8 - (badge.right() + 8), side),
            task->recent);
        if ((option.state & QStyle::State_HasFocus) != 0) paint_focus(*painter, option.rect);
        painter->restore();
    }
    /// Around the current cell, within what is selected as well.
    static void paint_focus(QPainter& painter, const QRect& cell) {
        painter.save();
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours().text, 2));
        painter.drawRect(cell.adjusted(1, 1, -2, -2));
        painter.restore();
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const int line = option.fontMetrics.height();
        // Names and dates have the width of their words; a very long name is cut off.
        const int words = index.data(cell_role).isValid()
                              ? 0
                              : std::min(20 * line, QStyledItemDelegate::sizeHint(option, index).width());
        return {std::max(words, static_cast<int>(least_cell * line)), static_cast<int>(2.1 * line)};
    }
    static constexpr double least_cell = 2.5;  // lines: the badge alone
    /// Whether a cell has room for bars.
    static bool shows_bars(int width, const QFontMetrics& font) {
        return width - 16 - 8 - 1.5 * font.height() >= fewest_bars * step;
    }

  private:
    static constexpr double step = 7;
    static constexpr std::size_t fewest_bars = 3;

    static void paint_bars(QPainter& painter, const QRectF& room, const std::vector<RecentAttempt>& recent) {
        constexpr double bar = 4.5;
        const auto fitting = static_cast<std::size_t>(std::max(0.0, room.width() / step));
        if (fitting < fewest_bars) return;  // one or two show no course
        const std::size_t first = recent.size() > fitting ? recent.size() - fitting : 0;
        if (first >= recent.size()) return;
        const Palette& p = colours();
        double x = room.left();
        for (std::size_t i = first; i < recent.size(); ++i, x += step) {
            const double share = std::clamp(recent[i].points.value_or(0) / 100, 0.06, 1.0);
            const QRectF box(x, room.bottom() - share * room.height(), bar, share * room.height());
            painter.setPen(recent[i].passed ? Qt::NoPen : QPen(p.bad, 1.2));
            painter.setBrush(recent[i].passed ? QBrush(p.good) : QBrush(Qt::NoBrush));
            painter.drawRect(box);
        }
        const double y = room.bottom() - pass_mark / 100 * room.height();
        painter.setPen(QPen(p.limit, 1, Qt::DotLine));
        painter.drawLine(QPointF(room.left(), y), QPointF(x - step + bar, y));
    }
};

class GridFilter : public QSortFilterProxyModel {
  public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void set_name(const QString& name) {
        name_ = name.trimmed();
        invalidateFilter();
    }
    /// -1: all.
    void set_standing(int standing) {
        standing_ = standing;
        invalidateFilter();
    }
    void set_order(Order order) {
        order_ = order;
        invalidate();
        sort(0);
    }

  protected:
    bool filterAcceptsRow(int row, const QModelIndex&) const override {
        const PersonStandings& person = grid().person(row);
        if (!text(person.name).contains(name_, Qt::CaseInsensitive)) return false;
        if (standing_ < 0) return true;
        return !person.not_here &&
               std::any_of(person.tasks.begin(), person.tasks.end(), [this](const PersonTask& task) {
                   return static_cast<int>(task.standing.standing) == standing_;
               });
    }
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override {
        const PersonStandings &a = grid().person(left.row()), &b = grid().person(right.row());
        // How many are done is not known of everyone.
        if (order_ == Order::least_done && a.not_here != b.not_here) return b.not_here;
        if (order_ == Order::least_done && tasks_done(a) != tasks_done(b))
            return tasks_done(a) < tasks_done(b);
        if (order_ == Order::longest_ago && a.last_attempt != b.last_attempt)
            return a.last_attempt < b.last_attempt;
        const int names = QString::localeAwareCompare(text(a.name), text(b.name));
        return names != 0 ? names < 0 : a.person_id < b.person_id;
    }

  private:
    const CohortGridModel& grid() const { return *static_cast<const CohortGridModel*>(sourceModel()); }
    QString name_;
    int standing_ = -1;
    Order order_ = Order::name;
};

/// Shapes and their words, in as many lines as they need.
class Legend : public QWidget {
  public:
    Legend() {
        QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
        setAccessibleName(CohortGrid::tr("What the signs mean"));
        for (const auto& row : standing_names) {
            TaskStanding one;
            one.standing = row.kind;
            shown_.push_back(one);
            one.provisional = row.kind == Standing::passed;
            one.by_override = row.kind == Standing::proficient;
            one.declared_at = one.by_override ? 1 : 0;
            if (one.provisional || one.by_override) shown_.push_back(one);
        }
        describe();
    }
    /// Also the sign of a standing that is not known here.
    void show_unknown(bool wanted) {
        if (wanted == !shown_.back()) return;
        if (wanted)
            shown_.emplace_back();
        else
            shown_.pop_back();
        describe();
        updateGeometry();
        update();
    }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return lay_out(nullptr, width); }
    QSize sizeHint() const override { return {400, heightForWidth(900)}; }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setPen(colours().muted);
        lay_out(&painter, width());
    }

  private:
    void describe() {
        QStringList words;
        for (const auto& one : shown_) words << name_of(one);
        setAccessibleDescription(words.join(QStringLiteral(", ")));
    }
    static QString name_of(const std::optional<TaskStanding>& one) {
        return one ? standing_name(*one) : unknown_standing_name();
    }
    int lay_out(QPainter* painter, int width) const {
        const int side = static_cast<int>(1.3 * fontMetrics().height()), line = side + 6;
        int x = 0, y = 0;
        for (const auto& one : shown_) {
            const QString words = name_of(one);
            const int whole = side + 6 + fontMetrics().horizontalAdvance(words) + 18;
            if (x > 0 && x + whole > width) {
                x = 0;
                y += line;
            }
            if (painter != nullptr) {
                if (one)
                    paint_standing(*painter, QRectF(x, y, side, side), *one);
                else
                    paint_unknown_standing(*painter, QRectF(x, y, side, side));
                painter->setPen(colours().muted);
                painter->drawText(QRect(x + side + 6, y, whole, side), Qt::AlignLeft | Qt::AlignVCenter,
                                  words);
            }
            x += whole;
        }
        return y + line;
    }
    std::vector<std::optional<TaskStanding>> shown_;  ///< none: not known
};

}  // namespace

CohortGrid::CohortGrid(QWidget* parent) : QWidget(parent), model_(new CohortGridModel(this)) {
    auto* filter = new GridFilter(this);
    filter->setSourceModel(model_);
    filter->setDynamicSortFilter(true);
    shown_ = filter;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 10, 10, 10);
    auto* row = new FlowRow;
    name_ = new QLineEdit;
    name_->setObjectName(QStringLiteral("grid_name"));
    name_->setPlaceholderText(tr("Find a person"));
    name_->setAccessibleName(tr("Find a person"));
    name_->setClearButtonEnabled(true);
    row->add(name_, 1, with_text(150));
    standing_ = new QComboBox;
    standing_->setObjectName(QStringLiteral("grid_standing"));
    standing_->setAccessibleName(tr("Standing"));
    standing_->addItem(tr("Any standing"), -1);
    for (const auto& one : standing_names)
        standing_->addItem(QCoreApplication::translate("fulcrum::standings", one.title),
                           static_cast<int>(one.kind));
    row->add(standing_);
    order_ = new QComboBox;
    order_->setObjectName(QStringLiteral("grid_order"));
    order_->setAccessibleName(tr("Order"));
    order_->addItem(tr("By name"));
    order_->addItem(tr("Fewest tasks done first"));
    order_->addItem(tr("Longest without practice first"));
    row->add(order_);
    layout->addLayout(row);
    view_ = new QTableView;
    view_->setObjectName(QStringLiteral("cohort_grid"));
    view_->setAccessibleName(tr("People by tasks"));
    view_->setModel(shown_);
    view_->setItemDelegate(new GridDelegate(view_));
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->setShowGrid(false);
    view_->setTabKeyNavigation(false);  // Tab leads on to the next control, arrows to the next cell
    view_->setAlternatingRowColors(true);
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view_->setMinimumHeight(300);
    layout->addWidget(view_, 1);
    legend_ = new Legend;
    layout->addWidget(legend_);
    bars_ =
        make_label(tr("Bars: the latest attempts, as high as their points. Filled: passed. Outline: failed. "
                      "Dotted line: %1 points, the pass mark.")
                       .arg(figure(pass_mark)),
                   "muted");
    layout->addWidget(bars_);
    connect(view_->horizontalHeader(), &QHeaderView::sectionResized, this,
            [this](int column, int, int width) {
                if (column == 1) bars_->setVisible(GridDelegate::shows_bars(width, view_->fontMetrics()));
            });
    connect(name_, &QLineEdit::textChanged, this, [filter](const QString& name) { filter->set_name(name); });
    connect(standing_, QOverload<int>::of(&QComboBox::activated), this,
            [this, filter] { filter->set_standing(standing_->currentData().toInt()); });
    connect(order_, QOverload<int>::of(&QComboBox::activated), this,
            [filter](int order) { filter->set_order(static_cast<Order>(order)); });
    connect(view_, &QTableView::activated, this, [this](const QModelIndex& index) {
        emit person_wanted(index.data(person_role).toString(), index.data(task_role).toString());
    });
}

CohortGrid::~CohortGrid() = default;

void CohortGrid::show_table(const database::CohortTable& table, const QStringList& titles) {
    std::vector<std::string> tasks;
    if (!table.standings.empty())
        for (const PersonTask& task : table.standings.front().tasks) tasks.push_back(task.standing.task);
    model_->set(table.standings, titles, std::move(tasks));
    static_cast<Legend*>(legend_)->show_unknown(
        std::any_of(table.standings.begin(), table.standings.end(),
                    [](const PersonStandings& one) { return one.not_here; }));
    shown_->sort(0);
    QHeaderView* heads = view_->horizontalHeader();
    heads->setMinimumSectionSize(static_cast<int>(GridDelegate::least_cell * fontMetrics().height()));
    heads->setSectionResizeMode(QHeaderView::Stretch);
    if (model_->columnCount() == 0) return;
    heads->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    heads->setSectionResizeMode(model_->columnCount() - 1, QHeaderView::ResizeToContents);
    view_->verticalHeader()->setDefaultSectionSize(static_cast<int>(2.1 * fontMetrics().height()));
}

}  // namespace fulcrum::ui

#include "moc_cohort_grid.cpp"
