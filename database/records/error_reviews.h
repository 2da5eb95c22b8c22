// SPDX-License-Identifier: GPL-3.0-or-later
// Educators confirm or strike errors that the program recorded by itself, with a reason. Nothing is edited:
// the newest review of an error counts, the record and the score stay as they are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/store/store.h"
#include "sim_core/numerics/name_table.h"
#include "sim_core/telemetry/event.h"

namespace fulcrum::database {

enum class ErrorVerdict : std::uint8_t { confirmed, struck };
inline constexpr NameRow<ErrorVerdict> error_verdicts[] = {
    {ErrorVerdict::confirmed, "confirmed", "confirmed"}, {ErrorVerdict::struck, "struck", "struck"}};
static_assert(in_order(error_verdicts));

struct ErrorReview {
    std::string id, attempt_id, author_id, author_name;
    std::uint32_t tick = 0;
    EventKind kind = EventKind::slip;
    std::uint8_t hand = 255;
    std::int8_t tissue = -1;
    std::int32_t detail = 0;
    ErrorVerdict verdict = ErrorVerdict::confirmed;
    std::string reason;
    std::int64_t time = 0;  ///< UTC ms
    /// Its value is no part of what names an event.
    bool is_of(const Event& event) const {
        return event.tick == tick && event.kind == kind && event.hand == hand && event.tissue == tissue &&
               event.detail == detail;
    }
};

class ErrorReviews {
  public:
    explicit ErrorReviews(const Store& store) : store_(store) {}

    /// All of them, oldest first.
    std::vector<ErrorReview> history(const Session& session, const std::string& attempt_id) const;
    /// The newest of each error, by the moment of the error.
    std::vector<ErrorReview> in_force(const Session& session, const std::string& attempt_id) const;
    /// `reason`: 1 to 1,000 characters. Throws bad_value where the attempt's record has no such event, or it
    /// is no error; not_found where the record is not in this store; conflict while it is being recorded.
    /// Returns the id.
    std::string add(const Session& educator, const std::string& attempt_id, const Event& event,
                    ErrorVerdict verdict, const std::string& reason) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
