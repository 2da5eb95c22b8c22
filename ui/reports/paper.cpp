// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/paper.h"

#include <QCoreApplication>
#include <QPageSize>

#include "database/rows/crypto.h"
#include "ui/reports/report_texts.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString joined(const std::vector<std::string>& parts) {
    QStringList list;
    for (const std::string& part : parts) list << text(part);
    return list.isEmpty() ? QStringLiteral("–") : list.join(QStringLiteral(", "));
}

}  // namespace

Sheet::Sheet(const std::string& path, bool landscape, const QString& title) try
    : file_(path, OutputFile::Existing::replace, OutputFile::Access::owner_only),
      writer_(text(file_.temporary_path())) {
    writer_.setResolution(dots_per_inch);
    writer_.setPageSize(QPageSize(QPageSize::A4));
    writer_.setPageOrientation(landscape ? QPageLayout::Landscape : QPageLayout::Portrait);
    writer_.setPageMargins(QMarginsF(14, 12, 14, 12), QPageLayout::Millimeter);
    writer_.setTitle(title);
    writer_.setCreator(QStringLiteral("Fulcrum"));
    if (!painter_.begin(&writer_)) {
        throw database::StoreError(database::StoreErrorKind::failed,
                                   {QT_TRANSLATE_NOOP("errors", "%1: the PDF cannot be written"), path},
                                   QT_TRANSLATE_NOOP("errors", "choose another folder or free some space"));
    }
} catch (const std::system_error& error) {
    fail_output(path, error);
}

Sheet::~Sheet() {
    if (painter_.isActive()) painter_.end();
}

void Sheet::finish() {
    painter_.end();
    try {
        file_.commit();
    } catch (const std::system_error& error) {
        fail_output(file_.path(), error);
    }
}

void Sheet::watermark(const QString& shown) {
    painter_.save();
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPointSizeF(54);
    font.setBold(true);
    painter_.setFont(font);
    QColor faint = paper_palette().bad;
    faint.setAlpha(28);
    painter_.setPen(faint);
    painter_.translate(width() / 2, height() / 2);
    painter_.rotate(-35);
    painter_.drawText(QRectF(-width(), -height() / 4, 2 * width(), height() / 2), Qt::AlignCenter, shown);
    painter_.restore();
}

double bottom_of(const Sheet& sheet) {
    return sheet.height() - Sheet::mm(footer_mm + 3);
}

void page_head(Sheet& sheet, const ReportProvenance& provenance, const QString& kind,
               const std::string& title, const QString& line, bool synthetic, bool provisional) {
    sheet.new_page();
    if (provenance.demo) sheet.watermark(ReportTexts::tr("DEMONSTRATION"));
    sheet.font(9, false, paper_palette().muted);
    sheet.paragraph(join_with_dots({text(provenance.programme), capital(kind)}));
    sheet.font(17, true);
    sheet.paragraph(text(title));
    sheet.font(9, false, paper_palette().muted);
    sheet.paragraph(line);
    sheet.font(9, true, paper_palette().bad);
    if (synthetic) sheet.paragraph(ReportTexts::tr("Synthetic: the people in this report are not real."));
    if (provisional) {
        sheet.paragraph(ReportTexts::tr(
            "Provisional limits (of synthetic operators, or of the task itself): they allow \"passed "
            "(provisional)\", never proficiency or a certificate."));
    }
    sheet.skip(2);
}

namespace {

/// A few files one by one; of many their number and one digest over the lines of names and digests, which the
/// other formats list.
QString assets_in_short(const std::vector<database::AssetFile>& assets) {
    constexpr std::size_t most = 4;
    QStringList files;
    std::string lines;
    for (const database::AssetFile& file : assets) {
        files << text(file.name) + QLatin1Char(' ') + text(file.digest.substr(0, 16));
        lines += file.digest + "  " + file.name + "\n";
    }
    return assets.size() <= most ? ReportTexts::tr("Files (sha256): %1").arg(files.join(QStringLiteral(", ")))
                                 : ReportTexts::tr("Files: %1, sha256 of their list %2")
                                       .arg(assets.size())
                                       .arg(text(database::sha256_hex(lines).substr(0, 16)));
}

}  // namespace

void footer(Sheet& sheet, const ReportProvenance& provenance, const QString& n) {
    const double top = sheet.height() - Sheet::mm(footer_mm);
    sheet.to(top);
    sheet.rule();
    sheet.font(7, false, paper_palette().muted);
    if (!provenance.metric_versions.empty())
        sheet.paragraph(ReportTexts::tr("Metrics: %1").arg(versions_in_short(provenance.metric_versions)));
    const QString sets = ReportTexts::tr("Benchmark sets: %1").arg(joined(provenance.benchmark_sets));
    const QString program = ReportTexts::tr("program %1").arg(text(provenance.program_version));
    sheet.paragraph(join_with_dots(
        {provenance.benchmark_sets.empty() ? QString() : sets, n,
         provenance.program_digest.empty()
             ? program
             : program + QStringLiteral(" sha256:") + text(provenance.program_digest.substr(0, 16))}));
    if (!provenance.assets.empty()) sheet.paragraph(assets_in_short(provenance.assets));
    const bool of_attempt = provenance.attempt_key.has_value();
    const QString key = text(provenance.attempt_key.value_or(provenance.station_key).substr(0, 16));
    const QString audit = text(provenance.audit_head.substr(0, 16));
    sheet.paragraph(join_with_dots(
        {text(provenance.programme),
         ReportTexts::tr("created %1 by %2 (%3)")
             .arg(local_time(provenance.as_of), text(provenance.made_by), role_text(provenance.made_as)),
         audit.isEmpty() ? audit : ReportTexts::tr("audit %1").arg(audit),
         key.isEmpty() ? key
         : of_attempt  ? ReportTexts::tr("attempt signed by key %1").arg(key)
                       : ReportTexts::tr("signed by key %1").arg(key),
         provenance.tamper_evident
             ? QString()
             : ReportTexts::tr("not tamper-evident (manual: Who can change the store)")}));
}

}  // namespace fulcrum::ui
