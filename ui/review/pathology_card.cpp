// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/pathology_card.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QTableWidget>

#include "ui/reports/export_row.h"
#include "ui/reports/pathology_words.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

PathologyCard::PathologyCard(QWidget* parent) : QFrame(parent) {
    setProperty("role", "card");
    setObjectName(QStringLiteral("pathology_card"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Pathology report (simulated)"), "heading"));
    lines_ = new QGridLayout;
    lines_->setHorizontalSpacing(16);
    lines_->setVerticalSpacing(4);
    lines_->setColumnStretch(1, 1);
    layout->addLayout(lines_);
    // Ten columns beside each other: the unit stands below the name.
    QStringList heads = pathology_columns();
    for (QString& head : heads) {
        const int gap = head.lastIndexOf(QLatin1Char(' '));
        if (gap > 0) head[gap] = QLatin1Char('\n');
    }
    table_ = make_table(heads, "pathology_table");
    table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setWordWrap(false);
    layout->addWidget(table_);
    legend_ = make_label({}, "muted");
    legend_->setWordWrap(true);
    layout->addWidget(legend_);
    export_ = new ExportRow("export_attempt");
    layout->addWidget(export_);
    connect(export_, &ExportRow::save_wanted, this, &PathologyCard::save_wanted);
}

void PathologyCard::open(const std::optional<PathologyReport>& report, const std::optional<QString>& file) {
    clear_layout(lines_);
    table_->setRowCount(0);
    setVisible(report.has_value());
    if (!report) return;
    int row = 0;
    for (const PathologyLine& line : pathology_lines(*report)) {
        lines_->addWidget(make_label(line.title, "muted"), row, 0, Qt::AlignTop);
        QLabel* words = make_label(line.words);
        words->setWordWrap(true);
        if (line.bad) set_tint(words, Tint::bad);
        lines_->addWidget(words, row, 1);
        if (line.time >= 0) {
            QPushButton* show = make_button(tr("Show"), "pathology_show", "link");
            show->setAccessibleName(tr("Show: %1").arg(line.words));
            connect(show, &QPushButton::clicked, this, [this, time = line.time] { emit time_chosen(time); });
            lines_->addWidget(show, row, 2, Qt::AlignTop);
        }
        ++row;
    }
    for (const QStringList& cells : pathology_rows(*report)) {
        const int at = table_->rowCount();
        table_->insertRow(at);
        for (int column = 0; column < cells.size(); ++column)
            table_->setItem(at, column,
                            make_cell(cells[column], column < 2 ? Qt::AlignLeft | Qt::AlignVCenter
                                                                : Qt::AlignRight | Qt::AlignVCenter));
    }
    size_columns(table_);
    table_->horizontalHeader()->setStretchLastSection(false);
    table_->horizontalHeader()->setMinimumSectionSize(40);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->clearSelection();
    table_->setCurrentItem(nullptr);
    table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                           table_->verticalHeader()->length() + 2 * table_->frameWidth());
    legend_->setText(pathology_legend(*report));
    export_->setVisible(file.has_value());
    if (file) export_->propose(*file);
}

}  // namespace fulcrum::ui

#include "moc_pathology_card.cpp"
