// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as CSV with a header row, as other programs write them: RFC 4180 with quotes, doubled quotes and
// line ends in quotes; LF or CRLF; a byte order mark is ignored.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fulcrum::database {

class CsvRows {
  public:
    /// Throws InputError with file and line: cannot be read, larger than 16 MiB, not UTF-8, no header, no
    /// commas in it but semicolons or tabs, a column named twice, a quote that does not end, a row with
    /// another number of cells.
    static CsvRows load(const std::string& path);
    static CsvRows parse(const std::string& text, const std::string& file);

    const std::string& file() const noexcept { return file_; }
    std::size_t size() const noexcept { return rows_.size(); }
    /// Column names are compared without regard to case.
    bool has(const std::string& column) const;
    /// "" where there is no such column. `row` from 0.
    const std::string& cell(std::size_t row, const std::string& column) const;
    /// Where the row begins, from 1.
    int line(std::size_t row) const { return rows_[row].line; }
    /// "users.csv:12".
    std::string place(std::size_t row) const;
    /// Throws InputError unless all are there.
    void require(const std::vector<std::string>& columns) const;

  private:
    struct Row {
        int line = 0;
        std::vector<std::string> cells;
    };
    std::size_t index_of(const std::string& column) const;
    std::string file_;
    std::vector<std::string> columns_;  ///< lower case
    std::vector<Row> rows_;
};

}  // namespace fulcrum::database
