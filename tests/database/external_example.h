// SPDX-License-Identifier: GPL-3.0-or-later
// A trace of a box trainer, as `fulcrum import` stores it.
#pragma once

#include <limits>

#include "database/records/external_attempts.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {

inline constexpr const char* box_trace = "t,left.px\ns,m\n0,0.1\n0.5,0.2\n";

inline ExternalAttempt box_attempt(const std::string& person) {
    ExternalAttempt attempt;
    attempt.person_id = person;
    attempt.exercise = "peg-transfer";
    attempt.source = "box trainer";
    attempt.performed = noon - 3600 * 1000;
    attempt.utc_offset_min = 60;
    attempt.duration_s = 0.5;
    attempt.trace = box_trace;
    attempt.files = {{external_trace_file, "aa"}, {external_mapping_file, "bb"}};
    attempt.program_version = "0.1.0";
    attempt.score.program_version = "0.1.0";
    attempt.score.not_scored_because = StatementId::recorded_elsewhere;
    attempt.score.metrics.push_back({"path_len", 1, "left", "", 100.0, {}, "mm", Direction::lower, {}});
    return attempt;
}

}  // namespace fulcrum::database::test
