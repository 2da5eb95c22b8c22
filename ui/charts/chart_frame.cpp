// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_frame.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QShortcut>
#include <QTableWidget>
#include <QToolTip>
#include <algorithm>

#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

ChartFrame::ChartFrame(QWidget* chart, TabledChart* source, const QString& title, const char* name,
                       QWidget* head)
    : QWidget(nullptr), chart_(chart), source_(source), title_(title), name_(name), head_(head) {
    setObjectName(QString::fromLatin1(name));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(make_tools(title, head));
    caption_ = make_label({}, "muted");
    caption_->setObjectName(objectName() + QStringLiteral("_caption"));
    caption_->hide();
    layout->addWidget(caption_);
    layout->addWidget(chart_, 1);
    source_->when_changed([this] {
        stale_ = true;
        if (table_shown_ && !behind_) fill();
    });
    auto* copy = new QShortcut(QKeySequence::Copy, this);
    copy->setContext(Qt::WidgetWithChildrenShortcut);
    connect(copy, &QShortcut::activated, this, &ChartFrame::copy_data);
}

QWidget* ChartFrame::make_tools(const QString& title, QWidget* head) {
    auto* tools = new QWidget;
    auto* row = new FlowRow(tools);
    row->setSpacing(6);
    heading_ = make_label(title, "heading");
    heading_->setVisible(head == nullptr);
    if (head == nullptr)
        row->add(heading_, 1, with_text(180));
    else
        row->add(head, 1, with_text(170));
    auto* buttons = new QWidget;  // together on the next line where they have no room next to the title
    auto* in_line = new FlowRow(buttons);
    in_line->setSpacing(6);
    const auto add = [&](const QString& shown, const char* part, const QString& spoken) {
        QPushButton* button = make_button(shown, (name_ + part).constData(), "link");
        button->setAccessibleName(spoken);
        button->setToolTip(spoken);
        in_line->add(button);
        return button;
    };
    as_table_ = add(tr("Table"), "_as_table", tr("%1: show the values as a table").arg(title));
    copy_picture_ = add(tr("Copy picture"), "_copy_picture", tr("%1: copy as a picture").arg(title));
    copy_data_ = add(tr("Copy data"), "_copy_data",
                     tr("%1: copy the values, to be pasted into a spreadsheet").arg(title));
    row->add(buttons);
    connect(as_table_, &QPushButton::clicked, this, [this] { table_shown_ ? show_chart() : show_table(); });
    connect(copy_picture_, &QPushButton::clicked, this, &ChartFrame::copy_picture);
    connect(copy_data_, &QPushButton::clicked, this, &ChartFrame::copy_data);
    return tools;
}

QTableWidget* ChartFrame::make_twin() {
    QTableWidget* twin = make_table({}, (name_ + "_table").constData());
    twin->setMinimumHeight(std::max(chart_->height(), 9 * fontMetrics().height()));
    static_cast<QVBoxLayout*>(layout())->addWidget(twin, 1);
    connect(twin, &QTableWidget::itemActivated, this, [this](QTableWidgetItem* item) {
        const QString key = twin_->item(item->row(), 0)->data(Qt::UserRole).toString();
        if (!key.isEmpty()) emit row_chosen(key);
    });
    return twin;
}

ChartTable ChartFrame::shown_table() const {
    return behind_ ? *behind_ : source_->table();
}

void ChartFrame::set_below_title(QWidget* widget) {
    static_cast<QVBoxLayout*>(layout())->insertWidget(1, widget);
}

void ChartFrame::show_table() {
    if (twin_ == nullptr) twin_ = make_twin();
    table_shown_ = true;
    as_table_->setText(tr("Chart"));
    as_table_->setAccessibleName(tr("%1: show the chart").arg(title_));
    as_table_->setToolTip(as_table_->accessibleName());
    caption_->setVisible(behind_.has_value());
    chart_->hide();
    twin_->show();
    fill();
}

void ChartFrame::show_chart() {
    behind_.reset();
    table_shown_ = false;
    stale_ = true;
    as_table_->setText(tr("Table"));
    as_table_->setAccessibleName(tr("%1: show the values as a table").arg(title_));
    as_table_->setToolTip(as_table_->accessibleName());
    caption_->hide();
    if (twin_ != nullptr) twin_->hide();
    chart_->show();
}

