// SPDX-License-Identifier: GPL-3.0-or-later
// Real-time operation while the window draws and both hands grasp and drag the bowel: by mouse, and by a
// haptic device (a fake of libHD) behind fulcrum-hapticd. Eight seconds by default; FULCRUM_SOAK_S=600 runs
// ten minutes, and each of the two once more while operators keep all cores busy. FULCRUM_SOAK_PAGE=
// docs/results writes the pages of all four (soak_page.h).
#include <QProcess>

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <thread>

#include "app/live/live_attempt.h"
#include "assessment/task/attempt_words.h"
#include "assessment/task/bowel_line.h"
#include "tests/app/host_witness.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/posed_hand.h"
#include "tests/app/soak_page.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_touch.h"
#include "tests/support/built.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

/// Grasps the bowel at one place after another, drags it and releases it, without end.
class DraggingMind : public ObservingRig {
  public:
    explicit DraggingMind(const Scene& scene) : radius_(scene.bowel->outer_radius) {
        for (const InstrumentSpec& spec : scene.instruments) {
            const auto h = static_cast<std::size_t>(spec.hand);
            trocar_[h] = make_trocar(spec.trocar);
            jaw_length_ = spec.jaw_length;
            opening_ = spec.jaw_opening;
            point_[h] = trocar_[h].position + trocar_[h].rotation.col(2) * spec.start_insertion;
        }
    }
    void observe(const WorldSnapshot& world, const TaskDisplay&) noexcept override {
        const LinePoint place = line_point(world, places[place_]);
        Trocar& trocar = trocar_[hand_];
        const Vector3 axis = (place.position - trocar.position).normalized();
        Vector3 side = axis.cross(place.tangent);
        if (side.norm() < 0.2) side = Vector3::UnitZ() - axis.z() * axis;
        side.normalize();
        if (side.z() < 0) side = -side;
        const Vector3 middle = place.position + (radius_ + 0.001) * (0.95 * side - 0.3 * axis).normalized();
        const Vector3 wall = middle + 0.5 * jaw_length_ * (middle - trocar.position).normalized();
        if (stage_ < 2) goal_ = stage_ == 0 ? Vector3(wall - 0.03 * axis) : wall;
        grasp_ = world.grasps[hand_].held;
    }
    void read(std::uint32_t, RigSample& sample) override {
        constexpr std::uint32_t lengths[] = {1600, 900, 700, 4200, 600, 600};  // ticks
        if (++in_stage_ >= lengths[stage_]) next_stage();
        if (stage_ == 3) {
            const double turn = 2 * 3.14159265358979 * in_stage_ / 2100.0;
            goal_ = taken_ + Vector3(0.012 * std::sin(turn), 0, 0.010 * (1 - std::cos(turn)));
        }
        const Vector3 way = goal_ - point_[hand_];
        const double speed = stage_ == 3 ? 0.06e-3 : 0.12e-3;
        point_[hand_] += way.norm() > speed ? Vector3(way * (speed / way.norm())) : way;
        for (std::size_t h = 0; h < hand_count; ++h) {
            DeviceReading reading;
            reading.handle = handle_for_tip(trocar_[h], point_[h]);
            const bool closed = h == hand_ && (stage_ == 2 || stage_ == 3);
            reading.jaw = closed ? 0 : 0.6 * opening_;
            sample.hand[h] = quantise(reading, sample.hand[h]);
        }
    }
    void write_force(Hand, const Vector3&) override {}
    bool has_force(Hand) const override { return false; }
    double damping(Hand) const override { return -1; }

  private:
    void next_stage() {
        in_stage_ = 0;
        stage_ = (stage_ + 1) % 6;
        if (stage_ == 3) taken_ = point_[hand_];
        if (stage_ == 5)
            goal_ = point_[hand_] + 0.03 * (trocar_[hand_].position - point_[hand_]).normalized();
        if (stage_ != 0) return;
        hand_ = 1 - hand_;
        place_ = (place_ + 1) % 4;
    }
    static constexpr double places[] = {0.26, 0.52, 0.34, 0.60};  // m along the bowel, left and right in turn
    Trocar trocar_[hand_count];
    double radius_, jaw_length_ = 0.02, opening_ = 1;
    Vector3 point_[hand_count] = {Vector3::Zero(), Vector3::Zero()}, goal_ = Vector3::Zero(),
            taken_ = Vector3::Zero();
    std::size_t hand_ = 0, place_ = 0, stage_ = 0;
    std::uint32_t in_stage_ = 0;
    bool grasp_ = false;
};

/// Only reads the clock a thousand times a second: processor time that this thread does not get, the program
/// does not get either.
class ClockWitness {
  public:
    ClockWitness() : thread_([this] { watch(); }) {}
    ~ClockWitness() {
        stop_.store(true);
        thread_.join();
    }
    /// s, total of gaps so long that the program moves its deadline.
    double withheld() const { return 1e-9 * static_cast<double>(withheld_ns_.load()); }

