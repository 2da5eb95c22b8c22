// SPDX-License-Identifier: GPL-3.0-or-later
// Reports of a cohort that are written to a folder every day or week. They belong to this station (settings
// are not exchanged); whoever writes them signs in as a director (`fulcrum schedule run`, from cron or a
// timer).
#pragma once

#include <string>
#include <vector>

#include "database/store/store.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum::database {

enum class ScheduleEvery { day, week };
const char* every_name(ScheduleEvery every);

struct ReportSchedule {
    std::string id, cohort_id;
    std::string cohort_name;  ///< read only; empty where the cohort is gone
    std::string format;       ///< "pdf", "csv", "xlsx", "json"
    std::string folder;       ///< absolute
    ScheduleEvery every = ScheduleEvery::week;
    std::string last_period;  ///< read only: the newest one that was written, "2026-W48"; empty: none
    Sentence problem;         ///< read only: why the last try failed; empty: it did not
};

/// "2026-11-26", "2026-W48" (ISO 8601), in UTC: the part of a file's name, and what is written once.
std::string period_of(ScheduleEvery every, UtcMilliseconds time);

/// Held by whoever writes what is due, so that two at once write each report once. Another program, or
/// another part of this one, does not wait for it. A program that is killed has released it.
class ScheduleLock {
  public:
    /// Throws StoreError read_only, disk_full where the file next to the store cannot be made.
    explicit ScheduleLock(const Store& store);
    ~ScheduleLock();
    ScheduleLock(const ScheduleLock&) = delete;
    ScheduleLock& operator=(const ScheduleLock&) = delete;
    bool held() const noexcept { return held_; }

  private:
    int descriptor_ = -1;
    bool held_ = false;
};

class Schedules {
  public:
    explicit Schedules(const Store& store) : store_(store) {}
    /// Operation::export_cohort of that cohort. Throws bad_value for a folder that is not absolute, conflict
    /// where the same is scheduled. Returns the id.
    std::string add(const Session& director, const ReportSchedule& schedule) const;
    std::vector<ReportSchedule> list(const Session& director) const;
    void remove(const Session& director, const std::string& id) const;
    /// The report of this period was written, or (`problem`) was not. Audited. Nothing where the schedule was
    /// removed while its report was written.
    void note(const Session& director, const std::string& id, const std::string& period,
              const Sentence& problem) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
