// SPDX-License-Identifier: GPL-3.0-or-later
// Errors that an educator confirms or strikes: only those that were recorded, with a reason, never edited,
// the newest counts, the score stays, an erasure takes them, stations exchange them.
#include "database/records/error_reviews.h"

#include "database/sync/station_erasure.h"
#include "database/sync/trace_fetch.h"
#include "sim_core/telemetry/event_types.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class ReviewedErrors : public ::testing::Test {
  protected:
    ReviewedErrors() { attempt = programme.record("ann", true, 70, "A2", {drop, Programme::slip()}); }
    std::string add(const std::string& login, const Event& event, const std::string& reason,
                    ErrorVerdict verdict = ErrorVerdict::struck) const {
        return ErrorReviews(*programme.store).add(programme.session(login), attempt, event, verdict, reason);
    }
    std::vector<ErrorReview> in_force(const std::string& login) const {
        return ErrorReviews(*programme.store).in_force(programme.session(login), attempt);
    }
    std::int64_t rows() const {
        Query row(programme.store->connection(), "SELECT COUNT(*) FROM error_review");
        return row.next() ? row.integer(0) : -1;
    }
    static inline const Event drop{998, EventKind::drop, 0, -1, 3, 0.0F};
    Programme programme;
    std::string attempt;
};

TEST_F(ReviewedErrors, OnlyWhatTheRecordHoldsAsAnErrorIsReviewed) {
    const auto refused = [&](const Event& event, const std::string& reason) {
        return error_kind([&] { add("educator", event, reason); });
    };
    // Each of what names an event, changed.
    Event other[] = {Programme::slip(), Programme::slip(), Programme::slip(), Programme::slip(),
                     Programme::slip()};
    other[0].tick = 998;
    other[1].kind = EventKind::drop;
    other[2].hand = 0;
    other[3].tissue = 1;
    other[4].detail = 8;
    for (const Event& event : other) EXPECT_EQ(refused(event, "seen"), StoreErrorKind::bad_value);
    const Event grasp{250, EventKind::grasp, 1, 2, 7, 0.5F};  // recorded, and no error
    EXPECT_EQ(refused(grasp, "seen"), StoreErrorKind::bad_value);
    for (const std::string& reason :
         {std::string(), std::string(" \t\n"), std::string(1001, 'x'), std::string(5000, 'x')})
        EXPECT_EQ(refused(Programme::slip(), reason), StoreErrorKind::bad_value);
    EXPECT_EQ(rows(), 0);
    std::string longest;
    for (int i = 0; i < 1000; ++i) longest += "\xc3\xbc";  // of characters, not bytes
    add("educator", Programme::slip(), longest);
    EXPECT_EQ(in_force("educator").at(0).reason, longest);

    for (const char* login : {"ann", "ben", "director", "administrator", "other_educator"})
        EXPECT_THROW(add(login, Programme::slip(), "seen"), AccessDenied) << login;
    EXPECT_EQ(error_kind([&] {
                  ErrorReviews(*programme.store)
                      .add(programme.session("educator"), "no-such-attempt", Programme::slip(),
                           ErrorVerdict::struck, "seen");
              }),
              StoreErrorKind::not_found);
    for (const char* login : {"ann", "educator", "director"}) EXPECT_EQ(in_force(login).size(), 1U) << login;
    for (const char* login : {"ben", "administrator", "other_educator"})
        EXPECT_THROW(in_force(login), AccessDenied) << login;
}

TEST_F(ReviewedErrors, AreNotOfAnAttemptThatStillRuns) {
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    Programme::append_second(recorder);
    recorder.append(Programme::slip());
    recorder.flush();
    EXPECT_EQ(error_kind([&] {
                  ErrorReviews(*programme.store)
                      .add(programme.session("educator"), recorder.attempt_id(), Programme::slip(),
                           ErrorVerdict::struck, "seen");
              }),
              StoreErrorKind::conflict);
}

