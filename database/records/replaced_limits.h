// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts that were cut off, and failed when they were scored after their benchmark set had been replaced:
// they count by the set that was in force when they began. Internal to this room.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "database/rows/attempt_records.h"
#include "database/rows/connection.h"

namespace fulcrum::database {

class ReplacedLimits {
  public:
    explicit ReplacedLimits(Connection& connection) : connection_(connection) {}
    /// Says whether such an attempt failed by a provisional set, a firm one, or one of which this store does
    /// not know it: that is as without one.
    void decide(AttemptSummary& attempt);

  private:
    std::optional<bool> is_provisional(const AssetFile& set, const std::string& name);
    Connection& connection_;
    std::map<std::pair<std::string, std::string>, std::optional<bool>> known_;  ///< by digest and name
};

}  // namespace fulcrum::database
