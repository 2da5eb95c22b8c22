// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace fulcrum {
namespace {

constexpr std::size_t longest_compared = 64;

/// Levenshtein distance.
std::size_t letters_apart(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t k = 0; k < b.size(); ++k) {
            const std::size_t changed = diagonal + (a[i] == b[k] ? 0 : 1);
            diagonal = row[k + 1];
            row[k + 1] = std::min({changed, row[k + 1] + 1, row[k] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
    if (name.empty() || name.size() > longest_compared) return {};
    std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
    std::string nearest;
    for (const std::string& one : known) {
        if (one.size() > longest_compared) continue;
        const std::size_t apart = letters_apart(name, one);
        if (apart >= least || apart >= std::max(name.size(), one.size())) continue;
        least = apart;
        nearest = one;
    }
    return nearest;
}

}  // namespace fulcrum
