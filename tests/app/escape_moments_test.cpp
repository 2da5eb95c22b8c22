// SPDX-License-Identifier: GPL-3.0-or-later
// A kill, the end of the window, an unplugged device and a fault of the simulator, each at every moment of an
// assessed attempt: none takes a broken limit back, and without one the store says what the rules say. The
// attempts of one test run at the same time, each with a store of its own.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/live/interrupted.h"
#include "assessment/task/attempt_words.h"
#include "tests/app/counters.h"
#include "tests/app/escape_attempt.h"

namespace fulcrum::app::program_test {
namespace {

enum class Deed { kill, close, unplug, fault };

/// `device_back`: its device is back, and it waits; `resumed`: it runs again.
enum class Moment { ready, running, paused, device_lost, device_back, resumed, finishing };
struct MomentRow {
    Moment moment;
    const char* name;
};
// The finishing one is the last: it does not wait for the others.
constexpr MomentRow moment_rows[] = {{Moment::ready, "ready"},
                                     {Moment::running, "running"},
                                     {Moment::paused, "paused"},
                                     {Moment::device_lost, "device_lost"},
                                     {Moment::device_back, "device_back"},
                                     {Moment::resumed, "resumed"},
                                     {Moment::finishing, "finishing"}};

/// An attempt and the moment that it is brought to, in a folder of its own.
class Staged {
  public:
    Staged(const std::string& folder, const MomentRow& row, bool breaks)
        : moment(row.moment),
          name(row.name),
          store_path(folder + "/" + row.name + "/fulcrum.db"),
          breaks_(breaks) {
        std::filesystem::create_directories(folder + "/" + row.name);
        database::Store::create(store_path, false);
        attempt = std::make_unique<EscapingAttempt>(store_path, breaks, false, moment != Moment::ready);
    }
    /// Before its moment: a limit was shown as broken, or nothing but a movement was seen.
    bool prepares() {
        if (moment == Moment::ready) return attempt->reaches(ui::AttemptPhase::ready);
        return breaks_ ? comes_true([&] { return attempt->hands->broke.load(); }) : attempt->moves();
    }
    bool reaches_its_moment() {
        switch (moment) {
            case Moment::ready:
            case Moment::running:
                return true;
            case Moment::paused:
                return attempt->pauses();
            case Moment::device_lost:
                return attempt->loses_the_device();
            case Moment::device_back:
                return attempt->loses_the_device() && attempt->device_comes_back();
            case Moment::resumed:
                return attempt->loses_the_device() && attempt->device_comes_back() && attempt->resumes() &&
                       (breaks_ || becomes_practice());
            case Moment::finishing:
                attempt->live->abandon();
                return comes_true([&] { return attempt->live->phase() >= ui::AttemptPhase::finishing; });
        }
        return false;
    }

    void close();
    void unplug();
    void fail();

    const Moment moment;
    const std::string name, store_path;
    std::unique_ptr<EscapingAttempt> attempt;

