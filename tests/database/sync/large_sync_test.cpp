// SPDX-License-Identifier: GPL-3.0-or-later
// Many attempts: FULCRUM_SYNC_ATTEMPTS at a station (default 40; 5,000 is the measured size), and how long it
// takes.
#include <chrono>
#include <cstdio>

#include "database/sync/enrolment.h"
#include "database/sync/server_enrolment.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class SyncLarge : public Sync {
  protected:
    template <typename Act>
    SyncResult timed(const char* what, Act&& act) const {
        const auto start = std::chrono::steady_clock::now();
        const SyncResult result = act();
        const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        std::printf("%s: %lld units, %lld audit rows, %.2f s\n", what,
                    static_cast<long long>(result.transferred()), static_cast<long long>(result.audit_rows),
                    took);
        return result;
    }
};

TEST_F(SyncLarge, TwoStationsEndWithTheSame) {
    const int attempts = std::max(1, qEnvironmentVariableIntValue("FULCRUM_SYNC_ATTEMPTS") == 0
                                         ? 40
                                         : qEnvironmentVariableIntValue("FULCRUM_SYNC_ATTEMPTS"));
    Station b;
    sync(a);
    sync(b);
    for (int i = 0; i < attempts; ++i) {
        a.record(i % 2 == 0 ? "ann" : "ben", i % 3 != 0, i % 100);
    }
    const Session ann = b.sign_in("ann");
    for (int i = 0; i < attempts; ++i) {
        Recorder recorder(b.path, ann, example_meta(ann.person_id()), b.clock.options());
        Programme::append_second(recorder);
        recorder.finish(example_result(true, i % 100));
    }
    timed("a sends", [&] { return sync(a); });
    timed("b sends and receives", [&] { return sync(b); });
    timed("a receives", [&] { return sync(a); });
    EXPECT_EQ(timed("a again", [&] { return sync(a); }).transferred(), 0);
    EXPECT_EQ(rows_at(*a.store), rows_at(*b.store));
    EXPECT_EQ(rows_at(*a.store), rows_on(server, false));
    Query count(a.store->connection(), "SELECT COUNT(*) FROM attempt");
    EXPECT_TRUE(count.next() && count.integer(0) == 2 * attempts);
    expect_the_same_standings(b);
    // A station of one cohort, whose rows the server chooses.
    const KeysOfOneTest keys;
    const Station c;
    enrol_station(*c.store, c.store->station_session(), server,
                  make_enrolment_token(server, "", {"Year 1"}, 1).text);
    const auto receive = [&] {
        return sync_with_server(
            *c.store, c.store->has_administrator() ? c.sign_in("administrator") : c.store->station_session(),
            server_of(*c.store));
    };
    timed("c, of one cohort, receives", receive);
    EXPECT_EQ(timed("c again", receive).transferred(), 0);
    Query received(c.store->connection(), "SELECT COUNT(*) FROM attempt");
    EXPECT_TRUE(received.next() && received.integer(0) == 2 * attempts);
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);
}

}  // namespace
}  // namespace fulcrum::database::test
