// SPDX-License-Identifier: GPL-3.0-or-later
// What every chart has around it: its title, its values as a table one click away, copying as a picture and
// as data. Where a part of a chart was chosen, the table of what is behind it takes the chart's place until
// it is shown again. UI thread.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/charts/chart_table.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class FlowRow;

class ChartFrame : public QWidget {
    Q_OBJECT
  public:
    /// Takes the chart, a widget and a TabledChart. `name`: of this frame; its parts are NAME_as_table,
    /// NAME_copy_picture, NAME_copy_data and NAME_table. `head`: in place of a title, such as a legend.
    template <class Chart>
    ChartFrame(Chart* chart, const QString& title, const char* name, QWidget* head = nullptr)
        : ChartFrame(static_cast<QWidget*>(chart), static_cast<TabledChart*>(chart), title, name, head) {}

    bool shows_table() const { return table_shown_; }
    /// What is behind a part of the chart, in its place.
    void show_behind(const QString& caption, ChartTable table);
    /// The table, or what is behind a part of the chart.
    void show_chart();
    /// Between the title and the chart.
    void set_below_title(QWidget* widget);
    /// What a copy holds: what the twin shows, or would show.
    ChartTable shown_table() const;

  signals:
    /// A row of the table was activated that is about something.
    void row_chosen(const QString& key);

  private:
    ChartFrame(QWidget* chart, TabledChart* source, const QString& title, const char* name, QWidget* head);
    QWidget* make_tools(const QString& title, QWidget* head);
    QTableWidget* make_twin();
    void show_table();
    void fill();
    void copy_picture();
    void copy_data();
    void confirm(QPushButton* button, const QString& words);

    QWidget* chart_;
    TabledChart* source_;
    QString title_;
    QByteArray name_;
    QWidget* head_;
    QLabel *heading_, *caption_;
    QPushButton *as_table_, *copy_picture_, *copy_data_;
    QTableWidget* twin_ = nullptr;
    std::optional<ChartTable> behind_;
    bool table_shown_ = false, stale_ = true;
};

}  // namespace fulcrum::ui
