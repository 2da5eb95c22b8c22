// SPDX-License-Identifier: GPL-3.0-or-later
// CSV: UTF-8, a header row, a units row, ISO 8601 UTC, raw next to scaled columns, formula-injection guard.
#include "ui/reports/report_sheet.h"
#include "ui/reports/report_writer.h"

namespace fulcrum::ui {
namespace {

std::string cell_text(const SheetCell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return csv_text(*text);
    if (const auto* number = std::get_if<double>(&cell)) return csv_number(*number);
    if (const auto* count = std::get_if<long long>(&cell)) return std::to_string(*count);
    if (const auto* flag = std::get_if<bool>(&cell)) return *flag ? "1" : "0";
    return {};
}

void add_row(std::string& csv, const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) csv += (i == 0 ? "" : ",") + cells[i];
    csv += "\r\n";
}

}  // namespace

std::string sheet_csv(const DataSheet& sheet) {
    std::string csv;
    std::vector<std::string> names, units;
    for (const SheetColumn& column : sheet.columns) {
        names.push_back(csv_text(column.name));
        units.push_back(csv_text(column.unit));
    }
    add_row(csv, names);
    add_row(csv, units);
    for (const std::vector<SheetCell>& row : sheet.rows) {
        std::vector<std::string> cells;
        for (const SheetCell& cell : row) cells.push_back(cell_text(cell));
        add_row(csv, cells);
    }
    return csv;
}

std::string dictionary_csv(const DataSheet& sheet) {
    std::string csv;
    add_row(csv, {"column", "unit", "meaning"});
    for (const SheetColumn& column : sheet.columns)
        add_row(csv, {csv_text(column.name), csv_text(column.unit), csv_text(column.meaning)});
    return csv;
}

namespace {

class CsvWriter : public ReportWriter {
  public:
    ReportFiles write_attempt(const AttemptPaper& paper, const ReportRequest& request) const override {
        save_report(request.path, attempt_csv(paper));
        return {request.path};
    }
    ReportFiles write_person(const PersonReport& report, const ReportRequest& request) const override {
        return write(person_sheet(report), request.path);
    }
    ReportFiles write_cohort(const ReportSource& source, const ReportRequest& request,
                             const Progress& progress) const override {
        const auto report = gather_cohort(source, request, PeoplePages::none, progress);
        return report ? write(cohort_sheet(*report), request.path) : ReportFiles();
    }

  private:
    static ReportFiles write(const DataSheet& sheet, const std::string& path) {
        const std::string dictionary = path + ".dictionary.csv";
        save_report(path, sheet_csv(sheet));
        save_report(dictionary, dictionary_csv(sheet));
        return {path, dictionary};
    }
};

}  // namespace

const ReportWriter& csv_writer() {
    static const CsvWriter writer;
    return writer;
}

}  // namespace fulcrum::ui
