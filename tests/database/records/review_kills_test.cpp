// SPDX-License-Identifier: GPL-3.0-or-later
// A program in which an educator reviews is killed at random moments: every deed whose call had returned is
// in the store, as it was done, and db check passes. FULCRUM_KILLS sets the number of kills (600 for the long
// run); FULCRUM_KILLS_PAGE is the folder for its page.
#include <QFile>
#include <chrono>
#include <cstdio>
#include <random>
#include <thread>

#include "database/rows/connection.h"
#include "sim_core/lab/result_page.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/deeds_journal.h"
#include "tests/database/processes.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/kill_pages.h"

namespace fulcrum::database::test {
namespace {

struct ReviewToll {
    int kills = 0, in_the_middle = 0;
    std::size_t acknowledged = 0, lost = 0;
    std::map<DeedKind, std::size_t> by_kind;
};

/// What the store has to hold of one object, by its newest acknowledged deeds.
struct Acknowledged {
    std::map<DeedKind, Deed> newest;
    bool has(DeedKind kind) const { return newest.count(kind) != 0; }
};

class ReviewKills : public ::testing::Test {
  protected:
    /// The text's last word.
    static std::uint32_t number_of(const std::string& text) {
        return static_cast<std::uint32_t>(std::strtoul(text.c_str() + text.rfind(' ') + 1, nullptr, 10));
    }
    static std::int64_t count(const Store& store, const char* sql, const std::string& id) {
        Query row(store.connection(), sql);
        row.bind(id);
        return row.next() ? row.integer(0) : -1;
    }
    static bool has_comment(const Store& store, const std::string& id, const Acknowledged& expected) {
        Query row(store.connection(), "SELECT text, sent, read, time_s FROM comment WHERE id = ?");
        row.bind(id);
        if (!row.next()) return expected.has(DeedKind::deletion_begun);
        if (expected.has(DeedKind::draft_deleted)) return false;
        if (expected.has(DeedKind::comment_read) && row.integer(2) == 0) return false;
        if (const auto mark = expected.newest.find(DeedKind::mark); mark != expected.newest.end())
            return row.integer(1) > 0 && number_of(row.text(0)) == mark->second.number &&
                   row.real(3) == 0.01 * (mark->second.number % 90);
        if (expected.has(DeedKind::draft_sent) && row.integer(1) == 0) return false;
        // A later edit may have been made whose call had not returned.
        return number_of(row.text(0)) >= expected.newest.at(DeedKind::draft).number;
    }
    static bool has_rating(const Store& store, const std::string& id, const Acknowledged& expected) {
        Query row(store.connection(),
                  "SELECT handed_in, remark, (SELECT COUNT(*) FROM rating_item i WHERE i.rating_id = r.id), "
                  "(SELECT COUNT(*) FROM rating_release l WHERE l.rating_id = r.id) FROM rating r WHERE id = "
                  "?");
        row.bind(id);
        if (!row.next()) return expected.has(DeedKind::discard_begun);
        if (expected.has(DeedKind::rating_discarded)) return false;
        if (expected.has(DeedKind::rating_handed_in) && row.integer(0) == 0) return false;
        if (expected.has(DeedKind::rating_released) && row.integer(3) != 1) return false;
        const auto answered = expected.newest.find(DeedKind::rating_answered);
        if (answered == expected.newest.end()) return true;
        return row.integer(2) > 0 && number_of(row.text(1)) >= answered->second.number;
    }
    /// Whether the store holds what was acknowledged of an object.
    static bool holds(const Store& store, const std::string& id, const Acknowledged& expected) {
        const auto number = [&](DeedKind kind) { return expected.newest.at(kind).number; };
        if (expected.has(DeedKind::mark) || expected.has(DeedKind::draft))
            return has_comment(store, id, expected);
        if (expected.has(DeedKind::rating_begun)) return has_rating(store, id, expected);
        const auto has_text = [&](const char* sql, DeedKind kind) {
            Query rows(store.connection(), sql);
            rows.bind(id);
            while (rows.next())
                if (number_of(rows.text(0)) == number(kind)) return true;
            return false;
        };
        bool good = true;
        if (expected.has(DeedKind::attempt_voided))
            good = has_text("SELECT reason FROM attempt_void WHERE attempt_id = ?", DeedKind::attempt_voided);
        if (expected.has(DeedKind::correction_asked))
            good = good && has_text("SELECT text FROM correction_request WHERE attempt_id = ?",
                                    DeedKind::correction_asked);
        if (expected.has(DeedKind::decided))
            good = has_text("SELECT reason FROM standing_override WHERE id = ?", DeedKind::decided);
        if (expected.has(DeedKind::error_reviewed))
            good = has_text("SELECT reason FROM error_review WHERE id = ?", DeedKind::error_reviewed);
        if (expected.has(DeedKind::score_added))
            good = count(store, "SELECT COUNT(*) FROM score WHERE id = ?", id) == 1;
        if (const auto moved = expected.newest.find(DeedKind::attempt_moved); moved != expected.newest.end())
            good = count(store, "SELECT COUNT(*) FROM attempt_reassignment WHERE to_id = ?", id) == 1 &&
                   count(store, "SELECT COUNT(*) FROM attempt_void WHERE attempt_id = ?",
                         moved->second.other) == 1 &&
                   count(store, "SELECT COUNT(*) FROM trace_chunk WHERE attempt_id = ?", id) > 0;
        return good;
    }
    /// All that was acknowledged to the child that was killed, and the whole store.
    void look(const DeedsJournal& journal, const Programme& programme) {
        const Store store = Store::open(programme.path, programme.clock.options());
        std::map<std::string, Acknowledged> objects;
        for (const Deed& deed : journal.deeds()) {
            objects[deed.object].newest[deed.kind] = deed;
            if (deed.kind == DeedKind::deletion_begun || deed.kind == DeedKind::discard_begun) continue;
            ++toll.by_kind[deed.kind];
            ++toll.acknowledged;
        }
        for (const auto& [id, expected] : objects) {
            if (holds(store, id, expected)) continue;
            ++toll.lost;
            ADD_FAILURE() << "kill " << toll.kills << ": " << id << " is not as it was acknowledged (deed "
                          << static_cast<int>(expected.newest.rbegin()->first) << ")";
        }
        for (const CheckItem& item : store.check(store.station_session()).items)
            EXPECT_TRUE(item.ok) << "kill " << toll.kills << ": " << item.name << ": "
                                 << item.problems.front().words();
    }
    /// A store with attempts of two trainees, in which `kills` children review one after the other.
    void review_and_kill(int kills) {
        const TemporaryFoldersInMemory in_memory;
        Programme programme;
        for (int i = 0; i < 8 + 2 * kills; ++i)
            programme.record(i % 2 == 0 ? "ann" : "ben", i % 3 != 0, 60 + i, "A2", {Programme::slip()});
        programme.store.reset();
        const std::string folder = programme.folder.path().toStdString();
        DeedsJournal& journal = DeedsJournal::in(folder);
        for (int kill = 0; kill < kills && !HasFailure(); ++kill) {
            journal.clear();
            const pid_t child = start_child("review", folder, ++children);
            // After so many deeds, which do not depend on how busy the machine is.
            ASSERT_TRUE(wait_for_deeds(journal, child, static_cast<std::uint32_t>(random() % 60)))
                << "the child ended by itself";
            std::this_thread::sleep_for(std::chrono::microseconds(random() % 10'000));
            ASSERT_TRUE(kill_child(child)) << "the child ended by itself";
            ++toll.kills;
            toll.in_the_middle += journal.begun > journal.acknowledged ? 1 : 0;
            look(journal, programme);
        }
    }
    std::mt19937_64 random{20261126};
    int children = 0;
    ReviewToll toll;
};

void write_review_page(const std::string& folder, const ReviewToll& toll) {
    const auto deeds = [&](std::initializer_list<DeedKind> kinds) {
        std::size_t sum = 0;
        for (const DeedKind kind : kinds)
            if (const auto found = toll.by_kind.find(kind); found != toll.by_kind.end()) sum += found->second;
        return std::to_string(sum);
    };
    lab::ResultTable table;
    table.name = "kills_reviewing";
    table.columns = {"what", "value"};
    table.rows = {
        {"kills", std::to_string(toll.kills)},
        {"of these in the middle of an action", std::to_string(toll.in_the_middle)},
        {"actions that were acknowledged", std::to_string(toll.acknowledged)},
        {"comments at a moment, sent at once", deeds({DeedKind::mark})},
        {"comments read by the trainee", deeds({DeedKind::comment_read})},
        {"drafts of comments: written, edited", deeds({DeedKind::draft})},
        {"drafts of comments: sent, deleted", deeds({DeedKind::draft_sent, DeedKind::draft_deleted})},
        {"observer forms: begun, answered, discarded",
         deeds({DeedKind::rating_begun, DeedKind::rating_answered, DeedKind::rating_discarded})},
        {"observer forms: handed in, released",
         deeds({DeedKind::rating_handed_in, DeedKind::rating_released})},
        {"attempts voided or moved to another person",
         deeds({DeedKind::attempt_voided, DeedKind::attempt_moved})},
        {"scores put next to the one in force", deeds({DeedKind::score_added})},
        {"decisions on a standing", deeds({DeedKind::decided})},
        {"errors confirmed or struck", deeds({DeedKind::error_reviewed})},
        {"corrections that a trainee asked for", deeds({DeedKind::correction_asked})},
        {"objects that were not as acknowledged", std::to_string(toll.lost)},
    };
    lab::ResultPage page("kills_reviewing",
                         "Killed " + std::to_string(toll.kills) + " times while an educator reviews",
                         "FULCRUM_KILLS=" + std::to_string(toll.kills) + " FULCRUM_KILLS_PAGE=" + folder +
                             " test_database --gtest_filter=ReviewKills.*");
    page.paragraph(
        "A program opens a store, signs an educator and a trainee in, and makes one action of a review after "
        "the other, in random order, by the calls that the pages make. It enters each action into memory "
        "that "
        "outlives it as soon as the call has returned: from then on the action is *acknowledged*. A `kill "
        "-9` "
        "ends the program up to 10 ms after a random one of its first 60 actions. After every kill each "
        "acknowledged action is looked "
        "for, with its text, number and state, and the whole store is checked: pages, references, audit "
        "chain, signatures, checksums and digests. Of a draft or an open form that was being changed, what "
        "was acknowledged last, or the change that was under way, has to be there. Every 20 kills a new "
        "store "
        "with 48 attempts begins. This page is written only where every check passed.");
    page.table(table);
    page.write(folder, lab::this_machine(lab::build_info()));
}

TEST_F(ReviewKills, LoseNothingThatWasAcknowledged) {
    constexpr int of_one_store = 20;
    for (int left = kills_asked(5); left > 0 && !HasFailure(); left -= of_one_store)
        review_and_kill(std::min(left, of_one_store));
    EXPECT_GT(toll.acknowledged, static_cast<std::size_t>(toll.kills));
    std::printf(
        "%d kills while reviewing, %d in the middle of a deed: %zu deeds acknowledged, %zu objects "
        "not as acknowledged\n",
        toll.kills, toll.in_the_middle, toll.acknowledged, toll.lost);
    if (const char* page = fulcrum::test::kill_pages()) write_review_page(page, toll);
    fulcrum::test::enter_kills({fulcrum::test::Killed::reviewing, static_cast<std::size_t>(toll.kills),
                                "actions that were acknowledged", toll.acknowledged, toll.lost},
                               lab::this_machine(lab::build_info()));
}

}  // namespace
}  // namespace fulcrum::database::test
