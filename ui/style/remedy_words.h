// SPDX-License-Identifier: GPL-3.0-or-later
// The remedies of a curriculum in words: when they are meant, and what to do.
#pragma once

#include <QString>
#include <vector>

#include "assessment/curriculum/remedy.h"
#include "assessment/task/task.h"

namespace fulcrum::ui {

/// "above 880 mm".
QString remedy_bound_words(const Remedy& remedy);
/// "practise it from “Divide the sheet …” on": `task` is the one whose remedy it is. Names that are not among
/// `tasks` stay as they are in the file.
QString remedy_action_words(const Remedy& remedy, const std::string& task,
                            const std::vector<TaskDefinition>& tasks);
/// A line of a list: "Path length above 880 mm: practise it with the ghost of an expert".
QString remedy_words(const Remedy& remedy, const std::string& task, const std::vector<TaskDefinition>& tasks);

}  // namespace fulcrum::ui