void ChartFrame::show_behind(const QString& caption, ChartTable table) {
    behind_ = std::move(table);
    caption_->setText(caption);
    stale_ = true;
    show_table();
    twin_->setFocus();
    if (twin_->rowCount() > 0) twin_->setCurrentCell(0, 0);
}

void ChartFrame::fill() {
    if (!stale_) return;
    stale_ = false;
    const ChartTable table = shown_table();
    twin_->setAccessibleName(behind_ ? caption_->text() : title_);
    twin_->clear();
    twin_->setRowCount(static_cast<int>(table.rows.size()));
    twin_->setColumnCount(static_cast<int>(table.columns.size()));
    QStringList titles;
    for (const ChartColumn& column : table.columns) titles << column_title(column);
    twin_->setHorizontalHeaderLabels(titles);
    std::vector<int> whole;
    for (int r = 0; r < twin_->rowCount(); ++r) {
        const ChartRow& row = table.rows[static_cast<std::size_t>(r)];
        for (int c = 0; c < twin_->columnCount(); ++c) {
            const ChartCell& cell = row.cells[static_cast<std::size_t>(c)];
            QTableWidgetItem* item = make_cell(cell.shown, cell.number ? Qt::AlignRight | Qt::AlignVCenter
                                                                       : Qt::AlignLeft | Qt::AlignVCenter);
            if (c == 0) item->setData(Qt::UserRole, row.key);
            twin_->setItem(r, c, item);
            if (r == 0 && cell.number) whole.push_back(c);
        }
    }
    // A long trace has as many rows as its chart has points: their columns are as wide as their titles.
    constexpr int most_fitted = 500;
    if (twin_->rowCount() <= most_fitted)
        fit_columns(twin_, whole);
    else
        size_columns(twin_);
}

void ChartFrame::copy_picture() {
    const double ratio = devicePixelRatioF();
    // A hidden widget is painted in another size: the chart takes its place for that moment.
    setUpdatesEnabled(false);
    if (table_shown_) {
        twin_->hide();
        chart_->show();
        layout()->activate();
    }
    const QPixmap chart = chart_->grab();
    if (table_shown_) {
        chart_->hide();
        twin_->show();
    }
    setUpdatesEnabled(true);
    const QPixmap head = head_ != nullptr ? head_->grab() : QPixmap();
    const QFontMetrics bold(heading_->font());
    constexpr int margin = 10;
    const auto width = static_cast<int>(chart.width() / ratio) + 2 * margin;
    const QRect words = bold.boundingRect(QRect(margin, margin, width - 2 * margin, 1000),
                                          Qt::AlignLeft | Qt::TextWordWrap, title_);
    const int head_height = head.isNull() ? 0 : static_cast<int>(head.height() / ratio) + 4;
    const int top = words.bottom() + 8;
    QImage picture(
        QSize(width, top + head_height + static_cast<int>(chart.height() / ratio) + margin) * ratio,
        QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    picture.fill(colours().card);
    QPainter painter(&picture);
    painter.setFont(heading_->font());
    painter.setPen(colours().text);
    painter.drawText(words, Qt::AlignLeft | Qt::TextWordWrap, title_);
    if (!head.isNull()) painter.drawPixmap(margin, top, head);
    painter.drawPixmap(margin, top + head_height, chart);
    painter.end();
    QGuiApplication::clipboard()->setImage(picture);
    confirm(copy_picture_, tr("The picture was copied."));
}

void ChartFrame::copy_data() {
    const ChartTable table = shown_table();
    QGuiApplication::clipboard()->setText(copied_table(table));
    confirm(copy_data_, tr("%n rows were copied.", nullptr, static_cast<int>(table.rows.size())));
}

void ChartFrame::confirm(QPushButton* button, const QString& words) {
    button->setAccessibleDescription(words);
    QToolTip::showText(button->mapToGlobal(QPoint(0, button->height())), words, button, {}, 3000);
}

}  // namespace fulcrum::ui

#include "moc_chart_frame.cpp"
