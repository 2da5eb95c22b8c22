// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a report as an XLSX workbook: the same cells as the CSV, numbers as numbers, its dictionary
// and its origin.
#include <xlsxwriter.h>

#include <QFile>
#include <QTemporaryDir>
#include <algorithm>

#include "ui/reports/report_rows.h"
#include "ui/reports/report_sheet.h"
#include "ui/reports/report_writer.h"

namespace fulcrum::ui {
namespace {

constexpr double narrowest = 8, widest = 44;  // characters

/// A sheet being written; remembers how wide its columns have to be.
class SheetWriter {
  public:
    SheetWriter(lxw_workbook* book, const std::string& name)
        : sheet_(workbook_add_worksheet(book, name.c_str())) {}

    void words(lxw_row_t row, std::size_t column, const std::string& text, lxw_format* format = nullptr) {
        worksheet_write_string(sheet_, row, at(column), text.c_str(), format);
        widen(column, text.size());
    }
    void number(lxw_row_t row, std::size_t column, double value) {
        worksheet_write_number(sheet_, row, at(column), value, nullptr);
        widen(column, 10);
    }
    void cell(lxw_row_t row, std::size_t column, const SheetCell& value) {
        if (const auto* text = std::get_if<std::string>(&value)) words(row, column, *text);
        if (const auto* one = std::get_if<double>(&value)) number(row, column, *one);
        if (const auto* count = std::get_if<long long>(&value))
            number(row, column, static_cast<double>(*count));
        if (const auto* flag = std::get_if<bool>(&value)) number(row, column, *flag ? 1 : 0);
    }
    /// The first rows stay in view and rows can be chosen by what their cells say.
    void finish(int heads, lxw_row_t last_row) {
        for (std::size_t i = 0; i < widths_.size(); ++i)
            worksheet_set_column(sheet_, at(i), at(i), std::clamp(widths_[i] + 2.0, narrowest, widest),
                                 nullptr);
        worksheet_freeze_panes(sheet_, static_cast<lxw_row_t>(heads), 0);
        if (heads > 0 && !widths_.empty())
            worksheet_autofilter(sheet_, static_cast<lxw_row_t>(heads - 1), 0, last_row,
                                 at(widths_.size() - 1));
    }

  private:
    static lxw_col_t at(std::size_t column) { return static_cast<lxw_col_t>(column); }
    void widen(std::size_t column, std::size_t characters) {
        if (widths_.size() <= column) widths_.resize(column + 1, 0);
        widths_[column] = std::max(widths_[column], static_cast<double>(characters));
    }
    lxw_worksheet* sheet_;
    std::vector<double> widths_;
};

void write_origin(lxw_workbook* book, lxw_format* bold, const ReportProvenance& provenance) {
    SheetWriter writer(book, "Origin");
    const std::pair<const char*, std::string> lines[] = {
        {"programme", provenance.programme},
        {"as_of_utc", database::iso_utc(provenance.as_of)},
        {"made_by", provenance.made_by},
        {"made_as", provenance.made_as},
        {"program_version", provenance.program_version},
        {"program_versions", joined(provenance.program_versions)},
        {"metric_versions", joined(provenance.metric_versions)},
        {"benchmark_sets", joined(provenance.benchmark_sets)},
        {"assets", joined_assets(provenance.assets)},
        {"program_sha256", provenance.program_digest},
        {"tamper_evidence", tamper_evidence(provenance)},
        {"audit_head", provenance.audit_head},
        {"station_key", provenance.station_key},
        {"demonstration", provenance.demo ? "every person in this file is synthetic" : "no"},
    };
    lxw_row_t row = 0;
    for (const auto& [name, value] : lines) {
        writer.words(row, 0, name, bold);
        writer.words(row++, 1, value);
    }
    writer.finish(0, row);
}

[[noreturn]] void fail(const std::string& why) {
    throw database::StoreError(
        database::StoreErrorKind::failed,
        {QT_TRANSLATE_NOOP("errors", "the workbook cannot be made (%1)"), why},
        QT_TRANSLATE_NOOP("errors", "free some space in the folder of temporary files, or choose CSV"));
}

}  // namespace

std::string workbook(const DataSheet& sheet, const ReportProvenance& provenance) {
    // The library writes files only, and temporary files of its own.
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("workbook.xlsx")).toStdString();
    std::string parts = folder.path().toStdString();
    lxw_workbook_options options{};
    options.tmpdir = parts.data();
    lxw_workbook* book = folder.isValid() ? workbook_new_opt(path.c_str(), &options) : nullptr;
    if (book == nullptr) fail(folder.errorString().toStdString());
    lxw_format* bold = workbook_add_format(book);
    format_set_bold(bold);
    lxw_format* grey = workbook_add_format(book);
    format_set_italic(grey);
    format_set_font_color(grey, LXW_COLOR_GRAY);
    {
        SheetWriter writer(book, sheet.name);
        for (std::size_t i = 0; i < sheet.columns.size(); ++i) {
            writer.words(0, i, sheet.columns[i].name, bold);
            writer.words(1, i, sheet.columns[i].unit, grey);
        }
        lxw_row_t row = 2;
        for (const std::vector<SheetCell>& cells : sheet.rows) {
            for (std::size_t i = 0; i < cells.size(); ++i) writer.cell(row, i, cells[i]);
            ++row;
        }
        writer.finish(2, row - 1);
    }
    {
        SheetWriter writer(book, "Dictionary");
        std::size_t column = 0;
        for (const char* head : {"column", "unit", "meaning"}) writer.words(0, column++, head, bold);
        lxw_row_t row = 1;
        for (const SheetColumn& one : sheet.columns) {
            writer.words(row, 0, one.name);
            writer.words(row, 1, one.unit);
            writer.words(row++, 2, one.meaning);
        }
        writer.finish(1, row - 1);
    }
    write_origin(book, bold, provenance);
    const lxw_error error = workbook_close(book);  // frees the book
    if (error != LXW_NO_ERROR) fail(lxw_strerror(error));
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly)) fail(file.errorString().toStdString());
    return file.readAll().toStdString();
}

namespace {

class XlsxWriter : public ReportWriter {
  public:
    ReportFiles write_person(const PersonReport& report, const ReportRequest& request) const override {
        save_report(request.path, workbook(person_sheet(report), report.provenance));
        return {request.path};
    }
    ReportFiles write_cohort(const ReportSource& source, const ReportRequest& request,
                             const Progress& progress) const override {
        const auto report = gather_cohort(source, request, PeoplePages::none, progress);
        if (!report) return {};
        save_report(request.path, workbook(cohort_sheet(*report), report->provenance));
        return {request.path};
    }
};

}  // namespace

const ReportWriter& xlsx_writer() {
    static const XlsxWriter writer;
    return writer;
}

}  // namespace fulcrum::ui
