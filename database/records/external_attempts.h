// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts that were recorded elsewhere (box trainer, robot, another simulator) and imported as a trace. They
// are measured and shown with their class, `external`; nothing judges them and they enter no standing: their
// exercise is none of a curriculum, and they are practice without a verdict. They are stored, audited,
// voided, reassigned, synchronised and erased as other attempts are.
#pragma once

#include <string>
#include <vector>

#include "database/rows/attempt_records.h"
#include "database/store/store.h"

namespace fulcrum::database {

struct ExternalAttempt {
    std::string person_id;
    std::string exercise;        ///< "peg-transfer": 1 to 40 letters, digits, dots, hyphens and underscores
    std::string source;          ///< what recorded it, 1 to 200 characters
    std::int64_t performed = 0;  ///< UTC ms, not after now
    int utc_offset_min = 0;
    double duration_s = 0;
    std::string trace;             ///< Trace CSV
    std::vector<AssetFile> files;  ///< that it was read from: external_trace_file, external_mapping_file
    std::string program_version;
    ScoreRow score;  ///< metrics alone: no verdict, gates or points
};

/// Names in ExternalAttempt::files. The digest is of the file as it was imported.
inline constexpr const char* external_trace_file = "external/trace";
inline constexpr const char* external_mapping_file = "external/mapping";

/// The kind of the product that holds the trace, packed (pack_bytes()).
inline constexpr const char* external_trace_product = "external_trace";

/// Throws not_found: its trace is at another station, or it is none of these attempts.
[[noreturn]] void no_imported_trace(const std::string& attempt_id);

class ExternalAttempts {
  public:
    explicit ExternalAttempts(const Store& store) : store_(store) {}

    /// One transaction, audited. Returns the attempt's id. Operation::import_attempt. Throws AccessDenied;
    /// StoreError bad_value, conflict where this person has an attempt of the same trace that is not voided.
    std::string add(const Session& session, const ExternalAttempt& attempt) const;
    /// Throws bad_value where add() would, whoever the person is.
    void check_values(const ExternalAttempt& attempt) const;
    /// Throws what add() would, and stores nothing.
    void check(const Session& session, const ExternalAttempt& attempt) const;
    /// The trace as it was measured, Trace CSV. Operation::read_trace. Throws StoreError not_found where the
    /// attempt is none of these or its trace is at another station, corrupt.
    std::string trace(const Session& session, const std::string& attempt_id) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
