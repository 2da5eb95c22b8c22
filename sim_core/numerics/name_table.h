// SPDX-License-Identifier: Apache-2.0
// An enum and its one table: every value with its name in files and its title on screens. A file's word that
// is not in the table is an error where the file is read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Marks an English text for lupdate; as Qt defines it. Screens translate it by its context.
#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(scope, x) x
#endif

namespace fulcrum {

/// A row of a table that holds nothing but names. Tables with more columns have `kind` and `name` as well.
template <typename Enum>
struct NameRow {
    Enum kind;
    const char* name;   ///< in files; permanent
    const char* title;  ///< on screens, English
};

/// True if row i is that of the enum's value i: then row_of() is a look-up by index.
template <typename Row, std::size_t n>
constexpr bool in_order(const Row (&rows)[n]) {
    for (std::size_t i = 0; i < n; ++i)
        if (static_cast<std::size_t>(rows[i].kind) != i) return false;
    return true;
}

template <typename Row, std::size_t n, typename Enum>
constexpr const Row& row_of(const Row (&rows)[n], Enum kind) {
    return rows[static_cast<std::size_t>(kind)];
}

/// Null where no row has this name.
template <typename Row, std::size_t n>
constexpr const Row* find_row(const Row (&rows)[n], std::string_view name) {
    for (const Row& row : rows)
        if (name == row.name) return &row;
    return nullptr;
}

/// "a, b, c", for the hint of an error.
template <typename Row, std::size_t n>
std::string names_of(const Row (&rows)[n]) {
    std::string names;
    for (const Row& row : rows) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

}  // namespace fulcrum
