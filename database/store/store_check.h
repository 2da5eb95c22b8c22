// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of `db check`, each reading one side of the store to its end. Internal to this floor.
#pragma once

#include <string>
#include <vector>

#include "database/rows/connection.h"
#include "database/store/store.h"

namespace fulcrum::database {

/// Reports progress and asks whether to continue, between rows and within one long statement.
class CheckWatch {
  public:
    CheckWatch(Connection& connection, const StoreProgress& progress);
    ~CheckWatch();
    CheckWatch(const CheckWatch&) = delete;
    CheckWatch& operator=(const CheckWatch&) = delete;
    void begin(double from, double to, const char* what);
    /// False: stop.
    bool at(double share);
    bool stopped() const { return stopped_; }

  private:
    static int ask(void* watch);
    bool report();
    Connection& connection_;
    const StoreProgress& progress_;
    double from_ = 0, to_ = 0, done_ = 0;
    std::string what_;
    bool stopped_ = false;
};

/// The schema is what the steps of this program make of an empty file: a trigger that was removed, or one
/// that was added, would let later changes pass.
void check_definitions(const Store& store, std::vector<Sentence>& problems);
/// Every chunk: checksum, decoded to its last bit, numbers and ticks in order, the lengths that the attempt
/// gives. Decodes on all cores.
void check_traces(const Store& store, CheckItem& item, CheckWatch& watch);
/// Every record against the newest digest that the audit log has of it.
void check_records(const Store& store, CheckItem& item, CheckWatch& watch);

}  // namespace fulcrum::database
