// SPDX-License-Identifier: GPL-3.0-or-later
// docs/results/hands.md: each kind of device with its first steps and its tasks. Each is entered in the
// folder that FULCRUM_HANDS_PAGE names, and the page is written from all rows that are there, each with the
// commit at which it was measured: it can be made in parts.
#pragma once

#include <string>
#include <vector>

namespace fulcrum::app::program_test {

/// Kinds of make_taught(), in the order of the page.
const std::vector<std::string>& hands_kinds();

struct HandsRow {
    std::string kind, task;  ///< together the key: measured again, a row is replaced
    std::vector<std::string> cells;
    std::string commit = {};  ///< of the program that measured it; enter_hands() fills it in
};
inline constexpr const char* first_steps_task = "first steps";

/// The folder of the page; null: none is asked for.
const char* hands_folder();
void enter_hands(HandsRow row);

}  // namespace fulcrum::app::program_test
