// SPDX-License-Identifier: GPL-3.0-or-later
// What a person changed on a page that was filled a while ago: an exchange or another window may have changed
// the rest since then, and that stays.
#pragma once

#include <algorithm>
#include <vector>

namespace fulcrum::ui {

template <typename T>
bool holds(const std::vector<T>& all, const T& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

/// Whether a choice, in any order, is another one than the page was filled with.
template <typename T>
bool is_changed(const std::vector<T>& filled, const std::vector<T>& chosen) {
    return !std::is_permutation(filled.begin(), filled.end(), chosen.begin(), chosen.end());
}

/// `now` with what was added to `filled` and without what was taken out of it.
template <typename T>
std::vector<T> with_changes(std::vector<T> now, const std::vector<T>& filled, const std::vector<T>& chosen) {
    const auto taken_out = [&](const T& one) { return holds(filled, one) && !holds(chosen, one); };
    now.erase(std::remove_if(now.begin(), now.end(), taken_out), now.end());
    for (const T& one : chosen)
        if (!holds(filled, one) && !holds(now, one)) now.push_back(one);
    return now;
}

}  // namespace fulcrum::ui