  private:
    void watch() {
        using namespace std::chrono;
        constexpr auto period = milliseconds(1), longest = milliseconds(20);
        auto deadline = steady_clock::now() + period;
        while (!stop_.load()) {
            std::this_thread::sleep_until(deadline);
            const auto late = steady_clock::now() - deadline;
            if (late >= longest) {
                withheld_ns_ += duration_cast<nanoseconds>(late).count();
                deadline += late;
            }
            deadline += period;
        }
    }
    std::atomic<bool> stop_{false};
    std::atomic<std::int64_t> withheld_ns_{0};
    std::thread thread_;
};

/// Resident memory of this process, bytes.
double resident_bytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * 4096.0;
}

std::string number(double value, const char* format = "%.0f") {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string list(std::initializer_list<double> values, const char* format = "%.0f") {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ", ") + number(value, format);
    return text;
}

/// In a group of processes of its own, which a signal reaches as a whole.
class ProcessGroup : public QProcess {
  protected:
    void setupChildProcess() override { setpgid(0, 0); }
};

/// `fulcrum lab operators C4`, which uses all cores, again and again while it exists. A shell begins it
/// again, and the shell is begun before the attempt: a fork shares this process's memory, and the ticks after
/// it would copy some 600 pages.
class BusyOperators {
  public:
    BusyOperators() {
        process_.start(QStringLiteral("/bin/sh"),
                       {QStringLiteral("-c"),
                        QStringLiteral(R"(while "$0" lab operators C4 --seeds 60 --output "$1"; do :; done)"),
                        QString::fromStdString(fulcrum::test::built_program("fulcrum-lab")), folder_.path()});
        EXPECT_TRUE(process_.waitForStarted());
    }
    ~BusyOperators() {
        EXPECT_EQ(process_.state(), QProcess::Running) << process_.readAllStandardError().toStdString();
        const auto group = static_cast<pid_t>(process_.processId());
        if (group > 0) ::kill(-group, SIGKILL);
        process_.waitForFinished();
    }

  private:
    QTemporaryDir folder_;
    ProcessGroup process_;
};

/// What differs between two devices of the hands.
struct SoakKind {
    bool through_daemon = false;
    bool loaded = false;  ///< operators use all cores
    /// Moves the hands until it is done.
    std::function<bool(ObservingRig&, const std::function<bool()>&, int milliseconds)> work;
    std::function<int()> events;
};

/// What was seen while the attempt ran.
struct Seen {
    LoopStatistics statistics;
    std::vector<double> frames;  // ms
    int held_pictures = 0;
    double grown = 0, of_replay = 0, withheld = 0;  // bytes, bytes, s
    double taken = 0;                               // s of all processors, by the host
    std::uint64_t missed_then = 0;                  // by the program, while the host took as much time
};

class Soak : public Window {
  protected:
    void run(const SoakKind& kind);

  private:
    void watch(const SoakKind& kind, Seen& seen);
    lab::ResultTable table_of(const SoakKind& kind, const Seen& seen, const database::AttemptSummary& attempt,
                              const database::Trace& trace, int grasps) const;
    void write_pages(const SoakKind& kind, const lab::ResultTable& table) const;
    const int seconds_ =
        std::getenv("FULCRUM_SOAK_S") != nullptr ? std::atoi(std::getenv("FULCRUM_SOAK_S")) : 8;
};

void Soak::watch(const SoakKind& kind, Seen& seen) {
    TheatreView* view = theatre().view();
    const auto* live = dynamic_cast<const LiveAttempt*>(theatre().session());
    ASSERT_NE(live, nullptr);
    DraggingMind mind(live->scene());
    const ClockWitness witness;
    const HostWitness host;
    struct Missed {
        HostWitness::Clock::time_point from, to;
        std::uint64_t ticks;
    };
    std::vector<Missed> missed;
    auto looked = HostWitness::Clock::now();
    QElapsedTimer clock;
    clock.start();
    double settled = 0, resident = 0, of_replay = 0;
    int pictures = view->pictures();
    kind.work(
        mind,
        [&] {
            const std::uint64_t before = seen.statistics.missed_by_program;
            seen.statistics = live->statistics();  // while the threads run: the counters are atomic
            const auto now = HostWitness::Clock::now();
            if (seen.statistics.missed_by_program != before)
                missed.push_back({looked, now, seen.statistics.missed_by_program - before});
            looked = now;
            if (view->pictures() != pictures) {
                pictures = view->pictures();
                seen.frames.push_back(view->last_frame_ms());
                for (const GraspState& grasp : theatre().session()->snapshot().grasps)
                    seen.held_pictures += grasp.held ? 1 : 0;
            }
            of_replay = static_cast<double>(seen.statistics.replay_bytes);
            resident = resident_bytes() - of_replay;
            if (settled == 0 && clock.elapsed() > seconds_ * 250LL) settled = resident;
            return clock.elapsed() >= seconds_ * 1000LL;
        },
        seconds_ * 1000 + 60000);
    seen.grown = resident - settled;
    seen.of_replay = of_replay;
    seen.withheld = witness.withheld();
    seen.taken = host.taken();
    // A tick is 1 ms, and the host's time is known to 10 ms.
    for (const Missed& one : missed) {
        const double taken = host.taken(one.from, one.to);
        if (taken > 0 && taken + 0.01 >= 1e-3 * static_cast<double>(one.ticks)) seen.missed_then += one.ticks;
    }
    std::sort(seen.frames.begin(), seen.frames.end());
}