  private:
    bool becomes_practice() {
        return comes_true([&] { return attempt->live->became_practice(); });
    }
    bool is_lost() const { return moment == Moment::device_lost || moment == Moment::device_back; }
    const bool breaks_;
};

/// What the end of the window does to an attempt (TheatrePage).
void Staged::close() {
    if (moment != Moment::ready) attempt->live->abandon();
    attempt->live.reset();
}

/// The device goes, comes back, and the trainee resumes and then abandons.
void Staged::unplug() {
    EscapingAttempt& at = *attempt;
    if (moment == Moment::finishing) {
        at.hands->unplugged = true;
    } else if (moment == Moment::ready) {
        at.hands->resting = at.hands->unplugged = true;
        at.live->start();
        ASSERT_TRUE(at.reaches(ui::AttemptPhase::device_lost));
    } else if (is_lost()) {
        ASSERT_TRUE(moment == Moment::device_back || at.device_comes_back());
        ASSERT_TRUE(at.loses_it_again());
    } else {
        ASSERT_TRUE(at.loses_the_device());
    }
    if (moment != Moment::finishing) {
        ASSERT_TRUE(at.device_comes_back());
        ASSERT_TRUE(at.resumes());
        ASSERT_TRUE(breaks_ || becomes_practice());
        EXPECT_EQ(at.live->assessed(), breaks_);
    }
    at.abandon_and_wait();
}

/// The simulator fails at the next step that advances: none does in a pause, or without a device.
void Staged::fail() {
    EscapingAttempt& at = *attempt;
    *at.fails = true;
    if (moment == Moment::ready) at.live->start();
    if (moment == Moment::paused || is_lost()) {
        ASSERT_TRUE(at.ticks_pass(50));
        ASSERT_LT(at.live->phase(), ui::AttemptPhase::finishing) << "nothing is simulated yet";
        ASSERT_TRUE(moment != Moment::device_lost || at.device_comes_back());
        at.asks_to_resume();
    }
    at.live->wait();
    at.live->rethrow();
}

/// One for each moment; a limit cannot be broken before the start.
class AllMoments {
  public:
    AllMoments(const std::string& folder, bool breaks) {
        for (const MomentRow& row : moment_rows)
            if (!breaks || row.moment != Moment::ready)
                staged.push_back(std::make_unique<Staged>(folder, row, breaks));
    }
    /// Empty: all are where they should be; else the first that is not.
    std::string missing() {
        for (const auto& one : staged)
            if (!one->prepares()) return "before " + one->name;
        // Until the press of the last has been recorded.
        if (!staged.back()->attempt->ticks_pass(400)) return "a tick";
        for (const auto& one : staged)
            if (!one->reaches_its_moment()) return one->name;
        return {};
    }
    std::vector<std::unique_ptr<Staged>> staged;
};

enum class Kept {
    nothing,
    failed,      ///< and counts
    not_scored,  ///< it was cut off, and does not count
    practice,    ///< it resumed after a loss
    either       ///< failed or not scored: the end was being stored
};

Kept kept_by_the_rules(Deed deed, Moment moment, bool broken) {
    if (broken) return Kept::failed;
    if (deed == Deed::unplug) return moment == Moment::finishing ? Kept::failed : Kept::practice;
    if (deed == Deed::fault) {
        if (moment == Moment::finishing) return Kept::failed;
        const bool was_lost =
            moment == Moment::device_lost || moment == Moment::device_back || moment == Moment::resumed;
        return was_lost ? Kept::practice : Kept::not_scored;
    }
    if (moment == Moment::ready) return Kept::nothing;
    if (moment == Moment::resumed) return Kept::practice;
    if (deed == Deed::close) return Kept::failed;
    return moment == Moment::finishing ? Kept::either : Kept::not_scored;
}

bool ends_as(AttemptState state, Deed deed, Moment moment) {
    if (state == AttemptState::abandoned)
        return deed == Deed::close || deed == Deed::unplug || moment == Moment::finishing;
    return (deed == Deed::kill && state == AttemptState::interrupted) ||
           (deed == Deed::fault && state == AttemptState::failed_simulation);
}

void expect_kept(const std::string& store_path, Deed deed, Moment moment, bool broken) {
    const Kept kept = kept_by_the_rules(deed, moment, broken);
    if (kept == Kept::nothing) {
        EXPECT_TRUE(stored_attempts(store_path).empty());
        return;
    }
    const database::AttemptSummary attempt = only_attempt(store_path);
    EXPECT_TRUE(ends_as(attempt.state, deed, moment)) << row_of(attempt_states, attempt.state).name;
    if (kept == Kept::failed || (kept == Kept::either && attempt.passed)) {
        expect_failed(attempt);
        return;
    }
    EXPECT_FALSE(attempt.counting);
    EXPECT_NE(attempt.passed, true);
    EXPECT_EQ(attempt.meta.mode, kept == Kept::practice ? AttemptMode::practice : AttemptMode::assessed);
    if (kept == Kept::not_scored) {
        EXPECT_FALSE(attempt.passed) << "nothing was broken";
    }
}

class EscapeBy : public ::testing::TestWithParam<Deed> {
  protected:
    /// Every attempt at its moment, and what is done to it then; `broken`: each has broken a limit.
    void escape(bool broken) {
        if (GetParam() == Deed::kill) {
            ASSERT_NO_FATAL_FAILURE(reach_and_kill(broken));
        } else {
            ASSERT_NO_FATAL_FAILURE(reach_and_do(broken));
        }
        for (const MomentRow& row : moment_rows) {
            if (broken && row.moment == Moment::ready) continue;
            SCOPED_TRACE(row.name);
            expect_kept(path + "/" + row.name + "/fulcrum.db", GetParam(), row.moment, broken);
        }
    }

