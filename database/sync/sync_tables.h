// SPDX-License-Identifier: GPL-3.0-or-later
// What is exchanged between a station and the programme server, in which order, which way and by which rule:
// one list that the exchange walks (docs/FORMATS.md, Sync). A unit is a row with the rows that belong to it;
// it is transferred whole or not at all.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/store/record_digests.h"

namespace fulcrum::database {

struct ChildTable {
    const char* table;
    const char* key;       ///< the column that names the unit
    bool up_only = false;  ///< pushed; not pulled
};

/// A column that has to name a unit which the other side has: else the unit waits.
struct Reference {
    const char* table;  ///< the unit's own, or one of its children
    const char* column;
    const char* target;  ///< table of the unit that it names
};

enum class SyncRule : std::uint8_t {
    added,      ///< written once and never changed: whoever lacks it gets it
    versioned,  ///< the higher `version` counts; where both are equal and differ, the server's
};

struct SyncTable {
    const char* title;  ///< in messages
    const char* table;
    std::vector<const char*> key;
    SyncRule rule;
    const char* where;  ///< which rows are exchanged, in SQL for both engines
    std::vector<ChildTable> children = {};
    std::vector<Reference> references = {};
    std::optional<RecordKind> record = {};  ///< in the audit log of the station that receives it
    const char* unique = nullptr;           ///< a column by which no two units may be equal
    int batch = 200;                        ///< units in a transaction
    bool only_from_whole = false;  ///< sent by stations that have the whole programme; others receive it
};

const std::vector<SyncTable>& sync_tables();

/// "id", or "attempt_id || ' ' || person_id": names a unit in one text.
std::string key_expression(const SyncTable& table);

}  // namespace fulcrum::database
