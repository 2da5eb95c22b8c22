// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/research/suppression.h"

#include <cstddef>
#include <utility>

namespace fulcrum::database {
namespace {

/// Which counts are hidden, and what makes them safe.
class Hiding {
  public:
    explicit Hiding(const CountTable& table)
        : counts_(table.counts),
          rows_(counts_.size()),
          columns_(counts_.empty() ? 0 : counts_[0].size()),
          hidden_(rows_, std::vector<bool>(columns_, false)) {
        for (std::size_t r = 0; r < rows_; ++r)
            for (std::size_t c = 0; c < columns_; ++c)
                hidden_[r][c] = counts_[r][c] < least_people || table.people[r][c] < least_people;
    }
    /// Hides more until nothing follows. Each step hides one more count, so it ends.
    void complete() {
        while (hide_in_lines() || hide_for_links()) {
        }
    }
    bool is_hidden(std::size_t r, std::size_t c) const { return hidden_[r][c]; }

  private:
    bool hide_in_lines() {
        for (std::size_t r = 0; r < rows_; ++r)
            if (!is_safe_row(r) && hide_smallest_of_row(r)) return true;
        for (std::size_t c = 0; c < columns_; ++c)
            if (!is_safe_column(c) && hide_smallest_of_column(c)) return true;
        return false;
    }
    static bool is_safe(int hidden, long long sum) {
        return hidden == 0 || (hidden >= 2 && sum >= least_people);
    }
    // The total of a line counts as the sum of the others: hidden counts with it are a sum and a difference.
    bool is_safe_row(std::size_t r) const {
        int hidden = 0;
        long long sum = 0;
        for (std::size_t c = 0; c < columns_; ++c)
            if (hidden_[r][c]) ++hidden, sum += counts_[r][c];
        return is_safe(hidden, sum);
    }
    bool is_safe_column(std::size_t c) const {
        int hidden = 0;
        long long sum = 0;
        for (std::size_t r = 0; r < rows_; ++r)
            if (hidden_[r][c]) ++hidden, sum += counts_[r][c];
        return is_safe(hidden, sum);
    }
    bool hide_smallest_of_row(std::size_t r) {
        std::size_t best = columns_;
        for (std::size_t c = 0; c < columns_; ++c)
            if (!hidden_[r][c] && (best == columns_ || counts_[r][c] < counts_[r][best])) best = c;
        if (best == columns_) return false;
        hidden_[r][best] = true;
        return true;
    }
    bool hide_smallest_of_column(std::size_t c) {
        std::size_t best = rows_;
        for (std::size_t r = 0; r < rows_; ++r)
            if (!hidden_[r][c] && (best == rows_ || counts_[r][c] < counts_[best][c])) best = r;
        if (best == rows_) return false;
        hidden_[best][c] = true;
        return true;
    }
    /// Rows and columns are places, a hidden count is a way between its row and its column. One without a way
    /// around it follows from the sums of all lines on one side.
    bool has_way_around(std::size_t row, std::size_t column) const {
        std::vector<bool> seen_row(rows_, false), seen_column(columns_, false);
        std::vector<std::size_t> open = {row};
        seen_row[row] = true;
        while (!open.empty()) {
            const std::size_t r = open.back();
            open.pop_back();
            for (std::size_t c = 0; c < columns_; ++c) {
                if (!hidden_[r][c] || seen_column[c] || (r == row && c == column)) continue;
                seen_column[c] = true;
                for (std::size_t next = 0; next < rows_; ++next) {
                    if (!hidden_[next][c] || seen_row[next] || (next == row && c == column)) continue;
                    seen_row[next] = true;
                    open.push_back(next);
                }
            }
        }
        return seen_column[column];
    }
    bool hide_for_links() {
        for (std::size_t r = 0; r < rows_; ++r)
            for (std::size_t c = 0; c < columns_; ++c)
                if (hidden_[r][c] && !has_way_around(r, c) &&
                    (hide_smallest_of_row(r) || hide_smallest_of_column(c)))
                    return true;
        return false;
    }

    const std::vector<std::vector<long long>>& counts_;
    std::size_t rows_, columns_;
    std::vector<std::vector<bool>> hidden_;
};

}  // namespace

std::vector<std::vector<std::optional<long long>>> suppress_small(const CountTable& table) {
    Hiding hiding(table);
    hiding.complete();
    std::vector<std::vector<std::optional<long long>>> shown;
    for (std::size_t r = 0; r < table.counts.size(); ++r) {
        shown.emplace_back();
        for (std::size_t c = 0; c < table.counts[r].size(); ++c)
            shown.back().push_back(hiding.is_hidden(r, c) ? std::optional<long long>() : table.counts[r][c]);
    }
    return shown;
}

}  // namespace fulcrum::database
