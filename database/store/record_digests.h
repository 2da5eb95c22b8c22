// SPDX-License-Identifier: GPL-3.0-or-later
// What the audit log keeps of every record that somebody is answerable for: a digest of its rows as they are
// after each deed. The newest digest of a record is compared with its rows by `db check`, so that a row that
// was changed, added or deleted without a deed is found (docs/FORMATS.md, *The store*). Internal to this
// floor.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "database/rows/connection.h"

namespace fulcrum::database {

/// Named in audit payloads by the words of record_kinds (record_digests.cpp).
enum class RecordKind : std::uint8_t {
    station,
    setting,
    programme,
    person,  ///< with roles and verifier
    cohort,  ///< with members and educators
    attempt,
    trace,  ///< of an attempt that has ended: its chunks and products
    score,  ///< with gates, metrics, critical errors, pathology
    attempt_void,
    reassignment,
    comment,  ///< one that was sent
    correction,
    tissues,  ///< id "TASK VERSION"
    decision,
    asset,  ///< accepted by the programme; id: its digest
    curriculum_move,
    rating,  ///< a form that was handed in, with its answers
    form,    ///< of a rating that was handed in; id: its digest
    rating_release,
    goal,  ///< a personal goal
    goal_end,
    error_review,  ///< an error that was confirmed or struck
    asset_text,    ///< what an accepted file says; id: its digest
};

struct RecordName {
    RecordKind kind = RecordKind::station;
    std::string id;
    /// "attempt 4f2a...", as in audit payloads.
    std::string text() const;
    /// The reverse; nothing for any other text.
    static std::optional<RecordName> of_text(const std::string& text);
};

class RecordDigests {
  public:
    explicit RecordDigests(Connection& connection);
    ~RecordDigests();
    RecordDigests(const RecordDigests&) = delete;
    RecordDigests& operator=(const RecordDigests&) = delete;
    /// BLAKE2b-256 of the record's rows, hex; "" where there is no such record. Every value with its type and
    /// length, every number by its bits.
    std::string of(const RecordName& name);
    /// As programs before schema 12 computed it, which knew no devices with force and no origins: "" where
    /// the record has either, or is no attempt. Audit rows of that time hold this one.
    std::string of_before_origins(const RecordName& name);
    /// Ids of the records of this kind.
    std::vector<std::string> ids(RecordKind kind);

  private:
    std::string digest_of(const std::string& id, const std::vector<const char*>& statements,
                          const char* later);
    Connection& connection_;
    std::map<std::string, std::unique_ptr<Query>> statements_;
};

/// Every record of the store, kind by kind.
std::vector<RecordName> all_records(Connection& connection);

/// Operation of the audit row that enters all records of a store from before there were digests.
inline constexpr const char* baseline_operation = "store.baseline";
/// Key of the digests in an audit payload: an object from RecordName::text() to the digest, "" for a record
/// that is gone.
inline constexpr const char* records_key = "records";

}  // namespace fulcrum::database
