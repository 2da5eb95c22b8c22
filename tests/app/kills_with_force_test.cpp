// SPDX-License-Identifier: GPL-3.0-or-later
// Kills and stops the window, the overseer and the device process while a haptic device presses on a sphere
// in an assessed attempt: the force at its motors is 0 within 50 ms, and nothing is lost. The device is a
// fake of libHD whose motors are memory that this test maps: it outlives all of them. FULCRUM_FORCE_KILLS
// sets the number of rounds (300 for the long run); FULCRUM_FORCE_KILLS_PAGE is the folder for its page.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <limits>
#include <random>
#include <set>
#include <thread>

#include "app/live/interrupted.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "sim_core/lab/result_page.h"
#include "tests/app/counters.h"
#include "tests/app/daemon_processes.h"
#include "tests/app/program_path.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_touch.h"
#include "tests/support/built.h"

namespace fulcrum::app::program_test {
namespace {

using fulcrum::test::Variable;
constexpr std::int64_t ms_in_ns = 1'000'000, force_kill_limit = 50 * ms_in_ns;
constexpr double pressing_n = 0.05;
constexpr int force_kill_patience_ms = 120000;
/// After it, a broken limit that the screen shows has to be in the store.
constexpr std::int64_t at_once_ns = 50 * ms_in_ns;
// Before a signal; long enough to break a limit, and in the ordinary run.
constexpr unsigned long_press_ms = 2500, short_press_ms = 300;
enum Victim { the_device_process, the_overseer, the_window, victims };
constexpr const char* victim_names[victims] = {"device process", "overseer", "window"};

template <typename Condition>
bool wait_until_so(Condition condition, int milliseconds = force_kill_patience_ms) {
    const std::int64_t last = monotonic_ns() + milliseconds * ms_in_ns;
    while (!condition()) {
        if (monotonic_ns() > last) return false;
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    return true;
}

std::string in_ms(std::int64_t ns) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", static_cast<double>(ns) / 1e6);
    return text;
}

/// By the record: a tip pressed clearly harder than A2 allows (4 N), and not for a tick alone.
bool breaks_the_limit(const database::Trace& trace) {
    constexpr double clearly = 4.5;  // N
    constexpr int ticks = 20;
    int above = 0;
    for (const TickSample& sample : trace.samples) {
        double most = 0;
        for (const HandSample& hand : sample.hand) {
            const Vector3 force(hand.force[0], hand.force[1], hand.force[2]);
            most = std::max(most, sample_force_unit * force.norm());
        }
        above += most > clearly ? 1 : 0;
    }
    return above >= ticks;
}

/// Before the child is started, which inherits these.
struct PressingDevice {
    static std::string daemon() {
        const std::string program = program_path();
        return program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd";
    }
    fulcrum::test::FakePage<fulcrum::test::FakeTouchPage> page{"FAKE_TOUCH_PAGE"};
    Variable library{"FULCRUM_LIBHD", fulcrum::test::fake_library("libHD.so")};
    Variable device{"FULCRUM_DEVICE", "touch:Left Device,Right Device"};
    Variable program{"FULCRUM_HAPTICD", daemon()};
};

class KillsWithForce : public PressingDevice, public ::testing::Test {
  protected:
    KillsWithForce();
    ~KillsWithForce() override;
    void start_window(int number);
    /// N, what the library got last.
    double force() const;
    bool presses() const { return counters->ticks.load() > 0 && force() > pressing_n; }
    bool find_daemon();
    /// ns from `begin` until the motors of both hands got 0; the largest number if they did not.
    std::int64_t until_zero(Victim victim, std::int64_t begin) const;
    void round(Victim victim, int signal, int number);
    void after_window(int signal, int number, std::int64_t begin);
    void after_daemon(Victim victim, int signal, int number, std::uint32_t paused, std::uint32_t finished);
    void end_window();
    /// What the next start finds.
    void look_at_store();
    bool passes_its_check() const;
    void write_force_page(const char* folder) const;