  private:
    void reach_and_do(bool broken) {
        AllMoments all(path, broken);
        ASSERT_EQ(all.missing(), "");
        // The one that finishes is not waited for by the others.
        std::reverse(all.staged.begin(), all.staged.end());
        for (const auto& one : all.staged) {
            SCOPED_TRACE(one->name);
            ASSERT_NO_FATAL_FAILURE(act_on(*one));
        }
    }
    void act_on(Staged& one) {
        if (GetParam() == Deed::close) return one.close();
        if (GetParam() == Deed::unplug) return one.unplug();
        one.fail();
    }
    /// A child has the attempts; after the kill the program starts again on each store.
    void reach_and_kill(bool broken) {
        const std::string counters_path = path + "/counters";
        Counters* counters = map_counters(counters_path.c_str());
        ASSERT_NE(counters, nullptr);
        const pid_t child = ::fork();
        if (child == 0) {
            ::execl("/proc/self/exe", "test_app", "--reach-moments", path.c_str(), counters_path.c_str(),
                    broken ? "broken" : "whole", static_cast<char*>(nullptr));
            ::_exit(127);
        }
        ASSERT_GT(child, 0);
        int status = 0;
        pid_t ended = 0;
        const bool reached = comes_true([&] {
            if (ended == 0) ended = ::waitpid(child, &status, WNOHANG);
            return counters->finished.load() > 0 || ended != 0;
        });
        ASSERT_EQ(ended, 0) << "the child did not get there: " << status;
        ASSERT_EQ(::kill(child, SIGKILL), 0);
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(reached);
        for (const MomentRow& row : moment_rows) {
            if (broken && row.moment == Moment::ready) continue;
            const std::string store_path = path + "/" + row.name + "/fulcrum.db";
            const database::Store store = database::Store::open(store_path);
            score_interrupted(store_path, store.station_session());
        }
    }

    QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
};

TEST_P(EscapeBy, NoMomentTakesABrokenLimitBack) {
    escape(true);
}
TEST_P(EscapeBy, WithoutABrokenLimitTheStoreSaysWhatTheRulesSay) {
    escape(false);
}

std::string deed_name(const ::testing::TestParamInfo<Deed>& deed) {
    switch (deed.param) {
        case Deed::kill:
            return "Kill";
        case Deed::close:
            return "Close";
        case Deed::unplug:
            return "Unplug";
        case Deed::fault:
            return "SimulatorFault";
    }
    return "";
}
INSTANTIATE_TEST_SUITE_P(Deeds, EscapeBy,
                         ::testing::Values(Deed::kill, Deed::close, Deed::unplug, Deed::fault), deed_name);

}  // namespace

int reach_moments_until_killed(const char* folder, const char* counters_path, bool breaks) {
    Counters* counters = map_counters(counters_path);
    if (counters == nullptr) return 1;
    AllMoments all(folder, breaks);
    const std::string missing = all.missing();
    if (!missing.empty()) {
        std::fprintf(stderr, "an attempt did not get there: %s\n", missing.c_str());
        std::_Exit(2);
    }
    counters->finished.store(1);
    for (;;) ::pause();
}

}  // namespace fulcrum::app::program_test