lab::ResultTable Soak::table_of(const SoakKind& kind, const Seen& seen,
                                const database::AttemptSummary& attempt, const database::Trace& trace,
                                int grasps) const {
    const auto frame = [&](double share) {
        return seen.frames.empty() ? 0.0
                                   : seen.frames[static_cast<std::size_t>(
                                         share * static_cast<double>(seen.frames.size() - 1))];
    };
    const auto durations = [](const Durations& d) {
        return list({d.p50_us, d.p99_us, d.p999_us, d.worst_us});
    };
    const LoopStatistics& statistics = seen.statistics;
    lab::ResultTable table;
    table.columns = {"what", "value"};
    table.rows = {
        {"ticks", number(static_cast<double>(statistics.ticks))},
        {soak_missed, number(static_cast<double>(statistics.missed_by_program))},
        {soak_missed_then, number(static_cast<double>(seen.missed_then))},
        {"missed by the scheduler", number(static_cast<double>(statistics.missed_by_scheduler))},
        {"waking late, us: p50, p99, p99.9, worst", durations(statistics.wake)},
        {"tick, us: p50, p99, p99.9, worst", durations(statistics.tick)},
        {"world step, us: p50, p99, p99.9, worst", durations(statistics.step)},
    };
    if (const auto& device = statistics.device) {
        table.rows.insert(
            table.rows.end(),
            {{"ticks of the device process", number(static_cast<double>(device->device_ticks))},
             {"of them a period late by its own doing", number(static_cast<double>(device->device_late_own))},
             {"of them a period late by the scheduler",
              number(static_cast<double>(device->device_late - device->device_late_own))},
             {"pose, from the device to the program's tick, us: p50, p99, p99.9, worst",
              durations(device->pose_age)},
             {"force, from the program to the motors, us: p50, p99, p99.9, worst",
              durations(device->force_delay)},
             {"time between two readings, less the period, us: p50, p99, p99.9, worst",
              durations(device->jitter)},
             {"real-time priority granted to the device process",
              device->real_time_priority ? "yes" : "no"}});
    }
    table.rows.insert(
        table.rows.end(),
        {{"processor time withheld from a thread that only reads the clock, s",
          number(seen.withheld, "%.2f")},
         {"time that the host took from all processors (steal time), s", number(seen.taken, "%.2f")},
         {"late world steps", number(static_cast<double>(statistics.late_steps))},
         {"samples lost", number(static_cast<double>(attempt.lost_samples))},
         {"ticks in the record", number(static_cast<double>(trace.samples.size()))},
         {"waits and page faults within ticks", list({static_cast<double>(statistics.waits_in_ticks),
                                                      static_cast<double>(statistics.page_faults_in_ticks)})},
         {"processor time of a tick, us: p50, p99, p99.9, worst", durations(statistics.own)},
         {"memory of the replay's key frames at the end, MiB", number(seen.of_replay / 1048576.0, "%.1f")},
         {"other memory grown after the first quarter, MiB", number(seen.grown / 1048576.0, "%.1f")},
         {"pictures", number(static_cast<double>(seen.frames.size()))},
         {"picture, ms: p50, p99, worst", list({frame(0.5), frame(0.99), frame(1.0)}, "%.1f")},
         {"grasps of bowel", number(grasps)},
         {"pictures with bowel held", number(seen.held_pictures)},
         {"inputs", number(kind.events())},
         {"real-time priority granted", statistics.real_time_priority ? "yes" : "no"},
         {"how it ended", row_of(attempt_states, attempt.state).name}});
    return table;
}

