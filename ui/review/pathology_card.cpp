// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/pathology_card.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QRadioButton>
#include <QScrollBar>
#include <QTableWidget>
#include <algorithm>

#include "ui/reports/export_row.h"
#include "ui/reports/pathology_words.h"
#include "ui/review/specimen_view.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

PathologyCard::PathologyCard(QWidget* parent) : QFrame(parent) {
    setProperty("role", "card");
    setObjectName(QStringLiteral("pathology_card"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    auto* top = new FlowRow;
    top->add(make_label(tr("Pathology report (simulated)"), "heading"), 1, with_text(200));
    as_map_ = new QRadioButton(tr("Map"));
    as_map_->setObjectName(QStringLiteral("specimen_as_map"));
    as_solid_ = new QRadioButton(tr("In 3D"));
    as_solid_->setObjectName(QStringLiteral("specimen_as_solid"));
    for (QRadioButton* choice : {as_map_, as_solid_}) top->add(choice);
    connect(as_solid_, &QRadioButton::toggled, this, &PathologyCard::show_solid);
    layout->addLayout(top);
    map_ = new SpecimenView;
    layout->addWidget(map_);
    auto* row = new QHBoxLayout;
    sector_ = make_label({});
    sector_->setObjectName(QStringLiteral("specimen_sector"));
    sector_show_ = make_button(tr("Show the deepest defect"), "specimen_show", "link");
    row->addWidget(sector_, 1);
    row->addWidget(sector_show_, 0, Qt::AlignTop);
    layout->addLayout(row);
    numbers_button_ = make_button({}, "pathology_numbers");
    layout->addWidget(numbers_button_, 0, Qt::AlignLeft);
    numbers_ = new QWidget;
    numbers_->hide();
    auto* numbers = new QVBoxLayout(numbers_);
    numbers->setContentsMargins(0, 0, 0, 0);
    numbers->setSpacing(8);
    layout->addWidget(numbers_);
    lines_ = new QGridLayout;
    lines_->setHorizontalSpacing(16);
    lines_->setVerticalSpacing(4);
    lines_->setColumnStretch(1, 1);
    numbers->addLayout(lines_);
    // Ten columns in a row: the unit is below the name.
    QStringList heads = pathology_columns();
    for (QString& head : heads) {
        const int gap = head.lastIndexOf(QLatin1Char(' '));
        if (gap > 0) head[gap] = QLatin1Char('\n');
    }
    table_ = make_table(heads, "pathology_table");
    table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setAccessibleName(tr("All numbers"));
    table_->setWordWrap(false);
    numbers->addWidget(table_);
    legend_ = make_label({}, "muted");
    legend_->setWordWrap(true);
    numbers->addWidget(legend_);
    export_ = new ExportRow("export_attempt");
    layout->addWidget(export_);
    connect(export_, &ExportRow::save_wanted, this, &PathologyCard::save_wanted);
    connect(map_, &SpecimenView::sector_chosen, this, &PathologyCard::show_sector);
    connect(sector_show_, &QPushButton::clicked, this, [this] { emit time_chosen(shown_time_); });
    connect(numbers_button_, &QPushButton::clicked, this, [this] {
        numbers_->setVisible(numbers_->isHidden());
        numbers_button_->setText(numbers_->isHidden() ? tr("All numbers") : tr("Hide the numbers"));
    });
}

void PathologyCard::open(const std::optional<PathologyReport>& report, const std::optional<QString>& file) {
    report_ = report;
    setVisible(report.has_value());
    if (!report) return;
    map_->open(*report);
    as_map_->setChecked(true);
    for (QRadioButton* choice : {as_map_, as_solid_}) choice->setVisible(map_->has_sectors());
    sector_->setText(tr("Select a sector to see its numbers."));
    set_tint(sector_, Tint::muted);
    sector_show_->hide();
    numbers_->hide();
    numbers_button_->setText(tr("All numbers"));
    fill_numbers();
    export_->setVisible(file.has_value());
    if (file) export_->propose(*file);
}

void PathologyCard::show_solid(bool solid) {
    map_->show_solid(solid);
}

std::optional<double> PathologyCard::defect_time(const SectorFinding& finding) const {
    const double third = report_->plan.line / sector_count;
    for (const Defect& defect : report_->defects) {  // deepest first
        const int sector =
            std::min(sector_count - 1, static_cast<int>(0.5 * (defect.from + defect.to) / third));
        if (defect.level == finding.level && sector == static_cast<int>(finding.sector))
            return defect.when.begin;
    }
    return std::nullopt;
}

void PathologyCard::show_sector(int finding) {
    const SectorFinding& chosen = report_->findings[static_cast<std::size_t>(finding)];
    sector_->setText(sector_words(*report_, chosen));
    set_tint(sector_, Tint::none);
    const std::optional<double> time = defect_time(chosen);
    shown_time_ = time.value_or(-1);
    sector_show_->setVisible(time.has_value());
}

void PathologyCard::fill_numbers() {
    clear_layout(lines_);
    table_->setRowCount(0);
    int row = 0;
    for (const PathologyLine& line : pathology_lines(*report_)) {
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
    for (const QStringList& cells : pathology_rows(*report_)) {
        const int at = table_->rowCount();
        table_->insertRow(at);
        for (int column = 0; column < cells.size(); ++column)
            table_->setItem(at, column,
                            make_cell(cells[column], column < 2 ? Qt::AlignLeft | Qt::AlignVCenter
                                                                : Qt::AlignRight | Qt::AlignVCenter));
    }
    size_columns(table_);
    QHeaderView* heads = table_->horizontalHeader();
    heads->setStretchLastSection(false);
    // Columns of one width, none narrower than a head or a number: with large text the table scrolls
    // sideways.
    int widest = 40;
    for (int column = 0; column < table_->columnCount(); ++column)
        widest = std::max({widest, heads->sectionSizeHint(column),
                           static_cast<QAbstractItemView*>(table_)->sizeHintForColumn(column)});
    heads->setMinimumSectionSize(widest);
    heads->setSectionResizeMode(QHeaderView::Stretch);
    table_->clearSelection();
    table_->setCurrentItem(nullptr);
    table_->setFixedHeight(heads->sizeHint().height() + table_->verticalHeader()->length() +
                           table_->horizontalScrollBar()->sizeHint().height() + 2 * table_->frameWidth());
    legend_->setText(pathology_legend(*report_));
}

}  // namespace fulcrum::ui

#include "moc_pathology_card.cpp"
