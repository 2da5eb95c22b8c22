// SPDX-License-Identifier: Apache-2.0
// Rows and cells of a CSV file, for the readers of this room.
#pragma once

#include <algorithm>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/trace/trace_csv.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

/// Splits lines into cells, counts rows, makes the errors.
class CsvReader {
  public:
    /// `separator`: between cells; ' ' means one or more spaces or tabs.
    CsvReader(std::istream& in, const std::string& file, char separator = ',')
        : in_(in), file_(file), separator_(separator) {}

    bool next() {
        if (!read_line()) return false;
        ++row_;
        split();
        return true;
    }
    const std::vector<std::string_view>& cells() const { return cells_; }
    [[noreturn]] void fail(const std::string& column, const Sentence& wrong, const Sentence& hint) const {
        fail_at(row_, column, wrong, hint);
    }
    /// For what should have been in a row that is not there.
    [[noreturn]] void fail_at(std::size_t row, const std::string& column, const Sentence& wrong,
                              const Sentence& hint) const {
        throw InputError(file_, std::to_string(row) + ": " + column, wrong, hint);
    }
    /// Cells are shown in errors; they may hold anything.
    static std::string quoted(std::string_view cell) {
        std::string text = "'";
        for (const char c : cell.substr(0, 40)) text += c >= ' ' && c < 127 ? c : '?';
        return text + (cell.size() > 40 ? "…'" : "'");
    }

  private:
    bool read_line() {
        line_.clear();
        for (;;) {
            if (position_ == filled_) {
                in_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
                filled_ = static_cast<std::size_t>(in_.gcount());
                position_ = 0;
                if (filled_ == 0) return !line_.empty();
            }
            const char* begin = buffer_.data() + position_;
            const char* end = buffer_.data() + filled_;
            const char* newline = std::find(begin, end, '\n');
            line_.append(begin, newline);
            position_ += static_cast<std::size_t>(newline - begin);
            if (line_.size() > trace_csv_line_limit) {
                ++row_;
                fail("(line)", {QT_TRANSLATE_NOOP("errors", "longer than %1 bytes"), trace_csv_line_limit},
                     QT_TRANSLATE_NOOP("errors", "write one sample per row"));
            }
            if (newline != end) {
                ++position_;
                if (!line_.empty() && line_.back() == '\r') line_.pop_back();
                return true;
            }
        }
    }

    void split() {
        cells_.clear();
        std::string_view rest = line_;
        if (separator_ == ' ') {
            split_at_spaces(rest);
            return;
        }
        for (;;) {
            const std::size_t comma = rest.find(separator_);
            cells_.push_back(trimmed(rest.substr(0, comma)));
            if (comma == std::string_view::npos) break;
            rest.remove_prefix(comma + 1);
        }
    }

    void split_at_spaces(std::string_view rest) {
        constexpr std::string_view space = " \t";
        for (;;) {
            const std::size_t begin = rest.find_first_not_of(space);
            if (begin == std::string_view::npos) break;
            rest.remove_prefix(begin);
            const std::size_t end = std::min(rest.find_first_of(space), rest.size());
            cells_.push_back(rest.substr(0, end));
            rest.remove_prefix(end);
        }
        if (cells_.empty()) cells_.emplace_back();
    }

    static std::string_view trimmed(std::string_view cell) {
        while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
        while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
        // Spreadsheets put labels into quotes; the format needs none, so a plain pair is taken off.
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
            cell = cell.substr(1, cell.size() - 2);
        return cell;
    }

    std::istream& in_;
    std::string file_;
    char separator_;
    std::vector<char> buffer_ = std::vector<char>(1U << 16U);
    std::size_t filled_ = 0, position_ = 0, row_ = 0;
    std::string line_;
    std::vector<std::string_view> cells_;
};

}  // namespace fulcrum
