// SPDX-License-Identifier: GPL-3.0-or-later
// What a site says that blades meet in a task's tissues: versions, each with who, when and why; the newest is
// in force for attempts that begin afterwards. What the values mean and may be is the scene's business
// (sim_core/scene/cutting_values.h); who may set them is checked here.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "database/store/store.h"

namespace fulcrum::database {

/// By tissue label, then by name.
using TissueValues = std::map<std::string, std::map<std::string, double>>;

struct TissueSetting {
    int version = 0;      ///< 0: never set
    TissueValues values;  ///< empty: the scene file's own
    std::string author_name, reason;
    UtcMilliseconds time = 0;
};

class Tissues {
  public:
    explicit Tissues(const Store& store) : store_(store) {}
    /// Version 0 where nobody has set any. Operation::read_tissues.
    TissueSetting in_force(const Session& session, const std::string& task_id) const;
    /// Newest first. Operation::read_tissues.
    std::vector<TissueSetting> history(const Session& session, const std::string& task_id) const;
    /// Adds a version, audited with what was before. `seen`: the version that the author looked at; throws
    /// StoreError conflict where a newer one is in force, bad_value without a reason, with a value that is no
    /// number, or where nothing would change. Operation::set_tissues. Returns the new version.
    int set(const Session& educator, const std::string& task_id, int seen, const TissueValues& values,
            const std::string& reason) const;

  private:
    std::vector<TissueSetting> read(const std::string& task_id, int limit) const;
    const Store& store_;
};

}  // namespace fulcrum::database
