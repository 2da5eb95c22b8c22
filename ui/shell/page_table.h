// SPDX-License-Identifier: GPL-3.0-or-later
// Which pages the rail offers to whom. A new screen is its pair of files and one line in page_table.cpp.
#pragma once

#include <QString>
#include <typeindex>
#include <vector>

#include "ui/page/context.h"

namespace fulcrum::ui {

struct PageEntry {
    const char* name;                   ///< object name of the rail's button
    const char* title;                  ///< on that button; in English, see page_title()
    std::vector<database::Role> roles;  ///< who sees it
    std::type_index type;               ///< the page's class: entries of one class share the page
    Page* (*make)(Context& context);
    bool at_station_only = false;  ///< for what is done at a station: not shown for a programme server
};

/// In the order of the rail; a role's first entry is the page it starts on.
const std::vector<PageEntry>& page_table();
/// Those that the session's role sees now.
std::vector<const PageEntry*> pages_of(Context& context);
/// In today's language.
QString page_title(const PageEntry& entry);

}  // namespace fulcrum::ui
