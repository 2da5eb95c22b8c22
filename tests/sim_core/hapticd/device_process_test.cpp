// SPDX-License-Identifier: Apache-2.0
// The loop of the device process says by whose doing a period was late: its own work, a wait in it, or the
// scheduler.
#include "sim_core/hapticd/device_process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "sim_core/devices/packets.h"
#include "tests/fakes/fake_page.h"

namespace fulcrum::hapticd {
namespace {

constexpr std::int64_t loop_ms = 1'000'000;  // ns

/// Every 50th reading takes so long, by work or by waiting.
class SlowReading : public Backend {
  public:
    enum class Kind { quick, works, waits };
    explicit SlowReading(Kind kind) : kind_(kind) { facts_.slot[1] = true; }
    const DeviceFacts& facts() const override { return facts_; }
    void read(std::int64_t, DevicePose (&poses)[device_slots]) noexcept override {
        poses[1].sequence = ++readings_;
        if (kind_ == Kind::quick || readings_ % 50 != 0) return;
        if (kind_ == Kind::waits) usleep(2500);
        const std::int64_t begin = own_time();
        while (kind_ == Kind::works && own_time() - begin < 5 * loop_ms / 2) {
        }
    }
    void render(int, const Vector3&, double) noexcept override {}

  private:
    static std::int64_t own_time() noexcept {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return time.tv_sec * 1000 * loop_ms + time.tv_nsec;
    }
    Kind kind_;
    DeviceFacts facts_;
    std::uint64_t readings_ = 0;
};

/// Runs in a process of its own until this object ends.
class RunningDevice {
  public:
    explicit RunningDevice(SlowReading::Kind kind) {
        make_socket_pair(ends_);
        const pid_t own = getpid();
        process = fork();
        if (process == 0) {
            SlowReading backend(kind);
            _exit(run_device(backend, *state.get(), *command.get(), own, ends_[1]));
        }
    }
    ~RunningDevice() {
        state->stopping.store(1);
        kill(process, SIGCONT);
        int status = 0;
        EXPECT_EQ(waitpid(process, &status, 0), process);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
        for (const int end : ends_) close(end);
    }
    RunningDevice(const RunningDevice&) = delete;
    RunningDevice& operator=(const RunningDevice&) = delete;
    LoopReport loop() const {
        LoopReport report;
        state->loop.read(report);
        return report;
    }
    bool ran(std::uint64_t ticks) const {
        const std::uint64_t begun = loop().ticks;
        return test::until([&] { return loop().ticks >= begun + ticks; });
    }
    SharedPage<StatePage> state = SharedPage<StatePage>::create("test-state", true);
    SharedPage<CommandPage> command = SharedPage<CommandPage>::create("test-command", false);
    pid_t process = 0;

  private:
    int ends_[2] = {-1, -1};
};

TEST(HapticdLoop, CountsTheLateTicksThatItsOwnWorkAndWaitsCause) {
    for (const auto kind : {SlowReading::Kind::works, SlowReading::Kind::waits}) {
        const RunningDevice device(kind);
        ASSERT_TRUE(device.ran(320));
        const LoopReport report = device.loop();
        EXPECT_GE(report.late_own, 6U) << "every 50th tick lasts 2.5 periods";
        EXPECT_LE(report.late_own, report.late);
    }
}

TEST(HapticdLoop, LateTicksOfAProcessThatGotNoProcessorAreNotItsOwn) {
    const RunningDevice device(SlowReading::Kind::quick);
    ASSERT_TRUE(device.ran(50));
    for (int i = 0; i < 5; ++i) {
        ASSERT_EQ(kill(device.process, SIGSTOP), 0);
        usleep(5000);
        ASSERT_EQ(kill(device.process, SIGCONT), 0);
        ASSERT_TRUE(device.ran(20));
    }
    const LoopReport report = device.loop();
    EXPECT_GE(report.late, 5U);
    // A signal that meets the few microseconds of a tick's work counts as a wait in it.
    EXPECT_LE(report.late_own, report.late / 2);
}

}  // namespace
}  // namespace fulcrum::hapticd