    QTemporaryDir folder;
    const std::string folder_path = folder.path().toStdString(), store_path = folder_path + "/fulcrum.db",
                      counters_path = folder_path + "/counters";
    Counters* counters;
    const bool long_run = std::getenv("FULCRUM_FORCE_KILLS") != nullptr;
    const unsigned longest_press_ms = long_run ? long_press_ms : short_press_ms;
    std::mt19937_64 random{20261126};
    std::optional<database::Session> trainee;
    std::set<std::string> earlier;
    pid_t window = 0, overseer = 0, device_process = 0;
    SharedPage<StatePage> state;

    std::vector<std::int64_t> took[victims][2];  ///< ns, by victim and signal
    std::uint32_t begun_before = 0, finished_before = 0;
    std::size_t begun = 0, missing = 0, scored = 0, finished = 0, finished_lost = 0, interrupted = 0;
    std::size_t paused = 0, resumed = 0, broken = 0, broken_kept = 0, shown_broken = 0, shown_kept = 0;
    std::vector<std::uint32_t> lost_ticks;
};

KillsWithForce::KillsWithForce() : counters(map_counters(counters_path.c_str())) {
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    database::Store::create(store_path, false);
    const database::Store store = database::Store::open(store_path);
    const database::People people(store);
    const auto programme = people.create_programme("Department", "alma", "Alma Admin", "correct horse");
    const auto created =
        people.create(programme.administrator, trainee_login, "Tara Trainee", {database::Role::trainee});
    trainee.emplace(people.change_password(people.sign_in(trainee_login, created.one_time_password),
                                           created.one_time_password, trainee_password));
}

KillsWithForce::~KillsWithForce() {
    end_window();
    prctl(PR_SET_CHILD_SUBREAPER, 0);
}

double KillsWithForce::force() const {
    double most = 0;
    for (const auto& one : page->device)
        for (const auto& f : one.force) most = std::max(most, std::abs(f.load()));
    return most;
}

void KillsWithForce::start_window(int number) {
    counters->ticks.store(0);
    begun_before = counters->begun.load();
    finished_before = counters->finished.load();
    window = ::fork();
    ASSERT_GE(window, 0);
    if (window != 0) return;
    ::execl("/proc/self/exe", "test_app_kills", "--press-until-killed", folder_path.c_str(),
            counters_path.c_str(), std::to_string(number).c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
}

bool KillsWithForce::find_daemon() {
    overseer = daemon_child_of(window);
    device_process = overseer != 0 ? daemon_child_of(overseer) : 0;
    if (device_process == 0) return false;
    state = state_page_of(overseer);
    return static_cast<bool>(state);
}

std::int64_t KillsWithForce::until_zero(Victim victim, std::int64_t begin) const {
    constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
    constexpr std::int64_t stays = 25 * ms_in_ns;  // a tip that just let go of a sphere presses again
    std::int64_t zero_since = 0;
    while (monotonic_ns() < begin + 1000 * ms_in_ns) {
        if (victim == the_device_process) {
            // The system closes the device of a process that ended, and its motors with it: the overseer
            // reports when it has.
            std::int64_t latest = 0;
            bool zero = true;
            for (const auto& shared : state->report) {
                ForceReport report;
                zero = zero && shared.read(report) && report.time >= begin;
                for (const double f : report.force) zero = zero && f == 0;
                latest = std::max(latest, report.time);
            }
            if (zero) return latest - begin;
        } else if (force() != 0) {
            zero_since = 0;
        } else if (zero_since == 0) {
            zero_since = monotonic_ns();
        } else if (monotonic_ns() - zero_since > stays) {
            std::int64_t latest = 0;
            for (const auto& one : page->device) latest = std::max(latest, one.zero_time.load());
            return std::max<std::int64_t>(latest - begin, 0);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    return never;
}

/// Ends what a round left, and waits until nothing of it runs.
void KillsWithForce::end_window() {
    for (const pid_t one : {window, overseer, device_process}) {
        if (one > 0 && ::kill(one, SIGCONT) == 0 && one == window) ::kill(one, SIGKILL);
    }
    if (window == 0) return;
    // This process is the reaper of all of them.
    const std::int64_t last = monotonic_ns() + 10000 * ms_in_ns;
    while (monotonic_ns() < last) {
        const pid_t reaped = ::waitpid(-1, nullptr, WNOHANG);
        if (reaped < 0) {
            window = overseer = device_process = 0;
            return;
        }
        if (reaped == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ADD_FAILURE() << "a process of the daemon did not end";
}

void KillsWithForce::round(Victim victim, int signal, int number) {
    if (window == 0) start_window(number);
    int status = 0;
    const auto ended = [&] { return ::waitpid(window, &status, WNOHANG) == window; };
    ASSERT_TRUE(wait_until_so([&] { return presses() || ended(); }) && presses()) << "round " << number;
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % longest_press_ms));
    // It also travels, and begins another attempt: at a moment at which it presses.
    ASSERT_TRUE(wait_until_so([&] { return (presses() && find_daemon() && presses()) || ended(); }) &&
                presses())
        << "round " << number;
    const std::uint32_t paused_then = counters->paused.load(), finished_then = counters->finished.load();
    const pid_t target = victim == the_window ? window : victim == the_overseer ? overseer : device_process;
    const std::int64_t begin = monotonic_ns();
    ASSERT_EQ(::kill(target, signal), 0) << "round " << number;
    const std::int64_t lasted = until_zero(victim, begin);
    EXPECT_LE(lasted, force_kill_limit)
        << strsignal(signal) << " of the " << victim_names[victim] << ", round " << number;
    took[victim][signal == SIGSTOP ? 1 : 0].push_back(lasted);
    if (victim == the_window)
        after_window(signal, number, begin);
    else
        after_daemon(victim, signal, number, paused_then, finished_then);
}

void KillsWithForce::after_window(int signal, int number, std::int64_t begin) {
    if (signal == SIGSTOP && number % 4 < 2) {  // it continues, as after a suspended session
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        EXPECT_EQ(force(), 0) << "while the window is stopped";
        ASSERT_EQ(::kill(window, SIGCONT), 0);
        EXPECT_TRUE(wait_until_so([&] { return presses(); })) << "round " << number;
        ++resumed;
        return;
    }
    const std::int64_t broken_at = counters->broken.load();
    ::kill(window, SIGKILL);
    end_window();
    const std::size_t before = interrupted;
    look_at_store();
    EXPECT_TRUE(!long_run || passes_its_check()) << "round " << number;
    if (interrupted == before) return;
    const database::Store store = database::Store::open(store_path);
    const database::Attempts attempts(store);
    const auto newest = attempts.list(*trainee).front();
    if (broken_at > 0 && begin - broken_at > at_once_ns) {
        ++shown_broken;
        shown_kept += newest.passed == false ? 1 : 0;
        EXPECT_EQ(newest.passed, false) << "the screen showed a broken limit " << in_ms(begin - broken_at)
                                        << " ms before the signal, round " << number;
    }
    if (!breaks_the_limit(attempts.read_trace(*trainee, newest.meta.id))) return;
    ++broken;
    EXPECT_EQ(newest.passed, false) << "a broken limit stays broken, round " << number;
    EXPECT_TRUE(newest.counting) << "round " << number;
    EXPECT_EQ(newest.meta.mode, AttemptMode::assessed);
    broken_kept += newest.passed == false && newest.counting ? 1 : 0;
}

void KillsWithForce::after_daemon(Victim victim, int signal, int number, std::uint32_t paused_then,
                                  std::uint32_t finished_then) {
    // The window notices, pauses, and the trainee abandons: the score is acknowledged.
    EXPECT_TRUE(wait_until_so([&] { return counters->finished.load() > finished_then; }))
        << "round " << number;
    EXPECT_EQ(counters->paused.load(), paused_then + 1) << "round " << number;
    ++paused;
    if (victim == the_overseer && signal == SIGSTOP && number % 4 < 2) ::kill(overseer, SIGCONT);
}

void KillsWithForce::look_at_store() {
    const std::size_t acknowledged = counters->finished.load() - finished_before;
    const std::size_t have_begun = counters->begun.load() - begun_before;
    const database::Store store = database::Store::open(store_path);
    const database::Attempts attempts(store);
    const std::size_t open = attempts.interrupted_without_score(*trainee).size();
    EXPECT_LE(open, 1U);
    std::size_t seen = 0, with_score = 0;
    database::AttemptFilter all;
    all.limit = -1;
    for (const database::AttemptSummary& attempt : attempts.list(*trainee, all)) {
        if (!earlier.insert(attempt.meta.id).second) continue;
        ++seen;
        EXPECT_NE(attempt.state, AttemptState::running);
        EXPECT_NE(attempt.passed, true) << "each was abandoned or cut off";
        ASSERT_TRUE(attempt.meta.force_devices[0].has_value()) << "made with force";
        if (attempt.state != AttemptState::interrupted) {
            EXPECT_TRUE(attempts.score(*trainee, attempt.meta.id).has_value());
            ++with_score;
            continue;
        }
        const database::Trace trace = attempts.read_trace(*trainee, attempt.meta.id);
        for (std::size_t k = 0; k < trace.samples.size(); ++k) ASSERT_EQ(trace.samples[k].tick, k + 1);
        lost_ticks.push_back(counters->ticks.load() - static_cast<std::uint32_t>(trace.samples.size()));
    }
    EXPECT_GE(with_score, acknowledged) << "an acknowledged score is lost";
    EXPECT_GE(seen, have_begun);
    EXPECT_EQ(score_interrupted(store_path, *trainee).size(), open);
    EXPECT_TRUE(attempts.interrupted_without_score(*trainee).empty());
    begun += have_begun;
    missing += have_begun > seen ? have_begun - seen : 0;
    scored += with_score;
    finished += acknowledged;
    finished_lost += acknowledged > with_score ? acknowledged - with_score : 0;
    interrupted += open;
}

bool KillsWithForce::passes_its_check() const {
    const database::Store store = database::Store::open(store_path);
    const database::CheckReport report = store.check(store.station_session());
    for (const database::CheckItem& item : report.items)
        for (const Sentence& problem : item.problems) ADD_FAILURE() << item.name << ": " << problem.words();
    EXPECT_TRUE(report.ok);
    return report.ok;
}

void KillsWithForce::write_force_page(const char* to) const {
    lab::ResultTable times;
    times.name = "time_to_zero";
    times.columns = {"victim", "signal", "rounds", "ms until the force was 0: median", "p99", "largest"};
    std::size_t rounds = 0;
    for (int victim = 0; victim < victims; ++victim)
        for (int stop = 0; stop < 2; ++stop) {
            std::vector<std::int64_t> all = took[victim][stop];
            if (all.empty()) continue;
            std::sort(all.begin(), all.end());
            rounds += all.size();
            const auto share = [&all](double part) {
                return in_ms(all[static_cast<std::size_t>(part * static_cast<double>(all.size() - 1) + 0.5)]);
            };
            times.rows.push_back({victim_names[victim], stop == 1 ? "SIGSTOP" : "SIGKILL",
                                  std::to_string(all.size()), share(0.5), share(0.99), share(1)});
        }
    std::vector<std::uint32_t> ticks = lost_ticks;
    std::sort(ticks.begin(), ticks.end());
    lab::ResultTable lost;
    lost.name = "lost";
    lost.columns = {"what", "value"};
    const auto add = [&lost](const char* what, std::size_t value) {
        lost.rows.push_back({what, std::to_string(value)});
    };
    add("attempts begun", begun);
    add("of these missing at the next start", missing);
    add("attempts whose debrief was shown before a kill of the window", finished);
    add("of these scores lost", finished_lost);
    add("attempts cut off with the window, found as interrupted and scored from their record", interrupted);
    add("of these with a broken limit in their record", broken);
    add("of these failed at the next start", broken_kept);
    add("attempts whose screen showed a broken limit at least 50 ms before the signal", shown_broken);
    add("of these failed at the next start", shown_kept);
    add("attempts that paused when a process of the daemon died or stopped", paused);
    add("windows that were stopped, continued, and pressed again with force", resumed);
    add("ticks of trace lost where the window was killed: median",
        ticks.empty() ? 0 : ticks[ticks.size() / 2]);
    add("ticks of trace lost where the window was killed: largest", ticks.empty() ? 0 : ticks.back());
    lab::ResultPage result(
        "kills_with_force",
        "Killed and stopped " + std::to_string(rounds) + " times while a haptic device pressed",
        "FULCRUM_FORCE_KILLS=" + std::to_string(rounds) + " FULCRUM_FORCE_KILLS_PAGE=" + to +
            " test_app --gtest_filter=KillsWithForce.*");
    result.paragraph(
        "The window of the program runs under Xvfb with its threads and its store, and drives a 3D Systems "
        "Touch through fulcrum-hapticd; the maker's library is a fake whose motors are memory that the test "
        "maps. A trainee signs in and presses on the spheres of A2 in one assessed attempt after another, in "
        "every other one far too hard. At a random moment at which the motors have a force, the window, the "
        "overseer or the device process gets SIGKILL or SIGSTOP. The time counts from the signal to the "
        "first "
        "servo tick with 0 at both hands; where the device process itself is the victim, to the overseer's "
        "report that the system has closed its device. At the end the whole store is checked.");
    result.table(times);
    result.table(lost);
    result.write(to, lab::this_machine(lab::build_info()));
}

TEST_F(KillsWithForce, ForceIsZeroWithin50MillisecondsAndNothingIsLost) {
    ASSERT_NE(counters, nullptr);
    const char* const asked = std::getenv("FULCRUM_FORCE_KILLS");
    const int rounds = asked != nullptr ? std::max(1, std::atoi(asked)) : 3;
    for (int i = 0; i < rounds && !HasFatalFailure(); ++i) {
        const auto victim = static_cast<Victim>(i % victims);
        // 3 rounds: the device process is killed, the overseer stopped, the window killed.
        const bool stop = (i / victims + victim) % 2 == 1;
        round(victim, stop ? SIGSTOP : SIGKILL, i);
        if (long_run && i % 10 == 9) std::cout << i + 1 << " rounds" << std::endl;
    }
    if (window != 0) {
        end_window();
        look_at_store();
    }
    const bool sound = passes_its_check();
    EXPECT_EQ(missing, 0U);
    EXPECT_EQ(finished_lost, 0U);
    EXPECT_EQ(broken, broken_kept);
    // A machine that starves the recorder's thread for seconds loses those.
    for (const std::uint32_t ticks : lost_ticks) EXPECT_LE(ticks, 5000U);
    for (int victim = 0; victim < victims; ++victim)
        for (const auto& one : took[victim])
            if (!one.empty())
                std::cout << victim_names[victim] << ": " << one.size() << " times, force 0 after at most "
                          << in_ms(*std::max_element(one.begin(), one.end())) << " ms\n";
    std::cout << begun << " attempts, " << finished << " finished, " << interrupted << " cut off, " << broken
              << " of them with a broken limit, " << shown_kept << " of " << shown_broken
              << " failed whose screen showed one\n";
    if (const char* to = std::getenv("FULCRUM_FORCE_KILLS_PAGE"); to != nullptr && sound)
        write_force_page(to);
}

}  // namespace
}  // namespace fulcrum::app::program_test
