// SPDX-License-Identifier: GPL-3.0-or-later
// Whether an account belongs to a person, a synthetic operator or whoever recorded an imported trace.
#pragma once

#include <cstdint>
#include <string>

#include "database/rows/enum_column.h"

namespace fulcrum::database {

enum class PersonKind : std::uint8_t { real, synthetic, external };
inline constexpr NameRow<PersonKind> person_kinds[] = {
    {PersonKind::real, "real", QT_TRANSLATE_NOOP("fulcrum::people", "real")},
    {PersonKind::synthetic, "synthetic", QT_TRANSLATE_NOOP("fulcrum::people", "synthetic")},
    {PersonKind::external, "external", QT_TRANSLATE_NOOP("fulcrum::people", "external")}};
static_assert(in_order(person_kinds));

/// The column `kind` of a person. Throws StoreError corrupt for an unknown word.
inline PersonKind person_kind_of(const std::string& stored, const std::string& person) {
    return enum_of(stored, person_kinds, "kind of person " + person);
}

}  // namespace fulcrum::database
