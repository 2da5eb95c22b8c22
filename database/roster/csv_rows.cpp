// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/roster/csv_rows.h"

#include <QString>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::database {
namespace {

constexpr std::uintmax_t largest = std::uintmax_t{16} << 20U;  // bytes

constexpr std::string_view mark = "\xEF\xBB\xBF";
bool has_mark(const std::string& text) {
    return text.compare(0, mark.size(), mark) == 0;
}

std::string lower(std::string word) {
    for (char& c : word) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return word;
}

std::string trimmed(const std::string& cell) {
    const auto blank = [](char c) { return c == ' ' || c == '\t'; };
    const auto begin = std::find_if_not(cell.begin(), cell.end(), blank);
    const auto end = std::find_if_not(cell.rbegin(), std::make_reverse_iterator(begin), blank).base();
    return {begin, end};
}

/// One cell after the other; says whether a cell was the last of its row.
class Cells {
  public:
    Cells(const std::string& text, const std::string& file) : text_(text), file_(file) {
        if (has_mark(text_)) at_ = mark.size();
    }
    bool more() const { return at_ < text_.size(); }
    int line() const { return line_; }
    std::string next(bool& last) {
        std::string cell;
        const bool quoted = more() && text_[at_] == '"';
        if (quoted) cell = in_quotes();
        const std::size_t inside = cell.size();
        while (more() && text_[at_] != ',' && text_[at_] != '\n') cell += text_[at_++];
        last = !more() || text_[at_] == '\n';
        if (more()) {
            if (text_[at_] == '\n') ++line_;
            ++at_;
        }
        if (last && cell.size() > inside && cell.back() == '\r') cell.pop_back();
        return quoted ? cell : trimmed(cell);
    }

  private:
    std::string in_quotes() {
        const int begun = line_;
        std::string cell;
        for (++at_; more(); ++at_) {
            if (text_[at_] == '\n') ++line_;
            if (text_[at_] != '"') {
                cell += text_[at_];
            } else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
                cell += '"';
                ++at_;
            } else {
                ++at_;
                return cell;
            }
        }
        throw InputError(file_, std::to_string(begun),
                         QT_TRANSLATE_NOOP("errors", "a quotation mark opens here and is never closed"),
                         QT_TRANSLATE_NOOP("errors", "close the cell with a quotation mark"));
    }

    const std::string& text_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace

CsvRows CsvRows::load(const std::string& path) {
    const std::string name = std::filesystem::path(path).filename().string();
    std::error_code error;
    const bool regular = std::filesystem::is_regular_file(path, error);
    std::ifstream in(path, std::ios::binary);
    if (!regular || !in)
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "cannot be read"),
                         QT_TRANSLATE_NOOP("errors", "name a file that exists and may be read"));
    if (std::filesystem::file_size(path, error) > largest)
        throw InputError(name, "", QT_TRANSLATE_NOOP("errors", "is larger than 16 MiB"),
                         QT_TRANSLATE_NOOP("errors", "split it into smaller files"));
    return parse({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}, name);
}

CsvRows CsvRows::parse(const std::string& text, const std::string& file) {
    const std::string_view content = std::string_view(text).substr(has_mark(text) ? mark.size() : 0);
    if (QString::fromUtf8(content.data(), static_cast<int>(content.size())).toUtf8().toStdString() != content)
        throw InputError(file, "", QT_TRANSLATE_NOOP("errors", "is not UTF-8"),
                         QT_TRANSLATE_NOOP("errors", "save it as UTF-8"));
    CsvRows table;
    table.file_ = file;
    Cells cells(text, file);
    while (cells.more()) {
        Row row;
        row.line = cells.line();
        for (bool last = false; !last;) row.cells.push_back(cells.next(last));
        if (row.cells.size() == 1 && row.cells[0].empty()) continue;  // an empty line
        if (table.columns_.empty()) {
            if (row.cells.size() == 1 && row.cells[0].find_first_of(";\t") != std::string::npos)
                throw InputError(file, std::to_string(row.line),
                                 QT_TRANSLATE_NOOP("errors", "its cells are separated by semicolons or tabs"),
                                 QT_TRANSLATE_NOOP("errors", "save it with commas between the cells"));
            for (std::string& cell : row.cells) cell = lower(cell);
            table.columns_ = row.cells;
            std::sort(row.cells.begin(), row.cells.end());
            const auto twice = std::adjacent_find(row.cells.begin(), row.cells.end());
            if (twice != row.cells.end())
                throw InputError(file, "1",
                                 {QT_TRANSLATE_NOOP("errors", "the column '%1' occurs twice"), *twice},
                                 QT_TRANSLATE_NOOP("errors", "name each column once"));
        } else if (row.cells.size() != table.columns_.size()) {
            throw InputError(
                file, std::to_string(row.line),
                {QT_TRANSLATE_NOOP("errors", "has %1 cells where the first row has %2"), row.cells.size(),
                 table.columns_.size()},
                QT_TRANSLATE_NOOP(
                    "errors",
                    "give every row the same number of cells; put a cell that contains a comma in quotes"));
        } else {
            table.rows_.push_back(std::move(row));
        }
    }
    if (table.columns_.empty())
        throw InputError(file, "", QT_TRANSLATE_NOOP("errors", "is empty"),
                         QT_TRANSLATE_NOOP("errors", "begin with a row of column names"));
    return table;
}

std::size_t CsvRows::index_of(const std::string& column) const {
    return static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), lower(column)) -
                                    columns_.begin());
}

bool CsvRows::has(const std::string& column) const {
    return index_of(column) < columns_.size();
}

const std::string& CsvRows::cell(std::size_t row, const std::string& column) const {
    static const std::string nothing;
    const std::size_t index = index_of(column);
    return index < columns_.size() ? rows_[row].cells[index] : nothing;
}

std::string CsvRows::place(std::size_t row) const {
    return file_ + ":" + std::to_string(line(row));
}

void CsvRows::require(const std::vector<std::string>& columns) const {
    for (const std::string& column : columns) {
        if (!has(column))
            throw InputError(file_, "1", {QT_TRANSLATE_NOOP("errors", "has no column %1"), column},
                             QT_TRANSLATE_NOOP("errors", "add it to the first row"));
    }
}

}  // namespace fulcrum::database
