// SPDX-License-Identifier: Apache-2.0
// Words of a file that stand for values of an enum: whatever is not in the enum's table is refused, with the
// place and the words that are known. Nothing is turned into a default.
#pragma once

#include "sim_core/numerics/name_table.h"
#include "sim_core/numerics/types.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {

inline constexpr NameRow<Hand> hand_names[] = {
    {Hand::left, QT_TRANSLATE_NOOP("errors", "left"), QT_TRANSLATE_NOOP("fulcrum::hands", "left hand")},
    {Hand::right, QT_TRANSLATE_NOOP("errors", "right"), QT_TRANSLATE_NOOP("fulcrum::hands", "right hand")}};
static_assert(in_order(hand_names));

/// The value that a word in a file stands for. Throws InputError.
template <typename Row, std::size_t n>
auto named(const JsonDocument& document, const nlohmann::json& word, const std::string& place,
           const Row (&rows)[n]) {
    const Row* row = word.is_string() ? find_row(rows, word.get_ref<const std::string&>()) : nullptr;
    if (row == nullptr)
        document.fail(place, {QT_TRANSLATE_NOOP("errors", "unknown name %1"), word.dump()},
                      {QT_TRANSLATE_NOOP("errors", "give one of: %1"), names_of(rows)});
    return row->kind;
}

/// As named(), of a key that may be absent: then `value` stays.
template <typename Row, std::size_t n, typename Enum>
void copy_named(const JsonDocument& document, const nlohmann::json& node, const std::string& place,
                const char* key, const Row (&rows)[n], Enum& value) {
    if (node.contains(key)) value = named(document, node.at(key), place + "/" + key, rows);
}

}  // namespace fulcrum