void Soak::run(const SoakKind& kind) {
    create_programme_and_trainee();
    std::optional<BusyOperators> busy;
    if (kind.loaded) busy.emplace();  // its fork is before the first tick
    start("B1", false);
    Seen seen;
    ASSERT_NO_FATAL_FAILURE(watch(kind, seen));
    busy.reset();
    if (theatre().session() != nullptr && theatre().session()->phase() == AttemptPhase::running) {
        abandon();
    } else {
        wait_for_debrief();  // after ten minutes, B1's time limit, the attempt has ended by itself
    }
    const database::AttemptSummary attempt = newest_attempt();
    const database::Trace trace =
        database::Attempts(*services.store()).read_trace(window.context().session(), attempt.meta.id);
    int grasps = 0;
    for (const Event& event : trace.events) grasps += event.kind == EventKind::grasp ? 1 : 0;
    const lab::ResultTable table = table_of(kind, seen, attempt, trace, grasps);
    for (const auto& row : table.rows) std::printf("%s: %s\n", row[0].c_str(), row[1].c_str());
    write_pages(kind, table);
    EXPECT_EQ(attempt.lost_samples, 0U);
    // A shared machine withholds its processors for up to a quarter of the periods and sometimes stops
    // completely. Required here: the attempt continues, and the record misses no tick.
    ASSERT_GT(static_cast<double>(trace.samples.size()), 500.0 * (seconds_ - seen.withheld));
    for (std::size_t i = 0; i < trace.samples.size(); ++i) ASSERT_EQ(trace.samples[i].tick, i + 1);
    EXPECT_LT(seen.grown, 64.0 * 1048576.0);
    EXPECT_GE(grasps, seconds_ / 30);
    EXPECT_EQ(seen.statistics.device.has_value(), std::getenv("FULCRUM_DEVICE") != nullptr);
    expect_replays(attempt.meta.id);
}

void Soak::write_pages(const SoakKind& kind, const lab::ResultTable& table) const {
    const char* const folder = std::getenv("FULCRUM_SOAK_PAGE");
    if (folder == nullptr) return;
    static std::vector<SoakRun> runs;  // of this process
    runs.push_back({kind.through_daemon, kind.loaded, table.rows});
    for (const lab::ResultPage& page : soak_pages(runs, seconds_))
        page.write(folder, lab::this_machine(lab::build_info()));
}

class SoakByMouse : public Soak {
  protected:
    void drag(bool loaded) {
        std::optional<MouseHand> hand;
        run({false, loaded,
             [&](ObservingRig& mind, const std::function<bool()>& done, int milliseconds) {
                 return hand.emplace(theatre(), mind).work_until(done, milliseconds);
             },
             [&] { return hand->events(); }});
    }
};

TEST_F(SoakByMouse, KeepsItsClockAndLosesNothingWhileItDrawsAndTheHandsDragBowel) {
    drag(false);
}

TEST_F(SoakByMouse, KeepsItsClockWhileOperatorsUseAllCores) {
    if (std::getenv("FULCRUM_SOAK_S") == nullptr) GTEST_SKIP() << "FULCRUM_SOAK_S is not set";
    drag(true);
}

/// Before the services of the fixture are made, which read these.
struct SoakDevice {
    fulcrum::test::FakePage<fulcrum::test::FakeTouchPage> page{"FAKE_TOUCH_PAGE"};
    fulcrum::test::Variable library{"FULCRUM_LIBHD", fulcrum::test::fake_library("libHD.so")};
    fulcrum::test::Variable device{"FULCRUM_DEVICE", "touch:Left Device,Right Device"};
    fulcrum::test::Variable program{"FULCRUM_HAPTICD", fulcrum::test::hapticd_program()};
};
class SoakThroughTheDaemon : public SoakDevice, public Soak {
  protected:
    void drag(bool loaded) {
        std::optional<PosedHand> hand;
        double felt = 0;
        run({true, loaded,
             [&](ObservingRig& mind, const std::function<bool()>& done, int milliseconds) {
                 const auto put = [&](int h, const Vector3& position) {
                     for (int axis = 0; axis < 3; ++axis)
                         page->device[h].position[axis] = 1e3 * position[axis];
                 };
                 const auto press = [&](int h, bool closed) { page->device[h].buttons = closed ? 1 : 0; };
                 hand.emplace(theatre(), mind, put, Vector3::Zero(), press);
                 return hand->work_until(
                     [&] {
                         for (const auto& one : page->device)
                             for (const auto& force : one.force)
                                 felt = std::max(felt, std::abs(force.load()));
                         return done();
                     },
                     milliseconds);
             },
             [&] { return hand->events(); }});
        EXPECT_GT(felt, 0.05) << "N, at the motors";
    }
};

TEST_F(SoakThroughTheDaemon, KeepsItsClockAndLosesNothingWhileItDrawsAndTheHandsDragBowel) {
    drag(false);
}

TEST_F(SoakThroughTheDaemon, KeepsItsClockWhileOperatorsUseAllCores) {
    if (std::getenv("FULCRUM_SOAK_S") == nullptr) GTEST_SKIP() << "FULCRUM_SOAK_S is not set";
    drag(true);
}

}  // namespace
}  // namespace fulcrum::app::program_test
