// SPDX-License-Identifier: GPL-3.0-or-later
// Enums in the store: written and read by the names of their tables.
#pragma once

#include <string>
#include <type_traits>

#include "database/rows/connection.h"
#include "database/rows/errors.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum::database {

/// The value that a column names. Throws StoreError corrupt, naming `place` ("mode of attempt 4f2a..."; a
/// text, or what makes it then), where the table has no such name.
template <typename Row, std::size_t n, typename Place>
auto enum_of(const std::string& name, const Row (&rows)[n], const Place& place) {
    const Row* row = find_row(rows, name);
    if (row == nullptr) {
        std::string where;
        if constexpr (std::is_invocable_v<Place>) {
            where = place();
        } else {
            where = place;
        }
        throw StoreError(
            StoreErrorKind::corrupt,
            {QT_TRANSLATE_NOOP("errors", "%1: '%2' is unknown; known are %3"), where, name, names_of(rows)},
            QT_TRANSLATE_NOOP("errors",
                              "use the program version that wrote the store, or restore the newest backup"));
    }
    return row->kind;
}

}  // namespace fulcrum::database
