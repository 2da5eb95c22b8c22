// SPDX-License-Identifier: GPL-3.0-or-later
// The values of a chart as a table: what its twin shows, and what is copied as data.
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::ui {

/// A value as it is shown, and as it is copied: a number with all its digits and a point, a day as ISO 8601.
struct ChartCell {
    QString shown;
    std::string copied;
    bool number = false;  ///< aligned at the right

    static ChartCell words(const QString& words);
    static ChartCell value(const std::optional<double>& value);
    static ChartCell count(long long count);
    /// Days since 1 January 1970.
    static ChartCell day(std::int64_t day);
};

struct ChartColumn {
    QString name;
    QString unit = {};  ///< empty: none
};

struct ChartRow {
    std::vector<ChartCell> cells;
    QString key = {};  ///< of what the row is about; empty: it leads nowhere
};

struct ChartTable {
    std::vector<ChartColumn> columns;
    std::vector<ChartRow> rows;
};

/// "force, left hand (N)".
QString column_title(const ChartColumn& column);
/// For spreadsheets: a row of titles with units, cells separated by tabs, no cell is a formula.
QString copied_table(const ChartTable& table);

/// A chart that has its values as a table too. Part of a widget.
class TabledChart {
  public:
    virtual ~TabledChart() = default;
    virtual ChartTable table() const = 0;
    /// Called when the table changes; the chart's frame sets it.
    void when_changed(std::function<void()> call) { changed_ = std::move(call); }

  protected:
    void values_changed() const {
        if (changed_) changed_();
    }

  private:
    std::function<void()> changed_;
};

}  // namespace fulcrum::ui
