// SPDX-License-Identifier: GPL-3.0-or-later
// One run of the exchange. Internal to this room.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "database/sync/sync.h"
#include "database/sync/units.h"

namespace fulcrum::database {

/// Thrown where SyncOptions::stop said so.
struct SyncStopped {};

/// With the station's password where the address is that of its enrolment, else with what libpq finds.
std::unique_ptr<Connection> connection_to(const Store& store, const ServerAddress& address);

class Exchange {
  public:
    Exchange(const Store& store, Connection& server, const SyncOptions& options);
    void run();
    SyncResult result;

  private:
    using Keys = std::vector<std::string>;
    enum class Way { up, down };

    void require_one_programme();
    void require_known_log();
    void look_at_clock();
    /// Of a station that was enrolled: that the account is this one's, and where it gets some cohorts only,
    /// what else it has and the server is to go on showing it.
    void use_enrolment();
    /// What the server shows now was given to this station, also when it shows it no more.
    void note_given(const std::string& held, const std::string& held_whole);
    void apply_erasures();
    /// Enters the first exchange of the store in its log, before anything is sent.
    void begin();
    void exchange_until_settled(const Units& units);
    /// Returns how many units were left because another one has their login or name there and gives it up in
    /// this exchange. With `last` that is a conflict.
    std::size_t exchange_versioned(const Units& units, bool last);
    /// Once, however often it is found.
    void add_conflict(Sentence one);
    void add_missing(const Units& units, Way way);
    void push(const Units& units, const Keys& keys);
    void pull(const Units& units, const Keys& keys);
    /// A reassignment at one station and a rater who opened the original at another one, in either order: the
    /// next exchange sends that the rater has seen the copy too.
    void note_copies_seen(const Units& units, const std::vector<Unit>& read);
    void push_audit();
    bool is_changed_here(const std::string& key);
    /// Logins or names of units that are only here, which others have whom the server does not show.
    std::set<std::string> names_of_hidden(const Units& units, const std::map<std::string, UnitState>& here,
                                          const std::map<std::string, UnitState>& there);
    /// Leaves out the units that name others which the other side lacks.
    std::vector<Unit> transferable(const Units& units, std::vector<Unit> read, Way way);
    const std::set<std::string>& known(const std::string& table, Way way);
    void finish();
    void progress(const std::string& title, Way way, std::size_t done, std::size_t all);
    SyncCount& count(const Units& units);

    const Store& store_;
    Connection& station_;
    Connection& server_;
    const SyncOptions& options_;
    std::string server_id_;
    bool is_limited_ = false;  ///< the server shows some cohorts only
    std::set<std::string>
        refused_;  ///< people and cohorts here that the server has, but not for this station
    std::map<std::string, std::set<std::string>> known_[2];  ///< by table: keys that the receiving side has
    std::map<std::pair<std::string, Way>, std::int64_t> waiting_;  ///< by title
    std::set<std::string> conflicts_said_;
    std::size_t step_ = 0, steps_ = 1;
};

}  // namespace fulcrum::database
