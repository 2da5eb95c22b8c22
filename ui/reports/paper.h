// SPDX-License-Identifier: GPL-3.0-or-later
// A4 paper written from the top down by QPainter, and what stands at the foot of every report.
#pragma once

#include <QPainter>
#include <QPdfWriter>
#include <string>

#include "sim_core/numerics/output_file.h"
#include "ui/reports/report.h"
#include "ui/style/palette.h"

namespace fulcrum::ui {

inline constexpr int dots_per_inch = 300;

/// A page being written from the top down; units are millimetres through mm().
class Sheet {
  public:
    /// Throws StoreError (failed) where the file cannot be written.
    Sheet(const std::string& path, bool landscape, const QString& title);
    Sheet(const Sheet&) = delete;
    Sheet& operator=(const Sheet&) = delete;
    ~Sheet();
    /// Puts the file in its place; without it nothing is left. Throws as the constructor.
    void finish();

    static double mm(double length) { return length * dots_per_inch / 25.4; }
    double width() const { return writer_.width(); }
    double height() const { return writer_.height(); }
    double y() const { return y_; }
    void skip(double length_mm) { y_ += mm(length_mm); }
    void to(double y) { y_ = y; }
    QPainter& painter() { return painter_; }
    void new_page() {
        if (started_) writer_.newPage();
        started_ = true;
        y_ = 0;
    }
    void font(double points, bool bold = false, const QColor& colour = paper_palette().text) {
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setPointSizeF(points);
        font.setBold(bold);
        painter_.setFont(font);
        painter_.setPen(colour);
    }
    double line_height() { return QFontMetricsF(painter_.font(), &writer_).height(); }
    /// A paragraph; moves down.
    void paragraph(const QString& shown) {
        const QRectF room(0, y_, width(), height());
        QRectF used;
        painter_.drawText(room, Qt::TextWordWrap, shown, &used);
        y_ = used.bottom() + mm(0.8);
    }
    void rule() {
        painter_.setPen(QPen(paper_palette().line, mm(0.2)));
        painter_.drawLine(QPointF(0, y_), QPointF(width(), y_));
        y_ += mm(1.5);
    }
    void cell(double x, double cell_width, const QString& shown, Qt::Alignment alignment = Qt::AlignLeft) {
        const QString fitted =
            QFontMetricsF(painter_.font(), &writer_).elidedText(shown, Qt::ElideRight, cell_width - mm(1.5));
        painter_.drawText(QRectF(x, y_, cell_width - mm(1.5), line_height()), alignment | Qt::AlignVCenter,
                          fitted);
    }
    void watermark(const QString& shown);

  private:
    OutputFile file_;
    QPdfWriter writer_;
    QPainter painter_;
    double y_ = 0;
    bool started_ = false;
};

/// Where the foot of a page begins.
double bottom_of(const Sheet& sheet);
/// A new page down to where its content begins.
void page_head(Sheet& sheet, const ReportProvenance& provenance, const QString& kind,
               const std::string& title, const QString& line, bool synthetic, bool provisional);
inline constexpr double footer_mm = 25;  ///< its height; the page's content ends 3 mm above it
void footer(Sheet& sheet, const ReportProvenance& provenance, const QString& n);

}  // namespace fulcrum::ui