TEST_F(ReviewedErrors, TheNewestCountsAndTheScoreStays) {
    const auto before = programme.attempts().score(programme.session("ann"), attempt);
    add("educator", Programme::slip(), "the tissue was torn before");
    programme.clock.set_forward_s(-3600);  // somebody sets the clock back
    add("educator", Programme::slip(), "I have looked again", ErrorVerdict::confirmed);
    add("educator", Programme::slip(), "no, it was torn");
    add("educator", drop, "seen", ErrorVerdict::confirmed);
    const std::vector<ErrorReview> newest = in_force("ann");
    ASSERT_EQ(newest.size(), 2U);
    EXPECT_TRUE(newest[0].is_of(drop)) << "by their moment";
    EXPECT_EQ(newest[0].verdict, ErrorVerdict::confirmed);
    EXPECT_TRUE(newest[1].is_of(Programme::slip()));
    EXPECT_EQ(newest[1].verdict, ErrorVerdict::struck);
    EXPECT_EQ(newest[1].reason, "no, it was torn");
    EXPECT_EQ(newest[1].author_name, "Edu Cator");
    EXPECT_EQ(ErrorReviews(*programme.store).history(programme.session("ann"), attempt).size(), 4U);
    for (const char* sql : {"UPDATE error_review SET reason = 'x'", "DELETE FROM error_review"})
        EXPECT_ANY_THROW(programme.store->connection().execute(sql)) << sql;
    EXPECT_EQ(rows(), 4);

    const auto after = programme.attempts().score(programme.session("ann"), attempt);
    ASSERT_TRUE(before && after);
    EXPECT_EQ(after->id, before->id);
    EXPECT_EQ(after->points, before->points);
    EXPECT_EQ(after->passed, before->passed);
    // A void does not take back what was said of its errors, nor forbid to say it.
    programme.attempts().void_attempt(programme.session("educator"), attempt, "the camera was off");
    add("educator", drop, "the ring was wet");
    EXPECT_EQ(in_force("ann").at(0).verdict, ErrorVerdict::struck);
    expect_sound(*programme.store);
    // The administrator reads that it was done, of whose attempt, and not what was said.
    AuditFilter filter;
    filter.kind = "error";
    const auto entries = Audit(*programme.store).entries(programme.session("administrator"), filter);
    ASSERT_EQ(entries.size(), 5U);
    for (const AuditEntry& entry : entries) {
        EXPECT_EQ(entry.operation, "error.review");
        EXPECT_EQ(entry.payload.find("torn"), std::string::npos) << entry.payload;
    }
}

TEST_F(ReviewedErrors, GoWithTheTraineeOrTheAuthorWhoIsErased) {
    add("educator", Programme::slip(), "the tissue was torn before");
    const std::string kept = programme.record("ben", true, 60, "A2", {Programme::slip()});
    ErrorReviews(*programme.store)
        .add(programme.session("educator"), kept, Programme::slip(), ErrorVerdict::confirmed, "seen");
    erase_person(*programme.store, programme.session("director"), programme.id("ann"), "asked", false);
    EXPECT_EQ(rows(), 1) << "Ben's stays";
    expect_sound(*programme.store);
    EXPECT_ANY_THROW(programme.store->connection().execute("DELETE FROM error_review"))
        << "its guard is back";
    erase_person(*programme.store, programme.session("director"), programme.id("educator"), "asked", false);
    EXPECT_EQ(rows(), 0) << "as the comments of an erased author";
    expect_sound(*programme.store);
}

TEST(RecordedErrors, AreOfWhoeverPerformsAndNeverOfTheDevice) {
    int errors = 0, critical = 0;
    for (const auto& row : event_kinds) {
        errors += is_error(row.kind) ? 1 : 0;
        critical += row.weight == EventWeight::critical ? 1 : 0;
    }
    EXPECT_EQ(errors, 12);
    EXPECT_EQ(critical, 3);
    for (const EventKind kind : {EventKind::device_lost, EventKind::device_fault, EventKind::simulator_fault,
                                 EventKind::over_force_end, EventKind::grasp, EventKind::samples_lost})
        EXPECT_FALSE(is_error(kind)) << event_name(kind);
}

using SyncReviewedErrors = Sync;

TEST_F(SyncReviewedErrors, OfTwoStationsTheNewestCountsOnBothAndAnErasureTakesThem) {
    const std::string attempt = a.record("ann", true, 70, "A2", {Programme::slip()});
    sync(a);
    const Station b;
    sync(b);
    ErrorReviews(*a.store).add(a.session("educator"), attempt, Programme::slip(), ErrorVerdict::struck,
                               "the tissue was torn before");
    b.clock.pass_s(60);
    const Session educator = b.sign_in("educator");
    // Its record is where it was recorded; there it is reviewed, or where it was fetched to.
    EXPECT_EQ(error_kind([&] {
                  ErrorReviews(*b.store).add(educator, attempt, Programme::slip(), ErrorVerdict::confirmed,
                                             "seen");
              }),
              StoreErrorKind::not_found);
    ASSERT_TRUE(fetch_trace(*b.store, educator, server, attempt, {}).complete);
    ErrorReviews(*b.store).add(educator, attempt, Programme::slip(), ErrorVerdict::confirmed, "seen");
    for (int round = 0; round < 2; ++round) {
        sync(a);
        sync(b);
    }
    sync(a);
    for (const Store* store : {a.store.get(), b.store.get()}) {
        const Session who = store == a.store.get() ? a.session("ann") : b.sign_in("ann");
        EXPECT_EQ(ErrorReviews(*store).history(who, attempt).size(), 2U);
        const auto newest = ErrorReviews(*store).in_force(who, attempt);
        ASSERT_EQ(newest.size(), 1U);
        EXPECT_EQ(newest[0].verdict, ErrorVerdict::confirmed);
        EXPECT_EQ(newest[0].author_name, "Edu Cator");
        expect_sound(*store);
    }
    expect_sound(server);
    erase_at_programme_server(server, a.id("ann"), false);
    sync(a);
    sync(b);
    for (const Store* store : {a.store.get(), b.store.get()}) {
        Query row(store->connection(), "SELECT COUNT(*) FROM error_review");
        ASSERT_TRUE(row.next());
        EXPECT_EQ(row.integer(0), 0);
    }
    expect_sound(server);
}

}  // namespace
}  // namespace fulcrum::database::test
