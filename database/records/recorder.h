// SPDX-License-Identifier: GPL-3.0-or-later
// Writes one attempt while it runs: chunks of about one second in a transaction each, so that a crash costs
// at most the last second and the attempt is found again as interrupted. Has a connection of its own; calls
// come from one thread at a time (the recorder's, or the only one when headless). append() only copies; a
// flush writes and may block on the disk: never call from the haptic or world thread.
#pragma once

#include <memory>
#include <string>

#include "database/rows/attempt_records.h"
#include "database/rows/trace_codec.h"
#include "database/store/store.h"

namespace fulcrum::database {

class Recorder {
  public:
    /// Checks perform_attempt for meta.person_id and writes the attempt as running. Throws AccessDenied,
    /// StoreError.
    Recorder(const std::string& store_path, const Session& session, AttemptMeta meta,
             StoreOptions options = {});
    /// Without finish() the attempt stays running in the store and is listed as interrupted when it is next
    /// opened.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    const std::string& attempt_id() const noexcept;
    const AttemptMeta& meta() const noexcept;

    /// An input and what it led to, in pairs. Flushes by itself whenever flush_ticks samples have gathered;
    /// while another program holds the store it keeps up to a minute and tries again each second, then throws
    /// StoreError locked. Other failures of the store (disk_full ...) throw at once. Either way nothing that
    /// was appended is dropped.
    void append(const RigSample& input);
    void append(const TickSample& sample);
    void append(const StepRecord& step);
    void append(const Event& event);
    /// Writes what has gathered, in one transaction. StoreError (disk_full, locked ...): nothing was dropped,
    /// call again or finish.
    void flush();
    /// An assessed attempt continues as practice (a device was lost and came back): stored at once, audited
    /// with the reason. False while another program holds the store: ask again. No effect on practice.
    bool relabel_as_practice(const Statement& reason);
    /// The rest of the trace, the result and its score, in one transaction, audited. Once. On StoreError
    /// nothing was written and it may be called again.
    void finish(const AttemptResult& result);
    bool finished() const noexcept;

    std::uint64_t bytes_written() const noexcept;  ///< compressed trace so far
    std::uint64_t records_waiting() const noexcept;
    static constexpr std::uint32_t flush_ticks = 1000;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fulcrum::database
